//! The checks of the rooms turn red where their numbers are spoiled.

use contact_vv::case::{Judged, Verdict};
use contact_vv::mesh::Order;
use contact_vv::oracle::ReferenceKind;
use contact_vv::solve::Fitted;
use contact_vv::solve::{Element, Ended};
use contact_vv::study::refinement::{self, Numbers, family, nested};
use contact_vv::study::{Study, fields, fitted, measured};

use crate::workbench::fails;

fn judged(numbers: &Numbers) -> Vec<Judged> {
    numbers.judge().expect("judged")
}

#[test]
fn a_model_error_that_does_not_fall_with_the_square_of_the_contact_turns_red() {
    const RATIOS: [f64; 4] = [0.005, 0.05, 0.1, 0.2];
    let judge = |of: [[f64; 2]; 4], bar: f64| {
        let ratio = |k: usize| {
            let departures = of[k].map(|value| [value, bar]);
            refinement::Ratio { a_over_r: RATIOS[k], departures, dofs: 1 }
        };
        judged(&Numbers::ModelError([0, 1, 2, 3].map(ratio).into()))
    };
    let sound = RATIOS.map(|ratio| [-0.24 * ratio * ratio, 0.18 * ratio * ratio]);
    assert_eq!((judge(sound, 1e-8).len(), fails(&judge(sound, 1e-8))), (8, 0));
    // What is below five error bars has no power.
    assert_eq!(fails(&judge(sound, 1e-5)), 2);
    let spoiled = |index: usize, by: f64| {
        let mut departures = sound;
        departures[index] = departures[index].map(|departure| departure * by);
        fails(&judge(departures, 1e-8))
    };
    // The smallest contact off: itself, and the pair that it is in. Another one spoils the pairs on both its sides.
    assert_eq!([spoiled(0, 6.0), spoiled(1, 1.1), spoiled(2, 1.1), spoiled(3, 1.1)], [4, 4, 4, 2]);
    // Of another sign, or no number: no power at all.
    assert_eq!([spoiled(2, -1.0), spoiled(3, f64::NAN), spoiled(0, f64::NAN)], [6, 6, 8]);
}

#[test]
fn an_order_on_curved_sides_that_is_lower_on_one_mesh_or_no_number_turns_red() {
    let judge = |order: Order, powers: [f64; 2], spoiled: f64| {
        let level = |k: u32| {
            let errors =
                powers.map(|power| 0.01 * 0.5_f64.powf(power * f64::from(k)) * if k == 2 { spoiled } else { 1.0 });
            nested::Level { elements: 6 << k, dofs: 1, errors }
        };
        let levels: Vec<nested::Level<2>> = (0..4).map(level).collect();
        let judged = judged(&Numbers::Rings(order, Element::ALL.map(|element| (element, levels.clone()))));
        assert_eq!(judged.len(), 6);
        fails(&judged)
    };
    for (order, powers) in [(Order::Linear, [1.5, 2.0]), (Order::Quadratic, [2.0, 3.0])] {
        assert_eq!(judge(order, powers, 1.0), 0);
        assert_eq!(judge(order, powers.map(|power| power - 0.2), 1.0), 6);
        // A mesh whose errors are larger or smaller by a fifth spoils one pair of each number.
        assert_eq!([judge(order, powers, 1.2), judge(order, powers, 1.0 / 1.2)], [2, 2]);
        assert_eq!(judge(order, powers, f64::NAN), 6);
    }
}

/// The checks of errors of truncated Hertz on four meshes: of the pressure, the half-width and the profile.
fn orders(order: Order, peak: [f64; 4], width: [f64; 4], l2: [f64; 4]) -> Vec<Judged> {
    let level = |k: usize| nested::Level { elements: 4 << k, dofs: 1, errors: [peak[k], width[k], l2[k]] };
    let (levels, edges) = ((0..4).map(level).collect(), vec![0.0; 4]);
    judged(&Numbers::Orders(nested::Series { order, levels, edges, load: 1e-12 }))
}

