//! Bodies from meshes made elsewhere: files of Gmsh (`msh`, of `words`) and input decks of CalculiX and Abaqus (`inp`),
//! their groups of cells and of sides (`elements`).

mod elements;
mod inp;
mod msh;
mod words;

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::case::file::source::text_of;
use crate::case::file::value::Value;
use crate::elasticity::{element, quadrature};
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{BoundaryName, GivenMesh, HalfTold, Shape};

use elements::{Elements, OPTIONS, Piece, SUBDIVISION, number};

/// Names of the shapes of meshes in files: `gmsh` is the older one, and any format is read by both.
pub const SHAPES: [&str; 2] = ["mesh", "gmsh"];
/// Largest mesh file that is read \[bytes\].
const LARGEST_FILE: u64 = 64 << 20;
/// Nodes of a cell of up to nine counter-clockwise, where they were listed clockwise.
const TURNED: [usize; 9] = [0, 3, 2, 1, 7, 6, 5, 4, 8];

/// Numbers of the ends of a side in ascending order.
type SideKey = [u64; 2];
/// A side of cells: first, last and middle node, a cell to its left; and of how many cells it is one.
type Side = (Vec<u64>, usize);

/// Where the mesh that a body is read from lies: its file is given from the folder of the scene file.
pub fn path(table: Value) -> PathBuf {
    table.source.file.parent().unwrap_or(Path::new("")).join(table.at("file").text())
}

/// A group of cells of a mesh file as a body, of revolution or of the plane.
pub fn shape(revolves: bool, table: Value) -> Result<Shape, Error> {
    let [group, side] = ["group", "contact"].map(|key| table.at(key));
    let path = path(table);
    let bytes = bytes(table.at("file"), &path)?;
    // Numbers of Gmsh may be in binary.
    let text = text_of(&bytes);
    let bytes = text.as_deref().map_or(&bytes[..], str::as_bytes);
    let is_deck = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("inp"));
    // Decks have other endings too, and every line of them that is no data begins with a star.
    let is_deck = is_deck || bytes.trim_ascii_start().starts_with(b"*");
    let mesh = if is_deck { inp::parse(&path, bytes)? } else { msh::parse(&path, bytes)? };
    if let Some(refused) = mesh.of_revolution.as_ref().filter(|_| !revolves) {
        return Err(refused.clone());
    }
    let (cells, turned) = cells(group, &mesh)?;
    let sides = sides(&cells);
    let mut numbers = HashMap::new();
    let mut points = Vec::new();
    let mut number = |tag: u64| -> usize {
        *numbers.entry(tag).or_insert_with(|| {
            points.push(mesh.nodes.get(&tag).copied().unwrap_or([f64::NAN; 2]).map(|x| table.units.length * x));
            points.len() - 1
        })
    };
    let own = cells.iter().map(|cell| cell.iter().map(|tag| number(*tag)).collect()).collect();
    let mut boundaries: BTreeMap<BoundaryName, Vec<Vec<usize>>> = BTreeMap::new();
    let mut inner = BTreeSet::new();
    let (curves_of, half_told) = curves(&mesh, &sides);
    for (name, own) in curves_of {
        let name: BoundaryName = name.to_owned().into();
        if own.iter().any(|(_, cells)| *cells > 1) {
            inner.insert(name.clone());
        }
        let edges = own.iter().map(|(side, _)| side.iter().map(|tag| number(*tag)).collect());
        boundaries.insert(name, edges.collect());
    }
    let [surfaces, curves] = mesh.called;
    let rounding = table.units.length * mesh.rounding();
    let mut given = GivenMesh { points, cells: own, boundaries, half_told, inner, turned, rounding };
    let own = boundary(&given, side)?;
    let is_taken = own.as_deref() != Some(CONTACT) && given.boundaries.contains_key(CONTACT);
    let remedy = "rename that group: the boundary given as `contact` takes this name";
    side.refuse_if(is_taken, format!("another {curves} is called `contact`"), remedy)?;
    let Some(own) = own else {
        let known: Vec<&str> = given.boundaries.keys().map(AsRef::as_ref).collect();
        let message = format!("no {curves} `{}` bounds `{}`", side.text(), group.text());
        return Err(side.refused(message, known_names(&mesh, &known)));
    };
    let message = format!("the {curves} `{own}` runs inside the {surfaces} `{}`", group.text());
    side.refuse_if(given.inner.contains(&own), message, "name a curve on the outline of the body")?;
    let contact = given.boundaries[&own].clone();
    given.boundaries.insert(CONTACT.into(), contact);
    Ok(Shape::Given(Arc::new(given)))
}

