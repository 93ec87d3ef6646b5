//! Sparse Cholesky factorisation with the retained freedoms ordered last.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::solvers::LltError;
use faer::perm::PermRef;
use faer::prelude::Solve;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::amd;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky, supernodal::SupernodalLltRef,
};
use faer::sparse::{SparseColMat, SymbolicSparseColMatRef, Triplet};
use faer::{Conj, Mat, MatMut, Par, Side, Spec};

use super::{CoupledSpring, is_retained};
use crate::elasticity::{BodySystem, ElasticSystem};
use crate::error::Error;

/// Cholesky factor of `P (K + σ I_c) Pᵀ`.
///
/// The shift σ, of the size of the retained diagonal, makes bodies held by contact alone definite; it is taken off S again.
#[derive(Debug)]
pub struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    shift: f64,
}

impl Factor {
    /// Orders the interior by approximate minimum degree, puts the retained freedoms last, and factorises once.
    pub fn new(body: &BodySystem) -> Result<Self, Error> {
        let shift = mean_retained_diagonal(body);
        let matrix = shifted(body, shift);
        let order = retained_last(body);
        let inverse = inverse_of(&order);
        let permutation = PermRef::new_checked(&order, &inverse, order.len());
        let symbolic = symbolic(matrix.symbolic(), SymmetricOrdering::Custom(permutation), &body.name)?;
        let values = numeric(&symbolic, &matrix, &body.name)?;
        Ok(Self { symbolic, values, shift })
    }

    /// Schur complement `S = L₂₂L₂₂ᵀ − σI` and condensed load `f̂ = (S + σI) x_c`, where `(K + σI_c) x = f`.
    pub fn schur(&self, body: &BodySystem) -> (Mat<f64>, Vec<f64>) {
        let m = body.retained.len();
        let trailing = self.trailing_block(m);
        let mut schur = &trailing * trailing.transpose();
        let solution = self.solve(body.force.clone());
        let at_contact: Vec<f64> = body.retained.iter().map(|&equation| solution[equation]).collect();
        let load = (0..m).map(|i| (0..m).map(|j| schur[(i, j)] * at_contact[j]).sum()).collect();
        for i in 0..m {
            schur[(i, i)] -= self.shift;
        }
        (schur, load)
    }

    /// `(K + σ I_c) u = f + λ + σ u_c`.
    pub fn recover(&self, body: &BodySystem, retained: &[f64], contact_force: &[f64]) -> Vec<f64> {
        let mut rhs = body.force.clone();
        for ((&equation, u), force) in body.retained.iter().zip(retained).zip(contact_force) {
            rhs[equation] += force + self.shift * u;
        }
        self.solve(rhs)
    }

    /// Operations of the factorisation, `Σ (column length)²` over the columns of L.
    pub fn operations(&self) -> f64 {
        let SymbolicCholeskyRaw::Supernodal(symbolic) = self.symbolic.raw() else { return f64::NAN };
        let columns = |s: usize| symbolic.supernode_end()[s] - symbolic.supernode_begin()[s];
        let below = |s: usize| symbolic.supernode(s).pattern().len();
        let of = |s: usize| (0..columns(s)).map(|j| ((columns(s) - j + below(s)) as f64).powi(2)).sum::<f64>();
        (0..symbolic.n_supernodes()).map(of).sum()
    }

    fn solve(&self, mut rhs: Vec<f64>) -> Vec<f64> {
        solve_in_place(&self.symbolic, &self.values, &mut rhs);
        rhs
    }

    /// The last `m` rows and columns of `L`, gathered from the supernodes that reach into them.
    fn trailing_block(&self, m: usize) -> Mat<f64> {
        let mut block = Mat::zeros(m, m);
        let SymbolicCholeskyRaw::Supernodal(symbolic) = self.symbolic.raw() else {
            return block;
        };
        let first = symbolic.nrows() - m;
        let factor = SupernodalLltRef::new(symbolic, &self.values);
        for s in 0..symbolic.n_supernodes() {
            let node = factor.supernode(s);
            let (values, start) = (node.val(), node.start());
            for j in first.saturating_sub(start)..values.ncols() {
                for i in j..values.nrows() {
                    let row = if i < values.ncols() { start + i } else { node.pattern()[i - values.ncols()] };
                    block[(row - first, start + j - first)] = values[(i, j)];
                }
            }
        }
        block
    }
}

