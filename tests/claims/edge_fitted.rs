//! Meshes with lines on the ends of the contact: how many digits they give, and for how many dofs; how far they are
//! iterated, and what no mesh is fitted to.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use contact_vv::accuracy::{self, Asked};
use contact_vv::case::library::{Bars, Patch, TruncatedHertz, find};
use contact_vv::checkout::root;
use contact_vv::measure::{Quantity, nodal, profile, relative_error};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::scene::{
    Action, Body, Component, Ends, Face, Load, Material, Path, Place, Scene, Shape, Support, VectorField,
};
use contact_vv::solve::edge_fitted::Answer;
use contact_vv::solve::{Fitted, Formulation, Run};
use contact_vv::study::fitted::{LOADS, OF_END};

use crate::balance::{barred, scene, solved_on, text, told_of};
use crate::outputs::json;
use crate::scene_file::case;
use crate::workbench::{self, area, block_text, held_at, meshed, parsed, resolution};

/// The same block and candidates under another load.
fn under(factor: f64) -> (TruncatedHertz, Hertz) {
    let numbers = TruncatedHertz::default().under(factor);
    (numbers.clone(), numbers.closed_form())
}

/// A load under which the contact does not end on a line of the mesh that is drawn.
const OFF: f64 = 0.89;

fn solved(fitted: Fitted, scene: &Scene) -> Answer {
    let answer = fitted.solve(scene, &Formulation::verification()).expect("answer");
    assert!(answer.run.solution.converged(), "{fitted:?}: {}", answer.run.solution.outcome);
    answer
}

/// Relative errors of peak and second-moment width.
fn errors(run: &Run, hertz: &Hertz) -> [f64; 2] {
    let measures = run.measures();
    [
        relative_error(measures.peak.pressure, hertz.peak_pressure()),
        relative_error(measures.second_moment_width, hertz.half_width()),
    ]
}

#[test]
fn digits_of_truncated_hertz_and_of_the_truncated_sphere_cost_few_dofs() {
    for name in ["truncated-hertz", "truncated-sphere"] {
        let case = find(name, None).expect("known");
        let [peak, width, end] = [Quantity::PeakPressure, Quantity::SecondMomentWidth, Quantity::HalfWidth]
            .map(|one| case.reading(0, &one).value);
        for (order, layers, digits, most) in [
            (Order::Quintic, 1, 1e-3, 900),
            (Order::Sextic, 1, 1e-4, 1000),
            (Order::Septic, 2, 1e-5, 1700),
            (Order::Octic, 3, 1e-6, 2700),
        ] {
            let answer = solved(Fitted { order, layers }, &case.scene);
            let measures = answer.run.measures();
            let errors =
                [relative_error(measures.peak.pressure, peak), relative_error(measures.second_moment_width, width)];
            assert!(errors.iter().all(|error| *error <= digits), "{name}, {order:?}: {errors:?}");
            let of_end = relative_error(measures.half_width(), end);
            assert!(of_end <= OF_END * digits, "{name}, {order:?}: the half-width is {of_end:e} off");
            assert!(answer.run.dofs <= most, "{name}, {order:?}: {} dofs", answer.run.dofs);
        }
    }
}

#[test]
fn peaks_around_an_axis_are_as_accurate_as_the_ends_of_their_contacts() {
    for a_over_r in [0.05, 0.047, 0.053] {
        let case = find("truncated-sphere", Some(a_over_r)).expect("known");
        let [peak, end] = [Quantity::PeakPressure, Quantity::HalfWidth].map(|one| case.reading(0, &one).value);
        // By the pressures of points around the axis alone the peak is 1e-4, 1e-5, 1e-4 and 4e-7 off.
        for (order, layers, digits) in
            [(Order::Quintic, 2, 5e-6), (Order::Septic, 2, 3e-6), (Order::Quintic, 3, 1e-6), (Order::Octic, 3, 2e-7)]
        {
            let measures = solved(Fitted { order, layers }, &case.scene).run.measures().clone();
            let error = relative_error(measures.peak.pressure, peak);
            let of_end = relative_error(measures.half_width(), end);
            assert!(error <= digits && error <= of_end, "{a_over_r}, {order:?}, {layers}: {error:e}, {of_end:e}");
            assert_eq!(measures.peak.pressure, measures.pressure_at_origin);
        }
    }
}

