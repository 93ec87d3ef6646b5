//! What is called converged is the discrete solution, whatever stretch, reference, load or stiffness the user guessed.

use std::path::Path;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::Case;
use contact_vv::case::library::{Cylinder, PinRod};
use contact_vv::case::notes;
use contact_vv::mesh::Order;
use contact_vv::scene::Scene;
use contact_vv::solution::Outcome;
use contact_vv::solve::Run;
use contact_vv::solve::{Change, Discretisation, Element, Formulation, Iteration, Origin};

use crate::outputs::{contact_vv, scene};
use crate::scene_file::text_of;
use crate::workbench::resolution;

fn parsed(text: &str) -> Discretisation {
    let file = Case::parse(Path::new("converged.toml"), text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    Discretisation::of(file.scene, file.resolution).expect("meshed")
}

fn meshed(scene: Scene, elements: usize) -> Discretisation {
    Discretisation::of(scene, resolution(elements, 0, Order::Quadratic)).expect("meshed")
}

/// All nine, as they stand in the paper and as the program takes them.
fn all() -> Vec<Formulation> {
    Formulation::nine().into_iter().chain(Formulation::compared()).collect()
}

/// Peak and second-moment width of each contact.
fn quoted(run: &Run) -> Vec<[f64; 2]> {
    run.contacts.iter().map(|contact| [contact.measures.peak.pressure, contact.measures.second_moment_width]).collect()
}

/// Runs of the formulations that converge: each must have the peak and the width that kinematic load finds to 1e-6 with the
/// same contact element, which takes no part in judging them.
fn converged_are_right(
    discretisation: &Discretisation,
    formulations: &[Formulation],
    change: Change,
    place: &str,
) -> usize {
    let mut converged = 0;
    for formulation in formulations {
        let kinematic = Formulation::new(formulation.element, Iteration::Kinematic).tolerance(1e-6);
        let wanted = Run::from_origin(Origin::Own, discretisation, &kinematic, change).expect("solved");
        let run = Run::from_origin(Origin::Own, discretisation, formulation, change).expect("solved");
        assert!(wanted.solution.converged(), "{place}, {}: {}", kinematic.name(), wanted.solution.outcome);
        if !run.solution.converged() {
            continue;
        }
        converged += 1;
        for (found, wanted) in quoted(&run).into_iter().flatten().zip(quoted(&wanted).into_iter().flatten()) {
            // A contact on one point has no width.
            let error = if wanted > 0.0 { (found / wanted - 1.0).abs() } else { 0.0 };
            assert!(error <= 3.0 * formulation.settings.tolerance, "{place}, {}: {error:e}", formulation.name());
        }
        assert!(run.contacts.iter().all(|contact| contact.open == Some(false)), "{place}: {}", formulation.name());
    }
    converged
}

#[test]
fn scene_under_a_thirtieth_of_its_load_is_right_where_it_is_called_converged() {
    let text = text_of("cylinder-on-block.toml").replace("[0, -57.5]", "[0, -2]").replace("tolerance = 1e-6\n", "");
    let converged = converged_are_right(&parsed(&text), &all(), Change::NONE, "load 2");
    assert!(converged >= 3, "{converged} converged");
}

/// A block under a parabola of radius 500 mm, pressed to a half-width of 2 mm on candidates of `stretch` half-widths.
fn long_stretch(stretch: f64, reference: &str) -> String {
    let load = std::f64::consts::PI * 4.0 * 210e3 / 0.91 / (4.0 * 500.0);
    let [size, per] = [2.5 * 2.0 * stretch, 2.0 * stretch / 32.0];
    format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [0, {size}], y = [0, {size}], contact = \"bottom\" }} }}\n\
         supports = [{{ at = \"left\", component = \"x\" }}]\n\
         loads = [{{ traction = {{ at = \"far\", value = [0, {}] }} }}]\n\
         [contact]\nfirst = \"block\"\ngap = {{ parabola = 500 }}\nstretch = {}\n{reference}\
         [mesh]\nelements = 4\nper = {}\n",
        -load / (2.0 * size),
        2.0 * stretch,
        4.0 * per,
    )
}

