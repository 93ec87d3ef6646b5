//! An accuracy that is asked for is met, or said not to be.

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use approx::assert_relative_eq;
use contact_vv::accuracy::longest::longest;
use contact_vv::accuracy::{self, Answer, Asked, Quantity, fitted, percentage};
use contact_vv::case::library::{Cylinder, PinPlate, PressFit, TruncatedHertz, find};
use contact_vv::case::solved::met;
use contact_vv::case::{Case, Verdict};
use contact_vv::error::Kind;
use contact_vv::measure::{larger, relative_error};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::scene::{Material, PlaneHypothesis, Scene};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::study::random::{Family, Site};

use crate::balance::{scene, solved_on, told_of};
use crate::scene_file::{self, text_of};
use crate::workbench::{self, block_text, kinematic, parsed};

/// Relative errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 3e-3, 1e-3];
/// Half-angle of the pin \[degrees\].
const ANGLE: f64 = 60.0;

/// Truncated Hertz under the load that makes its contact so many times as long as the nominal one, on the outline of
/// that one.
fn truncated(ratio: f64) -> Case {
    let nominal = TruncatedHertz::default();
    let (a_over_r, size, stretch) = (nominal.a_over_r * ratio, nominal.size / ratio, nominal.stretch / ratio);
    TruncatedHertz { a_over_r, size, stretch, ..nominal }.case()
}

/// The same of the cylinder at a/R = 0.005.
fn cylinder(ratio: f64) -> Case {
    let nominal = Cylinder { a_over_r: 0.005, ..Default::default() };
    Cylinder { a_over_r: nominal.a_over_r * ratio, stretch: nominal.stretch / ratio, ..nominal }.case()
}

/// Peak pressure and second-moment width by the closed form.
fn closed_form(case: &Case) -> [f64; 2] {
    [Quantity::PeakPressure, Quantity::SecondMomentWidth].map(|quantity| case.reading(0, &quantity).value)
}

/// Larger relative error of peak and second-moment width; NaN where either is or the run did not converge.
pub fn error(run: &Run, truth: [f64; 2]) -> f64 {
    let measures = run.measures();
    let found = [measures.peak.pressure, measures.second_moment_width];
    let [peak, width] = [0, 1].map(|k| (found[k] / truth[k] - 1.0).abs());
    if run.solution.converged() { larger(peak, width) } else { f64::NAN }
}

fn answered(scene: &Scene, asked: f64) -> Answer {
    accuracy::solve(scene, &kinematic(), &by_moment(asked)).expect("solved")
}

/// An accuracy of peak and second-moment width.
fn by_moment(relative: f64) -> Asked {
    Asked { quantities: vec![Quantity::PeakPressure, Quantity::SecondMomentWidth], ..Asked::new(relative) }
}

#[test]
fn every_later_mesh_starts_from_the_contact_set_of_the_one_before() {
    let scene = cylinder(1.0).scene;
    let asked = Asked { high_order: false, ..by_moment(3e-3) };
    let answer = accuracy::solve(&scene, &kinematic().tolerance(1e-9), &asked).expect("solved");
    assert!(answer.tried.len() > 2);
    for tried in &answer.tried[2..] {
        assert!(tried.iterations <= 3, "{} elements took {} iterations", tried.elements, tried.iterations);
    }
    let discretisation = Discretisation::of(answer.scene.clone(), answer.resolution).expect("meshed");
    let own = discretisation.solve(&answer.run.formulation).expect("solved");
    for (own, carried) in own.points.iter().zip(&answer.run.solution.points) {
        assert_relative_eq!(own.pressure, carried.pressure, max_relative = 1e-6, epsilon = 1e-6);
    }
}

#[test]
fn pin_and_rod_press_fits_and_scene_files_meet_what_they_are_asked() {
    for name in ["cylinder", "pin-rod", "press-fit", "patch", "own-weight"] {
        let problem = find(name, None).expect("known");
        let fine = answered(&problem.scene, 1e-4);
        let fine = [fine.run.measures().peak.pressure, fine.run.measures().second_moment_width];
        for asked in ASKED {
            let answer = answered(&problem.scene, asked);
            assert!(answer.unmet.is_none(), "{name}, {asked}: {:?}", answer.unmet);
            assert!(error(&answer.run, fine) <= asked, "{name}, {asked}");
        }
    }
    let file = scene_file::case("rigid-cosine");
    // Westergaard, as the file's own checks have it.
    let answer = answered(&file.scene, 3e-3);
    assert!(answer.unmet.is_none());
    assert_relative_eq!(answer.run.measures().peak.pressure, 213.067134, max_relative = 3e-3);
}

