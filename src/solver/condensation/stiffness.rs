//! The condensed stiffness of all bodies, and factors of it with springs: one dense matrix, or of many bodies a sparse
//! one.
//!
//! S is block-diagonal by body, and springs couple only bodies that are in contact. Of few bodies a dense matrix is the
//! quicker one. Of many, memory and time of a sparse factorisation grow with their number, whether they stand apart or
//! press on one another in a row.

use std::ops::{Index, Range};
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{ColRef, Conj, Mat, MatMut, Par, Side, Spec};

use crate::condensation::dense::{DenseFactor, Padded, RankOne, VANISHED};
use crate::condensation::factor::singular;
use crate::condensation::trailing::Trailing;
use crate::elasticity::{self, summed};
use crate::error::Error;

/// Condensed stiffness `S` [N/mm] of all bodies.
#[derive(Debug)]
pub enum Stiffness {
    /// One matrix.
    Dense(Mat<f64>),
    /// The blocks of many bodies.
    Sparse(Blocks),
}

/// Lower triangle of S, with zeros where springs couple two bodies.
#[derive(Debug)]
pub struct Blocks {
    pattern: SymbolicSparseColMat<elasticity::Index>,
    values: Vec<f64>,
    /// Where factors have entries.
    symbolic: Arc<SymbolicCholesky<elasticity::Index>>,
    /// Place of each pivot among the values of a factor, and its row of S.
    pivots: Arc<Vec<[usize; 2]>>,
    /// Operations of a factorisation, `Σ (column length)²`.
    operations: f64,
}

/// Factor of `S + Σ A k bᵀb`.
#[derive(Clone, Debug)]
pub enum SystemFactor {
    /// Of one matrix.
    Dense(DenseFactor),
    /// Of one matrix, the rows that change last.
    Trailing(Trailing),
    /// Of the blocks of many bodies: where its entries are, and their values.
    Sparse(Arc<SymbolicCholesky<elasticity::Index>>, Vec<f64>),
}

impl SystemFactor {
    /// `x = A⁻¹ b`.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        match self {
            Self::Dense(factor) => factor.solve(b),
            Self::Trailing(part) => part.factor().solve(b),
            Self::Sparse(symbolic, values) => {
                let mut x = b.to_vec();
                let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
                let rhs = MatMut::from_column_major_slice_mut(&mut x, b.len(), 1);
                let factor = LltRef::new(symbolic, values);
                factor.solve_in_place_with_conj(Conj::No, rhs, Par::Seq, MemStack::new(&mut memory));
                x
            }
        }
    }
}

impl Stiffness {
    /// Whether it is one matrix, of which a factor may be changed in place.
    pub fn is_dense(&self) -> bool {
        matches!(self, Self::Dense(_))
    }

    /// A copy as one matrix.
    pub fn to_dense(&self) -> Mat<f64> {
        match self {
            Self::Dense(matrix) => matrix.clone(),
            Self::Sparse(blocks) => {
                let n = blocks.pattern.ncols();
                Mat::from_fn(n, n, |i, j| self[(i, j)])
            }
        }
    }

    /// Factor of `S + Σ δ bᵀb`, in the memory of one that is no longer needed; none where that is not positive
    /// definite, round-off apart.
    pub fn factorise<'a>(
        &self,
        terms: impl Iterator<Item = RankOne<'a>>,
        memory: Option<SystemFactor>,
    ) -> Option<SystemFactor> {
        match self {
            Self::Dense(matrix) => {
                let memory = match memory {
                    Some(SystemFactor::Dense(factor)) => factor.into_memory(),
                    _ => Padded::default(),
                };
                let mut sum = Padded::copy_of(matrix, memory);
                let mut whole = sum.as_mut();
                add(terms, |i, j, change| whole[(i, j)] += change);
                DenseFactor::of(sum).map(SystemFactor::Dense)
            }
            Self::Sparse(blocks) => blocks.factorise(terms),
        }
    }

    /// `S u` \[N\].
    pub fn times(&self, u: &[f64]) -> Vec<f64> {
        match self {
            Self::Dense(matrix) => (matrix * ColRef::from_slice(u)).iter().copied().collect(),
            Self::Sparse(blocks) => summed(blocks.matrix(), u, |term| term),
        }
    }

    /// `|S| |u|`: the size of the terms in `S u` \[N\].
    pub fn terms(&self, u: &[f64]) -> Vec<f64> {
        match self {
            Self::Dense(matrix) => {
                let of = |i: usize| (0..u.len()).map(|j| (matrix[(i, j)] * u[j]).abs()).sum();
                (0..u.len()).map(of).collect()
            }
            Self::Sparse(blocks) => summed(blocks.matrix(), u, f64::abs),
        }
    }

    /// Operations of a factorisation, and of a solve with its product `S u`.
    pub fn operations(&self) -> [f64; 2] {
        match self {
            Self::Dense(matrix) => {
                let n = matrix.ncols() as f64;
                [n.powi(3) / 3.0, 2.0 * n.powi(2)]
            }
            Self::Sparse(blocks) => [blocks.operations, 4.0 * blocks.symbolic.len_val() as f64],
        }
    }
}

