//! The principal stress difference of our disc between two plates, over that at its centre.

use crate::case::library::{Cylinder, CylinderModel};
use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::scene::Grading;
use crate::solve::{Discretisation, Formulation, Run};

/// Elements on the half-width before they are halved.
const ELEMENTS: usize = 8;
/// Growth of the elements away from the contact, and the coarsest: fringes reach far into the disc.
const GROWTH: f64 = 1.15;
const COARSEST: f64 = 0.05;
/// Newton's iterations for the place of a point in its cell, and how far outside a cell a point of its edge may seem to lie.
const ITERATIONS: usize = 12;
const MARGIN: f64 = 1e-6;

/// Stress differences at the nodes of a disc of radius 1.
pub struct Field {
    points: Vec<[f64; 2]>,
    cells: Vec<Vec<usize>>,
    stress: Vec<[f64; 3]>,
    centre: f64,
}

impl Field {
    /// The disc under the load that Hertz needs for a half-width over the radius, its mesh halved so many times.
    pub fn of(a_over_r: f64, refinement: u32) -> Result<Self, Error> {
        let disc = Cylinder { a_over_r, model: CylinderModel::BetweenPlates, ..Default::default() };
        let mut scene = disc.scene();
        scene.grading = Grading { along: GROWTH, depth: GROWTH, coarsest: COARSEST, ..scene.grading };
        let discretisation =
            Discretisation::of(scene, Resolution { elements: ELEMENTS, refinement, order: Order::Quadratic })?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let fields = discretisation.recover(&run.solution)?;
        let mesh = &discretisation.mesh;
        let points: Vec<[f64; 2]> = mesh.points.iter().map(|point| point.map(|x| x / disc.radius)).collect();
        let cells = (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect();
        let mut field = Self { points, cells, stress: fields.stress, centre: 1.0 };
        field.centre = if run.solution.converged() { field.at([0.0, 1.0]) } else { f64::NAN };
        Ok(field)
    }

    /// `(σ₁ − σ₂)` at a point `[x, z]`, z from the loaded end, over that at the centre; NaN outside the disc's lower quarter.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        self.cells.iter().find_map(|cell| self.within(cell, point)).unwrap_or(f64::NAN)
    }

    /// The same if the point lies in a cell.
    fn within(&self, cell: &[usize], point: [f64; 2]) -> Option<f64> {
        let corners = || cell.iter().map(|&node| self.points[node]);
        let outside = |k: usize| {
            let [low, high] = [
                corners().map(|p| p[k]).fold(f64::INFINITY, f64::min),
                corners().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max),
            ];
            let slack = 0.05 * (high - low);
            !(low - slack <= point[k] && point[k] <= high + slack)
        };
        if outside(0) || outside(1) {
            return None;
        }
        let place = self.place(cell, point)?;
        let mut tensor = [0.0; 3];
        for (&node, (shape, _)) in cell.iter().zip(shape_functions::cell(cell.len(), place)) {
            (0..3).for_each(|k| tensor[k] += shape * self.stress[node][k]);
        }
        let [x, y, xy] = tensor;
        Some((x - y).hypot(2.0 * xy) / self.centre)
    }

    /// Natural coordinates of a point in a cell, by Newton; none where it lies outside.
    fn place(&self, cell: &[usize], point: [f64; 2]) -> Option<[f64; 2]> {
        let mut at = [0.0; 2];
        for _ in 0..ITERATIONS {
            let (mut left, mut slope) = (point, [[0.0; 2]; 2]);
            for (&node, (shape, gradient)) in cell.iter().zip(shape_functions::cell(cell.len(), at)) {
                for i in 0..2 {
                    left[i] -= shape * self.points[node][i];
                    (0..2).for_each(|j| slope[i][j] += gradient[j] * self.points[node][i]);
                }
            }
            let determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
            at[0] += (slope[1][1] * left[0] - slope[0][1] * left[1]) / determinant;
            at[1] += (slope[0][0] * left[1] - slope[1][0] * left[0]) / determinant;
        }
        at.iter().all(|x| x.abs() <= 1.0 + MARGIN).then_some(at)
    }
}