/// Two blocks of other moduli, both with the tractions of their half-planes.
fn two_blocks(young: [f64; 2], poisson: [f64; 2]) -> (Scene, Hertz) {
    let (one, _) = under(OFF);
    let mut scene = one.scene();
    let modulus = |k: usize| young[k] / (1.0 - poisson[k] * poisson[k]);
    let modulus = 1.0 / (1.0 / modulus(0) + 1.0 / modulus(1));
    let hertz = Hertz { load: Hertz::load_for(one.half_width(), one.radius, modulus), radius: one.radius, modulus };
    let side = one.size * one.half_width();
    let upper = VectorField::of(move |[x, y]: [f64; 2]| hertz.stress(x, y));
    let lower = VectorField::of(move |[x, y]: [f64; 2]| {
        let [along, across, shear] = hertz.stress(x, -y);
        [along, across, -shear]
    });
    let symmetric = scene.bodies[0].supports[0].clone();
    let body = |k: usize, y: [f64; 2], contact, field: &VectorField<3>, more: Option<Support>| Body {
        density: 1.0,
        name: ["upper", "lower"][k].into(),
        shape: Shape::Rectangle { x: [0.0, side], y, contact },
        material: Material { young: young[k], poisson: poisson[k] },
        supports: [symmetric.clone()].into_iter().chain(more).collect(),
        loads: ["right", "far"].map(|side| Load::on(side, Action::Stress(field.clone()))).to_vec(),
    };
    let ground = held_at([0.0, -side], Component::Y, 0.0);
    let bodies =
        vec![body(0, [0.0, side], Face::Bottom, &upper, None), body(1, [-side, 0.0], Face::Top, &lower, Some(ground))];
    scene.bodies = bodies;
    scene.contacts[0].second = Some(1);
    (scene, hertz)
}

#[test]
fn two_bodies_of_other_moduli_are_found_to_as_many_digits() {
    for (young, poisson) in [([210e3, 70e3], [0.3, 0.2]), ([210e3, 2.1e3], [0.3, 0.45])] {
        let (scene, hertz) = two_blocks(young, poisson);
        let meshes = [(Order::Quintic, 1, 1e-4, 1300), (Order::Septic, 2, 1e-5, 3300), (Order::Octic, 3, 1e-6, 5400)];
        for (order, layers, bound, most) in meshes {
            let answer = solved(Fitted { order, layers }, &scene);
            let errors = errors(&answer.run, &hertz);
            assert!(errors.iter().all(|error| *error <= bound), "{order:?} of {young:?}: {errors:?}");
            assert!(answer.run.dofs <= most, "{order:?} of {young:?}: {} dofs", answer.run.dofs);
        }
    }
}

/// A block pressed on a rigid hump on either side of its middle, `g = c₄ s⁴ − 2 c₄ s₀² s²`; one half of it, or all.
fn humps(coefficient: f64, hump: f64, pressure: f64, whole: bool, per: f64) -> Scene {
    let even = [-2.0 * coefficient * hump * hump, coefficient];
    let contact =
        format!("gap = {{ even = {even:?} }}\nstretch = 5\nboth-sides = {whole}\n[mesh]\nelements = 8\nper = {per:?}");
    let traction = format!("traction = {{ at = \"far\", value = [0, -{pressure}] }}");
    let text = block_text([if whole { -10.0 } else { 0.0 }, 10.0], 15.0, &traction, &contact);
    parsed(&text.replace("young = 210e3", "young = 1e4")).scene
}

#[test]
fn contact_that_begins_away_from_its_symmetry_line_is_found_as_on_the_whole_body() {
    for (coefficient, hump, pressure) in [(1e-4, 2.0, 0.2), (1e-4, 3.5, 3.0), (1e-3, 1.0, 1.0), (1e-3, 2.0, 3.0)] {
        let [half, whole] = [false, true].map(|whole| {
            solved(Fitted { order: Order::Sextic, layers: 1 }, &humps(coefficient, hump, pressure, whole, 1.0))
        });
        // A first mesh on which the hump is narrower than an element.
        let coarse = humps(coefficient, hump, pressure, false, 5.0);
        let coarse = solved(Fitted { order: Order::Sextic, layers: 1 }, &coarse).run.measures().peak.pressure;
        let what = format!("humps at {hump} mm, {coefficient} under {pressure} MPa");
        let [[begin, end]] = half.stretches[0][..] else { panic!("{what}: {:?}", half.stretches) };
        let [.., [other, last]] = whole.stretches[0][..] else { panic!("{what}: {:?}", whole.stretches) };
        assert!(begin > 0.0 && begin < hump && hump < end, "{what}: {begin} to {end}");
        let width = end - begin;
        assert!(
            (begin - other).abs() <= 2e-3 * width && (end - last).abs() <= 2e-3 * width,
            "{what}: {other} to {last}"
        );
        let [own, others] = [&half, &whole].map(|answer| answer.run.measures().peak.pressure);
        assert!(relative_error(own, others) <= 1e-3, "{what}: {own} and {others} MPa");
        assert!(relative_error(coarse, own) <= 1e-3, "{what}: {coarse} and {own} MPa");
    }
}

/// A whole block whose contact lies off its middle by so many half-widths.
fn off_the_middle(shift: f64) -> (Scene, Hertz) {
    let (one, hertz) = under(OFF);
    let side = one.size * one.half_width();
    let centre = shift * one.half_width();
    let field = VectorField::of(move |[x, y]: [f64; 2]| hertz.stress(x - centre, y));
    let mut scene = one.scene_under(field.clone());
    let body = &mut scene.bodies[0];
    body.shape = Shape::Rectangle { x: [-side, side], y: [0.0, side], contact: Face::Bottom };
    body.loads = ["left", "right", "far"].map(|side| Load::on(side, Action::Stress(field.clone()))).to_vec();
    body.supports = vec![Support { at: Place::Point([-side, side]), component: Component::X, value: 0.0 }];
    let pair = &mut scene.contacts[0];
    pair.symmetric = false;
    pair.path = Path::Straight { origin: [centre, 0.0], both_sides: true };
    (scene, hertz)
}

