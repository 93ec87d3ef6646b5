//! How bodies resist: stiffness, loads and supports of each body, and stresses from displacements.
//!
//! * [`shape_functions`] — of quadrilaterals of every order, and of their edges.
//! * [`quadrature`] — Gauss rules.
//! * [`dilatation`] — what keeps nearly incompressible cells from locking.
//! * [`element`] — element stiffness, and stresses within a cell.
//! * [`graph`] — which nodes share a cell, and the order in which they are eliminated.
//! * [`dofs`] — which displacement components are unknown, numbered in that order.
//! * [`assembly`] — the stiffness matrix.
//! * [`loads`] — consistent nodal forces.
//! * [`mod@point`] — where in the cells a point lies.
//! * [`rigid_motion`] — motions that no support stops, and bodies refused for them.
//! * [`stress`] — nodal stresses.
//! * [`axis`] — the axis of bodies of revolution.
//! * [`reactions`] — what supports exert.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::elasticity::ElasticSystem;
//! use signorini::mesh::{Mesh, Order, Resolution};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let mesh = Mesh::of(&scene, Resolution { elements: 8, refinement: 0, order: Order::Linear })?;
//! let system = ElasticSystem::assemble(&scene, &mesh)?;
//! // The quarter carries half the load, downwards.
//! let load = std::f64::consts::PI * 2.5f64.powi(2) * scene.contact_modulus() / (4.0 * 50.0);
//! let half = 0.5 * load * scene.thickness;
//! assert!((system.bodies[0].applied_vertical() + half).abs() <= 1e-9 * half);
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod assembly;
pub mod axis;
pub mod dilatation;
pub mod dofs;
pub mod element;
pub mod graph;
pub mod loads;
pub mod point;
pub mod quadrature;
pub mod reactions;
pub mod rigid_motion;
pub mod shape_functions;
pub mod stress;

use std::sync::Arc;

use faer::sparse::{SparseColMat, SparseColMatRef};

use crate::error::{Error, Place};
use crate::mesh::Mesh;
use crate::scene::Scene;

pub use dofs::{Dofs, Freedom};
pub use graph::{Index, NodeGraph};

/// `K q = f` for every body, with the normal dofs of the candidate contact nodes known.
#[derive(Clone, Debug)]
pub struct ElasticSystem {
    /// One system per body; bodies are coupled by contact only.
    pub bodies: Vec<BodySystem>,
}

/// Stiffness, load and numbering of one body.
#[derive(Clone, Debug)]
pub struct BodySystem {
    /// The body, as errors name it.
    pub place: Place,
    /// Lower triangle of the stiffness matrix `K` [N/mm].
    pub stiffness: Arc<SparseColMat<Index, f64>>,
    /// Applied forces at each node, in x and y, as [`loads::at_nodes`] has them \[N\].
    pub applied: Vec<[f64; 2]>,
    /// Load vector `f`, prescribed displacements included \[N\].
    pub force: Vec<f64>,
    /// Numbering.
    pub dofs: Dofs,
}

/// The unknowns of every body, numbered in the order in which they are eliminated; refuses bodies that could move as a
/// whole.
pub fn numbered(scene: &Scene, mesh: &Mesh) -> Result<Vec<(NodeGraph, Dofs)>, Error> {
    let number = |body: usize| {
        let graph = NodeGraph::of(mesh, body);
        axis::refuse(scene, mesh, body)?;
        let dofs = Dofs::number(scene, mesh, body, &graph)?;
        rigid_motion::refuse_free(scene, mesh, body, &dofs)?;
        Ok((graph, dofs))
    };
    (0..scene.bodies.len()).map(number).collect()
}

impl ElasticSystem {
    /// Assembles stiffness and loads of every body of the mesh of a scene.
    pub fn assemble(scene: &Scene, mesh: &Mesh) -> Result<Self, Error> {
        Self::assemble_numbered(scene, mesh, numbered(scene, mesh)?, &|_| 1.0)
    }