/// The one of some names that a name means: the same, or else the only one that differs from it in case alone, as which
/// Abaqus takes names.
fn meant<'a>(name: &str, known: impl Iterator<Item = &'a str> + Clone) -> Option<&'a str> {
    let mut alike = known.clone().filter(|known| known.to_lowercase() == name.to_lowercase());
    let only = || alike.next().filter(|_| alike.next().is_none());
    known.clone().find(|known| *known == name).or_else(only)
}

/// The boundary that a name means; none where there is none. Refused where it is given by a set of nodes that leaves a
/// side half told.
pub fn boundary(mesh: &GivenMesh, name: Value) -> Result<Option<BoundaryName>, Error> {
    let known = mesh.boundaries.keys().chain(mesh.half_told.keys()).map(AsRef::as_ref);
    let Some(called) = meant(name.text(), known) else { return Ok(None) };
    Err(match mesh.half_told.get(called) {
        None => return Ok(Some(called.to_owned().into())),
        Some(HalfTold::Alone(node)) => name.refused(
            format!("the set `{called}` has node {node}, but not all nodes of a side with it"),
            "list all nodes of every side, or the corners alone, and no others of the outline",
        ),
        Some(HalfTold::Hole(node)) => name.refused(
            format!("the set `{called}` lacks node {node}, between two of its sides that lie along one line"),
            "list that node too; where a part of the line is meant to be left out, name the sides, by a *SURFACE or a \
            group of lines",
        ),
    })
}

/// The names there are, or what to do where there are none.
fn known_names(mesh: &Elements, known: &[&str]) -> String {
    if known.is_empty() {
        return format!("there are none: {}", mesh.made);
    }
    format!("known: {}", known.join(", "))
}

fn bytes(name: Value, path: &Path) -> Result<Vec<u8>, Error> {
    let refused = |reason: String| {
        let remedy = "give the file as seen from the folder of the scene file: a Gmsh mesh (.msh), or an input deck of \
            CalculiX or Abaqus (.inp)";
        name.refused(format!("`{}` cannot be read: {reason}", path.display()), remedy)
    };
    let failed = |error: std::io::Error| refused(error.to_string());
    if !std::fs::metadata(path).map_err(failed)?.is_file() {
        return Err(refused("this is no file".into()));
    }
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(refused(format!("it has more than {LARGEST_FILE} bytes")));
    }
    Ok(bytes)
}

/// Cells of a group, counter-clockwise, and how many were turned: Gmsh lists cells clockwise where their surface is
/// turned over.
fn cells(name: Value, mesh: &Elements) -> Result<(Vec<Vec<u64>>, usize), Error> {
    let called = mesh.called[0];
    let known = mesh.surfaces.keys().map(String::as_str);
    let Some(group) = meant(name.text(), known.clone()).and_then(|own| mesh.surfaces.get(own)) else {
        let message = format!("there is no {called} `{}`", name.text());
        return Err(name.refused(message, known_names(mesh, &known.collect::<Vec<_>>())));
    };
    let pieces = || mesh.of(group);
    let refused = |message: String, remedy: &str| Err(name.refused(message, remedy));
    if let Some(piece) = pieces().find(|piece| piece.corners == 3) {
        let message = format!("cell {} of `{}` is a triangle, no quadrilateral", piece.tag, name.text());
        return refused(message, SUBDIVISION);
    }
    let Some(first) = pieces().next() else {
        return refused(format!("the {called} `{}` has no cells", name.text()), OPTIONS);
    };
    if let Some(piece) = pieces().find(|piece| piece.nodes.len() != first.nodes.len()) {
        let message =
            format!("cells {} and {} have {} and {} nodes", first.tag, piece.tag, first.nodes.len(), piece.nodes.len());
        return refused(message, "mesh the whole body with one order");
    }
    let area = |piece: &Piece| {
        let at = |k: usize| mesh.nodes.get(&piece.nodes[k % 4]).copied().unwrap_or([f64::NAN; 2]);
        (0..4).map(|k| at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1]).sum::<f64>()
    };
    let stands_twice = |piece: &Piece| piece.nodes.iter().collect::<HashSet<_>>().len() < piece.nodes.len();
    if let Some(piece) = pieces().find(|piece| area(piece).is_nan() || area(piece) == 0.0 || stands_twice(piece)) {
        let remedy = "repair the mesh: a quadrilateral with a node twice is a triangle";
        return refused(format!("cell {} of `{}` is degenerate", piece.tag, name.text()), remedy);
    }
    let clockwise = |piece: &Piece| area(piece) < 0.0;
    let counter_clockwise = |piece: &Piece| match clockwise(piece) {
        false => piece.nodes.clone(),
        true => TURNED.iter().filter_map(|&k| piece.nodes.get(k).copied()).collect(),
    };
    let cells: Vec<Vec<u64>> = pieces().map(counter_clockwise).collect();
    let rule = quadrature::gauss_square(if first.nodes.len() == 4 { 2 } else { 3 });
    for (piece, cell) in pieces().zip(&cells) {
        let points: Vec<[f64; 2]> = cell.iter().filter_map(|tag| mesh.nodes.get(tag).copied()).collect();
        let inside_out = rule.iter().find_map(|(at, _)| element::gradients(&points, *at).err());
        if let Some(jacobian) = inside_out {
            let message = format!(
                "cell {} of `{}` is turned inside out: its Jacobian determinant is {jacobian:.3e} at a quadrature \
                point",
                piece.tag,
                name.text()
            );
            return refused(
                message,
                "repair the mesh: a corner is not convex, or a mid-side node lies far from the middle",
            );
        }
    }
    // Of two cells beside one another each runs along their common side the other way.
    let mut along = HashMap::new();
    for (piece, cell) in pieces().zip(&cells) {
        for k in 0..4 {
            if let Some(other) = along.insert([cell[k], cell[(k + 1) % 4]], piece.tag) {
                let message = format!("cells {other} and {} of `{}` lie over one another", piece.tag, name.text());
                return refused(message, "repair the mesh: it is folded");
            }
        }
    }
    Ok((cells, pieces().filter(|piece| clockwise(piece)).count()))
}

