//! Two bars closing a gap.

use super::{finite, non_negative, positive, uniform_answer};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Two bars in line, one end moved towards the other until the gap closes (`ν = 0`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bars {
    /// Young's modulus of both bars `E` \[MPa\].
    pub young: f64,
    /// Section of both bars per unit thickness `A` \[mm\].
    pub section: f64,
    /// Length of the moved bar `L₁` \[mm\].
    pub moved_length: f64,
    /// Length of the fixed bar `L₂` \[mm\].
    pub fixed_length: f64,
    /// Gap between them `g ≥ 0` \[mm\].
    pub gap: f64,
    /// Displacement of the free end `u` \[mm\], positive towards the fixed bar.
    pub displacement: f64,
}

impl Bars {
    /// Force per unit thickness `F = EA (u − g) / (L₁ + L₂)` \[N/mm\], zero while `u ≤ g`.
    pub fn force(&self) -> f64 {
        self.pressure() * self.section
    }

    /// Contact pressure `p = E (u − g) / (L₁ + L₂)` \[MPa\], zero while `u ≤ g`.
    pub fn pressure(&self) -> f64 {
        let closure = self.displacement - self.gap;
        if closure <= 0.0 {
            return 0.0;
        }
        self.young * closure / (self.moved_length + self.fixed_length)
    }
}

impl Oracle for Bars {
    fn name(&self) -> &str {
        "two bars"
    }

    fn source(&self) -> Source {
        Source::new("Hooke's law", "two bars in series; bilinear, exact for ν = 0")
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![
            positive("young", self.young),
            positive("section", self.section),
            positive("moved_length", self.moved_length),
            positive("fixed_length", self.fixed_length),
            non_negative("gap", self.gap),
            finite("displacement", self.displacement),
        ];
        uniform_answer(parameters, quantity, self.pressure(), self.force())
    }
}
