//! Reactions: what the supports exert balances loads and contact, with the sign of a force on the body.

use approx::assert_relative_eq;
use contact_vv::accuracy::{self, Asked, Barred, Quantity, bars};
use contact_vv::case::Case;
use contact_vv::error::Error;
use contact_vv::solution::Solution;
use contact_vv::solve::{Discretisation, Formulation};

use crate::balance::solved_as_it_says;
use crate::scene_file::text_of;
use crate::workbench::{distance, parsed};

/// Round-off of nodal forces, relative to the largest force on a body.
const ROUND_OFF: f64 = 1e-9;

fn solved(text: &str) -> (Discretisation, Solution) {
    let (discretisation, run) = solved_as_it_says(&parsed(text));
    assert!(run.solution.converged(), "{text}");
    (discretisation, run.solution)
}

/// A bar 10 mm wide and 20 mm high, 3 mm thick, over a rigid plane.
fn bar(plane: &str, gap: f64, supports: &str, loads: &str) -> String {
    format!(
        "title = \"bar\"\nplane = \"{plane}\"\nthickness = 3\n[[body]]\nname = \"bar\"\nyoung = 1000\npoisson = 0.25\n\
         shape = {{ rectangle = {{ x = [0, 10], y = [0, 20], contact = \"bottom\" }} }}\nsupports = [{supports}]\n\
         loads = [{loads}]\n[contact]\nfirst = \"bar\"\ngap = {{ uniform = {gap} }}\nstretch = 10\n[reference]\n\
         pressure = 1\n[mesh]\nelements = 4\nper = 10\n[solve]\ntolerance = 1e-8\n"
    )
}

fn forces(discretisation: &Discretisation, solution: &Solution) -> Vec<f64> {
    discretisation.reactions(1.0, solution).expect("reactions").iter().map(|reaction| reaction.force).collect()
}

fn forces_of(text: &str) -> Vec<f64> {
    let (discretisation, solution) = solved(text);
    forces(&discretisation, &solution)
}

/// Contact force on a body from the contact points alone, `−Σ A p n` of the nodes' retained dofs \[N\].
fn contact(discretisation: &Discretisation, solution: &Solution, body: usize) -> [f64; 2] {
    let offset = discretisation.condensed.offsets[body];
    let candidates = discretisation.mesh.bodies[body].candidates.iter().enumerate();
    candidates.fold([0.0; 2], |[x, y], (index, candidate)| {
        let force = solution.contact_force[offset + index];
        [x + force * candidate.normal[0], y + force * candidate.normal[1]]
    })
}

#[test]
fn run_that_ends_before_the_last_increment_has_the_reactions_of_its_own_share() {
    let push = "{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\", value = -0.05 }";
    let text = bar("stress", 0.0, push, "{ body-force = [0.5, -0.25] }");
    let text = text.replace("[solve]", "[solve]\nincrements = 4\nmax-iterations = 2\nstiffness = 1e4");
    let (discretisation, run) = solved_as_it_says(&parsed(&text));
    assert!(!run.solution.converged() && run.share() < 1.0, "{:?} after {}", run.solution.outcome, run.share());
    let reactions = discretisation.reactions(run.share(), &run.solution).expect("reactions");
    let touch = contact(&discretisation, &run.solution, 0);
    let [x, y] = [0.5, -0.25].map(|density| run.share() * density * 600.0);
    assert!(touch[1] > 1.0, "{touch:?}");
    assert_relative_eq!(reactions[0].force, -x - touch[0], max_relative = 1e-9);
    assert_relative_eq!(reactions[1].force, -y - touch[1], max_relative = 1e-9);
    // Under that share of its loads nothing is left over.
    let equilibrium = discretisation.equilibrium(run.share(), &run.solution).expect("sums");
    assert!(equilibrium.iter().all(|one| one.largest() <= 1e-9), "{equilibrium:?}");
    let held = discretisation.mesh.node_at(&discretisation.scene, 0, [10.0, 20.0]).expect("a corner");
    let fields = discretisation.recover_under(run.share(), &run.solution).expect("recovered");
    assert_relative_eq!(fields.displacement[held][1], -0.05 * run.share(), max_relative = 1e-14);
}

