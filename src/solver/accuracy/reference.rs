//! Reference answers: numbers of a contact to five digits, by cells of high order fitted to it, on several meshes whose differences bound
//! the error.

use rayon::prelude::*;
use serde::Serialize;

use crate::accuracy::Quantity;
use crate::error::Error;
use crate::measure::{display_factor, larger};
use crate::mesh::{Order, Resolution};
use crate::scene::{Path, Scene};
use crate::solve::{Discretisation, Fitted, Formulation, Run};

/// A mesh: order and layers, and cells on each piece of the contact side.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// Order and layers.
    pub fitted: Fitted,
    /// Cells on each piece of the contact side, between its ends.
    pub cells: usize,
}

impl Mesh {
    const fn of(order: Order, layers: usize, cells: usize) -> Self {
        Self { fitted: Fitted { order, layers }, cells }
    }
}

/// The mesh whose numbers are the answer; then one of another order, one with fewer layers, and one of other cells.
pub const MESHES: [Mesh; 4] = [
    Mesh::of(Order::Octic, 5, 3),
    Mesh::of(Order::Septic, 5, 3),
    Mesh::of(Order::Octic, 4, 3),
    Mesh::of(Order::Octic, 5, 2),
];
/// Move of an end, over the half-width, at which it is at rest.
const AT_REST: f64 = 1e-6;
/// Bound over the largest difference to another mesh.
const FACTOR: f64 = 2.0;
/// Part of a number's scale that rounding may leave.
const ROUND_OFF: f64 = 1e-8;

/// What is known of a scene.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Its numbers.
    pub known: Vec<Known>,
    /// Degrees of freedom of the meshes.
    pub dofs: [usize; 4],
}

/// A number that is known, in our units: mm, MPa, N, rad.
#[derive(Clone, Debug, Serialize)]
pub struct Known {
    /// What it is.
    pub measured: Measured,
    /// Its value.
    pub value: f64,
    /// How far it may be off.
    pub bound: f64,
    /// What it is small or large against: itself, or for places the half-width.
    pub scale: f64,
    /// What the other meshes say.
    pub others: [f64; 3],
}

/// What is measured of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Measured {
    /// Pressure at s = 0.
    Origin,
    /// Largest pressure.
    Peak,
    /// Where that is.
    Place,
    /// Second-moment width.
    SecondMomentWidth,
    /// Where the contact ends.
    End,
    /// Force of the whole contact.
    Resultant,
    /// Force across the load of one half of the contact.
    Across,
}

impl Known {
    /// The same in a unit, by the factor from ours to it.
    pub fn times(&self, factor: f64) -> Self {
        let [value, bound, scale] = [self.value, self.bound, self.scale].map(|own| factor * own);
        Self { value, bound, scale, others: self.others.map(|other| factor * other), ..*self }
    }
}

impl Measured {
    const ALL: [Self; 7] =
        [Self::Origin, Self::Peak, Self::Place, Self::SecondMomentWidth, Self::End, Self::Resultant, Self::Across];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Origin => "pressure at s = 0",
            Self::Peak => "peak-pressure",
            Self::Place => "peak-place",
            Self::SecondMomentWidth => "second-moment-width",
            Self::End => "end",
            Self::Resultant => "resultant",
            Self::Across => "force across the load, of one half",
        }
    }

    /// The same with an error bar on any mesh.
    pub fn quantity(self) -> Option<Quantity> {
        match self {
            Self::Peak => Some(Quantity::PeakPressure),
            Self::Place => Some(Quantity::PeakPlace),
            Self::SecondMomentWidth => Some(Quantity::SecondMomentWidth),
            Self::End => Some(Quantity::End(0)),
            Self::Resultant => Some(Quantity::Resultant),
            Self::Origin | Self::Across => None,
        }
    }

    /// Unit that it is shown in on a path, and the factor from ours to that.
    pub fn unit(self, path: &Path) -> (&'static str, f64) {
        let factor = display_factor(path);
        match self {
            Self::Origin | Self::Peak => ("MPa", 1.0),
            Self::Resultant | Self::Across => ("N", 1.0),
            Self::Place | Self::SecondMomentWidth | Self::End if factor > 1.0 => ("°", factor),
            Self::Place | Self::SecondMomentWidth | Self::End => ("mm", 1.0),
        }
    }

    /// Its value in a run, whose contact ends at a place that is known better than from its pressures.
    fn of(self, run: &Run, end: f64) -> f64 {
        let measures = run.measures();
        match self {
            _ if !run.solution.converged() => f64::NAN,
            Self::Origin => measures.pressure_at_origin,
            Self::Peak => measures.peak.pressure,
            Self::Place => measures.peak.position,
            Self::SecondMomentWidth => measures.second_moment_width,
            Self::End => end,
            Self::Resultant => measures.resultant,
            // On an arc, whose coordinate is the angle from the load line.
            Self::Across => {
                run.solution.points_of(0).iter().map(|one| one.pressure * one.weight * one.position.sin()).sum()
            }
        }
    }
}

/// The numbers of the first contact of a scene; refused where no mesh can be fitted to it.
pub fn answer(scene: &Scene) -> Result<Answer, Error> {
    let formulation = Formulation::verification();
    let solved = MESHES.into_par_iter().map(|Mesh { fitted, cells }| {
        let answer = fitted.solve_with_ends(scene, &formulation, AT_REST)?;
        let end = answer.stretches[0].last().map_or(f64::NAN, |stretch| stretch[1]);
        let resolution = Resolution { elements: cells, refinement: 0, order: fitted.order };
        Ok((Run::of(&Discretisation::of(answer.discretisation.scene, resolution)?, &formulation)?, end))
    });
    let solved = solved.collect::<Result<Vec<(Run, f64)>, Error>>()?;
    let half_width = solved[0].0.measures().second_moment_width;
    let known = |measured: Measured| {
        let [value, a, b, c] = [0, 1, 2, 3].map(|mesh| measured.of(&solved[mesh].0, solved[mesh].1));
        let scale = if measured == Measured::Place { half_width } else { value.abs() };
        let apart = [a, b, c].into_iter().map(|other| (other - value).abs()).fold(0.0, larger);
        Known { measured, value, bound: FACTOR * apart + ROUND_OFF * scale, scale, others: [a, b, c] }
    };
    let straight = scene.contacts[0].path.is_straight();
    let there = Measured::ALL.into_iter().filter(|one| *one != Measured::Across || !straight);
    Ok(Answer { known: there.map(known).collect(), dofs: [0, 1, 2, 3].map(|mesh| solved[mesh].0.dofs) })
}
