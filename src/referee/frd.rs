//! Answers of CalculiX as fields (`.frd`): pressures and gaps of any deck with contact pairs, displacements of all; of
//! plane cells, or of the slice into which CalculiX expands them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::error::Error;
use crate::referee::answer::{Answer, Point, contact_named, without_gaps};
use crate::referee::asked::Asked;
use crate::referee::calculix::AGAIN;
use crate::referee::field::Field;
use crate::referee::profile::handed;
use crate::referee::side::{Cell, Side, signed_coordinate};
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::units::Role;
use crate::scene::Scene;

/// How contact results are written.
const CONTACT: &str =
    "write `*CONTACT FILE` with CDIS and CSTR in the step, and run ccx again; of an exported deck hand in the .dat";
/// How they are written such that their nodes are there.
const EXPANDED: &str = "write *CONTACT FILE and *NODE FILE with OUTPUT=3D, so that the file has the nodes into which \
    ccx expands plane elements and those of the contact are among them; or hand in a .csv of positions and nodal \
    forces";
/// How they are written where the file has the expanded nodes, and those of the contact are of the plane, as of a
/// surface of nodes.
const IN_PLANE: &str = "leave OUTPUT=3D out, so that the file has the nodes of the plane elements, by which the \
    contact names its own; or hand in a .csv of positions and nodal forces";
/// What to do about a node with two kinds of numbers.
const TWICE: &str = "keep one line a node, that of the side and state which are judged, or run ccx again";
/// What to do where they are there, and have no values.
const BETWEEN: &str =
    "hand in values at every node up to where nothing presses, as `*CONTACT PAIR, TYPE=SURFACE TO SURFACE` has them";

/// Pressures and gaps of the contact block of the state that is asked for, or of the last one.
pub fn parse(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let source = Source { file, text };
    let contact = contact_named(scene, asked.contact.as_deref(), |message, remedy| source.refused(message, remedy))?;
    let length = source.factor(Role::Position, "the place of a node", None, asked.unit(Role::Position))?;
    let stress = source.factor(Role::Pressure, "the pressure", None, asked.unit(Role::Pressure))?;
    let gaps = source.factor(Role::Gap, "the gap", None, asked.unit(Role::Gap).or(asked.unit(Role::Position)))?;
    let heads = heads(&source);
    let own: Vec<&Head> = heads.iter().filter(|head| head.name == "CONTACT").collect();
    if own.is_empty() {
        return Err(source.refused("it has no contact block", CONTACT));
    }
    let states: Vec<State> = own.iter().map(|head| head.state).collect();
    let head = own[State::chosen(&source, &states, asked)?];
    let block = block(&source, head)?;
    let column = |role: Role, usual: &str| {
        let name = asked.column(role).unwrap_or(usual).to_owned();
        (block.components.iter().position(|known| *known == name), name)
    };
    let (Some(pressure), name) = column(Role::Pressure, "CPRESS") else {
        let name = asked.column(Role::Pressure).unwrap_or("CPRESS");
        let message = format!("its contact block has no component {name} but {}", block.components.join(", "));
        let remedy = "write *CONTACT FILE with CSTR, or name the component by --column pressure=NAME";
        return Err(source.refused(message, remedy));
    };
    let (gap, _) = column(Role::Gap, "COPEN");
    let plane = Plane::of(&source, scene)?;
    let rows = plane.rows(&block);
    let is_strange = |number: &usize| !plane.all.contains_key(number);
    let strange: Vec<f64> =
        block.rows.iter().filter(|(number, _)| is_strange(number)).map(|(_, values)| values[pressure]).collect();
    let lost = strange.iter().filter(|pressure| pressure.abs() > 0.0).count();
    one_pressure(&source, &block, &rows, pressure)?;
    let values = means(&rows);
    let pair = &scene.contacts[contact];
    let places: Vec<[f64; 2]> = plane.places.iter().map(|place| place.map(|x| length * x)).collect();
    let value = |node: usize| values[node].as_ref().map(|values| asked.sign() * stress * values[pressure]);
    let (side, other) = Side::of(&source, (scene, contact), &places, &plane.cells, value)?;
    let nodes = side.nodes();
    let point = |&node: &usize| {
        let position = signed_coordinate(pair, places[node]);
        let gap = gap.zip(values[node].as_ref()).map(|(gap, values)| gaps * values[gap]);
        (position, value(node).map(|value| Point { position, value, area: None, gap }))
    };
    let (points, lacking) = without_gaps(nodes.iter().map(point).collect());
    if lacking + lost > 0 {
        let message = format!(
            "its contact block has values at {} nodes, {} of which the file does not have, {lost} of them under \
            pressure; {lacking} of the {} nodes of contact `{}` have none, and none is no zero",
            block.rows.len(),
            strange.len(),
            nodes.len(),
            pair.name
        );
        let remedy = match (strange.len(), plane.is_slice) {
            (0, _) => BETWEEN,
            (_, true) => IN_PLANE,
            (_, false) => EXPANDED,
        };
        return Err(source.refused(message, remedy));
    }
    side.all_pressed(&source, (pair, scene.plane.radial()), &places, |node, _| value(node))?;
    let order = asked.order.unwrap_or(side.order());
    let refused = |message, remedy: &str| source.refused(format!("contact block: {message}"), remedy);
    let contacts = vec![handed((scene, contact), points, Some(order), false, refused)?];
    let mut read = vec![format!("{name} as pressure")];
    read.extend(other);
    read.extend(gap.map(|gap| format!("{} as gap", block.components[gap])));
    read.extend(heads.iter().map(|head| format!("block {} of {}", head.name, head.state)));
    read.push(format!("the contact block of {} is judged", head.state));
    let all: Vec<State> = heads.iter().map(|head| head.state).collect();
    let field = displacements((&source, scene), asked, (None, &BTreeMap::new()), Some(head.state))?;
    let code = Some("CalculiX".into());
    let (mut notes, units) = (head.state.notes(&all), asked.units());
    let without =
        format!("the file does not have {} nodes of its contact block, at which nothing presses", strange.len());
    notes.extend((!strange.is_empty()).then_some(without));
    Ok(Answer { file: file.into(), code, read, notes, units, contacts, field })
}

