//! Where an iteration must fail, and how fast it goes, before it is run: read off the condensed matrices.
//!
//! * [`rate`] — asymptotic rates of the iterations on their final contact set.
//! * [`conditioning`] — what stiff springs cost in digits.
//! * [`halving`] — steps of kinematic load started with every candidate closed.

pub mod conditioning;
pub mod halving;
pub mod rate;
