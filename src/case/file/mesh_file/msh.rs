//! Sections of a Gmsh file of format 4.1 or 2.2, as text or binary (Gmsh reference manual, "MSH file format").
//!
//! Nothing is reserved by the counts that the file states: memory stays within a few times the size of the file.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::path::Path;

use crate::case::file::source::Source;
use crate::error::Error;

use super::elements::{Elements, KINDS, OPTIONS, PLANE, Piece, add_to};
use super::words::{Coding, Words, shown};

/// Most physical groups that a point, curve, surface or volume belongs to.
const MOST_GROUPS: usize = 16;
/// Most characters of a name (the manual, "$PhysicalNames").
const LONGEST_NAME: usize = 127;
/// How groups are made.
const MADE: &str = "give the body a Physical Surface and its sides Physical Curves in Gmsh";
/// What to do with a file that is none of Gmsh's.
const OTHER: &str = "give a mesh of Gmsh (.msh), or an input deck of CalculiX or Abaqus (.inp); Gmsh opens .bdf, \
    .unv, .med, .cgns, .stl and .vtk and saves them as .msh, as `meshio convert` does";
/// What to do with a file of another version.
const VERSIONS: &str = "save it as version 4.1 or 2.2: Mesh.MshFileVersion = 4.1";

/// Gmsh's types of solids of first and second order: files of format 2.2 say no dimension.
const SOLIDS: [i64; 11] = [4, 5, 6, 7, 11, 12, 13, 14, 17, 18, 19];

/// Physical groups by dimension and entity.
type Entities = HashMap<(i64, i64), Vec<u64>>;

/// Sections that are read to their last row.
const SECTIONS: [&str; 6] = ["$PhysicalNames", "$Entities", PARTITIONED, "$Nodes", PARAMETRIC, "$Elements"];
/// Entities of a mesh that is cut into parts.
const PARTITIONED: &str = "$PartitionedEntities";
/// Nodes of format 2.2 with their parameters (Mesh.SaveParametric).
const PARAMETRIC: &str = "$ParametricNodes";

/// What a file is read into.
struct Gmsh<'a> {
    words: Words<'a>,
    /// Whether it is of format 4.1, and not of 2.2.
    by_blocks: bool,
    /// Names of physical groups by dimension and number.
    names: HashMap<(i64, u64), String>,
    entities: Entities,
    elements: Elements,
}

/// Reads a file; what is wrong is told with its line.
pub fn parse(file: &Path, bytes: &[u8]) -> Result<Elements, Error> {
    let text = String::from_utf8_lossy(bytes);
    let source = Source { file, text: &text };
    let words = Words { source, bytes: text.as_bytes(), at: 0, coding: Coding::Text };
    let called = ["physical surface", "physical curve"];
    let elements = Elements { called, made: MADE, ..Elements::default() };
    let (names, entities) = (HashMap::new(), Entities::new());
    let mut gmsh = Gmsh { words, by_blocks: true, names, entities, elements };
    let mut sections = Vec::new();
    while let Some((name, place)) = gmsh.words.next() {
        gmsh.words.begin_data();
        let is_of_other = if gmsh.by_blocks { name == PARAMETRIC } else { name == "$Entities" || name == PARTITIONED };
        let is_read = SECTIONS.contains(&&*name) && !is_of_other;
        match &*name {
            "$MeshFormat" => gmsh.read_format(bytes)?,
            "$PhysicalNames" => gmsh.read_names()?,
            "$Entities" | PARTITIONED if is_read => gmsh.read_entities(name == PARTITIONED)?,
            "$Nodes" if gmsh.by_blocks => gmsh.read_nodes()?,
            "$Nodes" | PARAMETRIC if is_read => gmsh.read_listed_nodes(name == PARAMETRIC)?,
            "$Elements" if gmsh.by_blocks => gmsh.read_elements()?,
            "$Elements" => gmsh.read_listed_elements()?,
            // Comments of other programs begin like sections.
            _ if name.starts_with('$') && (!sections.is_empty() || gmsh.words.end_of(&name).is_some()) => {
                gmsh.words.at = place.end
            }
            _ => {
                let message = format!("`{}` stands where a section should begin", shown(&name));
                let remedy = if sections.is_empty() { OTHER } else { "save the mesh again as version 4.1, ASCII" };
                return Err(gmsh.words.wrong(place, message, remedy));
            }
        }
        if is_read {
            gmsh.words.closed(&name, place)?
        } else {
            gmsh.words.skip(&name, place)?
        }
        sections.push(if name == PARAMETRIC { "$Nodes".into() } else { name });
    }
    let wanted = ["$MeshFormat", "$Nodes", "$Elements"].into_iter().chain(gmsh.by_blocks.then_some("$Entities"));
    for wanted in wanted {
        if !sections.iter().any(|name| name == wanted) {
            let end = gmsh.words.bytes.len();
            let remedy = "save the mesh as version 4.1, ASCII, with physical groups";
            return Err(gmsh.words.wrong(end..end, format!("there is no section `{wanted}`"), remedy));
        }
    }
    Ok(gmsh.elements)
}

