//! A bound on the error of an iterate that needs no scale: from its own forces, gaps and penetrations, in the energy
//! norm.
//!
//! An iterate in equilibrium, `S u + Σ F b = f̂`, and the discrete solution, `S u* + Σ F* b = f̂`, differ by
//! `S (u − u*) = −Σ (F − F*) b`. With the remaining gaps `h = g − w` that is, times `u − u*`,
//!
//! `‖u − u*‖²_S = Σ (F − F*)(h − h*) = Σ F h − Σ F h* − Σ F* h`, as `F* h* = 0` at every point.
//!
//! Splitting the forces into pressing and pulling ones, `F = P − T`, and dropping what is not positive (`−P h*`, and
//! `−F* h` where `h ≥ 0`) leaves
//!
//! `‖u − u*‖²_S ≤ Σ P h + Σ F* v + Σ T (h* − h)`, `v = max(−h, 0)`.
//!
//! Without tension it asks of the solution only the total of F*, which statics give or the load bounds. It is a bound,
//! not the error: what iterations stop by is the error itself ([`target`](crate::algorithm::target)), which is known
//! here at the same price, and other than a norm of energy sees the peak and the width.

use crate::algorithm::exact::Exact;
use crate::algorithm::{ContactProblem, Iterate};
use crate::solution::EnergyError;

/// Square of the error of an iterate and the bound on it, over what the contact forces of the solution store, `Σ F* δ`;
/// none where there are no such forces.
pub fn of(problem: &ContactProblem, exact: &Exact, iterate: &Iterate) -> Option<EnergyError> {
    let away: Vec<f64> = iterate.displacement.iter().zip(&exact.iterate.displacement).map(|(u, v)| u - v).collect();
    let error: f64 = problem.stiffness.times(&away).iter().zip(&away).map(|(force, u)| force * u).sum();
    let mut own = vec![0.0; problem.compliance.len()];
    let mut bound = 0.0;
    for (i, point) in problem.points.iter().enumerate() {
        let [force, wanted] = [iterate.pressure[i], exact.iterate.pressure[i].max(0.0)].map(|p| point.weight * p);
        let gap = point.gap - iterate.approach[i];
        bound += wanted * (-gap).max(0.0);
        bound += match force {
            pressing if pressing > 0.0 => pressing * gap,
            // `h* − h` is `w − w*`, also where the gap is infinite.
            pulling => -pulling * (iterate.approach[i] - exact.iterate.approach[i]),
        };
        own[point.contact] += wanted;
    }
    let stored: f64 = own.iter().zip(&problem.compliance).map(|(force, compliance)| force * force * compliance).sum();
    (stored > 0.0).then(|| EnergyError { error: error / stored, bound: bound / stored })
}
