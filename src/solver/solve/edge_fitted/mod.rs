//! Meshes fitted to the contact: mesh lines on the ends of every closed stretch, with layers of cells towards them.
//!
//! The solution is analytic but for the square root in which the pressure ends. On a mesh that ends a cell there, cells
//! of high order see nothing of it: the error falls with the order as if it were not there. Where the contact ends is
//! found on the way: all points up to an expected end are closed, and the pressure there tells how far off that is. The
//! error of peak and width is of second order in it.
//!
//! * `fitted` — order and layers of such a mesh, and what it is not made for.
//! * `search` — the ends sought on coarse meshes, then on the one asked for.
//! * `closed` — the closed stretches, a mesh with lines on their ends, how far these shall move, and where the contact
//!   ends there.
//! * `tip` — how far that is from such a line, by the forces near it.
//! * `top` — the largest pressure between two such lines, by the forces of all of the stretch.

mod closed;
mod fitted;
mod search;
mod tip;
mod top;

pub(super) use closed::of_lines;
pub use fitted::Fitted;
pub use search::{Answer, Sought, Tried};
pub(crate) use search::{lay_on_ends, off};
