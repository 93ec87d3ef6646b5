//! Consistent nodal forces of what acts on a side, or on a part of it, of body forces and concentrated forces.

use crate::elasticity::dofs::Dofs;
use crate::elasticity::shape_functions::{OnEdge, on_edge};
use crate::elasticity::{element, point, quadrature, shape_functions};
use crate::error::{Error, Place};
use crate::mesh::{Edge, Mesh};
use crate::scene::{Action, Load, Scene, SidePart};

/// Load vector of a body, from the forces applied at its nodes and those on rigid faces \[N\].
pub fn vector(scene: &Scene, mesh: &Mesh, body: usize, dofs: &Dofs, applied: &[[f64; 2]]) -> Result<Vec<f64>, Error> {
    let mut force = vec![0.0; dofs.equations];
    for (node, &value) in mesh.bodies[body].nodes.clone().zip(applied) {
        dofs.add_force(node, value, &mut force);
    }
    for load in &scene.bodies[body].loads {
        if let Load::RigidFace { boundary, component, force: value } = load {
            // The component that the nodes of the face share; a node of it that a support holds has none.
            let nodes = mesh.boundary(scene, body, boundary)?.iter().flatten();
            let shared = nodes.filter_map(|&node| dofs.of_node(node)[component.index()].equation()).next();
            let Some(equation) = shared else { return Err(fixed_face(scene, body, boundary, *value)) };
            force[equation] += value;
        }
    }
    Ok(force)
}

fn fixed_face(scene: &Scene, body: usize, boundary: &str, force: f64) -> Error {
    let expected = format!("every node of `{boundary}` is fixed in that direction");
    let remedy = "leave out the supports or the force";
    Error::value(scene.place_of_body(body), "force on a rigid face", force, expected, remedy)
}

/// Applied forces at each node of a body, in x and y, fixed components included \[N\].
///
/// The force on a rigid face is not among them: it acts on what its nodes have in common, which no support holds.
pub fn at_nodes(scene: &Scene, mesh: &Mesh, body: usize) -> Result<Vec<[f64; 2]>, Error> {
    let nodes = mesh.bodies[body].nodes.clone();
    let mut forces = vec![[0.0; 2]; nodes.len()];
    for index in 0..scene.bodies[body].loads.len() {
        let mut take = |node: usize, value: [f64; 2]| {
            (0..2).for_each(|k| forces[node - nodes.start][k] += value[k]);
        };
        hand_out(scene, mesh, body, index, &mut take)?;
    }
    Ok(forces)
}

/// The traction of a load at the ends of a stretch of an edge that carries it.
pub struct Traction {
    /// First and last node of the edge.
    pub edge: [usize; 2],
    /// Where in the edge it begins and ends, −1 to 1, and the traction there \[MPa\].
    pub ends: [(f64, [f64; 2]); 2],
}

impl Traction {
    /// The one that reaches an end of an edge, its first or its last.
    pub fn at(&self, edge: &Edge, end: usize) -> Option<[f64; 2]> {
        let (_, traction) = self.ends[end];
        (self.edge == edge[..2] && self.reaches(end)).then_some(traction)
    }

    /// Whether it goes on to the first or the last node of its edge, but for a part that no stress sees.
    pub fn reaches(&self, end: usize) -> bool {
        (self.ends[end].0 - [-1.0, 1.0][end]).abs() <= UNSEEN
    }
}

/// Part of an edge that no stress sees.
pub const UNSEEN: f64 = 1e-3;

/// The tractions of every load of a body.
pub fn tractions(scene: &Scene, mesh: &Mesh, body: usize) -> Result<Vec<Vec<Traction>>, Error> {
    let of = |(index, load): (usize, &Load)| match load {
        Load::OnSide { boundary, part, action } => {
            Ok(LoadedSide::of(scene, mesh, (body, index), boundary, part.as_ref())?.at_ends(action))
        }
        _ => Ok(Vec::new()),
    };
    scene.bodies[body].loads.iter().enumerate().map(of).collect()
}

/// Hands the consistent forces of a load, one of its body by its index, to the nodes; those of a rigid face belong to
/// no single node.
fn hand_out(scene: &Scene, mesh: &Mesh, body: usize, index: usize, take: Taker) -> Result<(), Error> {
    match &scene.bodies[body].loads[index] {
        Load::OnSide { boundary, part, action } => {
            LoadedSide::of(scene, mesh, (body, index), boundary, part.as_ref())?.hand_out(action, take);
            Ok(())
        }
        Load::BodyForce(density) => body_force(scene, mesh, body, *density, take),
        Load::Force { at, force } => {
            for (node, value) in point::shapes_at(scene, mesh, body, *at)? {
                take(node, force.map(|f| f * value));
            }
            Ok(())
        }
        Load::RigidFace { .. } => Ok(()),
    }
}

