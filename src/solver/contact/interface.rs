//! Nodes and edges of the candidate stretch, what they face, and where on an edge contact conditions are enforced.

use std::f64::consts::TAU;

use crate::condensation::Condensed;
use crate::contact::primary::{PrimarySurface, natural};
use crate::contact::{ContactEdge, ContactPoint};
use crate::elasticity::{quadrature, shape_functions};
use crate::error::{Error, Part};
use crate::mesh::{Candidate, Mesh, candidates};
use crate::scene::{ContactPair, Profile, Scene};

/// Part of the area of an edge below which a point has none: a node on the axis of revolution.
const NO_AREA: f64 = 1e-9;
/// Radius up to which a node is on the axis of revolution \[mm\]: what rounding leaves.
const ON_AXIS: f64 = 1e-9;
/// Gauss points that find the centre of the area of an edge of 2 nodes: exactly, its radius being linear.
const FINE: usize = 2;

/// Where on an edge the contact conditions are enforced.
///
/// As many Gauss points as the edge has nodes are more than its normal displacements can follow: pressures are then not
/// unique and oscillate as springs stiffen. The default takes one point fewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub enum Quadrature {
    /// Gauss, one point fewer than the edge has nodes: 1 on 2-node, 2 on 3-node edges; the default.
    Gauss,
    /// Gauss, as many points as nodes: 2 on 2-node, 3 on 3-node edges.
    GaussFull,
    /// Lobatto: the nodes themselves.
    Lobatto,
}

impl Quadrature {
    /// Points and weights for an edge of `nodes` nodes.
    pub fn rule(self, nodes: usize) -> Vec<(f64, f64)> {
        match self {
            Self::Gauss => quadrature::gauss(nodes - 1),
            Self::GaussFull => quadrature::gauss(nodes),
            Self::Lobatto => quadrature::lobatto(nodes),
        }
    }
}

/// The candidate stretch of one contact: contact nodes and the edges between them.
#[derive(Clone, Debug)]
pub struct Interface {
    /// Nodes of the first body, in the order of the contact coordinate.
    pub nodes: Vec<ContactNode>,
    /// Edges as node indices: first, last and, on 3-node edges, the middle.
    pub edges: Vec<Vec<usize>>,
    /// Edges of the second body; none where the other side is rigid.
    pub primary: Option<PrimarySurface>,
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Path, gap and symmetry of the contact.
    pub pair: ContactPair,
    /// Thickness \[mm\]; 1 of bodies of revolution.
    pub thickness: f64,
    /// Which coordinate of bodies of revolution is the radius.
    pub radial: Option<usize>,
}

/// A node of the first body and, unless the other side is rigid, what it faces on the second.
#[derive(Clone, Debug)]
pub struct ContactNode {
    /// Contact coordinate.
    pub coordinate: f64,
    /// Position on the first body \[mm\].
    pub point: [f64; 2],
    /// Outward normal of the first body.
    pub normal: [f64; 2],
    /// Initial gap \[mm\].
    pub gap: f64,
    /// Retained dof of its own normal displacement.
    pub dof: usize,
    /// Retained dofs of the primary body with their weights: the opposite node, or where the meshes do not match
    /// those of the edges around, by the dual shape function of this node.
    pub opposite: Vec<(usize, f64)>,
}

impl ContactNode {
    /// Row `b` of the approach `w = b·u` at this node: own normal displacement plus the opposite one, both outward.
    pub fn row(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        std::iter::once((self.dof, 1.0)).chain(self.opposite.iter().copied())
    }
}

impl Interface {
    /// The candidates of the first body of a contact, projected on to the second; what their nodes face is not known
    /// yet.
    pub(super) fn projected(scene: &Scene, mesh: &Mesh, condensed: &Condensed, contact: usize) -> Result<Self, Error> {
        let pair = &scene.contacts[contact];
        let first = &mesh.bodies[pair.first];
        let own = first.candidates_of(contact);
        let other = |second| PrimarySurface::of(scene, mesh, pair, second, condensed.offsets[second]);
        let primary = pair.second.map(other).transpose()?;
        let node = |index: usize| {
            let candidate: &Candidate = &first.candidates[index];
            let s = candidate.coordinate;
            let opposite = match &primary {
                None => pair.path.own_depth(),
                Some(primary) => {
                    let nodes = primary.at(s).ok_or_else(|| non_matching(scene, contact, primary, s))?;
                    nodes.iter().map(|(node, value)| value * node.depth).sum()
                }
            };
            let point = mesh.points[candidate.node];
            let gap = match &pair.profile {
                Profile::Drawn => pair.drawn(pair.path.depth(point), opposite),
                _ => pair.gap(s),
            };
            let dof = condensed.offsets[pair.first] + index;
            Ok(ContactNode { coordinate: s, point, normal: candidate.normal, gap, dof, opposite: Vec::new() })
        };
        let nodes = own.clone().map(node).collect::<Result<Vec<ContactNode>, Error>>()?;
        let index = |node: usize| first.candidate_index(node).map(|index| index - own.start);
        let mut edges: Vec<Vec<usize>> = candidates::candidate_edges(mesh, scene, pair, pair.first)?
            .iter()
            .filter_map(|edge| edge.iter().map(|&n| index(n)).collect())
            .collect();
        edges.sort_by_key(|edge| edge[0].min(edge[1]));
        let (thickness, radial) = (scene.thickness, scene.plane.radial());
        Ok(Self { nodes, edges, primary, contact, pair: pair.clone(), thickness, radial })
    }

