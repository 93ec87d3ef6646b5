//! Within what is asked at both ends; and a width that is plainly wrong must be seen.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::study::photoelastic::run::{Numbers, Width};

/// Root mean square that is accepted, in fringe orders: the reading is good to about 0.03.
const ACCEPTED: f64 = 0.035;
/// Half-widths over the fitted one that must not pass.
const WRONG: [f64; 2] = [0.7, 1.3];
/// Root mean square that our mesh may cost: a third of that of reading.
const MESH: f64 = 0.01;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let photograph = || Reference {
        name: "photograph, shape only, uncalibrated".into(),
        kind: ReferenceKind::Measured,
        value: 0.0,
        uncertainty: None,
    };
    let ends = numbers.ends.iter().map(|end| {
        let quantity =
            Quantity::at("root mean square of the fringe orders", format!("{}, {} points", end.end, end.points));
        let because = "read to about 0.03 orders; five constants fitted at the bottom, none at the top";
        Check::absolute(quantity, photograph(), ACCEPTED, because).judge(end.rms)
    });
    let wrong = WRONG.map(|times| {
        let quantity = Quantity::at("root mean square with a wrong half-width", format!("{times} of the fitted one"));
        let because = "a comparison that does not see this sees nothing of the contact";
        Check::at_least(quantity, Reference::own("what is accepted", ACCEPTED), because).judge(at(numbers, times))
    });
    let mesh = Check::at_most(
        "root mean square of the fringe orders that a mesh twice as coarse changes",
        Reference::own("accepted", MESH),
        "our own error shall be at most a third of that of reading",
    );
    Ok(ends.chain(wrong).chain([mesh.judge(numbers.mesh[0])]).collect())
}

/// With all else held, at the half-width solved next to so many times the fitted one.
fn at(numbers: &Numbers, times: f64) -> f64 {
    let wanted = times * numbers.half_width[0];
    let far = |width: &&Width| (width.a_over_r - wanted).abs();
    numbers.widths.iter().min_by(|a, b| far(a).total_cmp(&far(b))).map_or(f64::NAN, |width| width.held)
}