#[test]
fn both_ends_of_a_contact_off_the_middle_of_its_body_are_found() {
    let meshes = [(Order::Sextic, 2, 1e-5, 3000), (Order::Octic, 3, 1e-6, 5400)];
    for shift in [0.0, 0.4, -1.3] {
        let (scene, hertz) = off_the_middle(shift);
        for (order, layers, bound, most) in meshes {
            let answer = solved(Fitted { order, layers }, &scene);
            let errors = errors(&answer.run, &hertz);
            assert!(errors.iter().all(|error| *error <= bound), "{order:?} at {shift}: {errors:?}");
            assert!(answer.run.dofs <= most, "{order:?} at {shift}: {} dofs", answer.run.dofs);
            for end in answer.stretches[0][0] {
                assert!(relative_error(end.abs(), hertz.half_width()) <= 5e-4, "{order:?} at {shift}: {end}");
            }
        }
    }
}

#[test]
fn around_a_contact_that_is_known_frames_fill_the_body_and_touch_all_its_sides() {
    let one = TruncatedHertz::default().scene();
    let (a, side) = (2.5, 20.0);
    let (half, both) = (vec![a], vec![-a, a]);
    // Two cells in the box and three in each of two frames, and four for each layer; twice that on both sides.
    let meshes = [
        (half.clone(), Face::Bottom, 2 + 2 * 3 + 4 * 3),
        (half, Face::Top, 2 + 2 * 3 + 4 * 3),
        (both, Face::Bottom, 2 * (2 + 2 * 3 + 4 * 3)),
    ];
    for (places, contact, cells) in meshes {
        let left = if places.len() > 1 { -side } else { 0.0 };
        let mut scene = one.clone();
        let y = if contact == Face::Bottom { [0.0, side] } else { [-side, 0.0] };
        scene.bodies[0].shape = Shape::Rectangle { x: [left, side], y, contact };
        scene.contacts[0].path = Path::Straight { origin: [0.0, 0.0], both_sides: places.len() > 1 };
        scene.contacts[0].ends = Ends { places: places.clone(), layers: 3, off: 0.0 };
        for order in Order::ALL {
            let mesh = Mesh::of(&scene, resolution(1, 0, order)).expect("mesh");
            let case = format!("{order:?} {contact:?} {places:?}");
            assert!(relative_error(area(&mesh), (side - left) * side) <= 1e-12, "{case}: {}", area(&mesh));
            for (name, length) in [("contact", side - left), ("far", side - left), ("left", side), ("right", side)] {
                let found = workbench::length(&mesh, &scene, name);
                assert!(relative_error(found, length) <= 1e-12, "{case}, {name}: {found}");
            }
            assert_eq!(mesh.cells(), cells, "{case}");
        }
    }
}

#[test]
fn bars_of_fitted_meshes_hold_the_error_of_peak_width_and_ends() {
    for (turn, factor) in LOADS.into_iter().enumerate() {
        let (numbers, hertz) = under(factor);
        for digits in (2..=6).filter(|digits| (digits + turn).is_multiple_of(2)) {
            let answer = solved(Fitted::of_digits(digits), &numbers.scene());
            let bars = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
            let truths = [
                (Quantity::PeakPressure, hertz.peak_pressure()),
                (Quantity::SecondMomentWidth, hertz.half_width()),
                (Quantity::End(0), hertz.half_width()),
            ];
            for (quantity, truth) in truths {
                let one = told_of(&bars.all, &quantity);
                let error = (one.value - truth).abs();
                assert!(error <= one.bar.total(), "{quantity:?}, {digits} digits at {factor}: {error} > {:?}", one.bar);
                assert!(one.bar.total() <= 5e-2 * truth, "{quantity:?}, {digits} digits at {factor}: {:?}", one.bar);
            }
            // The largest shear stress below a line of Hertz, 0.300283 p₀.
            let shear = told_of(&bars.all, &Quantity::Shear { body: 0 });
            let error = (shear.value - 0.300283 * hertz.peak_pressure()).abs();
            assert!(error <= shear.bar.total(), "{digits} digits at {factor}: {error} > {:?}", shear.bar);
        }
    }
}

#[test]
fn layered_meshes_keep_the_uniform_pressure_and_hang_together() {
    let plain = Patch::default().scene();
    for order in [Order::Linear, Order::Quadratic, Order::Quartic, Order::Octic] {
        for places in [vec![4.0], vec![2.5, 7.0], vec![1.0]] {
            let mut scene = plain.clone();
            scene.contacts[0].ends = Ends { places: places.clone(), layers: 3, off: 0.0 };
            let made = meshed(scene, 1, order);
            let area: f64 = area(&made.mesh);
            assert!(relative_error(area, 200.0) <= 1e-12, "{order:?} {places:?}: {area}");
            let solution = made.solve(&Formulation::verification()).expect("solution");
            for point in &solution.points {
                assert!((point.pressure - 100.0).abs() <= 1e-5, "{order:?} {places:?}: {point:?}");
            }
            // Every end is a corner, with a cell on either side that is as small as the layers make it.
            for place in places {
                let mut ends: Vec<f64> = made.edges.iter().flat_map(|edge| edge.ends).collect();
                ends.sort_by(f64::total_cmp);
                assert!(ends.iter().any(|end| (end - place).abs() <= 1e-9), "{order:?}: {place} in {ends:?}");
            }
        }
    }
}

