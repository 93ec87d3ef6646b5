//! Where the other codes' answers come from: frozen files, or the codes themselves.

use serde::Serialize;

use crate::error::Error;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, file};
#[cfg(feature = "python")]
use crate::oracle::cross_code::live;
use crate::oracle::cross_code::{Code, DiscreteAnswer};
use crate::study::cross_code::differences::{Groups, largest_change};
use crate::study::cross_code::twin::Twin;

/// Frozen or live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answers {
    /// Read from `oracles/frozen`; Rust alone suffices.
    Frozen,
    /// Asked now, and held against the frozen ones as well.
    #[cfg(feature = "python")]
    Live,
}

/// A code's answer to our discrete problem.
pub struct Answered {
    /// In short.
    pub digest: Digest,
    /// In full; none where it was not asked.
    pub whole: Option<DiscreteAnswer>,
    /// Whether it is what was frozen; none where it was not asked.
    pub reproduced: Option<Reproduced>,
}

/// A live answer beside the frozen one.
#[derive(Clone, Debug, Serialize)]
pub struct Reproduced {
    /// Largest relative change of a number.
    pub change: f64,
    /// Versions that changed since.
    pub versions: String,
}

impl Reproduced {
    /// What changed, and the versions that changed since.
    pub fn of(now: &Groups, kept: &Groups, versions: String) -> Self {
        Self { change: largest_change(now, kept), versions }
    }
}

impl Answers {
    /// What tells the trials apart: nothing for frozen answers, which the page shows.
    pub fn suffix(self) -> &'static str {
        match self {
            Self::Frozen => "",
            #[cfg(feature = "python")]
            Self::Live => ", live",
        }
    }

    /// A code's answer to our discrete problem.
    pub fn discrete(self, code: Code, twin: &Twin) -> Result<Answered, Error> {
        let name = &twin.problem.name;
        let frozen = Frozen::read(code)?;
        let kept = frozen.discrete.get(name).cloned().ok_or_else(|| absent(code, name))?;
        let nodes = twin.problem.points.len();
        if kept.nodes != nodes {
            let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
            return Err(Error::refused(&file(code), name, found, REFREEZE));
        }
        match self {
            Self::Frozen => Ok(Answered { digest: kept, whole: None, reproduced: None }),
            #[cfg(feature = "python")]
            Self::Live => {
                let answer = live::discrete(code, &twin.problem)?;
                let digest = twin.digest_of_other(&answer);
                let changed = frozen.changed_versions(&live::versions()?);
                let reproduced = Some(Reproduced::of(&digest.numbers(), &kept.numbers(), changed));
                Ok(Answered { digest, whole: Some(answer), reproduced })
            }
        }
    }
}

fn absent(code: Code, name: &str) -> Error {
    Error::missing_key(&file(code), name, "the frozen results", REFREEZE)
}
