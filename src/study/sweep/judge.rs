//! Whatever the initial stiffness, what converges shall be the discrete solution of its element.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::ReferenceKind;
use crate::solve::Settings;
use crate::study::sweep::run::{Numbers, Saved};

/// Error of a peak or a half-width that an iteration within its tolerance may have, in tolerances.
const SLACK: f64 = 3.0;

/// The largest error of what converged; where nothing did there is nothing to judge, and the check says so. What the program takes
/// converges.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let (error, tolerance, starts) = match numbers {
        Numbers::Sweep(sweep) => (
            sweep.error,
            sweep.formulation.settings.tolerance,
            format!("{} starts converge", sweep.iterations.points.len()),
        ),
        Numbers::Rules(rules) => {
            let errors = || rules.iter().flat_map(|rule| &rule.runs).filter_map(|run| run.error);
            (errors().reduce(larger), Settings::default().tolerance, format!("{} runs converge", errors().count()))
        }
        Numbers::Saved(scene, saved) => {
            let worst = saved.iter().map(|one| one.error).reduce(larger);
            (worst, Settings::default().tolerance, format!("{}, all nine as the program takes them", scene.name()))
        }
    };
    let because = "the iteration error bounds norms of pressure and width; a single number may be off by more, never by this much";
    let quantity = Quantity::at("error of p₀ and a of what converges, from any initial stiffness", starts);
    let check = Check::error(quantity, Reference::own("the discrete solution", 0.0), SLACK * tolerance, because);
    let converging = match numbers {
        Numbers::Saved(scene, saved) => Some(converging(scene.name(), saved)),
        Numbers::Sweep(_) | Numbers::Rules(_) => None,
    };
    let right = match error {
        Some(error) => check.judge(error),
        None => {
            check.not_run(ReferenceKind::SelfConsistency, "the discrete solution", "not run: no start converges".into())
        }
    };
    Ok([right].into_iter().chain(converging).collect())
}

/// That all nine converge as the program takes them.
fn converging(scene: &str, saved: &[Saved]) -> Judged {
    let failing = saved.iter().filter(|one| one.iterations[1].is_none()).count();
    let quantity = Quantity::at("formulation that does not converge as the program takes it", scene);
    let because = "acceleration, κ₀ and tolerance are chosen so that all nine do";
    Check::none(quantity, because).judge(failing as f64)
}