#[test]
fn what_a_contact_presses_too_much_is_left_over_of_the_force_and_turns_the_body() {
    // 600 N, and a hundred times that from both sides, which cancels.
    let loads =
        ["left", "right"].map(|side| format!("{{ pressure = {{ at = \"{side}\", law = {{ uniform = 1000 }} }} }}"));
    let loads = format!("{{ traction = {{ at = \"far\", value = [0, -20] }} }}, {}", loads.join(", "));
    let (discretisation, mut solution) = solved(&bar("strain", 0.0, "{ at = [0, 20], component = \"x\" }", &loads));
    let points = &discretisation.mesh.points;
    let middle = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64);
    let reach = points.iter().map(|[x, y]| (x - middle[0]).hypot(y - middle[1])).fold(0.0, f64::max);
    // A part that grows along x: its force, and its moment about the middle of all nodes.
    let (mut more, mut turning) = (0.0, 0.0);
    for (force, candidate) in solution.contact_force.iter_mut().zip(&discretisation.mesh.bodies[0].candidates) {
        let x = points[candidate.node][0];
        let part = 1e-3 * x * *force;
        (more, turning) = (more + part, turning + part * (x - middle[0]));
        *force += part;
    }
    let found = discretisation.equilibrium(1.0, &solution).expect("sums")[0];
    let largest = solution.contact_force.iter().sum::<f64>();
    assert_relative_eq!(found.force, (more / largest).abs(), max_relative = 1e-6);
    assert_relative_eq!(found.moment, (turning / (largest * reach)).abs(), max_relative = 1e-6);
}

#[test]
fn supports_of_a_bar_take_what_its_stiffness_its_loads_and_the_plane_below_ask_for() {
    let pull = "{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\", value = 0.02 }, \
                { at = [0, 20], component = \"y\" }";
    let push = "{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\", value = -0.05 }";
    let held = "{ at = \"left\", component = \"x\" }, { at = [0, 20], component = \"y\" }";
    let loads = "{ traction = { at = \"left\", value = [2, 0] } }, { force = { at = [0, 20], value = [5, -11] } }";
    // Sideways, above an open gap: E' A u / L with E' = E in plane stress, E / (1 − ν²) in plane strain; of the height,
    // over the gap.
    let [stress, strain] = [1000.0, 1000.0 / (1.0 - 0.25 * 0.25)].map(|modulus| modulus * (20.0 * 3.0) * 0.02 / 10.0);
    let pressed = 1000.0 * (10.0 * 3.0) * (0.05 - 0.01) / 20.0;
    for (what, text, wanted, below) in [
        ("pulled, plane stress", bar("stress", 1.0, pull, ""), vec![-stress, stress, 0.0], 0.0),
        ("pulled, plane strain", bar("strain", 1.0, pull, ""), vec![-strain, strain, 0.0], 0.0),
        ("pushed onto the plane", bar("stress", 0.01, push, ""), vec![0.0, -pressed], pressed),
        ("loads on held components", bar("stress", 1.0, held, loads), vec![-(2.0 * 20.0 * 3.0 + 5.0), 11.0], 0.0),
    ] {
        let (discretisation, solution) = solved(&text);
        let found = forces(&discretisation, &solution);
        let largest = wanted.iter().fold(0.0, |most: f64, force: &f64| most.max(force.abs()));
        assert!(distance(&found, &wanted) <= ROUND_OFF * largest, "{what}: {found:?}, not {wanted:?}");
        let touch = contact(&discretisation, &solution, 0)[1];
        assert!((touch - below).abs() <= ROUND_OFF * largest, "{what}: {touch} on the plane");
    }
    // A component that is held twice at a node is that of the side that it lies on.
    let once = forces_of(&bar("stress", 1.0, pull, ""));
    let point = "{ at = [10, 20], component = \"x\", value = 0.02 }";
    let twice = forces_of(&bar("stress", 1.0, &format!("{pull}, {point}"), ""));
    assert!(distance(&twice, &[&once[..], &[0.0]].concat()) <= ROUND_OFF * once[1], "{twice:?}, {once:?}");
}

