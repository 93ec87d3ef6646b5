//! How bodies resist: stiffness, loads and supports of each body, and stresses from displacements.
//!
//! * [`shape_functions`] — 4-node and 8-node quadrilaterals, and their edges.
//! * [`quadrature`] — Gauss rules.
//! * [`element`] — element stiffness.
//! * [`freedoms`] — which displacement components are unknown.
//! * [`loads`] — consistent nodal forces.
//! * [`rigid_motion`] — refuses bodies that are free to move.
//! * [`stress`] — nodal stresses.

pub mod element;
pub mod freedoms;
pub mod loads;
pub mod quadrature;
pub mod rigid_motion;
pub mod shape_functions;
pub mod stress;

use faer::sparse::{SparseColMat, Triplet};

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

pub use freedoms::{Freedom, Freedoms};

/// `K q = f` for every body, with the normal freedoms of the candidate contact nodes known.
#[derive(Clone, Debug)]
pub struct ElasticSystem {
    /// One system per body; bodies are coupled by contact only.
    pub bodies: Vec<BodySystem>,
}

/// Stiffness, load and numbering of one body.
#[derive(Clone, Debug)]
pub struct BodySystem {
    /// Name of the body.
    pub name: String,
    /// Lower triangle of the stiffness matrix `K` [N/mm].
    pub stiffness: SparseColMat<usize, f64>,
    /// Load vector `f`, prescribed displacements included \[N\].
    pub force: Vec<f64>,
    /// Numbering.
    pub freedoms: Freedoms,
    /// Equations of the outward normal displacements of the candidate nodes.
    pub retained: Vec<usize>,
}

impl ElasticSystem {
    /// Assembles stiffness and loads of every body of the mesh of a scene.
    pub fn assemble(scene: &Scene, mesh: &Mesh) -> Result<Self, Error> {
        Self::assemble_scaled(scene, mesh, &|_| 1.0)
    }

    /// The same with the stiffness of every cell times a factor of its index.
    pub fn assemble_scaled(scene: &Scene, mesh: &Mesh, factor: &dyn Fn(usize) -> f64) -> Result<Self, Error> {
        let bodies = (0..scene.bodies.len()).map(|body| BodySystem::assemble(scene, mesh, body, factor));
        Ok(Self { bodies: bodies.collect::<Result<_, _>>()? })
    }

    /// Number of unknown displacement components.
    pub fn freedoms(&self) -> usize {
        self.bodies.iter().map(|body| body.freedoms.equations).sum()
    }

    /// Nodal displacements \[mm\] from the solution of each body, in mesh order.
    pub fn nodal_displacements(&self, solutions: &[Vec<f64>]) -> Vec<[f64; 2]> {
        let per_body = self.bodies.iter().zip(solutions);
        per_body.flat_map(|(body, solution)| body.freedoms.displacements(solution)).collect()
    }
}

impl BodySystem {
    fn assemble(scene: &Scene, mesh: &Mesh, body: usize, factor: &dyn Fn(usize) -> f64) -> Result<Self, Error> {
        let freedoms = Freedoms::number(scene, mesh, body)?;
        rigid_motion::refuse_free(scene, mesh, body, &freedoms)?;
        let mut force = loads::nodal_forces(scene, mesh, body, &freedoms)?;
        let stiffness = assemble_stiffness(scene, mesh, body, &freedoms, factor, &mut force)?;
        let retained = freedoms.retained.clone();
        Ok(Self { name: scene.bodies[body].name.clone(), stiffness, force, freedoms, retained })
    }

    /// Applied load along y: the load vector times a unit rigid motion along y, prescribed components at rest \[N\].
    pub fn applied_vertical(&self) -> f64 {
        let mut motion = vec![0.0; self.force.len()];
        for (pair, n) in self.freedoms.components.iter().zip(&self.freedoms.axes) {
            for (freedom, y) in pair.iter().zip([n[1], n[0]]) {
                if let Freedom::Equation(equation) = freedom {
                    motion[*equation] = y;
                }
            }
        }
        motion.iter().zip(&self.force).map(|(m, f)| m * f).sum()
    }

    /// `K u` for a vector of unknowns \[N\].
    pub fn product(&self, u: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; u.len()];
        let matrix = self.stiffness.as_ref();
        for (column, &u_column) in u.iter().enumerate() {
            let rows = matrix.row_idx_of_col(column);
            for (row, &value) in rows.zip(matrix.val_of_col(column)) {
                out[row] += value * u_column;
                if row != column {
                    out[column] += value * u[row];
                }
            }
        }
        out
    }
}

/// Lower triangle of `K = Σ Tᵀ k T`; prescribed displacements move to the load, `f ← f − k u_p`.
fn assemble_stiffness(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    freedoms: &Freedoms,
    factor: &dyn Fn(usize) -> f64,
    force: &mut [f64],
) -> Result<SparseColMat<usize, f64>, Error> {
    let elasticity = scene.bodies[body].material.stiffness(scene.plane);
    let per_cell = mesh.order.nodes_per_cell() * 2;
    let cells = mesh.bodies[body].cells.clone();
    let mut triplets = Vec::with_capacity(cells.len() * per_cell * (per_cell + 1) / 2);
    for cell in cells {
        let nodes = mesh.cell(cell);
        let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
        let mut k = element::stiffness(&points, &elasticity, scene.thickness)
            .map_err(|jacobian| Error::DegenerateCell { cell, body: scene.bodies[body].name.clone(), jacobian })?;
        k.iter_mut().flatten().for_each(|entry| *entry *= factor(cell));
        freedoms.rotate(nodes, &mut k);
        let of_cell: Vec<Freedom> = nodes.iter().flat_map(|&n| freedoms.of_node(n)).collect();
        scatter(&of_cell, &k, &mut triplets, force);
    }
    SparseColMat::try_new_from_triplets(freedoms.equations, freedoms.equations, &triplets).map_err(|error| {
        Error::value(
            &scene.name,
            "stiffness",
            format!("{error:?}"),
            "a sparse matrix must fit in memory",
            "lower the resolution",
        )
    })
}

fn scatter(of_cell: &[Freedom], k: &[Vec<f64>], triplets: &mut Vec<Triplet<usize, usize, f64>>, force: &mut [f64]) {
    for (i, &row) in of_cell.iter().enumerate() {
        let Freedom::Equation(row) = row else { continue };
        for (j, &column) in of_cell.iter().enumerate() {
            match column {
                Freedom::Equation(column) if row >= column => triplets.push(Triplet::new(row, column, k[i][j])),
                Freedom::Equation(_) => {}
                Freedom::Prescribed(value) => force[row] -= k[i][j] * value,
            }
        }
    }
}
