//! What came out: data only.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::solution::Outcome;
//! use signorini::solve::{Discretisation, Formulation};
//!
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let discretisation = Discretisation::of(Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5), resolution)?;
//! let mut formulation = Formulation::verification();
//! formulation.settings.max_iterations = 1;
//! // What ends before it converges is a result, too.
//! assert_eq!(discretisation.solve(&formulation)?.outcome, Outcome::Capped);
//! # Ok::<(), signorini::error::Error>(())
//! ```

use std::ops::Range;

use crate::error::Coordinate;

/// How an iteration ended; not converging is a result, never an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub enum Outcome {
    /// The iteration error is within the tolerance, in every contact.
    Converged,
    /// The state returned to an earlier one.
    Cycling {
        /// Iterations from one return to the next.
        period: usize,
    },
    /// The iteration error grows without end, or a number is none.
    Diverged,
    /// Another criterion than the iteration error was met, and that error is above the tolerance, or unknown.
    Stopped,
    /// The state no longer changes, and the iteration error is above the tolerance: round-off, or springs at their
    /// limit.
    Stalled,
    /// The largest number of iterations was made.
    Capped,
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Converged => f.write_str("converged"),
            Self::Cycling { period } => write!(f, "cycling (period {period})"),
            Self::Diverged => f.write_str("diverged"),
            Self::Stopped => f.write_str("stopped by its criterion, above the tolerance"),
            Self::Stalled => f.write_str("stalled"),
            Self::Capped => f.write_str("not converged"),
        }
    }
}

/// How far an answer is from the discrete solution of its own element and mesh, on the scale of that solution: of
/// several contacts the largest of each.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IterationError {
    /// `|p − p*|/p*` of the largest pressure.
    pub peak: f64,
    /// Share of the force at the wrong place, `½ Σ A |p̄ − p̄*| / Σ A p̄*` over the means of the candidate edges, and
    /// of tension, which is cut from the pressures told; of a contact that is open in the discrete solution the force
    /// that it carries over the largest force.
    pub force: f64,
    /// `|a − a*|/a*`, a the half-width by second moment, or `|c − c*|/a*` of the centre of pressure if that is larger.
    pub width: f64,
    /// `Σ F* |w − w*| / (Σ F* δ)`, δ = Σ F*/(E* t) the approach that the contact's own force makes.
    pub approach: f64,
}

impl IterationError {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self { peak: f64::NAN, force: f64::NAN, width: f64::NAN, approach: f64::NAN };
    /// There is none.
    pub const NONE: Self = Self { peak: 0.0, force: 0.0, width: 0.0, approach: 0.0 };

    /// The largest of the four; NaN if any is.
    pub fn largest(&self) -> f64 {
        largest([self.peak, self.force, self.width, self.approach])
    }

    /// The larger of each; NaN if either is.
    pub fn worse(self, other: Self) -> Self {
        Self {
            peak: larger(self.peak, other.peak),
            force: larger(self.force, other.force),
            width: larger(self.width, other.width),
            approach: larger(self.approach, other.approach),
        }
    }
}

/// Error of the last iteration in the energy norm, `‖u − u*‖²_S`, and the bound that the iteration's own forces and
/// gaps give, both over what the contact forces of the discrete solution store.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct EnergyError {
    /// The error.
    pub error: f64,
    /// Its bound.
    pub bound: f64,
}

/// Work done by an iteration: counts, not seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Work {
    /// Iterations over all load increments.
    pub iterations: usize,
    /// Factorisations of the dense system `S + K_c`.
    pub factorisations: usize,
    /// Terms of rank one by which such a factor was updated instead.
    pub updates: usize,
    /// Back-substitutions with such a factor, the refinement of each iteration included.
    pub back_substitutions: usize,
    /// Operations of all these: `m³/3` a factorisation of m rows, `2m²` an updated term and a back-substitution.
    pub operations: f64,
    /// Accelerated iterations given up for the plain one; they count as iterations.
    pub rejected: usize,
}

impl Work {
    /// Counts a factorisation of so many rows.
    pub fn count_factorisation(&mut self, rows: usize) {
        self.factorisations += 1;
        self.operations += (rows as f64).powi(3) / 3.0;
    }
}

