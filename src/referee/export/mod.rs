//! All that is needed to run a case elsewhere.
//!
//! * [`gmsh`] — its mesh for Gmsh, and what reads its files.
//! * [`deck`] — an input deck of CalculiX or Abaqus.
//! * [`problem`] — the same as plain numbers, and scripts of other codes that solve it.
//! * `rows` — what both share: approaches of contact nodes as displacements of nodes, nodal forces.
//! * [`condensed`] — the condensed matrices and our solution, for other algorithms.
//! * [`own`] — our own answer, and an empty one.

pub mod condensed;
pub mod deck;
pub mod gmsh;
pub mod own;
pub mod problem;
mod rows;