    /// The same with unknowns that are already numbered, and the stiffness of every cell times a factor of its index.
    pub fn assemble_numbered(
        scene: &Scene,
        mesh: &Mesh,
        numbered: Vec<(NodeGraph, Dofs)>,
        factor: &(dyn Fn(usize) -> f64 + Sync),
    ) -> Result<Self, Error> {
        let bodies = numbered.into_iter().enumerate();
        let bodies = bodies.map(|(body, (graph, dofs))| BodySystem::assemble(scene, mesh, body, &graph, dofs, factor));
        Ok(Self { bodies: bodies.collect::<Result<_, _>>()? })
    }

    /// Number of unknown displacement components.
    pub fn dofs(&self) -> usize {
        self.bodies.iter().map(|body| body.dofs.equations).sum()
    }

    /// Nodal displacements \[mm\] from the solution of each body, in mesh order, where prescribed displacements are
    /// `share` times theirs.
    pub fn nodal_displacements(&self, share: f64, solutions: &[Vec<f64>]) -> Vec<[f64; 2]> {
        let per_body = self.bodies.iter().zip(solutions);
        per_body.flat_map(|(body, solution)| body.dofs.displacements(share, solution)).collect()
    }
}

impl BodySystem {
    fn assemble(
        scene: &Scene,
        mesh: &Mesh,
        body: usize,
        graph: &NodeGraph,
        dofs: Dofs,
        factor: &(dyn Fn(usize) -> f64 + Sync),
    ) -> Result<Self, Error> {
        let applied = loads::at_nodes(scene, mesh, body)?;
        let mut force = loads::vector(scene, mesh, body, &dofs, &applied)?;
        let stiffness = Arc::new(assembly::stiffness(scene, mesh, body, (graph, &dofs), factor, &mut force)?);
        Ok(Self { place: scene.place_of_body(body), stiffness, applied, force, dofs })
    }

    /// Applied load along y: its work on a unit motion along y \[N\].
    pub fn applied_vertical(&self) -> f64 {
        self.work_of_load(&|_| [0.0, 1.0])[0]
    }

    /// Work of the load vector on a displacement of the nodes, prescribed components at rest, and the sum of the sizes
    /// of its terms [N mm].
    pub fn work_of_load(&self, displacement: &dyn Fn(usize) -> [f64; 2]) -> [f64; 2] {
        let mut motion = vec![0.0; self.force.len()];
        for (k, (pair, n)) in self.dofs.components.iter().zip(&self.dofs.axes).enumerate() {
            let [u, v] = displacement(self.dofs.first + k);
            for (dof, along) in pair.iter().zip([n[0] * u + n[1] * v, n[0] * v - n[1] * u]) {
                if let Freedom::Equation(equation) = dof {
                    motion[*equation] = along;
                }
            }
        }
        let terms = || motion.iter().zip(&self.force).map(|(m, f)| m * f);
        [terms().sum(), terms().map(f64::abs).sum()]
    }

    /// `|K| |u|` for a vector of unknowns: the size of the terms in `K u` \[N\].
    pub fn terms_of_product(&self, u: &[f64]) -> Vec<f64> {
        summed(SparseColMat::as_ref(&self.stiffness), u, f64::abs)
    }

    /// `K u` for a vector of unknowns \[N\].
    pub fn product(&self, u: &[f64]) -> Vec<f64> {
        summed(SparseColMat::as_ref(&self.stiffness), u, |term| term)
    }
}

/// `Σ_j of(K_ij u_j)` of every row of a symmetric matrix, by its lower triangle.
pub(crate) fn summed(matrix: SparseColMatRef<Index, f64>, u: &[f64], of: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut sums = vec![0.0; u.len()];
    for (column, &u_column) in u.iter().enumerate() {
        let rows = matrix.row_idx_of_col(column);
        for (row, &value) in rows.zip(matrix.val_of_col(column)) {
            sums[row] += of(value * u_column);
            if row != column {
                sums[column] += of(value * u[row]);
            }
        }
    }
    sums
}
