//! Where a contact found on a mesh begins and ends.

use crate::measure::ACTIVE;
use crate::measure::stretch::{self, Stretch};
use crate::scene::ContactPair;
use crate::solution::Part;

/// Candidate elements within the contact, from the symmetry line on where there is one, and from x = 0 to its outer end.
pub fn pressed(part: Part, pair: &ContactPair) -> [usize; 2] {
    let (edges, floor) = (part.edges, floor(part));
    let first = edges.iter().position(|edge| edge.pressure > floor);
    let last = edges.iter().rposition(|edge| edge.pressure > floor);
    let (Some(first), Some(last)) = (first, last) else { return [0, 0] };
    if !pair.path.has_both_sides() {
        return [last + 1, last + 1];
    }
    let middle = edges.len() / 2;
    [last + 1 - first, (last + 1).saturating_sub(middle).max(middle.saturating_sub(first))]
}

/// Whether the contact reaches the outermost candidate on the left and on the right; on a symmetry line it does not end.
pub fn filled(part: Part, pair: &ContactPair) -> [bool; 2] {
    outermost(part, pair).map_or([false; 2], |[first, last]| [first.reaches[0], last.reaches[1]])
}

/// Where the contact begins and ends \[mm, or rad\]: as far to the left as to the right of a symmetry line. NaN where there is
/// none.
pub fn ends(part: Part, pair: &ContactPair) -> [f64; 2] {
    match outermost(part, pair) {
        None => [f64::NAN; 2],
        Some([first, last]) if pair.path.has_both_sides() => [first.begin, last.end],
        Some([_, last]) => [-last.end, last.end],
    }
}

/// The first and the last closed stretch.
fn outermost(part: Part, pair: &ContactPair) -> Option<[Stretch; 2]> {
    let stretches = stretch::closed(pair, part, floor(part));
    stretches.first().zip(stretches.last()).map(|(first, last)| [*first, *last])
}

/// Pressure that counts as none.
fn floor(part: Part) -> f64 {
    ACTIVE * part.points.iter().map(|point| point.pressure).fold(0.0, f64::max)
}
