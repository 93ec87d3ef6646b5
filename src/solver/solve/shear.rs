//! The largest shear stress below a contact.

use crate::elasticity::point::shapes_at;
use crate::elasticity::{shape_functions, stress};
use crate::error::Error;
use crate::measure::Measures;
use crate::mesh::candidates;
use crate::scene::Load;
use crate::solve::Discretisation;

/// Half-widths below the surface down to which the largest shear stress is looked for: under Hertz it lies at 0.79 of
/// one, under a uniform pressure at one.
const DEPTH: f64 = 2.0;
/// A largest value found beyond that is none of this contact; so far it is looked for.
const BEYOND: f64 = 1.2;
/// Part of the largest stress at a node that a cell must have at one of its own for places between them to be looked
/// at.
pub(super) const NEAR: f64 = 0.8;
/// Parts of a cell's side at whose ends stresses are looked at, and halvings of them around the largest.
const PARTS: usize = 8;
const HALVINGS: usize = 8;
/// Part of the half-width that rounding explains.
const ROUNDING: f64 = 1e-6;

/// The largest in-plane shear stress below a contact, and how it is distributed.
#[derive(Clone, Debug)]
pub struct Shear {
    /// Its value `τ = ½ (σ₁ − σ₂) = √(¼ (σ_x − σ_y)² + τ_xy²)` \[MPa\].
    pub stress: f64,
    /// Its depth below the surface, along the direction of the gap \[mm\].
    pub depth: f64,
    /// Depth and shear stress at every place looked at \[mm, MPa\].
    pub samples: Vec<[f64; 2]>,
}

impl Shear {
    /// How far above or below the largest the shear stress is nearly as large, by no more than a difference \[mm\].
    pub fn farthest(&self, difference: f64) -> f64 {
        // Towards a lower sample as far as the parabola through the largest one is as high: a cell may be wider than
        // the top.
        let of_sample = |&[depth, stress]: &[f64; 2]| {
            let below = self.stress - stress;
            let part = if below <= difference { 1.0 } else { (difference / below).sqrt() };
            part * (depth - self.depth).abs()
        };
        let farthest = self.samples.iter().map(of_sample).fold(0.0, f64::max);
        if difference.is_nan() { f64::NAN } else { farthest }
    }
}

impl Discretisation {
    /// The largest in-plane shear stress of a body below a contact with some measures, of the displacement of every
    /// node: between the ends of the closed stretches, down to two half-widths. Stresses are looked at where that is.
    ///
    /// None where it lies on the surface or at the lower end of that: at a corner, or under a pressure that varies too
    /// little for a largest value inside. None beside a force at a point either, where stresses have no limit.
    pub fn shear_below(
        &self,
        displacement: &[[f64; 2]],
        measures: &Measures,
        [contact, body]: [usize; 2],
    ) -> Result<Option<Shear>, Error> {
        let below = Below::of(self, measures, [contact, body])?;
        let is_wanted = below.corners_and_sides();
        let stress = stress::of_body(&self.scene, &self.mesh, displacement, body, &|node| is_wanted[node])?;
        let nodes = self.mesh.order.nodes_per_cell();
        let grid = grid(nodes);
        let (mut samples, mut best) = (Vec::new(), None);
        let mut most = f64::NEG_INFINITY;
        let cells = self.mesh.bodies[body].cells.clone();
        let at_nodes: Vec<Vec<[f64; 2]>> = cells.clone().map(|cell| below.at_nodes(cell, &stress)).collect();
        let largest = |own: &[[f64; 2]]| own.iter().map(|sample| sample[1]).fold(f64::NEG_INFINITY, f64::max);
        let enough = NEAR * at_nodes.iter().map(|own| largest(own)).fold(f64::NEG_INFINITY, f64::max);
        for (cell, own) in cells.zip(at_nodes) {
            if own.is_empty() || largest(&own) < enough {
                samples.extend(own);
                continue;
            }
            for (at, shapes) in &grid {
                let Some((depth, shear)) = below.sample(cell, shapes, &stress) else { continue };
                samples.push([depth, shear]);
                if shear > most {
                    (most, best) = (shear, Some((cell, *at)));
                }
            }
        }
        let Some((cell, at)) = best.filter(|(cell, _)| !self.is_at_force(body, *cell)) else { return Ok(None) };
        let sample = |shapes: &[f64]| below.sample(cell, shapes, &stress);
        let (depth, shear) = largest_around(nodes, at, sample, |(_, shear)| *shear).unwrap_or((f64::NAN, f64::NAN));
        let inside = depth > ROUNDING * below.deepest && depth < below.deepest;
        samples.retain(|sample| sample[0] <= below.deepest);
        Ok(inside.then_some(Shear { stress: shear, depth, samples }))
    }