/// The displacements of a file, of a state where one is given; none where it has none, or their unit is not known.
/// `ours` is the unit of our own decks. Places of nodes are those of a deck where it has them: a file has six digits,
/// by which a thin ring of 1 m loses its shape.
pub fn displacements(
    (source, scene): (&Source, &Scene),
    asked: &Asked,
    (ours, deck): (Option<&str>, &BTreeMap<usize, [f64; 2]>),
    state: Option<State>,
) -> Result<Option<Field>, Error> {
    let named = asked.unit(Role::Displacement);
    let heads = heads(source);
    let is_it = |head: &&Head| {
        // The state of a .dat tells its time alone.
        let is_of =
            |state: State| head.state.is_at(state.time) && state.step.is_none_or(|own| head.state.step == Some(own));
        head.name == "DISP" && state.is_none_or(is_of)
    };
    let Some(head) = heads.iter().rfind(is_it).filter(|_| ours.or(named).is_some()) else { return Ok(None) };
    let length = source.factor(Role::Position, "the place of a node", ours, asked.unit(Role::Position))?;
    let moved = source.factor(Role::Displacement, "the displacement", ours, named)?;
    let (mut block, mut plane) = (block(source, head)?, Plane::of(source, scene)?);
    block.rows.iter_mut().for_each(|(number, values)| plane.turn(*number, values));
    if let Some(number) = plane.all.keys().find(|number| !block.rows.contains_key(number)) {
        return Err(source.refused(format!("its block of displacements has no node {number}"), AGAIN));
    }
    let whole = plane.part_along_radius(scene).into_iter().map(|part| moved / part);
    let vector = |(values, whole): (&Option<Vec<f64>>, f64)| match values.as_deref() {
        Some([u, v, ..]) => Ok([whole * u, moved * v]),
        _ => Err(source.refused("its block of displacements has no two components at every node", AGAIN)),
    };
    let displacement = means(&plane.rows(&block)).iter().zip(whole).map(vector).collect::<Result<_, Error>>()?;
    for (number, place) in deck {
        let Some(own) = plane.of.get(number).map(|&node| &mut plane.places[node]) else { continue };
        let size = place[0].abs().max(place[1].abs());
        if (own[0] - place[0]).abs().max((own[1] - place[1]).abs()) <= SAME_RADIUS * size {
            *own = *place;
        }
    }
    Ok(Some(Field {
        displacement,
        points: plane.places.iter().map(|place| place.map(|x| length * x)).collect(),
        cells: plane.cells,
    }))
}

