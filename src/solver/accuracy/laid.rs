//! A scene laid out for a mesh.

use crate::mesh::Resolution;
use crate::mesh::size::{MOST, cells_of, dense, expected};
use crate::scene::Scene;

/// A scene laid out for a mesh.
pub(super) struct Laid {
    pub(super) scene: Scene,
    pub(super) resolution: Resolution,
    /// Growth along the surface; NaN where the mesh of every body is given.
    pub(super) growth: f64,
}

impl Laid {
    /// Why its mesh is too large to be solved, with so many cells at most.
    pub(super) fn too_large(&self, most_cells: f64) -> Option<String> {
        let (cells, [_, candidates]) = (cells_of(&self.scene, self.resolution), expected(&self.scene, self.resolution));
        let most = MOST[1];
        let fits = cells <= most_cells && dense(&self.scene, self.resolution) <= most;
        (!fits).then(|| {
            format!("the next mesh would have about {cells:.1e} cells and {candidates:.0} candidate elements, more than {most_cells:.0e} or {most}")
        })
    }
}