#[test]
fn a_whole_disc_that_touches_over_more_than_a_quarter_of_its_radius_is_fitted_as_its_half_is() {
    // Beyond that it has no frames around the contact, and its right half has lines on the ends of both.
    let disc = |part: &str, support: &str, both_sides: bool, weight: f64| {
        let text = format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"disc\"\nyoung = 1000\npoisson = 0.3\n\
             shape = {{ disc = {{ centre = [0, 50], radius = 50, {part} = true }} }}\n\
             supports = [{{ at = {support}, component = \"x\" }}]\nloads = [{{ body-force = [0, {weight}] }}]\n\
             [contact]\nfirst = \"disc\"\nboth-sides = {both_sides}\ngap = {{ circle = 50 }}\nstretch = 26\n\
             [mesh]\nelements = 8\nper = 13\n"
        );
        solved(Fitted { order: Order::Quintic, layers: 1 }, &parsed(&text).scene)
    };
    for weight in [-0.371429, -0.45] {
        let half = disc("half", "\"axis\"", false, weight);
        let whole = disc("whole", "[0, 50]", true, weight);
        let [[_, end]] = half.stretches[0][..] else { panic!("{:?}", half.stretches) };
        let [[left, right]] = whole.stretches[0][..] else { panic!("{:?}", whole.stretches) };
        assert!(end > 12.5, "{end}");
        assert_relative_eq!(left, -right, max_relative = 1e-6);
        assert_relative_eq!(right, end, max_relative = 1e-6);
        // The lines may lie off the ends by 2e-3 of the half-width.
        let [own, others] = [&whole, &half].map(|answer| answer.run.measures().peak.pressure);
        assert_relative_eq!(own, others, max_relative = 1e-4);
    }
}

#[test]
fn columns_beyond_a_contact_on_both_sides_grow_from_its_last_cell_where_frames_have_no_room() {
    let mut scene = TruncatedHertz::default().scene();
    // Not as deep as half of the contact.
    scene.bodies[0].shape = Shape::Rectangle { x: [-20.0, 20.0], y: [0.0, 1.0], contact: Face::Bottom };
    scene.contacts[0].path = Path::Straight { origin: [0.0, 0.0], both_sides: true };
    scene.contacts[0].ends = Ends { places: vec![-2.5, 2.5], layers: 0, off: 0.0 };
    let mesh = Mesh::of(&scene, resolution(1, 0, Order::Linear)).expect("mesh");
    let mut columns: Vec<f64> = mesh.points.iter().filter(|point| point[1] == 0.0).map(|point| point[0]).collect();
    columns.sort_by(f64::total_cmp);
    // 3.75, 5.625 and no more than a fifth of the body, scaled to the 15 mm that are left.
    let grading = scene.grading;
    let first = 2.5 * grading.along;
    let sizes = [first, first * grading.along, grading.coarsest * 40.0].map(|size| {
        let sum = first + first * grading.along + grading.coarsest * 40.0;
        15.0 * size / sum
    });
    let beyond = sizes.iter().scan(5.0, |at, size| {
        *at += size;
        Some(*at)
    });
    let right: Vec<f64> = [0.0, 2.5, 5.0].into_iter().chain(beyond).collect();
    let wanted: Vec<f64> = right[1..].iter().rev().map(|x| -x).chain(right.iter().copied()).collect();
    assert_eq!(columns.len(), wanted.len(), "{columns:?}");
    for (column, wanted) in columns.iter().zip(wanted) {
        assert!((column - wanted).abs() <= 1e-12, "{column} {wanted}");
    }
}

#[test]
fn pressure_between_nodes_is_the_polynomial_of_the_cell_and_the_bar_of_a_force_of_statics_is_round_off() {
    let case = case("rigid-cosine");
    let answer = solved(Fitted { order: Order::Octic, layers: 3 }, &case.scene);
    let wanted = case.reading(0, &Quantity::Pressure { at: 4.0 }).value;
    let part = answer.run.solution.part(0);
    let stretch = answer.discretisation.scene.contact().stretch;
    // The block is one wavelength high, and its load drawn for an infinite one.
    let error = relative_error(nodal::pressure_at(part, stretch, 4.0), wanted);
    assert!(error <= 3e-4, "{error}");
    let straight = relative_error(profile::interpolate(part.points, stretch, 4.0), wanted);
    assert!(straight > 2e-3, "{straight}");
    let bars = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
    for order in [Order::Quartic, Order::Octic] {
        let answer = solved(Fitted { order, layers: 1 }, &case.scene);
        let force = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
        let bar = force.of(0, &Quantity::Resultant).expect("barred").total();
        assert!(bar <= 1e-7 * answer.run.measures().resultant, "{order:?}: {bar}");
    }
    assert!(bars.of(0, &Quantity::HalfWidth).expect("barred").total() <= 2e-4 * answer.run.measures().half_width());
}

