//! Where an iteration must fail, and how fast it goes, before it is run: read off the condensed matrices.
//!
//! * [`limit`] — the contact an iteration shall end in.
//! * [`linear`] — steps of constant stiffness from its start, linearised on the final contact set.
//! * [`rate`] — asymptotic rates of the iterations on their final contact set.
//! * [`release`] — steps of varying stiffness, from the points just outside the contact.
//! * [`conditioning`] — what stiff springs cost in digits.
//! * [`halving`] — steps of kinematic load started with every candidate closed.

pub mod conditioning;
pub mod halving;
pub mod limit;
pub mod linear;
pub mod rate;
pub mod release;

pub use limit::Limit;
