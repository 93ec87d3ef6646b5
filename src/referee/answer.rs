//! What another code found, on its own mesh: points of each contact in our units, in the order of the contact
//! coordinate.

use std::path::PathBuf;

use crate::error::Error;
use crate::markdown::significant;
use crate::measure::display_factor;
use crate::mesh::Order;
use crate::referee::field::Field;
use crate::referee::units::Units;
use crate::scene::{ContactPair, Scene};
use crate::solution::EdgeState;

/// An answer as it was handed in.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The file it was read from.
    pub file: PathBuf,
    /// The code, where it says so.
    pub code: Option<String>,
    /// What was read as what, a sentence each.
    pub read: Vec<String>,
    /// What makes it another answer than may be meant, a sentence each.
    pub notes: Vec<String>,
    /// Units of its numbers, as the file or --unit calls them.
    pub units: Units,
    /// Its contacts.
    pub contacts: Vec<Handed>,
    /// Displacements on its mesh, where they were handed in with their unit.
    pub field: Option<Field>,
}

/// What was handed in of one contact.
#[derive(Clone, Debug)]
pub struct Handed {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Its points, in the order of the contact coordinate.
    pub points: Vec<Point>,
    /// How they follow one another: nodes of edges with two, or with three nodes.
    pub order: Order,
    /// Whether that was told.
    pub is_told: bool,
    /// Means over edges, where these were handed in too.
    pub edges: Vec<EdgeState>,
    /// Whether nodal forces were handed in instead of pressures.
    pub forces: bool,
}

/// One point: a node of the contact side, or where a pressure was read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Contact coordinate; negative on the other half \[mm, or rad on an arc\].
    pub position: f64,
    /// Pressure, positive in compression \[MPa\]; the force \[N\] where forces were handed in.
    pub value: f64,
    /// Tributary area \[mm²\]; none where it was not handed in.
    pub area: Option<f64>,
    /// Remaining gap \[mm\]; none where it was not handed in.
    pub gap: Option<f64>,
}

impl Answer {
    /// What was handed in of a contact.
    pub fn of(&self, contact: usize) -> Option<&Handed> {
        self.contacts.iter().find(|handed| handed.contact == contact)
    }

    /// Turns what lies on the left half alone of a symmetric contact over: models of the left half are judged as those
    /// of the right one.
    pub fn mirror(&mut self, scene: &Scene) {
        let is_half = |handed: &&mut Handed| !scene.contacts[handed.contact].path.has_both_sides();
        self.contacts.iter_mut().filter(is_half).for_each(Handed::laid_on_the_line);
        let ends = |handed: &Handed| Some([handed.points.first()?.position, handed.points.last()?.position]);
        let is_left = |handed: &Handed| ends(handed).is_some_and(|[first, last]| last <= SAME * first.abs());
        for handed in self.contacts.iter_mut().filter(|_| !scene.is_of_revolution()).filter(is_half) {
            if is_left(handed) {
                handed.points.reverse();
                handed.points.iter_mut().for_each(|point| point.position = 0.0 - point.position);
                handed.edges = handed.edges.iter().rev().map(EdgeState::mirrored).collect();
                self.read.push("the left half of a symmetric contact as the right one".into());
            }
        }
    }
}

/// What is read where there are both.
pub const BESIDE: &str = "the pressures, not the forces beside them";
/// Part of the distance to its neighbour by which an outermost point lies off the symmetry line for the digits of its
/// file.
const OFF_THE_LINE: f64 = 0.05;

impl Handed {
    /// Lays an outermost point that lies next to the symmetry line, and the edge there, on it.
    fn laid_on_the_line(&mut self) {
        let lay = |[at, next]: [f64; 2]| if at.abs() <= OFF_THE_LINE * (next - at).abs() { 0.0 } else { at };
        if let [first, second, .., before, last] = &mut self.points[..] {
            first.position = lay([first.position, second.position]);
            last.position = lay([last.position, before.position]);
        }
        if let Some(edge) = self.edges.first_mut() {
            edge.ends[0] = lay(edge.ends);
        }
        if let Some(edge) = self.edges.last_mut() {
            edge.ends[1] = lay([edge.ends[1], edge.ends[0]]);
        }
    }
}

/// The contact of a name; without one, the only one of the scene.
pub fn contact_named(
    scene: &Scene,
    name: Option<&str>,
    refused: impl Fn(String, String) -> Error,
) -> Result<usize, Error> {
    let known: Vec<&str> = scene.contacts.iter().map(|pair| pair.name.as_str()).collect();
    match name {
        None if known.len() == 1 => Ok(0),
        None => {
            let message = format!("the scene has {} contacts, and the answer does not say of which it is", known.len());
            Err(refused(
                message,
                format!("add a column `contact`, or give --contact, with one of {}", known.join(", ")),
            ))
        }
        Some(name) => known
            .iter()
            .position(|other| *other == name)
            .ok_or_else(|| refused(format!("there is no contact `{name}`"), format!("known: {}", known.join(", ")))),
    }
}

/// Places of a contact, in mm or degrees.
pub fn places(pair: &ContactPair, all: &[f64]) -> String {
    let all: Vec<String> = all.iter().map(|s| significant(display_factor(&pair.path) * s, 4)).collect();
    format!("{} {}", all.join(" to "), if pair.path.is_straight() { "mm" } else { "°" })
}

