//! What it costs.

use super::found::{Findings, extremes};
use super::statement::{Statement, judged};
use crate::case::library::{cylinder, pin_rod};
use crate::solve::{Iteration, Run};

/// The paper's two examples.
const CASES: [&str; 2] = [cylinder::NINE, pin_rod::NINE];

/// Condensation pays.
pub fn condensation_pays(f: &Findings) -> Statement {
    let runs: Vec<&Run> = CASES.into_iter().flat_map(|case| f.runs(case)).collect();
    // Without condensation every factorisation would be the sparse one; with it there is one, and dense small ones.
    let gain = |run: &&Run| {
        run.sparse_operations * run.solution.work.factorisations as f64
            / (run.sparse_operations + run.solution.work.operations)
    };
    let single = |run: &&&Run| run.formulation.algorithm == Iteration::Constant;
    let refactoring: Vec<f64> = runs.iter().filter(|run| !single(run)).map(gain).collect();
    let [low, high] = extremes(refactoring.into_iter());
    Statement {
        text: "It pays to iterate on the external dofs alone (substructuring)",
        clause: format!("{low:.1} to {high:.0} times the operations without"),
        measured: format!(
            "operations without over with condensation, where the algorithm factorises at every iteration: {low:.1} to {high:.0}; with constant stiffness one factorisation serves either way"
        ),
        judgement: judged(low > 1.0),
    }
}
