//! Where: structured, graded, exactly curved meshes of quadrilaterals of order 1, 2 and 4 to 8.
//!
//! * [`connectivity`] — nodes, cells and boundaries.
//! * [`spacing`] — one-dimensional laws of element size.
//! * [`block`] — transfinite interpolation inside four sides.
//! * `layered` — layers of cells towards the ends of contacts.
//! * `outline` — from the scene's shapes to blocks.
//! * `merge` — from blocks to nodes and cells.
//! * `given` — meshes made elsewhere, and their halving.
//! * `sound` — whether given meshes hang together.
//! * [`candidates`] — the contact nodes with their normals.
//! * [`order`] — element order: the nodes of a cell; how fine a mesh is.
//! * [`lobatto`] — the points on which cells of order 4 and more have them.
//! * [`size`] — how large a mesh would be.
//! * [`variant`] — the same mesh mirrored, renumbered or shaken.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::mesh::{Mesh, Order, Resolution};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Linear };
//! let mesh = Mesh::of(&scene, resolution)?;
//! let finer = Mesh::of(&scene, Resolution { refinement: 1, ..resolution })?;
//! assert_eq!(finer.cells(), 4 * mesh.cells());
//! # Ok::<(), signorini::error::Error>(())
//! ```

pub mod block;
pub mod candidates;
pub mod connectivity;
pub mod lobatto;
pub mod order;
pub mod size;
pub mod spacing;
pub mod variant;

mod given;
mod layered;
mod merge;
mod outline;
mod sound;

use crate::error::Error;
use crate::scene::{Scene, Shape};

pub use connectivity::{BodyMesh, Candidate, Edge, Mesh};
pub use order::{Order, Resolution};

impl Mesh {
    /// Meshes every body of a scene.
    pub fn of(scene: &Scene, resolution: Resolution) -> Result<Self, Error> {
        scene.validate()?;
        if !resolution.is_allowed() {
            return Err(Error::value(
                scene.name.as_str(),
                "resolution",
                resolution.elements,
                "elements per half-width (or 10 mm of arc) must lie between 1 and 4096",
                "use 8 to 32",
            ));
        }
        given::refuse_others(scene, resolution.order)?;
        let mut mesh = Self { order: resolution.order, points: vec![], connectivity: vec![], bodies: vec![] };
        for (index, body) in scene.bodies.iter().enumerate() {
            match &body.shape {
                Shape::Given(given) if resolution.refinement == 0 => mesh.append_given(given),
                Shape::Given(given) => mesh.append(&given.blocks(resolution.refinement)),
                shape => {
                    let blocks = outline::Layout::new(scene, resolution, index).blocks(shape);
                    mesh.append(&layered::towards_ends(blocks, scene, index, resolution.order));
                }
            }
        }
        sound::refuse_loose(&mesh, scene)?;
        candidates::find(&mut mesh, scene)?;
        Ok(mesh)
    }
}