#[test]
fn disc_on_a_block_is_solved_with_8_node_cells_whose_middles_do_not_face() {
    let file = scene_file::case("cylinder-on-block");
    for asked in [1e-2, 3e-3, 2e-3] {
        let by_moment = Asked { high_order: false, ..by_moment(asked) };
        let answer = accuracy::solve(&file.scene, &kinematic(), &by_moment).expect("solved");
        assert!(answer.unmet.is_none());
        assert_eq!(answer.resolution.order, Order::Quadratic);
        // Hertz leaves out 0.1 % at a/R = 0.05 and a block of 32 half-widths.
        assert!(error(&answer.run, [1464.678, 2.499228]) <= asked + 1e-3, "{asked}");
    }
}

#[test]
fn cells_of_high_order_meet_up_to_a_millionth_of_peak_and_half_width_with_few_freedoms() {
    // Six digits are those of the load that the block is drawn for; 8-node cells took 27,925 for five.
    let most = [(1e-3, 700), (1e-4, 1_000), (1e-5, 1_700), (1e-6, 2_700)];
    let problems = [truncated(1.0), truncated(0.94), truncated(1.07), find("truncated-sphere", None).expect("known")];
    for (k, problem) in problems.iter().enumerate() {
        let [peak, end] = closed_form(problem);
        for (asked, dofs) in most {
            let answer = accuracy::solve(&problem.scene, &kinematic(), &Asked::new(asked)).expect("solved");
            assert!(answer.unmet.is_none(), "{k}, {asked}: {:?}", answer.unmet);
            for (quantity, truth) in [(Quantity::PeakPressure, peak), (Quantity::HalfWidth, end)] {
                let one = told_of(&answer.estimates, &quantity);
                let [error, of_run] =
                    [one.value, quantity.of(answer.run.measures())].map(|value| relative_error(value, truth));
                assert!(error <= one.relative() && one.relative() <= asked, "{k}, {asked}, {quantity:?}: {error:e}");
                assert!(of_run <= asked, "{k}, {asked}, {quantity:?}: {of_run:e}");
            }
            assert!(answer.run.dofs <= dofs, "{k}, {asked}: {}", answer.run.dofs);
        }
    }
}

#[test]
fn cells_end_with_a_contact_whose_end_the_first_mesh_misses() {
    // The pressure has its peak beside the middle: the first mesh ends the contact a sixth too early.
    let scene = scene("beside-the-middle", &[]).scene;
    for asked in [1e-2, 1e-4] {
        let answer = accuracy::solve(&scene, &kinematic(), &Asked::new(asked)).expect("solved");
        assert!(answer.unmet.is_none() && answer.resolution.order > Order::Quartic, "{asked}: {:?}", answer.unmet);
    }
}

#[test]
fn other_algorithms_leave_what_the_mesh_of_kinematic_load_does() {
    // By constant stiffness a tolerance that is near to what the mesh leaves presses points beyond the contact: a
    // closer one is asked for.
    for (family, number, algorithm, asked) in [
        (Family::Wedge, 93_000, Iteration::Varying, 1e-3),
        (Family::Wedge, 93_000, Iteration::Constant, 1e-3),
        (Family::Hertz, 90_000, Iteration::Constant, 1e-2),
        (Family::Hertz, 90_003, Iteration::Constant, 1e-2),
    ] {
        let sample = Site { family, number }.sample().expect("a sample");
        let formulation = Formulation::new(Element::Node, algorithm);
        let answer = accuracy::solve(&sample.scene, &formulation, &Asked::new(asked)).expect("solved");
        assert!(answer.unmet.is_none(), "{family:?}, {algorithm:?}: {:?}", answer.unmet);
        for one in &answer.estimates {
            let error = (one.value / sample.truth(0, &one.quantity) - 1.0).abs();
            assert!(
                error <= one.relative() && one.relative() <= asked,
                "{family:?}, {algorithm:?}, {:?}: {error:.1e}",
                one.quantity
            );
            assert!(one.bar.mesh <= 0.8 * asked * one.value, "{family:?}, {algorithm:?}, {one:?}");
        }
    }
}

#[test]
fn asked_for_more_than_round_off_leaves_the_answer_is_no_worse() {
    // A ring of a fiftieth of its radius: its stiffness leaves forces no better than 1e-7.
    let scene = scene("thin-on-block", &[]).scene;
    let [met, beyond] =
        [1e-3, 1e-4].map(|asked| accuracy::solve(&scene, &kinematic(), &Asked::new(asked)).expect("solved"));
    let [within, left] = [met.estimate(), beyond.estimate()];
    // What round-off leaves differs a little from mesh to mesh.
    assert!(met.unmet.is_none() && left <= 1.2 * within, "{left:.1e} of 1e-4, {within:.1e} of 1e-3");
}

