//! Input decks of CalculiX and Abaqus: their nodes, plane elements, sets and surfaces (Abaqus keywords; CalculiX
//! manual, "Input deck format"). What else stands in a deck is passed over.
//!
//! Names are as they are written first, whatever their case is later. Node and element sets, and surfaces, name sides
//! of cells; element sets name bodies, and `Eall` has all elements. What belongs to an instance of a part is called
//! `INSTANCE.NAME`, and `NAME` too where there is one instance. Nothing is taken from other files, and nothing
//! generated.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

use crate::case::file::source::Source;
use crate::error::Error;

use super::elements::{Elements, INSTANCE, KINDS, OPTIONS, PLANE, Piece, add_to, is_off, number};
use super::words::shown;

/// What plane elements are called before the number of their nodes: plane stress and strain, flat shells and membranes,
/// as which pre-processors write them, and sections of bodies of revolution.
const CELLS: [&str; 9] = ["CPS", "CPE", "CPEG", "S", "STRI", "M3D", "R3D", "DC2D", OF_REVOLUTION];
/// What elements of bodies of revolution are called.
const OF_REVOLUTION: &str = "CAX";
/// As what meshio writes every 4-node quadrilateral.
const OF_MESHIO: &str = "CAX4P";
/// What the names of elements that are no cells begin with: lines, and what joins nodes.
const NO_CELLS: [&str; 15] = [
    "T2D", "T3D", "B2", "B3", "R2D", "GAP", "SPRING", "DASHPOT", "MASS", "ROTARY", "CONN", "DCOUP", "RB", "SFM", "COH",
];
/// What the names of shells and membranes begin with: S1 and S2 are their faces, and their edges are E1 to E4, or S3 to
/// S6 in CalculiX.
const SHELLS: [&str; 3] = ["S", "M3D", "R3D"];
/// What makes nodes and elements that no line lists, moves them, or puts numbers into their lines.
const GENERATED: [&str; 9] =
    ["NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "IMPERFECTION", "PARAMETER"];
/// What is read, each after what it may name, whatever stands first in the deck.
const READ: [&[&str]; 4] = [&["NODE"], &["ELEMENT"], &["NSET", "ELSET"], &["SURFACE"]];
/// What else counts.
const AROUND: [&str; 5] = ["PART", "END PART", "INSTANCE", "END INSTANCE", "INCLUDE"];
/// Most members of all sets and surfaces together, each as often as it is named.
const MOST_MEMBERS: usize = 10_000_000;
/// Most instances of parts.
const MOST_INSTANCES: usize = 100;
/// How groups are made.
const MADE: &str = "give the cells a set (ELSET) and their sides surfaces or sets (*SURFACE, *NSET)";
/// What to do about a deck that is more than a list.
const LISTED: &str = "write the mesh as one list of nodes and elements, such as Gmsh saves as .inp (Mesh.Format = 39)";
/// What to do about a line that is not understood.
const AGAIN: &str = "write the deck again: numbers and names are separated by commas";

/// A keyword, what it is given, and the lines below it.
struct Block<'a> {
    source: Source<'a>,
    keyword: &'static str,
    /// Names of the part and of the instance within which it stands; empty outside.
    within: [&'a str; 2],
    /// Names in capitals, and values.
    parameters: Vec<(String, &'a str)>,
    /// Of the keyword with its parameters.
    place: Range<usize>,
    /// Of the lines below.
    data: Range<usize>,
}

/// A word of a line of data, and its place.
type Word<'a> = (&'a str, Range<usize>);

/// The lines of a part of a text that are no comments, with their places.
fn lines<'a>(source: Source<'a>, part: Range<usize>) -> impl Iterator<Item = Word<'a>> {
    let mut at = part.start;
    let lines = source.text[part].split_inclusive('\n').map(move |line| {
        at += line.len();
        let begin = at - line.len();
        (line.trim_end(), begin..begin + line.trim_end().len())
    });
    lines.filter(|(line, _)| !line.trim_start().starts_with("**") && !line.is_empty())
}

