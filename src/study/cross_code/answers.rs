//! Another code's answer to our discrete problem.

use crate::error::Error;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, file};
#[cfg(feature = "python")]
use crate::oracle::cross_code::live;
use crate::oracle::cross_code::{Code, DiscreteAnswer};
use crate::study::answers::{Answers, Reproduced};
use crate::study::cross_code::twin::Twin;

/// A code's answer to our discrete problem.
pub struct Answered {
    /// In short.
    pub digest: Digest,
    /// In full; none where it was not asked.
    pub whole: Option<DiscreteAnswer>,
    /// Whether it is what was frozen; none where it was not asked.
    pub reproduced: Option<Reproduced>,
}

/// A code's answer to our discrete problem.
pub fn answered(answers: Answers, code: Code, twin: &Twin) -> Result<Answered, Error> {
    let name = &twin.problem.name;
    let frozen = Frozen::read(code)?;
    let kept = frozen.discrete.get(name).cloned().ok_or_else(|| absent(code, name))?;
    let nodes = twin.problem.points.len();
    if kept.nodes != nodes {
        let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
        return Err(Error::refused(&file(code), name, found, REFREEZE));
    }
    match answers {
        Answers::Frozen => Ok(Answered { digest: kept, whole: None, reproduced: None }),
        #[cfg(feature = "python")]
        Answers::Live => {
            let answer = live::discrete(code, &twin.problem)?;
            let digest = twin.digest_of_other(&answer);
            let changed = frozen.changed_versions(&live::versions()?);
            let reproduced = Some(Reproduced::of(&digest.numbers(), &kept.numbers(), changed));
            Ok(Answered { digest, whole: Some(answer), reproduced })
        }
    }
}

fn absent(code: Code, name: &str) -> Error {
    Error::missing_key(&file(code), name, "the frozen results", REFREEZE)
}
