//! Answers of CalculiX: nodal forces of the tables (`.dat`) of an exported deck, contact fields (`.frd`) of any deck with contact pairs.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::error::{Error, Located};
use crate::mesh::Order;
use crate::referee::answer::{Answer, Handed, Point, contact_named, ordered, signed_coordinate};
use crate::referee::asked::Asked;
use crate::referee::export::deck::{GAPS, named};
use crate::referee::units::Role;
use crate::scene::Scene;

/// What a deck of ours begins with, and by which its units are known.
const OURS: &str = ": mm, N, MPa.";
/// What to do with files that are cut or of another kind.
const AGAIN: &str = "run ccx again, and hand in the file that it writes";

/// What is wrong at the line of a word of a text.
fn at(file: &Path, text: &str, word: &str, message: String, remedy: &str) -> Error {
    let begin = (word.as_ptr() as usize).saturating_sub(text.as_ptr() as usize).min(text.len());
    Error::at(Located::new((file, text), begin..begin + word.len()), message, remedy)
}

/// A unit that is named, or known because the deck is one of ours.
fn factor(file: &Path, role: Role, asked: &Asked, ours: Option<&str>) -> Result<f64, Error> {
    let remedy = format!("give --unit {}=UNIT, with one of {}", role.name(), role.known_units());
    let Some(unit) = asked.unit(role).or(ours) else {
        return Err(Error::file(file, format!("it does not say the unit of {}", role.name()), remedy));
    };
    role.factor(unit).ok_or_else(|| Error::file(file, format!("the unit `{unit}` is not known"), remedy))
}

/// Nodal forces of the sets behind the gap elements of an exported deck.
pub fn forces(file: &Path, text: &str, deck: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let own = deck.lines().next().is_some_and(|line| line.contains(OURS));
    let [length, force] =
        [(Role::X, "mm"), (Role::Force, "N")].map(|(role, unit)| factor(file, role, asked, own.then_some(unit)));
    let [length, force] = [length?, force?];
    let places = nodes_of_deck(&file.with_extension("inp"), deck)?;
    let order = asked.order.unwrap_or_else(|| order_of_deck(deck));
    let mut contacts = Vec::new();
    for (contact, pair) in scene.contacts.iter().enumerate() {
        let set = format!("{GAPS}{}", named(&[&pair.name]));
        let lines = table_of(text, &set);
        if lines.is_empty() {
            continue;
        }
        let point = |line: &str| -> Result<Point, Error> {
            let words: Vec<&str> = line.split_whitespace().collect();
            let wrong = |message: String| at(file, text, line, message, AGAIN);
            let [node, along, ..] = words.as_slice() else {
                return Err(wrong("this line has no node and force".into()));
            };
            let number: usize = node.parse().map_err(|_| wrong(format!("`{node}` is no number of a node")))?;
            let value: f64 = along.parse().map_err(|_| wrong(format!("`{along}` is no number")))?;
            let place = places.get(&number).ok_or_else(|| wrong(format!("node {number} is not in the deck")))?;
            if !value.is_finite() || words.len() < 4 {
                return Err(wrong(format!("`{}` is no node with three forces", line.trim())));
            }
            let position = signed_coordinate(pair, place.map(|x| length * x));
            Ok(Point { position, value: 0.0 - asked.sign() * force * value, area: None, gap: None })
        };
        let points = lines.into_iter().map(point).collect::<Result<Vec<Point>, Error>>()?;
        let points =
            ordered(points, order, |message, remedy| Error::file(file, format!("set {set}: {message}"), remedy))?;
        contacts.push(Handed { contact, points, order, edges: vec![], forces: true });
    }
    if contacts.is_empty() {
        let message = format!("it has no forces of a set whose name begins with {GAPS}");
        let remedy = "run the deck that `contact-vv export` writes; of another deck hand in the .frd, or a .csv of positions and forces";
        return Err(Error::file(file, message, remedy));
    }
    let read = vec![
        "reactions behind the gap elements as contact forces, turned round".into(),
        "places from the deck of the same name".into(),
    ];
    Ok(Answer { file: file.into(), code: Some("CalculiX".into()), read, contacts })
}

/// Lines of the last table of forces of a set.
fn table_of<'a>(text: &'a str, set: &str) -> Vec<&'a str> {
    let mut lines = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if line.contains(" for set ") {
            inside = line.trim_start().starts_with("forces") && line.split_whitespace().any(|word| word == set);
            if inside {
                lines.clear();
            }
        } else if inside && !line.trim().is_empty() {
            lines.push(line);
        }
    }
    lines
}

/// Places of the nodes of a deck.
fn nodes_of_deck(file: &Path, deck: &str) -> Result<BTreeMap<usize, [f64; 2]>, Error> {
    let mut nodes = BTreeMap::new();
    let mut inside = false;
    for line in deck.lines() {
        if line.starts_with('*') {
            inside = if line.starts_with("**") {
                inside
            } else {
                line.split(',').next().is_some_and(|word| word.trim().eq_ignore_ascii_case("*node"))
            };
            continue;
        }
        let mut words = line.split(',').map(str::trim);
        if let (true, Some(number), Some(x), Some(y)) = (inside, words.next(), words.next(), words.next()) {
            let (number, x, y) = (number.parse::<usize>(), x.parse::<f64>(), y.parse::<f64>());
            let (Ok(number), Ok(x), Ok(y)) = (number, x, y) else {
                return Err(at(
                    file,
                    deck,
                    line,
                    format!("`{line}` is no node with its place"),
                    "export the deck again",
                ));
            };
            nodes.insert(number, [x, y]);
        }
    }
    Ok(nodes)
}

