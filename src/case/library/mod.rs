//! The scenes of the suite: each is one struct of numbers, and what it makes of them.
//!
//! * [`hertz`] — elastic cylinder on a rigid plane, and its exact twin, the truncated Hertz scene.
//! * [`pin`] — pin and connecting-rod eye; pin in a wide plate.
//! * [`exact`] — patch test, press fit, two bars, own weight, flat punch.

pub mod exact;
pub mod hertz;
pub mod pin;

pub use exact::{Bars, FlatPunch, OwnWeight, Patch, PressFit};
pub use hertz::{Cylinder, CylinderModel, TruncatedHertz};
pub use pin::{PinPlate, PinRod};
