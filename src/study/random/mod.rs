//! Random scenes, and what is true of them by closed forms or a boundary method: the same ones for every study that asks.
//!
//! * [`draw`] — the random numbers.
//! * [`family`] — kinds of scenes.
//! * [`sample`] — a scene and the truths about it.
//! * `blocks` — blocks under parabolas, waves and punches.
//! * `gaps` — gaps of all other kinds, whose truth is that of the boundary method.
//! * `pressed` — blocks cut out of the half-plane that they press.
//! * `half_plane` — what the stresses below them say.
//! * `round` — cylinders, pins and rings.
//! * `strips` — layers and rows.
//! * [`unseen`] — scenes that bars and accuracies are tested with.
//! * `scenes` — a scene of each family; such scenes with a coarse mesh given, and two of them in one.
//!
//! Sizes, materials, loads and guesses of the candidate stretch are drawn. What the scene is and the closed form is not must stay
//! far below the errors that are looked at: blocks carry the stresses of the half-plane on their sides, and leave nothing out;
//! waves are pressed on blocks at least two waves high, e^(−8π) of which nothing is left; cylinders have a/R ≤ 0.005 and pins
//! clearances of 1e-6 radii in plates of 1000 radii, which leaves 1e-5 (a test measures both).

mod blocks;
pub mod draw;
pub mod family;
mod gaps;
mod half_plane;
mod pressed;
mod round;
pub mod sample;
mod scenes;
mod strips;
pub mod unseen;

pub use draw::Draw;
pub use family::{Family, Site};
pub use sample::{GUESS, Sample, Truth};
