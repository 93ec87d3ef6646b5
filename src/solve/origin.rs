//! Where the contact iteration starts.

use crate::named::named_enum;
use crate::solution::Solution;

named_enum! {
    /// Where kinematic load starts.
    pub enum Start {
        /// Every candidate point closed: the paper's own start.
        Closed = "closed",
        /// The active set of a mesh half as fine, itself found from one half as fine, down to one element per half-width.
        ///
        /// A point starts as the nearest point of the coarser mesh ended: open, closed or hardened. The contact edge is then
        /// wrong by about a coarse point spacing, and an iteration or two set it right.
        Nested = "nested",
    }
}

/// Where one solve starts.
#[derive(Clone, Copy, Debug)]
pub enum Origin<'a> {
    /// Where its formulation says.
    Own,
    /// From the active set of an earlier solution on this mesh or on another one, whose candidates may end elsewhere.
    ///
    /// A point starts closed where the nearest point of the same contact was pressed. Only kinematic load has an active set
    /// to start from; the other algorithms, and load in increments, start as ever. Where the set leads nowhere, or the earlier
    /// solution is none, the scene is solved from its own start.
    From(&'a Solution),
}
