//! Bodies from Gmsh meshes: ASCII files of format 4.1, their physical surfaces and curves.

mod reader;
mod words;

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::case::file::source::Source;
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{BoundaryName, GivenMesh, Shape};

use reader::{Gmsh, OPTIONS, Piece};

/// Largest mesh file that is read \[bytes\].
const LARGEST_FILE: u64 = 64 << 20;

/// What makes quadrilaterals of triangles.
const SUBDIVISION: &str =
    "mesh with Mesh.SubdivisionAlgorithm = 1, which cuts all cells into quadrilaterals, and Mesh.RecombineAll = 1";
/// Node tags of a side in ascending order.
type SideKey = [u64; 2];

/// Where the mesh that a body is read from lies: its file is given from the folder of the scene file.
pub fn path(table: Value) -> PathBuf {
    table.source.file.parent().unwrap_or(Path::new("")).join(table.at("file").text())
}

/// The physical surface of a mesh file as a body.
pub fn shape(table: Value) -> Result<Shape, Error> {
    let [group, side] = ["group", "contact"].map(|key| table.at(key));
    let path = path(table);
    let text = text(table.at("file"), &path)?;
    let gmsh = Gmsh::parse(Source { file: &path, text: &text })?;
    let (cells, turned) = cells(group, &gmsh)?;
    let sides = sides(&cells);
    let mut numbers = HashMap::new();
    let mut points = Vec::new();
    let mut number = |tag: u64| -> usize {
        *numbers.entry(tag).or_insert_with(|| {
            points.push(gmsh.nodes.get(&tag).copied().unwrap_or([f64::NAN; 2]).map(|x| table.units.length * x));
            points.len() - 1
        })
    };
    let own = cells.iter().map(|cell| cell.iter().map(|tag| number(*tag)).collect()).collect();
    let mut boundaries: BTreeMap<BoundaryName, Vec<Vec<usize>>> = BTreeMap::new();
    let mut inner = BTreeSet::new();
    for (name, pieces) in &gmsh.curves {
        let own = pieces
            .iter()
            .flat_map(|block| block.iter())
            .filter_map(|piece| sides.get(&key(piece.nodes[0], piece.nodes[1])));
        let own: Vec<&(Vec<u64>, usize)> = own.collect();
        if own.iter().any(|(_, cells)| *cells > 1) {
            inner.insert(name.clone().into());
        }
        let edges: Vec<Vec<usize>> =
            own.iter().map(|(side, _)| side.iter().map(|tag| number(*tag)).collect()).collect();
        if !edges.is_empty() {
            boundaries.insert(name.clone().into(), edges);
        }
    }
    if side.text() != CONTACT && boundaries.contains_key(CONTACT) {
        let remedy = "rename that group: the boundary given as `contact` takes this name";
        return Err(side.refused("another physical curve is called `contact`", remedy));
    }
    let known: Vec<&str> = boundaries.keys().map(AsRef::as_ref).collect();
    let Some(contact) = boundaries.get(side.text()) else {
        let message = format!("no physical curve `{}` bounds `{}`", side.text(), group.text());
        return Err(side.refused(message, known_names(&known)));
    };
    if inner.contains(side.text()) {
        let message = format!("the curve `{}` runs inside `{}`", side.text(), group.text());
        return Err(side.refused(message, "name a curve on the outline of the body"));
    }
    let contact = contact.clone();
    boundaries.insert(CONTACT.into(), contact);
    Ok(Shape::Given(Arc::new(GivenMesh { points, cells: own, boundaries, inner, turned })))
}

/// The names there are, or what to do where there are none.
fn known_names(known: &[&str]) -> String {
    if known.is_empty() {
        return "there are none: give the body a Physical Surface and its sides Physical Curves in Gmsh".into();
    }
    format!("known: {}", known.join(", "))
}

fn text(name: Value, path: &Path) -> Result<String, Error> {
    let refused = |reason: String| {
        let remedy = "give the file as seen from the folder of the scene file; save it as version 4.1, ASCII";
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
    // Binary files are told from their second line on.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Cells of the physical surface, counter-clockwise, and how many were turned: Gmsh lists cells clockwise where their surface is
/// turned over.
fn cells(name: Value, gmsh: &Gmsh) -> Result<(Vec<Vec<u64>>, usize), Error> {
    let Some(blocks) = gmsh.surfaces.get(name.text()) else {
        let known: Vec<&str> = gmsh.surfaces.keys().map(String::as_str).collect();
        let message = format!("there is no physical surface `{}`", name.text());
        return Err(name.refused(message, known_names(&known)));
    };
    let pieces = || blocks.iter().flat_map(|block| block.iter());
    let refused = |message: String, remedy: &str| Err(name.refused(message, remedy));
    let other = |piece: &&Piece| ![4, 8].contains(&piece.nodes.len());
    if let Some(piece) = pieces().find(|piece| piece.is_triangular) {
        let message = format!("cell {} of `{}` is a triangle, no quadrilateral", piece.tag, name.text());
        return refused(message, SUBDIVISION);
    }
    if let Some(piece) = pieces().find(other) {
        let message = format!("cell {} of `{}` is no quadrilateral of 4 or 8 nodes", piece.tag, name.text());
        return refused(message, OPTIONS);
    }
    let Some(first) = pieces().next() else {
        return refused(format!("the physical surface `{}` has no cells", name.text()), OPTIONS);
    };
    if let Some(piece) = pieces().find(|piece| piece.nodes.len() != first.nodes.len()) {
        let message =
            format!("cells {} and {} have {} and {} nodes", first.tag, piece.tag, first.nodes.len(), piece.nodes.len());
        return refused(message, "mesh the whole body with one order");
    }
    let area = |piece: &Piece| {
        let at = |k: usize| gmsh.nodes.get(&piece.nodes[k % 4]).copied().unwrap_or([f64::NAN; 2]);
        (0..4).map(|k| at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1]).sum::<f64>()
    };
    if let Some(piece) = pieces().find(|piece| area(piece).is_nan() || area(piece) == 0.0) {
        return refused(format!("cell {} of `{}` is degenerate", piece.tag, name.text()), "repair the mesh");
    }
    let clockwise = |piece: &Piece| area(piece) < 0.0;
    let counter_clockwise = |piece: &Piece| match (clockwise(piece), piece.nodes.len()) {
        (false, _) => piece.nodes.clone(),
        (true, 4) => [0, 3, 2, 1].map(|k: usize| piece.nodes[k]).to_vec(),
        (true, _) => [0, 3, 2, 1, 7, 6, 5, 4].map(|k: usize| piece.nodes[k]).to_vec(),
    };
    let cells: Vec<Vec<u64>> = pieces().map(counter_clockwise).collect();
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

/// Every side of a cell: first, last and middle node, a cell to its left; and of how many cells it is one.
fn sides(cells: &[Vec<u64>]) -> HashMap<SideKey, (Vec<u64>, usize)> {
    let mut sides: HashMap<SideKey, (Vec<u64>, usize)> = HashMap::new();
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
