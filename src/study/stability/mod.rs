//! Predicted against measured, one iteration at a time.
//!
//! * `ground` — the scene and the contact that an iteration ends in.
//! * `rates` — asymptotic rates of constant and varying stiffness.
//! * `before` — the rate of varying stiffness, by Hertz's closed form alone.
//! * `fixed_target` — constant stiffness towards given springs: whether and how fast.
//! * `basin` — varying stiffness with `correction`: what attracts nearby, and what happens from afar.
//! * `failing` — why `secant` and `literal` fail with constant stiffness.
//! * `halving` — iterations of kinematic load.
//! * `plan` — all of them, by element or by scene.
//! * `judge` — the predictions hold.
//! * `section`, `tables` — predictions beside measurements.

pub mod basin;
pub mod before;
pub mod failing;
pub mod fixed_target;
mod ground;
pub mod halving;
pub mod judge;
mod numbers;
mod plan;
pub mod rates;
mod section;
mod tables;

use crate::study::about::About;

pub use judge::judge;
pub use numbers::Numbers;
pub use plan::plan;
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Predicted against measured",
    asked: "Whether rates and iterations are those that the matrices predict.",
    limits: "What is called a posteriori needs the solved contact, and is no help before it.",
};
