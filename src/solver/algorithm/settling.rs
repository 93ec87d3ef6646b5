//! The factor of a system whose springs come to rest one by one: rows without a moving spring are eliminated once.
//!
//! Why it stands beside [`kept`](crate::algorithm::kept) is told there.

use crate::algorithm::ContactProblem;
use crate::algorithm::kept::changed;
use crate::condensation::dense::RankOne;
use crate::condensation::stiffness::SystemFactor;
use crate::condensation::trailing::Trailing;
use crate::solution::Work;

/// Systems from this size on are split; smaller ones are as quickly factorised.
const PAYS_FROM: usize = 128;
/// Springs that may still move for a split to pay, as a share of those that moved before.
const FEWER: f64 = 0.95;

/// The last factor of `S + Σ A k bᵀb` and the springs it belongs to.
#[derive(Clone, Debug, Default)]
pub struct Settling {
    /// With the springs that may move where it is split.
    kept: Option<(SystemFactor, Vec<usize>)>,
    stiffness: Vec<f64>,
}

impl Settling {
    /// The factor for some springs: only of the rows whose springs still move, where all others stand as they stood;
    /// none where `S + K_c` is not positive definite.
    pub fn renew(&mut self, problem: &ContactProblem, stiffness: &[f64], work: &mut Work) -> Option<&SystemFactor> {
        let moved = changed(&self.stiffness, stiffness);
        self.stiffness.clear();
        self.stiffness.extend_from_slice(stiffness);
        let kept = self.kept.take();
        let could_move = match &kept {
            Some((SystemFactor::Trailing(_), moving)) => moving.len(),
            _ => stiffness.len(),
        };
        let is_large = problem.load.len() >= PAYS_FROM && problem.stiffness.is_dense();
        let pays = is_large && moved.len() as f64 <= FEWER * could_move as f64;
        self.kept = Some(match kept {
            Some((SystemFactor::Trailing(mut part), moving)) if !pays && is_subset(&moved, &moving) => {
                work.count_factorisation(part.changing());
                part.renew(terms(problem, stiffness, &moving)).then_some((SystemFactor::Trailing(part), moving))?
            }
            Some(_) if pays => split(problem, stiffness, moved, work)?,
            other => (problem.factorise_in(other.map(|(factor, _)| factor), stiffness, work)?, Vec::new()),
        });
        self.kept.as_ref().map(|(factor, _)| factor)
    }
}

/// Eliminates the rows without a moving spring.
fn split(
    problem: &ContactProblem,
    stiffness: &[f64],
    moving: Vec<usize>,
    work: &mut Work,
) -> Option<(SystemFactor, Vec<usize>)> {
    work.count_factorisation(problem.load.len());
    let mut at_rest = stiffness.to_vec();
    let mut changing = vec![false; problem.load.len()];
    for &i in &moving {
        at_rest[i] = 0.0;
        problem.points[i].row.iter().for_each(|&(row, _)| changing[row] = true);
    }
    let part = Trailing::of(&problem.matrix(&at_rest), &changing, terms(problem, stiffness, &moving))?;
    Some((SystemFactor::Trailing(part), moving))
}

/// `A k bᵀb` of some springs.
fn terms<'a>(
    problem: &'a ContactProblem,
    stiffness: &'a [f64],
    springs: &'a [usize],
) -> impl Iterator<Item = RankOne<'a>> {
    springs.iter().map(|&i| (problem.points[i].weight * stiffness[i], problem.points[i].row.as_slice()))
}

/// Whether every member of one ascending list is in another.
fn is_subset(of: &[usize], all: &[usize]) -> bool {
    of.iter().all(|i| all.binary_search(i).is_ok())
}
