//! What is asked, and what is answered.

use crate::accuracy::reading::Quantity;
use crate::measure::larger;
use crate::mesh::size::MOST;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::{Contact, Errors, Run};

impl Quantity {
    /// Relative error that the iteration leaves in it, with what springs of the rule `penalty` cost; NaN where it is not known.
    pub(super) fn iterated(self, contact: &Contact) -> f64 {
        let of = |errors: Errors| match self {
            Self::PeakPressure => errors.peak.abs(),
            Self::HalfWidth => errors.half_width.abs(),
            // Nothing is recorded of the others, and no accuracy may be asked for them.
            _ => f64::NAN,
        };
        contact.iteration.map_or(f64::NAN, of) + contact.penalty.map_or(0.0, of)
    }
}

/// What is asked.
#[derive(Clone, Debug)]
pub struct Asked {
    /// Relative error that may remain.
    pub relative: f64,
    /// In which quantities.
    pub quantities: Vec<Quantity>,
    /// Most cells of a mesh that is tried.
    pub most_cells: f64,
}

impl Asked {
    /// A relative error in peak and half-width, by meshes of any size that is solved at all.
    pub fn new(relative: f64) -> Self {
        Self { relative, quantities: Quantity::ASKED.into(), most_cells: MOST[0] }
    }
}

/// What came out.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The scene with the candidates and growth of the mesh answered.
    pub scene: Scene,
    /// The mesh answered.
    pub resolution: Resolution,
    /// Its run.
    pub run: Run,
    /// What is said of each quantity.
    pub estimates: Vec<Quoted>,
    /// Why the accuracy is not met; none where it is.
    pub unmet: Option<String>,
    /// Every mesh solved, in order.
    pub tried: Vec<Tried>,
}

impl Answer {
    /// Largest estimated relative error of the quantities asked for; NaN where nothing is known.
    pub fn estimate(&self) -> f64 {
        if self.estimates.is_empty() { f64::NAN } else { largest(&self.estimates) }
    }
}

/// The estimate of one quantity of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Quoted {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// The quantity.
    pub quantity: Quantity,
    /// Estimated relative error of the mesh answered; NaN where nothing is known.
    pub relative: f64,
    /// Part of it that comes from the elements along the contact; NaN where it is not known.
    pub elements: f64,
    /// Part of it that comes from the growth away from the contact; NaN where it is not known, or was refined with them.
    pub growth: f64,
    /// What the distance to a mesh finer in both directions says of it; NaN where none was solved.
    pub check: f64,
    /// Part of it that the iteration leaves, and springs of the rule `penalty`.
    pub iteration: f64,
    /// Observed order in the element size along the contact; NaN where there is none.
    pub order: f64,
    /// Observed order in the logarithm of the growth; NaN where there is none.
    pub growth_order: f64,
}

/// One mesh that was solved.
#[derive(Clone, Debug)]
pub struct Tried {
    /// What it was solved for.
    pub purpose: &'static str,
    /// Element order.
    pub order: Order,
    /// Elements within the contact, within half of it where it has both sides; within that of fewest where there are several.
    pub elements: usize,
    /// Growth along the surface; NaN where the mesh of every body is given.
    pub growth: f64,
    /// Dofs; 0 where contact went on beyond the candidates.
    pub dofs: usize,
    /// Contact iterations.
    pub iterations: usize,
    /// What was found, contact by contact.
    pub contacts: Vec<TriedContact>,
    /// Largest estimated relative error of the quantities asked for; NaN where there is none yet.
    pub estimate: f64,
}

/// What one mesh says of one contact.
#[derive(Clone, Copy, Debug)]
pub struct TriedContact {
    /// Candidate stretch \[mm, or rad\].
    pub stretch: f64,
    /// Peak pressure \[MPa\].
    pub peak: f64,
    /// Half-width \[mm, or rad\].
    pub half_width: f64,
}

/// Largest relative error; NaN where one is.
pub(super) fn largest(quoted: &[Quoted]) -> f64 {
    quoted.iter().map(|one| one.relative).fold(0.0, larger)
}