#[test]
fn fit_of_a_ring_with_a_narrow_bore_is_within_its_bar() {
    let [soft, steel] = [(21e3, 0.49), (210e3, 0.3)].map(|(young, poisson)| Material { young, poisson });
    for part in [400.0, 50.0, 8.0] {
        let fit = PressFit { materials: [soft, steel], plane: PlaneHypothesis::Strain, ..Default::default() };
        let case = PressFit { inner: fit.interface / part, ..fit }.case();
        let truth = case.reading(0, &Quantity::PeakPressure).value;
        for asked in [1e-2, 1e-3, 1e-4, 1e-5] {
            let answer = accuracy::solve(&case.scene, &kinematic(), &Asked::new(asked)).expect("solved");
            let peak = told_of(&answer.estimates, &Quantity::PeakPressure);
            let [error, bar] = [(peak.value / truth - 1.0).abs(), peak.relative()];
            assert!(error <= bar, "bore of 1/{part}, {asked}: {error:.1e} of {bar:.1e}");
        }
    }
}

/// A block under 2000 N on a gap that points tell.
fn pressed(gap: impl Fn(f64) -> f64) -> Scene {
    let rows = (0..=505).map(|k| f64::from(k) / 50.0).map(|s| format!("[{s}, {:e}]", gap(s)));
    let gap = format!(
        "gap = {{ table = [{}], smooth = true }}\nstretch = 10\n[mesh]\nelements = 16\nper = 2",
        rows.collect::<Vec<_>>().join(", ")
    );
    parsed(&block_text([0.0, 60.0], 60.0, "traction = { at = \"far\", force = [0, -2000] }", &gap)).scene
}

#[test]
fn contact_that_fills_candidates_fitted_to_it_is_looked_at_on_ones_that_are_a_tenth_longer() {
    // A bump beyond the contact, which the first mesh does not see and the next one does.
    let scene = pressed(|s| s * s / 2000.0 - 0.006 * (-((s - 6.3) / 0.3).powi(2)).exp());
    let line = Formulation::new(Element::Line, Iteration::Kinematic);
    let answer = accuracy::solve(&scene, &line, &Asked::new(0.15)).expect("solved");
    let [_, filled, longer, ..] = &answer.tried[..] else { panic!("{:?}", answer.tried) };
    // By a twentieth of its length on either side, with the same elements and no bars before.
    assert_relative_eq!(longer.contacts[0].stretch, 1.1 * filled.contacts[0].stretch, max_relative = 1e-12);
    assert!(filled.estimate.is_nan() && (filled.contacts[0].half_width - filled.contacts[0].stretch).abs() <= 1e-9);
}

#[test]
fn a_bar_of_elements_too_wide_for_the_top_is_no_best() {
    let hump = |height: f64| pressed(|s| s * s / 2000.0 + height * (1.0 - (-(s / 0.2).powi(2)).exp()));
    // On the first meshes the hump is not seen, and on the next ones no bar is known.
    let scene = hump(0.002);
    let answer = answered(&scene, 1e-2);
    let fine = Discretisation::of(scene, workbench::resolution(100, 0, Order::Quadratic)).expect("meshed");
    let truth = Run::of(&fine, &kinematic()).expect("solved").measures().peak.pressure;
    let bar = answer.estimates[0].bar.total();
    let off = (answer.run.measures().peak.pressure - truth).abs();
    assert!(bar.is_nan() || off <= bar + 2e-3 * truth, "{off} beyond {bar}");
    // Of a lower one the bars are wider on the next meshes: the first is the best up to that which moves its peak by
    // more than its bar.
    for (most, best) in [(1_000, 0), (4_000, 2)] {
        let asked = Asked { high_order: false, most_dofs: Some(most), ..by_moment(1e-2) };
        let answer = accuracy::solve(&hump(0.0005), &kinematic(), &asked).expect("solved");
        let meshes: Vec<_> = answer.tried.iter().filter(|tried| tried.purpose == "mesh").collect();
        assert!(meshes.last().expect("one").estimate > meshes[0].estimate, "{meshes:?}");
        assert_eq!((answer.run.dofs, meshes.len() > best), (meshes[best].dofs, true), "{most}");
    }
}

