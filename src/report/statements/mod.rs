//! The paper's statements, judged from the numbers of the studies: no verdict and no condition here is typed.
//!
//! * [`found`] — look-ups in what was found.
//! * `statement` — what is said of each.
//! * `agreement` — what is found is right, whatever the formulation.
//! * `stiffness` — how far it depends on the initial stiffness.
//! * `work` — what it costs.

mod agreement;
pub mod found;
mod statement;
mod stiffness;
mod work;

use crate::study::Finding;

use found::Findings;

pub use statement::{Judgement, Statement};

/// All statements, judged.
pub fn judge(findings: &[Finding]) -> Vec<Statement> {
    let f = Findings(findings);
    vec![
        agreement::of_all(&f),
        stiffness::dependence(&f),
        stiffness::stability(&f),
        stiffness::two_iterations(&f),
        agreement::no_difference(&f),
        agreement::top_quarter(&f),
        work::constant_saves(&f),
        work::least(&f),
        stiffness::alike(&f),
        work::condensation_pays(&f),
        agreement::gaertner(&f),
    ]
}
