//! What the springs really do: tension that is cut, the equilibrium of every body, bodies of very different stiffness,
//! bodies that touch.

use std::path::PathBuf;

use approx::assert_relative_eq;
use contact_vv::accuracy::{Barred, Bars, Quantity, bars};
use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::mesh::Resolution;
use contact_vv::scene::Scene;
use contact_vv::solution::{IterationError, Outcome};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

fn path(name: &str) -> PathBuf {
    root().join(format!("tests/data/scenes/{name}.toml"))
}

/// The text of a scene of `tests/data/scenes`.
pub fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The scene with other words in it.
pub fn scene(name: &str, changes: &[[&str; 2]]) -> Case {
    let mut text = text(name);
    for [was, is] in changes {
        assert!(text.contains(was), "{name}: {was}");
        text = text.replace(was, is);
    }
    Case::parse(&path(name), &text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A scene solved on a mesh of so many elements.
pub fn solved_on(scene: Scene, resolution: Resolution, formulation: &Formulation) -> (Discretisation, Run) {
    let discretisation = Discretisation::of(scene, resolution).expect("meshed");
    let run = Run::of(&discretisation, formulation).expect("solved");
    (discretisation, run)
}

/// A case solved on its own mesh.
pub fn solved(case: &Case, formulation: &Formulation) -> (Discretisation, Run) {
    solved_on(case.scene.clone(), case.resolution, formulation)
}

/// What is told of a number of the first contact.
pub fn told_of<'a>(all: &'a [Barred], quantity: &Quantity) -> &'a Barred {
    all.iter().find(|one| (one.contact, &one.quantity) == (0, quantity)).expect("told")
}

/// The run of a case on its own mesh, and its bars.
pub fn barred(case: &Case, formulation: &Formulation) -> (Run, Bars) {
    let (discretisation, run) = solved(case, formulation);
    let bars = bars(&discretisation, &run, &[]).expect("bars");
    (run, bars)
}

/// A case solved on its own mesh by its own formulation.
pub fn solved_as_it_says(case: &Case) -> (Discretisation, Run) {
    solved(case, case.formulation())
}

/// Reaction along y of each body's clamp \[N\].
fn clamps(discretisation: &Discretisation, run: &Run) -> [f64; 2] {
    let reactions = discretisation.reactions(1.0, &run.solution).expect("recovered");
    [0, 1].map(|body| reactions.iter().filter(|one| one.body == body).map(|one| one.force).nth(1).expect("along y"))
}

#[test]
fn leaves_pass_on_what_beam_theory_says_under_any_load() {
    // Two cantilevers of one section that touch at the tip of the shorter one: F = P (3 L₂ − L₁)/(4 L₁).
    for load in [3.0, 300.0] {
        let case = scene("leaf-spring", &[["force = [0, 300]", &format!("force = [0, {load}]")]]);
        let force = load * (3.0 * 300.0 - 200.0) / (4.0 * 200.0);
        for (element, algorithm) in [(Element::Node, Iteration::Kinematic), (Element::Line, Iteration::Kinematic)] {
            let (discretisation, run) = solved(&case, &Formulation::new(element, algorithm));
            assert!(run.solution.converged(), "{element:?}, {load} N: {}", run.solution.outcome);
            let [upper, lower] = clamps(&discretisation, &run);
            assert_relative_eq!(run.transmitted(), force, max_relative = 5e-3);
            assert_relative_eq!(upper, -force, max_relative = 5e-3);
            assert_relative_eq!(lower, force - load, epsilon = 5e-3 * force);
            assert!(run.imbalance() <= 1e-7, "{element:?}, {load} N: {}", run.imbalance());
        }
    }
}

#[test]
fn iteration_that_is_cut_off_while_a_spring_pulls_is_not_converged() {
    // On the way peak, width and approach are within the tolerance while more than the contact's force is tension,
    // which is cut.
    let case = scene("leaf-spring", &[]);
    let mut formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let (_, whole) = solved(&case, &formulation);
    let pulls = |error: &IterationError| {
        [error.peak, error.width, error.approach].iter().all(|part| *part <= 1e-3) && error.force > 1.0
    };
    let pulled =
        whole.solution.history.iter().position(|iteration| pulls(&iteration.error)).expect("a hard spring pulls");
    formulation.settings.max_iterations = pulled + 1;
    let (_, run) = solved(&case, &formulation);
    assert_eq!(run.solution.outcome, Outcome::Capped);
    assert!(run.imbalance() > 0.1, "{}", run.imbalance());
}

#[test]
fn bodies_a_milliard_times_as_stiff_as_others_converge_to_hertz() {
    for (stiff, soft) in [("young = 210000.0", "young = 1e9"), ("young = 210000.0", "young = 1e3")] {
        let case = scene("stiff-on-soft", &[[stiff, soft]]);
        for algorithm in [Iteration::Varying, Iteration::Constant, Iteration::Kinematic] {
            let (_, run) = solved(&case, &Formulation::new(Element::Node, algorithm));
            assert!(run.solution.converged(), "{soft}, {}: {}", algorithm.name(), run.solution.outcome);
            assert_relative_eq!(run.measures().peak.pressure, 0.01316, max_relative = 1e-2);
            assert_relative_eq!(run.transmitted(), 0.02067097, max_relative = 2e-3);
        }
    }
    // The other way round: what is free is the soft one.
    let other = [["young = 1.0\npoisson", "young = 1e9\npoisson"], ["young = 210000.0", "young = 1.0"]];
    let case = scene("stiff-on-soft", &other);
    let (_, run) = solved(&case, &Formulation::new(Element::Node, Iteration::Kinematic));
    assert!(run.solution.converged(), "{}", run.solution.outcome);
    assert_relative_eq!(run.transmitted(), 0.02067097, max_relative = 2e-3);
}

#[test]
fn body_whose_forces_are_lost_in_round_off_is_out_of_balance_and_not_converged() {
    let case = scene("stiff-on-soft", &[["young = 210000.0", "young = 1e13"]]);
    let (_, run) = solved(&case, &Formulation::new(Element::Node, Iteration::Kinematic));
    // Its iteration is within its tolerance of the condensed problem, which has lost the load.
    assert!(run.solution.error().largest() <= 1e-3, "{:?}", run.solution.error());
    assert!(run.imbalance() > 1e-2, "{}", run.imbalance());
    assert_eq!(run.solution.outcome, Outcome::Stalled);
}

#[test]
fn bodies_that_just_touch_have_no_contact() {
    let case = scene("touching", &[]);
    for element in Element::ALL {
        for algorithm in [Iteration::Constant, Iteration::Kinematic] {
            let (_, run) = solved(&case, &Formulation::new(element, algorithm));
            let name = format!("{}.{}", element.name(), algorithm.name());
            assert!(run.solution.converged(), "{name}: {}", run.solution.outcome);
            assert_eq!(run.contacts[0].open, Some(true), "{name}");
            let none = if algorithm == Iteration::Kinematic { 0.0 } else { 1e-3 * 70e3 * 0.07 };
            assert!(run.transmitted().abs() <= none, "{name}: {}", run.transmitted());
        }
    }
    // A hair nearer they press: F = E A δ/L of both bars, one behind the other.
    let case = scene("touching", &[["value = -0.07", "value = -0.0700001"]]);
    let (_, run) = solved(&case, &Formulation::new(Element::Node, Iteration::Kinematic));
    assert!(run.contacts[0].open == Some(false) && run.transmitted() > 1e-4, "{}", run.transmitted());
}
