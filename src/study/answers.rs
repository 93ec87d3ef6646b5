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
pub fn reproduced(name: &str, now: &Groups, kept: &Groups, versions: &str) -> Judged {
    let frozen =
        Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let because = format!("solvers and libraries differ in round-off; {versions}");
    let quantity = Quantity::at("largest relative change of a live answer", name);
    Check::error(quantity, frozen, REPRODUCED, because).judge(largest_change(now, kept))
}