    /// Whether a force acts at a node of a cell, or in a cell beside it.
    fn is_at_force(&self, body: usize, cell: usize) -> bool {
        let acts_at = |load: &Load| match load {
            Load::Force { at, .. } => shapes_at(&self.scene, &self.mesh, body, *at).ok(),
            _ => None,
        };
        let mut nodes = self.scene.bodies[body].loads.iter().filter_map(acts_at).flatten();
        nodes.any(|(node, _)| self.mesh.cell(cell).contains(&node))
    }
}

/// What lies below a contact.
struct Below<'a> {
    discretisation: &'a Discretisation,
    contact: usize,
    body: usize,
    /// Contact coordinates and [depth](crate::scene::Path::depth) of the nodes of the surface, in that order.
    surface: Vec<[f64; 2]>,
    /// From the path's depth to one into the body.
    inwards: f64,
    /// Ends of the closed stretches, in the contact coordinate.
    ends: [f64; 2],
    /// Depth down to which a largest value counts \[mm\].
    deepest: f64,
    /// Depths of the nodes of the body; none beside the contact, and too deep.
    depths: Vec<Option<f64>>,
}

impl<'a> Below<'a> {
    fn of(discretisation: &'a Discretisation, measures: &Measures, [contact, body]: [usize; 2]) -> Result<Self, Error> {
        let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
        let pair = &scene.contacts[contact];
        let nodes = candidates::facing_edges(mesh, scene, pair, body)?.into_iter().flatten();
        let place = |node: usize| [pair.path.coordinate(mesh.points[node]), pair.path.depth(mesh.points[node])];
        let mut surface: Vec<[f64; 2]> = nodes.map(place).collect();
        surface.sort_by(|a, b| a[0].total_cmp(&b[0]));
        surface.dedup_by(|a, b| a[0] - b[0] <= 0.0);
        let inwards = if (body == pair.first) == pair.above { -1.0 } else { 1.0 };
        let [begin, end] = [measures.stretches.first().map(|s| s.begin), measures.stretches.last().map(|s| s.end)];
        let ends = [begin, end].map(|end| end.unwrap_or(f64::NAN));
        let deepest = DEPTH * measures.second_moment_width * pair.path.metric();
        let below = Self { discretisation, contact, body, surface, inwards, ends, deepest, depths: Vec::new() };
        let depths = mesh.points[mesh.bodies[body].nodes.clone()].iter().map(|&point| below.depth(point)).collect();
        Ok(Self { depths, ..below })
    }

    /// Which nodes of the body belong to a cell with a node below the contact.
    fn corners_and_sides(&self) -> Vec<bool> {
        let mesh = &self.discretisation.mesh;
        let mut are = vec![false; self.depths.len()];
        for nodes in mesh.bodies[self.body].cells.clone().map(|cell| mesh.cell(cell)) {
            if nodes.iter().any(|&node| self.depth_of(node).is_some()) {
                nodes.iter().for_each(|&node| are[self.own(node)] = true);
            }
        }
        are
    }

    /// Number of a node in the body.
    fn own(&self, node: usize) -> usize {
        node - self.discretisation.mesh.bodies[self.body].nodes.start
    }

