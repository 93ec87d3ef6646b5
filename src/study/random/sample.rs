//! A scene and the truths about it.

use crate::measure::Quantity;
use crate::scene::{Component, Place, Scene};
use crate::solve::Displaced;

/// Guess of the candidate stretch over the length of the contact, where the bodies allow it.
pub const GUESS: [f64; 2] = [0.3, 10.0];

/// A scene and the truths about it.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The scene.
    pub scene: Scene,
    /// What its closed form says.
    pub truths: Vec<Truth>,
    /// Fewest elements on half of the contact that see all there is.
    pub fewest: f64,
}

/// The true value of a number.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Index of the contact that it is of; 0 of reactions and displacements.
    pub contact: usize,
    /// What is measured.
    pub quantity: Quantity,
    /// Its true value.
    pub value: f64,
}

impl Sample {
    /// A scene with one contact, that any mesh sees.
    pub fn of<const N: usize>(scene: Scene, truths: [(Quantity, f64); N]) -> Self {
        let truth = |(quantity, value)| Truth { contact: 0, quantity, value };
        let sample = Self { scene, truths: truths.map(truth).into(), fewest: 0.0 };
        let half_width = sample.half_width(0);
        if half_width.is_nan() { sample } else { sample.with(Quantity::HalfWidth, half_width) }
    }

    /// Half of what lies between where a contact begins and ends; NaN where the closed form does not say.
    fn half_width(&self, contact: usize) -> f64 {
        let end = self.end(contact);
        let begin = self.truth(contact, &Quantity::Begin(0));
        let on_symmetry_line = begin.is_nan() && !self.scene.contacts[contact].path.has_both_sides();
        let begin = if on_symmetry_line { -end } else { begin };
        0.5 * (end - begin)
    }

    /// The same with the force of a support of a body \[N\].
    pub fn held(self, (body, support): (usize, usize), value: f64) -> Self {
        self.with(Quantity::Reaction { body, support }, value)
    }

    /// The same with another number of its first contact.
    pub fn with(mut self, quantity: Quantity, value: f64) -> Self {
        self.truths.push(Truth { contact: 0, quantity, value });
        self
    }

    /// The same with a displacement component of a side or a point \[mm\].
    pub fn moved(self, body: usize, at: Place, component: Component, value: f64) -> Self {
        self.with(Quantity::Displacement(Displaced { body, at, component }), value)
    }

    /// The same with the largest shear stress below the contact in a body, and its depth \[MPa, mm\].
    pub fn sheared(self, body: usize, [stress, depth]: [f64; 2]) -> Self {
        self.with(Quantity::Shear { body }, stress).with(Quantity::ShearDepth { body }, depth)
    }

    /// The same where the pressure has no limit, so that nothing is known of its place nor of the shear stress.
    pub fn without_peak(mut self) -> Self {
        self.truths.retain_mut(|truth| match truth.quantity {
            Quantity::PeakPressure => {
                truth.value = f64::INFINITY;
                true
            }
            Quantity::PeakPlace | Quantity::Shear { .. } | Quantity::ShearDepth { .. } => false,
            _ => true,
        });
        self
    }

    /// The displacements that its truths are of.
    pub fn displaced(&self) -> Vec<Displaced> {
        let displaced = |truth: &Truth| match &truth.quantity {
            Quantity::Displacement(displaced) => Some(displaced.clone()),
            _ => None,
        };
        self.truths.iter().filter_map(displaced).collect()
    }

    /// The same where it takes some elements on half of the contact to see all there is.
    pub fn seen_by(self, fewest: f64) -> Self {
        Self { fewest, ..self }
    }

    /// Outermost end of a contact; NaN where the closed form does not say.
    pub fn end(&self, contact: usize) -> f64 {
        let ends = (0..).map(|k| self.truth(contact, &Quantity::End(k)));
        ends.take_while(|end| end.is_finite()).last().unwrap_or(f64::NAN)
    }

    /// The true value of a number of a contact; NaN where the closed form does not say.
    pub fn truth(&self, contact: usize, quantity: &Quantity) -> f64 {
        let own = self.truths.iter().find(|truth| truth.contact == contact && truth.quantity == *quantity);
        let known = own.map(|truth| truth.value);
        match quantity {
            Quantity::HalfWidth => known.unwrap_or_else(|| self.half_width(contact)),
            _ => known.unwrap_or(f64::NAN),
        }
    }
}
