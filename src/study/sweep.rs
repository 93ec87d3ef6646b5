//! Steps against initial stiffness (the paper's Fig. 11), and the condition of its "two steps".

use crate::case::library::Cylinder;
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::Resolution;
use crate::solution::Solution;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::{Finding, Series, Table, Trial};

/// Start stiffnesses: half decades from 1e-3 to 1e6.
fn stiffnesses() -> Vec<f64> {
    (-6..=12).map(|k| 10f64.powf(0.5 * f64::from(k))).collect()
}

/// Scenes of the sweep and their elements per half-width or per 10 mm of arc.
pub const SCENES: [(&str, usize); 2] = [("cylinder", 8), ("pin-rod", 12)];

/// Name of the study of a scene.
pub fn study(scene: &str) -> String {
    format!("stiffness sweep, {scene}")
}

/// Name of the study whose candidates end at the contact edge.
pub const AT_THE_EDGE: &str = "stiffness sweep, candidates end at the edge";

/// Name of the study of the rules.
pub const RULES: &str = "rules, cylinder";

/// Error of a peak or a half-width that an iteration within its tolerance may have, in tolerances.
pub const SLACK: f64 = 3.0;

/// Trials of the sweeps.
pub fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for (scene, elements) in SCENES {
        for formulation in Formulation::nine() {
            trials.push(Trial::new(study(scene), formulation.name(), move || {
                let problem = problem::problem(scene, None)?;
                let resolution = Resolution { elements, ..problem.resolution };
                sweep(&study(scene), &problem, resolution, &formulation)
            }));
        }
    }
    trials.push(Trial::new(RULES, "all rules", rules));
    trials.push(Trial::new(AT_THE_EDGE, "node.kinematic", || {
        let parts = problem::cylinder(Cylinder { stretch: 1.0, ..Default::default() });
        let problem = Problem::new("cylinder", "cylinder, candidates end at a", parts);
        let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
        sweep(AT_THE_EDGE, &problem, Resolution { elements: 8, ..problem.resolution }, &formulation)
    }));
    trials
}

/// Every rule of every algorithm on the cylinder, from three start stiffnesses: outcome, and steps where it converged.
fn rules() -> Result<Finding, Error> {
    let starts = [0.1, 1.0, 10.0];
    let problem = problem::problem("cylinder", None)?;
    let discretisation = Discretisation::of(problem.scene, Resolution { elements: SCENES[0].1, ..problem.resolution })?;
    let mut rows = Vec::new();
    for algorithm in Iteration::ALL {
        for &rule in algorithm.rules() {
            let mut row = vec![algorithm.name().to_string(), rule.name().to_string()];
            for stiffness in starts {
                let formulation = Formulation { rule, stiffness, ..Formulation::new(Element::Node, algorithm) };
                row.push(match discretisation.solve(&formulation) {
                    // Soft springs of a penalty spread the contact beyond any candidates.
                    Err(Error::ContactBeyondCandidates { .. } | Error::ContactCutShort { .. }) => {
                        "refused: contact beyond the candidates".into()
                    }
                    solution => ended(&solution?),
                });
            }
            rows.push(row);
        }
    }
    let head = ["algorithm", "rule"].map(String::from).into_iter().chain(starts.map(|k| format!("κ₀ = {k}")));
    let title =
        "The rules of each algorithm on the cylinder, node element; `penalty` converges to its own springs' law".into();
    Ok(Finding { tables: vec![Table { title, head: head.collect(), rows }], ..Default::default() })
}

/// How a solution ended, with its steps where it converged.
fn ended(solution: &Solution) -> String {
    let steps = format!(", {} steps", solution.work.steps);
    format!("{}{}", solution.outcome, if solution.converged() { &steps } else { "" })
}

/// Runs a formulation from every start stiffness; what converges must be the discrete solution of its element.
fn sweep(
    picture: &str,
    problem: &Problem,
    resolution: Resolution,
    formulation: &Formulation,
) -> Result<Finding, Error> {
    let discretisation = Discretisation::of(problem.scene.clone(), resolution)?;
    let (mut points, mut failed) = (Vec::new(), Vec::new());
    let mut errors = Vec::new();
    for stiffness in stiffnesses() {
        let run = Run::of(&discretisation, &Formulation { stiffness, ..formulation.clone() })?;
        if !run.solution.converged() {
            failed.push(stiffness);
            continue;
        }
        points.push([stiffness, run.solution.work.steps as f64]);
        errors.push(run.iteration_error());
    }
    // Where nothing converges within the limit of steps there is nothing to judge: the chart shows it.
    let check = errors.into_iter().reduce(larger).map(|largest| {
        Judged::norm(
            "Whatever the start stiffness, what converges shall be the discrete solution of its element",
            "largest error of p₀ and a",
            largest,
            Reference::own("active set", 0.0),
            SLACK * formulation.settings.tolerance,
            "the iteration error bounds norms of pressure and width; a single number may be off by more, never by this much",
        )
    });
    let series = Series { picture: picture.into(), label: formulation.name(), points, failed };
    Ok(Finding { checks: check.into_iter().collect(), series: vec![series], ..Default::default() })
}
