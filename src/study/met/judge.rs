//! What the record must hold: a fixed part solved again is what was recorded, and hardly anything is called met that is not.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::study::met::run::{Numbers, Record};

/// Share of what is called met that may not be so.
const WRONG: f64 = 0.01;
/// Error over what was asked, of what is called met.
const FARTHEST: f64 = 1.5;
/// A recomputed error may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;
/// Errors below this part of the one asked for may differ: they hang on the iteration.
const ITERATED: f64 = 0.01;

/// The checks.
pub fn judge(Numbers { recorded, fresh }: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![as_recorded(recorded, fresh), right(recorded), near(recorded), consistent(recorded)])
}

/// Whether fresh answers are the recorded ones.
fn as_recorded(recorded: &[Record], fresh: &[Record]) -> Judged {
    let moved = fresh.iter().filter(|fresh| !recorded.iter().any(|kept| is_as_recorded(kept, fresh))).count();
    let quantity = Quantity::at("recomputed answer that is not the recorded one", format!("of {}", fresh.len()));
    let record = Reference::own("snapshots/met.csv", 0.0);
    Check::at_most(quantity, record, "mesh, estimate and errors; `met` renews the record").judge(if fresh.is_empty() {
        f64::NAN
    } else {
        moved as f64
    })
}

/// Whether a fresh answer is the recorded one: mesh and verdict always, errors but for the iteration.
pub fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let key = |record: &Record| (record.family, record.number, record.asked.to_bits());
    let found = |record: &Record| (record.met, record.dofs, record.dofs_in_all);
    let alike = |a: f64, b: f64| {
        (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + ITERATED * kept.asked
    };
    key(kept) == key(fresh)
        && found(kept) == found(fresh)
        && alike(kept.estimate, fresh.estimate)
        && alike(kept.peak, fresh.peak)
        && alike(kept.half_width, fresh.half_width)
}

/// What is called met is so, but for a small share.
pub fn right(recorded: &[Record]) -> Judged {
    let met = recorded.iter().filter(|record| record.met).count();
    let wrong = recorded.iter().filter(|record| record.is_falsely_met()).count();
    let quantity = Quantity::at(
        "share of the accuracies called met with a peak or a half-width off by more than was asked",
        format!("{wrong} of {met} called met, {} answers in all", recorded.len()),
    );
    let because = "bars are held by nineteen of twenty and more, and an answer seldom uses all of its own";
    Check::error(quantity, Reference::analytic("closed forms", 0.0), WRONG, because).judge(wrong as f64 / met as f64)
}

/// Nothing that is called met is far from it.
pub fn near(recorded: &[Record]) -> Judged {
    let over = recorded.iter().filter(|record| record.met).map(|record| record.error() / record.asked);
    let quantity = Quantity::at("largest error over what was asked, of what is called met", "peak or half-width");
    let because = "who asks for 1 % may be given 1.5 %, and never twice as much";
    Check::at_most(quantity, Reference::analytic("closed forms", FARTHEST), because)
        .judge(over.reduce(larger).unwrap_or(f64::NAN))
}

/// Nothing is called not met whose estimates are all within what was asked.
pub fn consistent(recorded: &[Record]) -> Judged {
    let wrong = recorded.iter().filter(|record| record.is_contradictory()).count();
    let quantity = Quantity::at(
        "accuracy called not met beside estimates that are all within it",
        format!("of {} answers", recorded.len()),
    );
    let because = "an estimate beyond what was asked is the reason why it is not met";
    Check::at_most(quantity, Reference::own("the estimate", 0.0), because).judge(if recorded.is_empty() {
        f64::NAN
    } else {
        wrong as f64
    })
}
