//! The checks of the rooms turn red where their numbers are spoiled.

use contact_vv::case::{Judged, Verdict};
use contact_vv::mesh::Order;
use contact_vv::oracle::ReferenceKind;
use contact_vv::study::{family, fields, gaertner, quarter, refinement};

fn fails(judged: &[Judged]) -> usize {
    judged.iter().filter(|one| one.verdict == Verdict::Fail).count()
}

fn model(ratios: [[f64; 2]; 4]) -> refinement::Numbers {
    let mut a_over_r = [0.005, 0.05, 0.1, 0.2].into_iter();
    let ratio = |[peak, half_width]: [f64; 2]| refinement::Ratio {
        a_over_r: a_over_r.next().expect("four"),
        peak,
        half_width,
        dofs: 1,
    };
    refinement::Numbers::ModelError(refinement::ModelError { elements: 48, ratios: ratios.map(ratio) })
}

#[test]
fn a_model_error_that_does_not_fall_with_the_square_of_the_contact_turns_red() {
    let judge = |ratios| refinement::judge(&model(ratios)).expect("judged");
    let sound = [[1.0, 1.0], [0.9994, 1.0004], [0.9976, 1.0016], [0.9904, 1.0064]];
    assert_eq!(fails(&judge(sound)), 0);
    let spoiled = |index: usize, by: f64| {
        let mut ratios = sound;
        ratios[index] = ratios[index].map(|ratio| ratio * by);
        ratios
    };
    assert_eq!(fails(&judge(spoiled(0, 1.001))), 2);
    assert_eq!(fails(&judge(spoiled(1, 1.0005))), 2);
    assert_eq!(fails(&judge(spoiled(3, f64::NAN))), 2);
}

#[test]
fn an_order_that_is_not_reached_turns_red() {
    let orders = |power: f64| {
        let level = |size: f64| refinement::Errors {
            size,
            dofs: 1,
            peak: size.powf(power),
            half_width: size.powf(power),
            l2: size.powf(0.5 * power),
            load: 1e-12,
        };
        let levels = [0.25, 0.125, 0.0625, 0.03125].map(level).into();
        refinement::Numbers::Orders(refinement::Orders { order: Order::Quadratic, levels })
    };
    let judge = |power| fails(&refinement::judge(&orders(power)).expect("judged"));
    assert_eq!([judge(2.0), judge(1.5), judge(f64::NAN)], [0, 3, 3]);
}

#[test]
fn a_quarter_that_changes_a_small_contact_turns_red() {
    let changes = |a_over_r, by: f64| {
        let contact = |peak| quarter::Contact { peak, half_width: 1.0 };
        let change = quarter::Change { a_over_r, quarter: contact(by), half: contact(1.0), above: contact(1.0) };
        fails(&quarter::judge(&quarter::Numbers { changes: vec![change] }).expect("judged"))
    };
    assert_eq!(
        [changes(0.025, 1.0), changes(0.025, 1.002), changes(0.025, f64::NAN), changes(0.1, 1.002)],
        [0, 1, 1, 0]
    );
}

fn curves(ended: family::Ended, other: f64) -> family::Numbers {
    let placed = family::Placed { pressure: 2.0, angle: 0.3 };
    let mut list = vec![family::Ended::Converged(placed); 8];
    list[0] = ended;
    let line = family::Line { value: 2.0, ended: list.clone() };
    let elsewhere = family::Placed { pressure: other * placed.pressure, angle: placed.angle };
    family::Numbers::Curves(family::Curves {
        clearances: vec![0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0],
        eyes: vec![line.clone(); 3],
        shanks: vec![line.clone(); 3],
        same_place: [placed, elsewhere],
        wide_plate: 0.2,
    })
}

#[test]
fn a_lost_scene_of_the_family_and_a_pin_of_another_place_turn_red() {
    let judge = |ended, other| fails(&family::judge(&curves(ended, other)).expect("judged"));
    assert_eq!(judge(family::Ended::Beyond, 1.0), 0);
    assert_eq!(judge(family::Ended::NotConverged, 1.0), 1);
    assert_eq!(judge(family::Ended::Beyond, 1.01), 1);
    assert_eq!(judge(family::Ended::Beyond, f64::NAN), 1);
}

#[test]
fn a_slope_that_depends_on_its_step_turns_red() {
    let judge = |by_half: [f64; 2]| {
        let slope = || family::Slope { number: "E t c / F", slope: [0.2, -0.4], by_half };
        let at = family::Place { clearance: 5.0, eye: 2.0, shank: 1.0 };
        let numbers = family::Sensitivities { at, slopes: [slope(), slope(), slope()] };
        fails(&family::judge(&family::Numbers::Sensitivities(numbers)).expect("judged"))
    };
    assert_eq!([judge([0.2, -0.4]), judge([0.25, -0.4]), judge([f64::NAN; 2])], [0, 3, 6]);
}

#[test]
fn stresses_that_do_not_carry_the_load_turn_red() {
    let mut field = fields::run::field(fields::Shown::Cylinder).expect("solved");
    let judge = |field: &fields::Field| fails(&fields::judge(&fields::Numbers::Field(field.clone())).expect("judged"));
    assert_eq!(judge(&field), 0);
    for resultant in &mut field.resultants {
        resultant.force *= 1.1;
    }
    assert_eq!(judge(&field), field.resultants.len());
    field.load = f64::NAN;
    assert_eq!(judge(&field), field.resultants.len());
}

#[test]
fn a_curve_beyond_its_uncertainty_turns_red_and_one_that_is_absent_is_not_run() {
    let judge = |deviates| {
        let (file, source, kind) = ("curve.csv".into(), "Gaertner 1977".into(), ReferenceKind::Measured);
        let numbers = gaertner::Numbers::Present(vec![gaertner::Curve { file, source, kind, deviates }]);
        gaertner::judge(&numbers).expect("judged")[0].verdict.clone()
    };
    let deviates = |worst| judge(Some(gaertner::Deviates { worst, model_form: None }));
    assert_eq!([deviates(1.9), deviates(2.1), deviates(f64::NAN)], [Verdict::Pass, Verdict::Fail, Verdict::Fail]);
    assert!(matches!(judge(None), Verdict::NotRun(_)));
    let absent = gaertner::judge(&gaertner::Numbers::Absent("why".into())).expect("judged");
    assert_eq!(absent[0].verdict, Verdict::NotRun("why".into()));
}
