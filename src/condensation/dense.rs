//! Dense Cholesky factorisation of what the algorithms solve with, in the memory of the matrix itself.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::{factor, solve, update};
use faer::{Col, Mat, MatMut, MatRef, Par, Spec};

/// A pivot below this fraction of its diagonal is what round-off leaves of zero: up to 1e-11 on bodies held by contact
/// alone once the last spring has opened (flat punch on a block of 40 half-widths); springs of κ leave about κ.
const VANISHED: f64 = 1e-10;

/// Dense Cholesky factor `A = L Lᵀ`.
#[derive(Clone, Debug)]
pub struct DenseFactor {
    l: Padded,
    /// Diagonal of A.
    diagonal: Vec<f64>,
}

/// A square matrix with rows of zeros below it, up to a multiple of the widest register.
///
/// Products run over whole registers: what memory holds below the last row is multiplied too, and where an earlier use left
/// integers there, which read as denormal numbers, a factorisation takes five times as long.
#[derive(Clone, Debug)]
pub struct Padded(Mat<f64>);

impl Default for Padded {
    fn default() -> Self {
        Self(Mat::new())
    }
}

impl Padded {
    /// A copy of a square matrix, in memory at hand where that fits.
    pub fn copy_of(matrix: &Mat<f64>, memory: Self) -> Self {
        let m = matrix.ncols();
        let mut copy = if memory.0.ncols() == m { memory.0 } else { Mat::zeros(m.next_multiple_of(16), m) };
        copy.as_mut().submatrix_mut(0, 0, m, m).copy_from(matrix);
        Self(copy)
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
        let diagonal: Vec<f64> = matrix.as_ref().diagonal().column_vector().iter().copied().collect();
        let m = diagonal.len();
        let mut memory = MemBuffer::new(factor::cholesky_in_place_scratch::<f64>(m, Par::Seq, Spec::default()));
        let stack = MemStack::new(&mut memory);
        factor::cholesky_in_place(matrix.as_mut(), Default::default(), Par::Seq, stack, Spec::default()).ok()?;
        Self { l: matrix, diagonal }.sound()
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
        self.sound()
    }

    fn sound(self) -> Option<Self> {
        let l = self.l.as_ref();
        let holds = |(i, a): (usize, &f64)| l[(i, i)].powi(2) > VANISHED * a;
        let sound = self.diagonal.iter().enumerate().all(holds);
        sound.then_some(self)
    }

    /// The memory of a factor that is no longer needed.
    pub fn into_memory(self) -> Padded {
        self.l
    }

    /// `x = A⁻¹ b`.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let (m, mut x) = (b.len(), b.to_vec());
        let mut memory = MemBuffer::new(solve::solve_in_place_scratch::<f64>(m, 1, Par::Seq));
        let rhs = MatMut::from_column_major_slice_mut(&mut x, m, 1);
        solve::solve_in_place(self.l.as_ref(), rhs, Par::Seq, MemStack::new(&mut memory));
        x
    }
}