#[test]
fn blocks_between_walls_lean_on_them_with_poissons_share() {
    // σ_x = ν/(1−ν) σ_y where nothing gives way sideways; walls push inwards, the ground upwards.
    let side = |poisson: f64, height: f64| poisson / (1.0 - poisson) * 100.0 * height * 2.0;
    let (upper, lower) = (side(0.3, 10.0), side(0.33, 5.0));
    let wanted = [upper, -upper, lower, -lower, 2000.0];
    for (found, wanted) in forces_of(&text_of("blocks.toml")).into_iter().zip(wanted) {
        assert_relative_eq!(found, wanted, max_relative = 1e-7);
    }
}

/// The bars of the reactions of a bar under a body force.
fn barred(supports: &str) -> Vec<Barred> {
    let load = "{ body-force = [0.5, -5] }";
    let (discretisation, run) = solved_as_it_says(&parsed(&bar("stress", 0.0, supports, load)));
    let all = bars(&discretisation, &run, &[]).expect("bars").all;
    all.into_iter().filter(|one| matches!(one.quantity, Quantity::Reaction { .. })).collect()
}

#[test]
fn what_sides_with_unlike_displacements_at_their_corner_exert_has_no_bar() {
    let held = |side: &str, value: &str| format!("{{ at = \"{side}\", component = \"x\", value = {value} }}");
    for (left, far, torn) in
        [("0", "-0.05", true), ("0.05", "0.0501", true), ("0", "0", false), ("0.05", "0.05", false)]
    {
        for one in barred(&format!("{}, {}", held("left", left), held("far", far))) {
            let why = one.unknown.is_some_and(|why| why.contains("unlike displacements"));
            assert_eq!((one.bar.total().is_nan(), why), (torn, torn), "{one:?}");
        }
    }
}

/// What a point takes beside a side falls with the logarithm of the cells: no mesh tells how far it is from 0. What
/// statics give stays known.
#[test]
fn force_that_a_point_takes_beside_a_side_has_no_bar() {
    let [point, side] = ["{ at = [10, 20], component = \"x\" }", "{ at = \"left\", component = \"x\" }"];
    let alone = barred(point);
    assert_relative_eq!(alone[0].value, -300.0, max_relative = 1e-6);
    assert!(alone[0].bar.total() <= 1e-4, "{alone:?}");
    for supports in [format!("{side}, {point}"), format!("{point}, {side}")] {
        let shared = barred(&supports);
        assert_relative_eq!(shared[0].value + shared[1].value, -300.0, max_relative = 1e-6);
        for one in shared {
            assert!(one.bar.total().is_nan() && one.unknown.is_some_and(|why| why.contains("at a point")), "{one:?}");
        }
    }
}

/// A block on a parabola, held at a point.
fn block(plane: &str, body: &str) -> Case {
    let second = if body.contains("[[body]]") { "second = \"base\"\n" } else { "" };
    parsed(&format!(
        "{plane}\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [0, 20], y = [0, 20], contact = \"bottom\" }} }}\n{body}\n\
         [contact]\nfirst = \"block\"\n{second}gap = {{ parabola = 100 }}\nstretch = 2\n[mesh]\nelements = 8\nper = 1\n"
    ))
}

