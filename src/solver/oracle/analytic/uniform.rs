//! Contacts under one pressure all over: a patch, a block under its own weight, two bars closing a gap.

use super::{Parameter, answer, finite, non_negative, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// A contact whose pressure is the same everywhere.
#[derive(Clone, Debug)]
pub struct Uniform {
    /// Contact pressure \[MPa\].
    pub pressure: f64,
    /// Contact force per unit thickness \[N/mm\].
    pub resultant: f64,
    parameters: Vec<Parameter>,
    source: Source,
}

impl Uniform {
    /// Two blocks with matching faces of the full width `B` \[mm\] pressed together by a pressure `q` \[MPa\]: `p = q`,
    /// `qB`.
    pub fn patch(applied: f64, width: f64) -> Self {
        Self {
            pressure: applied,
            resultant: applied * width,
            parameters: vec![positive("applied", applied), positive("width", width)],
            source: Source::new("uniform patch", "equilibrium", "constant stress satisfies every field equation"),
        }
    }

    /// Rectangular block standing free on a rigid frictionless plane, of specific weight `ρg` \[N/mm³\], height `H` and
    /// full width `B` \[mm\]: `p = ρgH`, `ρgHB`.
    pub fn own_weight(specific_weight: f64, height: f64, width: f64) -> Self {
        let pressure = specific_weight * height;
        let given = [("specific_weight", specific_weight), ("height", height), ("width", width)];
        Self {
            pressure,
            resultant: pressure * width,
            parameters: given.map(|(name, value)| positive(name, value)).into(),
            source: Source::new("own weight", "equilibrium", "σ_y = −ρg(H − y) satisfies every field equation"),
        }
    }

    /// Two bars in line (`ν = 0`) of Young's modulus `E` \[MPa\], section per unit thickness `A` and lengths `L₁`, `L₂`
    /// \[mm\], one end moved by `u` towards the other until the gap `g ≥ 0` closes \[mm\]: `p = E (u − g) / (L₁ + L₂)`,
    /// zero while `u ≤ g`, and `pA`.
    pub fn bars(young: f64, section: f64, [moved, fixed]: [f64; 2], gap: f64, displacement: f64) -> Self {
        let closure = displacement - gap;
        let pressure = if closure <= 0.0 { 0.0 } else { young * closure / (moved + fixed) };
        Self {
            pressure,
            resultant: pressure * section,
            parameters: vec![
                positive("young", young),
                positive("section", section),
                positive("moved_length", moved),
                positive("fixed_length", fixed),
                non_negative("gap", gap),
                finite("displacement", displacement),
            ],
            source: Source::new("two bars", "Hooke's law", "two bars in series; bilinear, exact for ν = 0"),
        }
    }
}

impl Oracle for Uniform {
    fn source(&self) -> Source {
        self.source
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let value = match quantity {
            Quantity::Resultant => self.resultant,
            Quantity::PeakPressure | Quantity::Pressure { .. } => self.pressure,
            _ => return Reading::Silent,
        };
        answer(self.parameters.clone(), quantity, value)
    }
}
