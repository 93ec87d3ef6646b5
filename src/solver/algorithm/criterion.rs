//! When an iteration stops: by its error against the discrete solution, or by what one could see of it without that.
//!
//! Only the first says something of the answer. The others are those that the paper can have had, which does not tell
//! its own.

use crate::algorithm::{ContactProblem, Iterate, target};
use crate::measure::largest;
use crate::named::named_enum;
use crate::solution::Seen;

named_enum! {
    /// What shall fall below the tolerance.
    pub enum Criterion {
        /// The iteration error against the discrete solution.
        Error = "error",
        /// The contact conditions: penetration, tension, and pressure across a gap.
        Conditions = "conditions",
        /// Change of the displacements, penetration and tension.
        Residuals = "residuals",
        /// Change of the displacements alone.
        Displacement = "displacement",
        /// Points that open or close: the iteration stops where none does, whatever the tolerance.
        State = "state",
    }
}

impl Criterion {
    /// What it judges of an iteration by what that shows; none for the iteration error, which it does not show.
    pub fn of(self, seen: &Seen) -> Option<f64> {
        match self {
            Self::Error => None,
            Self::Conditions => Some(seen.conditions),
            Self::Residuals => Some(seen.residuals),
            Self::Displacement => Some(seen.displacement),
            Self::State => Some(seen.state),
        }
    }
}

/// What an iterate shows after the one before it; of changes nothing where there is none.
pub fn seen(problem: &ContactProblem, before: Option<&Iterate>, iterate: &Iterate) -> Seen {
    let [w, p] = [largest(iterate.approach.iter().map(|w| w.abs())), largest(iterate.pressure.iter().copied())];
    let deep = problem.points.iter().zip(&iterate.approach).map(|(point, w)| w - point.gap);
    let [penetration, tension] = [largest(deep) / w, largest(iterate.pressure.iter().map(|p| -p)) / p];
    let across = problem.points.iter().zip(&iterate.approach).zip(&iterate.pressure).map(|((point, own), pressure)| {
        let gap = point.gap - own;
        // An infinite gap is open, whatever is left in its spring.
        if gap > 0.0 && *pressure > 0.0 { gap.min(w) * pressure } else { 0.0 }
    });
    let conditions = largest([penetration, tension, largest(across) / (w * p)]);
    let Some(before) = before else { return Seen { conditions, ..Seen::NOTHING } };
    let moved = iterate.displacement.iter().zip(&before.displacement).map(|(u, earlier)| u - earlier);
    let displacement = norm(moved) / norm(iterate.displacement.iter().copied());
    let is_same = target::pressed(problem, iterate) == target::pressed(problem, before);
    Seen {
        conditions,
        displacement,
        residuals: largest([displacement, penetration, tension]),
        state: if is_same { 0.0 } else { 1.0 },
    }
}

fn norm(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.map(|x| x * x).sum::<f64>().sqrt()
}
