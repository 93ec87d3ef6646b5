//! Whether the frozen answers are read, are of the present scripts and meshes, and whether some code agrees with the truth.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::referee::judge::ENGINEERING;
use crate::study::scoreboard::board::{FOLDER, RENEW};
use crate::study::scoreboard::run::{Ended, Numbers, Row};
use crate::study::scoreboard::setting::Setting;

/// Relative change that other rounding explains.
const SAME: f64 = 1e-6;

/// The checks; those on other codes ask that one of them agrees, not that all do.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let rows = || numbers.rows.iter();
    let unread = rows().filter(|row| matches!(row.ended, Ended::Failed { by_itself: false, .. })).count();
    let moved = rows().filter(|row| !is_same(row)).count();
    let [now, then] = numbers.dofs;
    let complete = |value: f64| if numbers.rows.len() == Setting::ALL.len() { value } else { f64::NAN };
    let named = |name: &'static str| Quantity::at(name, numbers.case.clone());
    let none =
        |name, value: usize, because: &'static str| Check::none(named(name), because).judge(complete(value as f64));
    let best = numbers.best(|_| true);
    let nearest = |k: usize| match best.map(|row| &row.ended) {
        Some(Ended::Judged { scores, .. }) => (scores[k].error.abs(), scores[k].bar),
        _ => (f64::NAN, 0.0),
    };
    let agrees = |k: usize, name| {
        let (error, bar) = nearest(k);
        let reference = Reference {
            kind: crate::oracle::ReferenceKind::CrossCode,
            ..Reference::own("the nearest of other codes", 0.0)
        };
        Check::error(named(name), reference, ENGINEERING + bar, "engineering tolerance, and what the truth may be off")
            .judge(error)
    };
    let renewed = format!("{FOLDER} is of the present meshes: {RENEW}");
    Ok(vec![
        none("frozen answers that cannot be read", unread, "what a code wrote once is read as it was"),
        none(
            "frozen answers judged otherwise than when they were written",
            moved,
            "peak and second-moment width within 1e-6",
        ),
        none("scripts changed since their answers were frozen", numbers.changed.len(), RENEW),
        Check::at_most(
            named("degrees of freedom that the exported mesh has changed by"),
            Reference::own("none", 0.0),
            renewed,
        )
        .judge(now.abs_diff(then) as f64),
        agrees(0, "relative error of the peak pressure of the nearest code"),
        agrees(1, "relative error of the second-moment width of the nearest code"),
    ])
}

fn is_same(row: &Row) -> bool {
    match row.ended {
        Ended::Judged { moved, .. } => moved <= SAME,
        Ended::Failed { .. } => true,
    }
}
