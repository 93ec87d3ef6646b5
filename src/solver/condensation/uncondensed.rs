//! The bodies and their springs as one sparse system, ordered and solved by the library alone: what checks the condensation.

use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

use crate::condensation::dense::RankOne;
use crate::condensation::factor::singular;
use crate::elasticity::ElasticSystem;
use crate::error::Error;

/// The unknowns of each body without condensation: `(K + Σ A k bᵀb) u = f + Σ A c b`, refined once; of every spring `A k` [N/mm] with the
/// sparse row b on the retained dofs, and its force `A c` at rest \[N\].
pub fn solve_uncondensed(system: &ElasticSystem, springs: &[(RankOne, f64)]) -> Result<Vec<Vec<f64>>, Error> {
    let not_definite = || singular(&"coupled system".into(), 0);
    // Lower triangle, right-hand side, and the first unknown of each body.
    let (mut triplets, mut retained, mut rhs, mut offsets) = (Vec::new(), Vec::new(), Vec::new(), vec![0]);
    for body in &system.bodies {
        let (matrix, offset) = (body.stiffness.as_ref(), rhs.len());
        for column in 0..matrix.ncols() {
            let entries = matrix.row_idx_of_col(column).zip(matrix.val_of_col(column));
            triplets.extend(entries.map(|(row, &value)| Triplet::new(offset + row, offset + column, value)));
        }
        retained.extend(body.retained.clone().map(|equation| offset + equation));
        rhs.extend_from_slice(&body.force);
        offsets.push(rhs.len());
    }
    for ((constant, row), force) in springs {
        for &(i, b_i) in *row {
            rhs[retained[i]] += b_i * force;
            let lower = row.iter().filter(|(j, _)| retained[i] >= retained[*j]);
            triplets.extend(lower.map(|&(j, b_j)| Triplet::new(retained[i], retained[j], constant * b_i * b_j)));
        }
    }
    let n = rhs.len();
    let matrix = SparseColMat::try_new_from_triplets(n, n, &triplets).map_err(|_| not_definite())?;
    let factor = matrix.sp_cholesky(Side::Lower).map_err(|_| not_definite())?;
    let solve = |b: &[f64]| -> Vec<f64> {
        let mut x = Mat::from_fn(n, 1, |i, _| b[i]);
        factor.solve_in_place(x.as_mut());
        (0..n).map(|i| x[(i, 0)]).collect()
    };
    let mut x = solve(&rhs);
    let mut residual = rhs;
    for &Triplet { row, col, val } in &triplets {
        residual[row] -= val * x[col];
        if row != col {
            residual[col] -= val * x[row];
        }
    }
    x.iter_mut().zip(solve(&residual)).for_each(|(x, change)| *x += change);
    Ok(offsets.windows(2).map(|pair| x[pair[0]..pair[1]].to_vec()).collect())
}
