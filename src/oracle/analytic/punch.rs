//! A rigid flat punch on a half-plane.

use std::f64::consts::PI;

use super::{answer, finite, positive};
use crate::oracle::{Oracle, Quantity, Reading, ReferenceKind, Source};

/// Rigid flat punch with sharp corners (Sadowsky 1928; Johnson, Contact Mechanics, 1985, §2.8).
///
/// The peak is infinite, so it is not read: compare the pressure at the centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatPunch {
    /// Full load per unit length `P` \[N/mm\].
    pub load: f64,
    /// Half-width of the punch `a` \[mm\].
    pub half_width: f64,
}

impl FlatPunch {
    /// Pressure `p = P / (π √(a² − x²))` \[MPa\] at `x` \[mm\]; infinite at the corners, zero outside.
    pub fn pressure(&self, x: f64) -> f64 {
        let inside = (self.half_width - x) * (self.half_width + x);
        if inside < 0.0 {
            return 0.0;
        }
        self.load / (PI * inside.sqrt())
    }

    /// Pressure at the centre `p(0) = P / πa` \[MPa\].
    pub fn centre_pressure(&self) -> f64 {
        self.pressure(0.0)
    }

    /// Half-width by second moment `2 √(∫p x²/∫p) = √2 a` \[mm\].
    pub fn second_moment(&self) -> f64 {
        std::f64::consts::SQRT_2 * self.half_width
    }
}

impl Oracle for FlatPunch {
    fn name(&self) -> &str {
        "flat punch"
    }

    fn kind(&self) -> ReferenceKind {
        ReferenceKind::Analytic
    }

    fn source(&self) -> Source {
        Source::new(
            "M. Sadowsky 1928; K. L. Johnson, Contact Mechanics, 1985, §2.8",
            "re-derived, originals not at hand; checked by equilibrium",
        )
    }

    fn read(&self, quantity: Quantity) -> Reading {
        let mut parameters = vec![positive("load", self.load), positive("half_width", self.half_width)];
        let value = match quantity {
            Quantity::HalfWidth => self.half_width,
            Quantity::SecondMoment => self.second_moment(),
            Quantity::Resultant => self.load,
            Quantity::Pressure { at } => {
                parameters.push(finite("at", at));
                self.pressure(at)
            }
            _ => return Reading::Silent,
        };
        answer(&parameters, value)
    }
}
