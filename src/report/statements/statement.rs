//! A statement of the paper, and how it fared.

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

/// Reproduced or not.
pub fn judged(holds: bool) -> Judgement {
    if holds { Judgement::Reproduced } else { Judgement::NotReproduced }
}
