//! A row per run of a case: how it ended, and the work it took.

use serde::{Deserialize, Serialize};

use crate::solve::Run;
use crate::study::{Finding, Numbers};

/// A run as the record has it; of one that did not converge only how it ended.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct RunRow {
    /// The case.
    pub case: String,
    /// The trial, mostly a formulation.
    pub trial: String,
    /// How it ended.
    pub outcome: String,
    /// Iterations over all load increments.
    pub iterations: Option<usize>,
    /// Factorisations of the dense system.
    pub factorisations: Option<usize>,
    /// Terms of rank one by which a factor was updated instead.
    pub updates: Option<usize>,
    /// Back-substitutions with such a factor.
    pub back_substitutions: Option<usize>,
    /// Degrees of freedom of the mesh.
    pub dofs: usize,
    /// Of these the retained ones.
    pub retained: usize,
}

impl RunRow {
    fn of(Finding { case, name, .. }: &Finding, run: &Run) -> Self {
        let counted = |count: usize| run.solution.converged().then_some(count);
        let work = &run.solution.work;
        Self {
            case: case.clone(),
            trial: name.clone(),
            outcome: run.solution.outcome.to_string(),
            iterations: counted(work.iterations),
            factorisations: counted(work.factorisations),
            updates: counted(work.updates),
            back_substitutions: counted(work.back_substitutions),
            dofs: run.dofs,
            retained: run.retained,
        }
    }
}

/// The rows of all runs of cases, sorted.
pub fn rows(findings: &[Finding]) -> Vec<RunRow> {
    let of = |finding: &Finding| match &finding.numbers {
        Numbers::Cases(numbers) => Some(RunRow::of(finding, &numbers.run)),
        _ => None,
    };
    let mut rows: Vec<RunRow> = findings.iter().filter_map(of).collect();
    rows.sort();
    rows
}
