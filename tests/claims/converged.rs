//! What is called converged is the discrete solution, whatever stretch, reference, load or stiffness the user guessed.

use approx::assert_abs_diff_eq;
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::library::{Cylinder, PinRod};
use contact_vv::case::notes;
use contact_vv::mesh::Order;
use contact_vv::scene::Scene;
use contact_vv::solution::Outcome;
use contact_vv::solve::{Change, Discretisation, Element, Formulation, Iteration, Origin, Run};

use crate::outputs::{contact_vv, scene};
use crate::scene_file::text_of;
use crate::workbench::{block_text, parsed, resolution};

fn drawn(text: &str) -> Discretisation {
    let file = parsed(text);
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

/// A block under a parabola of radius 500 mm, pressed to a half-width of 2 mm on candidates of `stretch` half-widths.
fn long_stretch(stretch: f64, reference: &str) -> String {
    let load = std::f64::consts::PI * 4.0 * 210e3 / 0.91 / (4.0 * 500.0);
    let [size, per] = [2.5 * 2.0 * stretch, 2.0 * stretch / 8.0];
    let traction = format!("traction = {{ at = \"far\", value = [0, {}] }}", -load / (2.0 * size));
    let contact = format!("gap = {{ parabola = 500 }}\nstretch = {}\n{reference}", 2.0 * stretch);
    block_text([0.0, size], size, &traction, &contact) + &format!("[mesh]\nelements = 4\nper = {per}\n")
}

#[test]
fn what_is_called_converged_is_right_whatever_load_stretch_reference_and_start() {
    let light = text_of("cylinder-on-block.toml").replace("[0, -57.5]", "[0, -2]").replace("tolerance = 1e-6\n", "");
    let references = ["", "pressure = 1e7", "pressure = 10", "length = 300"].map(|value| match value {
        "" => ("no reference".to_string(), long_stretch(2.0, ""), 3),
        value => (value.to_string(), long_stretch(2.0, &format!("[reference]\n{value}\n")), 3),
    });
    let stretches = [1.5, 20.0, 50.0, 100.0, 150.0].map(|k| (format!("stretch {k} a"), long_stretch(k, ""), 0));
    for (place, text, least) in [("load 2".into(), light, 3)].into_iter().chain(references).chain(stretches) {
        let discretisation = drawn(&text);
        let converged = converged_are_right(&discretisation, &all(), Change::NONE, &place);
        assert!(converged >= least, "{place}: {converged} converged");
        let kinematic = Run::of(&discretisation, &Formulation::verification()).expect("solved");
        assert!(kinematic.solution.converged(), "{place}");
        assert!(notes::of(&kinematic, 0).iter().all(|note| !note.contains("no contact")), "{place}");
    }
    let weak = drawn(&text_of("roller-between-plates.toml"));
    // Of line and layer elements on meshes that do not match, pressures are not unique to 1e-8.
    let node: Vec<Formulation> = all().into_iter().filter(|formulation| formulation.element == Element::Node).collect();
    for load in [1.0, 1e-2, 1e-4] {
        converged_are_right(&weak, &node, Change { load, ..Change::NONE }, &format!("load {load}"));
    }
    for scene in [Cylinder::default().scene(), PinRod::default().scene()] {
        let discretisation = meshed(scene, 4);
        for element in Element::ALL {
            let stiff = [1e-3, 1.0, 3162.0, 1e5]
                .map(|stiffness| Formulation { stiffness, ..Formulation::new(element, Iteration::Varying) });
            converged_are_right(&discretisation, &stiff, Change::NONE, &discretisation.scene.name);
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
    let discretisation = drawn(&text_of("three-rings.toml"));
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
