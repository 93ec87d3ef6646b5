//! A closed form is compared only with what it is of: a scene that contradicts it is refused, or noted with both numbers.

use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::accuracy::bars;
use contact_vv::case::library::FlatPunch;
use contact_vv::case::{Case, Verdict};
use contact_vv::oracle::{Quantity, Reading};
use contact_vv::referee::Truth;

use crate::scene_file::text_of;
use crate::workbench::block_text;

fn parsed(text: &str) -> Result<Case, String> {
    Case::parse(Path::new("hypotheses.toml"), text).map_err(|error| error.to_string())
}

/// What is noted of a scene that is solved.
fn noted(text: &str) -> Vec<String> {
    let case = parsed(text).unwrap_or_else(|error| panic!("{error}"));
    let (meshed, run) = case.solve().expect("solved");
    case.notes(&run, &bars(&meshed.discretisation, &run, &[]).expect("bars").all)
}

/// A block of 20 by 20 mm on a rigid profile, 2 mm thick.
fn block(gap: &str, oracle: &str, load: f64) -> String {
    let contact = format!("gap = {gap}\nstretch = 2\noracle = {oracle}\n[mesh]\nelements = 16\nper = 2");
    let traction = format!("traction = {{ at = \"far\", force = [0, {}] }}", -0.5 * load);
    block_text([0.0, 20.0], 20.0, &traction, &contact).replace("thickness = 1", "thickness = 2")
}

/// A steel pin in a wide plate of a material.
fn pin(material: &str, oracle: &str) -> String {
    format!(
        "plane = \"stress\"\nthickness = 10\n[[body]]\nname = \"pin\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ disc = {{ centre = [0, 0], radius = 20 }} }}\n\
         supports = [{{ at = \"axis\", component = \"x\" }}, {{ at = \"cut\", component = \"y\" }}]\n\
         [[body]]\nname = \"plate\"\n{material}\n\
         shape = {{ ring = {{ centre = [0, 0.1], inner = 20.1, outer = 60, sweep = 180, contact = \"inner\" }} }}\n\
         supports = [{{ at = \"start\", component = \"x\" }}, {{ at = \"end\", component = \"x\" }}]\n\
         loads = [{{ traction = {{ at = \"outer\", force = [0, 20000] }} }}]\n\
         [contact]\nfirst = \"pin\"\nsecond = \"plate\"\narc = {{ centre = [0, 0], radius = 20 }}\n\
         gap = {{ hole = {{ radius = 20, clearance = 0.1 }} }}\nstretch = 85\noracle = {oracle}\n\
         [mesh]\nelements = 4\nper = 10\n"
    )
}

