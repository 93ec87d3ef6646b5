//! Reactions: what the supports exert balances loads and contact, with the sign of a force on the body.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::elasticity::reactions::internal_forces;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::Component;
use contact_vv::solution::Solution;
use contact_vv::solve::{Discretisation, Run};

use crate::workbench::{block, parsed, resolution};

/// Round-off of nodal forces, relative to the largest force on a body.
const ROUND_OFF: f64 = 1e-9;

fn solved(text: &str) -> (Discretisation, Solution) {
    let file = parsed(text);
    let discretisation = Discretisation::of(file.scene.clone(), file.resolution).expect("meshed");
    let solution = discretisation.solve(file.formulation()).expect("solved");
    assert!(solution.converged(), "{text}");
    (discretisation, solution)
}

fn scene(name: &str) -> String {
    let path = format!("{}/tests/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("a scene")
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
    discretisation.reactions(solution).expect("reactions").iter().map(|reaction| reaction.force).collect()
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
    let case = parsed(&text);
    let discretisation = Discretisation::of(case.scene.clone(), case.resolution).expect("meshed");
    let run = Run::of(&discretisation, case.formulation()).expect("stopped");
    assert!(!run.solution.converged() && run.share() < 1.0, "{:?} after {}", run.solution.outcome, run.share());
    let reactions = discretisation.reactions_under(run.share(), &run.solution).expect("reactions");
    let touch = contact(&discretisation, &run.solution, 0);
    let [x, y] = [0.5, -0.25].map(|density| run.share() * density * 600.0);
    assert!(touch[1] > 1.0, "{touch:?}");
    assert_relative_eq!(reactions[0].force, -x - touch[0], max_relative = 1e-9);
    assert_relative_eq!(reactions[1].force, -y - touch[1], max_relative = 1e-9);
    let held = discretisation.mesh.node_at(&discretisation.scene, 0, [10.0, 20.0]).expect("a corner");
    let fields = discretisation.recover_under(run.share(), &run.solution).expect("recovered");
    assert_relative_eq!(fields.displacement[held][1], -0.05 * run.share(), max_relative = 1e-14);
}

#[test]
fn bar_pulled_by_its_end_pulls_back_with_its_stiffness() {
    // Sideways, above an open gap: E' A u / L with E' = E in plane stress, E / (1 − ν²) in plane strain.
    let (young, poisson, area, length, pull) = (1000.0, 0.25, 20.0 * 3.0, 10.0, 0.02);
    for (plane, modulus) in [("stress", young), ("strain", young / (1.0 - poisson * poisson))] {
        let supports = "{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\", value = 0.02 }, \
                        { at = [0, 20], component = \"y\" }";
        let (discretisation, solution) = solved(&bar(plane, 1.0, supports, ""));
        let wanted = modulus * area * pull / length;
        let found = forces(&discretisation, &solution);
        assert_relative_eq!(found[0], -wanted, max_relative = ROUND_OFF);
        assert_relative_eq!(found[1], wanted, max_relative = ROUND_OFF);
        assert_abs_diff_eq!(found[2], 0.0, epsilon = ROUND_OFF * wanted);
    }
}

#[test]
fn bar_pushed_onto_a_plane_is_pushed_down_by_its_support_and_up_by_the_plane() {
    let supports = "{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\", value = -0.05 }";
    let (discretisation, solution) = solved(&bar("stress", 0.01, supports, ""));
    let wanted = 1000.0 * (10.0 * 3.0) * (0.05 - 0.01) / 20.0;
    let found = forces(&discretisation, &solution);
    assert_abs_diff_eq!(found[0], 0.0, epsilon = ROUND_OFF * wanted);
    assert_relative_eq!(found[1], -wanted, max_relative = ROUND_OFF);
    assert_relative_eq!(contact(&discretisation, &solution, 0)[1], wanted, max_relative = ROUND_OFF);
}

#[test]
fn blocks_between_walls_lean_on_them_with_poissons_share() {
    let (discretisation, solution) = solved(&scene("blocks"));
    // σ_x = ν/(1−ν) σ_y where nothing gives way sideways; walls push inwards, the ground upwards.
    let side = |poisson: f64, height: f64| poisson / (1.0 - poisson) * 100.0 * height * 2.0;
    let (upper, lower) = (side(0.3, 10.0), side(0.33, 5.0));
    let wanted = [upper, -upper, lower, -lower, 2000.0];
    for (found, wanted) in forces(&discretisation, &solution).into_iter().zip(wanted) {
        assert_relative_eq!(found, wanted, max_relative = 1e-7);
    }
}

#[test]
fn load_on_a_held_component_goes_straight_into_its_support() {
    let supports = "{ at = \"left\", component = \"x\" }, { at = [0, 20], component = \"y\" }";
    let loads = "{ traction = { at = \"left\", value = [2, 0] } }, { force = { at = [0, 20], value = [5, -11] } }";
    let (discretisation, solution) = solved(&bar("stress", 1.0, supports, loads));
    let found = forces(&discretisation, &solution);
    assert_relative_eq!(found[0], -(2.0 * 20.0 * 3.0 + 5.0), max_relative = ROUND_OFF);
    assert_relative_eq!(found[1], 11.0, max_relative = ROUND_OFF);
}

#[test]
fn component_held_twice_at_a_node_is_the_later_supports() {
    let pull = "{ at = \"left\", component = \"x\" }, { at = \"right\", component = \"x\", value = 0.02 }, \
                { at = [0, 20], component = \"y\" }";
    let (discretisation, solution) = solved(&bar("stress", 1.0, pull, ""));
    let once = forces(&discretisation, &solution);
    let corner = format!("{pull}, {{ at = [10, 20], component = \"x\", value = 0.02 }}");
    let (discretisation, solution) = solved(&bar("stress", 1.0, &corner, ""));
    let twice = forces(&discretisation, &solution);
    assert!(twice[3] > 0.01 * once[1], "{twice:?}");
    assert_relative_eq!(twice[1] + twice[3], once[1], max_relative = ROUND_OFF);
    assert_relative_eq!(twice[0], once[0], max_relative = ROUND_OFF);
}

#[test]
fn motion_of_a_body_as_a_whole_has_no_internal_force() {
    for order in [Order::Linear, Order::Quadratic] {
        let scene = block([3.0, 2.0], vec![], vec![]);
        let mesh = Mesh::of(&scene, resolution(3, 0, order)).expect("meshed");
        let force = |of: &dyn Fn([f64; 2]) -> [f64; 2]| {
            let displacement: Vec<[f64; 2]> = mesh.points.iter().map(|&point| of(point)).collect();
            let forces = internal_forces(&scene, &mesh, 0, &displacement).expect("forces");
            forces.into_iter().flatten().map(f64::abs).fold(0.0, f64::max)
        };
        let strained = force(&|[x, _]| [x, 0.0]);
        for still in [force(&|_| [1.0, 0.0]), force(&|_| [0.0, 1.0]), force(&|[x, y]| [-y, x])] {
            assert!(still <= 1e-12 * strained, "{order:?}: {still} of {strained}");
        }
    }
}

#[test]
fn each_support_has_a_reaction_along_its_own_component() {
    let (discretisation, solution) = solved(&scene("press-fit"));
    let reactions = discretisation.reactions(&solution).expect("reactions");
    let places: Vec<(usize, usize)> = reactions.iter().map(|reaction| (reaction.body, reaction.support)).collect();
    assert_eq!(places, [(0, 0), (0, 1), (1, 0), (1, 1)]);
    // The outer ring presses the quarter of the inner one into both planes of symmetry, and hangs on them itself.
    for reaction in reactions {
        let component = discretisation.scene.bodies[reaction.body].supports[reaction.support].component;
        let outward = if component == Component::X { 1.0 } else { -1.0 };
        let sign = [1.0, -1.0][reaction.body];
        let pressure = 12.703010;
        assert_relative_eq!(reaction.force, sign * outward * pressure * 40.0 * 10.0, max_relative = 0.003);
    }
}
