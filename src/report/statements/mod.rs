//! The paper's statements, judged from the numbers of the studies: no verdict and no condition here is typed.
//!
//! * [`found`] — look-ups in what was found.
//! * `agreement` — what is found is right, whatever the formulation.
//! * `stiffness` — how far it depends on the initial stiffness.
//! * `work` — what it costs.

mod agreement;
pub mod found;
mod stiffness;
mod work;

use crate::study::Finding;

use found::Findings;

/// How a statement of the paper fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as stated.
    Reproduced,
    /// It holds under the condition given with it.
    UnderCondition,
    /// It does not hold here.
    NotReproduced,
    /// Nothing to judge it by.
    NotJudged,
}

impl std::fmt::Display for Judgement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Reproduced => "reproduced",
            Self::UnderCondition => "reproduced under a stated condition",
            Self::NotReproduced => "not reproduced",
            Self::NotJudged => "not judged",
        })
    }
}

/// A statement of the paper with what was measured.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What the paper says.
    pub text: &'static str,
    /// What was measured.
    pub measured: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// All statements, judged.
pub fn judge(findings: &[Finding]) -> Vec<Statement> {
    let f = Findings(findings);
    vec![
        agreement::of_all(&f),
        stiffness::dependence(&f),
        stiffness::stability(&f),
        stiffness::two_steps(&f),
        agreement::no_difference(&f),
        agreement::top_quarter(&f),
        work::constant_saves(&f),
        work::least(&f),
        stiffness::alike(&f),
        work::condensation_pays(&f),
        agreement::gaertner(&f),
    ]
}

/// Reproduced or not.
fn judged(holds: bool) -> Judgement {
    if holds { Judgement::Reproduced } else { Judgement::NotReproduced }
}
