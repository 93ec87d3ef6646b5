//! What everything is held against: one sparse Cholesky solve of the same matrix by the library's own high-level solver.

use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

use crate::condensation::eliminated::shifted;
use crate::condensation::factor::singular;
use crate::elasticity::BodySystem;
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
    /// The system of a body; the shift σ is that of its condensation, without which bodies supported by contact alone are singular.
    pub fn of(body: &BodySystem) -> Result<Self, Error> {
        let equations = body.dofs.in_mesh_order();
        let n = equations.len();
        let mut row_of = vec![0; n];
        equations.iter().enumerate().for_each(|(row, &equation)| row_of[equation] = row);
        let (values, _) = shifted(body);
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
