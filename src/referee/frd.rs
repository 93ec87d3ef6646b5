//! Answers of CalculiX as fields (`.frd`), written with `OUTPUT=2D`: pressures and gaps of any deck with contact pairs, displacements of all.

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, Handed, Point, contact_named, ordered, signed_coordinate};
use crate::referee::asked::Asked;
use crate::referee::calculix::{AGAIN, at, factor};
use crate::referee::field::Field;
use crate::referee::side::{self, Cell};
use crate::referee::units::Role;
use crate::scene::Scene;

/// Pressures and gaps of the last contact block of a file of fields.
pub fn parse(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let contact = contact_named(scene, asked.contact.as_deref(), |message, remedy| Error::file(file, message, remedy))?;
    let [length, stress] = [Role::Position, Role::Pressure].map(|role| factor(file, role, asked, None));
    let [length, stress] = [length?, stress?];
    let (nodes, block) = (nodes_of_fields(file, text)?, contact_block(file, text)?);
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
    let numbers: Vec<usize> = nodes.keys().copied().collect();
    let places: Vec<[f64; 2]> = nodes.values().map(|[x, y, _]| [length * x, length * y]).collect();
    let cells = cells(file, text, &numbers)?;
    let edges = side::edges(scene, contact, &places, &cells);
    let mut own: Vec<usize> = edges.iter().flatten().copied().collect();
    own.sort_unstable();
    own.dedup();
    let none = vec![0.0; block.components.len()];
    let point = |index: usize| {
        // Nodes that it does not list carry nothing.
        let values = block.rows.get(&numbers[index]).unwrap_or(&none);
        let gap = gap.map(|gap| length * values[gap]);
        Point {
            position: signed_coordinate(pair, places[index]),
            value: asked.sign() * stress * values[pressure],
            area: None,
            gap,
        }
    };
    let points = own.into_iter().map(point).collect();
    let quadratic = !edges.is_empty() && edges.iter().all(|edge| edge.len() == 3);
    let order = asked.order.unwrap_or(if quadratic { Order::Quadratic } else { Order::Linear });
    let points =
        ordered(points, order, |message, remedy| Error::file(file, format!("contact block: {message}"), remedy))?;
    let read = [Some(format!("{name} as pressure")), gap.map(|gap| format!("{} as gap", block.components[gap]))];
    let contacts = vec![Handed { contact, points, order, edges: vec![], forces: false }];
    Ok(Answer {
        file: file.into(),
        code: Some("CalculiX".into()),
        read: read.into_iter().flatten().collect(),
        contacts,
        field: displacements(file, text, asked, None)?,
    })
}

/// The displacements of a file; none where it has none, or their unit is not known. `ours` is the unit of our own decks.
pub fn displacements(file: &Path, text: &str, asked: &Asked, ours: Option<&str>) -> Result<Option<Field>, Error> {
    let known = asked.unit(Role::Displacement).or(ours).is_some();
    let Some(block) = last_block(file, text, "DISP")?.filter(|_| known) else { return Ok(None) };
    let [length, moved] = [Role::Position, Role::Displacement].map(|role| factor(file, role, asked, ours));
    let [length, moved] = [length?, moved?];
    let nodes = nodes_of_fields(file, text)?;
    let numbers: Vec<usize> = nodes.keys().copied().collect();
    let value = |number: &usize| match block.rows.get(number).map(Vec::as_slice) {
        Some([u, v, ..]) => Ok([moved * u, moved * v]),
        _ => Err(Error::file(file, format!("its block of displacements has no node {number}"), AGAIN)),
    };
    Ok(Some(Field {
        points: nodes.values().map(|[x, y, _]| [length * x, length * y]).collect(),
        cells: cells(file, text, &numbers)?,
        displacement: numbers.iter().map(value).collect::<Result<_, Error>>()?,
    }))
}

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

/// Types of plane cells: corners, then all nodes.
const PLANE: [(&str, usize, usize); 4] = [("7", 3, 3), ("8", 3, 6), ("9", 4, 4), ("10", 4, 8)];
/// Types of lines, as which gap elements are written.
const LINES: [&str; 2] = ["11", "12"];

/// The plane cells, their nodes by index.
fn cells(file: &Path, text: &str, numbers: &[usize]) -> Result<Vec<Cell>, Error> {
    let wrong = |line: &str, message: &str, remedy: &str| at(file, text, line, message.into(), remedy);
    let mut lines = text.lines().skip_while(|line| !line.starts_with("    3C")).skip(1).peekable();
    let mut cells = Vec::new();
    while let Some(head) = lines.next_if(|line| line.starts_with(" -1")) {
        let kind = head.split_whitespace().nth(2).unwrap_or_default();
        let mut nodes = Vec::new();
        while let Some(line) = lines.next_if(|line| line.starts_with(" -2")) {
            for word in line[3..].split_whitespace() {
                let index = word.parse().ok().and_then(|number: usize| numbers.binary_search(&number).ok());
                nodes.push(index.ok_or_else(|| wrong(line, "this line names a node that is not there", AGAIN))?);
            }
        }
        if LINES.contains(&kind) {
            continue;
        }
        let Some((_, corners, all)) = PLANE.into_iter().find(|(known, ..)| *known == kind) else {
            return Err(wrong(
                head,
                "this cell is not plane",
                "write *CONTACT FILE and *NODE FILE with OUTPUT=2D, and run ccx again",
            ));
        };
        if nodes.len() != all {
            return Err(wrong(head, "this cell has not the nodes of its type", AGAIN));
        }
        cells.push(Cell { nodes, corners });
    }
    Ok(cells)
}

/// The last block of contact results.
fn contact_block(file: &Path, text: &str) -> Result<Block, Error> {
    let remedy =
        "write `*CONTACT FILE` with CDIS and CSTR in the step, and run ccx again; of an exported deck hand in the .dat";
    last_block(file, text, "CONTACT")?.ok_or_else(|| Error::file(file, "it has no contact block", remedy))
}

/// The last block of a name; none where there is none.
fn last_block(file: &Path, text: &str, name: &str) -> Result<Option<Block>, Error> {
    let Some(begin) = text.rfind(&format!(" -4  {name}")) else { return Ok(None) };
    let mut lines = text[begin..].lines().skip(1).peekable();
    let mut components = Vec::new();
    while let Some(line) = lines.next_if(|line| line.starts_with(" -5")) {
        // What a viewer is to compute from the others is listed too.
        components.extend(line.split_whitespace().nth(1).filter(|name| *name != "ALL").map(str::to_owned));
    }
    let mut rows = BTreeMap::new();
    for line in lines {
        if line.starts_with(" -3") {
            return Ok(Some(Block { components, rows }));
        }
        let (node, values) = record(file, text, line, components.len())?;
        rows.insert(node, values);
    }
    Err(Error::file(file, format!("its block {name} has no end"), AGAIN))
}