/// The words between the commas of a line, but for those in quotes; none behind its last word.
fn words((line, place): Word<'_>) -> Vec<Word<'_>> {
    let (mut at, mut is_quoted) = (place.start, false);
    let own = line.trim_end_matches([',', ' ', '\t']).split(|mark| {
        is_quoted ^= mark == '"';
        mark == ',' && !is_quoted
    });
    let word = own.map(|word| {
        let begin = at + (word.len() - word.trim_start().len());
        at += word.len() + 1;
        (unquoted(word), begin..begin + word.trim().len())
    });
    word.collect()
}

/// A name without blanks and quotes around it.
fn unquoted(name: &str) -> &str {
    name.trim().trim_matches('"')
}

impl<'a> Block<'a> {
    /// All blocks of a deck whose keywords count.
    fn all(source: Source<'a>) -> Result<Vec<Self>, Error> {
        let mut blocks: Vec<Self> = Vec::new();
        let (mut any, mut counts, mut within) = (false, false, [""; 2]);
        let mut all = lines(source, 0..source.text.len()).peekable();
        while let Some((line, place)) = all.next() {
            let Some(own) = line.trim_start().strip_prefix('*') else {
                if !any {
                    let message = format!("`{}` stands where a keyword should begin", shown(line.trim()));
                    return Err(source.refused(place, message, LISTED));
                }
                blocks.iter_mut().last().filter(|_| counts).into_iter().for_each(|block| block.data.end = place.end);
                continue;
            };
            any = true;
            let own = own.split(',').next().unwrap_or_default().split_whitespace();
            let known = READ.into_iter().flatten().chain(&GENERATED).chain(&AROUND);
            let is_it = |known: &&&str| {
                let mut own = own.clone();
                known.split(' ').all(|word| own.next().is_some_and(|own| own.eq_ignore_ascii_case(word)))
                    && own.next().is_none()
            };
            let Some(keyword) = known.copied().find(|known| is_it(&known)) else {
                counts = false;
                continue;
            };
            counts = true;
            let mut given = words((line, place.clone()));
            let mut end = place.end;
            let mut goes_on = line.ends_with(',');
            while let Some((more, place)) = all.next_if(|_| goes_on) {
                goes_on = more.ends_with(',');
                end = place.end;
                given.extend(words((more, place)));
            }
            let parameter = |(word, _): Word<'a>| {
                let (name, value) = word.split_once('=').unwrap_or((word, ""));
                (name.trim().to_uppercase(), unquoted(value))
            };
            let parameters = given.into_iter().skip(1).map(parameter).collect();
            let block = Self { source, keyword, within, parameters, place: place.start..end, data: end..end };
            match keyword {
                "PART" | "INSTANCE" => {
                    within[usize::from(keyword == "INSTANCE")] = block.parameter("NAME").unwrap_or_default();
                }
                "END PART" | "END INSTANCE" => within = [""; 2],
                _ => {}
            }
            blocks.push(block);
        }
        Ok(blocks)
    }

    /// What a parameter is given; empty where it is only named.
    fn parameter(&self, name: &str) -> Option<&'a str> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, value)| *value)
    }

    fn refused(&self, message: impl Into<String>, remedy: &str) -> Error {
        self.source.refused(self.place.clone(), format!("*{}: {}", self.keyword, message.into()), remedy)
    }

    /// Something wrong with a line below.
    fn wrong(&self, row: &[Word], message: impl Into<String>, remedy: &str) -> Error {
        let end = row.last().map_or(self.place.end, |(_, place)| place.end);
        let begin = row.first().map_or(end, |(_, place)| place.start);
        self.source.refused(begin..end, message, remedy)
    }

    /// Whether a line below ends in a comma: what it lists goes on in the next one.
    fn goes_on(&self, row: &[Word]) -> bool {
        row.last()
            .is_some_and(|(_, place)| self.source.text[place.end..].trim_start_matches([' ', '\t']).starts_with(','))
    }

    /// The words of each line below.
    fn rows(&self) -> impl Iterator<Item = Vec<Word<'a>>> {
        lines(self.source, self.data.clone()).map(words)
    }

    /// A word as a number.
    fn number<T: std::str::FromStr>(&self, (word, place): &Word, what: &str) -> Result<T, Error> {
        // Exponents may begin with the D of Fortran.
        let read = word.parse().or_else(|_| word.replace(['D', 'd'], "E").parse());
        read.map_err(|_| self.source.refused(place.clone(), format!("`{}` is not {what}", shown(word)), AGAIN))
    }

    /// A word as a coordinate, 0 where it is blank.
    fn coordinate(&self, word: &Word) -> Result<f64, Error> {
        if word.0.is_empty() { Ok(0.0) } else { self.number(word, "a coordinate") }
    }

    /// The number of a node or element.
    fn tag(&self, word: &Word, what: &str) -> Result<u64, Error> {
        let tag: u64 = self.number(word, what)?;
        let refused = || self.source.refused(word.1.clone(), format!("`{tag}` is not {what}: it is too large"), AGAIN);
        if tag < INSTANCE { Ok(tag) } else { Err(refused()) }
    }
}