impl Index<(usize, usize)> for Stiffness {
    type Output = f64;

    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        match self {
            Self::Dense(matrix) => &matrix[(i, j)],
            Self::Sparse(blocks) => blocks.place(i.max(j), i.min(j)).map_or(&0.0, |at| &blocks.values[at]),
        }
    }
}

impl Blocks {
    /// Those of some bodies, whose dofs begin at the offsets, with the dofs of two bodies each that springs of a
    /// contact couple.
    pub fn of(blocks: &[Mat<f64>], offsets: &[usize], coupled: &[[Range<usize>; 2]]) -> Result<Self, Error> {
        let n = offsets[blocks.len()];
        let mut beyond = vec![0..0; n];
        for [one, other] in coupled {
            let [columns, rows] = if one.start < other.start { [one, other] } else { [other, one] };
            columns.clone().for_each(|column| beyond[column] = rows.clone());
        }
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        for (block, ends) in blocks.iter().zip(offsets.windows(2)) {
            for (column, others) in (ends[0]..).zip(&beyond[ends[0]..ends[1]]) {
                rows.extend((column..ends[1]).chain(others.clone()).map(|row| row as elasticity::Index));
                values.extend_from_slice(&block.col_as_slice(column - ends[0])[column - ends[0]..]);
                values.resize(rows.len(), 0.0);
                starts.push(rows.len() as elasticity::Index);
            }
        }
        let pattern = SymbolicSparseColMat::new_checked(n, n, starts, None, rows);
        let supernodal_flop_ratio_threshold = SupernodalThreshold::FORCE_SUPERNODAL;
        let params = CholeskySymbolicParams { supernodal_flop_ratio_threshold, ..Default::default() };
        let symbolic = factorize_symbolic_cholesky(pattern.as_ref(), Side::Lower, SymmetricOrdering::Amd, params)
            .map_err(|_| singular(&"coupled system".into(), 0))?;
        let (pivots, operations) = pivots(&symbolic);
        Ok(Self { pattern, values, symbolic: Arc::new(symbolic), pivots: Arc::new(pivots), operations })
    }

    fn matrix(&self) -> SparseColMatRef<'_, elasticity::Index, f64> {
        SparseColMatRef::new(self.pattern.as_ref(), &self.values)
    }

    /// Place of an entry of the lower triangle among the values; none where that is always zero.
    fn place(&self, row: usize, column: usize) -> Option<usize> {
        let [first, end] = [column, column + 1].map(|k| self.pattern.col_ptr()[k] as usize);
        let at = self.pattern.row_idx()[first..end].binary_search(&(row as elasticity::Index));
        at.ok().map(|at| first + at)
    }

    fn factorise<'a>(&self, terms: impl Iterator<Item = RankOne<'a>>) -> Option<SystemFactor> {
        let mut values = self.values.clone();
        add(terms, |i, j, change| {
            if i >= j {
                let at = self.place(i, j).expect("springs couple dofs of one contact");
                values[at] += change;
            }
        });
        let mut l = vec![0.0; self.symbolic.len_val()];
        let scratch = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
        self.symbolic
            .factorize_numeric_llt(
                &mut l,
                SparseColMatRef::new(self.pattern.as_ref(), &values),
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(scratch)),
                Spec::default(),
            )
            .ok()?;
        let holds = |[at, row]: &[usize; 2]| {
            let diagonal = values[self.pattern.col_ptr()[*row] as usize];
            l[*at].powi(2) > VANISHED * diagonal
        };
        self.pivots.iter().all(holds).then(|| SystemFactor::Sparse(self.symbolic.clone(), l))
    }
}

/// Place of each pivot among the values of a factor with its row of the matrix, and the operations of the
/// factorisation.
fn pivots(symbolic: &SymbolicCholesky<elasticity::Index>) -> (Vec<[usize; 2]>, f64) {
    let (mut pivots, mut operations) = (Vec::with_capacity(symbolic.nrows()), 0.0);
    let SymbolicCholeskyRaw::Supernodal(parts) = symbolic.raw() else { return (pivots, f64::NAN) };
    let row_of = |row: usize| symbolic.perm().map_or(row, |order| order.arrays().0[row] as usize);
    for part in 0..parts.n_supernodes() {
        let [first, end] = [parts.supernode_begin()[part], parts.supernode_end()[part]].map(|row| row as usize);
        let length = end - first + parts.supernode(part).pattern().len();
        for k in 0..end - first {
            pivots.push([parts.col_ptr_for_val()[part] as usize + k * (length + 1), row_of(first + k)]);
            operations += ((length - k) as f64).powi(2);
        }
    }
    (pivots, operations)
}

/// Entries `δ b_i b_j` of some terms.
fn add<'a>(terms: impl Iterator<Item = RankOne<'a>>, mut entry: impl FnMut(usize, usize, f64)) {
    for (delta, b) in terms {
        for &(i, b_i) in b {
            for &(j, b_j) in b {
                entry(i, j, delta * b_i * b_j);
            }
        }
    }
}