/// Solves the two bodies and their springs as one sparse system.
pub(super) fn solve_coupled(system: &ElasticSystem, springs: &[CoupledSpring]) -> Result<Vec<Vec<f64>>, Error> {
    let mut offset = 0;
    let mut triplets = Vec::new();
    let (mut retained, mut rhs, mut offsets) = (Vec::new(), Vec::new(), Vec::new());
    for body in &system.bodies {
        let matrix = body.stiffness.as_ref();
        for column in 0..matrix.ncols() {
            for (row, &value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                triplets.push(Triplet::new(offset + row, offset + column, value));
            }
        }
        retained.extend(body.retained.iter().map(|r| offset + r));
        rhs.extend_from_slice(&body.force);
        offsets.push(offset);
        offset += body.freedoms.equations;
    }
    for CoupledSpring { row, constant, force } in springs {
        for &(i, b_i) in row {
            rhs[retained[i]] += b_i * force;
            for &(j, b_j) in row {
                if retained[i] >= retained[j] {
                    triplets.push(Triplet::new(retained[i], retained[j], constant * b_i * b_j));
                }
            }
        }
    }
    let name = "coupled system";
    let matrix = SparseColMat::try_new_from_triplets(offset, offset, &triplets)
        .map_err(|_| Error::SingularStiffness { body: name.into(), pivot: 0 })?;
    let symbolic = symbolic(matrix.symbolic(), SymmetricOrdering::Amd, name)?;
    let values = numeric(&symbolic, &matrix, name)?;
    let reference = rhs.clone();
    solve_in_place(&symbolic, &values, &mut rhs);
    refine(&symbolic, &values, &matrix, &reference, &mut rhs);
    Ok(system.bodies.iter().zip(offsets).map(|(body, at)| rhs[at..at + body.freedoms.equations].to_vec()).collect())
}

/// One step of iterative refinement, `x ← x + A⁻¹(b − A x)`.
fn refine(
    symbolic: &SymbolicCholesky<usize>,
    values: &[f64],
    matrix: &SparseColMat<usize, f64>,
    b: &[f64],
    x: &mut [f64],
) {
    let mut residual = b.to_vec();
    let view = matrix.as_ref();
    for column in 0..view.ncols() {
        for (row, &value) in view.row_idx_of_col(column).zip(view.val_of_col(column)) {
            residual[row] -= value * x[column];
            if row != column {
                residual[column] -= value * x[row];
            }
        }
    }
    solve_in_place(symbolic, values, &mut residual);
    x.iter_mut().zip(residual).for_each(|(x, r)| *x += r);
}

fn mean_retained_diagonal(body: &BodySystem) -> f64 {
    let matrix = body.stiffness.as_ref();
    let diagonal = |column: usize| {
        let entries = matrix.row_idx_of_col(column).zip(matrix.val_of_col(column));
        entries.filter(|(row, _)| *row == column).map(|(_, value)| *value).sum::<f64>()
    };
    body.retained.iter().map(|&equation| diagonal(equation)).sum::<f64>() / body.retained.len() as f64
}

fn shifted(body: &BodySystem, shift: f64) -> SparseColMat<usize, f64> {
    let mut matrix = body.stiffness.clone();
    for &column in &body.retained {
        let at = matrix.row_idx_of_col(column).position(|row| row == column);
        if let Some(at) = at {
            matrix.val_of_col_mut(column)[at] += shift;
        }
    }
    matrix
}