/// What a point takes beside the contact it takes from it: as its part vanishes, so does the bar of all that the
/// contact tells.
#[test]
fn contact_that_shares_its_force_with_a_point_has_no_bar() -> Result<(), Error> {
    let [strain, revolution] = ["plane = \"strain\"\nthickness = 1", "plane = \"axisymmetric\""];
    let (line, above) = ("{ at = \"left\", component = \"x\" }", "{ at = [0, 20], component = \"y\"");
    let load = "loads = [{ traction = { at = \"far\", force = [0, -3000] } }]";
    let base = "[[body]]\nname = \"base\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = { rectangle = { x = [0, 20], y = [-20, 0], contact = \"top\" } }\n\
         supports = [{ at = \"left\", component = \"x\" }, { at = [0, -20], component = \"y\" }]";
    for (plane, body, has_bars) in [
        (strain, format!("supports = [{line}, {above}, value = -0.1 }}]"), false),
        (strain, format!("supports = [{line}, {above} }}]\n{load}"), false),
        (revolution, format!("supports = [{above} }}]\n{load}"), false),
        // A point that takes nothing, or what the load alone gives.
        (strain, format!("supports = [{line}, {{ at = [20, 20], component = \"x\" }}]\n{load}"), true),
        (strain, format!("supports = [{line}]\n{}\n{base}", load.replace("3000", "1000")), true),
    ] {
        let case = block(plane, &body);
        let (discretisation, run) = solved_as_it_says(&case);
        let all = bars(&discretisation, &run, &[])?.all;
        for quantity in [Quantity::PeakPressure, Quantity::HalfWidth, Quantity::Resultant] {
            let one = all.iter().find(|one| one.quantity == quantity).expect("a number");
            let why = one.unknown.is_some_and(|why| why.contains("at a point"));
            assert_eq!((one.bar.total().is_finite(), why), (has_bars, !has_bars), "{body}: {one:?}");
        }
        for asked in [0.2, 0.1, 0.05] {
            let answer = accuracy::solve(&case.scene, &Formulation::verification(), &Asked::new(asked))?;
            let why = answer.unmet.is_some_and(|why| why.contains("at a point"));
            assert_eq!(why, !has_bars, "{asked}: {body}");
        }
    }
    Ok(())
}

/// A body far from the point touches nothing that it holds.
#[test]
fn a_contact_that_no_point_reaches_keeps_its_bars() -> Result<(), Error> {
    let text = |value: &str| {
        format!(
            "plane = \"strain\"\nthickness = 1\n\
             [[body]]\nname = \"left\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ rectangle = {{ x = [-60, -20], y = [0, 20], contact = \"bottom\" }} }}\n\
             supports = [{{ at = \"far\", component = \"y\", value = -0.02 }}, {{ at = \"far\", component = \"x\" }}]\n\
             [[body]]\nname = \"right\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ rectangle = {{ x = [20, 60], y = [0, 20], contact = \"bottom\" }} }}\n\
             supports = [{{ at = \"left\", component = \"x\" }}, {{ at = {value}, component = \"y\", value = -0.1 }}]\n\
             [[contact]]\nname = \"a\"\nfirst = \"left\"\norigin = [-40, 0]\nboth-sides = true\ngap = {{ parabola = \
             100 }}\nstretch = 2\n\
             [[contact]]\nname = \"b\"\nfirst = \"right\"\norigin = [40, 0]\nboth-sides = true\ngap = {{ parabola = \
             100 }}\nstretch = 2\n\
             [mesh]\nelements = 8\nper = 2\n"
        )
    };
    let (discretisation, run) = solved_as_it_says(&parsed(&text("[40, 20]")));
    let all = bars(&discretisation, &run, &[])?.all;
    let known = |contact: usize| {
        let own = |one: &&Barred| {
            one.contact == contact && matches!(one.quantity, Quantity::PeakPressure | Quantity::Resultant)
        };
        all.iter().filter(own).map(|one| one.bar.total().is_finite()).collect::<Vec<bool>>()
    };
    assert_eq!((known(0), known(1)), (vec![true; 2], vec![false; 2]));
    Ok(())
}
