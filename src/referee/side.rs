//! Which edges of a mesh made elsewhere lie on the contact side of the first body, and whether they are all that is
//! pressed there.

use std::collections::{HashMap, HashSet, VecDeque};

use crate::error::Error;
use crate::measure::display_factor;
use crate::mesh::Order;
use crate::referee::source::Source;
use crate::referee::units::{Role, is_angle};
use crate::scene::{ContactPair, Path, Profile, Scene, Shape};

/// Distance from the side, over the length of an edge, that its chord explains.
const NEAR: f64 = 0.02;
/// Cosine between outward normals from which on they are of one side.
const ALONG: f64 = 0.5;
/// Rounding of the stretch.
const SAME: f64 = 1e-6;
/// Pressure over the largest, above which an edge is pressed, and a contact does not end: stresses at free nodes are
/// not quite 0.
pub(super) const PRESSED: f64 = 0.02;
/// Share of the force that may lie elsewhere, or behind an end.
pub(super) const DROPPED: f64 = 1e-3;
/// Distance of two edges, over the length of one, from which on there is a part of the side between them.
const APART: f64 = 1e-2;
/// Part of the candidate stretch that a side reaches over which lies there with its points in another unit.
const REACHED: f64 = 0.5;
/// What to do about points that lie elsewhere.
const UNDEFORMED: &str = "hand in the mesh undeformed, in plane cells, in the coordinates of the scene and the unit \
    of --unit position=UNIT; --contact names one of several";
/// What to do about cells of the other half of a scene whose contact does not lie on the symmetry line.
const ONE_HALF: &str = "; of a symmetric whole hand in the half that the scene is";

/// What to do about a part of it that no cell is at.
const ALL: &str = "hand in all cells along the contact";

/// A cell by its nodes: three or four corners, then the mid-sides, if it has them.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Its nodes.
    pub nodes: Vec<usize>,
    /// How many of them are corners.
    pub corners: usize,
}

/// Whether no two cells share a point, as files of discontinuous fields have it.
pub fn have_own_points(cells: &[Cell]) -> bool {
    let all: Vec<usize> = cells.iter().flat_map(|cell| cell.nodes.iter().copied()).collect();
    cells.len() > 1 && all.iter().collect::<HashSet<_>>().len() == all.len()
}

/// The nodes of an edge: its ends, and its mid-side where it has one.
type Edge = Vec<usize>;

/// The contact side of a mesh.
pub struct Side {
    /// Edges on it within the candidate stretch.
    edges: Vec<Edge>,
    /// Edges that go on from these and face the same way, and lie off the undeformed path or beyond the stretch.
    off: Vec<Edge>,
    /// What unit of the points would bring more of them onto it.
    fits: String,
}

impl Side {
    /// The side of a contact, that of the first body; that of the second one where only it has values other than 0,
    /// which is then said. Refused where no edge lies there.
    pub fn of(
        source: &Source,
        (scene, contact): (&Scene, usize),
        points: &[[f64; 2]],
        cells: &[Cell],
        pressure: impl Fn(usize) -> Option<f64>,
    ) -> Result<(Self, Option<String>), Error> {
        let pair = &scene.contacts[contact];
        let is_pressed =
            |side: &Self| side.nodes().iter().any(|&node| pressure(node).is_some_and(|own| own.abs() > 0.0));
        let first = Self::of_body(source, scene, (pair, pair.first), points, cells);
        let of_second = |body| Some((body, Self::of_body(source, scene, (pair, body), points, cells).ok()?));
        let second = if first.as_ref().is_ok_and(is_pressed) { None } else { pair.second.and_then(of_second) };
        let Some((body, second)) = second.filter(|(_, side)| is_pressed(side)) else { return Ok((first?, None)) };
        let names = [body, pair.first].map(|body| &scene.bodies[body].name);
        let how = format!("the side of `{}`, since that of `{}` has no values other than 0", names[0], names[1]);
        Ok((second, Some(how)))
    }

