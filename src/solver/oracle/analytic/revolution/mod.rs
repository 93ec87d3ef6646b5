//! Frictionless contact of bodies of revolution on a half-space; loads are whole forces \[N\].
//!
//! * [`sphere`]: Hertz's point contact, of a paraboloid or of two spheres.
//! * [`indentation`]: a rigid profile of revolution by its transform: powers, cone, circle, flat punch.
//! * [`half_space`]: stresses and displacements below a pressure of revolution.

pub mod half_space;
pub mod indentation;
pub mod sphere;
