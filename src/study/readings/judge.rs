//! What the record must hold: every site, and a fixed part run again as it was.

use std::collections::HashSet;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::readings::axes::starts;
use crate::study::readings::course::{Record, Site};
use crate::study::readings::run::Numbers;

/// Iterations may differ by this share, and by one: a criterion that is met by a hair's breadth.
const HAIR: f64 = 0.02;

/// The checks.
pub fn judge(Numbers { recorded, fresh, .. }: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![complete(recorded), as_recorded(recorded, fresh)])
}

/// Whether every start of every site is there once.
pub fn complete(recorded: &[Record]) -> Judged {
    let wanted = Site::all().len() * starts().count();
    let found: HashSet<String> = recorded.iter().map(key).collect();
    let quantity = Quantity::at("start of a reading that is not recorded", format!("of {wanted}"));
    let record = Reference::own("snapshots/readings.csv", 0.0);
    Check::at_most(quantity, record, "what is not recorded is not judged").judge(wanted.abs_diff(found.len()) as f64)
}

/// Whether fresh starts are the recorded ones.
pub fn as_recorded(recorded: &[Record], fresh: &[Record]) -> Judged {
    let moved = fresh.iter().filter(|fresh| !recorded.iter().any(|kept| is_as_recorded(kept, fresh))).count();
    let quantity = Quantity::at("recomputed start that is not the recorded one", format!("of {}", fresh.len()));
    let record = Reference::own("snapshots/readings.csv", 0.0);
    Check::at_most(quantity, record, "iterations by every criterion; `readings` renews the record")
        .judge(if fresh.is_empty() { f64::NAN } else { moved as f64 })
}

/// Whether a fresh start is the recorded one.
fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let numbers = |record: &Record| record.iterations.split(' ').map(|n| n.parse::<f64>().ok()).collect::<Vec<_>>();
    let alike = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1.0 + HAIR * a.max(*b),
        (None, None) => true,
        _ => false,
    };
    let [own, other] = [numbers(kept), numbers(fresh)];
    key(kept) == key(fresh) && own.len() == other.len() && own.iter().zip(&other).all(alike)
}

/// What a record is of.
fn key(record: &Record) -> String {
    let Record { example, candidates, element, thickness, algorithm, rule, bound, spring, stiffness, .. } = record;
    format!(
        "{example:?} {candidates:?} {element:?} {thickness} {algorithm:?} {rule:?} {bound} {spring:?} {stiffness:e}"
    )
}
