//! Where other codes' answers come from, frozen files or the codes themselves, and whether these still say what was frozen.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::live::Live;
use crate::study::differences::{Groups, largest_change};

/// Relative difference from the frozen answer that a live one may have.
const REPRODUCED: f64 = 1e-6;

/// Frozen or live.
#[derive(Clone, Copy, Debug)]
pub enum Answers {
    /// Read from `oracles/frozen`; Rust alone suffices.
    Frozen,
    /// Asked now, and held against the frozen ones as well.
    Live(Live),
}

/// A live answer beside the frozen one.
#[derive(Clone, Debug)]
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
            Self::Live(_) => ", live",
        }
    }
}

/// A live answer is what was frozen; the versions that changed since are named.
pub fn reproduced(name: &str, live: &Reproduced) -> Judged {
    let frozen =
        Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let because = format!("solvers and libraries differ in round-off; {}", live.versions);
    let quantity = Quantity::at("largest relative change of a live answer", name);
    Check::error(quantity, frozen, REPRODUCED, because).judge(live.change)
}
