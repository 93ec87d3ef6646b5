//! How a run ended is told with what it cost or what to do; that what is called converged is right is surveyed.

use approx::assert_abs_diff_eq;
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::library::Cylinder;
use contact_vv::mesh::Order;
use contact_vv::solution::Outcome;
use contact_vv::solve::{Element, Formulation, Iteration, Run};

use crate::balance::solved;
use crate::outputs::{contact_vv, scene};
use crate::scene_file::case;
use crate::workbench::meshed;

#[test]
fn penalty_tells_what_its_springs_cost() {
    let discretisation = meshed(Cylinder::default().scene(), 8, Order::Quadratic);
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
    let (_, table, _) = contact_vv(&[&penalty[..], &["--element", "node", "--all"]].concat());
    assert!(table.contains("springs of the penalty cost -36.58 % of the peak"), "{table}");
}

#[test]
fn round_off_is_named_where_it_is_the_limit_and_not_the_iterations() {
    // Pressures of line elements on meshes that do not match hang on penetrations of the size of rounding.
    let formulation = Formulation::new(Element::Line, Iteration::Kinematic).tolerance(1e-12);
    let (_, run) = solved(&case("three-rings"), &formulation);
    assert_eq!(run.solution.outcome, Outcome::Stalled);
    assert!(run.solution.work.iterations < 500 && run.iteration_error() < 1e-4, "{:e}", run.iteration_error());
    let line = ["--element", "line", "--algorithm", "kinematic", "--tolerance", "1e-12"];
    let (sound, _, error) = contact_vv(&[&["solve", &scene("three-rings")][..], &line].concat());
    assert!(!sound && error.contains("as was tried") && error.contains("--tolerance 1e-12"), "{error}");
}

#[test]
fn more_steps_are_asked_for_with_an_option_that_is_offered() {
    let slow = ["solve", "cylinder", "--element", "line", "--algorithm", "constant", "--resolution", "4"];
    // Where an accuracy chose the mesh no other command is tried.
    let path = scene("cylinder-to-accuracy");
    let (sound, _, error) = contact_vv(&["solve", &path, "--accuracy", "5 %", "--max-iterations", "1"]);
    assert!(!sound && error.contains("--max-iterations"), "{error}");
    let (_, json, _) = contact_vv(&[&slow[..], &["--max-iterations", "3", "--json", "-"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!((json["steps"].as_u64(), json["outcome"].as_str()), (Some(3), Some("not converged")));
}
