//! An accuracy asked for a contact across x = 0 is met wherever the contact lies, and costs twice the half where it is
//! symmetric.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use contact_vv::accuracy::longest::longest;
use contact_vv::accuracy::{self, Answer, Asked, Quantity, fitted};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::Scene;
use contact_vv::solve::{Fitted, Formulation, Run};

use crate::accuracy::{ASKED, error};
use crate::balance::solved_on;
use crate::scene_file::text_of;
use crate::workbench::{block_text, parsed};

/// Radius of the parabola \[mm\].
const RADIUS: f64 = 50.0;
/// A mesh made by hand, far finer than any that is answered.
const FINE: &str = "elements = 40\nper = 2\ngrowth = { along = 1.2, depth = 1.15, coarsest = 0.08 }";

/// A block on x from `left` to `right` under a parabola, pressed with Hertz's load for the half-width `a` at `centre`.
///
/// It rolls on the parabola until the contact lies under the load: Hertz's, but for the size of the block.
fn rolling(a: f64, centre: f64, stretch: f64, [left, right]: [f64; 2], mesh: &str) -> String {
    let load = PI * a * a * (210e3 / 0.91) / (4.0 * RADIUS);
    // p = m + k x with the resultant and the moment of the load.
    let [none, first, second] = [1, 2, 3].map(|k| (right.powi(k) - left.powi(k)) / f64::from(k));
    let scale = load / (none * second - first * first);
    let [mean, slope] = [(second - first * centre) * scale, (none * centre - first) * scale];
    let law = format!("polynomial = {{ along = \"x\", coefficients = [{mean}, {slope}] }}");
    let load = format!("pressure = {{ at = \"far\", law = {{ {law} }} }}");
    let contact = format!(
        "both-sides = true\ngap = {{ parabola = {RADIUS} }}\nstretch = {stretch}\n[reference]\nlength = 2\npressure = \
        4000\n\
         [mesh]\n{mesh}"
    );
    block_text([left, right], 40.0, &load, &contact).replace("at = [0, 40]", &format!("at = [{right}, 40]"))
}

const WIDE: [f64; 2] = [-40.0, 40.0];
const ANY: &str = "accuracy = \"1 %\"";

fn answered(scene: &Scene, asked: f64) -> Answer {
    let quantities = vec![Quantity::PeakPressure, Quantity::SecondMomentWidth];
    accuracy::solve(scene, &Formulation::verification(), &Asked { quantities, ..Asked::new(asked) }).expect("solved")
}

fn by_hand(text: &str) -> Run {
    let mut file = parsed(text);
    // At the default tolerance the iteration leaves 0.08 % in the half-width.
    file.formulations[0].settings.tolerance = 1e-8;
    file.solve().expect("solved").1
}

fn both(run: &Run) -> [f64; 2] {
    [run.measures().peak.pressure, run.measures().second_moment_width]
}

/// That an answer is met, within what is asked and what is estimated, but for what the truth itself leaves.
fn met(answer: &Answer, asked: f64, truth: [f64; 2], place: &str) {
    assert!(answer.unmet.is_none(), "{place}: {:?}", answer.unmet);
    let error = error(&answer.run, truth);
    assert!(error <= asked, "{place}: {error:e}");
    assert!(error <= answer.estimate() + 1e-4, "{place}: {error:e} beyond {:e}", answer.estimate());
}

/// Both candidates beyond the ends are open, and the stretch reaches little beyond the outer end.
fn covers(answer: &Answer, place: &str) {
    let pair = answer.scene.contact();
    assert!(!fitted::is_filled(&answer.run, 0), "{place}");
    let outer = answer.run.measures().edge().max(-answer.run.measures().begin());
    assert!(pair.stretch > outer, "{place}: {} and {outer}", pair.stretch);
    assert!(
        pair.stretch < outer + 1.5 * answer.run.measures().second_moment_width,
        "{place}: {} and {outer}",
        pair.stretch
    );
}