/// Where an instance lies: its part is moved, then turned about a point.
#[derive(Clone, Copy)]
struct Placement {
    by: [f64; 3],
    about: [f64; 2],
    /// Cosine and sine.
    turn: [f64; 2],
}

impl Placement {
    /// As the lines below *INSTANCE say: a translation; two points of an axis and an angle in degrees.
    fn of(block: &Block) -> Result<Self, Error> {
        let mut rows = [[0.0; 7]; 2];
        for (row, values) in block.rows().zip(&mut rows) {
            for (word, value) in row.iter().zip(values) {
                *value = block.coordinate(word)?;
            }
        }
        let [[x, y, z, ..], [x0, y0, z0, x1, y1, z1, angle]] = rows;
        let is_upright = (x1 - x0).abs().max((y1 - y0).abs()) <= 1e-9 * (z1 - z0).abs() && z1 != z0;
        if angle != 0.0 && !is_upright {
            return Err(block.refused("the instance is turned about an axis that is not along z", PLANE));
        }
        let (sine, cosine) = (angle.to_radians() * (z1 - z0).signum()).sin_cos();
        Ok(Self { by: [x, y, z], about: [x0, y0], turn: [cosine, sine] })
    }

    fn of_point(&self, at: [f64; 3]) -> [f64; 3] {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|k| at[k] + self.by[k]);
        let ([x0, y0], [cosine, sine]) = (self.about, self.turn);
        if sine == 0.0 && cosine == 1.0 {
            return [x, y, z];
        }
        [x0 + cosine * (x - x0) - sine * (y - y0), y0 + sine * (x - x0) + cosine * (y - y0), z]
    }
}

/// Sets by their instance, 0 of none, and their names in capitals: the name as it was written first, and the members.
#[derive(Default)]
struct Sets(BTreeMap<(usize, String), (String, BTreeSet<u64>)>);

impl Sets {
    fn of(&mut self, instance: usize, name: &str) -> &mut BTreeSet<u64> {
        let own = self.0.entry((instance, name.to_uppercase()));
        &mut own.or_insert_with(|| (name.to_owned(), BTreeSet::new())).1
    }
}

/// What a deck is read into.
#[derive(Default)]
struct Deck {
    elements: Elements,
    /// Names of the instances.
    instances: Vec<String>,
    /// Which of them is read, from 1; 0 outside.
    instance: usize,
    /// Where that lies.
    placed: Option<Placement>,
    /// Index of each element by its number.
    index: BTreeMap<u64, usize>,
    /// Numbers of shells and membranes.
    shells: BTreeSet<u64>,
    node_sets: Sets,
    node_surfaces: Sets,
    element_sets: Sets,
    members: usize,
}

