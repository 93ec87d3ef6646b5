//! What to do where an iteration does not converge.

use crate::case::Case;
use crate::cli::solve::Arguments;
use crate::cli::solve::found::Found;
use crate::markdown;
use crate::solution::Outcome;
use crate::solve::{Element, Formulation, Iteration, Run};

/// The command that does converge on this mesh to the same tolerance, nearest to what was asked: it was tried here.
/// None where none of those tried does.
pub fn converging(arguments: &Arguments, Found { problem, discretisation, run, .. }: &Found) -> Option<String> {
    let own = problem.formulation();
    let Formulation { element, algorithm, .. } = run.formulation;
    let tolerance = run.formulation.settings.tolerance;
    let (node, kinematic) = (Element::Node, Iteration::Kinematic);
    let nearest = [(element, algorithm), (element, kinematic), (node, algorithm), (node, kinematic)];
    let converges = |other: &Arguments| {
        let formulation = other.formulation(own.clone());
        let runs = || Run::of(discretisation, &formulation).is_ok_and(|run| run.solution.converged());
        formulation != run.formulation && formulation.validate(&discretisation.scene).is_ok() && runs()
    };
    let typed = |(element, algorithm)| {
        let bare = arguments.by(element, algorithm, None);
        let is_same = bare.formulation(own.clone()).settings.tolerance <= tolerance;
        if is_same { bare } else { arguments.by(element, algorithm, Some(tolerance)) }
    };
    let found = nearest.into_iter().map(typed).find(converges)?;
    Some(format!("this converges on the same mesh, as was tried: {}", found.typed()))
}

/// What to say of a body that is out of balance although its contact has converged.
pub fn unbalanced(problem: &Case, run: &Run) -> Option<String> {
    let worst = run.equilibrium.iter().max_by(|a, b| a.largest().total_cmp(&b.largest()))?;
    let within = run.solution.error().largest() <= run.formulation.settings.tolerance;
    (run.solution.outcome == Outcome::Stalled && within).then(|| {
        format!(
            "loads, contact and reactions of `{}` are out of balance by {}: its stiffness, or that of a body it \
            touches, is so large, or its cells so long and thin, that round-off takes the forces; try --fitted, make \
            such a body rigid, or fix it",
            problem.scene.bodies[worst.body].name,
            markdown::error(worst.largest())
        )
    })
}

/// What to do where an iteration did not converge.
pub fn remedy(run: &Run) -> Option<&'static str> {
    match run.solution.outcome {
        Outcome::Converged => None,
        Outcome::Stalled => Some(
            "nothing changes any more, for round-off or because springs are at their limit: ask for a larger \
            --tolerance, or choose --element node with --algorithm kinematic",
        ),
        Outcome::Cycling { .. } => {
            Some("more iterations would repeat: choose another --stiffness, or --algorithm kinematic")
        }
        Outcome::Stopped => Some("stop by --criterion error, or ask this one for a smaller --tolerance"),
        Outcome::Diverged => Some("choose another --stiffness, or --algorithm kinematic"),
        Outcome::Capped => {
            Some("allow more with --max-iterations, choose another --stiffness, or --algorithm kinematic")
        }
    }
}