#[test]
fn chain_of_bodies_whose_contacts_end_alike_is_fitted() {
    let case = scene("chain", &[]);
    let answer = solved(Fitted { order: Order::Sextic, layers: 2 }, &case.scene);
    let material = Material::STEEL.plane_modulus(case.scene.plane);
    let expected = [(10.0, material), (5.0, 0.5 * material), (5.0, 0.5 * material)];
    for (contact, (radius, modulus)) in answer.run.contacts.iter().zip(expected) {
        let hertz = Hertz { load: 1000.0, radius, modulus };
        // Discs are no half-planes: (a/R)² is 5e-4.
        let error = relative_error(contact.measures.peak.pressure, hertz.peak_pressure());
        assert!(error <= 1e-3, "{error}");
    }
}

#[test]
fn a_contact_that_stays_open_beside_others_has_no_end_to_fit() {
    let scene = scene("parabola-beside-open", &[]).scene;
    let answer = solved(Fitted { order: Order::Sextic, layers: 2 }, &scene);
    let [closed, open] = &answer.run.contacts[..] else { panic!("two contacts") };
    assert!(open.measures.stretches.is_empty());
    let hertz = Hertz { load: 1000.0, radius: 20.0, modulus: Material::STEEL.plane_modulus(scene.plane) };
    let error = relative_error(closed.measures.peak.pressure, hertz.peak_pressure());
    assert!(error <= 1e-3, "{error}");
}

/// What is said of a scene that no mesh can be fitted to.
fn refusal(scene: &Scene) -> String {
    let error = Fitted::of_digits(4).solve(scene, &Formulation::verification()).expect_err("refused");
    format!("{} {}: {}", error.place, error.message, error.remedy)
}

/// A block held at a point inside it.
fn held_inside() -> Scene {
    let mut scene = case("eccentric-to-accuracy").scene;
    scene.bodies[0].supports[0].at = Place::Point([0.37, 0.41]);
    scene
}

/// A beam on two rollers, or on one and held on its left.
#[test]
fn rectangles_have_nodes_where_they_are_held_and_pressed_also_on_fitted_meshes() {
    let beam = text("beam-on-rollers");
    let (before, rest) = beam.split_once("[[contact]]").expect("a contact");
    let (_, right) = rest.split_once("[[contact]]").expect("another");
    let hinged = before.replace("supports = [", "supports = [{ at = [-60, 7.3], component = \"y\" }, ");
    let [whole, one] = [beam.clone(), format!("{hinged}[contact]{right}")].map(|text| parsed(&text).scene);
    for (scene, lever, about) in [(whole, 100.0, -50.0), (one, 110.0, -60.0)] {
        let moment = 150.0 * (13.777 - about) - 70.0 * (22.1 + about) - 30.0 * (22.3 + about);
        let runs = [
            Run::of(&meshed(scene.clone(), 8, Order::Quadratic), &Formulation::verification()).expect("run"),
            solved(Fitted::of_digits(4), &scene).run,
        ];
        // The contacts lie less than their half-widths off the lowest points of the rollers.
        for run in runs {
            let last = &run.contacts[run.contacts.len() - 1];
            let error = relative_error(last.measures.resultant, moment / lever);
            assert!(error <= 0.3 / lever, "{error}");
        }
    }
}

#[test]
fn candidates_of_a_lower_quarter_end_before_the_cut_that_holds_it_however_far_they_go() {
    let scene = scene("quarter-discs", &[]).scene;
    let hertz = Hertz { load: 2000.0, radius: 72.0 / 17.0, modulus: scene.modulus_of(&scene.contacts[0]) };
    let answer = solved(Fitted::of_digits(4), &scene);
    // Half-planes and parabolas are off by (a/R)², 1/800.
    for error in errors(&answer.run, &hertz) {
        assert!(error <= 5e-4, "{error}");
    }
}

#[test]
fn ends_that_would_move_there_and_back_come_to_rest_within_their_bars() {
    // Rubber on a small roller of steel: on cells of order 6 two series of the end take turns.
    let rubber = [
        ["young = 210e3\npoisson = 0.3", "young = 3\npoisson = 0.499"],
        ["centre = [0, 8], radius = 8", "centre = [0, 200], radius = 200"],
        ["centre = [0, -9], radius = 9", "centre = [0, -10], radius = 10"],
        ["force = [0, -1000]", "force = [0, -1.1428571428571428]"],
        ["stretch = 5", "stretch = 3"],
    ];
    let scene = scene("quarter-discs", &rubber).scene;
    let [coarse, fine] = [4, 6].map(|digits| {
        let answer = solved(Fitted::of_digits(digits), &scene);
        let bars = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
        [Quantity::PeakPressure, Quantity::HalfWidth].map(|quantity| told_of(&bars.all, &quantity).clone())
    });
    for (coarse, fine) in coarse.iter().zip(&fine) {
        let apart = (coarse.value - fine.value).abs();
        assert!(apart <= coarse.bar.total() + fine.bar.total(), "{:?}: {apart}, {:?}", coarse.quantity, coarse.bar);
    }
}

