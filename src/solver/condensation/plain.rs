//! What everything is held against, by the library's own high-level solver alone: one sparse Cholesky solve of the
//! matrix of a body, and the bodies with their springs as one sparse system, which checks the condensation.

use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

use crate::condensation::dense::RankOne;
use crate::condensation::eliminated::shifted;
use crate::condensation::factor::singular;
use crate::elasticity::{BodySystem, ElasticSystem};
use crate::error::{Error, Place};

/// `(K + σ I_c) u = f` of one body in the order of the mesh, as a user would hand it over.
#[derive(Debug)]
pub struct Plain {
    matrix: SparseColMat<usize, f64>,
    force: Mat<f64>,
    /// Equation of each row.
    equations: Vec<usize>,
    body: Place,
}

impl Plain {
    /// The system of a body; the shift σ is that of its condensation, without which bodies supported by contact alone
    /// are singular.
    pub fn of(body: &BodySystem) -> Result<Self, Error> {
        let equations = body.dofs.in_mesh_order();
        let n = equations.len();
        let mut row_of = vec![0; n];
        equations.iter().enumerate().for_each(|(row, &equation)| row_of[equation] = row);
        let (values, _) = shifted(&body.stiffness, body.dofs.retained.clone());
        let (starts, rows) = (body.stiffness.symbolic().col_ptr(), body.stiffness.symbolic().row_idx());
        let entry = |column: usize, at: usize| {
            let (i, j) = (row_of[rows[at] as usize], row_of[column]);
            Triplet::new(i.max(j), i.min(j), values[at])
        };
        let of_column =
            |column: usize| (starts[column] as usize..starts[column + 1] as usize).map(move |at| (column, at));
        let triplets: Vec<_> = (0..n).flat_map(of_column).map(|(column, at)| entry(column, at)).collect();
        let matrix = SparseColMat::try_new_from_triplets(n, n, &triplets).map_err(|_| singular(&body.place, 0))?;
        let force = Mat::from_fn(n, 1, |row, _| body.force[equations[row]]);
        Ok(Self { matrix, force, equations, body: body.place.clone() })
    }

    /// Ordering, analysis, factorisation and one solve, all at their defaults: the unknowns by equation.
    pub fn solve(&self) -> Result<Vec<f64>, Error> {
        let not_definite = |_| singular(&self.body, 0);
        let mut solution = self.force.clone();
        self.matrix.sp_cholesky(Side::Lower).map_err(not_definite)?.solve_in_place(solution.as_mut());
        let mut unknowns = vec![0.0; self.equations.len()];
        self.equations.iter().enumerate().for_each(|(row, &equation)| unknowns[equation] = solution[(row, 0)]);
        Ok(unknowns)
    }
}

/// The unknowns of each body without condensation: `(K + Σ A k bᵀb) u = f + Σ A c b`, refined once; of every spring
/// `A k` [N/mm] with the sparse row b on the retained dofs, and its force `A c` at rest \[N\].
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
        retained.extend(body.dofs.retained.clone().map(|equation| offset + equation));
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
