//! One body, its interior eliminated.

use std::ops::Range;
use std::sync::Arc;

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::sparse::SparseColMat;
use faer::{Accum, Mat, Par};

use crate::clock::{Clock, Stage};
use crate::condensation::factor::{self, Factor};
use crate::elasticity::{BodySystem, Index};
use crate::error::{Error, Place};

/// `K + σ I_c = L Lᵀ` with the retained dofs last, and `y = L⁻¹ f`.
///
/// The shift σ, of the size of the retained diagonal, makes bodies supported by contact alone definite; it is taken off
/// S again.
#[derive(Debug)]
pub struct Eliminated {
    place: Place,
    stiffness: Arc<SparseColMat<Index, f64>>,
    /// Without its values where it is made again to recover unknowns.
    factor: Factor,
    /// `L_cc`: the last rows and columns of L.
    trailing: Mat<f64>,
    /// `y`: the load, eliminated forwards.
    forward: Vec<f64>,
    shift: f64,
}

impl Eliminated {
    /// Factorises once, and keeps the factor or makes it again whenever unknowns are recovered: of many bodies those
    /// take most of the memory.
    pub fn of(body: &BodySystem, keeps: bool, clock: &mut Clock) -> Result<Self, Error> {
        let pattern = body.stiffness.symbolic();
        let symbolic = clock.time(Stage::Analysis, || factor::analyse(pattern, &body.place))?;
        let (mut factor, shift) = clock.time(Stage::Factorisation, || {
            let (values, shift) = shifted(&body.stiffness, body.dofs.retained.clone());
            Factor::new(Arc::new(symbolic), pattern, &values, &body.place).map(|factor| (factor, shift))
        })?;
        Ok(clock.time(Stage::ForwardElimination, || {
            let trailing = factor.trailing_block(body.dofs.retained.len());
            let mut forward = body.force.clone();
            factor.solve_lower(&mut forward);
            if !keeps {
                factor.forget();
            }
            let (place, stiffness) = (body.place.clone(), body.stiffness.clone());
            Self { place, stiffness, factor, trailing, forward, shift }
        }))
    }

    /// `S = L_cc L_ccᵀ − σ I`.
    pub fn stiffness(&self) -> Mat<f64> {
        let (m, l) = (self.trailing.nrows(), self.trailing.as_ref());
        let mut schur = Mat::zeros(m, m);
        let lower = BlockStructure::TriangularLower;
        let upper = BlockStructure::TriangularUpper;
        matmul(schur.as_mut(), lower, Accum::Replace, l, lower, l.transpose(), upper, 1.0, Par::Seq);
        for j in 0..m {
            schur[(j, j)] -= self.shift;
            (j + 1..m).for_each(|i| schur[(j, i)] = schur[(i, j)]);
        }
        schur
    }

    /// `f̂ = L_cc y_c`.
    pub fn load(&self) -> Vec<f64> {
        let m = self.trailing.nrows();
        let y = &self.forward[self.forward.len() - m..];
        let mut load = vec![0.0; m];
        for (j, y_j) in y.iter().enumerate() {
            load.iter_mut().zip(self.trailing.col_as_slice(j)).for_each(|(sum, l)| *sum += l * y_j);
        }
        load
    }

    /// All unknowns from the retained ones, backwards: `Lᵀ u = (y_i, L_ccᵀ u_c)`, so that `K_ii u_i = f_i − K_ic u_c`;
    /// for each of several sets of retained ones.
    ///
    /// The load is `factor` times the one that was eliminated.
    pub fn recover(&self, factor: f64, retained: &[&[f64]]) -> Vec<Vec<f64>> {
        let right = |retained: &&[f64]| {
            let mut u: Vec<f64> = self.forward.iter().map(|y| factor * y).collect();
            let first = u.len() - retained.len();
            for (j, value) in u[first..].iter_mut().enumerate() {
                *value = self.trailing.col_as_slice(j).iter().zip(*retained).map(|(l, u)| l * u).sum();
            }
            u
        };
        let mut all: Vec<Vec<f64>> = retained.iter().map(right).collect();
        if self.factor.is_kept() {
            self.factor.solve_upper(&mut all);
        } else {
            let first = self.forward.len() - self.trailing.nrows();
            let (values, _) = shifted(&self.stiffness, first..self.forward.len());
            let again = Factor::new(self.factor.symbolic(), self.stiffness.symbolic(), &values, &self.place);
            again.expect("it was factorised before").solve_upper(&mut all);
        }
        all
    }

    /// The factor.
    pub fn factor(&self) -> &Factor {
        &self.factor
    }
}

/// Values of `K + σ I_c`, and σ: the mean diagonal of the retained dofs.
pub(super) fn shifted(stiffness: &SparseColMat<Index, f64>, retained: Range<usize>) -> (Vec<f64>, f64) {
    let (starts, mut values) = (stiffness.symbolic().col_ptr(), stiffness.val().to_vec());
    // The rows of a column ascend from the diagonal on.
    let diagonal = || retained.clone().map(|column| starts[column] as usize);
    let shift = diagonal().map(|at| values[at]).sum::<f64>() / retained.len().max(1) as f64;
    diagonal().for_each(|at| values[at] += shift);
    (values, shift)
}
