//! What came out of a trial of the cures.

use serde::Serialize;

use crate::error::Error;
use crate::solve::Element;
use crate::study::cures::nested::Nested;
use crate::study::cures::record::{self, Measured, Runs};
use crate::study::cures::rules::Rule;

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// From which starts an element converges.
    Reach(Reach),
    /// Every rule from two starts.
    Rules(Vec<Rule>),
    /// Nested starts on a scene.
    Nested(Nested),
}

/// The three accelerations of an element, none first: judged as measured now, shown as recorded.
#[derive(Clone, Debug, Serialize)]
pub struct Reach {
    /// As measured now.
    pub now: Vec<Measured>,
    /// As recorded.
    pub recorded: Vec<Runs>,
}

impl Reach {
    /// Of an element.
    pub(super) fn of(element: Element) -> Result<Self, Error> {
        Ok(Self { now: record::measure(element)?, recorded: record::read(element)? })
    }
}