/// Where a block of results begins, and what it is of.
struct Head<'a> {
    name: &'a str,
    state: State,
    /// The text behind its first line.
    rest: &'a str,
}

/// All blocks of results.
fn heads<'a>(source: &Source<'a>) -> Vec<Head<'a>> {
    let (mut state, mut heads, mut at) = (State::default(), Vec::new(), 0);
    for line in source.text.split_inclusive('\n') {
        at += line.len();
        let words = || line.split_whitespace();
        if line.starts_with("    1PSTEP") {
            // Number of the block of states, increment and step.
            let numbers: Vec<usize> = words().skip(1).filter_map(|word| word.parse().ok()).collect();
            state.step = if let [_, increment, step] = numbers[..] { Some([step, increment]) } else { None };
        } else if line.starts_with("  100C") {
            let time = line.get(12..24).and_then(|word| word.trim().parse().ok());
            state.time = time.or(words().nth(2).and_then(|word| word.parse().ok())).unwrap_or(f64::NAN);
        } else if line.starts_with(" -4") {
            heads.extend(words().nth(1).map(|name| Head { name, state, rest: &source.text[at..] }));
        }
    }
    heads
}

/// A block of results: names of components, and their values a node.
struct Block {
    components: Vec<String>,
    rows: BTreeMap<usize, Vec<f64>>,
}

/// The rows of a block.
fn block(source: &Source, head: &Head) -> Result<Block, Error> {
    let mut lines = head.rest.lines().peekable();
    let mut components = Vec::new();
    while let Some(line) = lines.next_if(|line| line.starts_with(" -5")) {
        // What a viewer is to compute from the others is listed too.
        components.extend(line.split_whitespace().nth(1).filter(|name| *name != "ALL").map(str::to_owned));
    }
    let mut rows: Vec<(usize, &str, Vec<f64>)> = Vec::new();
    for line in lines {
        if line.starts_with(" -3") {
            if let Some((_, line, values)) = rows.iter().find(|(.., values)| values.len() != components.len()) {
                return Err(wrong(source, line, &format!("{} of {} components", values.len(), components.len())));
            }
            return Ok(Block { components, rows: once(source, head.name, rows)? });
        }
        match (line.strip_prefix(" -2"), rows.last_mut()) {
            // More than six components go on in the next line.
            (Some(more), Some((.., values))) => {
                values.extend(numbers(more).ok_or_else(|| wrong(source, line, more.trim()))?);
            }
            _ => {
                let (node, values) = record(source, line)?;
                rows.push((node, line, values));
            }
        }
    }
    Err(source.refused(format!("its block {} has no end", head.name), AGAIN))
}

/// The numbers of each node; where parts of a mesh meet a node may be written twice, with the same ones.
fn once(source: &Source, block: &str, rows: Vec<(usize, &str, Vec<f64>)>) -> Result<BTreeMap<usize, Vec<f64>>, Error> {
    let mut known = BTreeMap::new();
    for (node, line, values) in rows {
        let before = known.entry(node).or_insert_with(|| values.clone());
        if *before != values {
            let message = format!("its block {block} has other numbers of node {node} before this line");
            return Err(source.at(line, message, TWICE));
        }
    }
    Ok(known)
}

fn wrong(source: &Source, line: &str, what: &str) -> Error {
    source.at(line, format!("this line is cut, or holds no finite numbers: {what}"), AGAIN)
}

