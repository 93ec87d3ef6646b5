//! Reactions: what the supports exert on the bodies.

use std::collections::BTreeMap;

use crate::elasticity::reactions;
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::Discretisation;

/// Part of a displacement by which two that are one may differ: units convert to it.
const SAME: f64 = 1e-9;

/// What one support exerts on its body.
#[derive(Clone, Copy, Debug)]
pub struct Reaction {
    /// Index of the body in the scene.
    pub body: usize,
    /// Index of the support in the body.
    pub support: usize,
    /// Force on the modelled part of the body along the component that is fixed, positive along x or y \[N\].
    pub force: f64,
}

impl Discretisation {
    /// The reaction of every support under a share of loads and prescribed displacements, as where an iteration ended
    /// before the last increment, from the equilibrium of the nodes that it holds: `R = Σ (f_int − f_load)`.
    ///
    /// Contact has no part in it: it acts along the normals of the candidates, which no support may hold. Loads,
    /// contact and reactions of a body add up to zero, as far as the contact pressures balance the load.
    pub fn reactions(&self, share: f64, solution: &Solution) -> Result<Vec<Reaction>, Error> {
        self.reactions_of(share, &self.displacement_under(share, solution))
    }

    /// The same of the displacement of every node \[mm\].
    pub fn reactions_of(&self, share: f64, displacement: &[[f64; 2]]) -> Result<Vec<Reaction>, Error> {
        let mut all = Vec::new();
        for body in 0..self.scene.bodies.len() {
            let forces = self.forces_of_supports(body, share, displacement)?;
            all.extend(forces.into_iter().enumerate().map(|(support, force)| Reaction { body, support, force }));
        }
        Ok(all)
    }

    /// What each support of a body takes of the forces missing at its nodes, in the component that it holds \[N\].
    fn forces_of_supports(&self, body: usize, share: f64, displacement: &[[f64; 2]]) -> Result<Vec<f64>, Error> {
        let (scene, mesh) = (&self.scene, &self.mesh);
        let holders = reactions::holders(scene, mesh, body)?;
        let mut forces = vec![0.0; scene.bodies[body].supports.len()];
        if holders.is_empty() {
            return Ok(forces);
        }
        let first = mesh.bodies[body].nodes.start;
        let mut is_held = vec![false; mesh.bodies[body].nodes.len()];
        holders.keys().for_each(|(node, _)| is_held[node - first] = true);
        let internal = reactions::internal_forces(scene, mesh, body, displacement, &|node| is_held[node - first])?;
        let applied = &self.system.bodies[body].applied;
        for ((node, component), support) in holders {
            forces[support] += internal[node - first][component] - share * applied[node - first][component];
        }
        Ok(forces)
    }

    /// In which components supports of a body prescribe unlike displacements of one node: the stress there grows with
    /// 1/r, and what they exert with its logarithm.
    pub fn torn(&self, body: usize) -> Result<[bool; 2], Error> {
        let mut held: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        let mut torn = [false; 2];
        for support in &self.scene.bodies[body].supports {
            let component = support.component.index();
            for node in self.mesh.nodes_at(&self.scene, body, &support.at)? {
                let value = *held.entry((node, component)).or_insert(support.value);
                torn[component] |= (value - support.value).abs() > SAME * value.abs().max(support.value.abs());
            }
        }
        Ok(torn)
    }
}