#[test]
fn hertz_on_an_arc_speaks_of_angles() {
    let case = parsed(&text_of("rigid-pin.toml")).expect("a scene");
    let oracle = case.oracle().expect("Hertz").clone();
    let read = |quantity: Quantity| match oracle.read(&quantity) {
        Reading::Value { value, .. } => value,
        other => panic!("{quantity:?}: {other:?}"),
    };
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
fn numbers_that_the_scene_has_otherwise_are_refused_with_both() {
    // A cylinder and its parabola are one, and so is a table of it.
    for gap in [
        "{ parabola = 100 }",
        "{ circle = 100 }",
        "{ even = [0.005] }",
        "{ table = [[0, 0], [0.5, 0.00125], [1, 0.005], [2, 0.02]] }",
    ] {
        assert!(parsed(&block(gap, "{ hertz = { load = 5000, radius = 100 } }", 5000.0)).is_ok(), "{gap}");
    }
    for (gap, oracle) in [
        ("{ wedge = 0.005 }", "{ wedge = { load = 2000, radius = 20, round = 0.15 } }"),
        ("{ parabola = 100 }", "{ wedge = { load = 9000, radius = 100, round = 0.2 } }"),
        ("{ even = [0.004, 0.002] }", "{ polynomial = { load = 9000, coefficients = [0.004, 0.003, 0] } }"),
        ("{ wedge = 0.005 }", "{ hertz = { load = 5000, radius = 100 } }"),
        ("{ uniform = 0 }", "{ hertz = { load = 5000, radius = 100 } }"),
        ("{ parabola = 100 }", "{ flat-punch = { load = 5000, half-width = 2 } }"),
        ("{ parabola = 100 }", "{ lame = { radii = [1, 2, 3], interference = 0.1 } }"),
        ("{ parabola = 100 }", "{ persson = { load = 1, radius = 2, clearance = 0.1 } }"),
    ] {
        let error = parsed(&block(gap, oracle, 5000.0)).map(|_| ()).expect_err(oracle);
        assert!(error.contains("hypotheses.toml") && error.contains("`oracle`"), "{error}");
    }
}

#[test]
fn persson_is_of_one_material_and_of_the_gap_that_it_names() {
    let [steel, aluminium] = ["young = 210e3\npoisson = 0.3", "young = 70e3\npoisson = 0.33"];
    let persson = "{ persson = { load = 40000, radius = 20, clearance = 0.1 } }";
    assert!(parsed(&pin(steel, persson)).is_ok());
    for (material, oracle, says) in [
        (aluminium, persson, "`plate` has `young` 70000 and `poisson` 0.33"),
        ("young = 210e3\npoisson = 0.4", persson, "`poisson` 0.4"),
        (
            steel,
            "{ persson = { load = 40000, radius = 26, clearance = 0.1 } }",
            "`radius` is 26, and the pin's radius in the gap is 20",
        ),
        (
            steel,
            "{ persson = { load = 40000, radius = 20, clearance = 0.2 } }",
            "`clearance` is 0.2, and that of the gap is 0.1",
        ),
    ] {
        let error = parsed(&pin(material, oracle)).map(|_| ()).expect_err(says);
        assert!(error.contains(says), "{error}");
    }
    let notes = noted(&pin(steel, &persson.replace("40000", "20000")));
    assert!(
        notes.iter().any(|note| note.contains("Persson has a load of 20000") && note.contains("40000.0")),
        "{notes:?}"
    );
}

#[test]
fn loads_that_the_contact_does_not_carry_are_noted_with_both_numbers() {
    let with = |load: f64| {
        noted(&block("{ parabola = 100 }", &format!("{{ hertz = {{ load = {load}, radius = 100 }} }}"), 5000.0))
    };
    assert!(with(5000.0).is_empty(), "{:?}", with(5000.0));
    for load in [2500.0, 4900.0, 6500.0] {
        let notes = with(load);
        assert!(notes[0].contains(&format!("load of {load}")) && notes[0].contains("5000.00"), "{notes:?}");
    }
    // Of the second contact too.
    let text = text_of("roller-between-plates.toml").replacen(
        "load = 2000, radius = 50 } }\n\n[mesh]",
        "load = 1000, radius = 50 } }\n\n[mesh]",
        1,
    );
    let notes = noted(&text);
    assert!(notes.iter().any(|note| note.contains("`below`") && note.contains("2000.00")), "{notes:?}");
    assert!(notes.iter().all(|note| !note.contains("`above`")), "{notes:?}");
}

#[test]
fn cases_are_off_their_closed_forms_by_no_more_than_they_say() {
    let held = |case: &Case| {
        let (meshed, run) = case.solve().expect("solved");
        case.held_to_closed_forms(&meshed, &run).expect("judged")
    };
    let mut case = parsed(&text_of("rigid-pin.toml")).expect("a scene");
    let judged = held(&case);
    assert_eq!(judged.len(), 3);
    assert!(judged.iter().all(|one| one.verdict == Verdict::Pass), "{judged:?}");
    // What is not stated is seen.
    case.checks.iter_mut().for_each(|check| check.model = 0.0);
    assert!(held(&case).iter().any(|one| one.verdict == Verdict::Fail));
    let punch = FlatPunch { size: 20.0, ..Default::default() }.case();
    assert!(held(&punch).iter().any(|one| one.verdict == Verdict::Fail), "a finite block, and no check says so");
}