/// Reads a deck; what is wrong is told with its line.
pub fn parse(file: &Path, bytes: &[u8]) -> Result<Elements, Error> {
    let text = String::from_utf8_lossy(bytes);
    let source = Source { file, text: &text };
    let blocks = Block::all(source)?;
    refuse_generated(&blocks)?;
    let called = ["element set", "surface or set"];
    let mut deck = Deck { elements: Elements { called, made: MADE, ..Elements::default() }, ..Deck::default() };
    let instances: Vec<&Block> = blocks.iter().filter(|block| block.keyword == "INSTANCE").collect();
    deck.instances = instances.iter().map(|block| block.parameter("NAME").unwrap_or_default().to_owned()).collect();
    for (k, instance) in instances.iter().enumerate() {
        let names = ["PART", "NAME"].map(|key| instance.parameter(key).unwrap_or_default());
        let is_part = |block: &&Block| {
            block.keyword == "PART" && block.parameter("NAME").is_some_and(|name| name.eq_ignore_ascii_case(names[0]))
        };
        if !blocks.iter().any(|block| is_part(&block)) {
            return Err(instance.refused(format!("there is no part `{}`", shown(names[0])), LISTED));
        }
        if k == MOST_INSTANCES || deck.elements.nodes.len() + deck.elements.pieces.len() > MOST_MEMBERS {
            return Err(instance.refused("there are too many instances", "leave out those that are not needed"));
        }
        deck.instance = k + 1;
        deck.placed = Some(Placement::of(instance)?);
        deck.read(&blocks, |block| {
            block.within.iter().zip(names).any(|(own, name)| !own.is_empty() && own.eq_ignore_ascii_case(name))
        })?;
        if instances.len() > 1 {
            let own = deck.index.range((k as u64 + 1) * INSTANCE..(k as u64 + 2) * INSTANCE);
            let own: Vec<u64> = own.map(|(tag, _)| *tag).collect();
            deck.element_sets.of(k + 1, "Eall").extend(own);
        }
    }
    (deck.instance, deck.placed) = (0, None);
    // The nodes of an assembly are counted anew: reference points, of which no cell is made.
    let placed = blocks.iter().find(|block| block.keyword == "END INSTANCE");
    let placed = placed.map_or(usize::MAX, |block| block.place.start);
    deck.read(&blocks, |block| {
        let is_of_assembly = block.place.start > placed && ["NODE", "ELEMENT"].contains(&block.keyword);
        (instances.is_empty() || block.within == [""; 2]) && !is_of_assembly
    })?;
    if deck.elements.nodes.is_empty() {
        let end = text.len();
        return Err(source.refused(end..end, "there are no nodes (*NODE)", LISTED));
    }
    Ok(deck.into_elements())
}

/// Refuses what no line lists.
fn refuse_generated(blocks: &[Block]) -> Result<(), Error> {
    for block in blocks {
        if block.keyword == "INCLUDE" || block.keyword == "INSTANCE" && block.parameter("LIBRARY").is_some() {
            return Err(block.refused("other files are not read", "put the lines of that file here"));
        }
        if block.keyword == "PARAMETER" {
            return Err(block.refused("its values stand in other lines by their names", "write the numbers there"));
        }
        if GENERATED.contains(&block.keyword) {
            return Err(block.refused("nodes or elements are generated or moved", LISTED));
        }
    }
    Ok(())
}

impl Deck {
    /// Reads some of the blocks. Sets may stand before what they name, and name one another only afterwards.
    fn read(&mut self, blocks: &[Block], is_own: impl Fn(&Block) -> bool) -> Result<(), Error> {
        for keywords in READ {
            for block in blocks.iter().filter(|block| keywords.contains(&block.keyword) && is_own(block)) {
                if block.parameter("INPUT").is_some() {
                    return Err(block.refused("its lines are in another file", "put them below the keyword"));
                }
                match keywords[0] {
                    "NODE" => self.read_nodes(block)?,
                    "ELEMENT" => self.read_elements(block)?,
                    "SURFACE" => self.read_surface(block)?,
                    _ => self.read_set(block)?,
                }
            }
        }
        Ok(())
    }

    /// What the numbers of the instance that is read begin behind.
    fn behind(&self, instance: usize) -> u64 {
        instance as u64 * INSTANCE
    }