/// Symmetric scenes: the half and the whole.
fn twins() -> Vec<[Scene; 2]> {
    let disc = text_of("whole-disc.toml").replace("elements = 12\nper = 1.0", ANY);
    let half_disc = disc
        .replace("whole = true", "half = true")
        .replace("both-sides = true", "")
        .replace("at = [0, 50]", "at = \"axis\"")
        .replace("at = -0.5", "at = 0.5")
        .replace("value = 3624.91511", "value = 1812.457555");
    let half_disc = half_disc.split("[[check]]").next().expect("a scene").to_owned();
    let block = rolling(2.0, 0.0, 5.0, WIDE, ANY);
    let half_block = block
        .replace("both-sides = true\n", "")
        .replace("x = [-40, 40]", "x = [0, 40]")
        .replace("at = [40, 40]", "at = \"left\"");
    [[half_disc, disc], [half_block, block]].map(|texts| texts.map(|text| parsed(&text).scene)).into()
}

#[test]
fn symmetric_contact_takes_twice_the_freedoms_of_its_half_and_the_same_meshes() {
    for scenes in twins() {
        for asked in ASKED {
            let [half, whole] = [&scenes[0], &scenes[1]].map(|scene| answered(scene, asked));
            let place = format!("{}, {asked}", whole.scene.bodies[0].name);
            assert!(half.unmet.is_none() && whole.unmet.is_none(), "{place}");
            assert_eq!(whole.tried.len(), half.tried.len(), "{place}\n{:?}\n{:?}", whole.tried, half.tried);
            assert_relative_eq!(whole.run.dofs as f64, 2.0 * half.run.dofs as f64, max_relative = 0.01);
            assert_relative_eq!(whole.scene.contact().stretch, half.scene.contact().stretch, max_relative = 1e-6);
            // Where the ends are sought, they rest where they are good enough for the order.
            let order = whole.resolution.order;
            let (apart, spread) = if order > Order::Quadratic { (Fitted::misfit(order), 0.2) } else { (1e-6, 1e-3) };
            assert!(error(&whole.run, both(&half.run)) <= apart, "{place}");
            assert_relative_eq!(whole.estimate(), half.estimate(), max_relative = spread);
        }
    }
}

#[test]
fn mirror_image_is_answered_with_the_mirrored_mesh() {
    for (a, centre) in [(2.0, 1.3), (1.0, 2.5)] {
        let [right, left] =
            [centre, -centre].map(|centre| answered(&parsed(&rolling(a, centre, 6.0, WIDE, ANY)).scene, 3e-3));
        assert!(right.unmet.is_none() && left.unmet.is_none());
        covers(&right, "right");
        covers(&left, "left");
        assert_eq!(right.run.dofs, left.run.dofs);
        assert_relative_eq!(right.scene.contact().stretch, left.scene.contact().stretch, max_relative = 1e-6);
        assert_relative_eq!(right.run.measures().centre, -left.run.measures().centre, max_relative = 1e-6);
        assert!(error(&right.run, both(&left.run)) <= 1e-6);
    }
}

#[test]
fn both_ends_are_found_within_a_tenth_of_an_element() {
    for (a, centre) in [(2.0, 0.0), (2.0, 0.4), (2.0, -1.1), (1.5, 2.2), (1.5, -2.2)] {
        let scene = parsed(&rolling(a, centre, 6.0, WIDE, ANY)).scene;
        let elements = 8;
        let guessed = [centre - 1.03 * a, centre + 1.03 * a];
        let plan = fitted::Plan::around(guessed, 40.0, elements, Order::Quadratic, 2.0);
        let (scene, resolution) = plan.laid(&scene);
        let (_, run) = solved_on(scene, resolution, &Formulation::verification());
        let found = fitted::ends(&run, 0);
        for (found, side) in found.into_iter().zip([-1.0, 1.0]) {
            let exact = centre + side * run.measures().second_moment_width;
            let off = (found - exact) / (a / elements as f64);
            assert!(off.abs() < 0.15, "{a} at {centre}: {found}, off by {off}");
        }
    }
}