/// Number of a node, in ten columns or in five, and the numbers behind it.
fn record(source: &Source, line: &str) -> Result<(usize, Vec<f64>), Error> {
    let split = |at: usize| Some((line.get(3..at)?.trim().parse::<usize>().ok()?, line.get(at..)?));
    let (node, rest) = split(13).or_else(|| split(8)).ok_or_else(|| wrong(source, line, "no number of a node"))?;
    Ok((node, numbers(rest).ok_or_else(|| wrong(source, line, rest.trim()))?))
}

/// Numbers one behind the other, with blanks between or none; none where a word is no row of finite numbers.
fn numbers(text: &str) -> Option<Vec<f64>> {
    let mut all = Vec::new();
    for mut rest in text.split_whitespace() {
        while !rest.is_empty() {
            let (own, behind) = rest.split_at(end_of_number(rest));
            all.push(own.parse().ok().filter(|value: &f64| value.is_finite())?);
            rest = behind;
        }
    }
    Some(all)
}

/// Where the first number ends: its exponent has digits up to the sign of the next one, or to the one digit before the
/// point of the next one.
fn end_of_number(text: &str) -> usize {
    let Some(exponent) = text.find(['E', 'e']) else { return text.len() };
    let rest = &text[exponent + 1..];
    let signed = usize::from(rest.starts_with(['+', '-']));
    let digits = rest[signed..].bytes().take_while(u8::is_ascii_digit).count();
    let end = exponent + 1 + signed + digits;
    if text[end..].starts_with('.') && digits > 1 { end - 1 } else { end }
}

