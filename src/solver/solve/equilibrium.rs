//! Equilibrium of every body: its loads, the contact pressures as they are reported, and the reactions of its supports.
//!
//! Inside a body forces cancel in pairs, so that this balance holds of any displacement: what is left over is what the
//! reported pressures are short of the forces that the displacements belong to, and what round-off has made of both.

use crate::elasticity::reactions;
use crate::error::Error;
use crate::measure::larger;
use crate::scene::Load;
use crate::solution::Solution;
use crate::solve::Discretisation;

/// What is left over of the forces on one body.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Equilibrium {
    /// Index of the body in the scene.
    pub body: usize,
    /// `|Σ F|` over the largest force: the resultant of the loads, of a contact, or of what supports exert.
    pub force: f64,
    /// `|Σ r × F|` about the middle of the body, over the largest moment of one of them, or that force at the farthest
    /// point.
    pub moment: f64,
}

impl Equilibrium {
    /// The larger of both; NaN if either is.
    pub fn largest(&self) -> f64 {
        larger(self.force, self.moment)
    }
}

/// Part of the sum of the sizes of forces that counts as their resultant where they are in equilibrium with themselves.
const SELF_EQUILIBRATED: f64 = 1e-3;

/// Forces of one kind: their sum, the moment of that, and the sum of their sizes.
#[derive(Clone, Copy, Default)]
struct Sum {
    force: [f64; 2],
    moment: f64,
    sizes: f64,
}

impl Sum {
    /// Adds a force; around a body of revolution it is `kept` but for what cancels there, whose size counts.
    fn add(&mut self, arm: [f64; 2], force: [f64; 2], kept: impl Fn([f64; 2]) -> [f64; 2]) {
        self.sizes += force[0].hypot(force[1]);
        let force = kept(force);
        self.force = [self.force[0] + force[0], self.force[1] + force[1]];
        self.moment += arm[0] * force[1] - arm[1] * force[0];
    }

    fn resultant(&self) -> f64 {
        self.force[0].hypot(self.force[1])
    }
}

impl Discretisation {
    /// The equilibrium of every body under a share of loads and prescribed displacements; forces of no more than what
    /// the contacts have for round-off are none.
    pub fn equilibrium(&self, share: f64, solution: &Solution) -> Result<Vec<Equilibrium>, Error> {
        let displacement = self.displacement_under(share, solution);
        let of = |body: usize| self.equilibrium_of(body, share, solution, &displacement);
        (0..self.scene.bodies.len()).map(of).collect()
    }

    fn equilibrium_of(
        &self,
        body: usize,
        share: f64,
        solution: &Solution,
        displacement: &[[f64; 2]],
    ) -> Result<Equilibrium, Error> {
        let (scene, mesh) = (&self.scene, &self.mesh);
        let part = &mesh.bodies[body];
        let points = &mesh.points[part.nodes.clone()];
        let middle = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64);
        // Around a body of revolution radial forces and moments cancel, whatever they are.
        let radial = scene.plane.radial();
        let kept = |force: [f64; 2]| [0, 1].map(|k| if radial == Some(k) { 0.0 } else { force[k] });
        let arm = |node: usize| match radial.is_some() {
            true => [0.0; 2],
            false => [mesh.points[node][0] - middle[0], mesh.points[node][1] - middle[1]],
        };

        let loads = &self.system.bodies[body].applied;
        let mut applied = Sum::default();
        for (node, force) in part.nodes.clone().zip(loads) {
            applied.add(arm(node), force.map(|f| share * f), kept);
        }
        let mut contacts = vec![Sum::default(); scene.contacts.len()];
        for (index, candidate) in part.candidates.iter().enumerate() {
            let force = solution.contact_force[self.condensed.offsets[body] + index];
            contacts[candidate.contact].add(arm(candidate.node), candidate.normal.map(|n| n * force), kept);
        }
        let mut all = vec![applied];
        all.extend(contacts);
        let holding = self.holding(body)?;
        let first = part.nodes.start;
        let mut is_held = vec![false; part.nodes.len()];
        holding.iter().flat_map(|(nodes, _)| nodes).for_each(|(node, _)| is_held[node - first] = true);
        let internal = reactions::internal_forces(scene, mesh, body, displacement, &|node| is_held[node - first])?;
        for (nodes, given) in holding {
            let mut held = Sum::default();
            let mut passed = [0.0; 2];
            for (node, k) in nodes {
                let mut force = [0.0; 2];
                force[k] = internal[node - first][k] - share * loads[node - first][k];
                passed[k] += force[k];
                held.add(arm(node), force, kept);
            }
            // A rigid face passes on to its nodes what keeps them in line; that shall add up to the force on it.
            if let Some((k, force)) = given {
                held.force[k] += share * force - passed[k];
            }
            all.push(held);
        }
        let reach = points.iter().map(|p| (p[0] - middle[0]).hypot(p[1] - middle[1])).fold(0.0, larger);
        let size = all.iter().map(|one| larger(one.resultant(), SELF_EQUILIBRATED * one.sizes)).fold(0.0, larger);
        let [x, y] = [0, 1].map(|k| all.iter().map(|one| one.force[k]).sum::<f64>());
        let turning = all.iter().map(|one| one.moment).sum::<f64>().abs();
        let most = all.iter().map(|one| one.moment.abs()).fold(size * reach, larger);
        let over = |left: f64, size: f64| if size <= 0.0 { 0.0 } else { left / size };
        let is_none = all.iter().map(|one| one.sizes).fold(0.0, larger) <= solution.round_off;
        let [force, moment] = if is_none { [0.0; 2] } else { [over(x.hypot(y), size), over(turning, most)] };
        Ok(Equilibrium { body, force, moment })
    }

    /// What holds the nodes of a body: its supports, and its rigid faces with the force on each.
    fn holding(&self, body: usize) -> Result<Vec<Holding>, Error> {
        let (scene, mesh) = (&self.scene, &self.mesh);
        let supported = reactions::holders(scene, mesh, body)?;
        let mut all = Vec::new();
        for load in &scene.bodies[body].loads {
            let Load::RigidFace { boundary, component, force } = load else { continue };
            let k = component.index();
            let mut nodes: Vec<usize> = mesh.boundary(scene, body, boundary)?.iter().flatten().copied().collect();
            nodes.sort_unstable();
            nodes.dedup();
            let free = nodes.into_iter().map(|node| (node, k)).filter(|one| !supported.contains_key(one));
            all.push((free.collect(), Some((k, *force))));
        }
        all.push((supported.into_keys().collect(), None));
        Ok(all)
    }
}

/// Nodes that are held, each in a component; of a rigid face the component and the force on it \[N\].
type Holding = (Vec<(usize, usize)>, Option<(usize, f64)>);