#[test]
fn elements_resolve_the_contact_and_both_its_ends_lie_at_one_place_of_an_element() {
    let scene = parsed(&rolling(2.0, 0.0, 6.0, WIDE, ANY)).scene;
    for ends in [[-2.0, 2.0], [-1.0, 3.0], [-2.6, 1.4], [0.7, 4.7], [-4.8, -0.8], [-0.9, 1.1], [4.0, 5.0]] {
        for elements in [4, 8, 16, 32] {
            let plan = fitted::Plan::around(ends, 40.0, elements, Order::Quadratic, 4.0);
            let (laid, resolution) = plan.laid(&scene);
            let mesh = Mesh::of(&laid, resolution).expect("meshed");
            let nodes: Vec<f64> = mesh.bodies[0].candidates.iter().map(|candidate| candidate.coordinate).collect();
            let corners: Vec<f64> = nodes.iter().copied().step_by(2).collect();
            assert!(corners[0] < ends[0] && corners[corners.len() - 1] > ends[1]);
            let within = corners.windows(2).filter(|pair| pair[1] > ends[0] && pair[0] < ends[1]).count();
            assert!(within.abs_diff(2 * elements) <= 1, "{within} elements of {elements} between {ends:?}");
            for (end, side) in ends.into_iter().zip([-1.0, 1.0]) {
                let after = corners.partition_point(|corner| *corner < end);
                let place = (end - corners[after - 1]) / (corners[after] - corners[after - 1]);
                let covered = if side > 0.0 { place } else { 1.0 - place };
                assert!((covered - 0.875).abs() < 0.05, "{covered} of the element at {end} of {ends:?}, {elements}");
            }
        }
    }
}

#[test]
fn body_that_ends_sooner_on_one_side_limits_the_stretch_and_longer_contact_is_refused() {
    let near = |a: f64| parsed(&rolling(a, 1.0, 3.0, [-40.0, 4.0], ANY)).scene;
    assert_relative_eq!(longest(&near(2.0), near(2.0).contact()), 4.0);
    let fine = both(&by_hand(&rolling(2.0, 1.0, 3.8, [-40.0, 4.0], FINE)));
    met(&answered(&near(2.0), 3e-3), 3e-3, fine, "four on the right");
    let scene = parsed(&rolling(3.0, -2.5, 3.0, [-40.0, 4.0], ANY)).scene;
    let error = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(3e-3)).expect_err("beyond −4");
    assert!(error.to_string().contains("s = -4"), "{error}");
}

#[test]
fn contact_too_far_from_the_middle_for_its_width_is_told() {
    let scene = parsed(&rolling(0.5, 30.0, 31.0, WIDE, ANY)).scene;
    let answer = answered(&scene, 1e-2);
    assert!(answer.unmet.as_ref().is_some_and(|why| why.contains("put x = 0 nearer to it")), "{:?}", answer.unmet);
}

#[test]
fn first_mesh_across_the_middle_that_does_not_converge_ends_the_search_where_it_tells_the_contact() {
    let mut formulation = Formulation::verification();
    formulation.settings.max_iterations = 1;
    let scene = parsed(&rolling(2.0, 0.0, 3.0, WIDE, ANY)).scene;
    let answer = accuracy::solve(&scene, &formulation, &Asked::new(1e-2)).expect("solved");
    let why = answer.unmet.as_deref().unwrap_or("met");
    assert!(why.contains("the first iteration ended so") && answer.tried.len() == 1, "{why}, {}", answer.tried.len());
}

/// Candidates of a body whose cells are given end with one of them: those that were too short once are not tried again.
#[test]
fn disc_on_blocks_of_wide_cells_is_answered() {
    let load = 9000.0;
    let text = format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"disc\"\nyoung = 4e5\npoisson = 0.3\n\
         shape = {{ disc = {{ centre = [0, 30], radius = 30 }} }}\nsupports = [{{ at = \"axis\", component = \"x\" \
         }}]\n\
         loads = [{{ traction = {{ at = \"cut\", force = [0, -{load}] }} }}]\n\
         [[body]]\nname = \"block\"\nyoung = 4e5\npoisson = 0.3\n\
         shape = {{ blocks = [{{ corners = [[0, -15], [16, -15], [16, 0], [0, 0]], elements = [13, 6], bottom = \
         \"far\", top = \"contact\", left = \"left\" }}] }}\n\
         supports = [{{ at = \"left\", component = \"x\" }}, {{ at = \"far\", component = \"y\" }}]\n\
         [contact]\nfirst = \"block\"\nsecond = \"disc\"\ngap = {{ circle = 30 }}\nstretch = 4\n[mesh]\naccuracy = \"1 \
         %\"\n"
    );
    let answer =
        accuracy::solve(&parsed(&text).scene, &Formulation::verification(), &Asked::new(0.01)).expect("solved");
    assert_eq!(answer.unmet, None);
    // Hertz's of two half-planes, but for the size of block and disc.
    let hertz = (4.0 * 2.0 * load * 30.0 / PI / (0.5 * 4e5 / 0.91)).sqrt();
    assert_relative_eq!(answer.run.measures().half_width(), hertz, max_relative = 0.03);
}
