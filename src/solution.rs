//! What came out: data only.

use std::ops::Range;

/// How an iteration ended; not converging is a result, never an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All residuals are within the tolerance.
    Converged,
    /// The state returned to an earlier one.
    Cycling {
        /// Steps from one return to the next.
        period: usize,
    },
    /// A residual exceeded 1e6 or is not a number.
    Diverged,
    /// The largest number of steps was made.
    Exhausted,
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Converged => f.write_str("converged"),
            Self::Cycling { period } => write!(f, "cycling (period {period})"),
            Self::Diverged => f.write_str("diverged"),
            Self::Exhausted => f.write_str("exhausted"),
        }
    }
}

/// Violations of the contact conditions and of equilibrium by the pressures as reported, as pure numbers.
#[derive(Clone, Copy, Debug)]
pub struct Residuals {
    /// `max (w − g)⁺ / g_ref`.
    pub penetration: f64,
    /// `max (−p)⁺ / p_ref`.
    pub tension: f64,
    /// `max min(p/p_ref, h/g_ref)⁺`.
    pub complementarity: f64,
    /// `‖f̂ − S u − Σ A p⁺ b‖₁ / max(Σ A p⁺, ‖f̂‖₁)`.
    pub balance: f64,
}

impl Residuals {
    /// The largest of the four; NaN if any is.
    pub fn largest(&self) -> f64 {
        let all = [self.penetration, self.tension, self.complementarity, self.balance];
        if all.iter().any(|r| r.is_nan()) { f64::NAN } else { all.into_iter().fold(0.0, f64::max) }
    }
}

/// Work done by an iteration: counts, not seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Iteration steps over all load increments.
    pub steps: usize,
    /// Factorisations of the dense system `S + K_c`.
    pub factorisations: usize,
    /// Terms of rank one by which such a factor was updated instead.
    pub updates: usize,
    /// Back-substitutions with such a factor, the refinement of each step included.
    pub back_substitutions: usize,
    /// Operations of all these: `m³/3` a factorisation of m rows, `2m²` an updated term and a back-substitution.
    pub operations: f64,
    /// Accelerated steps given up for the plain one; they count as steps.
    pub rejected: usize,
}

impl Work {
    /// Counts a factorisation of so many rows.
    pub fn count_factorisation(&mut self, rows: usize) {
        self.factorisations += 1;
        self.operations += (rows as f64).powi(3) / 3.0;
    }
}

/// The state of one contact point, or the mean over one edge, at the end.
#[derive(Clone, Copy, Debug)]
pub struct PointState {
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    pub position: f64,
    /// Tributary area of the modelled part \[mm²\].
    pub weight: f64,
    /// Contact pressure as reported, ≥ 0 \[MPa\].
    pub pressure: f64,
    /// Remaining gap `h = g − w` \[mm\].
    pub gap: f64,
}

/// The part of a solution that belongs to one contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// Its contact points.
    pub points: Range<usize>,
    /// Its edges.
    pub edges: Range<usize>,
}

/// One step of the iteration, as recorded.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Load increment the step belongs to, from 1.
    pub increment: usize,
    /// Residuals after the step.
    pub residuals: Residuals,
    /// Points with pressure above `tolerance · p_ref`.
    pub active: usize,
    /// Approach \[mm\], spring force per area \[MPa\] and spring stiffness [MPa/mm] of the first contact point.
    pub first_point: [f64; 3],
}

/// Result of a contact iteration.
#[derive(Clone, Debug)]
pub struct Solution {
    /// How it ended.
    pub outcome: Outcome,
    /// Contact points: contact by contact, in the order of the contact coordinate.
    pub points: Vec<PointState>,
    /// Means over the candidate edges, the same for all elements: position of the middle, area, mean pressure and gap.
    pub edges: Vec<PointState>,
    /// Which points and edges belong to each contact of the scene.
    pub contacts: Vec<Share>,
    /// Spring force per area of each point before the projection to p ≥ 0 \[MPa\].
    pub spring_pressures: Vec<f64>,
    /// Displacements of the retained freedoms \[mm\].
    pub displacement: Vec<f64>,
    /// Force of the contact on the retained freedoms, `−Σ A p b` \[N\].
    pub contact_force: Vec<f64>,
    /// Every step.
    pub history: Vec<Step>,
    /// Work done.
    pub work: Work,
    /// Work done on coarser meshes to find the start.
    pub coarser: Work,
}

impl Solution {
    /// Contact points of one contact, in the order of the contact coordinate.
    pub fn points_of(&self, contact: usize) -> &[PointState] {
        &self.points[self.contacts[contact].points.clone()]
    }

    /// Edge means of one contact.
    pub fn edges_of(&self, contact: usize) -> &[PointState] {
        &self.edges[self.contacts[contact].edges.clone()]
    }

    /// Whether the iteration converged.
    pub fn converged(&self) -> bool {
        self.outcome == Outcome::Converged
    }

    /// Largest residual after the last step; NaN where there was none.
    pub fn residual(&self) -> f64 {
        self.history.last().map_or(f64::NAN, |step| step.residuals.largest())
    }
}
