//! A scene and the truths about it.

use crate::accuracy::{Quantity, Subject};
use crate::scene::Scene;

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
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// What is measured.
    pub subject: Subject,
    /// Its true value.
    pub value: f64,
}

impl Sample {
    /// A scene with one contact, that any mesh sees.
    pub fn of<const N: usize>(scene: Scene, truths: [(Quantity, f64); N]) -> Self {
        let truth = |(quantity, value)| Truth { subject: Subject::Contact(0, quantity), value };
        Self { scene, truths: truths.map(truth).into(), fewest: 0.0 }
    }

    /// The same with the force of a support of a body \[N\].
    pub fn held(mut self, (body, support): (usize, usize), value: f64) -> Self {
        self.truths.push(Truth { subject: Subject::Reaction(body, support), value });
        self
    }

    /// The same where it takes some elements on half of the contact to see all there is.
    pub fn seen_by(self, fewest: f64) -> Self {
        Self { fewest, ..self }
    }

    /// The true value of a number of a contact; NaN where the closed form does not say.
    pub fn truth(&self, contact: usize, quantity: Quantity) -> f64 {
        let subject = Subject::Contact(contact, quantity);
        self.truths.iter().find(|truth| truth.subject == subject).map_or(f64::NAN, |truth| truth.value)
    }
}
