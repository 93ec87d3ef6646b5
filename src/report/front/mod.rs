//! The front page: one computed answer to each question, the paper's statements, the verdicts, and the way to every page.
//!
//! * `right` — is it right, and against what; what no measurement has seen.
//! * [`nearness`] — how much of their tolerances the checks use.
//! * `cost` — what accuracy costs.
//! * `advice` — where methods fail, and what to use.
//! * `summary` — statements, verdicts, what was never compared, and the index.

mod advice;
mod cost;
pub mod nearness;
mod right;
mod summary;

use crate::report::{links, symbols};
use crate::study::Finding;

pub use right::{against, right};

/// The page.
pub fn page(findings: &[Finding]) -> String {
    let body = [
        format!("## Is it right?\n\n{}\n", right(findings)),
        format!("## Against what?\n\n{}\n", against(findings)),
        format!("## What does accuracy cost?\n\n{}\n", cost::cost()),
        format!("## Where does it fail, and what should I use?\n\n{}\n", advice::advice(findings)),
        format!("## The paper's statements\n\n{}\n", summary::statements(findings)),
        format!("## Verdicts\n\n{}\n", summary::verdicts(findings, advice::recommended(findings))),
        format!("## What was never compared\n\n{}\n", summary::never_compared(findings)),
        format!("## All pages\n\n{}\n", summary::index(findings)),
    ]
    .concat();
    let symbols = links::to_page("symbols", symbols::FILE);
    format!(
        "# Validation report\n\nThree contact elements × three iterations for frictionless elastic contact in 2D (Égert 1999). \
         Numbers, verdicts and conditions are computed, and with them the sentences that have any; typed are definitions, sources, hypotheses, \
         the reasons of checks, and what is out of scope. Do not edit. What letters stand for: {symbols}.\n\n{}\n",
        body.trim_end()
    )
}
