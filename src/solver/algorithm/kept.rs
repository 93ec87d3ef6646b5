//! The factor of a system of which a few springs switch from one iteration to the next: it is updated.
//!
//! [`settling`](crate::algorithm::settling) keeps the factor of the same matrix `S + Σ A k bᵀb` for another kind of
//! change. Under kinematic load a handful of springs opens or closes at an iteration, anywhere along the edges of the
//! contact, and which ones come next is not known: a term of rank one each is cheapest. With varying stiffness every
//! closed spring moves at every iteration, far too many for such terms, but those that have come to rest stay there:
//! what pays is to eliminate their rows once. Neither way does the other's work, and constant stiffness needs no more
//! than the factor itself.

use crate::algorithm::ContactProblem;
use crate::condensation::dense::RankOne;
use crate::condensation::stiffness::SystemFactor;
use crate::solution::Work;

/// Systems from this size on are updated where few springs change. A term costs 2 m² operations against m³/3 of a
/// factorisation, though slower ones; below, the small matrix is as quickly factorised.
const PAYS_FROM: usize = 256;
/// Springs that may change, as a fraction of the size.
const FEW: usize = 32;

/// The last factor of `S + Σ A k bᵀb` and the springs it belongs to.
#[derive(Clone, Debug, Default)]
pub struct KeptFactor {
    factor: Option<SystemFactor>,
    stiffness: Vec<f64>,
}

impl KeptFactor {
    /// The factor for some springs: the last one updated where few springs have changed, else a new one in its memory;
    /// none where `S + K_c` is not positive definite.
    ///
    /// Opening a hard spring takes `1e6` times the diagonal off again and costs as many digits, which the refinement of
    /// the equilibrium returns.
    pub fn renew(&mut self, problem: &ContactProblem, stiffness: &[f64], work: &mut Work) -> Option<&SystemFactor> {
        let updated = self.updated(problem, stiffness, work);
        self.factor = match updated {
            Some(factor) => Some(factor),
            None => problem.factorise_in(self.factor.take(), stiffness, work),
        };
        self.stiffness.clear();
        self.stiffness.extend_from_slice(stiffness);
        self.factor.as_ref()
    }

    fn updated(&mut self, problem: &ContactProblem, stiffness: &[f64], work: &mut Work) -> Option<SystemFactor> {
        let m = problem.load.len();
        if m < PAYS_FROM || !problem.stiffness.is_dense() || self.stiffness.len() != stiffness.len() {
            return None;
        }
        let changed = changed(&self.stiffness, stiffness);
        let closed = stiffness.iter().filter(|k| **k > 0.0).count();
        if changed.len() * FEW > m || closed <= changed.len() {
            return None;
        }
        let change = |&i: &usize| -> RankOne {
            let point = &problem.points[i];
            (point.weight * (stiffness[i] - self.stiffness[i]), &point.row)
        };
        let changes: Vec<RankOne> = changed.iter().map(change).collect();
        let Some(SystemFactor::Dense(factor)) = self.factor.take() else { return None };
        let factor = SystemFactor::Dense(factor.updated(&changes)?);
        work.updates += changes.len();
        work.operations += 2.0 * changes.len() as f64 * (m as f64).powi(2);
        Some(factor)
    }
}

/// Springs that are not what they were; all where there were none before.
pub(super) fn changed(before: &[f64], after: &[f64]) -> Vec<usize> {
    let same = |i: usize| before.get(i).is_some_and(|before| (after[i] - before).abs() <= 0.0);
    (0..after.len()).filter(|&i| !same(i)).collect()
}
