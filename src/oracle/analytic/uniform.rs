//! A patch under uniform pressure.

use super::{answer, finite, positive};
use crate::oracle::{Oracle, Quantity, Reading, ReferenceKind, Source};

/// Two blocks with matching faces pressed together by a uniform pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uniform {
    /// Applied pressure `q` \[MPa\].
    pub applied: f64,
    /// Full width of the patch `B` \[mm\].
    pub width: f64,
}

impl Uniform {
    /// Contact pressure `p = q` \[MPa\].
    pub fn pressure(&self) -> f64 {
        self.applied
    }

    /// Contact force per unit thickness `qB` \[N/mm\].
    pub fn resultant(&self) -> f64 {
        self.applied * self.width
    }
}

impl Oracle for Uniform {
    fn name(&self) -> &str {
        "uniform patch"
    }

    fn kind(&self) -> ReferenceKind {
        ReferenceKind::Analytic
    }

    fn source(&self) -> Source {
        Source::new("equilibrium", "constant stress satisfies every field equation")
    }

    fn read(&self, quantity: Quantity) -> Reading {
        let mut parameters = vec![positive("applied", self.applied), positive("width", self.width)];
        let value = match quantity {
            Quantity::Resultant => self.resultant(),
            Quantity::PeakPressure => self.pressure(),
            Quantity::Pressure { at } => {
                parameters.push(finite("at", at));
                self.pressure()
            }
            _ => return Reading::Silent,
        };
        answer(&parameters, value)
    }
}