#[test]
fn thin_ring_under_a_force_at_its_top_is_fitted_without_a_folded_cell() {
    let scene = scene("ring-under-a-force", &[]).scene;
    for digits in [2, 4] {
        let answer = solved(Fitted::of_digits(digits), &scene);
        // The force on the half is half of that on the ring.
        assert!(relative_error(answer.run.measures().resultant, 60.0) <= 1e-6, "{}", answer.run.measures().resultant);
    }
}

#[test]
fn bars_hold_on_a_thin_layer_that_is_pressed_in_part() {
    let scene = scene("layer-pressed-in-part", &[]).scene;
    let wanted = [Quantity::PeakPressure, Quantity::HalfWidth, Quantity::SecondMomentWidth];
    // Equal 8-node cells, which know neither of the contact nor of the part.
    let (_, fine) = solved_on(scene.clone(), resolution(12, 3, Order::Quadratic), &Formulation::verification());
    for digits in [2, 4, 6] {
        let answer = solved(Fitted::of_digits(digits), &scene);
        let bars = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
        for quantity in &wanted {
            let one = told_of(&bars.all, quantity);
            let [truth, apart] = [quantity.of(fine.measures()), one.bar.total()];
            // What the fine mesh leaves of a half-width.
            let left = 3e-4 * truth;
            assert!(
                (one.value - truth).abs() <= apart + left,
                "{quantity:?}, {digits}: {} ± {apart}, {truth}",
                one.value
            );
        }
    }
}

#[test]
fn forces_that_a_clamped_side_prescribes_are_within_their_bars() {
    let text = std::fs::read_to_string(root().join("tests/data/wild/2_displacement_driven.toml")).expect("a scene");
    // By cells of order 8 in three layers more, towards the corner of the clamped side too: a mesh of its own.
    let finer = Fitted { layers: 6, ..Fitted::of_digits(6) };
    for poisson in ["0.3", "0.4"] {
        let scene = parsed(&text.replace("poisson = 0.3", &format!("poisson = {poisson}"))).scene;
        let truth = solved(finer, &scene).run.measures().resultant;
        for digits in [2, 3, 4, 5] {
            let answer = solved(Fitted::of_digits(digits), &scene);
            let all = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars").all;
            let force = told_of(&all, &Quantity::Resultant);
            assert!((force.value - truth).abs() <= force.bar.total(), "{digits}: {force:?} beside {truth}");
        }
    }
}

/// Orders 4, 5 and 6 agree on the centre by chance, where all of them are off by the same.
#[test]
fn centre_and_moment_of_a_contact_off_the_middle_of_its_layer_are_within_their_bars() {
    let scene = |poisson: f64, pushed: f64, from_left: f64| {
        let text = format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"layer\"\nyoung = 3000\npoisson = {poisson}\n\
             shape = {{ rectangle = {{ x = [0, 4], y = [0, 6], contact = \"bottom\" }} }}\nsupports = [\
             {{ at = \"left\", component = \"x\" }}, {{ at = \"right\", component = \"x\" }}, \
             {{ at = \"far\", component = \"x\" }}, {{ at = \"far\", component = \"y\", value = {pushed} }}]\n\
             [contact]\nfirst = \"layer\"\nboth-sides = true\norigin = [{from_left}, 0]\n\
             gap = {{ parabola = 30 }}\nstretch = 1.2\n[mesh]\nelements = 8\nper = 1\n"
        );
        parsed(&text).scene
    };
    for scene in [scene(0.0, -0.0305, 1.565), scene(0.49, -0.02, 1.4)] {
        let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-4)).expect("solved");
        assert_eq!(answer.unmet, None);
        let truth = answer.run.measures();
        for digits in [2, 3, 4, 5] {
            let answer = solved(Fitted::of_digits(digits), &scene);
            let all = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars").all;
            for (quantity, truth) in
                [(Quantity::Centre, truth.centre), (Quantity::Moment, truth.centre * truth.resultant)]
            {
                let one = told_of(&all, &quantity);
                assert!((one.value - truth).abs() <= one.bar.total(), "{digits}: {one:?} beside {truth}");
            }
        }
    }
}

#[test]
fn what_no_mesh_is_fitted_to_is_refused_with_its_place_and_the_remedy() {
    let open = Bars { push: 0.9, ..Bars::default() }.scene();
    let refused = [
        (open, "bar", "no candidate is closed"),
        (Bars::default().scene(), "bar", "ends where its candidates end"),
        (case("three-rings").scene, "inner fit", "ends where its candidates end"),
        (case("rings-from-gmsh").scene, "inner", "the mesh of this body is given"),
        (case("blocks").scene, "upper", "ends where its candidates end"),
        (held_inside(), "block", "there is no node at"),
    ];
    for (scene, place, message) in refused {
        let told = refusal(&scene);
        assert!(told.contains(place) && told.contains(message), "{}: {told}", scene.name);
        assert!(told.contains("leave out --fitted"), "{}: {told}", scene.name);
        // A contact that goes on beyond its candidates ends with them too.
        let widens = told.contains("widen the candidate stretch");
        assert_eq!(widens, message.contains("candidates end"), "{}: {told}", scene.name);
    }
}