/// Points in order; refuses too few, those without any pressure, two at one place, and three-node edges that do not add
/// up.
pub fn ordered(
    mut points: Vec<Point>,
    order: Order,
    pair: &ContactPair,
    refused: impl Fn(String, &str) -> Error,
) -> Result<Vec<Point>, Error> {
    if points.len() < FEWEST {
        let message = format!("{} points were handed in, and a profile needs {FEWEST}", points.len());
        return Err(refused(message, "hand in every node of the contact side, those without pressure too"));
    }
    if points.iter().all(|point| point.value.abs() <= 0.0) {
        let message = format!("nothing presses: all {} values of contact `{}` are 0", points.len(), pair.name);
        return Err(refused(
            message,
            "hand in the side that has the values, of a state under the load of the scene, which --time names among \
            several",
        ));
    }
    points.sort_by(|a, b| a.position.total_cmp(&b.position));
    let length = points[points.len() - 1].position - points[0].position;
    if let Some(two) = points.windows(2).find(|two| two[1].position - two[0].position <= SAME * length) {
        let message = format!("two points lie at one place, {}", places(pair, &[two[0].position]));
        return Err(refused(
            message,
            "hand in the points of one side of one contact, of one step and time, each once; of a grid in parts merge \
            their points first",
        ));
    }
    // On an axis a node may have no area, and codes give none to nodes that are open.
    let may_have_none = |point: &Point| point.position.abs() <= SAME * length || point.value.abs() <= 0.0;
    let is_wrong = |point: &Point, area: f64| area < 0.0 || area <= 0.0 && !may_have_none(point);
    let wrong = |point: &Point| Some((point.position, point.area.filter(|area| is_wrong(point, *area))?));
    if let Some((position, area)) = points.iter().find_map(wrong) {
        let remedy = "areas are positive, but 0 where nothing presses; without areas they follow from the places";
        return Err(refused(format!("the area at {} is {area} mm²", places(pair, &[position])), remedy));
    }
    let nodes = usize::from(order.number()) + 1;
    if !(points.len() - 1).is_multiple_of(nodes - 1) {
        let message = format!("{} nodes are no whole number of edges with {nodes} nodes each", points.len());
        return Err(refused(
            message,
            "hand in every node from corner to corner, that on an axis too, or say by --order what edges they are of",
        ));
    }
    Ok(points)
}

/// Points in order, those at one place made one with their mean pressure and gap: cells with points of their own repeat
/// them.
pub fn joined(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.position.total_cmp(&b.position));
    let length = points.last().zip(points.first()).map_or(0.0, |(last, first)| last.position - first.position);
    let one = |own: &[Point]| {
        let mean = |of: &dyn Fn(&Point) -> Option<f64>| {
            own.iter().map(of).sum::<Option<f64>>().map(|sum| sum / own.len() as f64)
        };
        let value = mean(&|point| Some(point.value)).unwrap_or(f64::NAN);
        Point { value, gap: mean(&|point| point.gap), ..own[0] }
    };
    points.chunk_by(|a, b| b.position - a.position <= SAME * length).map(one).collect()
}

/// Points in order, and how many nodes of the contact lack one: those between others, and those up to an end on the
/// symmetry line that is pressed. What lies beyond the others is not guessed: whether the contact ends there is judged
/// as that of a list of points.
pub fn without_gaps(mut nodes: Vec<(f64, Option<Point>)>) -> (Vec<Point>, usize) {
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let points: Vec<Point> = nodes.iter().filter_map(|(_, point)| *point).collect();
    let largest = points.iter().map(|point| point.value.abs()).fold(0.0, f64::max);
    let is_free = |point: Option<&Point>| point.is_some_and(|point| point.value.abs() <= CLOSED * largest);
    let begin = nodes.iter().take_while(|(_, point)| point.is_none()).count();
    let end = nodes.iter().rev().take_while(|(_, point)| point.is_none()).count();
    let length = nodes.last().zip(nodes.first()).map_or(0.0, |(last, first)| last.0 - first.0);
    let is_at_line = nodes.first().is_some_and(|(at, _)| at.abs() <= SAME * length);
    let begin = if is_at_line && !is_free(points.first()) { 0 } else { begin };
    let lacking = nodes.len() - points.len();
    let beyond = if points.is_empty() { 0 } else { begin + end };
    (points, lacking - beyond)
}

/// Tension over the largest pressure that stresses have at nodes beside a contact: they are means of cells, of which
/// one ends it.
const PULL: f64 = 0.05;

/// Takes such tension for nothing, and says how much it was; none where there is none, or more.
pub fn without_pull<'a>(pressures: impl Iterator<Item = &'a mut f64>) -> Option<String> {
    let mut pressures: Vec<&mut f64> = pressures.collect();
    let largest = pressures.iter().fold(0.0, |most: f64, pressure| most.max(**pressure));
    let pull = pressures.iter().fold(0.0, |most: f64, pressure| most.max(-**pressure));
    if pull <= 0.0 || pull > PULL * largest {
        return None;
    }
    pressures.iter_mut().for_each(|pressure| **pressure = pressure.max(0.0));
    Some(format!(
        "tension of up to {:.1} % of the largest pressure as none: stresses at nodes are means of cells",
        100.0 * pull / largest
    ))
}

/// Largest pressure at the end of those that are listed, over all, behind which nodes without a value are beyond the
/// contact.
const CLOSED: f64 = 1e-3;
/// Fewest points of a profile.
pub const FEWEST: usize = 3;
/// Distance of two points, over the length of all, below which they are one.
const SAME: f64 = 1e-9;