    fn of_body(
        source: &Source,
        scene: &Scene,
        (pair, body): (&ContactPair, usize),
        points: &[[f64; 2]],
        cells: &[Cell],
    ) -> Result<Self, Error> {
        if cells.is_empty() {
            let remedy = "hand in the grid with the cells of the bodies, or the points with their pressures as .csv";
            return Err(source.refused("it has no plane cells, by which the contact side is found", remedy));
        }
        if !cells.iter().any(|cell| area(points, cell).abs() > 0.0) {
            let message = format!("none of its {} plane cells has an area in x and y", cells.len());
            return Err(source.refused(message, UNDEFORMED));
        }
        let all = outline(points, cells);
        let edges: Vec<Edge> = all.iter().filter(|edge| lies_on(scene, (pair, body), points, edge)).cloned().collect();
        if edges.is_empty() {
            let range = |axis: usize| {
                let along = || points.iter().map(|point| point[axis]);
                let [least, most] = [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)];
                format!("{least:.4} to {most:.4}")
            };
            let message = format!(
                "no edge of its cells lies on the side of contact `{}`, within the candidate stretch; its points lie \
                at x = {}, y = {} mm",
                pair.name,
                range(0),
                range(1)
            );
            let fits = unit_that_fits(scene, (pair, body), points, &all, 1);
            return Err(source.refused(message, format!("{UNDEFORMED}{}{fits}", one_half(pair))));
        }
        let of = |other: &ContactPair| if body == pair.first { Some(other.first) } else { other.second };
        let lies = |other: &ContactPair, edge: &Edge| {
            of(other).is_some_and(|body| lies_on(scene, (other, body), points, edge))
        };
        let is_other = |edge: &Edge| scene.contacts.iter().any(|other| lies(other, edge));
        let is_along = |edge: &&Edge| faces((pair, body), points, edge) && !is_other(edge);
        let others: Vec<&Edge> = all.iter().filter(is_along).collect();
        let off = connected(points, &edges, &others);
        let fits =
            if off.is_empty() { String::new() } else { unit_that_fits(scene, (pair, body), points, &all, edges.len()) };
        Ok(Self { edges, off, fits })
    }

    /// The nodes on it, once each.
    pub fn nodes(&self) -> Vec<usize> {
        let mut nodes: Vec<usize> = self.edges.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// Whether all its edges have mid-sides, or not.
    pub fn order(&self) -> Order {
        if self.edges.iter().all(|edge| edge.len() == 3) { Order::Quadratic } else { Order::Linear }
    }

    /// Refuses a side of which only a part is read: edges that go on from it are pressed too, by what their nodes say
    /// along their own normal. Edges of bodies of revolution are rings about x = 0 or y = 0; those without another side
    /// are not pressed, whatever corners beside them say.
    pub fn all_pressed(
        &self,
        source: &Source,
        (pair, radial): (&ContactPair, Option<usize>),
        points: &[[f64; 2]],
        pressure: impl Fn(usize, Option<[f64; 2]>) -> Option<f64>,
    ) -> Result<(), Error> {
        let along = |node: usize, normal: Option<[f64; 2]>| {
            pressure(node, normal).filter(|value| value.is_finite()).unwrap_or(0.0).abs()
        };
        let at = |node: usize| along(node, None);
        let of_edge = |edge: &Edge| -> Vec<f64> {
            let normal = normal(points, edge);
            edge.iter().map(|&node| along(node, Some(normal))).collect()
        };
        let has_other_side = |edge: &&Edge| {
            let [a, b] = [edge[0], edge[1]].map(|node| pair.path.coordinate(points[node]));
            !pair.gap(0.5 * (a + b)).is_infinite()
        };
        let beside = || self.off.iter().filter(has_other_side);
        let own = self.edges.iter().flatten().map(|&node| at(node));
        let largest = own.chain(beside().flat_map(of_edge)).fold(0.0, f64::max);
        let length = |edge: &Edge| {
            let middle = |radial: usize| 0.5 * (points[edge[0]][radial] + points[edge[1]][radial]).abs();
            distance(points[edge[0]], points[edge[1]]) * radial.map_or(1.0, middle) / edge.len() as f64
        };
        let on_side = |edge: &Edge| length(edge) * edge.iter().map(|&node| at(node)).sum::<f64>();
        let force = |edge: &Edge| length(edge) * of_edge(edge).iter().sum::<f64>();
        // The edge at which the contact ends has one pressed node.
        let pressed = || beside().filter(|edge| of_edge(edge).iter().all(|value| *value > PRESSED * largest));
        let dropped = pressed().map(force).sum::<f64>();
        let whole = self.edges.iter().map(on_side).sum::<f64>() + beside().map(force).sum::<f64>();
        if dropped <= DROPPED * whole {
            // Nodes of quadratic edges go by three.
            let is_pressed = |node: usize| at(node) > PRESSED * largest || self.order() == Order::Quadratic;
            let broken = self.broken(pair, points, is_pressed);
            return broken.map_or(Ok(()), |ends| Err(source.refused(lacking(pair, ends), ALL)));
        }
        let is_beyond = |edge: &Edge| edge.iter().any(|&node| pair.path.coordinate(points[node]).abs() > pair.stretch);
        let beyond = pressed().filter(|edge| is_beyond(edge)).count();
        let message = format!(
            "{} of the edges that are pressed lie off the undeformed path of contact `{}`, {beyond} of them beyond \
            its candidate stretch: {:.2} % of the force would be left out",
            pressed().count(),
            pair.name,
            100.0 * dropped / whole
        );
        let remedy = match beyond == pressed().count() {
            true => format!("give the contact a longer `stretch`{}", one_half(pair)),
            false => format!("{UNDEFORMED}{}{}", one_half(pair), self.fits),
        };
        Err(source.refused(message, remedy))
    }
}

