//! What the contact sees of the bodies: the condensed stiffness `S` and load `f̂` on the normal freedoms of the candidates.
//!
//! * [`factor`] — sparse Cholesky with the retained freedoms last; its trailing block is the Schur complement.

pub mod factor;

use faer::Mat;

use crate::elasticity::{BodySystem, ElasticSystem};
use crate::error::Error;

use factor::Factor;

/// `S u = f̂` on the retained freedoms of all bodies, body after body.
#[derive(Debug)]
pub struct Condensed {
    /// Condensed stiffness `S = K_cc − K_ci K_ii⁻¹ K_ic` [N/mm], block-diagonal by body.
    pub stiffness: Mat<f64>,
    /// Condensed load `f̂ = f_c − K_ci K_ii⁻¹ f_i` \[N\].
    pub load: Vec<f64>,
    /// First retained freedom of each body.
    pub offsets: Vec<usize>,
    factors: Vec<Factor>,
}

impl ElasticSystem {
    /// Condenses every body on its candidate contact normals, out of one sparse Cholesky factorisation each.
    pub fn condense(&self) -> Result<Condensed, Error> {
        let factors = self.bodies.iter().map(Factor::new).collect::<Result<Vec<_>, _>>()?;
        let mut offsets = vec![0];
        for body in &self.bodies {
            offsets.push(offsets[offsets.len() - 1] + body.retained.len());
        }
        let total = offsets[offsets.len() - 1];
        let mut stiffness = Mat::zeros(total, total);
        let mut load = Vec::with_capacity(total);
        for ((body, factor), &at) in self.bodies.iter().zip(&factors).zip(&offsets) {
            let (schur, condensed) = factor.schur(body);
            let m = body.retained.len();
            stiffness.submatrix_mut(at, at, m, m).copy_from(&schur);
            load.extend(condensed);
        }
        Ok(Condensed { stiffness, load, offsets, factors })
    }
}

impl Condensed {
    /// Number of retained freedoms.
    pub fn retained(&self) -> usize {
        self.load.len()
    }

    /// Operations of the sparse factorisations, `Σ (column length)²`.
    pub fn operations(&self) -> f64 {
        self.factors.iter().map(Factor::operations).sum()
    }

    /// All unknowns of each body from the retained ones and the forces the contact exerts on them, by one
    /// back-substitution: `(K + σ I_c) u = f + λ + σ u_c`.
    pub fn recover(&self, system: &ElasticSystem, retained: &[f64], contact_force: &[f64]) -> Vec<Vec<f64>> {
        let bodies = system.bodies.iter().zip(&self.factors).zip(&self.offsets);
        bodies
            .map(|((body, factor), &at)| {
                let range = at..at + body.retained.len();
                factor.recover(body, &retained[range.clone()], &contact_force[range])
            })
            .collect()
    }
}

/// A spring between retained freedoms.
#[derive(Clone, Debug)]
pub struct CoupledSpring {
    /// Sparse row `b` on the retained freedoms.
    pub row: Vec<(usize, f64)>,
    /// Spring constant `A k` [N/mm].
    pub constant: f64,
    /// Force `A c` along `b` at rest \[N\].
    pub force: f64,
}

/// The same unknowns without condensation: `(K + Σ A k bᵀb) u = f + Σ A c b`, used to check the condensed solve.
pub fn solve_uncondensed(system: &ElasticSystem, springs: &[CoupledSpring]) -> Result<Vec<Vec<f64>>, Error> {
    factor::solve_coupled(system, springs)
}

/// Which equations of a body are retained.
fn is_retained(body: &BodySystem) -> Vec<bool> {
    let mut retained = vec![false; body.freedoms.equations];
    body.retained.iter().for_each(|&equation| retained[equation] = true);
    retained
}