#[test]
fn what_cannot_be_met_is_said_with_the_best_that_was_found() {
    // The pressure under the corner of a flat punch has no limit, on however many cells; the half-width is met all the
    // same.
    let punch = find("flat-punch", None).expect("known");
    let answer = accuracy::solve(&punch.scene, &kinematic(), &by_moment(1e-2)).expect("solved");
    assert!(answer.unmet.as_ref().is_some_and(|why| why.contains("no limit")) && answer.run.solution.converged());
    assert!(met(&Asked::new(1e-2), &answer).verdict == Verdict::Fail);
    assert!(answer.dofs_in_all() < 60_000, "{} dofs", answer.dofs_in_all());
    assert!(answer.estimates[1].relative() <= 1e-2, "{:?}", answer.estimates);
    // Its half-width alone is no matter of the corner.
    let asked = Asked { quantities: vec![Quantity::SecondMomentWidth], ..Asked::new(1e-2) };
    let answer = accuracy::solve(&punch.scene, &kinematic(), &asked).expect("solved");
    assert!(answer.unmet.is_none() && answer.estimates.len() == 1);
    // Too few cells, and too few iterations.
    let cylinder = cylinder(1.0).scene;
    let few = Asked { most_cells: 30.0, ..Asked::new(1e-3) };
    let answer = accuracy::solve(&cylinder, &kinematic(), &few).expect("solved");
    assert!(answer.unmet.is_some_and(|why| why.contains("more than 3e1")));
    // The estimate of the best that was found is one all the same.
    let problem = truncated(1.0);
    let few = Asked { most_cells: 2000.0, ..Asked::new(1e-5) };
    let line = Formulation::new(Element::Line, Iteration::Kinematic);
    let answer = accuracy::solve(&problem.scene, &line, &few).expect("solved");
    assert!(answer.unmet.is_some());
    let (error, bar) = (error(&answer.run, closed_form(&problem)), answer.estimate());
    assert!(error <= bar, "{error:e} beyond {bar:e}");
    let mut hasty = kinematic();
    hasty.settings.max_iterations = 1;
    let answer = accuracy::solve(&cylinder, &hasty, &Asked::new(1e-2)).expect("a result, not an error");
    assert!(answer.unmet.is_some_and(|why| why.contains("not converged")));
}

#[test]
fn cells_that_no_gentler_growth_mends_are_refused_as_they_are() {
    // So far from y = 0 that round-off takes the height of the first ones.
    let contact = "gap = { parabola = 50 }\norigin = [0, 1e12]\nstretch = 3e-4\n[mesh]\nelements = 8\nper = 1e-4";
    let near = block_text([0.0, 60.0], 60.0, "traction = { at = \"far\", force = [0, -2000] }", contact);
    let scene = parsed(&near.replace("y = [0, 60]", "y = [1e12, 1000000000060]")).scene;
    let error = accuracy::solve(&scene, &kinematic(), &Asked::new(1e-2)).expect_err("no mesh");
    assert!(error.kind == Kind::DegenerateCell && error.message.contains("Jacobian determinant 0"), "{error}");
}

#[test]
fn contact_end_is_found_within_a_tenth_of_an_element() {
    for ratio in [0.8, 0.9, 1.0, 1.1] {
        let pin = PinPlate::of_half_angle(ANGLE * ratio).case();
        for (problem, angle) in [(truncated(ratio), None), (cylinder(ratio), None), (pin, Some(ANGLE * ratio))] {
            let elements = 8;
            let edge = angle.map_or(problem.scene.reference.length, f64::to_radians);
            let longest = longest(&problem.scene, problem.scene.contact());
            let plan = fitted::Plan::around([-1.03 * edge, 1.03 * edge], longest, elements, Order::Quadratic, 2.0);
            let (scene, resolution) = plan.laid(&problem.scene);
            let (_, run) = solved_on(scene, resolution, &Formulation::verification());
            let [_, found] = fitted::ends(&run, 0);
            let element = edge / elements as f64;
            assert!(
                (found - edge).abs() < 0.15 * element,
                "{} × {ratio}: {}",
                problem.scene.name,
                (found - edge) / element
            );
        }
    }
}

#[test]
fn contact_that_fills_its_candidates_is_looked_at_on_twice_as_long_ones() {
    // The last of 8 elements is pressed, and nothing penetrates beyond it.
    let sample = Site { family: Family::Hertz, number: 90_000 }.sample().expect("a sample");
    let answer = answered(&sample.scene, 1e-1);
    let [first, second] = [0, 1].map(|k| &answer.tried[k]);
    assert!(first.elements == 8 && second.purpose == "contact length", "{first:?}, {second:?}");
    assert_relative_eq!(second.contacts[0].stretch, 2.0 * first.contacts[0].stretch, max_relative = 1e-12);
}