/// What more to do where the scene has one of two such contacts, which no half of it is.
fn one_half(pair: &ContactPair) -> &'static str {
    if pair.symmetric && pair.path.has_both_sides() { ONE_HALF } else { "" }
}

/// A unit normal of an edge.
fn normal(points: &[[f64; 2]], edge: &Edge) -> [f64; 2] {
    let [a, b] = [points[edge[0]], points[edge[1]]];
    let length = distance(a, b);
    [(b[1] - a[1]) / length, (a[0] - b[0]) / length]
}

/// What is said of a part of a side that no edge is on \[mm, or rad on an arc\].
fn lacking(pair: &ContactPair, ends: [f64; 2]) -> String {
    let [from, to] = ends.map(|s| display_factor(&pair.path) * s);
    let unit = if pair.path.is_straight() { "mm" } else { "°" };
    format!("no edge of its cells lies on contact `{}` from {from:.4} to {to:.4} {unit}", pair.name)
}

impl Side {
    /// A part of the side that no edge is on, beside a node that is pressed.
    fn broken(&self, pair: &ContactPair, points: &[[f64; 2]], is_pressed: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
        let place = |node: usize| (signed_coordinate(pair, points[node]), node);
        let in_order = |edge: &Edge| {
            let [a, b] = [place(edge[0]), place(edge[1])];
            if a.0 <= b.0 { [a, b] } else { [b, a] }
        };
        let mut edges: Vec<[(f64, usize); 2]> = self.edges.iter().map(in_order).collect();
        edges.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
        let is_broken = |two: &&[[(f64, usize); 2]]| {
            let [[_, (from, end)], [(to, begin), _]] = [two[0], two[1]];
            to - from > APART * (two[0][1].0 - two[0][0].0) && (is_pressed(end) || is_pressed(begin))
        };
        edges.windows(2).find(is_broken).map(|two| [two[0][1].0, two[1][0].0])
    }
}

/// The factor by which more than so many edges would lie on the side, as a part of a remedy; nothing where none is.
fn unit_that_fits(
    scene: &Scene,
    (pair, body): (&ContactPair, usize),
    points: &[[f64; 2]],
    outline: &[Edge],
    more_than: usize,
) -> String {
    let count = |factor: f64| {
        let scaled: Vec<[f64; 2]> = points.iter().map(|point| point.map(|x| factor * x)).collect();
        let on_side: Vec<&Edge> = outline.iter().filter(|edge| lies_on(scene, (pair, body), &scaled, edge)).collect();
        let reach = on_side.iter().flat_map(|edge| &edge[..2]).map(|&node| pair.path.coordinate(scaled[node]).abs());
        if reach.fold(0.0, f64::max) < REACHED * pair.stretch { 0 } else { on_side.len() }
    };
    let lengths = Role::Position.units().iter().filter(|(unit, factor)| !is_angle(unit) && (factor - 1.0).abs() > 0.0);
    let tried = lengths.flat_map(|(_, factor)| [*factor, 1.0 / factor]).map(|factor| (count(factor), factor));
    match tried.max_by_key(|(count, _)| *count) {
        Some((count, factor)) if count > more_than => {
            let factor = crate::markdown::significant(factor, 4);
            format!(
                "; with all coordinates times {factor} it would lie there, so that their unit may be another one than \
                was named"
            )
        }
        _ => String::new(),
    }
}

/// Whether an edge lies on the contact side of a body, within the candidate stretch: that of the second one within the
/// gap from the first.
fn lies_on(scene: &Scene, (pair, body): (&ContactPair, usize), points: &[[f64; 2]], edge: &Edge) -> bool {
    let is_within = |&node: &usize| pair.path.coordinate(points[node]).abs() <= pair.stretch * (1.0 + SAME);
    let length = distance(points[edge[0]], points[edge[1]]);
    let is_near = |&node: &usize| {
        let wanted = surface(scene, pair, points[node]);
        let gap = if body == pair.first { 0.0 } else { pair.gap(pair.path.coordinate(points[node])).abs() };
        wanted.is_none_or(|wanted| (pair.path.depth(points[node]) - wanted).abs() <= NEAR * length + gap)
    };
    faces((pair, body), points, edge) && edge.iter().all(is_within) && edge.iter().all(is_near)
}

