//! The largest shear stress below a contact.

use crate::elasticity::point::{Cells, shapes_at};
use crate::elasticity::stress;
use crate::error::Error;
use crate::measure::Measures;
use crate::mesh::candidates;
use crate::scene::{Load, Path};
use crate::solve::Discretisation;
use crate::solve::largest::{NEAR, edges, grid, largest_along_edge, largest_around};

/// Half-widths below the surface down to which the largest shear stress is looked for: under Hertz it lies at 0.79 of
/// one, under a uniform pressure at one.
const DEPTH: f64 = 2.0;
/// A largest value found beyond that is none of this contact; so far it is looked for.
const BEYOND: f64 = 1.2;
/// Cells around whose largest samples it is looked for, and as many whose largest samples lie on an edge of where it is
/// looked for.
const SEEDS: usize = 8;
/// Part of the half-width, of an arc's radius, that rounding explains; and of the largest stress, that the search does.
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
        let apex = below.apex();
        let mut is_wanted = below.corners_and_sides();
        let of_apex = apex.iter().flat_map(|(cell, _)| self.mesh.cell(*cell));
        of_apex.for_each(|&node| is_wanted[below.own(node)] = true);
        let stress = stress::of_body(&self.scene, &self.mesh, displacement, body, &|node| is_wanted[node])?;
        let nodes = self.mesh.order.nodes_per_cell();
        let grid = grid(nodes);
        let places: Vec<[f64; 2]> = grid.iter().map(|(at, _)| *at).collect();
        // Shear stress, cell and place of the largest sample of every cell, and of every cell's largest on an edge.
        let (mut inside, mut on_edges) = (Vec::new(), Vec::new());
        let mut samples = Vec::new();
        let cells = self.mesh.bodies[body].cells.clone();
        let at_nodes: Vec<Vec<[f64; 2]>> = cells.clone().map(|cell| below.at_nodes(cell, &stress)).collect();
        let largest = |own: &[[f64; 2]]| own.iter().map(|sample| sample[1]).fold(f64::NEG_INFINITY, f64::max);
        let enough = NEAR * at_nodes.iter().map(|own| largest(own)).fold(f64::NEG_INFINITY, f64::max);
        for (cell, own) in cells.zip(at_nodes) {
            if own.is_empty() || largest(&own) < enough {
                samples.extend(own);
                continue;
            }
            let sample = |shapes: &[f64]| below.sample(cell, shapes, &stress);
            let found: Vec<Option<(f64, f64)>> = grid.iter().map(|(_, shapes)| sample(shapes)).collect();
            samples.extend(found.iter().flatten().map(|&(depth, shear)| [depth, shear]));
            let own = places.iter().zip(&found).filter_map(|(at, found)| Some((found.as_ref()?.1, cell, *at)));
            inside.extend(own.reduce(larger));
            let on_edge = edges(nodes, &places, &|k| found[k].is_some(), &sample);
            samples.extend(on_edge.iter().map(|&(_, (depth, shear))| [depth, shear]));
            on_edges.extend(on_edge.into_iter().map(|(at, (_, shear))| (shear, cell, at)).reduce(larger));
        }
        for seeds in [&mut inside, &mut on_edges] {
            seeds.sort_by(|a, b| b.0.total_cmp(&a.0));
            seeds.truncate(SEEDS);
        }
        let around = |&(_, cell, at): &(f64, usize, [f64; 2])| {
            let sample = |shapes: &[f64]| below.sample(cell, shapes, &stress);
            Some((cell, largest_around(nodes, at, sample, |(_, shear)| *shear)?))
        };
        let along = |&(_, cell, at): &(f64, usize, [f64; 2])| {
            let sample = |shapes: &[f64]| below.sample(cell, shapes, &stress);
            Some((cell, largest_along_edge(nodes, at, sample, |(_, shear)| *shear)?))
        };
        let at_apex = apex.iter().filter_map(|(cell, shapes)| Some((*cell, below.sample(*cell, shapes, &stress)?)));
        let all = inside.iter().filter_map(around).chain(on_edges.iter().filter_map(along)).chain(at_apex);
        // What is no larger than the first, but for the last step of its search, is the same maximum.
        let best = all.reduce(|best, next| if next.1.1 > (1.0 + ROUNDING) * best.1.1 { next } else { best });
        let Some((_, (depth, shear))) = best.filter(|(cell, _)| !self.is_at_force(body, *cell)) else {
            return Ok(None);
        };
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

    /// The cell that holds the centre of an arc, where all of its depths meet, with its shape functions there; none
    /// where the body does not reach it, and below a line.
    fn apex(&self) -> Option<(usize, Vec<f64>)> {
        let Path::Arc(circle) = self.discretisation.scene.contacts[self.contact].path else { return None };
        let mesh = &self.discretisation.mesh;
        let (cell, shapes) = Cells::of_body(mesh, self.body).shapes_at(circle.centre, ROUNDING)?;
        Some((mesh.bodies[self.body].cells.start + cell, shapes))
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
        let margin = ROUNDING * (self.ends[1] - self.ends[0]);
        // The centre of an arc is at every angle.
        let is_centre = !path.is_straight() && path.depth(point) <= ROUNDING * path.own_depth();
        let s = if is_centre { self.ends[0] } else { path.coordinate(point) };
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

/// The one of two places with the larger stress, the first of equals.
fn larger(a: (f64, usize, [f64; 2]), b: (f64, usize, [f64; 2])) -> (f64, usize, [f64; 2]) {
    if b.0 > a.0 { b } else { a }
}

/// `½ (σ₁ − σ₂)` of `[σ_x, σ_y, τ_xy]` \[MPa\].
fn largest_shear([x, y, xy]: [f64; 3]) -> f64 {
    (0.5 * (x - y)).hypot(xy)
}
