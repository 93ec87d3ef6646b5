//! The paper's statements, judged from the numbers of the studies: no verdict and no condition here is typed.
//!
//! * [`found`] — look-ups in what was found.
//! * `statement` — what is said of each.
//! * `agreement` — what is found is right, whatever the formulation.
//! * `readings` — what is said of iterations, over a designed set of readings of the paper.
//! * `work` — what it costs.

mod agreement;
pub mod found;
pub mod readings;
mod statement;
mod work;

use crate::study::Finding;

use found::Findings;

pub use statement::{Judgement, Statement};

/// All statements, judged.
pub fn judge(findings: &[Finding]) -> Vec<Statement> {
    let f = Findings(findings);
    let mut all = vec![agreement::of_all(&f)];
    all.extend(readings::of_all(&f));
    all.extend([
        agreement::no_difference(&f),
        agreement::top_quarter(&f),
        work::condensation_pays(&f),
        agreement::gaertner(&f),
    ]);
    all
}
