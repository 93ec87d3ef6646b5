//! Sparse Cholesky factorisation of matrices whose unknowns are numbered in the order of elimination.

use std::ops::Range;
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::solvers::LltError;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Mat, Par, Spec};
use pulp::Arch;

use crate::elasticity::Index;
use crate::error::{Error, Place};

/// `L` of `A = L Lᵀ`, in supernodes: neighbouring columns with the same rows below, stored densely.
#[derive(Debug)]
pub struct Factor {
    symbolic: Arc<Symbolic>,
    values: Vec<f64>,
}

/// Where L has entries.
pub type Symbolic = supernodal::SymbolicSupernodalCholesky<Index>;

impl Factor {
    /// Factorises the matrix of a pattern (lower triangle, in the order of elimination) and values.
    pub fn new(
        symbolic: Arc<Symbolic>,
        pattern: SymbolicSparseColMatRef<Index>,
        values: &[f64],
        body: &Place,
    ) -> Result<Self, Error> {
        let mut l = vec![0.0; symbolic.len_val()];
        let scratch =
            supernodal::factorize_supernodal_numeric_llt_scratch::<Index, f64>(&symbolic, Par::Seq, Spec::default());
        let factorised = supernodal::factorize_supernodal_numeric_llt(
            &mut l,
            SparseColMatRef::new(pattern, values),
            Default::default(),
            &symbolic,
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Spec::default(),
        );
        match factorised {
            Ok(_) => Ok(Self { symbolic, values: l }),
            Err(LltError::NonPositivePivot { index }) => Err(singular(body, index)),
        }
    }

    /// Operations of the factorisation, `Σ (column length)²` over the columns of L.
    pub fn operations(&self) -> f64 {
        let of = |s: usize| {
            let below = self.symbolic.supernode(s).pattern().len();
            (1..=self.columns(s).len()).map(|length| ((length + below) as f64).powi(2)).sum::<f64>()
        };
        (0..self.symbolic.n_supernodes()).map(of).sum()
    }