/// The state of one contact point at the end.
#[derive(Clone, Copy, Debug, serde::Serialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Point", description = "A contact point.")
)]
pub struct PointState {
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    #[cfg_attr(feature = "schema", schemars(description = "Contact coordinate."))]
    pub position: f64,
    /// Contact pressure as reported, ≥ 0 \[MPa\].
    #[cfg_attr(feature = "schema", schemars(description = "Contact pressure."))]
    pub pressure: f64,
    /// Remaining gap `h = g − w` \[mm\].
    #[cfg_attr(feature = "schema", schemars(description = "Remaining gap."))]
    pub gap: f64,
    /// Tributary area of the modelled part \[mm²\].
    #[serde(rename = "area")]
    #[cfg_attr(feature = "schema", schemars(description = "Area that its pressure acts on."))]
    pub weight: f64,
}

impl PointState {
    /// Its mirror image on s = 0.
    pub fn mirrored(&self) -> Self {
        Self { position: -self.position, ..*self }
    }
}

/// Means over one edge at the end.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct EdgeState {
    /// Contact coordinates where it begins and ends \[mm, or rad on an arc\].
    pub ends: [f64; 2],
    /// Its area \[mm²\].
    pub weight: f64,
    /// Mean contact pressure \[MPa\].
    pub pressure: f64,
    /// Contact coordinate of the axis of revolution about which it is a ring, whose mean is `∫p r dr / ∫r dr`; none in
    /// the plane, and where the radius is the same throughout.
    #[serde(skip)]
    pub axis: Option<f64>,
}

impl EdgeState {
    /// What its mean is taken over: its area of a body of revolution, else its length.
    pub fn measure(&self) -> f64 {
        if self.axis.is_some() { self.weight } else { self.length() }
    }

    /// Length along the contact coordinate.
    pub fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// Its mirror image on s = 0.
    pub fn mirrored(&self) -> Self {
        Self { ends: [-self.ends[1], -self.ends[0]], axis: self.axis.map(|axis| 0.0 - axis), ..*self }
    }

    /// Contact coordinate of the middle.
    pub fn position(&self) -> f64 {
        0.5 * (self.ends[0] + self.ends[1])
    }
}

/// The part of a solution that belongs to one contact.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Share {
    /// Its contact points.
    pub points: Range<usize>,
    /// Its edges.
    pub edges: Range<usize>,
    /// Nodes of each of these.
    #[serde(skip)]
    pub nodes: usize,
    /// Approach that its own force makes, `Σ A p/(E* t)`: what lengths of this contact are measured by \[mm\].
    pub approach: f64,
}

/// Contact points and edge means of a solution.
#[derive(Clone, Debug, serde::Serialize)]
pub struct States {
    /// Contact points: contact by contact, in the order of the contact coordinate.
    pub points: Vec<PointState>,
    /// Means over the candidate edges.
    pub edges: Vec<EdgeState>,
}

/// The same of one contact.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Part<'a> {
    /// Contact points, in the order of the contact coordinate.
    pub points: &'a [PointState],
    /// Means over the candidate edges.
    pub edges: &'a [EdgeState],
    /// Nodes of each of these.
    #[serde(skip)]
    pub nodes: usize,
}

impl States {
    /// What belongs to a contact.
    pub fn part(&self, share: &Share) -> Part<'_> {
        Part { points: &self.points[share.points.clone()], edges: &self.edges[share.edges.clone()], nodes: share.nodes }
    }
}

/// One iteration, as recorded.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Iterated {
    /// Load increment the iteration belongs to, from 1.
    pub increment: usize,
    /// How far the iteration is from the discrete solution; unknown where that was not found.
    pub error: IterationError,
    /// What it shows without that solution.
    pub seen: Seen,
    /// Points with pressure above the tolerance times the largest pressure of their contact.
    pub active: usize,
    /// Approach \[mm\], spring force per area \[MPa\] and spring stiffness [MPa/mm] of the first contact point.
    pub first_point: [f64; 3],
}

/// What an iteration shows of itself, without the discrete solution.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Seen {
    /// The largest of `max(w − g, 0)/max |w|`, of `max(−p, 0)/max p` and of `p max(g − w, 0)/(max p max |w|)`.
    pub conditions: f64,
    /// `‖u_j − u_{j−1}‖ / ‖u_j‖` of the retained dofs; NaN of a first iteration, like what follows.
    pub displacement: f64,
    /// The largest of that, of penetration and of tension, each as above.
    pub residuals: f64,
    /// 0 where the same points carry pressure as before, 1 where others do.
    pub state: f64,
}

