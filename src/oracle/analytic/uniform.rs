//! A patch under uniform pressure.

use super::{positive, uniform_answer};
use crate::oracle::{Oracle, Quantity, Reading, Source};

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

    fn source(&self) -> Source {
        Source::new("equilibrium", "constant stress satisfies every field equation")
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![positive("applied", self.applied), positive("width", self.width)];
        uniform_answer(parameters, quantity, self.pressure(), self.resultant())
    }
}