#[test]
fn candidates_a_hundred_times_too_long_are_right_where_they_are_called_converged() {
    for stretch in [1.5, 20.0, 50.0, 100.0, 150.0] {
        let discretisation = parsed(&long_stretch(stretch, ""));
        converged_are_right(&discretisation, &all(), Change::NONE, &format!("stretch {stretch} a"));
        let kinematic = Run::of(&discretisation, &Formulation::verification()).expect("solved");
        assert!(
            kinematic.solution.converged() && notes::of(&kinematic, 0).iter().all(|note| !note.contains("no contact"))
        );
    }
}

#[test]
fn reference_values_change_where_an_iteration_starts_and_not_what_is_converged() {
    for reference in
        ["", "[reference]\npressure = 1e7\n", "[reference]\npressure = 10\n", "[reference]\nlength = 300\n"]
    {
        let discretisation = parsed(&long_stretch(2.0, reference));
        let converged = converged_are_right(&discretisation, &all(), Change::NONE, reference);
        assert!(converged >= 3, "{reference}: {converged}");
    }
}

#[test]
fn weaker_load_is_judged_on_its_own_scale() {
    let discretisation = parsed(&text_of("roller-between-plates.toml"));
    // Of line and layer elements on meshes that do not match, pressures are not unique to 1e-8.
    let node: Vec<Formulation> = all().into_iter().filter(|formulation| formulation.element == Element::Node).collect();
    for load in [1.0, 1e-2, 1e-4] {
        converged_are_right(&discretisation, &node, Change { load, ..Change::NONE }, &format!("load {load}"));
    }
}

#[test]
fn stiff_starts_of_the_papers_sweep_are_right_where_they_are_called_converged() {
    let cylinder = meshed(Cylinder::default().scene(), 4);
    let pin = meshed(PinRod::default().scene(), 4);
    for (place, discretisation) in [("cylinder", cylinder), ("pin–rod", pin)] {
        for element in Element::ALL {
            let stiff = [1e-3, 1.0, 3162.0, 1e5]
                .map(|stiffness| Formulation { stiffness, ..Formulation::new(element, Iteration::Varying) });
            converged_are_right(&discretisation, &stiff, Change::NONE, place);
        }
    }
}