/// Every side of a cell.
fn sides(cells: &[Vec<u64>]) -> HashMap<SideKey, Side> {
    let mut sides: HashMap<SideKey, Side> = HashMap::new();
    for cell in cells {
        for k in 0..4 {
            let (from, to) = (cell[k], cell[(k + 1) % 4]);
            let side = || ([from, to].into_iter().chain(cell.get(4 + k).copied()).collect(), 0);
            sides.entry(key(from, to)).or_insert_with(side).1 += 1;
        }
    }
    sides
}

fn key(a: u64, b: u64) -> SideKey {
    [a.min(b), a.max(b)]
}

/// Curves by their names.
type Curves<'a> = BTreeMap<&'a str, Vec<&'a Side>>;

/// The sides of cells of every curve by its name: those of its lines, or of its nodes where no lines are called so.
/// Apart, sets of nodes that leave a side half told.
fn curves<'a>(mesh: &'a Elements, sides: &'a HashMap<SideKey, Side>) -> (Curves<'a>, BTreeMap<BoundaryName, HalfTold>) {
    let mut curves: BTreeMap<&str, Vec<&Side>> = BTreeMap::new();
    for (name, lines) in &mesh.curves {
        // The middle node of a line stands last or between its ends.
        let side = |piece: &Piece| {
            let ends = |[i, j]: [usize; 2]| sides.get_key_value(&key(*piece.nodes.get(i)?, *piece.nodes.get(j)?));
            [[0, 1], [0, 2], [1, 2]].into_iter().find_map(ends)
        };
        // A side that is listed again is the same side.
        let mut listed = HashSet::new();
        let own = mesh.of(lines).filter_map(side).filter(|(key, _)| listed.insert(**key));
        curves.insert(name, own.map(|(_, side)| side).collect());
    }
    let mut half_told = BTreeMap::new();
    if !mesh.sets.is_empty() {
        let known = Known::of(mesh, sides);
        for (name, nodes) in mesh.sets.iter().filter(|(name, _)| !mesh.curves.contains_key(*name)) {
            let all = known.sides_of(nodes);
            match known.half_told(nodes, &all) {
                Some(how) => drop(half_told.insert(name.clone().into(), how)),
                None => drop(curves.insert(name, all)),
            }
        }
    }
    curves.retain(|_, sides| !sides.is_empty());
    (curves, half_told)
}

/// Sides of cells, by which those of sets of nodes are found.
struct Known<'a> {
    mesh: &'a Elements,
    /// Sides by the smaller number of their ends.
    beginning: HashMap<u64, Vec<&'a Side>>,
    /// Sides of the outline by their first node; the body lies to their left.
    next: HashMap<u64, &'a Side>,
    /// Nodes of the cells, and of them those of the outline and those at the middle of sides.
    all: HashSet<u64>,
    outline: HashSet<u64>,
    middles: HashSet<u64>,
}

