//! Fringe orders of our disc between two plates: its principal stress difference, and the constants that are fitted to
//! a photograph.

use crate::case::library::{Cylinder, CylinderModel};
use crate::elasticity::{point, shape_functions};
use crate::error::Error;
use crate::mesh::{Mesh, Order, Resolution};
use crate::oracle::digitised::fringes::{Channel, Fringe};
use crate::scene::Grading;
use crate::solve::{Discretisation, Formulation, Run};

/// Elements on the half-width before they are halved.
const ELEMENTS: usize = 8;
/// Growth of the elements away from the contact, and the coarsest: fringes reach far into the disc.
const GROWTH: f64 = 1.15;
const COARSEST: f64 = 0.05;
/// How far around its nodes a cell is looked into, over its size: its edges are curved.
const SLACK: f64 = 0.05;

/// Stresses at the nodes of our disc.
pub struct Field {
    mesh: Mesh,
    /// Lowest and highest coordinates of each cell.
    boxes: Vec<[[f64; 2]; 2]>,
    stress: Vec<[f64; 3]>,
    radius: f64,
    centre: f64,
}

impl Field {
    /// The disc under the load that Hertz needs for a half-width over the radius, its mesh halved so many times.
    pub fn of(a_over_r: f64, refinement: u32) -> Result<Self, Error> {
        let disc = Cylinder { a_over_r, model: CylinderModel::BetweenPlates, ..Default::default() };
        let mut scene = disc.scene();
        scene.grading = Grading { along: GROWTH, depth: GROWTH, coarsest: COARSEST, ..scene.grading };
        let resolution = Resolution { elements: ELEMENTS, refinement, order: Order::Quadratic };
        let discretisation = Discretisation::of(scene, resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let stress = discretisation.recover(&run.solution)?.stress;
        let mesh = discretisation.mesh;
        let around = |cell: usize| {
            let sides = [0, 1].map(|k| {
                let of = || mesh.cell(cell).iter().map(|&node| mesh.points[node][k]);
                let (low, high) = (of().fold(f64::INFINITY, f64::min), of().fold(f64::NEG_INFINITY, f64::max));
                [low - SLACK * (high - low), high + SLACK * (high - low)]
            });
            [0, 1].map(|end| sides.map(|side| side[end]))
        };
        let boxes = (0..mesh.cells()).map(around).collect();
        let mut field = Self { boxes, stress, radius: disc.radius, centre: 1.0, mesh };
        field.centre = if run.solution.converged() { field.at([0.0, 1.0]) } else { f64::NAN };
        Ok(field)
    }

    /// `(σ₁ − σ₂)` at a point `[x, z]` over the radius, z from the loaded end, over that at the centre; NaN outside the
    /// disc's lower quarter.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        let at = point.map(|x| self.radius * x);
        let holds = |[low, high]: &[[f64; 2]; 2]| (0..2).all(|k| low[k] <= at[k] && at[k] <= high[k]);
        let near = self.boxes.iter().enumerate().filter(|(_, around)| holds(around)).filter_map(|(cell, _)| {
            let (natural, outside) = point::natural(&self.mesh, cell, at)?;
            Some((outside, cell, natural))
        });
        let Some((_, cell, natural)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) else { return f64::NAN };
        let nodes = self.mesh.cell(cell);
        let mut tensor = [0.0; 3];
        for (&node, (shape, _)) in nodes.iter().zip(shape_functions::cell(nodes.len(), natural)) {
            (0..3).for_each(|k| tensor[k] += shape * self.stress[node][k]);
        }
        let [x, y, xy] = tensor;
        (x - y).hypot(2.0 * xy) / self.centre
    }
}

/// Places of the loaded edge that are tried, over the radius.
const EDGE: [f64; 2] = [-0.03, 0.05];
/// Part of an interval that golden sections leave.
const GOLDEN: f64 = 0.618_033_988_749_895;
const SECTIONS: usize = 28;

/// Constants of a field that are fitted to fringes.
#[derive(Clone, Copy, Debug)]
pub struct Constants {
    /// Fringe order at the centre of the disc, by channel.
    pub orders: [f64; 3],
    /// How far the loaded edge lies above the end of the diameter in the picture, over the radius.
    pub edge: f64,
}

impl Constants {
    /// Constants with the least sum of squares, and that.
    pub fn fitted(field: &Field, fringes: &[Fringe]) -> (Self, f64) {
        let of = |edge: f64| {
            let found: Vec<f64> =
                fringes.iter().map(|fringe| field.at([fringe.half_spacing, fringe.depth + edge])).collect();
            // `N_c = Σ f N / Σ f²` over the fringes of each channel.
            let orders = Channel::ALL.map(|channel| {
                let own = fringes.iter().zip(&found).filter(|(fringe, _)| fringe.channel == channel);
                let sums = own.fold([0.0; 2], |[above, below], (fringe, f)| [above + f * fringe.order, below + f * f]);
                sums[0] / sums[1]
            });
            let residual = |(fringe, f): (&Fringe, &f64)| orders[fringe.channel as usize] * f - fringe.order;
            (Self { orders, edge }, fringes.iter().zip(&found).map(|one| residual(one).powi(2)).sum::<f64>())
        };
        let edge = golden(EDGE, |edge| of(edge).1);
        of(edge)
    }

    /// Computed order less the measured one.
    pub fn residual(&self, field: &Field, fringe: &Fringe) -> f64 {
        self.order_at(field, fringe.channel, [fringe.half_spacing, fringe.depth]) - fringe.order
    }

    /// Computed order of a channel at `[x, z]` of the picture.
    pub fn order_at(&self, field: &Field, channel: Channel, [x, z]: [f64; 2]) -> f64 {
        self.orders[channel as usize] * field.at([x, z + self.edge])
    }

    /// Root mean square of the residuals.
    pub fn rms(&self, field: &Field, fringes: &[Fringe]) -> f64 {
        let squares = fringes.iter().map(|fringe| self.residual(field, fringe).powi(2));
        (squares.sum::<f64>() / fringes.len() as f64).sqrt()
    }
}

/// Where a function of one minimum is least.
fn golden([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let [mut left, mut right] = inner(low, high);
    let [mut at_left, mut at_right] = [of(left), of(right)];
    for _ in 0..SECTIONS {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = inner(low, high)[0];
            at_left = of(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = inner(low, high)[1];
            at_right = of(right);
        }
    }
    0.5 * (low + high)
}