#[test]
fn an_order_that_one_pair_of_meshes_does_not_reach_turns_red() {
    let series = |power: f64| [0.25f64, 0.125, 0.0625, 0.03125].map(|size| 0.02 * size.powf(power));
    let judge = |errors, profile| {
        let judged = orders(Order::Quadratic, errors, errors, profile);
        assert_eq!(judged.len(), 10);
        fails(&judged)
    };
    assert_eq!(judge(series(2.0), series(1.0)), 0);
    assert_eq!(judge(series(1.5), series(0.75)), 9);
    assert_eq!(judge(series(f64::NAN), series(f64::NAN)), 9);
    // The finest mesh alone: a slope over four would still be 1.85.
    let [a, b, c, d] = series(2.0);
    assert_eq!(judge([a, b, c, 1.5 * d], series(1.0)), 2);
    // Not monotone, or of changing sign: no order is left that could pass.
    assert_eq!(judge([a, b, 1.1 * b, d], series(1.0)), 6);
    assert_eq!(judge([a, b, c, -d], series(1.0)), 6);
    assert_eq!(judge(series(2.0), [a, b, b, d]), 3);
}

#[test]
fn a_half_width_without_an_order_must_still_fall_with_the_second_power() {
    let judge = |half_width: [f64; 4]| {
        let squares = [0.25f64, 0.125, 0.0625, 0.03125];
        let judged = orders(Order::Linear, squares.map(|h| 0.02 * h * h), half_width, squares.map(|h| 0.3 * h));
        let own = judged.iter().filter(|one| one.check.quantity.name().contains("second-moment width"));
        assert_eq!(own.clone().filter(|one| one.check.quantity.name().contains("order")).count(), 0);
        own.filter(|one| one.verdict == Verdict::Fail).count()
    };
    assert_eq!(judge([1.3e-3, -5.3e-5, -5.7e-5, -1.9e-5]), 0);
    // One mesh, those of first order from 1.3e-3 on, and no number.
    assert_eq!(judge([1.3e-3, -5.3e-5, -5.7e-4, -1.9e-5]), 1);
    assert_eq!(judge([1.3e-3, -6.5e-4, -3.3e-4, -1.6e-4]), 2);
    assert_eq!(judge([1.3e-3, f64::NAN, -5.7e-5, -1.9e-5]), 1);
}

#[test]
fn a_quarter_that_changes_a_small_contact_turns_red() {
    let changes = |a_over_r, by: f64| {
        let change = refinement::Change { a_over_r, quarter: [by, 1.0], half: [1.0; 2], above: [1.0; 2] };
        fails(&judged(&Numbers::Quarter(vec![change])))
    };
    assert_eq!(
        [changes(0.025, 1.0), changes(0.025, 1.002), changes(0.025, f64::NAN), changes(0.1, 1.002)],
        [0, 1, 1, 0]
    );
}

#[test]
fn a_lost_scene_of_the_family_and_a_pin_of_another_place_turn_red() {
    let found = [2.0, 0.3];
    let judge = |first: family::Placed, other: f64| {
        let mut placed = vec![Ok(found); 8];
        placed[0] = first;
        let curves = vec![("eye".to_owned(), placed); 6];
        let same_place = [found, [other * found[0], found[1]]];
        let judged = judged(&Numbers::Family { curves, same_place, wide_plate: 0.2 });
        [fails(&judged[..1]), fails(&judged[1..])]
    };
    assert_eq!(judge(Err(Ended::Beyond), 1.0), [0, 0]);
    for lost in [Ended::Capped, Ended::Cycling, Ended::Diverged, Ended::Stalled, Ended::Stopped, Ended::Unsupported] {
        assert_eq!(judge(Err(lost), 1.0), [1, 0], "{lost:?}");
    }
    assert_eq!(judge(Err(Ended::Beyond), 1.01), [0, 1]);
    assert_eq!(judge(Err(Ended::Beyond), f64::NAN), [0, 1]);
}

