//! The pressures of a solution once more, from the full system without condensation.

use crate::condensation;
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::{Discretisation, Formulation};

/// κ of the springs that check the condensed solution against the full one: far stiffer than the bodies, and soft
/// enough that round-off in the approach stays below 1e-12 of the pressure.
const CHECKING_STIFFNESS: f64 = 1e3;

impl Discretisation {
    /// The spring pressures of a solution once more, from the full system without condensation \[MPa\].
    ///
    /// Every loaded point is replaced by a spring around the condensed solution, `p = p_s + k (w − w_s)`; the sparse
    /// system of all bodies then gives `w`, and with it `p`, without S having been used.
    pub fn uncondensed_pressures(&self, formulation: &Formulation, solution: &Solution) -> Result<Vec<f64>, Error> {
        let points = formulation.points(&self.interfaces);
        let stiffness = CHECKING_STIFFNESS * self.scene.contact_modulus() / self.scene.reference.length;
        let states: Vec<(f64, f64, f64)> = (solution.points.iter().zip(&points).zip(&solution.spring_pressures))
            .map(|((state, point), &p)| (point.gap - state.gap, p, if p.abs() > 0.0 { stiffness } else { 0.0 }))
            .collect();
        let springs: Vec<_> = (points.iter().zip(&states))
            .map(|(point, &(w, p, k))| ((point.weight * k, point.row.as_slice()), point.weight * (k * w - p)))
            .collect();
        let unknowns = condensation::solve_uncondensed(&self.system, &springs)?;
        let retained: Vec<f64> = (self.system.bodies.iter().zip(&unknowns))
            .flat_map(|(body, u)| u[body.dofs.retained.clone()].iter().copied())
            .collect();
        Ok((points.iter().zip(states)).map(|(point, (w, p, k))| p + k * (point.approach(&retained) - w)).collect())
    }
}
