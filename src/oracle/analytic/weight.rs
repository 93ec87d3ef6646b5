//! A block under its own weight.

use super::{positive, uniform_answer};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Rectangular block standing free on a rigid frictionless plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnWeight {
    /// Specific weight `ρg` \[N/mm³\], acting towards the plane.
    pub specific_weight: f64,
    /// Height of the block `H` \[mm\].
    pub height: f64,
    /// Full width of the block `B` \[mm\].
    pub width: f64,
}

impl OwnWeight {
    /// Contact pressure `p = ρgH` \[MPa\], uniform.
    pub fn pressure(&self) -> f64 {
        self.specific_weight * self.height
    }

    /// Weight per unit thickness `ρgHB` \[N/mm\].
    pub fn resultant(&self) -> f64 {
        self.pressure() * self.width
    }
}

impl Oracle for OwnWeight {
    fn name(&self) -> &str {
        "own weight"
    }

    fn source(&self) -> Source {
        Source::new("equilibrium", "σ_y = −ρg(H − y) satisfies every field equation")
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![
            positive("specific_weight", self.specific_weight),
            positive("height", self.height),
            positive("width", self.width),
        ];
        uniform_answer(parameters, quantity, self.pressure(), self.resultant())
    }
}