impl<'a> Gmsh<'a> {
    /// Version and coding; what is behind them is read from the bytes themselves where they are binary.
    fn read_format(&mut self, bytes: &'a [u8]) -> Result<(), Error> {
        let begin = self.words.begin();
        let version: f64 = self.words.number("a version")?;
        let kind: i64 = self.words.number("a file type")?;
        let size: u64 = self.words.number("a size")?;
        self.by_blocks = version == 4.1;
        if !self.by_blocks && !(2.0..=2.2).contains(&version) {
            return Err(self.words.refused(begin, format!("the mesh is version {version}"), VERSIONS));
        }
        if kind == 0 {
            return Ok(());
        }
        if size != 8 {
            let message = format!("its real numbers have {size} bytes, and those of 8 are read");
            return Err(self.words.refused(begin, message, VERSIONS));
        }
        // Up to here the file is text of the same places.
        self.words.bytes = bytes;
        self.words.at = self.words.at.min(bytes.len());
        self.words.coding = Coding::Little;
        self.words.begin_data();
        let begin = self.words.at;
        match self.words.whole("the number 1")?.to_le_bytes() {
            [1, 0, 0, 0, ..] => {}
            [0, 0, 0, 1, ..] => self.words.coding = Coding::Big,
            other => {
                let message = format!("the order of its bytes is told by the number 1, and {other:?} stands there");
                return Err(self.words.refused(begin, message, "save the mesh again"));
            }
        }
        Ok(())
    }

    /// `dimension tag "name"`, one a line, in binary files too.
    fn read_names(&mut self) -> Result<(), Error> {
        let words = &mut self.words;
        let count: u64 = words.number("a number of names")?;
        for _ in 0..count {
            let (dimension, tag) = (words.number("a dimension")?, words.number("a tag")?);
            let (line, place) = words.line();
            let quoted = line.trim().strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
            let Some(name) = quoted else {
                return Err(words.wrong(place, "this is no name in quotes", "save the mesh again"));
            };
            let length = name.chars().count();
            if length > LONGEST_NAME {
                let remedy = format!("give the group a name of at most {LONGEST_NAME} characters");
                return Err(words.wrong(place, format!("this name has {length} characters"), remedy));
            }
            self.names.insert((dimension, tag), name.to_owned());
        }
        Ok(())
    }

