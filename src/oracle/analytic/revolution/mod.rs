//! Frictionless contact of bodies of revolution on a half-space, and thick shells; loads are whole forces \[N\].
//!
//! * [`sphere`]: Hertz's point contact, of a paraboloid or of two spheres.
//! * [`indentation`]: a rigid profile of revolution by its transform: powers, cone, circle, flat punch.
//! * [`half_space`]: stresses and displacements below a pressure of revolution.
//! * [`shell`]: Lamé's thick sphere and cylinder, alone and fitted.

pub mod half_space;
pub mod indentation;
pub mod shell;
pub mod sphere;
