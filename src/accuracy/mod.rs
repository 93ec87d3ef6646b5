//! The cheapest mesh that meets an accuracy asked, found from coarse to fine.
//!
//! * [`estimate`] — Richardson with the observed order as a check.
//! * [`ends`] — where the contact found so far begins and ends.
//! * [`fitted`] — meshes fitted to it.
//! * [`mod@longest`] — how far candidates may go.
//! * `rungs` — the meshes of a search, each solved from the contact set of the one before.
//! * `along` — the ladder along the contact: more and more elements on one growth.
//! * `depth` — the ladder of growth: gentler and gentler on one surface mesh.
//! * `confirmed` — the last word on a mesh: one finer in both directions.
//! * `halved` — bodies that bring their mesh, and several contacts: all of the mesh halved again and again.
//! * `sizes` — sizes of elements where there are several contacts.
//! * `slow` — the mesh chosen by kinematic load, and run by another algorithm.
//! * [`search`] — which meshes are solved, and which one is answered.
//!
//! Refining the elements along the contact alone does not show what the growth away from it leaves: on truncated Hertz a
//! growth of 4 leaves 0.3 % however many elements there are. So there are two ladders, and the error of a mesh is the sum
//! of what both say of it, and no less than what one mesh finer in both directions says. Meshes finer than the one
//! answered are solved for the estimate only; they are part of the cost.
//!
//! Cells have 8 nodes: of the hand-made meshes of the study only that of the small cylinder at 1 % has 4-node cells, with 315
//! freedoms against 363; at 0.3 % they need about twice the freedoms, and none of up to 12 elements per half-width meets
//! 0.1 %.

mod along;
mod confirmed;
mod depth;
pub mod ends;
pub mod estimate;
pub mod fitted;
mod halved;
pub mod longest;
mod rungs;
pub mod search;
mod sizes;
mod slow;

use crate::mesh::size::MOST;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::{Contact, Run};

pub use search::{first, solve};

/// Smallest and largest relative error that may be asked for.
pub const RANGE: [f64; 2] = [1e-5, 0.2];

/// A relative error from a percentage, as users write it: `0.1 %`; none where it is no percentage within [`RANGE`].
pub fn percentage(text: &str) -> Option<f64> {
    let number = text.trim().strip_suffix('%')?.trim().parse::<f64>().ok()?;
    let [least, most] = RANGE;
    Some(0.01 * number).filter(|error| *error >= least * (1.0 - 1e-9) && *error <= most * (1.0 + 1e-9))
}

/// What to give instead of something else.
pub fn remedy() -> String {
    let [least, most] = RANGE.map(|error| 100.0 * error);
    format!("give a percentage between {least} % and {most} %, such as \"0.1 %\"")
}

/// A quantity that shall be accurate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Peak pressure.
    PeakPressure,
    /// Half-width by second moment; on arcs the same functional of the angle.
    HalfWidth,
}

impl Quantity {
    /// Both.
    pub const ALL: [Self; 2] = [Self::PeakPressure, Self::HalfWidth];

    /// Name in scene files and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::PeakPressure => "peak-pressure",
            Self::HalfWidth => "half-width",
        }
    }

    /// Its value in a contact [MPa; mm or rad].
    pub fn of(self, contact: &Contact) -> f64 {
        match self {
            Self::PeakPressure => contact.measures.peak.pressure,
            Self::HalfWidth => contact.measures.half_width,
        }
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
        Self { relative, quantities: Quantity::ALL.into(), most_cells: MOST[0] }
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
        if self.estimates.is_empty() { f64::NAN } else { depth::largest(&self.estimates) }
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
    /// Growth along the surface; NaN where every body brings its mesh.
    pub growth: f64,
    /// Freedoms; 0 where contact went on beyond the candidates.
    pub freedoms: usize,
    /// Steps of the iteration.
    pub steps: usize,
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
