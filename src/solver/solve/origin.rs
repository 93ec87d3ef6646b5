//! Where the contact iteration starts.

use crate::solution::Solution;

/// Where one solve starts.
#[derive(Clone, Copy, Debug)]
pub enum Origin<'a> {
    /// From the initial stiffness at every candidate.
    Own,
    /// From the active set of an earlier solution on this mesh or on another one, whose candidates may end elsewhere.
    ///
    /// A point starts closed where the nearest point of the same contact was pressed. Only kinematic load has an active set
    /// to start from; the other algorithms, and load in increments, start as ever. Where the set leads nowhere, or the earlier
    /// solution is none, the scene is solved from its own start.
    From(&'a Solution),
}