    /// Entries of L.
    pub fn entries(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Where it has entries.
    pub fn symbolic(&self) -> Arc<Symbolic> {
        self.symbolic.clone()
    }

    /// Drops its values.
    pub fn forget(&mut self) {
        self.values = Vec::new();
    }

    /// Whether it has its values.
    pub fn is_kept(&self) -> bool {
        self.values.len() == self.symbolic.len_val()
    }

    /// `x ← L⁻¹ x`.
    pub fn solve_lower(&self, x: &mut [f64]) {
        Arch::new().dispatch(SolveLower(self, x));
    }

    /// `x ← L⁻ᵀ x` for several x at once, L being read once for all.
    pub fn solve_upper(&self, x: &mut [Vec<f64>]) {
        Arch::new().dispatch(SolveUpper(self, x));
    }

    #[inline(always)]
    fn solve_lower_here(&self, x: &mut [f64]) {
        let mut below = Vec::new();
        for s in 0..self.symbolic.n_supernodes() {
            let (columns, rows) = (self.columns(s), self.rows_below(s));
            let own = columns.len();
            below.clear();
            below.resize(rows.len(), 0.0);
            for (j, column) in self.values_of(s).chunks_exact(own + rows.len()).enumerate() {
                let top = &mut x[columns.start + j..columns.end];
                top[0] /= column[j];
                let pivot = top[0];
                top[1..].iter_mut().zip(&column[j + 1..own]).for_each(|(x, l)| *x -= l * pivot);
                below.iter_mut().zip(&column[own..]).for_each(|(sum, l)| *sum += l * pivot);
            }
            rows.iter().zip(&below).for_each(|(&row, sum)| x[row as usize] -= sum);
        }
    }

    #[inline(always)]
    fn solve_upper_here(&self, x: &mut [Vec<f64>]) {
        let mut below = vec![Vec::new(); x.len()];
        for s in (0..self.symbolic.n_supernodes()).rev() {
            let (columns, rows) = (self.columns(s), self.rows_below(s));
            let own = columns.len();
            for (below, x) in below.iter_mut().zip(x.iter()) {
                below.clear();
                below.extend(rows.iter().map(|&row| x[row as usize]));
            }
            for (j, column) in self.values_of(s).chunks_exact(own + rows.len()).enumerate().rev() {
                for (below, x) in below.iter().zip(x.iter_mut()) {
                    let top = &mut x[columns.start + j..columns.end];
                    let sum = dot(&column[j + 1..own], &top[1..]) + dot(&column[own..], below);
                    top[0] = (top[0] - sum) / column[j];
                }
            }
        }
    }

    /// The last `m` rows and columns of `L`, gathered from the supernodes that reach into them.
    pub fn trailing_block(&self, m: usize) -> Mat<f64> {
        let mut block = Mat::zeros(m, m);
        let first = self.symbolic.nrows() - m;
        for s in (0..self.symbolic.n_supernodes()).rev() {
            let (columns, rows) = (self.columns(s), self.rows_below(s));
            if columns.end <= first {
                break;
            }
            let length = columns.len() + rows.len();
            for j in columns.start.max(first)..columns.end {
                let column = &self.values_of(s)[(j - columns.start) * length..][..length];
                let own = (j..columns.end).zip(&column[j - columns.start..]);
                let below = rows.iter().map(|&row| row as usize).zip(&column[columns.len()..]);
                own.chain(below).for_each(|(row, &value)| block[(row - first, j - first)] = value);
            }
        }
        block
    }

    fn columns(&self, s: usize) -> Range<usize> {
        self.symbolic.supernode_begin()[s] as usize..self.symbolic.supernode_end()[s] as usize
    }

    fn rows_below(&self, s: usize) -> &[Index] {
        self.symbolic.supernode(s).pattern()
    }

    /// Columns of a supernode one after the other: its own rows, then those below.
    fn values_of(&self, s: usize) -> &[f64] {
        let starts = self.symbolic.col_ptr_for_val();
        &self.values[starts[s] as usize..starts[s + 1] as usize]
    }
}

/// Error of a stiffness that is not positive definite although every rigid motion is fixed.
pub(super) fn singular(body: &Place, pivot: usize) -> Error {
    let message = format!("the stiffness is not positive definite (pivot {pivot})");
    Error::at(body, message, "check the material and the shape of the cells")
}

/// Where L has entries: elimination tree, column counts, supernodes.
pub fn analyse(lower: SymbolicSparseColMatRef<Index>, body: &Place) -> Result<Symbolic, Error> {
    let n = lower.nrows();
    let upper = lower.to_row_major().map_err(|_| singular(body, 0))?.into_transpose();
    let (mut tree, mut counts) = (vec![0; n], vec![0; n]);
    let scratch = StackReq::any_of(&[
        simplicial::prefactorize_symbolic_cholesky_scratch::<Index>(n, upper.row_idx().len()),
        supernodal::factorize_supernodal_symbolic_cholesky_scratch::<Index>(n),
    ]);
    let mut memory = MemBuffer::new(scratch);
    let stack = MemStack::new(&mut memory);
    let tree = simplicial::prefactorize_symbolic_cholesky(&mut tree, &mut counts, upper.as_ref(), stack);
    supernodal::factorize_supernodal_symbolic_cholesky(upper.as_ref(), tree, &counts, stack, Default::default())
        .map_err(|_| singular(body, 0))
}

/// [`Factor::solve_lower`] on registers as wide as the processor's own; a closure's call would be a function of its
/// own, compiled for the narrowest.
struct SolveLower<'a>(&'a Factor, &'a mut [f64]);

impl pulp::WithSimd for SolveLower<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.0.solve_lower_here(self.1);
    }
}

/// The same for [`Factor::solve_upper`].
struct SolveUpper<'a>(&'a Factor, &'a mut [Vec<f64>]);

impl pulp::WithSimd for SolveUpper<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.0.solve_upper_here(self.1);
    }
}

/// `a·b` in eight sums at once, as wide registers take them.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a, b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a.zip(b) {
        (0..8).for_each(|lane| sums[lane] += a[lane] * b[lane]);
    }
    sums.iter().sum::<f64>() + rest
}