#[test]
fn fitted_meshes_are_iterated_to_their_last_digit_unless_a_tolerance_is_asked_for() {
    let error = |order: &str, more: &[&str]| {
        let asked = ["solve", "pin-plate", "--fitted", "--order", order, "--no-error-bar"];
        let document = json(&[&asked, more].concat());
        document["contacts"][0]["iteration_error"]["half_width"].as_f64().expect("a number")
    };
    for order in [Order::Sextic, Order::Octic] {
        let own = error(&order.number().to_string(), &[]);
        assert!(own <= Fitted::misfit(order), "{order:?}: {own}");
    }
    let loose = error("8", &["--tolerance", "1e-3", "--algorithm", "varying"]);
    assert!(loose > Fitted::misfit(Order::Octic), "{loose}");
}

/// Part of a number below which it is met, whatever its bar.
const MILLIONTH: f64 = 1e-6;

/// The numbers of a fitted mesh whose bar is smaller than their error, of those that Hertz tells.
fn beyond_their_bars(answer: &Answer, hertz: &Hertz) -> Vec<String> {
    let bars = accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars");
    let truths = [
        (Quantity::PeakPressure, hertz.peak_pressure()),
        (Quantity::SecondMomentWidth, hertz.half_width()),
        (Quantity::HalfWidth, hertz.half_width()),
    ];
    let told = truths.into_iter().filter_map(|(quantity, truth)| {
        let one = told_of(&bars.all, &quantity);
        let (error, bar) = ((one.value - truth).abs(), one.bar.total());
        let is_within = error <= bar.max(MILLIONTH * truth);
        (!is_within).then(|| format!("{}: {error:e} beyond {bar:e}", quantity.key()))
    });
    told.collect()
}

#[test]
fn a_contact_that_ends_close_to_its_candidates_or_its_block_is_found_within_its_bars() {
    for beyond in [0.02, 0.08] {
        let numbers = TruncatedHertz { stretch: 1.0 + beyond, ..Default::default() };
        let hertz = numbers.closed_form();
        for digits in 3..=6 {
            let answer = solved(Fitted::of_digits(digits), &numbers.scene());
            let wrong = beyond_their_bars(&answer, &hertz);
            assert!(wrong.is_empty(), "{beyond}, {digits} digits: {wrong:?}");
        }
        // The block ends there, too.
        let numbers = TruncatedHertz { size: 1.0 + beyond, ..numbers };
        for asked in [1e-2, 1e-3, 1e-4] {
            let wanted = Asked { most_dofs: Some(20_000), ..Asked::new(asked) };
            let answer = accuracy::solve(&numbers.scene(), &Formulation::verification(), &wanted).expect("solved");
            let [peak, width] = errors(&answer.run, &hertz);
            let half_width = relative_error(answer.run.measures().half_width(), hertz.half_width());
            let error = peak.max(width).max(half_width);
            assert!(error <= asked, "{beyond}: {error} of {asked}");
        }
    }
}

/// A thin layer bonded to a rigid plane, pushed against a profile: two truncated series of its pressure agree by chance
/// 0.4 % below the peak.
const LAYER: &str = "plane = \"axisymmetric\"\n[[body]]\nname = \"layer\"\nyoung = 1000\npoisson = 0.3\n\
    shape = { rectangle = { x = [0, 20], y = [-1, 0], contact = \"top\" } }\n\
    supports = [{ at = \"far\", component = \"y\", value = 0.03 }, { at = \"far\", component = \"x\" }]\n\
    [contact]\nfirst = \"layer\"\ngap = { even = [0.001, -0.00002, 0.000003] }\nstretch = 8\n\
    [mesh]\nelements = 64\nper = 4\n[reference]\nlength = 4\n";
/// A block under a table whose curvature leaps at s = 3, near which the contact ends.
const BESIDE_KNOT: &str = "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 1000\npoisson = 0.3\n\
    shape = { rectangle = { x = [0, 15], y = [0, 10], contact = \"bottom\" } }\nsupports = [{ at = \"left\", component \
    = \"x\" }]\n\
    loads = [{ rigid-face = { at = \"far\", component = \"y\", force = -12 } }]\n\
    [contact]\nfirst = \"block\"\nsymmetric = true\nstretch = 7\n\
    gap = { table = [[0, 0], [1, 0.001], [2, 0.004], [3, 0.012], [4, 0.03], [7, 0.15]], smooth = true }\n\
    [mesh]\nelements = 128\nper = 4\n";

#[test]
fn peaks_of_layers_and_ends_beside_knots_are_those_of_fine_meshes_of_8_node_cells() {
    for (text, quantity, orders) in [
        (LAYER, Quantity::PeakPressure, [Order::Septic, Order::Octic]),
        (BESIDE_KNOT, Quantity::HalfWidth, [Order::Quintic, Order::Octic]),
    ] {
        let case = parsed(text);
        let fine = told_of(&barred(&case, &Formulation::verification()).1.all, &quantity).clone();
        for order in orders {
            let answer = solved(Fitted::of(order, 2), &case.scene);
            let own = told_of(&accuracy::bars(&answer.discretisation, &answer.run, &[]).expect("bars").all, &quantity)
                .clone();
            let bars = fine.bar.total() + own.bar.total();
            assert!((own.value - fine.value).abs() <= bars, "{order:?}: {own:?} beside {fine:?}");
        }
    }
}