    /// Depth of a node.
    fn depth_of(&self, node: usize) -> Option<f64> {
        self.depths[self.own(node)]
    }

    /// Depth of a point below the surface \[mm\]; none beside the closed stretches, and too deep.
    fn depth(&self, point: [f64; 2]) -> Option<f64> {
        let path = &self.discretisation.scene.contacts[self.contact].path;
        let s = path.coordinate(point);
        let margin = ROUNDING * (self.ends[1] - self.ends[0]);
        if !(self.ends[0] - margin <= s && s <= self.ends[1] + margin) {
            return None;
        }
        let after = self.surface.partition_point(|node| node[0] < s).clamp(1, self.surface.len() - 1);
        let ([s0, d0], [s1, d1]) = (self.surface[after - 1], self.surface[after]);
        let surface = d0 + (d1 - d0) * ((s - s0) / (s1 - s0)).clamp(0.0, 1.0);
        let depth = self.inwards * (path.depth(point) - surface);
        (depth <= BEYOND * self.deepest).then_some(depth)
    }

    /// Depth and shear stress at the nodes of a cell that lie below the contact.
    fn at_nodes(&self, cell: usize, stress: &[[f64; 3]]) -> Vec<[f64; 2]> {
        let mesh = &self.discretisation.mesh;
        let at = |&node: &usize| Some([self.depth_of(node)?, largest_shear(stress[self.own(node)])]);
        mesh.cell(cell).iter().filter_map(at).collect()
    }

    /// Depth and shear stress at a place of a cell, given its shape functions; none where it is not below the contact.
    fn sample(&self, cell: usize, shapes: &[f64], stress: &[[f64; 3]]) -> Option<(f64, f64)> {
        let mesh = &self.discretisation.mesh;
        let (mut point, mut tensor) = ([0.0; 2], [0.0; 3]);
        for (&node, shape) in mesh.cell(cell).iter().zip(shapes) {
            (0..2).for_each(|k| point[k] += shape * mesh.points[node][k]);
            (0..3).for_each(|k| tensor[k] += shape * stress[self.own(node)][k]);
        }
        Some((self.depth(point)?, largest_shear(tensor)))
    }
}

/// `½ (σ₁ − σ₂)` of `[σ_x, σ_y, τ_xy]` \[MPa\].
fn largest_shear([x, y, xy]: [f64; 3]) -> f64 {
    (0.5 * (x - y)).hypot(xy)
}

/// Natural coordinates of the places of a cell that are looked at, with the shape functions there.
pub(super) fn grid(nodes: usize) -> Vec<([f64; 2], Vec<f64>)> {
    let natural = |k: usize| 2.0 * k as f64 / PARTS as f64 - 1.0;
    let all = (0..=PARTS).flat_map(|i| (0..=PARTS).map(move |j| [natural(i), natural(j)]));
    all.map(|at| (at, shapes(nodes, at))).collect()
}

/// The largest of what is found around a place of a cell by its shape functions, by smaller and smaller steps; none
/// where nothing is found at the place itself.
pub(super) fn largest_around<T>(
    nodes: usize,
    mut at: [f64; 2],
    found: impl Fn(&[f64]) -> Option<T>,
    stress: impl Fn(&T) -> f64,
) -> Option<T> {
    let mut best = found(&shapes(nodes, at))?;
    let mut step = 2.0 / PARTS as f64;
    for _ in 0..HALVINGS {
        step *= 0.5;
        for (dx, dy) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
            let next = [at[0] + dx * step, at[1] + dy * step].map(|x: f64| x.clamp(-1.0, 1.0));
            if let Some(found) = found(&shapes(nodes, next)).filter(|found| stress(found) > stress(&best)) {
                (at, best) = (next, found);
            }
        }
    }
    Some(best)
}

fn shapes(nodes: usize, at: [f64; 2]) -> Vec<f64> {
    shape_functions::cell(nodes, at).into_iter().map(|(value, _)| value).collect()
}