#[test]
fn candidates_may_go_as_far_as_the_sides_of_the_bodies_and_the_gap_do() {
    let block = |sides: [f64; 2], gap: &str| {
        let both = if sides[0] < 0.0 { "both-sides = true\n" } else { "" };
        let contact = format!(
            "{both}gap = {{ {gap} }}\nstretch = 1\n[reference]\nlength = 1\npressure = 1\n[mesh]\nelements = 8\nper = 1"
        );
        parsed(&block_text(sides, 30.0, "traction = { at = \"far\", value = [0, -1] }", &contact)).scene
    };
    let library = |name: &str| find(name, None).expect("known").scene;
    let (on, across) = ([0.0, 60.0], [-45.0, 50.0]);
    for (scene, wanted) in [
        (block(on, "parabola = 50"), 60.0),
        (block(across, "parabola = 50"), 45.0),
        (block([-45.0, 40.0], "parabola = 50"), 40.0),
        (block(on, "punch = 7"), 7.0),
        (block(on, "table = [[0, 0], [4, 0.1], [9, 1]]"), 9.0),
        (block(on, "table = [[0, 0], [4, 0.1], [9, 1]], smooth = true"), 9.0),
        (block(across, "table = [[-6, 1], [0, 0], [4, 0.1], [9, 1]]"), 6.0),
        (block(across, "table = [[-9, 1], [0, 0], [4, 0.1], [5, 1]]"), 5.0),
        (block(on, "cosine = { amplitude = 0.01, wavelength = 40 }"), 20.0),
        // On a circle up to 45°, on an arc up to 90°.
        (block(on, "circle = 20"), 20.0 / SQRT_2),
        (block(on, "circles = [20, -30]"), 20.0 / SQRT_2),
        (block(on, "circles = [50, 30]"), 30.0 / SQRT_2),
        (library("cylinder"), Cylinder::default().radius / SQRT_2),
        (library("press-fit"), FRAC_PI_2),
        (library("pin-rod"), FRAC_PI_2),
    ] {
        assert_relative_eq!(longest(&scene, scene.contact()), wanted, max_relative = 1e-9);
    }
    // A little less than halfway to the next contact of the same side.
    let scene = scene_file::case("plate-on-two-supports").scene;
    let [left, right] = [0, 1].map(|contact: usize| scene.contacts[contact].path.origin()[0]);
    for pair in &scene.contacts {
        let side = (50.0 - pair.path.origin()[0]).min(pair.path.origin()[0] + 50.0);
        assert_relative_eq!(longest(&scene, pair), side.min(0.49 * (right - left).abs()), max_relative = 1e-9);
    }
}

#[test]
fn percentages_are_read_and_nothing_else_is() {
    for (text, wanted) in [("0.1 %", 1e-3), ("1%", 1e-2), (" 20 % ", 0.2), ("0.001 %", 1e-5), ("0.0001 %", 1e-6)] {
        assert_relative_eq!(percentage(text).expect(text), wanted, max_relative = 1e-12);
    }
    for text in ["0.1", "%", "0 %", "-1 %", "nan %", "inf %", "21 %", "1e-5 %", "one %", "", "0.1 % "] {
        assert_eq!(percentage(text).is_ok(), text == "0.1 % ", "{text}");
    }
    assert_eq!(percentage("21 %"), Err("it must lie between 0.0001 % and 20 %".into()));
}

#[test]
fn accuracy_in_a_file_is_the_engines_and_its_first_mesh_is_within_limits() {
    let file = scene_file::case("cylinder-to-accuracy");
    let asked = file.accuracy.clone().expect("asked");
    assert_relative_eq!(asked.relative, 1e-3, max_relative = 1e-12);
    assert_eq!(asked.quantities, Quantity::ASKED);
    let (meshed, run) = file.solve().expect("solved");
    let answer = meshed.answer;
    let answer = answer.expect("answered");
    assert!(met(&asked, &answer).verdict == Verdict::Pass);
    assert!(error(&run, [576.923077, 0.25]) <= 1e-3);
    assert_eq!(file.resolution, Resolution { elements: 8, refinement: 0, order: Order::Quadratic });
    let one = "accuracy = \"1 %\"\nquantity = [\"second-moment-width\"]";
    let one = text_of("cylinder-to-accuracy.toml").replace("accuracy = \"0.1 %\"", one);
    let asked = parsed(&one).accuracy.expect("asked");
    assert_eq!(asked.quantities, [Quantity::SecondMomentWidth]);
}