    /// The instance that a word is of, and the word in it: the one before its point, that of its keyword, or the one
    /// that is read.
    fn within<'w>(&self, block: &Block, word: &'w str) -> Result<(usize, &'w str), Error> {
        let of = |name: &str| self.instances.iter().position(|known| known.eq_ignore_ascii_case(name)).map(|k| k + 1);
        if let Some((Some(instance), own)) = word.split_once('.').map(|(name, own)| (of(unquoted(name)), own)) {
            return Ok((instance, unquoted(own)));
        }
        let Some(name) = block.parameter("INSTANCE") else { return Ok((self.instance, word)) };
        let refused = || block.refused(format!("there is no instance `{}`", shown(name)), "name one of *INSTANCE");
        Ok((of(name).ok_or_else(refused)?, word))
    }

    fn read_nodes(&mut self, block: &Block) -> Result<(), Error> {
        if block.parameter("SYSTEM").is_some_and(|system| !system.eq_ignore_ascii_case("R")) {
            return Err(block.refused("its coordinates are not rectangular", LISTED));
        }
        for row in block.rows() {
            let refused = |message: String, remedy: &str| block.wrong(&row, message, remedy);
            let tag = self.behind(self.instance) + block.tag(&row[0], "the number of a node")?;
            let mut at = [0.0; 3];
            // What is blank is 0.
            if row.len() < 3 && !block.goes_on(&row) {
                return Err(refused(format!("node {} has no x and y", number(tag)), AGAIN));
            }
            for (x, word) in at.iter_mut().zip(&row[1..]) {
                *x = block.coordinate(word)?;
            }
            self.elements.count_digits(at);
            let mut at = self.placed.map_or(at, |placed| placed.of_point(at));
            if is_off(at) {
                self.elements.off.insert(tag, std::mem::take(&mut at[2]));
            }
            self.elements.add_node(tag, at, refused)?;
            if let Some(set) = block.parameter("NSET") {
                self.node_sets.of(self.instance, set).insert(tag);
            }
        }
        Ok(())
    }

    fn read_elements(&mut self, block: &Block) -> Result<(), Error> {
        let kind = block.parameter("TYPE").ok_or_else(|| block.refused("it has no TYPE", AGAIN))?;
        let cell = kind_of(block, kind)?;
        let upper = kind.to_uppercase();
        if upper.starts_with(OF_REVOLUTION) && upper != OF_MESHIO {
            let message = format!("elements of type {} are of bodies of revolution", shown(kind));
            let remedy =
                "the scene is in plane strain or plane stress: give CPE or CPS elements, or `plane = \"axisymmetric\"`";
            self.elements.of_revolution.get_or_insert_with(|| block.refused(message, remedy));
        }
        let mut rows = block.rows();
        while let Some(mut row) = rows.next() {
            // The codes differ in the nodes of what is no cell, of which each has a line of the deck.
            let (count, corners) = cell.unwrap_or((row.len() - 1, 2));
            if count == 1 {
                continue;
            }
            while row.len() <= count && block.goes_on(&row) {
                let Some(more) = rows.next() else { break };
                row.extend(more);
            }
            let refused = |message: String, remedy: &str| block.wrong(&row, message, remedy);
            let behind = self.behind(self.instance);
            let tag = block.tag(&row[0], "the number of an element")?;
            if row.len() != count + 1 {
                let message = format!("element {tag} has {} nodes, and {kind} has {count}", row.len() - 1);
                let remedy = "the deck is cut, the TYPE is another one, or a line that goes on does not end in a comma";
                return Err(refused(message, remedy));
            }
            let nodes = row[1..].iter().map(|word| Ok(behind + block.tag(word, "the number of a node")?));
            let nodes = nodes.collect::<Result<Vec<u64>, Error>>()?;
            let index = self.elements.add_piece(Piece { tag, nodes, corners }, refused)?;
            if self.index.insert(behind + tag, index).is_some() {
                return Err(refused(format!("element {tag} stands twice"), AGAIN));
            }
            if cell.is_some() && SHELLS.iter().any(|name| upper.starts_with(name)) {
                self.shells.insert(behind + tag);
            }
            if let Some(set) = block.parameter("ELSET") {
                self.element_sets.of(self.instance, set).insert(behind + tag);
            }
        }
        Ok(())
    }

    fn read_set(&mut self, block: &Block) -> Result<(), Error> {
        let of_nodes = block.keyword == "NSET";
        let name = block.parameter(block.keyword).filter(|name| !name.is_empty());
        let name = name.ok_or_else(|| block.refused(format!("it has no {} = NAME", block.keyword), AGAIN))?;
        let mut found = BTreeSet::new();
        if let Some(elements) = block.parameter("ELSET").filter(|_| of_nodes) {
            let own = self.named(block, &(elements, block.place.clone()), false)?;
            found.extend(own.iter().flat_map(|tag| &self.elements.pieces[self.index[tag]].nodes));
        }
        for row in block.rows() {
            if block.parameter("GENERATE").is_some() {
                found.extend(self.generated(block, &row, of_nodes)?);
            } else {
                for word in &row {
                    found.extend(self.named(block, word, of_nodes)?);
                }
            }
        }
        self.counted(block, found.len())?;
        let sets = if of_nodes { &mut self.node_sets } else { &mut self.element_sets };
        sets.of(self.instance, name).extend(found);
        Ok(())
    }

    /// The nodes or elements from one number to another, in steps.
    fn generated(&mut self, block: &Block, row: &[Word], of_nodes: bool) -> Result<Vec<u64>, Error> {
        let numbers = row.iter().map(|word| block.number(word, "a number"));
        let numbers = numbers.collect::<Result<Vec<u64>, Error>>()?;
        let (from, to, step) = match numbers[..] {
            [from, to] if from <= to => (from, to, 1),
            [from, to, step] if from <= to && step > 0 => (from, to, step),
            _ => {
                return Err(block.wrong(row, "this is not `first, last, step` with first up to last", AGAIN));
            }
        };
        let behind = self.behind(self.within(block, "")?.0);
        let range = [from, to].map(|end| behind + end.min(INSTANCE - 1));
        let in_step = |tag: &u64| (tag - range[0]).is_multiple_of(step);
        let within: Vec<u64> = match of_nodes {
            true => self.elements.nodes.range(range[0]..=range[1]).map(|(tag, _)| *tag).collect(),
            false => self.index.range(range[0]..=range[1]).map(|(tag, _)| *tag).collect(),
        };
        self.counted(block, within.len())?;
        Ok(within.into_iter().filter(in_step).collect())
    }

    /// The node or element of a number, or those of another set.
    fn named(&mut self, block: &Block, (word, place): &Word, of_nodes: bool) -> Result<Vec<u64>, Error> {
        let what = if of_nodes { "node" } else { "element" };
        let is_there =
            |tag: &u64| if of_nodes { self.elements.nodes.contains_key(tag) } else { self.index.contains_key(tag) };
        let sets = if of_nodes { &self.node_sets } else { &self.element_sets };
        let (instance, own) = self.within(block, word)?;
        let behind = self.behind(instance);
        let of = |instance: usize| sets.0.get(&(instance, own.to_uppercase()));
        let found = match own.parse::<u64>() {
            Ok(tag) if tag < INSTANCE && is_there(&(behind + tag)) => Some(vec![behind + tag]),
            // Both codes pass over what a set lists and the deck does not have; meshio lists -1.
            _ if own.parse::<i64>().is_ok() => (block.keyword != "SURFACE").then(Vec::new),
            _ => of(instance).or_else(|| of(0)).map(|(_, own)| own.iter().copied().collect()),
        };
        let refused = || {
            let message = format!("there is no {what} or set of {what}s `{}`", shown(word));
            block.source.refused(place.clone(), message, "name what the deck has, sets behind those that they name")
        };
        let found: Vec<u64> = found.ok_or_else(refused)?;
        self.counted(block, found.len())?;
        Ok(found)
    }

    /// Counts members; sets of sets would take memory by the product of their numbers.
    fn counted(&mut self, block: &Block, members: usize) -> Result<(), Error> {
        self.members += members;
        if self.members > MOST_MEMBERS {
            let message = format!("its sets and surfaces have more than {MOST_MEMBERS} members");
            return Err(block.refused(message, "leave out sets that are not needed"));
        }
        Ok(())
    }

    fn read_surface(&mut self, block: &Block) -> Result<(), Error> {
        let name = block.parameter("NAME").filter(|name| !name.is_empty());
        let name = name.ok_or_else(|| block.refused("it has no NAME", AGAIN))?;
        let kind = block.parameter("TYPE").unwrap_or("ELEMENT").to_uppercase();
        let of_nodes = kind == "NODE";
        // Rigid lines, and surfaces made of others, are no sides of cells.
        if !of_nodes && kind != "ELEMENT" || block.parameter("COMBINE").is_some() {
            return Ok(());
        }
        for row in block.rows() {
            let is_face = row.last().is_some_and(|(word, _)| ["SPOS", "SNEG"].contains(&word.to_uppercase().as_str()));
            let own = self.named(block, &row[0], of_nodes)?;
            if of_nodes {
                self.node_surfaces.of(self.instance, name).extend(own);
                continue;
            }
            for tag in own {
                let piece = &self.elements.pieces[self.index[&tag]];
                // Nor are the faces of a shell.
                if piece.corners > 2 && is_face {
                    continue;
                }
                let index = if piece.corners == 2 { self.index[&tag] } else { self.add_side(block, tag, &row)? };
                add_to(self.elements.curves.entry(self.full(self.instance, name)).or_default(), index);
            }
        }
        Ok(())
    }

    /// A side of a cell as a line; its index. S1 is that from the first to the second corner, of a shell E1 or S3.
    fn add_side(&mut self, block: &Block, tag: u64, row: &[Word]) -> Result<usize, Error> {
        let Piece { nodes, corners, .. } = &self.elements.pieces[self.index[&tag]];
        let Some((word, place)) = row.get(1) else {
            let message = format!(
                "`{}` has no side behind it: Abaqus takes its free sides, which are not looked for",
                shown(row[0].0)
            );
            return Err(block.wrong(row, message, "name a side of S1 to S4 behind the element or set"));
        };
        let is_shell = self.shells.contains(&tag);
        let names = |k: usize| {
            if is_shell {
                [format!("E{}", k + 1), format!("S{}", k + 3)]
            } else {
                [format!("S{}", k + 1), String::new()]
            }
        };
        let side = (0..*corners).find(|k| names(*k).iter().any(|name| word.eq_ignore_ascii_case(name)));
        let Some(k) = side else {
            let message = format!("`{}` is no side of element {}", shown(word), number(tag));
            return Err(block.source.refused(
                place.clone(),
                message,
                if is_shell {
                    "name an edge of E1 to E4, or of S3 to S6 as CalculiX has them, behind the element or set"
                } else {
                    "name a side of S1 to S4 behind the element or set"
                },
            ));
        };
        let nodes = vec![nodes[k], nodes[(k + 1) % corners]];
        self.elements.pieces.push(Piece { tag: number(tag), nodes, corners: 2 });
        Ok(self.elements.pieces.len() - 1)
    }

    /// The name of what belongs to an instance.
    fn full(&self, instance: usize, name: &str) -> String {
        match instance.checked_sub(1) {
            Some(k) => format!("{}.{name}", self.instances[k]),
            None => name.to_owned(),
        }
    }

    /// Sets and surfaces as groups; a surface goes before a set of its name.
    fn into_elements(mut self) -> Elements {
        let mut elements = std::mem::take(&mut self.elements);
        let all =
            self.index.iter().filter(|(_, index)| elements.pieces[**index].corners > 2).map(|(tag, _)| *tag).collect();
        self.element_sets.0.entry((0, "EALL".into())).or_insert_with(|| ("Eall".into(), all));
        for ((instance, _), (name, own)) in &self.element_sets.0 {
            let name = self.full(*instance, name);
            let (mut cells, mut lines) = (Vec::new(), Vec::new());
            for tag in own {
                let index = self.index[tag];
                add_to(if elements.pieces[index].corners > 2 { &mut cells } else { &mut lines }, index);
            }
            if !lines.is_empty() {
                elements.curves.entry(name.clone()).or_insert(lines);
            }
            if !cells.is_empty() {
                elements.surfaces.insert(name, cells);
            }
        }
        let mut sets = std::mem::take(&mut self.node_sets.0);
        sets.append(&mut self.node_surfaces.0);
        let set = |((instance, _), (name, own)): ((usize, String), (String, BTreeSet<u64>))| {
            (self.full(instance, &name), own.into_iter().collect())
        };
        elements.sets = sets.into_iter().map(set).collect();
        if let [only] = &self.instances[..] {
            let before = format!("{only}.");
            [&mut elements.surfaces, &mut elements.curves].into_iter().for_each(|groups| plainly(groups, &before));
            plainly(&mut elements.sets, &before);
        }
        elements
    }
}

