//! Truncated Hertz under several loads, on fitted meshes and on 8-node cells that know nothing of the contact.

use rayon::prelude::*;
use serde::Serialize;

use crate::accuracy;
use crate::case::library::TruncatedHertz;
use crate::error::Error;
use crate::measure::{larger, relative_error};
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Fitted, Formulation, Run};
use crate::study::fitted::scenes::{self, Elsewhere};

/// Half-widths of the loads over that which block and candidates are drawn for.
pub const LOADS: [f64; 8] = [1.0, 0.97, 0.94, 0.91, 0.89, 0.88, 0.87, 0.85];

/// Part of a number that rounding decides.
const ROUND_OFF: f64 = 1e-9;

/// All meshes.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Fitted to the contact.
    pub fitted: Vec<Mesh>,
    /// Meshes that an accuracy chooses.
    pub chosen: Vec<Mesh>,
    /// 8-node cells, as fine on all candidates.
    pub plain: Vec<Mesh>,
    /// Other scenes.
    pub scenes: Vec<Elsewhere>,
}

/// A mesh, and what it gives under the worst of all loads.
#[derive(Clone, Debug, Serialize)]
pub struct Mesh {
    /// What it is made of.
    pub cells: Cells,
    /// Degrees of freedom, the most under any load.
    pub dofs: usize,
    /// Those of all meshes that were solved on the way, with its own.
    pub in_all: usize,
    /// Relative error of the peak pressure.
    pub peak: f64,
    /// Relative error of the second-moment width.
    pub half_width: f64,
}

/// The cells of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Cells {
    /// Fitted to the contact.
    Fitted(Fitted),
    /// What an accuracy chooses by error bars: a relative error.
    Chosen(f64),
    /// 8-node cells, so many on the half-width that the block is drawn for.
    Plain(usize),
}

impl Mesh {
    /// The larger error of peak and second-moment width; NaN where either is.
    pub fn error(&self) -> f64 {
        larger(self.peak, self.half_width)
    }

    /// The worse of two loads.
    fn worse(self, other: Self) -> Self {
        Self {
            cells: self.cells,
            dofs: self.dofs.max(other.dofs),
            in_all: self.in_all.max(other.in_all),
            peak: larger(self.peak, other.peak),
            half_width: larger(self.half_width, other.half_width),
        }
    }
}

/// The block and its candidates under a load of another half-width than they are drawn for.
pub fn under(factor: f64) -> TruncatedHertz {
    let drawn = TruncatedHertz::default();
    TruncatedHertz {
        a_over_r: factor * drawn.a_over_r,
        size: drawn.size / factor,
        stretch: drawn.stretch / factor,
        ..drawn
    }
}

/// All meshes under all loads.
pub fn numbers(fitted: &[Fitted], chosen: &[f64], plain: &[usize]) -> Result<Numbers, Error> {
    let fitted = fitted.iter().map(|&one| worst(Cells::Fitted(one))).collect::<Result<_, _>>()?;
    let chosen = chosen.iter().map(|&asked| worst(Cells::Chosen(asked))).collect::<Result<_, _>>()?;
    let plain = plain.iter().map(|&elements| worst(Cells::Plain(elements))).collect::<Result<_, _>>()?;
    Ok(Numbers { fitted, chosen, plain, scenes: scenes::numbers()? })
}

/// A mesh under the worst of all loads.
fn worst(cells: Cells) -> Result<Mesh, Error> {
    let all = LOADS.into_par_iter().map(|factor| solved(cells, factor)).collect::<Result<Vec<Mesh>, Error>>()?;
    let nothing = Mesh { cells, dofs: 0, in_all: 0, peak: 0.0, half_width: 0.0 };
    Ok(all.into_iter().fold(nothing, Mesh::worse))
}

/// A mesh under one load.
fn solved(cells: Cells, factor: f64) -> Result<Mesh, Error> {
    let (numbers, formulation) = (under(factor), Formulation::verification());
    let (run, in_all) = match cells {
        Cells::Fitted(fitted) => {
            let answer = fitted.solve(&numbers.scene(), &formulation)?;
            let in_all = answer.tried.iter().map(|one| one.dofs).sum();
            (answer.run, in_all)
        }
        Cells::Chosen(asked) => {
            let answer = accuracy::solve(&numbers.scene(), &formulation, &accuracy::Asked::new(asked))?;
            let in_all = answer.dofs_in_all();
            (answer.run, in_all)
        }
        Cells::Plain(elements) => {
            let drawn = numbers.case();
            let times = elements as f64 / drawn.resolution.elements as f64;
            let mut scene = drawn.scene;
            // The mesh does not know the load: it is the same under all.
            scene.grading.unit = TruncatedHertz::default().half_width();
            scene.grading = Order::Quadratic.refined(&scene.grading, times);
            let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
            let run = Run::of(&Discretisation::of(scene, resolution)?, &formulation)?;
            let dofs = run.dofs;
            (run, dofs)
        }
    };
    let hertz = numbers.closed_form();
    let error = |value: f64, truth: f64| match run.solution.converged() {
        true => (relative_error(value, truth) / ROUND_OFF).round() * ROUND_OFF,
        false => f64::NAN,
    };
    let measures = run.measures();
    let peak = error(measures.peak.pressure, hertz.peak_pressure());
    let half_width = error(measures.second_moment_width, hertz.half_width());
    Ok(Mesh { cells, dofs: run.dofs, in_all, peak, half_width })
}