fn body_force(scene: &Scene, mesh: &Mesh, body: usize, density: [f64; 2], take: Taker) -> Result<(), Error> {
    let rule = quadrature::gauss_square((usize::from(mesh.order.number()) + 1).max(3));
    for cell in mesh.bodies[body].cells.clone() {
        let nodes = mesh.cell(cell);
        let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
        for &(at, weight) in &rule {
            let (_, determinant) =
                element::gradients(&points, at).map_err(|jacobian| element::degenerate(scene, body, cell, jacobian))?;
            let shapes = shape_functions::cell(points.len(), at);
            let of = |k: usize| shapes.iter().zip(&points).map(|((value, _), point)| value * point[k]).sum();
            let volume = weight * determinant * scene.depth([of(0), of(1)]);
            for (&node, (value, _)) in nodes.iter().zip(shapes) {
                take(node, density.map(|b| b * value * volume));
            }
        }
    }
    Ok(())
}

/// Gauss points per edge for given stress fields: the Hertz field is integrated to 1e-7 and better on the meshes here.
const EDGE_POINTS: usize = 16;
/// Halvings after which the end of a part has all its digits.
const HALVINGS: usize = 60;
/// How far a part may seem to go beyond its side, over the length of both.
const ROUNDING: f64 = 1e-9;

/// What takes the force on a node, in x and y \[N\].
type Taker<'a> = &'a mut dyn FnMut(usize, [f64; 2]);

/// `t ds/dξ` at a point, given the slope `dx/dξ` of its edge.
type Acting<'a> = Box<dyn Fn([f64; 2], [f64; 2]) -> [f64; 2] + 'a>;

/// The edges that carry a load, each with the stretch of its natural coordinate that does.
struct LoadedSide<'a> {
    scene: &'a Scene,
    mesh: &'a Mesh,
    pieces: Vec<(&'a Edge, [f64; 2])>,
    rule: Vec<(f64, f64)>,
}

impl<'a> LoadedSide<'a> {
    /// All of a side, or the part of it that is named; a part that goes on where the side has ended is refused.
    fn of(
        scene: &'a Scene,
        mesh: &'a Mesh,
        (body, load): (usize, usize),
        boundary: &str,
        part: Option<&SidePart>,
    ) -> Result<Self, Error> {
        let edges = mesh.boundary(scene, body, boundary)?;
        let whole = |edge: &'a Edge| (edge, [-1.0, 1.0]);
        let pieces = edges.iter().map(whole).collect();
        let mut side = Self { scene, mesh, pieces, rule: quadrature::gauss(EDGE_POINTS) };
        if let Some(part) = part {
            side.refuse_beyond(part, boundary, || scene.place_of_load(body, load))?;
            side.pieces = edges.iter().flat_map(|edge| side.within(edge, part)).collect();
        }
        Ok(side)
    }

    /// Hands the consistent forces `f_a = ∫ N_a t ds · thickness`, `∫ N_a t 2πr ds` on a body of revolution, of what
    /// acts to the nodes.
    fn hand_out(&self, action: &Action, take: Taker) {
        let traction = self.traction(action);
        for (edge, (shapes, point, slope), weight) in self.samples() {
            let t = traction(point, slope);
            let depth = self.scene.depth(point);
            for (&node, (value, _)) in edge.iter().zip(&shapes) {
                take(node, t.map(|t| t * value * weight * depth));
            }
        }
    }