#[test]
fn penalty_tells_what_its_springs_cost() {
    let discretisation = meshed(Cylinder::default().scene(), 8);
    let with = |stiffness: f64| {
        let (element, rule) = (Element::Node, StiffnessRule::Penalty);
        let formulation = Formulation { stiffness, rule, ..Formulation::new(element, Iteration::Kinematic) };
        let run = Run::of(&discretisation, &formulation).expect("solved");
        assert!(run.solution.converged());
        (run.contacts[0].penalty.expect("told"), run)
    };
    let exact = Run::of(&discretisation, &Formulation::verification().tolerance(1e-9)).expect("solved");
    for stiffness in [0.3, 30.0, 3e4] {
        let (told, run) = with(stiffness);
        let error = |of: fn(&Run) -> f64| of(&run) / of(&exact) - 1.0;
        assert_abs_diff_eq!(told.peak, error(|run| run.measures().peak.pressure), epsilon = 1e-6);
        assert_abs_diff_eq!(told.half_width, error(|run| run.measures().second_moment_width), epsilon = 1e-6);
        assert_eq!(run.penalty_error() > 0.1, stiffness < 1.0);
    }
    let penalty = ["solve", "cylinder", "--rule", "penalty", "--algorithm", "kinematic", "--stiffness", "0.3"];
    let (sound, json, _) = contact_vv(&[&penalty[..], &["--json", "-"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert!(
        sound && json["contacts"][0]["penalty_error"]["half_width"].as_f64().is_some_and(|error| error > 0.5),
        "{json}"
    );
    let (_, table, _) = contact_vv(&[&penalty[..], &["--element", "node"]].concat());
    assert!(table.contains("springs of the penalty cost -36.58 % of the peak"), "{table}");
}

#[test]
fn kinematic_load_from_the_softest_springs_converges_or_says_that_they_are_lost() {
    let discretisation = meshed(Cylinder::default().scene(), 6);
    for decade in -12..=6 {
        let formulation =
            Formulation { stiffness: 10f64.powi(decade), ..Formulation::new(Element::Node, Iteration::Kinematic) };
        match Run::of(&discretisation, &formulation) {
            Ok(run) => assert!(run.solution.converged(), "1e{decade}: {}", run.solution.outcome),
            Err(error) => {
                let text = error.to_string();
                assert!(
                    decade <= -10 && text.contains("lost in the round-off") && text.contains("raise `stiffness`"),
                    "1e{decade}: {text}"
                );
            }
        }
    }
}

#[test]
fn round_off_is_named_where_it_is_the_limit_and_not_the_iterations() {
    // Pressures of line elements on meshes that do not match hang on penetrations of the size of rounding.
    let discretisation = parsed(&text_of("three-rings.toml"));
    let formulation = Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-12);
    let run = Run::of(&discretisation, &formulation).expect("solved");
    assert_eq!(run.solution.outcome, Outcome::Stalled);
    assert!(run.solution.work.iterations < 500 && run.iteration_error() < 1e-4, "{:e}", run.iteration_error());
    let line = ["--element", "line", "--algorithm", "kinematic", "--tolerance", "1e-12"];
    let (sound, _, error) = contact_vv(&[&["solve", &scene("three-rings")][..], &line].concat());
    assert!(!sound && error.contains("as was tried") && error.contains("--tolerance 1e-12"), "{error}");
}

#[test]
fn more_steps_are_asked_for_with_an_option_that_is_offered() {
    let slow = ["solve", "cylinder", "--element", "line", "--algorithm", "constant", "--resolution", "4"];
    // Another command converges; where an accuracy chose the mesh none is tried.
    let (sound, _, error) = contact_vv(&[&slow[..], &["--max-iterations", "3"]].concat());
    assert!(!sound && error.contains("as was tried") && !error.contains("--max-iterations"), "{error}");
    let path = scene("cylinder-to-accuracy");
    let (sound, _, error) = contact_vv(&["solve", &path, "--accuracy", "5 %", "--max-iterations", "1"]);
    assert!(!sound && error.contains("--max-iterations"), "{error}");
    let (_, json, _) = contact_vv(&[&slow[..], &["--max-iterations", "3", "--json", "-"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!((json["steps"].as_u64(), json["outcome"].as_str()), (Some(3), Some("not converged")));
}

#[test]
fn energy_error_of_every_run_is_below_its_bound() {
    let discretisation = meshed(PinRod::default().scene(), 6);
    for formulation in all() {
        for max_iterations in [1, 2, 5, 20, 500] {
            let mut formulation = formulation.clone();
            formulation.settings.max_iterations = max_iterations;
            let run = Run::of(&discretisation, &formulation).expect("solved");
            let energy = run.solution.energy.expect("it presses");
            // Round-off of both, over what the contact stores.
            assert!(energy.error <= energy.bound * (1.0 + 1e-9) + 1e-12, "{}: {energy:?}", formulation.name());
        }
    }
}

#[test]
fn error_told_is_that_against_the_solution_told() {
    let discretisation = meshed(Cylinder::default().scene(), 6);
    let mut formulation = Formulation::new(Element::Line, Iteration::Varying);
    formulation.settings.max_iterations = 4;
    let run = Run::of(&discretisation, &formulation).expect("solved");
    let exact = Run::of(&discretisation, &Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-9))
        .expect("solved");
    let peak = (run.measures().peak.pressure / exact.measures().peak.pressure - 1.0).abs();
    assert!(peak > 1e-3);
    assert_relative_eq!(run.solution.error().peak, peak, max_relative = 1e-5);
}
