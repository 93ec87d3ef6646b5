//! The scenes, with their closed forms.

use crate::case::Case;
use crate::case::library::{Cylinder, PinPlate, TruncatedHertz};
use crate::measure::larger;
use crate::oracle::Quantity;
use crate::solve::Run;

/// Contact half-angle of the pin \[degrees\].
const ANGLE: f64 = 60.0;

/// A scene of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Truncated Hertz.
    Truncated,
    /// The cylinder at a/R = 0.005.
    Cylinder,
    /// The pin in a wide plate.
    Pin,
}

impl Subject {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Truncated => "truncated hertz",
            Self::Cylinder => "cylinder, a/R = 0.005",
            Self::Pin => "pin in plate, ε = 60°",
        }
    }

    /// The scene under the load that makes the contact so many times as long as the nominal one, on the outline of that one.
    pub fn loaded(self, ratio: f64) -> Case {
        match self {
            Self::Truncated => {
                let nominal = TruncatedHertz::default();
                let (a_over_r, size) = (nominal.a_over_r * ratio, nominal.size / ratio);
                let numbers = TruncatedHertz { a_over_r, size, stretch: nominal.stretch / ratio, ..nominal };
                numbers.case()
            }
            Self::Cylinder => {
                let nominal = Cylinder { a_over_r: 0.005, ..Default::default() };
                let (a_over_r, stretch) = (nominal.a_over_r * ratio, nominal.stretch / ratio);
                Cylinder { a_over_r, stretch, ..nominal }.case()
            }
            Self::Pin => PinPlate::of_half_angle(ANGLE * ratio).case(),
        }
    }

    /// Nominal half-width \[mm\], or half-angle \[rad\].
    pub fn nominal(self) -> f64 {
        match self {
            Self::Truncated => TruncatedHertz::default().half_width(),
            Self::Cylinder => Cylinder { a_over_r: 0.005, ..Default::default() }.half_width(),
            Self::Pin => ANGLE.to_radians(),
        }
    }
}

/// Peak pressure and second-moment width, or second-moment angle, by the closed form.
pub fn closed_form(case: &Case) -> [f64; 2] {
    [Quantity::PeakPressure, Quantity::SecondMoment].map(|quantity| case.reading(quantity).value)
}

/// Larger relative error of peak and second-moment width; NaN where either is or the run did not converge.
pub fn error(run: &Run, truth: [f64; 2]) -> f64 {
    let measures = run.measures();
    let found = [measures.peak.pressure, measures.second_moment_width];
    let [peak, half_width] = [0, 1].map(|k| (found[k] / truth[k] - 1.0).abs());
    if run.solution.converged() { larger(peak, half_width) } else { f64::NAN }
}
