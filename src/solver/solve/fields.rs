//! Fields on the whole mesh, recovered from the condensed solution.

use crate::elasticity::{axis, stress};
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::solution::Solution;
use crate::solve::Discretisation;

/// Fields recovered on the whole mesh.
#[derive(Clone, Debug)]
pub struct Fields {
    /// Displacement of every node \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// `[σ_x, σ_y, τ_xy]` at every node \[MPa\], tension positive.
    pub stress: Vec<[f64; 3]>,
    /// Unknowns of each body in its own frames and numbering \[mm\].
    pub unknowns: Vec<Vec<f64>>,
}

impl Discretisation {
    /// Displacement of every node \[mm\] under a share of loads and prescribed displacements, by one back-substitution
    /// per body.
    pub fn displacement_under(&self, share: f64, solution: &Solution) -> Vec<[f64; 2]> {
        let unknowns = self.condensed.recover(share, &solution.displacement);
        self.system.nodal_displacements(share, &unknowns)
    }

    /// Displacement \[mm\] and stress \[MPa\] at every node, by one back-substitution per body.
    pub fn recover(&self, solution: &Solution) -> Result<Fields, Error> {
        self.recover_under(1.0, solution)
    }

    /// The same under a share of loads and prescribed displacements, as where an iteration ended before the last
    /// increment.
    pub fn recover_under(&self, share: f64, solution: &Solution) -> Result<Fields, Error> {
        let unknowns = self.condensed.recover(share, &solution.displacement);
        let displacement = self.system.nodal_displacements(share, &unknowns);
        let stress = stress::at_nodes(&self.scene, &self.mesh, &displacement)?;
        Ok(Fields { displacement, stress, unknowns })
    }

    /// Hoop stress along the arc of a contact, on the second body if there is one: contact coordinate of a node \[rad\]
    /// and `σ_x cos² s + σ_y sin² s + 2 τ_xy sin s cos s` \[MPa\], by rising coordinate.
    pub fn hoop_stresses(&self, fields: &Fields, contact: usize) -> Result<Vec<[f64; 2]>, Error> {
        let pair = &self.scene.contacts[contact];
        let edges = self.mesh.boundary(&self.scene, pair.second.unwrap_or(pair.first), CONTACT)?;
        let stress = |&node: &usize| {
            let (at, [x, y, xy]) = (pair.path.coordinate(self.mesh.points[node]), fields.stress[node]);
            let (sin, cos) = at.sin_cos();
            [at, x * cos * cos + y * sin * sin + 2.0 * xy * sin * cos]
        };
        let mut along: Vec<[f64; 2]> = edges.iter().flatten().map(stress).collect();
        along.sort_by(|a, b| a[0].total_cmp(&b[0]));
        along.dedup_by(|a, b| a[0] <= b[0]);
        Ok(along)
    }

    /// Stress across the plane at every node of recovered fields, of bodies of revolution the hoop stress \[MPa\].
    ///
    /// A hoop strain is `u_r/r` of the node, as accurate as displacements; on the axis `σ_θ = σ_r`.
    pub fn stress_across(&self, fields: &Fields) -> Vec<f64> {
        self.across(&fields.displacement, &fields.stress)
    }

    /// The same of displacements and stresses of all nodes.
    pub(super) fn across(&self, displacement: &[[f64; 2]], stress: &[[f64; 3]]) -> Vec<f64> {
        let mut across = vec![0.0; stress.len()];
        for (index, (body, part)) in self.scene.bodies.iter().zip(&self.mesh.bodies).enumerate() {
            let on_axis = axis::holds(&self.scene, &self.mesh, index);
            for node in part.nodes.clone() {
                let radial = self.scene.plane.radial().unwrap_or(0);
                let hoop_strain = displacement[node][radial] / self.mesh.points[node][radial];
                across[node] = match on_axis(node) {
                    true => stress[node][radial],
                    false => stress::across(stress[node], self.scene.plane, &body.material, hoop_strain),
                };
            }
        }
        across
    }

    /// Von Mises stress at every node of recovered fields \[MPa\].
    pub fn von_mises(&self, fields: &Fields) -> Vec<f64> {
        let across = self.stress_across(fields);
        fields.stress.iter().zip(across).map(|(stress, across)| stress::von_mises(*stress, across)).collect()
    }
}