/// Adds groups by what stands behind the name of their instance, where no other is called so.
fn plainly<T: Clone>(groups: &mut BTreeMap<String, T>, before: &str) {
    for (name, own) in groups.clone() {
        if let Some(plain) = name.strip_prefix(before) {
            groups.entry(plain.to_owned()).or_insert(own);
        }
    }
}

/// Nodes and corners of the cells of a type: `CPS8R` has 8 nodes and 4 corners; none of lines.
fn kind_of(block: &Block, kind: &str) -> Result<Option<(usize, usize)>, Error> {
    let upper = kind.to_uppercase();
    let refused =
        |what: &str, remedy: &str| Err(block.refused(format!("elements of type {} {what}", shown(kind)), remedy));
    let begins = |names: &[&str]| names.iter().any(|name| upper.starts_with(name));
    if begins(&["C3D", "SC"]) {
        return refused("are solids", PLANE);
    }
    if begins(&NO_CELLS) {
        return Ok(None);
    }
    // Of names that begin another one the longest counts.
    let rests = CELLS.iter().filter_map(|name| upper.strip_prefix(name));
    let rest = rests.min_by_key(|rest| rest.len()).unwrap_or_default();
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let nodes: usize = rest[..digits].parse().unwrap_or_default();
    match KINDS.iter().find(|(_, count, corners)| *count == nodes && *corners > 2) {
        Some(&(_, count, corners)) => Ok(Some((count, corners))),
        None => refused("are not read", OPTIONS),
    }
}
