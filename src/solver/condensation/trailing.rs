//! A dense factor of a matrix of which only a few rows change: they are eliminated last, and alone again.

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::{Accum, Mat, Par};

use crate::condensation::dense::{DenseFactor, Padded, RankOne};

/// Cholesky factor of `A + Σ δ bᵀb` with all b on rows that come last.
///
/// With the other rows first, `A = [A₁₁ A₁₂; A₂₁ A₂₂]`, the columns `L₁₁`, `L₂₁` do not change with δ; what does is
/// `L₂₂ L₂₂ᵀ = A₂₂ − L₂₁ L₂₁ᵀ + Σ δ bᵀb`, at `k³/3` operations for k rows.
#[derive(Clone, Debug)]
pub struct Trailing {
    factor: DenseFactor,
    /// Rows that come first.
    first: usize,
    /// Place of each row in the order of elimination.
    place: Vec<usize>,
    /// `A₂₂ − L₂₁ L₂₁ᵀ`, lower triangle.
    schur: Mat<f64>,
    /// Diagonal of `A₂₂`.
    diagonal: Vec<f64>,
}

impl Trailing {
    /// Eliminates every row of the symmetric A that is not marked as changing, and the others for the terms as they
    /// are; `None` where `A + Σ δ bᵀb` is not positive definite.
    pub fn of<'a>(a: &Mat<f64>, changing: &[bool], terms: impl Iterator<Item = RankOne<'a>>) -> Option<Self> {
        let (mut order, last): (Vec<usize>, Vec<usize>) = (0..a.ncols()).partition(|&row| !changing[row]);
        let first = order.len();
        order.extend(last);
        let mut place = vec![0; order.len()];
        order.iter().enumerate().for_each(|(i, &row)| place[row] = i);

        let mut matrix = Padded::zeros(order.len());
        let mut permuted = matrix.as_mut();
        for (j, &column) in order.iter().enumerate() {
            order[j..].iter().zip(j..).for_each(|(&row, i)| permuted[(i, j)] = a[(row, column)]);
        }
        let mut schur = permuted.as_ref().get(first.., first..).to_owned();
        let diagonal = schur.diagonal().column_vector().iter().copied().collect();
        terms.for_each(|term| add(term, &place, 0, |i, j, change| permuted[(i, j)] += change));

        let factor = DenseFactor::of(matrix)?.in_order(order);
        let below = factor.lower().get(first.., ..first);
        let [lower, whole] = [BlockStructure::TriangularLower, BlockStructure::Rectangular];
        matmul(schur.as_mut(), lower, Accum::Add, below, whole, below.transpose(), whole, -1.0, Par::Seq);
        Some(Self { factor, first, place, schur, diagonal })
    }

    /// The same A with other terms; false where that is not positive definite, round-off apart.
    pub fn renew<'a>(&mut self, terms: impl Iterator<Item = RankOne<'a>>) -> bool {
        let first = self.first;
        let mut diagonal = self.diagonal.clone();
        let mut trailing = self.factor.lower_mut().get_mut(first.., first..);
        trailing.copy_from_triangular_lower(&self.schur);
        terms.for_each(|term| {
            add(term, &self.place, first, |i, j, change| {
                trailing[(i, j)] += change;
                if i == j {
                    diagonal[i] += change;
                }
            });
        });
        self.factor.factorise_again(first, &diagonal)
    }

    /// The factor.
    pub fn factor(&self) -> &DenseFactor {
        &self.factor
    }

    /// Rows that change.
    pub fn changing(&self) -> usize {
        self.diagonal.len()
    }
}

/// Entries `δ b_i b_j` of the lower triangle from row `first` on, rows counted from there.
fn add((delta, b): RankOne, place: &[usize], first: usize, mut entry: impl FnMut(usize, usize, f64)) {
    for &(i, x) in b {
        for &(j, y) in b {
            if place[i] >= place[j] {
                entry(place[i] - first, place[j] - first, delta * x * y);
            }
        }
    }
}
