//! A closed form along a straight line, read on an arc.

use crate::oracle::{Oracle, Quantity, Reading, ReferenceKind, SharedOracle, Source};

/// A closed form of a straight line for a contact that is short beside the arc it lies on: its lengths are `s = r θ`.
#[derive(Clone)]
pub struct OnArc {
    /// The closed form along the line.
    pub straight: SharedOracle,
    /// Radius of the arc `r` \[mm\].
    pub radius: f64,
}

impl OnArc {
    /// A length along the line as the angle `θ = s/r` \[rad\].
    fn angle(&self, length: &Quantity) -> Reading {
        match self.straight.read(length) {
            Reading::Value { value, uncertainty } => {
                Reading::Value { value: value / self.radius, uncertainty: uncertainty / self.radius }
            }
            other => other,
        }
    }
}

impl Oracle for OnArc {
    fn kind(&self) -> ReferenceKind {
        self.straight.kind()
    }

    fn source(&self) -> Source {
        self.straight.source()
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        match quantity {
            Quantity::HalfWidth | Quantity::SecondMomentWidth => self.angle(quantity),
            Quantity::Pressure { at } => self.straight.read(&Quantity::Pressure { at: self.radius * at }),
            other => self.straight.read(other),
        }
    }
}
