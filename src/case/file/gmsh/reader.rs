//! Sections of a Gmsh file, format 4.1, ASCII (Gmsh reference manual, "MSH file format").
//!
//! Nothing is reserved by the counts that the file states: memory stays within a few times the size of the text.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use crate::case::file::source::Source;
use crate::error::Error;

use super::words::{Words, shown};

/// What Gmsh needs to be told for meshes of quadrilaterals.
pub const OPTIONS: &str = "mesh with Mesh.RecombineAll = 1, or transfinite surfaces and Recombine; 8-node cells come from Mesh.ElementOrder = 2 and Mesh.SecondOrderIncomplete = 1";
/// Most physical groups that a point, curve, surface or volume belongs to.
const MOST_GROUPS: usize = 16;
/// Most characters of a name (the manual, "$PhysicalNames").
const LONGEST_NAME: usize = 127;
/// What to do with a mesh of solids.
const PLANE: &str = "scenes are plane: mesh the surfaces only (gmsh -2), in the plane z = 0, of quadrilaterals";

/// Points, curves and surfaces by physical group.
#[derive(Debug, Default)]
pub struct Gmsh {
    /// Position of each node by its tag, in the file's unit.
    pub nodes: HashMap<u64, [f64; 2]>,
    /// Elements of the physical curves.
    pub curves: BTreeMap<String, Pieces>,
    /// Elements of the physical surfaces.
    pub surfaces: BTreeMap<String, Pieces>,
}

/// Elements of a physical group, block by block of the file; groups of one entity share its blocks.
pub type Pieces = Vec<Rc<[Piece]>>;

/// An element of Gmsh.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Its tag.
    pub tag: u64,
    /// Tags of its nodes: corners, then mid-sides.
    pub nodes: Vec<u64>,
    /// Three corners.
    pub is_triangular: bool,
}

/// Elements known here: type, nodes, corners. The others are of three dimensions or higher order.
const TYPES: [(u64, usize, usize); 10] = [
    (15, 1, 1),
    (1, 2, 2),
    (8, 3, 2),
    (26, 4, 2),
    (2, 3, 3),
    (9, 6, 3),
    (21, 10, 3),
    (3, 4, 4),
    (16, 8, 4),
    (10, 9, 4),
];

/// Physical groups by dimension and entity.
type Groups = HashMap<(usize, i64), Vec<u64>>;

impl Gmsh {
    /// Reads a file's text; what is wrong is told with its line.
    pub fn parse(source: Source) -> Result<Self, Error> {
        let mut words = Words { source, at: 0 };
        let (mut names, mut groups) = (HashMap::new(), Groups::new());
        let (mut gmsh, mut sections) = (Self::default(), Vec::new());
        while let Some((name, place)) = words.next() {
            match name {
                "$MeshFormat" => refuse_format(&mut words)?,
                "$PhysicalNames" => names = physical_names(&mut words)?,
                "$Entities" => groups = entities(&mut words)?,
                "$Nodes" => gmsh.nodes = nodes(&mut words)?,
                "$Elements" => gmsh.read_elements(&mut words, &names, &groups)?,
                _ if name.starts_with('$') => words.at = place.end,
                _ => {
                    let message = format!("`{}` stands where a section should begin", shown(name));
                    return Err(source.refused(place, message, "save the mesh again as version 4.1, ASCII"));
                }
            }
            words.skip(name, place)?;
            sections.push(name);
        }
        for wanted in ["$MeshFormat", "$Entities", "$Nodes", "$Elements"] {
            if !sections.contains(&wanted) {
                let end = source.text.len();
                let remedy = "save the mesh as version 4.1, ASCII, with physical groups";
                return Err(source.refused(end..end, format!("there is no section `{wanted}`"), remedy));
            }
        }
        Ok(gmsh)
    }

    /// Elements of the entities that belong to a physical group.
    fn read_elements(
        &mut self,
        words: &mut Words,
        names: &HashMap<(usize, u64), String>,
        groups: &Groups,
    ) -> Result<(), Error> {
        let blocks: u64 = words.number("a number of blocks")?;
        for what in ["a number of elements", "an element tag", "an element tag"] {
            words.number::<u64>(what)?;
        }
        for _ in 0..blocks {
            let dimension: usize = words.number("a dimension")?;
            let entity: i64 = words.number("an entity")?;
            let begin = words.begin();
            let kind: u64 = words.number("an element type")?;
            if dimension == 3 {
                let message = format!("elements of Gmsh's type {kind} are solids");
                return Err(words.refused(begin, message, PLANE));
            }
            let Some((_, count, corners)) = TYPES.iter().find(|(known, ..)| *known == kind).copied() else {
                let message = format!("elements of Gmsh's type {kind} are not read");
                return Err(words.refused(begin, message, OPTIONS));
            };
            if dimension != (corners - 1).min(2) {
                let message = format!("elements of Gmsh's type {kind} stand in an entity of dimension {dimension}");
                return Err(words.refused(begin, message, "save the mesh again"));
            }
            let elements: u64 = words.number("a number of elements")?;
            let mut pieces = Vec::new();
            for _ in 0..elements {
                let tag = words.number("an element tag")?;
                let begin = words.begin();
                let nodes = (0..count).map(|_| words.number("a node tag")).collect::<Result<Vec<u64>, Error>>()?;
                if let Some(missing) = nodes.iter().find(|node| !self.nodes.contains_key(node)) {
                    let message = format!("element {tag} names node {missing}, which does not exist");
                    return Err(words.refused(begin, message, "save the mesh again, with its nodes first"));
                }
                pieces.push(Piece { tag, nodes, is_triangular: corners == 3 });
            }
            let Some(named) = (match dimension {
                1 => Some(&mut self.curves),
                2 => Some(&mut self.surfaces),
                _ => None,
            }) else {
                continue;
            };
            let pieces: Rc<[Piece]> = pieces.into();
            for group in groups.get(&(dimension, entity)).into_iter().flatten() {
                let name = names.get(&(dimension, *group)).cloned().unwrap_or_else(|| group.to_string());
                named.entry(name).or_default().push(Rc::clone(&pieces));
            }
        }
        Ok(())
    }
}

