//! Reference answers: numbers of a contact to five digits, by cells of high order fitted to it, on several meshes whose
//! differences give their bars.

use rayon::prelude::*;

use crate::error::Error;
use crate::measure::{Quantity, larger};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::{Discretisation, Fitted, Formulation, Run};

/// The mesh whose numbers are the answer; then one of another order, one with fewer layers, and one of other cells on
/// each piece of the contact side, between its ends.
pub const MESHES: [(Fitted, usize); 4] = [
    (Fitted::of(Order::Octic, 5), 3),
    (Fitted::of(Order::Septic, 5), 3),
    (Fitted::of(Order::Octic, 4), 3),
    (Fitted::of(Order::Octic, 5), 2),
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
    /// The run on the first of them.
    pub run: Run,
}

/// A number that is known, in our units: mm, MPa, N, rad.
#[derive(Clone, Debug)]
pub struct Known {
    /// What it is.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// How far it may be off.
    pub bar: f64,
    /// What it is small or large against: itself, or for places the half-width.
    pub scale: f64,
    /// What the other meshes say.
    pub others: [f64; 3],
}

impl Known {
    /// The same in a unit, by the factor from ours to it.
    pub fn times(&self, factor: f64) -> Self {
        let [value, bar, scale] = [self.value, self.bar, self.scale].map(|own| factor * own);
        let others = self.others.map(|other| factor * other);
        Self { quantity: self.quantity.clone(), value, bar, scale, others }
    }
}

/// The numbers that are known: those of a contact, the approach where it is defined, and on an arc the force across the
/// load.
const NUMBERS: [Quantity; 9] = [
    Quantity::Pressure { at: 0.0 },
    Quantity::PeakPressure,
    Quantity::PeakPlace,
    Quantity::HalfWidth,
    Quantity::SecondMomentWidth,
    Quantity::End(0),
    Quantity::Resultant,
    Quantity::Approach,
    Quantity::Across,
];

/// A number of a run whose contact begins and ends at places that are known better than from its pressures.
fn value(on: &Discretisation, run: &Run, [begin, end]: [f64; 2], quantity: &Quantity) -> Result<f64, Error> {
    let measures = run.measures();
    Ok(match quantity {
        _ if !run.solution.converged() => f64::NAN,
        Quantity::Pressure { .. } => measures.pressure_at_origin,
        Quantity::HalfWidth if measures.across || begin > 0.0 => 0.5 * (end - begin),
        Quantity::HalfWidth | Quantity::End(_) => end,
        Quantity::Across | Quantity::Approach => on.number(run, 0, quantity)?,
        of_pressures => of_pressures.of(measures),
    })
}

/// The numbers of the first contact of a scene; refused where no mesh can be fitted to it.
pub fn answer(scene: &Scene) -> Result<Answer, Error> {
    let formulation = Formulation::verification();
    let on_arc = !scene.contacts[0].path.is_straight();
    let is_defined = |quantity: &&Quantity| match quantity {
        Quantity::Across => on_arc,
        Quantity::Approach => scene.pressed_sides(0).is_some(),
        _ => true,
    };
    let numbers: Vec<&Quantity> = NUMBERS.iter().filter(is_defined).collect();
    let solved = MESHES.into_par_iter().map(|(fitted, cells)| {
        let answer = fitted.solve_with_ends(scene, &formulation, AT_REST)?;
        let [first, last] = [answer.stretches[0].first(), answer.stretches[0].last()];
        let ends = [first.map_or(f64::NAN, |first| first[0]), last.map_or(f64::NAN, |last| last[1])];
        let resolution = Resolution { elements: cells, refinement: 0, order: fitted.order };
        let mesh = Discretisation::of(answer.discretisation.scene, resolution)?;
        let run = Run::of(&mesh, &formulation)?;
        let values =
            numbers.iter().map(|&quantity| value(&mesh, &run, ends, quantity)).collect::<Result<_, Error>>()?;
        Ok((values, run))
    });
    let mut solved = solved.collect::<Result<Vec<(Vec<f64>, Run)>, Error>>()?;
    let half_width = solved[0].1.measures().second_moment_width;
    let known = |(k, &quantity): (usize, &&Quantity)| {
        let [value, a, b, c] = [0, 1, 2, 3].map(|mesh| solved[mesh].0[k]);
        let scale = if *quantity == Quantity::PeakPlace { half_width } else { value.abs() };
        let apart = [a, b, c].into_iter().map(|other| (other - value).abs()).fold(0.0, larger);
        Known { quantity: quantity.clone(), value, bar: FACTOR * apart + ROUND_OFF * scale, scale, others: [a, b, c] }
    };
    let dofs = [0, 1, 2, 3].map(|mesh| solved[mesh].1.dofs);
    let known = numbers.iter().enumerate().map(known).collect();
    Ok(Answer { known, dofs, run: solved.swap_remove(0).1 })
}