    /// Where the candidate edges begin and end.
    pub fn contact_edges(&self) -> impl Iterator<Item = ContactEdge> + '_ {
        self.edges.iter().map(|edge| {
            let [a, b] = [edge[0], edge[1]].map(|node| self.nodes[node].coordinate);
            let ends = [a.min(b), a.max(b)];
            ContactEdge {
                contact: self.contact,
                ends,
                nodes: edge.len(),
                axis: self.radial.and_then(|radial| self.pair.path.axis(radial, ends)),
            }
        })
    }

    /// The circumference `2πr` at a contact coordinate of bodies of revolution \[mm\]; 1 in the plane, where the
    /// thickness stands for it.
    pub fn circumference(&self, position: f64) -> f64 {
        self.radial.map_or(1.0, |radial| TAU * self.pair.path.point(position)[radial])
    }

    /// Whether a node has no area: on the axis of revolution, but for rounding, `∫ N r dr = 0` of edges of order 2 and
    /// more, but for what a curved edge adds.
    pub fn has_no_area(&self, node: &ContactNode) -> bool {
        let is_on_axis = |radial: usize| self.pair.path.point(node.coordinate)[radial] <= ON_AXIS;
        self.radial.is_some_and(is_on_axis) && self.edges.iter().any(|edge| edge.len() > 2)
    }

    /// At a natural coordinate of an edge: shape functions `N_a`, contact coordinate `s`, and length per ξ \[mm\].
    pub fn at(&self, edge: &[usize], xi: f64) -> (Vec<f64>, f64, f64) {
        let shapes = shape_functions::edge(edge.len(), xi);
        let of = |pick: fn(&(f64, f64)) -> f64| -> f64 {
            shapes.iter().zip(edge).map(|(shape, &a)| pick(shape) * self.nodes[a].coordinate).sum()
        };
        let position = of(|shape| shape.0);
        let length = of(|shape| shape.1).abs() * self.pair.path.metric();
        (shapes.iter().map(|shape| shape.0).collect(), position, length)
    }

    /// At a natural coordinate of an edge, the area of each of its nodes per ξ: `N_a (n·n_a) ds/dξ · thickness`, of
    /// bodies of revolution `N_a 2πr ds/dξ` \[mm²\].
    pub fn areas_at(&self, edge: &[usize], xi: f64) -> Vec<f64> {
        let (shapes, position, length) = self.at(edge, xi);
        let area = length * self.circumference(position) * self.thickness;
        let aligned = |&a: &usize| self.pair.path.alignment(position, self.nodes[a].coordinate);
        shapes.iter().zip(edge).map(|(shape, a)| shape * aligned(a) * area).collect()
    }

    /// The points of a rule on every piece of an edge, each with its weight, which [`Interface::area`] makes its area.
    ///
    /// Around an axis the area grows with the radius. On edges of 2 nodes one Gauss point then lies at the centre of
    /// the area, so that a uniform pressure exerts its consistent nodal forces, as rules of more points do by
    /// themselves; with the middle of the edges the pressure of Hertz's sphere is 40 % too small at the axis.
    pub fn ruled(&self, edge: &[usize], quadrature: Quadrature) -> Vec<(f64, f64)> {
        let rule = quadrature.rule(edge.len());
        if self.radial.is_none() {
            return self.on_pieces(edge, &rule);
        }
        let area = |&(xi, weight): &(f64, f64)| {
            let (_, position, length) = self.at(edge, xi);
            (xi, weight * length * self.circumference(position))
        };
        let areas = |rule: &[(f64, f64)]| -> Vec<(f64, f64)> { self.on_pieces(edge, rule).iter().map(area).collect() };
        if rule.len() > 1 {
            let all = areas(&rule);
            let whole: f64 = all.iter().map(|(_, area)| area).sum();
            return all.into_iter().filter(|(_, area)| *area > NO_AREA * whole).collect();
        }
        let fine = quadrature::gauss(FINE);
        let centre = |piece: &[(f64, f64)]| {
            let whole: f64 = piece.iter().map(|(_, area)| area).sum();
            (piece.iter().map(|(xi, area)| xi * area).sum::<f64>() / whole, whole)
        };
        areas(&fine).chunks(FINE).map(centre).collect()
    }

    /// Area of a point of such a rule \[mm²\], with the length of the edge per ξ there.
    pub fn area(&self, weight: f64, length: f64) -> f64 {
        if self.radial.is_some() { weight } else { weight * length * self.thickness }
    }

    /// Points and weights of a rule on every piece of an edge; it is cut where opposite edges meet, so that the shape
    /// functions of both sides are smooth on each piece.
    pub fn on_pieces(&self, edge: &[usize], rule: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let coordinates: Vec<f64> = edge.iter().map(|&a| self.nodes[a].coordinate).collect();
        let [low, high] = [coordinates[0].min(coordinates[1]), coordinates[0].max(coordinates[1])];
        let mut cuts = vec![-1.0, 1.0];
        if let Some(primary) = &self.primary {
            let within = primary.corners().filter(|s| *s > low + primary.same && *s < high - primary.same);
            cuts.extend(within.map(|s| natural(&coordinates, s)));
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let piece = |ends: &[f64]| {
            let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            rule.iter().map(move |&(xi, weight)| (middle + half * xi, half * weight))
        };
        cuts.windows(2).flat_map(piece).collect()
    }

    /// The points of a rule on all edges, in the order of the contact coordinate, each with the row and the relative
    /// stiffness that it has by its edge, its shape functions and place there, and its gap.
    pub fn points(
        &self,
        quadrature: Quadrature,
        mut of: impl FnMut(&[usize], (&[f64], f64), f64) -> (Vec<(usize, f64)>, f64),
    ) -> Vec<ContactPoint> {
        let mut points = Vec::new();
        for (index, edge) in self.edges.iter().enumerate() {
            for (xi, weight) in self.ruled(edge, quadrature) {
                let (shapes, position, length) = self.at(edge, xi);
                let gap = self.gap(edge, &shapes, position);
                let (row, relative_stiffness) = of(edge, (&shapes, position), gap);
                let weight = self.area(weight, length);
                let (contact, shares) = (self.contact, vec![(index, weight)]);
                points.push(ContactPoint { contact, row, position, weight, gap, relative_stiffness, shares });
            }
        }
        points.sort_by(|a, b| a.position.total_cmp(&b.position));
        points
    }

    /// The normal displacements in the approach of a point of an edge, own ones by `N_a`, opposite ones by projection:
    /// retained dof, shape function, and normal of the node, out of the first body.
    pub fn terms(&self, edge: &[usize], (shapes, position): (&[f64], f64)) -> Vec<(usize, f64, [f64; 2])> {
        let own = edge.iter().zip(shapes).map(|(&a, &value)| (self.nodes[a].dof, value, self.nodes[a].normal));
        let primary = self.primary.iter().filter_map(|primary| primary.at(position)).flatten();
        own.chain(primary.map(|(node, value)| (node.dof, value, node.normal))).collect()
    }

    /// Initial gap at a point of an edge: that of the profile, or the drawn one interpolated by `N_a` \[mm\].
    pub fn gap(&self, edge: &[usize], shapes: &[f64], position: f64) -> f64 {
        match &self.pair.profile {
            Profile::Drawn => edge.iter().zip(shapes).map(|(&a, value)| value * self.nodes[a].gap).sum(),
            _ => self.pair.gap(position),
        }
    }
}

/// A row in which every dof stands once, where it first stood.
pub(super) fn summed(row: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
    let mut sums: Vec<(usize, f64)> = Vec::with_capacity(row.len());
    for (dof, value) in row {
        match sums.iter_mut().find(|(known, _)| *known == dof) {
            Some((_, sum)) => *sum += value,
            None => sums.push((dof, value)),
        }
    }
    sums
}

fn non_matching(scene: &Scene, contact: usize, primary: &PrimarySurface, at: f64) -> Error {
    let from = primary.corners().fold(f64::INFINITY, f64::min);
    let to = primary.corners().fold(f64::NEG_INFINITY, f64::max);
    let pair = &scene.contacts[contact];
    let [at, from, to] = [at, from, to].map(|s| pair.path.reported(s));
    let message = format!(
        "nothing of the secondary body is opposite the node of the primary one at s = {at}: its contact side lies \
        between {from} and {to}"
    );
    let remedy = "shorten the candidate stretch, or make the sides begin together";
    Error::at(scene.place_of(contact, Part::Second), message, remedy)
}