/// A kind of cell: its corners and nodes in the plane, and all it has.
type Kind = (&'static str, usize, usize, usize);

/// Plane cells, and the bricks and wedges into which they are expanded.
const KINDS: [Kind; 8] = [
    ("7", 3, 3, 3),
    ("8", 3, 6, 6),
    ("9", 4, 4, 4),
    ("10", 4, 8, 8),
    ("1", 4, 4, 8),
    ("2", 3, 3, 6),
    ("4", 4, 8, 20),
    ("5", 3, 6, 15),
];
/// Types of lines, as which gap elements are written.
const LINES: [&str; 2] = ["11", "12"];

/// The mesh in the plane: nodes at the same place of the slice are one, those of a sector of bodies of revolution at
/// the same radius.
struct Plane {
    /// All nodes of the file; of a sector turned into the plane.
    all: BTreeMap<usize, [f64; 2]>,
    /// Cosine and sine of the angles by which nodes of a sector were turned.
    turned: BTreeMap<usize, [f64; 2]>,
    /// Nodes of the plane by the number of each node that stands for them.
    of: BTreeMap<usize, usize>,
    /// Their places.
    places: Vec<[f64; 2]>,
    cells: Vec<Cell>,
    /// Whether cells were expanded ones.
    is_slice: bool,
}

impl Plane {
    fn of(source: &Source, scene: &Scene) -> Result<Self, Error> {
        let (mut all, mut turned) = (BTreeMap::new(), BTreeMap::new());
        for (number, [x, y, z]) in nodes(source)? {
            // In the plane ccx leaves z at its round-off.
            let radius = x.hypot(z);
            let is_turned = scene.is_of_revolution() && z.abs() > SAME * radius;
            all.insert(number, [if is_turned { radius } else { x }, y]);
            turned.extend(is_turned.then_some((number, [x / radius, z / radius])));
        }
        let mut plane = Self { all, turned, of: BTreeMap::new(), places: vec![], cells: vec![], is_slice: false };
        let mut lines = source.text.lines().skip_while(|line| !line.starts_with("    3C")).skip(1).peekable();
        while let Some(head) = lines.next_if(|line| line.starts_with(" -1")) {
            let kind = head.split_whitespace().nth(2).unwrap_or_default();
            let mut nodes = Vec::new();
            while let Some(line) = lines.next_if(|line| line.starts_with(" -2")) {
                let node = |word: &str| word.trim().parse().ok().filter(|number| plane.all.contains_key(number));
                // Numbers that fill their columns have no blanks between.
                let columns = |wide: usize| {
                    let ends = (3..line.len()).step_by(wide).map(move |at| [at, line.len().min(at + wide)]);
                    ends.map(|[from, to]| node(line.get(from..to)?)).collect::<Option<Vec<usize>>>()
                };
                let apart = line[3..].split_whitespace().map(node).collect::<Option<Vec<usize>>>();
                let own = apart.or_else(|| columns(10)).or_else(|| columns(5));
                let strange = || source.at(line, "this line names a node that is not there", AGAIN);
                nodes.extend(own.ok_or_else(strange)?);
            }
            if LINES.contains(&kind) {
                continue;
            }
            let Some(kind) = KINDS.iter().find(|(known, ..)| *known == kind) else {
                let remedy = "write *CONTACT FILE and *NODE FILE of plane elements, and run ccx again";
                return Err(source.at(head, "this cell is neither plane nor a slice of plane ones", remedy));
            };
            if nodes.len() != kind.3 {
                return Err(source.at(head, "this cell has not the nodes of its type", AGAIN));
            }
            let sliced = "this cell is not plane: its nodes do not lie in pairs at the same x and y";
            plane.add(kind, &nodes).ok_or_else(|| source.at(head, sliced, "hand in a plane model"))?;
        }
        // Several layers of a slice are the same cells.
        let mut known = BTreeSet::new();
        plane.cells.retain(|cell| {
            let mut nodes = cell.nodes.clone();
            nodes.sort_unstable();
            known.insert(nodes)
        });
        Ok(plane)
    }

    /// Adds a cell; none where nodes of it stand for none of the plane.
    fn add(&mut self, (_, corners, in_plane, all): &Kind, nodes: &[usize]) -> Option<()> {
        // Mid-sides in the plane stand behind all corners.
        let mids = if in_plane < all { 2 * corners } else { *corners };
        let own: Vec<usize> = (0..*corners).chain(mids..mids + in_plane - corners).map(|k| nodes[k]).collect();
        let place = |number: &usize| [self.all[number][0] + 0.0, self.all[number][1] + 0.0];
        let size = own.iter().map(|node| place(node)[0].abs().max(place(node)[1].abs())).fold(0.0, f64::max);
        let same = if self.turned.is_empty() { SAME } else { SAME_RADIUS };
        let near = |a: &usize, b: &usize| {
            let (a, b) = (place(a), place(b));
            (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) <= same * size
        };
        let groups: Vec<Vec<usize>> = own
            .iter()
            .map(|node| {
                nodes.iter().copied().filter(|other| other == node || (in_plane < all && near(node, other))).collect()
            })
            .collect();
        if groups.iter().map(Vec::len).sum::<usize>() != nodes.len() {
            return None;
        }
        let mut found = Vec::new();
        for (group, node) in groups.iter().zip(&own) {
            let known = group.iter().find_map(|number| self.of.get(number).copied());
            let index = known.unwrap_or(self.places.len());
            if known.is_none() {
                self.places.push(place(node));
            }
            found.push(index);
            self.of.extend(group.iter().map(|number| (*number, index)));
        }
        self.cells.push(Cell { nodes: found, corners: *corners });
        self.is_slice |= in_plane < all;
        Some(())
    }

    /// Turns the vector of a node of a sector into the plane, but for what it has across that, which tells nothing.
    fn turn(&self, number: usize, vector: &mut [f64]) {
        if let (Some([cosine, sine]), [u, _, w, ..]) = (self.turned.get(&number), vector) {
            *u = cosine * *u + sine * *w;
        }
    }

    /// Part of what nodes move along the radius that is written of them. Of cells of revolution in the plane it is the
    /// mean along x over the two ends of the sector of 2° into which ccx expands them, by Simpson's rule where there is
    /// a node between, as at corners of 8-node cells. The ripple between both kinds of nodes had 14 % of the strain
    /// energy of a torus of 1 m.
    fn part_along_radius(&self, scene: &Scene) -> Vec<f64> {
        if !scene.is_of_revolution() || !self.turned.is_empty() {
            return vec![1.0; self.places.len()];
        }
        let ends = 1f64.to_radians().cos();
        let mut all = vec![ends; self.places.len()];
        for cell in self.cells.iter().filter(|cell| cell.nodes.len() > cell.corners) {
            cell.nodes[..cell.corners].iter().for_each(|&node| all[node] = (2.0 + ends) / 3.0);
        }
        all
    }

    /// Rows of a block at each node of the plane. Where it names no node of a cell, those at the same place are meant.
    fn rows<'b>(&self, block: &'b Block) -> Vec<Vec<Row<'b>>> {
        let is_direct = block.rows.keys().any(|number| self.of.contains_key(number));
        let key = |x: f64, y: f64| [x + 0.0, y + 0.0].map(f64::to_bits);
        let mut at: BTreeMap<[u64; 2], Vec<usize>> = BTreeMap::new();
        self.places.iter().enumerate().for_each(|(node, [x, y])| at.entry(key(*x, *y)).or_default().push(node));
        let nodes = |number: &usize| match (is_direct, self.all.get(number)) {
            (false, Some([x, y])) => at.get(&key(*x, *y)).cloned().unwrap_or_default(),
            _ => self.of.get(number).copied().into_iter().collect(),
        };
        let mut rows = vec![vec![]; self.places.len()];
        for (number, values) in &block.rows {
            nodes(number).into_iter().for_each(|node| rows[node].push((*number, &values[..])));
        }
        rows
    }
}

