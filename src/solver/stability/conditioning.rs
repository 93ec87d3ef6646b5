//! What stiff springs cost: the condition number of `S + K_c`, and the digits its solution loses; and how far pressures
//! move when the bodies' stiffness is not quite what it was.

use faer::prelude::Solve;
use faer::{Mat, Side};

use crate::algorithm::{ContactProblem, Springs};
use crate::measure;
use crate::solution::Work;

/// Condition of `S + Σ A k b bᵀ`, and errors of the pressures `p = k (w − g)` found with it.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Conditioning {
    /// Largest over smallest eigenvalue; infinite where round-off leaves none above zero.
    pub condition: f64,
    /// Largest error of one solve over the largest pressure; NaN where the matrix is refused.
    pub plain: f64,
    /// The same after the refinement that every iteration makes; NaN where the matrix is refused.
    pub refined: f64,
}

/// Condition and errors under springs `k` that start at the gap; zero is open.
///
/// The reference is the mixed system `S u + Σ A p b = f̂`, `b·u − p/k = g` on the closed points, whose condition does
/// not grow with k. None where no eigenvalues are found.
pub fn of(problem: &ContactProblem, stiffness: &[f64]) -> Option<Conditioning> {
    let eigenvalues = problem.matrix(stiffness).self_adjoint_eigenvalues(Side::Lower).ok()?;
    let (smallest, largest) = (eigenvalues.first()?, eigenvalues.last()?);
    let condition = if *smallest > 0.0 { largest / smallest } else { f64::INFINITY };
    let work = &mut Work::default();
    let Some(factor) = problem.factorise(stiffness, work) else {
        return Some(Conditioning { condition, plain: f64::NAN, refined: f64::NAN });
    };
    let exact = mixed(problem, stiffness);
    let springs = Springs { stiffness: stiffness.to_vec(), force: vec![0.0; stiffness.len()] };
    let refined = problem.equilibrium(&factor, &springs, |point| point.gap, work).pressure;
    let mut rhs = problem.load.to_vec();
    for (point, k) in problem.points.iter().zip(stiffness) {
        point.add_row(point.weight * k * point.gap, &mut rhs);
    }
    let u = factor.solve(&rhs);
    let plain = problem.points.iter().zip(stiffness).map(|(point, k)| k * (point.approach(&u) - point.gap));
    let largest = exact.iter().map(|p| p.abs()).fold(0.0, f64::max);
    let error =
        |pressures: Vec<f64>| measure::largest(pressures.iter().zip(&exact).map(|(p, e)| (p - e).abs() / largest));
    Some(Conditioning { condition, plain: error(plain.collect()), refined: error(refined) })
}

/// Springs that hold closed points, over the mean diagonal of S: far stiffer than the bodies, with digits to spare.
const HOLDING: f64 = 1e5;

/// How the pressure of a closed point changes.
#[derive(Clone, Debug)]
pub struct Influence {
    /// With forces on the retained dofs, `δp = gᵀ δf`: displacements `g = (S + K)⁻¹ k b` [MPa/N].
    pub of_forces: Vec<f64>,
    /// With the gaps of the closed points, `δp = Σ_j m_j δg_j`: point index and m [MPa/mm].
    pub of_gaps: Vec<(usize, f64)>,
}

/// Influence of forces and gaps on the pressure of each closed point, in their order; none where the closed points
/// leave a body free.
pub fn influence(problem: &ContactProblem, pressures: &[f64]) -> Option<Vec<Influence>> {
    let n = problem.load.len();
    let trace = (0..n).map(|i| problem.stiffness[(i, i)]).sum::<f64>();
    let area = problem.points.iter().map(|point| point.weight).sum::<f64>() / problem.points.len() as f64;
    let hold = HOLDING * trace / (n as f64 * area);
    let stiffness: Vec<f64> = pressures.iter().map(|p| if *p > 0.0 { hold } else { 0.0 }).collect();
    let factor = problem.factorise(&stiffness, &mut Work::default())?;
    let closed = || (0..stiffness.len()).filter(|&i| stiffness[i] > 0.0);
    let of = |i: usize| {
        let mut unit = vec![0.0; n];
        problem.points[i].add_row(hold, &mut unit);
        let of_forces = factor.solve(&unit);
        let of_gap = |j: usize| {
            let point = &problem.points[j];
            let own = if i == j { hold } else { 0.0 };
            (j, hold * point.weight * point.approach(&of_forces) - own)
        };
        Influence { of_gaps: closed().map(of_gap).collect(), of_forces }
    };
    Some(closed().map(of).collect())
}

/// Pressures of the mixed system by LU with full pivoting, refined once; open points carry none \[MPa\].
fn mixed(problem: &ContactProblem, stiffness: &[f64]) -> Vec<f64> {
    let closed: Vec<usize> = (0..stiffness.len()).filter(|&i| stiffness[i] > 0.0).collect();
    let area: f64 = problem.points.iter().map(|point| point.weight).sum();
    let (n, unit) = (problem.load.len(), problem.load.iter().map(|f| f.abs()).sum::<f64>() / area);
    let mut matrix = Mat::zeros(n + closed.len(), n + closed.len());
    let mut rhs = Mat::zeros(n + closed.len(), 1);
    matrix.submatrix_mut(0, 0, n, n).copy_from(problem.stiffness.to_dense());
    problem.load.iter().enumerate().for_each(|(i, f)| rhs[(i, 0)] = *f);
    for (row, &i) in closed.iter().enumerate() {
        let point = &problem.points[i];
        let scale = point.weight * unit;
        for &(dof, b) in &point.row {
            matrix[(dof, n + row)] += scale * b;
            matrix[(n + row, dof)] += scale * b;
        }
        matrix[(n + row, n + row)] = -scale * unit / stiffness[i];
        rhs[(n + row, 0)] = scale * point.gap;
    }
    let lu = matrix.full_piv_lu();
    let mut x = lu.solve(&rhs);
    x += lu.solve(&(&rhs - &matrix * &x));
    let mut pressures = vec![0.0; stiffness.len()];
    closed.iter().enumerate().for_each(|(row, &i)| pressures[i] = unit * x[(n + row, 0)]);
    pressures
}
