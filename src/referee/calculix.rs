//! Answers of CalculiX as tables (`.dat`): nodal forces of an exported deck.

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, Point};
use crate::referee::asked::Asked;
use crate::referee::export::deck::{GAPS, SECTORS, gaps_of};
use crate::referee::profile::handed;
use crate::referee::side::signed_coordinate;
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::units::Role;
use crate::scene::Scene;

/// What a deck of ours begins with, and by which its units are known.
const OURS: &str = ": mm, N, MPa.";
/// What to do with files that are cut or of another kind.
pub const AGAIN: &str = "run ccx again, and hand in the file that it writes";

/// Whether a deck is one that we exported.
pub fn is_ours(deck: &str) -> bool {
    deck.lines().next().is_some_and(|line| line.contains(OURS))
}

/// Whether a table has forces of such a set as an exported deck asks for.
pub fn has_forces(text: &str) -> bool {
    let set = format!(" for set {GAPS}");
    text.lines().any(|line| line.trim_start().starts_with("forces") && line.contains(&set))
}

/// Nodal forces of the sets behind the gap elements of an exported deck.
pub fn forces(file: &Path, text: &str, deck: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    forces_at(file, text, deck, scene, asked).map(|(answer, _)| answer)
}

/// The same with the state that they are of.
pub fn forces_at(
    file: &Path,
    text: &str,
    deck: &str,
    scene: &Scene,
    asked: &Asked,
) -> Result<(Answer, Option<State>), Error> {
    let (source, own) = (Source { file, text }, is_ours(deck));
    let ours = |unit: &'static str| own.then_some(unit);
    let length = source.factor(Role::X, "the place of a node of the deck", ours("mm"), asked.unit(Role::X))?;
    let force = source.factor(Role::Force, "the force", ours("N"), asked.unit(Role::Force))?;
    let places = nodes_of_deck(&Source { file: &file.with_extension("inp"), text: deck })?;
    let order = asked.order.unwrap_or_else(|| order_of_deck(deck));
    // Nodes of no cell have the forces of the sector into which ccx expands cells of revolution.
    let whole = if scene.is_of_revolution() { SECTORS } else { 1.0 };
    let (mut contacts, mut read, mut notes, mut at) = (Vec::new(), Vec::new(), Vec::new(), None);
    for (contact, pair) in scene.contacts.iter().enumerate() {
        let set = gaps_of(scene, contact);
        let tables = tables_of(text, &set);
        if tables.is_empty() {
            continue;
        }
        let states: Vec<State> = tables.iter().map(|(state, _)| *state).collect();
        let (state, lines) = &tables[State::chosen(&source, &states, asked)?];
        at = Some(*state);
        read.push(format!("the forces of {set} at {state}, of {} that are there", tables.len()));
        notes.extend(state.notes(&states));
        let wanted = size_of_set(deck, &set);
        if lines.len() != wanted {
            let message = format!("its table of {set} has {} nodes, and the set in the deck {wanted}", lines.len());
            return Err(source.refused(message, AGAIN));
        }
        let point = |line: &&str| -> Result<Point, Error> {
            let words: Vec<&str> = line.split_whitespace().collect();
            let wrong = |message: String| source.at(line, message, AGAIN);
            let [node, along, ..] = words.as_slice() else {
                return Err(wrong("this line has no node and force".into()));
            };
            let number: usize = node.parse().map_err(|_| wrong(format!("`{node}` is no number of a node")))?;
            let value: f64 = along.parse().map_err(|_| wrong(format!("`{along}` is no number")))?;
            let place = places.get(&number).ok_or_else(|| wrong(format!("node {number} is not in the deck")))?;
            let are_numbers = words[1..].iter().all(|word| word.parse::<f64>().is_ok_and(f64::is_finite));
            if !are_numbers || words.len() < 4 {
                return Err(wrong(format!("`{}` is no node with three forces", line.trim())));
            }
            let position = signed_coordinate(pair, place.map(|x| length * x));
            Ok(Point { position, value: 0.0 - whole * asked.sign() * force * value, area: None, gap: None })
        };
        let points = lines.iter().map(point).collect::<Result<Vec<Point>, Error>>()?;
        let refused = |message, remedy: &str| source.refused(format!("set {set}: {message}"), remedy);
        contacts.push(handed((scene, contact), points, Some(order), true, refused)?);
    }
    if contacts.is_empty() {
        let message = format!("it has no forces of a set whose name begins with {GAPS}");
        let remedy = "run the deck that `contact-vv export` writes; of another deck hand in the .frd, or a .csv of \
            positions and forces";
        return Err(source.refused(message, remedy));
    }
    read.insert(0, "reactions behind the gap elements as contact forces, turned round".into());
    read.extend(scene.is_of_revolution().then(|| "reactions of a sector of 2° times 180".to_owned()));
    read.push("places from the deck of the same name".into());
    notes.dedup();
    let (code, units) = (Some("CalculiX".into()), asked.units());
    Ok((Answer { file: file.into(), code, read, notes, units, contacts, field: None }, at))
}

/// The tables of forces of a set, each with its time and its lines.
fn tables_of<'a>(text: &'a str, set: &str) -> Vec<(State, Vec<&'a str>)> {
    let mut tables: Vec<(State, Vec<&str>)> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if line.contains(" for set ") {
            inside = line.trim_start().starts_with("forces") && line.split_whitespace().any(|word| word == set);
            let time = line.split_whitespace().last().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN);
            tables.extend(inside.then_some((State { step: None, time }, vec![])));
        } else if let (true, false, Some((_, lines))) = (inside, line.trim().is_empty(), tables.last_mut()) {
            lines.push(line);
        }
    }
    tables
}

/// How many nodes a deck lists in a set.
fn size_of_set(deck: &str, set: &str) -> usize {
    let named = |line: &str| line.split([',', '=']).any(|word| word.trim().eq_ignore_ascii_case(set));
    let head = |line: &str| line.get(..5).is_some_and(|word| word.eq_ignore_ascii_case("*nset")) && named(line);
    let lines = deck.lines().skip_while(|line| !head(line)).skip(1).take_while(|line| !line.starts_with('*'));
    lines.flat_map(|line| line.split(',')).filter(|word| !word.trim().is_empty()).count()
}

/// Places of the nodes of a deck.
pub fn nodes_of_deck(source: &Source) -> Result<BTreeMap<usize, [f64; 2]>, Error> {
    let mut nodes = BTreeMap::new();
    let mut inside = false;
    for line in source.text.lines() {
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
                return Err(source.at(line, format!("`{line}` is no node with its place"), "export the deck again"));
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
        .any(|line| ["TYPE=CPE8", "TYPE=CPS8", "TYPE=CAX8"].iter().any(|kind| line.contains(kind)));
    if eight { Order::Quadratic } else { Order::Linear }
}