#[test]
fn stresses_that_do_not_carry_the_load_turn_red() {
    let mut field = fields::field(fields::SHOWN[0]).expect("solved");
    let judge =
        |field: &fields::Field| fails(&fields::Numbers::Field(Box::new(field.clone())).judge().expect("judged"));
    assert_eq!(judge(&field), 0);
    field.resultants.iter_mut().for_each(|(.., force)| *force *= 1.1);
    assert_eq!(judge(&field), field.resultants.len());
    field.load = f64::NAN;
    assert_eq!(judge(&field), field.resultants.len());
}

#[test]
fn a_curve_beyond_its_uncertainty_turns_red_and_one_that_is_absent_is_not_run() {
    let judge = |found: Result<f64, &str>| {
        let check = measured::check("curve.csv", "Gaertner 1977", ReferenceKind::Measured, None);
        let found = found.map(|worst| vec![check.judge(worst)]);
        let found = found.map_err(str::to_owned);
        measured::judge_curves("Gaertner 1977", &found)[0].verdict.clone()
    };
    assert_eq!([1.9, 2.1, f64::NAN].map(|worst| judge(Ok(worst))), [Verdict::Pass, Verdict::Fail, Verdict::Fail]);
    assert_eq!(judge(Err("why")), Verdict::NotRun("why".into()));
}

/// A mesh fitted to the contact, as far off as may be.
fn mesh(digits: usize, error: f64) -> fitted::Mesh {
    let fitted = Fitted::of_digits(digits);
    fitted::Mesh { fitted, dofs: 1000, in_all: 1000, errors: [error, error, fitted::OF_END * error], exact: false }
}

#[test]
fn a_fitted_mesh_that_errs_more_than_is_asked_turns_red() {
    let judge = |spoil: fn(&mut fitted::Mesh)| {
        let asked = |(digits, error)| mesh(digits, error);
        let (mut meshes, mut revolved) = (fitted::ASKED.map(asked), fitted::ASKED_OF_REVOLUTION.map(asked));
        let mut scenes = [("pin".into(), mesh(5, 1e-5))];
        let all = meshes.iter_mut().chain(&mut revolved);
        all.chain(scenes.iter_mut().map(|(_, mesh)| mesh)).for_each(spoil);
        let judge = |meshes: &[fitted::Mesh], revolved: &[fitted::Mesh], scenes: &[(String, fitted::Mesh)]| {
            let numbers = fitted::Numbers { meshes: meshes.into(), revolved: revolved.into(), scenes: scenes.into() };
            let judged = numbers.judge().expect("judged");
            assert_eq!(judged.len(), 21 + 2 * scenes.len());
            fails(&judged)
        };
        // Of the block, of the one of revolution, and of another scene; without their meshes no number of the blocks
        // could pass.
        [judge(&meshes, &[], &[]) - 12, judge(&[], &revolved, &[]) - 9, judge(&[], &[], &scenes) - 21]
    };
    assert_eq!(judge(|_| {}), [0, 0, 0]);
    assert_eq!(judge(|mesh| mesh.errors[0] *= 1.01), [3, 4, 1]);
    assert_eq!(judge(|mesh| mesh.errors[1] *= 1.01), [3, 4, 1]);
    // Of other scenes the half-width is not asked.
    assert_eq!(judge(|mesh| mesh.errors[2] *= 1.01), [3, 4, 0]);
    assert_eq!(judge(|mesh| mesh.errors[0] = f64::NAN), [3, 4, 1]);
    assert_eq!(judge(|mesh| mesh.errors = [f64::NAN; 3]), [9, 12, 2]);
    // A mesh that was not solved.
    assert_eq!(judge(|mesh| mesh.fitted.layers = 9)[..2], [9, 12]);
}
