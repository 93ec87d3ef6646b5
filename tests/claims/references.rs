//! Reference answers: their bounds hold the error where a closed form tells it.

use contact_vv::accuracy::reference::{Answer, Known, answer};
use contact_vv::case::Verdict;
use contact_vv::case::library::{Bars, Cylinder, PinPlate};
use contact_vv::measure::Quantity;
use contact_vv::measure::relative_error;
use contact_vv::study::Study;
use contact_vv::study::fitted::{LOADS, under};
use contact_vv::study::references::{Answered, Numbers};
use contact_vv::study::sheet::Other;

fn of(known: &[Known], quantity: Quantity) -> &Known {
    known.iter().find(|one| one.quantity == quantity).expect("known")
}

#[test]
fn bounds_of_reference_answers_hold_the_error_of_truncated_hertz_and_are_below_1e_5() {
    for factor in LOADS.into_iter().step_by(2) {
        let numbers = under(factor);
        let (hertz, known) = (numbers.closed_form(), answer(&numbers.scene()).expect("answered").known);
        let truths = [
            (Quantity::Pressure { at: 0.0 }, hertz.peak_pressure()),
            (Quantity::PeakPressure, hertz.peak_pressure()),
            (Quantity::PeakPlace, 0.0),
            (Quantity::SecondMomentWidth, hertz.half_width()),
            (Quantity::End(0), hertz.half_width()),
            (Quantity::Resultant, hertz.load),
        ];
        for (quantity, truth) in truths {
            let one = of(&known, quantity.clone());
            let error = (one.value - truth).abs();
            assert!(error <= one.bound, "{quantity:?} at {factor}: {error:e} > {:e}", one.bound);
            assert!(one.bound <= 1e-5 * one.scale, "{quantity:?} at {factor}: {:e} of {}", one.bound, one.scale);
        }
    }
}

#[test]
fn a_pin_of_persson_ends_where_his_angle_says_up_to_what_the_rim_of_the_plate_does() {
    let known = answer(&PinPlate::of_half_angle(60.0).scene()).expect("answered").known;
    assert!(relative_error(of(&known, Quantity::End(0)).value.to_degrees(), 60.0) <= 3e-3);
}

#[test]
fn a_contact_that_no_mesh_can_be_fitted_to_has_no_reference_answer() {
    assert!(answer(&Bars::default().scene()).is_err());
}

#[test]
fn a_number_that_another_mesh_or_8_node_cells_contradict_turns_its_check_red() {
    let Answer { known, .. } = answer(&Cylinder::default().scene()).expect("answered");
    let sound: Vec<_> = known
        .into_iter()
        .map(|known| Answered { known, unit: "", eight: None, others: vec![], digits: 1e-6 })
        .collect();
    let failed = |known: &[Answered]| {
        let judged = Numbers::Answer { dofs: [0; 5], known: known.into() }.judge().expect("judged").into_iter();
        judged.filter(|one| one.verdict != Verdict::Pass).map(|one| one.check.quantity.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(failed(&sound), Vec::<String>::new());
    let spoiled = |spoil: fn(&mut Answered)| {
        let mut other = sound.clone();
        let own = other.iter_mut().find(|one| one.known.quantity == Quantity::SecondMomentWidth);
        spoil(own.expect("measured"));
        failed(&other)
    };
    assert_eq!(
        spoiled(|one| one.known.bound = 2e-5 * one.known.scale),
        ["relative error bar of a reference answer, second-moment-width"]
    );
    assert_eq!(
        spoiled(|one| one.known.bound = f64::NAN),
        ["relative error bar of a reference answer, second-moment-width"]
    );
    let off = "difference of 8-node cells over what both may be off, second-moment-width";
    assert_eq!(spoiled(|one| one.eight = Some([1.01 * one.known.value, 1e-3 * one.known.value])), [off]);
    assert_eq!(spoiled(|one| one.eight = Some([f64::NAN; 2])), [off]);
    let (differs, rough) = (
        "difference over what both may be off, second-moment-width",
        "difference and error bar of theirs, relative, second-moment-width",
    );
    // What another found beside it: sound, out of both bounds, within its own wide bound, and no number.
    let other = |off: f64, bound: f64| {
        let mut other = sound.clone();
        let own = other.iter_mut().find(|one| one.known.quantity == Quantity::SecondMomentWidth).expect("measured");
        let value = (1.0 + off) * own.known.value;
        own.others = vec![Other { by: "another", value, uncertainty: 0.5 * bound, bound }];
        failed(&other)
    };
    assert_eq!(other(1e-9, 1e-9), Vec::<String>::new());
    assert_eq!(other(5e-7, 1e-9), [differs]);
    assert_eq!(other(5e-6, 1e-9), [differs, rough]);
    assert_eq!(other(0.0, 1e-4), [rough]);
    assert_eq!(other(f64::NAN, 1e-9), [differs, rough]);
    assert_eq!(other(0.0, f64::NAN), [differs, rough]);
}
