//! Where a contact found on a mesh begins and ends.

use crate::measure::ACTIVE;
use crate::solve::run::Run;

/// Candidate elements within a contact, from the symmetry line on where there is one, and from x = 0 to its outer end.
pub fn pressed(run: &Run, contact: usize) -> [usize; 2] {
    let (edges, measures) = (run.solution.edges_of(contact), &run.contacts[contact].measures);
    let floor = ACTIVE * measures.largest.pressure;
    let first = edges.iter().position(|edge| edge.pressure > floor);
    let last = edges.iter().rposition(|edge| edge.pressure > floor);
    let (Some(first), Some(last)) = (first, last) else { return [0, 0] };
    if !measures.across {
        return [last + 1, last + 1];
    }
    let middle = edges.len() / 2;
    [last + 1 - first, (last + 1).saturating_sub(middle).max(middle.saturating_sub(first))]
}

/// Whether it reaches an outermost candidate; on a symmetry line it does not end.
pub fn is_filled(run: &Run, contact: usize) -> bool {
    let stretches = &run.contacts[contact].measures.stretches;
    stretches.first().is_some_and(|one| one.reaches[0]) || stretches.last().is_some_and(|one| one.reaches[1])
}

/// Where it begins and ends \[mm, or rad\]: as far to the left as to the right of a symmetry line. NaN where there is none.
pub fn ends(run: &Run, contact: usize) -> [f64; 2] {
    let measures = &run.contacts[contact].measures;
    match measures.stretches.first() {
        None => [f64::NAN; 2],
        Some(first) if measures.across => [first.begin, measures.edge()],
        Some(_) => [-measures.edge(), measures.edge()],
    }
}