    /// What acts; the normal is `n ds = (dy, −dx)`.
    fn traction<'b>(&self, action: &'b Action) -> Acting<'b> {
        match action {
            Action::Uniform(traction) => {
                let traction = *traction;
                Box::new(move |_, [dx, dy]| traction.map(|t| t * dx.hypot(dy)))
            }
            Action::Field(field) => Box::new(|point, [dx, dy]| (field.0)(point).map(|t| t * dx.hypot(dy))),
            Action::Stress(field) => Box::new(|point, [dx, dy]| {
                let [x, y, xy] = (field.0)(point);
                [x * dy - xy * dx, xy * dy - y * dx]
            }),
            Action::Total(force) => {
                let (force, area) = (*force, self.area());
                Box::new(move |_, [dx, dy]| force.map(|f| f * dx.hypot(dy) / area))
            }
            Action::Moment(moment) => {
                let length = self.integral(|_| 1.0);
                let [x, y] = [0, 1].map(|k| self.integral(|point| point[k]) / length);
                let second = self.integral(|point| (point[0] - x).powi(2) + (point[1] - y).powi(2));
                let turn = moment / (second * self.scene.thickness);
                Box::new(move |point, [dx, dy]| [-(point[1] - y), point[0] - x].map(|r| r * turn * dx.hypot(dy)))
            }
        }
    }

    /// What acts at the ends of every piece that a stress sees.
    fn at_ends(&self, action: &Action) -> Vec<Traction> {
        let traction = self.traction(action);
        let at = |edge: &Edge, xi: f64| {
            let (_, point, slope) = on_edge(self.mesh, edge, xi);
            (xi, traction(point, slope).map(|t| t / slope[0].hypot(slope[1])))
        };
        let of =
            |(edge, ends): &(&Edge, [f64; 2])| Traction { edge: [edge[0], edge[1]], ends: ends.map(|xi| at(edge, xi)) };
        self.pieces.iter().filter(|(_, [begin, end])| end - begin > UNSEEN).map(of).collect()
    }

    /// Area of the side \[mm²\].
    fn area(&self) -> f64 {
        match self.scene.is_of_revolution() {
            true => self.integral(|point| self.scene.depth(point)),
            false => self.scene.thickness * self.integral(|_| 1.0),
        }
    }

    /// `∫ f ds`.
    fn integral(&self, of: impl Fn([f64; 2]) -> f64) -> f64 {
        self.samples().map(|(_, (_, point, slope), weight)| of(point) * slope[0].hypot(slope[1]) * weight).sum()
    }

    /// The Gauss points, each with its edge and its weight.
    fn samples(&self) -> impl Iterator<Item = (&Edge, OnEdge, f64)> {
        self.pieces.iter().flat_map(move |&(edge, [begin, end])| {
            let [middle, half] = [0.5 * (begin + end), 0.5 * (end - begin)];
            self.rule
                .iter()
                .map(move |&(at, weight)| (edge, on_edge(self.mesh, edge, middle + half * at), half * weight))
        })
    }

    /// The stretches of an edge that lie within a part.
    fn within(&self, edge: &'a Edge, part: &SidePart) -> Vec<(&'a Edge, [f64; 2])> {
        let of = |xi: f64| part.coordinate(on_edge(self.mesh, edge, xi).1);
        let mut cuts = vec![-1.0, 1.0];
        cuts.extend(self.turning(edge, part));
        cuts.sort_by(f64::total_cmp);
        for ends in cuts.clone().windows(2) {
            cuts.extend([part.from, part.to].into_iter().filter_map(|bound| crossing(&of, [ends[0], ends[1]], bound)));
        }
        cuts.sort_by(f64::total_cmp);
        let stretches = cuts.windows(2).map(|ends| [ends[0], ends[1]]);
        let inside = |ends: &[f64; 2]| {
            let middle = of(0.5 * (ends[0] + ends[1]));
            ends[1] > ends[0] && middle > part.from && middle < part.to
        };
        stretches.filter(inside).map(|ends| (edge, ends)).collect()
    }

    /// Where the coordinate of a part turns back within an edge: its slope along x or y is linear in ξ.
    fn turning(&self, edge: &Edge, part: &SidePart) -> Option<f64> {
        let slope = |xi: f64| {
            let (_, point, direction) = on_edge(self.mesh, edge, xi);
            part.slope(point, direction)
        };
        let [a, b] = [slope(-1.0), slope(1.0)];
        (a * b < 0.0).then(|| -1.0 + 2.0 * a / (a - b))
    }

    /// Refuses a part that begins before its side, or goes on beyond it.
    fn refuse_beyond(&self, part: &SidePart, boundary: &str, place: impl Fn() -> Place) -> Result<(), Error> {
        let nodes = self.pieces.iter().flat_map(|(edge, _)| edge.iter());
        let all: Vec<f64> = nodes.map(|&node| part.coordinate(self.mesh.points[node])).collect();
        let [low, high] =
            [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max)];
        let slack = ROUNDING * (high - low).abs().max(part.to.abs()).max(part.from.abs());
        if part.from >= low - slack && part.to <= high + slack && high - low > slack {
            return Ok(());
        }
        let [from, to, low, high] = [part.from, part.to, low, high].map(|end| part.shown(end));
        let message =
            format!("the part from {from} to {to} is not all on `{boundary}`, which goes from {low} to {high}");
        let remedy = "choose `from` and `to` within the side, and the coordinate that runs along it";
        Err(Error::at(place(), message, remedy))
    }
}

/// Where a function that rises or falls between two ends has a value; none where it does not reach it between them.
fn crossing(of: &dyn Fn(f64) -> f64, [begin, end]: [f64; 2], value: f64) -> Option<f64> {
    let rises = of(begin) < of(end);
    let (mut low, mut high) = (begin, end);
    let below = |xi: f64| (of(xi) < value) == rises;
    if !below(begin) || below(end) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        *if below(middle) { &mut low } else { &mut high } = middle;
    }
    Some(0.5 * (low + high))
}
