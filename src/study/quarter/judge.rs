//! The top quarter may be left out while the contact is small: the change grows with (a/R)².

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::quarter::run::{Change, Contact, Numbers};

/// Change of peak and second-moment width below which the top quarter may be left out.
pub const LEFT_OUT: f64 = 1e-3;
/// Largest a/R at which that is required.
const JUDGED: f64 = 0.025;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let judged = numbers.changes.iter().filter(|change| change.a_over_r <= JUDGED);
    Ok(judged.flat_map(of).collect())
}

fn of(change: &Change) -> [Judged; 2] {
    let near = |quantity: &'static str, of: fn(&Contact) -> f64| {
        let at = format!("a/R = {}", change.a_over_r);
        let half = Reference::own("half cylinder", of(&change.half));
        Check::near(Quantity::at(quantity, at), half, LEFT_OUT, "far field: of the order of (a/R)²")
            .judge(of(&change.quarter))
    };
    [
        near("peak pressure of the quarter cylinder [MPa]", |contact| contact.peak),
        near("half-width of the quarter cylinder [mm]", |contact| contact.half_width),
    ]
}
