//! A statement of the paper, and how it fared.

/// How a statement of the paper fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as stated.
    Reproduced,
    /// It holds under this condition, which the paper does not state.
    OnlyIf(String),
    /// It hangs on the rule by which stiffnesses change, which the paper's reference 12 would tell: so it does otherwise.
    Undecidable(String),
    /// It does not hold here.
    NotReproduced,
    /// Nothing to judge it by.
    NotJudged,
}

impl Judgement {
    /// The kind of judgement.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::OnlyIf(_) => "reproduced on a condition",
            Self::Undecidable(_) => "not decidable without [12]",
            Self::NotReproduced => "not reproduced",
            Self::NotJudged => "not judged",
        }
    }

    /// The judgement without what would decide it.
    pub fn brief(&self) -> String {
        match self {
            Self::OnlyIf(condition) => format!("only if: {condition}"),
            _ => self.word().into(),
        }
    }
}

impl std::fmt::Display for Judgement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Reproduced => f.write_str("reproduced"),
            Self::OnlyIf(condition) => write!(f, "reproduced only if: {condition}"),
            Self::Undecidable(condition) => write!(f, "not decidable without [12]: it {condition}"),
            Self::NotReproduced => f.write_str("not reproduced"),
            Self::NotJudged => f.write_str("not judged"),
        }
    }
}

/// A statement of the paper with what was measured.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What the paper says.
    pub text: &'static str,
    /// The one number that tells most.
    pub clause: String,
    /// What was measured.
    pub measured: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// Reproduced or not.
pub fn judged(holds: bool) -> Judgement {
    if holds { Judgement::Reproduced } else { Judgement::NotReproduced }
}
