//! Contact of the elastic half-plane with any profile, of layers and rows, and of a ring with a pin, without finite
//! elements.
//!
//! * [`half_plane`]: pressure, resultants and stresses between given ends, in closed form but for a quadrature.
//! * [`ends`]: where the closed stretches begin and end under a load.
//! * [`elements`]: the same by pressures that are linear between nodes and an active set; the start, and the
//!   cross-check.
//! * `gap`: slope of a profile, and where it is not smooth.
//! * [`ring`]: a ring on a rigid pin, by Michell's series.
//! * [`strip`]: layers and rows under even profiles, by their kernels.
//! * `quadrature`: points between the places where an integrand is not smooth.

pub mod elements;
pub mod ends;
mod gap;
pub mod half_plane;
pub(super) mod quadrature;
pub mod ring;
pub mod strip;

pub use half_plane::HalfPlane;
pub use ring::Ring;
pub use strip::Strip;
