//! A closed form is compared only with what it is of: a scene that contradicts it is refused, or noted with both numbers.

use approx::assert_relative_eq;
use contact_vv::accuracy::bars;
use contact_vv::case::library::FlatPunch;
use contact_vv::case::{Case, Verdict};
use contact_vv::oracle::Quantity;
use contact_vv::referee::Truth;

use crate::balance::scene;
use crate::scene_file::{self, text_of};
use crate::workbench::{parsed, told};

/// What is noted of a scene that is solved.
fn noted(case: &Case) -> Vec<String> {
    let (meshed, run) = case.solve().expect("solved");
    case.notes(&run, &bars(&meshed.discretisation, &run, &[]).expect("bars").all)
}

#[test]
fn hertz_on_an_arc_speaks_of_angles() {
    let case = scene_file::case("rigid-pin");
    let read = |quantity: Quantity| told(&case, &quantity);
    let radius = case.scene.contact().path.metric();
    let half_width = (4.0 * 0.6591 * 10010.0 / (std::f64::consts::PI * 210e3)).sqrt();
    assert_relative_eq!(read(Quantity::HalfWidth), half_width / radius, max_relative = 1e-12);
    assert_relative_eq!(read(Quantity::SecondMomentWidth), half_width / radius, max_relative = 1e-12);
    let [top, side] = [0.0, 0.5 * half_width / radius].map(|at| read(Quantity::Pressure { at }));
    assert_relative_eq!(side, top * 0.75f64.sqrt(), max_relative = 1e-12);
    // The referee knows it to what the closed form leaves out.
    let truth = Truth::of(case).expect("solved");
    let known = truth.known(0, &Quantity::HalfWidth);
    assert!(known.bar <= 0.01 * known.reference.value, "{known:?}");
    assert!(truth.notes().is_empty(), "{:?}", truth.notes());
}

#[test]
fn one_gap_told_in_another_way_has_the_same_closed_form() {
    // A cylinder and its parabola are one, and so is a table of it.
    for gap in ["{ circle = 100 }", "{ even = [0.005] }", "{ table = [[0, 0], [0.5, 0.00125], [1, 0.005], [2, 0.02]] }"]
    {
        scene("block-on-parabola", &[["{ parabola = 100 }", gap]]);
    }
}

#[test]
fn loads_that_the_contact_does_not_carry_are_noted_with_both_numbers() {
    let with = |load: &str| noted(&scene("block-on-parabola", &[["load = 5000", load]]));
    assert!(with("load = 5000").is_empty(), "{:?}", with("load = 5000"));
    for load in ["2500", "4900", "6500"] {
        let notes = with(&format!("load = {load}"));
        assert!(notes[0].contains(&format!("load of {load}")) && notes[0].contains("5000.00"), "{notes:?}");
    }
    let notes = noted(&scene("pin-in-plate", &[["load = 40000", "load = 20000"]]));
    let persson = |note: &String| note.contains("Persson has a load of 20000") && note.contains("40000.0");
    assert!(notes.iter().any(persson), "{notes:?}");
    // Of the second contact too.
    let text = text_of("roller-between-plates.toml").replacen(
        "load = 2000, radius = 50 } }\n\n[mesh]",
        "load = 1000, radius = 50 } }\n\n[mesh]",
        1,
    );
    let notes = noted(&parsed(&text));
    assert!(notes.iter().any(|note| note.contains("`below`") && note.contains("2000.00")), "{notes:?}");
    assert!(notes.iter().all(|note| !note.contains("`above`")), "{notes:?}");
}

#[test]
fn cases_are_off_their_closed_forms_by_no_more_than_they_say() {
    let held = |case: &Case| {
        let (meshed, run) = case.solve().expect("solved");
        case.held_to_closed_forms(&meshed, &run).expect("judged")
    };
    let mut case = scene_file::case("rigid-pin");
    let judged = held(&case);
    assert_eq!(judged.len(), 3);
    assert!(judged.iter().all(|one| one.verdict == Verdict::Pass), "{judged:?}");
    // What is not stated is seen.
    case.checks.iter_mut().for_each(|check| check.model = 0.0);
    assert!(held(&case).iter().any(|one| one.verdict == Verdict::Fail));
    let mut punch = FlatPunch { size: 20.0, ..Default::default() }.case();
    assert!(held(&punch).iter().all(|one| one.verdict == Verdict::Pass), "a finite block, as the case says");
    punch.model = 0.0;
    assert!(held(&punch).iter().any(|one| one.verdict == Verdict::Fail), "a finite block, and nothing says so");
}