fn refuse_format(words: &mut Words) -> Result<(), Error> {
    let begin = words.begin();
    let [version, kind]: [f64; 2] = [words.number("a version")?, words.number("a file type")?];
    if version == 4.1 && kind == 0.0 {
        words.number::<u64>("a size")?;
        return Ok(());
    }
    let found = if kind == 0.0 { format!("version {version}") } else { "a binary file".into() };
    let remedy = "save it as version 4.1, ASCII: Mesh.MshFileVersion = 4.1, Mesh.Binary = 0";
    Err(words.refused(begin, format!("the mesh is {found}"), remedy))
}

/// `dimension tag "name"`, one a line.
fn physical_names(words: &mut Words) -> Result<HashMap<(usize, u64), String>, Error> {
    let count: u64 = words.number("a number of names")?;
    let mut names = HashMap::new();
    for _ in 0..count {
        let (dimension, tag) = (words.number("a dimension")?, words.number("a tag")?);
        let (line, place) = words.line();
        let quoted = line.trim().strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
        let Some(name) = quoted else {
            return Err(words.source.refused(place, "this is no name in quotes", "save the mesh again"));
        };
        let length = name.chars().count();
        if length > LONGEST_NAME {
            let remedy = format!("give the group a name of at most {LONGEST_NAME} characters");
            return Err(words.source.refused(place, format!("this name has {length} characters"), remedy));
        }
        names.insert((dimension, tag), name.to_owned());
    }
    Ok(names)
}

/// Physical groups of points, curves, surfaces and volumes.
fn entities(words: &mut Words) -> Result<Groups, Error> {
    let mut counts = [0_u64; 4];
    for count in &mut counts {
        *count = words.number("a number of entities")?;
    }
    let mut groups = Groups::new();
    for (dimension, count) in counts.into_iter().enumerate() {
        for _ in 0..count {
            let tag = words.number("an entity")?;
            let box_corners = if dimension == 0 { 3 } else { 6 };
            for _ in 0..box_corners {
                words.number::<f64>("a coordinate")?;
            }
            let physical: u64 = words.number("a number of groups")?;
            let own = groups.entry((dimension, tag)).or_default();
            for _ in 0..physical {
                let begin = words.begin();
                // Its sign tells the orientation of the entity in it.
                own.push(words.number::<i64>("a group")?.unsigned_abs());
                if own.len() > MOST_GROUPS {
                    let message = format!("entity {tag} belongs to more than {MOST_GROUPS} physical groups");
                    let remedy = format!("give every curve and surface at most {MOST_GROUPS}, and list it once");
                    return Err(words.refused(begin, message, remedy));
                }
            }
            if dimension > 0 {
                let bounds: u64 = words.number("a number of bounding entities")?;
                for _ in 0..bounds {
                    words.number::<i64>("a bounding entity")?;
                }
            }
        }
    }
    Ok(groups)
}

/// Node positions; all must lie in one plane z = 0.
fn nodes(words: &mut Words) -> Result<HashMap<u64, [f64; 2]>, Error> {
    let blocks: u64 = words.number("a number of blocks")?;
    for what in ["a number of nodes", "a node tag", "a node tag"] {
        words.number::<u64>(what)?;
    }
    let mut nodes = HashMap::new();
    for _ in 0..blocks {
        let dimension: u64 = words.number("a dimension")?;
        words.number::<i64>("an entity")?;
        let parametric: u64 = words.number("0 or 1")?;
        let count: u64 = words.number("a number of nodes")?;
        let mut tags: Vec<u64> = Vec::new();
        for _ in 0..count {
            tags.push(words.number("a node tag")?);
        }
        for tag in tags {
            let begin = words.begin();
            let [x, y, z] = [words.coordinate("x")?, words.coordinate("y")?, words.coordinate("z")?];
            for _ in 0..if parametric == 1 { dimension.min(3) } else { 0 } {
                words.number::<f64>("a parameter")?;
            }
            if z.abs() > 1e-9 * (1.0 + x.abs().max(y.abs())) {
                let message = format!("node {tag} lies at z = {z}");
                return Err(words.refused(begin, message, PLANE));
            }
            if nodes.insert(tag, [x, y]).is_some() {
                let message = format!("node {tag} stands twice");
                return Err(words.refused(begin, message, "save the mesh again"));
            }
        }
    }
    Ok(nodes)
}