/// Edges with three nodes where a deck has cells with eight.
fn order_of_deck(deck: &str) -> Order {
    let upper = |line: &str| line.to_ascii_uppercase();
    let eight = deck
        .lines()
        .filter(|line| line.starts_with('*'))
        .map(upper)
        .any(|line| line.contains("TYPE=CPE8") || line.contains("TYPE=CPS8"));
    if eight { Order::Quadratic } else { Order::Linear }
}

/// Pressures and gaps of the last contact block of a file of fields.
pub fn fields(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let contact = contact_named(scene, asked.contact.as_deref(), |message, remedy| Error::file(file, message, remedy))?;
    let [length, stress] = [Role::Position, Role::Pressure].map(|role| factor(file, role, asked, None));
    let [length, stress] = [length?, stress?];
    let (nodes, block) = (nodes_of_fields(file, text)?, last_block(file, text)?);
    let named = |role: Role, usual: &str| asked.column(role).unwrap_or(usual).to_owned();
    let column = |name: &str| block.components.iter().position(|known| known == name);
    let name = named(Role::Pressure, "CPRESS");
    let Some(pressure) = column(&name) else {
        let message = format!("its contact block has no component {name} but {}", block.components.join(", "));
        return Err(Error::file(
            file,
            message,
            "write *CONTACT FILE with CSTR, or name the component by --column pressure=NAME",
        ));
    };
    let gap = column(&named(Role::Gap, "COPEN"));
    let pair = &scene.contacts[contact];
    // Plane cells become bricks inside ccx: one layer of their nodes is enough.
    let layer = block.rows.keys().filter_map(|node| nodes.get(node)).map(|[_, _, z]| *z).fold(f64::INFINITY, f64::min);
    let mut seen = BTreeSet::new();
    let mut points = Vec::new();
    for (node, values) in &block.rows {
        let Some(place) = nodes.get(node) else {
            return Err(Error::file(file, format!("node {node} of its contact block has no place"), AGAIN));
        };
        let position = signed_coordinate(pair, [place[0], place[1]].map(|x| length * x));
        if place[2] <= layer + LAYER
            && position.abs() <= pair.stretch * (1.0 + LAYER)
            && seen.insert(position.to_bits())
        {
            let gap = gap.map(|gap| length * values[gap]);
            points.push(Point { position, value: asked.sign() * stress * values[pressure], area: None, gap });
        }
    }
    let order = asked.order.unwrap_or(Order::Linear);
    let points =
        ordered(points, order, |message, remedy| Error::file(file, format!("contact block: {message}"), remedy))?;
    let read = [Some(format!("{name} as pressure")), gap.map(|gap| format!("{} as gap", block.components[gap]))];
    let contacts = vec![Handed { contact, points, order, edges: vec![], forces: false }];
    Ok(Answer {
        file: file.into(),
        code: Some("CalculiX".into()),
        read: read.into_iter().flatten().collect(),
        contacts,
    })
}

/// Distance from a layer of nodes, or beyond the stretch over that, that the digits of the file explain.
const LAYER: f64 = 1e-4;

/// A block of results: names of components, and their values a node.
struct Block {
    components: Vec<String>,
    rows: BTreeMap<usize, Vec<f64>>,
}

/// Number of a node and the numbers behind it, twelve characters each.
fn record(file: &Path, text: &str, line: &str, wanted: usize) -> Result<(usize, Vec<f64>), Error> {
    let wrong = || at(file, text, line, "this line is cut, or holds no finite numbers".into(), AGAIN);
    let node = line.get(3..13).and_then(|word| word.trim().parse().ok()).ok_or_else(wrong)?;
    let number = |k: usize| {
        line.get(13 + 12 * k..25 + 12 * k)
            .and_then(|word| word.trim().parse::<f64>().ok())
            .filter(|value| value.is_finite())
    };
    Ok((node, (0..wanted).map(number).collect::<Option<Vec<f64>>>().ok_or_else(wrong)?))
}

/// Places of the nodes.
fn nodes_of_fields(file: &Path, text: &str) -> Result<BTreeMap<usize, [f64; 3]>, Error> {
    let mut lines = text.lines().skip_while(|line| !line.starts_with("    2C"));
    if lines.next().is_none() {
        return Err(Error::file(file, "it has no block of nodes", AGAIN));
    }
    let mut nodes = BTreeMap::new();
    for line in lines.take_while(|line| line.starts_with(" -1")) {
        let (node, place) = record(file, text, line, 3)?;
        nodes.insert(node, [place[0], place[1], place[2]]);
    }
    Ok(nodes)
}

/// The last block of contact results.
fn last_block(file: &Path, text: &str) -> Result<Block, Error> {
    let begin = text.rfind(" -4  CONTACT").ok_or_else(|| {
        Error::file(
            file,
            "it has no contact block",
            "write `*CONTACT FILE` with CDIS and CSTR in the step, and run ccx again",
        )
    })?;
    let mut lines = text[begin..].lines().skip(1).peekable();
    let mut components = Vec::new();
    while let Some(line) = lines.next_if(|line| line.starts_with(" -5")) {
        components.extend(line.split_whitespace().nth(1).map(str::to_owned));
    }
    let mut rows = BTreeMap::new();
    for line in lines {
        if line.starts_with(" -3") {
            return Ok(Block { components, rows });
        }
        let (node, values) = record(file, text, line, components.len())?;
        rows.insert(node, values);
    }
    Err(Error::file(file, "its contact block has no end", AGAIN))
}