/// The number of a node in the file, and its values.
type Row<'b> = (usize, &'b [f64]);

/// Means of the values at each node of the plane, none where it has none.
fn means(rows: &[Vec<Row>]) -> Vec<Option<Vec<f64>>> {
    let mean = |rows: &Vec<Row>| {
        let (_, first) = rows.first()?;
        let sum = |k: usize| rows.iter().map(|(_, values)| values[k]).sum::<f64>();
        Some((0..first.len()).map(|k| sum(k) / rows.len() as f64).collect())
    };
    rows.iter().map(mean).collect()
}

/// Refuses two pressures at a node of the plane.
fn one_pressure(source: &Source, block: &Block, rows: &[Vec<Row>], pressure: usize) -> Result<(), Error> {
    let largest = block.rows.values().map(|values| values[pressure].abs()).fold(0.0, f64::max);
    let apart = |rows: &Vec<Row>| {
        let of = |(number, values): &Row| (*number, values[pressure]);
        let (first, one) = rows.first().map(of)?;
        let (second, other) = rows.iter().map(of).find(|(_, other)| (other - one).abs() > LAYERS * largest)?;
        Some(format!(
            "nodes {first} and {second} of its contact block are one of the plane, and have the pressures {one} and \
            {other}"
        ))
    };
    match rows.iter().find_map(apart) {
        Some(message) => Err(source.refused(message, "hand in a plane model, or one layer of it alone")),
        None => Ok(()),
    }
}

/// Difference of pressures of the layers of a slice, over the largest, which their six digits and an iteration leave.
const LAYERS: f64 = 1e-3;
/// Distance of nodes, over the largest coordinate of their cell, within which they are at the same place: six digits
/// are written.
const SAME: f64 = 2e-6;
/// The same of radii, of which both coordinates are rounded.
const SAME_RADIUS: f64 = 1e-5;

/// Places of the nodes.
fn nodes(source: &Source) -> Result<BTreeMap<usize, [f64; 3]>, Error> {
    let mut lines = source.text.lines().skip_while(|line| !line.starts_with("    2C"));
    if lines.next().is_none() {
        return Err(source.refused("it has no block of nodes", AGAIN));
    }
    let mut rows = Vec::new();
    for line in lines.take_while(|line| line.starts_with(" -1")) {
        let (node, place) = record(source, line)?;
        if place.len() != 3 {
            return Err(wrong(source, line, &format!("{} of 3 coordinates", place.len())));
        }
        rows.push((node, line, place));
    }
    let place = |(node, place): (usize, Vec<f64>)| (node, [place[0], place[1], place[2]]);
    Ok(once(source, "of nodes", rows)?.into_iter().map(place).collect())
}