#[test]
fn bodies_whose_opposite_contacts_end_near_one_another_are_fitted_to_either() {
    // On 8-node cells, of up to 2.5 million dofs, which end where the contacts do by chance.
    for (name, ends) in [
        ("soft-roller", [[840.9723, 14.9656], [823.3577, 15.2789]]),
        ("plate-between-unlike-rollers", [[1487.4707, 0.308053], [1429.7445, 0.320493]]),
        ("bush", [[281.5788, 43.897_f64.to_radians()], [203.2484, 39.93_f64.to_radians()]]),
    ] {
        let answer = solved(Fitted::of_digits(5), &scene(name, &[]).scene);
        for (contact, [peak, half_width]) in answer.run.contacts.iter().zip(ends) {
            assert_relative_eq!(contact.measures.peak.pressure, peak, max_relative = 3e-5);
            assert_relative_eq!(contact.measures.half_width(), half_width, max_relative = 1.5e-4);
        }
    }
    // A point that is held on such a side has its node.
    let held = "contact = \"bottom\" } }\nsupports = [{ at = \"left\", component = \"x\" }";
    let at_point = [[held, &format!("{held}, {{ at = [8.0, -3.0], component = \"y\" }}")]];
    solved(Fitted::of_digits(4), &scene("plate-between-unlike-rollers", &at_point).scene);
    // Contacts of one side are no opposite ones; the peak of 8-node cells.
    let one_side = solved(Fitted::of_digits(3), &scene("two-on-the-far-side", &[]).scene);
    assert_relative_eq!(one_side.run.measures().peak.pressure, 674.7, max_relative = 3e-4);
}

/// Small cells at the end of a contact stand beside one that is as long as the way from there to the corner.
#[test]
fn a_contact_that_ends_far_from_a_corner_does_not_press_it() {
    let ring = |name: &str, [poisson, inner, outer, sweep]: [f64; 4], contact: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nyoung = 1000\npoisson = {poisson}\nshape = {{ ring = {{ centre = [0, 0], \
            inner = {inner}, outer = {outer}, sweep = {sweep}, contact = \"{contact}\" }} }}\n"
        )
    };
    let text = format!(
        "plane = \"axisymmetric\"\n{}supports = []\nloads = [{{ body-force = [0, -0.22] }}]\n{}\
         supports = [{{ at = \"outer\", component = \"y\" }}]\n\
         [contact]\nfirst = \"ball\"\nsecond = \"cup\"\narc = {{ centre = [0, 0], radius = 10 }}\nstretch = 85\n\
         gap = {{ hole = {{ radius = 10, clearance = 0.01 }} }}\n[mesh]\nelements = 12\nper = 20\n",
        ring("ball", [0.4, 4.0, 10.0, 180.0], "outer"),
        ring("cup", [0.3, 10.0, 15.0, 90.0], "inner").replace("young = 1000", "young = 3000"),
    );
    let answer = solved(Fitted::of(Order::Sextic, 2), &parsed(&text).scene);
    let end = answer.run.measures().half_width().to_degrees();
    assert!((70.0..85.0).contains(&end), "{end}");
    let told = answer.run.with_limits(&answer.discretisation).expect("told");
    assert!(told.contacts[0].unbounded.is_none(), "{:?}", told.contacts[0].unbounded);
}

/// A paraboloid of radius R, pushed by δ: a² = δ R, p₀ = 2 E* a / (π R); no node that carries an area sees it on the
/// first meshes.
#[test]
fn a_contact_smaller_than_an_element_about_the_axis_is_found() {
    let (radius, pushed): (f64, f64) = (100.0, 0.0005);
    let text = format!(
        "plane = \"axisymmetric\"\n[[body]]\nname = \"block\"\nyoung = 1000\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [0, 10], y = [-8, 0], contact = \"top\" }} }}\n\
         supports = [{{ at = \"far\", component = \"y\", value = {pushed} }}]\n\
         [contact]\nfirst = \"block\"\ngap = {{ parabola = {radius} }}\nstretch = 7\n[mesh]\nelements = 9\nper = 3\n"
    );
    let scene = parsed(&text).scene;
    let searched = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-2)).expect("solved");
    assert!(searched.unmet.is_none(), "{:?}", searched.unmet);
    let fitted = solved(Fitted::of(Order::Sextic, 2), &scene).run;
    let half_width = (pushed * radius).sqrt();
    for run in [&searched.run, &fitted] {
        // The block gives way by as much as it is not a half-space: a few hundredths.
        assert_relative_eq!(run.measures().half_width(), half_width, max_relative = 0.03);
        let peak = 2.0 * (1000.0 / 0.91) * half_width / (PI * radius);
        assert_relative_eq!(run.measures().peak.pressure, peak, max_relative = 0.03);
    }
}
