//! Dense Cholesky factorisation of what the algorithms solve with, in the memory of the matrix itself.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::{factor, solve, update};
use faer::{Col, Mat, MatMut, MatRef, Par, Spec};

/// A pivot below this fraction of its diagonal is what round-off leaves of zero: up to 1e-11 on bodies held by contact
/// alone once the last spring has opened (flat punch on a block of 40 half-widths); springs of κ leave about κ.
pub(super) const VANISHED: f64 = 1e-10;

/// Dense Cholesky factor `A = L Lᵀ`.
#[derive(Clone, Debug)]
pub struct DenseFactor {
    l: Padded,
    /// Diagonal of A, as L has its rows.
    diagonal: Vec<f64>,
    /// Row of A that each row of L belongs to; empty where that is the same one.
    order: Vec<usize>,
}

/// A square matrix with rows of zeros below it, up to a multiple of the widest register.
///
/// Products run over whole registers: what memory holds below the last row is multiplied too, and where an earlier use
/// left integers there, which read as denormal numbers, a factorisation takes five times as long.
#[derive(Clone, Debug)]
pub struct Padded(Mat<f64>);

impl Default for Padded {
    fn default() -> Self {
        Self(Mat::new())
    }
}

impl Padded {
    /// A square matrix of zeros.
    pub fn zeros(m: usize) -> Self {
        Self(Mat::zeros(m.next_multiple_of(16), m))
    }

    /// A copy of a square matrix, in memory at hand where that fits.
    pub fn copy_of(matrix: &Mat<f64>, memory: Self) -> Self {
        let m = matrix.ncols();
        let mut copy = if memory.0.ncols() == m { memory } else { Self::zeros(m) };
        copy.as_mut().copy_from(matrix);
        copy
    }

    /// The matrix.
    pub fn as_mut(&mut self) -> MatMut<'_, f64> {
        let m = self.0.ncols();
        self.0.as_mut().submatrix_mut(0, 0, m, m)
    }

    /// The matrix.
    pub fn as_ref(&self) -> MatRef<'_, f64> {
        let m = self.0.ncols();
        self.0.as_ref().submatrix(0, 0, m, m)
    }
}

/// A change `δ b bᵀ`: δ and the sparse b.
pub type RankOne<'a> = (f64, &'a [(usize, f64)]);

impl DenseFactor {
    /// Factorises the lower triangle of a matrix: `None` where it is not positive definite, round-off apart.
    pub fn new(matrix: &Mat<f64>) -> Option<Self> {
        Self::of(Padded::copy_of(matrix, Padded::default()))
    }

    /// The same in the memory of the matrix itself.
    pub fn of(mut matrix: Padded) -> Option<Self> {
        let diagonal = matrix.as_ref().diagonal().column_vector().iter().copied().collect();
        in_place(matrix.as_mut())?;
        Some(Self { l: matrix, diagonal, order: Vec::new() }).filter(Self::is_sound)
    }

    /// The factor of a matrix whose row `order[i]` stands in row i of what was factorised.
    pub(super) fn in_order(self, order: Vec<usize>) -> Self {
        Self { order, ..self }
    }

    /// L, with whatever its upper triangle holds.
    pub(super) fn lower(&self) -> MatRef<'_, f64> {
        self.l.as_ref()
    }

    /// The same, to be changed.
    pub(super) fn lower_mut(&mut self) -> MatMut<'_, f64> {
        self.l.as_mut()
    }

    /// Factorises the rows and columns of L from `first` on, which hold a matrix by now, and whose diagonal of A is
    /// given; false where it is not positive definite, round-off apart.
    pub(super) fn factorise_again(&mut self, first: usize, diagonal: &[f64]) -> bool {
        self.diagonal[first..].copy_from_slice(diagonal);
        in_place(self.l.as_mut().get_mut(first.., first..)).is_some() && self.is_sound()
    }

    /// Factor of `A + Σ δ b bᵀ` out of that of A, at `O(m²)` a term; `None` where round-off leaves nothing of a pivot.
    pub fn updated(mut self, changes: &[RankOne]) -> Option<Self> {
        let m = self.diagonal.len();
        let entries = || changes.iter().flat_map(|(_, b)| b.iter());
        let Some(first) = entries().map(|&(row, _)| row).min() else { return Some(self) };
        let mut w = Mat::zeros(m - first, changes.len());
        let mut alpha = Col::zeros(changes.len());
        for (k, &(delta, b)) in changes.iter().enumerate() {
            alpha[k] = delta;
            for &(row, value) in b {
                w[(row - first, k)] += value;
                self.diagonal[row] += delta * value * value;
            }
        }
        // Columns before the first change stay as they are.
        let trailing = self.l.as_mut().submatrix_mut(first, first, m - first, m - first);
        update::rank_r_update_clobber(trailing, w.as_mut(), alpha.as_mut().as_diagonal_mut()).ok()?;
        Some(self).filter(Self::is_sound)
    }

    fn is_sound(&self) -> bool {
        let l = self.l.as_ref();
        let holds = |(i, a): (usize, &f64)| l[(i, i)].powi(2) > VANISHED * a;
        self.diagonal.iter().enumerate().all(holds)
    }

    /// The memory of a factor that is no longer needed.
    pub fn into_memory(self) -> Padded {
        self.l
    }

    /// `x = A⁻¹ b`.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        if self.order.is_empty() {
            return self.solve_as_factorised(b.to_vec());
        }
        let permuted = self.solve_as_factorised(self.order.iter().map(|&row| b[row]).collect());
        let mut x = vec![0.0; b.len()];
        self.order.iter().zip(permuted).for_each(|(&row, value)| x[row] = value);
        x
    }

    fn solve_as_factorised(&self, mut x: Vec<f64>) -> Vec<f64> {
        let m = x.len();
        let mut memory = MemBuffer::new(solve::solve_in_place_scratch::<f64>(m, 1, Par::Seq));
        let rhs = MatMut::from_column_major_slice_mut(&mut x, m, 1);
        solve::solve_in_place(self.l.as_ref(), rhs, Par::Seq, MemStack::new(&mut memory));
        x
    }
}

/// Factorises the lower triangle of a matrix in its memory; none where a pivot is not positive.
fn in_place(matrix: MatMut<'_, f64>) -> Option<()> {
    let scratch = factor::cholesky_in_place_scratch::<f64>(matrix.ncols(), Par::Seq, Spec::default());
    let mut memory = MemBuffer::new(scratch);
    let stack = MemStack::new(&mut memory);
    factor::cholesky_in_place(matrix, Default::default(), Par::Seq, stack, Spec::default()).ok().map(|_| ())
}
