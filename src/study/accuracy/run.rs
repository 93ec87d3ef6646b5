//! An answer against the closed form, a far finer mesh and the mesh made by hand.

use serde::Serialize;

use crate::accuracy::{self, Answer, Asked, Quantity};
use crate::error::Error;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::accuracy::by_hand::{ByHand, Price, truth};
use crate::study::accuracy::subject::{Subject, closed_form, error};

/// What an accuracy costs, and whether it is kept; errors are relative, the larger ones of peak and second-moment width.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Numbers {
    /// Error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Error estimated.
    pub estimate: f64,
    /// Error against the closed form.
    pub closed_form: f64,
    /// Error against a mesh far finer.
    pub finer: f64,
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
    /// Those of all meshes solved.
    pub dofs_in_all: usize,
    /// The mesh made by hand.
    pub by_hand: Price,
}

/// The engine's answer beside the mesh made by hand.
pub fn numbers(subject: Subject, asked: f64, by_hand: ByHand) -> Result<Numbers, Error> {
    let case = subject.loaded(1.0);
    let plain = Formulation::new(Element::Node, Iteration::Kinematic);
    let quantities = vec![Quantity::PeakPressure, Quantity::SecondMomentWidth];
    let answer = accuracy::solve(&case.scene, &plain, &Asked { quantities, ..Asked::new(asked) })?;
    Ok(Numbers::of(&answer, asked, [closed_form(&case), truth(subject)?], by_hand.price(subject)?))
}

impl Numbers {
    /// Of an answer, given peak and second-moment width by the closed form and by the finer mesh.
    pub fn of(answer: &Answer, asked: f64, [exact, finer]: [[f64; 2]; 2], by_hand: Price) -> Self {
        Self {
            asked,
            met: answer.unmet.is_none(),
            estimate: answer.estimate(),
            closed_form: error(&answer.run, exact),
            finer: error(&answer.run, finer),
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
            by_hand,
        }
    }
}
