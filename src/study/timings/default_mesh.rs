//! The mesh that a scene has by default, and what coarser and finer ones away from the contact would change.

use serde::Serialize;

use crate::case::Case;
use crate::error::Error;
use crate::mesh::Resolution;
use crate::scene::Grading;
use crate::solve::{Discretisation, Formulation, Run};

/// Growth along the surface and into the depth, and the coarsest element over the body, of the meshes tried.
///
/// Faster growth than that of the scenes cost truncated Hertz the order of its half-width on 4-node cells, the cylinder the
/// predicted iterations of kinematic load, and the plate the hoop stress of its rim opposite the pin.
const TRIED: [[f64; 3]; 4] = [[1.3, 1.25, 0.1], [1.5, 1.4, 0.2], [1.7, 1.6, 0.3], [2.0, 1.8, 0.5]];
/// How many times finer the mesh is that stands for the truth.
pub const FINER: usize = 4;

/// Meshes of a scene against one much finer.
#[derive(Clone, Debug, Serialize)]
pub struct DefaultMesh {
    /// The scene.
    pub scene: String,
    /// Elements within the contact.
    pub elements: usize,
    /// Degrees of freedom of the finer mesh.
    pub finer_dofs: usize,
    /// The scene's own.
    pub own: Tried,
    /// Of other growth.
    pub others: Vec<Tried>,
}

/// One mesh.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Tried {
    /// Growth along the surface and into the depth, coarsest element over the body.
    pub growth: [f64; 3],
    /// Degrees of freedom.
    pub dofs: usize,
    /// Relative error of the peak, with sign.
    pub peak: f64,
    /// Relative error of the second-moment width, with sign.
    pub half_width: f64,
}

/// The mesh of a case against one much finer, and others beside it.
pub fn measure(case: &Case) -> Result<DefaultMesh, Error> {
    let grading = case.scene.grading;
    let own = [grading.along, grading.depth, grading.coarsest];
    let elements = case.resolution.elements;
    let finer = solved(case, own, FINER * elements)?;
    let tried = |growth: [f64; 3]| -> Result<Tried, Error> {
        let run = solved(case, growth, elements)?;
        let (found, wanted) = (run.measures(), finer.measures());
        let [peak, half_width] = [
            found.peak.pressure / wanted.peak.pressure - 1.0,
            found.second_moment_width / wanted.second_moment_width - 1.0,
        ];
        Ok(Tried { growth, dofs: run.dofs, peak, half_width })
    };
    let is_other = |growth: &[f64; 3]| growth.map(f64::to_bits) != own.map(f64::to_bits);
    Ok(DefaultMesh {
        scene: case.name.clone(),
        elements,
        finer_dofs: finer.dofs,
        own: tried(own)?,
        others: TRIED.into_iter().filter(is_other).map(tried).collect::<Result<_, _>>()?,
    })
}

fn solved(case: &Case, [along, depth, coarsest]: [f64; 3], elements: usize) -> Result<Run, Error> {
    let mut scene = case.scene.clone();
    scene.grading = Grading { along, depth, coarsest, ..scene.grading };
    let resolution = Resolution { elements, ..case.resolution };
    Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification())
}
