//! All that is needed to run a case elsewhere.
//!
//! * [`gmsh`] — its mesh for Gmsh, and what reads its files.
//! * [`deck`] — an input deck of CalculiX or Abaqus.
//! * [`own`] — our own answer, and an empty one.

pub mod deck;
pub mod gmsh;
pub mod own;
