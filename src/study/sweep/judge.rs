//! Whatever the initial stiffness, what converges shall be the discrete solution of its element.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::ReferenceKind;
use crate::solve::Settings;
use crate::study::sweep::run::Numbers;

/// Error of a peak or a half-width that an iteration within its tolerance may have, in tolerances.
const SLACK: f64 = 3.0;

/// The largest error of what converged; where nothing did there is nothing to judge, and the check says so.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let (error, tolerance, starts) = match numbers {
        Numbers::Sweep(sweep) => {
            (sweep.error, sweep.formulation.settings.tolerance, format!("{} starts converge", sweep.iterations.points.len()))
        }
        Numbers::Rules(rules) => {
            let errors = || rules.iter().flat_map(|rule| &rule.runs).filter_map(|run| run.error);
            (errors().reduce(larger), Settings::default().tolerance, format!("{} runs converge", errors().count()))
        }
    };
    let because =
        "the iteration error bounds norms of pressure and width; a single number may be off by more, never by this much";
    let quantity = Quantity::at("error of p₀ and a of what converges, from any initial stiffness", starts);
    let check = Check::error(quantity, Reference::own("the discrete solution", 0.0), SLACK * tolerance, because);
    Ok(vec![match error {
        Some(error) => check.judge(error),
        None => {
            check.not_run(ReferenceKind::SelfConsistency, "the discrete solution", "not run: no start converges".into())
        }
    }])
}