    /// Physical groups of points, curves, surfaces and volumes, or of the parts they are cut into.
    fn read_entities(&mut self, cut: bool) -> Result<(), Error> {
        let words = &mut self.words;
        if cut {
            words.count("a number of parts")?;
            for _ in 0..words.count("a number of ghosts")? {
                words.whole("a ghost")?;
                words.whole("a part")?;
            }
        }
        let mut counts = [0_u64; 4];
        for count in &mut counts {
            *count = words.count("a number of entities")?;
        }
        for (dimension, count) in (0_i64..).zip(counts) {
            for _ in 0..count {
                let tag = words.whole("an entity")?;
                if cut {
                    words.whole("a dimension")?;
                    words.whole("an entity")?;
                    for _ in 0..words.count("a number of parts")? {
                        words.whole("a part")?;
                    }
                }
                let box_corners = if dimension == 0 { 3 } else { 6 };
                for _ in 0..box_corners {
                    words.real("a coordinate")?;
                }
                let physical = words.count("a number of groups")?;
                let own = self.entities.entry((dimension, tag)).or_default();
                for _ in 0..physical {
                    let begin = words.begin();
                    // Its sign tells the orientation of the entity in it.
                    own.push(words.whole("a group")?.unsigned_abs());
                    if own.len() > MOST_GROUPS {
                        let message = format!("entity {tag} belongs to more than {MOST_GROUPS} physical groups");
                        let remedy = format!("give every curve and surface at most {MOST_GROUPS}, and list it once");
                        return Err(words.refused(begin, message, remedy));
                    }
                }
                if dimension > 0 {
                    let bounds = words.count("a number of bounding entities")?;
                    for _ in 0..bounds {
                        words.whole("a bounding entity")?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Nodes of format 4.1, by entities.
    fn read_nodes(&mut self) -> Result<(), Error> {
        let blocks = self.words.count("a number of blocks")?;
        for what in ["a number of nodes", "a node tag", "a node tag"] {
            self.words.count(what)?;
        }
        for _ in 0..blocks {
            let dimension = self.words.whole("a dimension")?;
            self.words.whole("an entity")?;
            let parametric = self.words.whole("0 or 1")?;
            let count = self.words.count("a number of nodes")?;
            let mut tags: Vec<u64> = Vec::new();
            for _ in 0..count {
                tags.push(self.words.count("a node tag")?);
            }
            for tag in tags {
                self.read_place(tag)?;
                for _ in 0..if parametric == 1 { dimension.min(3) } else { 0 } {
                    self.words.real("a parameter")?;
                }
            }
        }
        Ok(())
    }

    /// Nodes of format 2.2: each with its place and, where they are parametric, an entity and as many parameters as
    /// that has dimensions.
    fn read_listed_nodes(&mut self, parametric: bool) -> Result<(), Error> {
        let count: u64 = self.words.number("a number of nodes")?;
        self.words.begin_data();
        for _ in 0..count {
            let tag = self.words.short_tag("a node tag")?;
            self.read_place(tag)?;
            let dimension = if parametric { self.words.whole("a dimension")? } else { continue };
            self.words.whole("an entity")?;
            for _ in 0..if dimension < 3 { dimension } else { 0 } {
                self.words.real("a parameter")?;
            }
        }
        Ok(())
    }

    /// The place of a node.
    fn read_place(&mut self, tag: u64) -> Result<(), Error> {
        let words = &mut self.words;
        let begin = words.begin();
        let place = [words.real("x")?, words.real("y")?, words.real("z")?];
        self.elements.count_digits(place);
        self.elements.add_node(tag, place, |message, remedy| words.refused(begin, message, remedy))
    }

    /// Elements of format 4.1, of the entities that belong to a physical group.
    fn read_elements(&mut self) -> Result<(), Error> {
        let blocks = self.words.count("a number of blocks")?;
        for what in ["a number of elements", "an element tag", "an element tag"] {
            self.words.count(what)?;
        }
        for _ in 0..blocks {
            let dimension = self.words.whole("a dimension")?;
            let entity = self.words.whole("an entity")?;
            let begin = self.words.begin();
            let kind = self.words.whole("an element type")?;
            let (count, corners) = self.kind(begin, kind, dimension == 3)?;
            if dimension != dimension_of(corners) {
                let message = format!("elements of Gmsh's type {kind} stand in an entity of dimension {dimension}");
                return Err(self.words.refused(begin, message, "save the mesh again"));
            }
            let elements = self.words.count("a number of elements")?;
            let first = self.elements.pieces.len();
            for _ in 0..elements {
                let tag = self.words.count("an element tag")?;
                self.read_piece(tag, count, corners)?;
            }
            let own = first..self.elements.pieces.len();
            for group in self.entities.get(&(dimension, entity)).cloned().unwrap_or_default() {
                self.add_to_group(dimension, group, std::slice::from_ref(&own));
            }
        }
        Ok(())
    }

    /// Elements of format 2.2: each with its group, or, where they are binary, several of one type and as many tags.
    fn read_listed_elements(&mut self) -> Result<(), Error> {
        let mut left: u64 = self.words.number("a number of elements")?;
        self.words.begin_data();
        let mut of: BTreeMap<(i64, u64), Vec<Range<usize>>> = BTreeMap::new();
        while left > 0 {
            let text = self.words.coding == Coding::Text;
            let mut tag = if text { self.words.short_tag("an element tag")? } else { 0 };
            let begin = self.words.begin();
            let kind = self.words.whole("an element type")?;
            let (count, corners) = self.kind(begin, kind, SOLIDS.contains(&kind))?;
            let follow = if text { 1 } else { self.words.short_tag("a number of elements")? };
            if follow == 0 || follow > left {
                let message = format!("{follow} elements follow where {left} are left");
                return Err(self.words.refused(begin, message, "save the mesh again"));
            }
            let tags = self.words.short_tag("a number of tags")?;
            left -= follow;
            for _ in 0..follow {
                if !text {
                    tag = self.words.short_tag("an element tag")?;
                }
                let mut group = 0;
                for k in 0..tags {
                    let own = self.words.whole("a tag")?.unsigned_abs();
                    // The first one is its physical group, 0 where it has none.
                    group = if k == 0 { own } else { group };
                }
                let index = self.read_piece(tag, count, corners)?;
                if group > 0 {
                    add_to(of.entry((dimension_of(corners), group)).or_default(), index);
                }
            }
        }
        for ((dimension, group), own) in of {
            self.add_to_group(dimension, group, &own);
        }
        Ok(())
    }

    /// Nodes and corners of elements of a type.
    fn kind(&self, begin: usize, kind: i64, is_solid: bool) -> Result<(usize, usize), Error> {
        if is_solid {
            return Err(self.words.refused(begin, format!("elements of Gmsh's type {kind} are solids"), PLANE));
        }
        let known = KINDS.iter().find(|(known, ..)| *known == kind).map(|&(_, count, corners)| (count, corners));
        let refused = || self.words.refused(begin, format!("elements of Gmsh's type {kind} are not read"), OPTIONS);
        known.ok_or_else(refused)
    }

    /// An element of so many nodes; its index.
    fn read_piece(&mut self, tag: u64, count: usize, corners: usize) -> Result<usize, Error> {
        let (words, by_blocks) = (&mut self.words, self.by_blocks);
        let begin = words.begin();
        let node = |_| if by_blocks { words.count("a node tag") } else { words.short_tag("a node tag") };
        let nodes = (0..count).map(node).collect::<Result<Vec<u64>, Error>>()?;
        let piece = Piece { tag, nodes, corners };
        self.elements.add_piece(piece, |message, remedy| self.words.refused(begin, message, remedy))
    }

    /// Adds elements to the group of a dimension and number; those of points have none.
    fn add_to_group(&mut self, dimension: i64, group: u64, own: &[Range<usize>]) {
        let name = self.names.get(&(dimension, group)).cloned().unwrap_or_else(|| group.to_string());
        let groups = match dimension {
            1 => &mut self.elements.curves,
            2 => &mut self.elements.surfaces,
            _ => return,
        };
        groups.entry(name).or_default().extend_from_slice(own);
    }
}

/// Dimension of elements of so many corners.
fn dimension_of(corners: usize) -> i64 {
    match corners {
        1 => 0,
        2 => 1,
        _ => 2,
    }
}