impl Seen {
    /// Nothing is known.
    pub const NOTHING: Self =
        Self { conditions: f64::NAN, displacement: f64::NAN, residuals: f64::NAN, state: f64::NAN };
}

/// How one load increment of several ended.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Increment {
    /// Which one, from 1.
    pub number: usize,
    /// How it ended; none follows one that did not converge.
    pub outcome: Outcome,
    /// Iterations made in it.
    pub iterations: usize,
    /// Contact points and edge means at its end.
    pub states: States,
    /// Displacements of the retained dofs at its end \[mm\].
    pub displacement: Vec<f64>,
    /// Force of the contact on the retained dofs at its end \[N\].
    pub contact_force: Vec<f64>,
}

/// Penetration of the surfaces of a contact where no contact point is.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Unseen {
    /// Where.
    #[serde(skip)]
    pub position: Coordinate,
    /// How deep \[mm\].
    pub penetration: f64,
    /// Whether it lies on a candidate edge, between its points; else beyond the candidates.
    pub is_candidate: bool,
}

/// Result of a contact iteration.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Solution {
    /// How it ended.
    pub outcome: Outcome,
    /// Contact points: contact by contact, in the order of the contact coordinate.
    pub points: Vec<PointState>,
    /// Means over the candidate edges, the same for all elements.
    pub edges: Vec<EdgeState>,
    /// Which points and edges belong to each contact of the scene.
    pub contacts: Vec<Share>,
    /// What the iteration shall end in: the discrete solution, or under the rule `penalty` that of the springs' own
    /// law; none where it was not found.
    pub target: Option<States>,
    /// The discrete solution itself, where springs of the rule `penalty` are the target.
    pub rigid: Option<States>,
    /// Error in the energy norm against the discrete solution; none without contact forces, or where that was not
    /// found.
    pub energy: Option<EnergyError>,
    /// Spring force per area of each point before the projection to p ≥ 0 \[MPa\].
    pub spring_pressures: Vec<f64>,
    /// Displacements of the retained dofs \[mm\].
    pub displacement: Vec<f64>,
    /// Force of the contact on the retained dofs, `−Σ A p b` \[N\].
    pub contact_force: Vec<f64>,
    /// What is passed over of each contact: penetrations between its points and beside them; nothing is known before it
    /// has converged.
    pub unseen: Vec<Vec<Unseen>>,
    /// Force that is none: what rounding leaves where bodies just touch \[N\].
    pub round_off: f64,
    /// Every load increment that was begun; empty where all of the load is applied at once.
    pub increments: Vec<Increment>,
    /// Every iteration.
    pub history: Vec<Iterated>,
    /// Work done.
    pub work: Work,
}

impl Solution {
    /// Whether surfaces penetrate one another between two contact points, neither of which sees it.
    pub fn meets_between_points(&self) -> bool {
        self.unseen.iter().flatten().any(|one| one.is_candidate)
    }

    /// Contact points of one contact, in the order of the contact coordinate.
    pub fn points_of(&self, contact: usize) -> &[PointState] {
        &self.points[self.contacts[contact].points.clone()]
    }

    /// All of one contact.
    pub fn part(&self, contact: usize) -> Part<'_> {
        Part { points: self.points_of(contact), edges: self.edges_of(contact), nodes: self.contacts[contact].nodes }
    }

    /// Edge means of one contact.
    pub fn edges_of(&self, contact: usize) -> &[EdgeState] {
        &self.edges[self.contacts[contact].edges.clone()]
    }

    /// Whether the iteration converged.
    pub fn converged(&self) -> bool {
        self.outcome == Outcome::Converged
    }

    /// Iteration error after the last iteration; unknown where there was none.
    pub fn error(&self) -> IterationError {
        self.history.last().map_or(IterationError::UNKNOWN, |iteration| iteration.error)
    }

    /// The discrete solution: what contact does on this mesh by this contact element, whatever the algorithm.
    pub fn discrete(&self) -> Option<&States> {
        self.rigid.as_ref().or(self.target.as_ref())
    }
}

/// The larger of two numbers; NaN if either is.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// The largest of numbers that are not negative; NaN if any is, 0 if there is none.
pub fn largest(sizes: impl IntoIterator<Item = f64>) -> f64 {
    sizes.into_iter().fold(0.0, larger)
}