/// Those of some edges that go on from others, one behind the other.
fn connected(points: &[[f64; 2]], from: &[Edge], others: &[&Edge]) -> Vec<Edge> {
    let key = |node: usize| points[node].map(|x| (x + 0.0).to_bits());
    let mut at: HashMap<[u64; 2], Vec<usize>> = HashMap::new();
    for (k, edge) in others.iter().enumerate() {
        edge[..2].iter().for_each(|&node| at.entry(key(node)).or_default().push(k));
    }
    let mut next: VecDeque<[u64; 2]> = from.iter().flat_map(|edge| [key(edge[0]), key(edge[1])]).collect();
    let mut found = Vec::new();
    while let Some(place) = next.pop_front() {
        for k in at.remove(&place).unwrap_or_default() {
            found.push(k);
            next.extend(others[k][..2].iter().map(|&node| key(node)));
        }
    }
    found.sort_unstable();
    found.dedup();
    found.into_iter().map(|k| others[k].clone()).collect()
}

/// Contact coordinate of a point, negative on the left of a symmetry line.
pub fn signed_coordinate(pair: &ContactPair, [x, y]: [f64; 2]) -> f64 {
    let s = pair.path.coordinate([x, y]);
    if !pair.path.has_both_sides() && x < pair.path.origin()[0] { 0.0 - s } else { s }
}

/// How deep the first body's side lies where a point is; none where only its mesh tells.
pub fn surface(scene: &Scene, pair: &ContactPair, point: [f64; 2]) -> Option<f64> {
    let origin = pair.path.origin();
    if let (Path::Arc(circle), false) = (&pair.path, matches!(pair.profile, Profile::Drawn)) {
        return Some(circle.radius);
    }
    // The side that the contact is on: a body may have another one on its other side.
    let below = pair.normal(point)[1] < 0.0;
    match (&scene.bodies[pair.first].shape, pair.path.is_straight()) {
        (Shape::Rectangle { y, .. }, true) => Some(origin[1] - if below { y[0] } else { y[1] }),
        (shape @ (Shape::Disc { .. } | Shape::Ring { .. }), true) => {
            let circle = shape.circle(pair.side(pair.first))?;
            let away = point[0] - circle.centre[0];
            let root = (circle.radius * circle.radius - away * away).max(0.0).sqrt();
            // A ring touches at its lowest point, on its inner side too.
            let is_lower = below || matches!(shape, Shape::Ring { .. });
            Some(origin[1] - circle.centre[1] + if is_lower { root } else { -root })
        }
        // On a mesh that is given, the side is one of its boundaries; others of the body may face the same way.
        (Shape::Given(mesh), _) => {
            let s = pair.path.coordinate(point);
            let depths = mesh.curves(pair.side(pair.first))?.into_iter().filter_map(|curve| curve.depth(&pair.path, s));
            // A closed boundary lies there twice.
            let away = |depth: &f64| (depth - pair.path.depth(point)).abs();
            depths.min_by(|a, b| away(a).total_cmp(&away(b)))
        }
        _ => None,
    }
}

/// Whether an edge of a body faces the other side of the contact.
fn faces((pair, body): (&ContactPair, usize), points: &[[f64; 2]], edge: &Edge) -> bool {
    pair.faces(body, [edge[0], edge[1]].map(|node| points[node]), ALONG)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Twice the area of a cell between its corners, negative where they run clockwise.
fn area(points: &[[f64; 2]], Cell { nodes, corners }: &Cell) -> f64 {
    let at = |k: usize| points[nodes[k % corners]];
    (0..*corners).map(|k| at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1]).sum()
}

/// Edges of one cell only, each with the cell to its left.
fn outline(points: &[[f64; 2]], cells: &[Cell]) -> Vec<Edge> {
    let mut known: HashMap<[usize; 2], Option<Edge>> = HashMap::new();
    for cell in cells {
        let Cell { nodes, corners } = cell;
        let is_clockwise = area(points, cell) < 0.0;
        for k in 0..*corners {
            let [a, b] = [nodes[k], nodes[(k + 1) % corners]];
            let ends = if is_clockwise { [b, a] } else { [a, b] };
            let edge = ends.into_iter().chain(nodes.get(corners + k).copied()).collect();
            known.entry([a.min(b), a.max(b)]).and_modify(|edge| *edge = None).or_insert(Some(edge));
        }
    }
    known.into_values().flatten().collect()
}
