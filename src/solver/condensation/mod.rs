//! What the contact sees of the bodies: the condensed stiffness `S` and load `f̂` on the normal dofs of the candidates.
//!
//! * [`factor`] — sparse Cholesky factorisation in the order of elimination.
//! * [`eliminated`] — one body: S is the trailing block of its factor.
//! * [`dense`] — dense Cholesky factorisation, for the algorithms.
//! * [`trailing`] — the same where only the last rows change.
//! * [`stiffness`] — S of all bodies, dense or sparse, and its factors with springs.
//! * [`plain`] — one solve by the library alone, the unit of all timings; and one without condensation, for checks.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::elasticity::ElasticSystem;
//! use signorini::mesh::{Mesh, Order, Resolution};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let mesh = Mesh::of(&scene, Resolution { elements: 8, refinement: 0, order: Order::Linear })?;
//! let condensed = ElasticSystem::assemble(&scene, &mesh)?.condense()?;
//! assert_eq!(condensed.retained(), mesh.bodies[0].candidates.len());
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod dense;
pub mod eliminated;
pub mod factor;
pub mod plain;
pub mod stiffness;
pub mod trailing;

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use faer::Mat;

use crate::clock::{Clock, Stage};
use crate::elasticity::ElasticSystem;
use crate::error::Error;
use crate::mesh::size::is_sparse;

use eliminated::Eliminated;
pub use plain::{Plain, solve_uncondensed};
use stiffness::{Blocks, Stiffness};

/// `S u = f̂` on the retained dofs of all bodies, body after body.
#[derive(Debug)]
pub struct Condensed {
    /// Condensed stiffness `S = K_cc − K_ci K_ii⁻¹ K_ic` [N/mm], block-diagonal by body.
    pub stiffness: Stiffness,
    /// Condensed load `f̂ = f_c − K_ci K_ii⁻¹ f_i` \[N\].
    pub load: Vec<f64>,
    /// First retained dof of each body.
    pub offsets: Vec<usize>,
    bodies: Vec<Eliminated>,
    /// What was recovered last, of bodies whose factors are made again for that.
    recovered: Mutex<Option<Recovered>>,
}

/// Share of the load, retained dofs, and all unknowns of each body.
type Recovered = (f64, Vec<f64>, Vec<Vec<f64>>);

/// Two bodies that a contact couples, each with those of its retained dofs that take part.
pub type Coupled = [(usize, Range<usize>); 2];

impl ElasticSystem {
    /// Condenses every body on its candidate contact normals, out of one sparse Cholesky factorisation each.
    pub fn condense(&self) -> Result<Condensed, Error> {
        self.condense_timed(None, &mut Clock::silent())
    }

    /// The same, its stages timed; given which retained dofs contacts couple, each with its body, S may be sparse.
    pub fn condense_timed(&self, contacts: Option<&[Coupled]>, clock: &mut Clock) -> Result<Condensed, Error> {
        let sizes = || self.bodies.iter().map(|body| body.dofs.retained.len() as f64);
        let contacts = contacts.filter(|_| is_sparse(sizes));
        let eliminated = |body| Eliminated::of(body, contacts.is_none(), clock);
        let bodies = self.bodies.iter().map(eliminated).collect::<Result<Vec<_>, _>>()?;
        clock.time(Stage::SchurComplement, || self.gathered(bodies, contacts))
    }

    /// The condensed bodies side by side, sparse where it is told which dofs are coupled.
    fn gathered(&self, bodies: Vec<Eliminated>, contacts: Option<&[Coupled]>) -> Result<Condensed, Error> {
        let mut offsets = vec![0];
        for body in &self.bodies {
            offsets.push(offsets[offsets.len() - 1] + body.dofs.retained.len());
        }
        let load = bodies.iter().flat_map(Eliminated::load).collect();
        if let Some(contacts) = contacts {
            let of_body = |(body, dofs): &(usize, Range<usize>)| offsets[*body] + dofs.start..offsets[*body] + dofs.end;
            let coupled: Vec<_> = contacts.iter().map(|sides| sides.each_ref().map(of_body)).collect();
            let blocks: Vec<_> = bodies.iter().map(Eliminated::stiffness).collect();
            let stiffness = Stiffness::Sparse(Blocks::of(&blocks, &offsets, &coupled)?);
            return Ok(Condensed { stiffness, load, offsets, bodies, recovered: Mutex::default() });
        }
        let total = offsets[offsets.len() - 1];
        let mut stiffness = Mat::zeros(total, total);
        for (body, ends) in bodies.iter().zip(offsets.windows(2)) {
            let m = ends[1] - ends[0];
            stiffness.submatrix_mut(ends[0], ends[0], m, m).copy_from(body.stiffness());
        }
        Ok(Condensed { stiffness: Stiffness::Dense(stiffness), load, offsets, bodies, recovered: Mutex::default() })
    }
}

impl Condensed {
    /// Number of retained dofs.
    pub fn retained(&self) -> usize {
        self.load.len()
    }

    /// Operations of the sparse factorisations, `Σ (column length)²`.
    pub fn operations(&self) -> f64 {
        self.bodies.iter().map(|body| body.factor().operations()).sum()
    }

    /// Entries of the sparse factors.
    pub fn factor_entries(&self) -> usize {
        self.bodies.iter().map(|body| body.factor().entries()).sum()
    }

    /// All unknowns of each body from the retained ones under `factor` times the load, by one back-substitution:
    /// `K_ii u_i = f_i − K_ic u_c`.
    pub fn recover(&self, factor: f64, retained: &[f64]) -> Vec<Vec<f64>> {
        let again = || self.recover_all(factor, &[retained]).into_iter().flatten().collect::<Vec<_>>();
        if self.stiffness.is_dense() {
            return again();
        }
        let mut last = self.recovered.lock().unwrap_or_else(PoisonError::into_inner);
        let is_it = |(of, own, _): &&Recovered| of.total_cmp(&factor).is_eq() && own == retained;
        if let Some((.., unknowns)) = last.as_ref().filter(is_it) {
            return unknowns.clone();
        }
        let unknowns = again();
        *last = Some((factor, retained.to_vec(), unknowns.clone()));
        unknowns
    }

    /// The same for several solutions in one pass through the factors: body after body, solution after solution.
    pub fn recover_all(&self, factor: f64, retained: &[&[f64]]) -> Vec<Vec<Vec<f64>>> {
        let parts = self.bodies.iter().zip(self.offsets.windows(2));
        let of_body = |ends: &[usize]| -> Vec<&[f64]> { retained.iter().map(|u| &u[ends[0]..ends[1]]).collect() };
        parts.map(|(body, ends)| body.recover(factor, &of_body(ends))).collect()
    }
}