/// Elimination order: interior freedoms by approximate minimum degree of their own graph, then the retained ones.
fn retained_last(body: &BodySystem) -> Vec<usize> {
    let retained = is_retained(body);
    let interior: Vec<usize> = (0..retained.len()).filter(|&e| !retained[e]).collect();
    let mut number = vec![usize::MAX; retained.len()];
    interior.iter().enumerate().for_each(|(new, &old)| number[old] = new);
    let matrix = body.stiffness.as_ref();
    let (mut starts, mut rows) = (vec![0], Vec::new());
    for &column in &interior {
        rows.extend(matrix.row_idx_of_col(column).filter(|&row| !retained[row]).map(|row| number[row]));
        starts.push(rows.len());
    }
    let n = interior.len();
    let graph = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
    let (mut forward, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = MemBuffer::new(amd::order_maybe_unsorted_scratch::<usize>(n, rows.len()));
    let ordered = amd::order_maybe_unsorted(
        &mut forward,
        &mut inverse,
        graph,
        amd::Control::default(),
        MemStack::new(&mut memory),
    );
    if ordered.is_err() {
        forward = (0..n).collect();
    }
    forward.iter().map(|&new| interior[new]).chain(body.retained.iter().copied()).collect()
}

fn inverse_of(order: &[usize]) -> Vec<usize> {
    let mut inverse = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| inverse[old] = new);
    inverse
}

fn symbolic(
    pattern: SymbolicSparseColMatRef<usize>,
    ordering: SymmetricOrdering<usize>,
    name: &str,
) -> Result<SymbolicCholesky<usize>, Error> {
    let params = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
        ..Default::default()
    };
    factorize_symbolic_cholesky(pattern, Side::Lower, ordering, params)
        .map_err(|_| Error::SingularStiffness { body: name.into(), pivot: 0 })
}

fn numeric(
    symbolic: &SymbolicCholesky<usize>,
    matrix: &SparseColMat<usize, f64>,
    name: &str,
) -> Result<Vec<f64>, Error> {
    let mut values = vec![0.0; symbolic.len_val()];
    let mut memory = MemBuffer::new(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default()));
    let factorised = symbolic
        .factorize_numeric_llt(
            &mut values,
            matrix.as_ref(),
            Side::Lower,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            Spec::default(),
        )
        .map(|_| ());
    match factorised {
        Ok(()) => Ok(values),
        Err(LltError::NonPositivePivot { index }) => Err(Error::SingularStiffness { body: name.into(), pivot: index }),
    }
}

fn solve_in_place(symbolic: &SymbolicCholesky<usize>, values: &[f64], rhs: &mut [f64]) {
    let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
    let n = rhs.len();
    let view = MatMut::from_column_major_slice_mut(rhs, n, 1);
    LltRef::new(symbolic, values).solve_in_place_with_conj(Conj::No, view, Par::Seq, MemStack::new(&mut memory));
}

/// A pivot below this fraction of its diagonal is what round-off leaves of zero: up to 1e-11 on bodies held by contact
/// alone once the last spring has opened (flat punch on a block of 40 half-widths); springs of κ leave about κ.
const VANISHED: f64 = 1e-10;

/// Dense Cholesky solve used by the algorithms: `None` where the matrix is not positive definite, round-off apart.
pub fn dense(matrix: &Mat<f64>) -> Option<DenseFactor> {
    let factor = faer::linalg::solvers::Llt::new(matrix.as_ref(), Side::Lower).ok()?;
    let pivot = |i: usize| factor.L()[(i, i)].powi(2);
    let vanished = (0..matrix.nrows()).any(|i| pivot(i) <= VANISHED * matrix[(i, i)]);
    (!vanished).then_some(DenseFactor(factor))
}

/// Dense Cholesky factor.
#[derive(Clone, Debug)]
pub struct DenseFactor(faer::linalg::solvers::Llt<f64>);

impl DenseFactor {
    /// `x = A⁻¹ b`.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut x = Mat::from_fn(b.len(), 1, |i, _| b[i]);
        self.0.solve_in_place(x.as_mut());
        (0..b.len()).map(|i| x[(i, 0)]).collect()
    }
}