/// Most sides in a row that a set of nodes is thought to have lost; and of more than two, so many times as many sides
/// as it has at least: else they are a part that is left out.
const HOLE: usize = 4;
const SEVERAL: usize = 3;
/// Cosine of the turn between two sides up to which they lie along one line.
const ALONG: f64 = 0.5;

impl<'a> Known<'a> {
    fn of(mesh: &'a Elements, sides: &'a HashMap<SideKey, Side>) -> Self {
        let mut beginning: HashMap<u64, Vec<&Side>> = HashMap::new();
        for (key, side) in sides {
            beginning.entry(key[0]).or_default().push(side);
        }
        beginning.values_mut().for_each(|sides| sides.sort_unstable());
        let outer = || sides.values().filter(|(_, cells)| *cells == 1);
        Self {
            mesh,
            beginning,
            next: outer().map(|side| (side.0[0], side)).collect(),
            all: sides.values().flat_map(|(side, _)| side).copied().collect(),
            outline: outer().flat_map(|(side, _)| side).copied().collect(),
            middles: sides.values().filter_map(|(side, _)| side.get(2)).copied().collect(),
        }
    }

    /// The sides all of whose nodes are in a set.
    fn sides_of(&self, nodes: &[u64]) -> Vec<&'a Side> {
        let own: HashSet<u64> = nodes.iter().copied().collect();
        // A set without any mid-side node is one of corners, and so are its sides.
        let asked = if own.is_disjoint(&self.middles) { 2 } else { 3 };
        let all = nodes.iter().filter_map(|node| self.beginning.get(node)).flatten().copied();
        let mut all: Vec<&Side> =
            all.filter(|(side, _)| side.iter().take(asked).all(|node| own.contains(node))).collect();
        // Of a set of all nodes the outline is meant, and so it is where a body is one cell wide.
        if all.iter().any(|(_, cells)| *cells == 1) {
            all.retain(|(_, cells)| *cells == 1);
        }
        all
    }

    /// What a set lacks: it has a node of the outline, but no side with it, or no side at all, or a hole of a few
    /// nodes.
    fn half_told(&self, nodes: &[u64], sides: &[&'a Side]) -> Option<HalfTold> {
        let told: HashSet<u64> = sides.iter().flat_map(|(side, _)| side).copied().collect();
        let of = if sides.is_empty() { &self.all } else { &self.outline };
        let alone = nodes.iter().find(|node| !told.contains(node) && of.contains(node));
        let hole = || self.hole(sides).map(|node| HalfTold::Hole(number(node)));
        alone.map(|node| HalfTold::Alone(number(*node))).or_else(hole)
    }

    /// The first node that is missing between two sides of the outline which lie along one line: the middle one of a
    /// side between them, or a corner of [a few](HOLE).
    fn hole(&self, sides: &[&'a Side]) -> Option<u64> {
        let keys: HashSet<SideKey> = sides.iter().map(|(side, _)| key(side[0], side[1])).collect();
        let is_told = |(side, _): &&Side| keys.contains(&key(side[0], side[1]));
        let next = |(side, _): &Side| self.next.get(&side[1]).copied();
        let direction = |(side, _): &Side| {
            let [from, to] =
                [side[0], side[1]].map(|node| self.mesh.nodes.get(&node).copied().unwrap_or([f64::NAN; 2]));
            [to[0] - from[0], to[1] - from[1]]
        };
        let goes_on = |pair: &[&Side]| {
            let [[x, y], [u, v]] = [direction(pair[0]), direction(pair[1])];
            x * u + y * v > ALONG * x.hypot(y) * u.hypot(v)
        };
        let missing = |first: &&'a Side| -> Option<u64> {
            let mut line = vec![*first];
            while line.len() < HOLE + 2 && (line.len() == 1 || !is_told(line.last()?)) {
                line.push(next(line.last()?)?);
            }
            let (last, between) = line[1..].split_last()?;
            let node = match between {
                // Of one side the middle node is missing, of several the corners between them.
                [one] => one.0.get(2),
                [one, _] => one.0.get(1),
                [one, ..] if SEVERAL * between.len() <= sides.len() => one.0.get(1),
                _ => None,
            };
            node.copied().filter(|_| is_told(last) && line.windows(2).all(goes_on))
        };
        sides.iter().filter(|(_, cells)| *cells == 1).find_map(missing)
    }
}
