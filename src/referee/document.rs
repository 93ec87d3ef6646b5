//! Answers as JSON, by a schema that `contact-vv schema answer` prints.

use std::fmt::Display;
use std::path::Path;

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Located};
use crate::mesh::Order;
use crate::referee::answer::{Answer, BESIDE, Handed, Point, contact_named, places};
use crate::referee::asked::Asked;
use crate::referee::profile::handed;
use crate::referee::units::{Role, Units, is_angle};
use crate::scene::{self, Scene};
use crate::solution::EdgeState;

/// What a code found for a case. Lists of a contact have one entry a point of its contact side, in any order.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// Name of the case, to be held against the one that is judged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// Name and version of the code.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Units of the lists.
    pub units: Units,
    /// The contacts.
    pub contacts: Vec<Contact>,
}

/// One contact.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Its name; may be left out where the scene has one only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Units of its lists, where they are others than those of the document: of contacts along arcs beside others along
    /// straight lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Units>,
    /// Order of the contact edges: 1, every point is a corner (the default); 2, corners and mid-sides by turns. Forces
    /// without it and without areas have the order by which their pressures vary less.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<u8>,
    /// Contact coordinate of each point: distance from the middle of the contact on a straight path, angle from the
    /// load line on an arc; negative on the other half. Of a contact around the axis of revolution the radius.
    pub position: Vec<f64>,
    /// Contact pressure per area of the undeformed path, positive in compression.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pressure: Vec<f64>,
    /// Nodal contact force along the normal, positive in compression: instead of the pressure. Of bodies of revolution
    /// that of the whole ring.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub force: Vec<f64>,
    /// Remaining gap, positive where open; null where there is no other side.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub gap: Vec<Option<f64>>,
    /// Tributary area of each point; follows from positions and order where it is left out. Of bodies of revolution
    /// that of the whole ring.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub area: Vec<f64>,
    /// Mean pressures over the edges, where the code knows them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub edges: Vec<Edge>,
}

/// The mean pressure over an edge.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Edge {
    /// Contact coordinate where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Its area.
    pub area: f64,
    /// Mean pressure.
    pub pressure: f64,
}

/// The schema (JSON Schema, draft 7).
pub fn schema() -> String {
    let schema = SchemaSettings::draft07().into_generator().into_root_schema_for::<Document>();
    serde_json::to_string_pretty(&schema).expect("a schema can be written as JSON")
}

/// What to do about a document that is none.
const SCHEMA: &str = "write it by the schema that `contact-vv schema answer` prints; `contact-vv export` writes one \
    to begin with; numbers are finite: leave out only points beyond the contact";

/// The answer in a text.
pub fn parse(file: &Path, text: &str, case: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let document: Document = serde_json::from_str(text).map_err(|error| {
        let begin = begin_of_line(text, error.line());
        Error::at(Located::new((file, text), begin..begin + error.column()), error.to_string(), SCHEMA)
    })?;
    let refused = |key: &str, message: String, remedy: &str| Error::file(file, format!("`{key}`: {message}"), remedy);
    if let Some(other) = document.case.as_deref().filter(|other| *other != case) {
        let message = format!("the answer is of `{other}`, but `{case}` is judged");
        return Err(refused("case", message, "judge the case that it is of"));
    }
    let units = &document.units;
    let is_asked = |contact: &Contact| {
        asked.contact.as_ref().is_none_or(|asked| contact.name.as_ref().is_none_or(|name| name == asked))
    };
    let own = document.contacts.iter().enumerate().filter(|(_, contact)| is_asked(contact));
    let handed = own.map(|(index, contact)| {
        let units = contact.units.as_ref().unwrap_or(units);
        Reader { file, index, scene, asked, units, contact }.handed()
    });
    let contacts: Vec<Handed> = handed.collect::<Result<_, Error>>()?;
    if contacts.is_empty() {
        let which = asked.contact.as_ref().map_or_else(String::new, |name| format!(" of the name `{name}`"));
        return Err(refused("contacts", format!("there is none{which}"), SCHEMA));
    }
    let is_twice = |k: &usize| contacts[..*k].iter().any(|one| one.contact == contacts[*k].contact);
    if let Some(k) = (0..contacts.len()).find(is_twice) {
        let message = format!("`{}` stands there twice", scene.contacts[contacts[k].contact].name);
        return Err(refused("contacts", message, SCHEMA));
    }
    let has_both = |contact: &Contact| !contact.pressure.is_empty() && !contact.force.is_empty();
    let mut read = vec!["lists by their keys, in the units that the file names".to_owned()];
    read.extend(document.contacts.iter().any(has_both).then(|| BESIDE.to_owned()));
    let (code, units) = (document.code, document.units);
    Ok(Answer { file: file.into(), code, read, notes: vec![], units, contacts, field: None })
}

/// Byte at which a line begins, from 1.
fn begin_of_line(text: &str, line: usize) -> usize {
    text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum()
}

/// What a contact is read with.
struct Reader<'a> {
    file: &'a Path,
    /// Its place in the document.
    index: usize,
    scene: &'a Scene,
    asked: &'a Asked,
    units: &'a Units,
    contact: &'a Contact,
}

impl Reader<'_> {
    /// What is wrong with a part of it.
    fn refused(&self, part: &str, message: impl Display, remedy: &str) -> Error {
        Error::file(self.file, format!("`contacts[{}].{part}`: {message}", self.index), remedy)
    }

    /// What turns a list into our unit; 1 where it is empty.
    fn factor(&self, role: Role, length: usize) -> Result<f64, Error> {
        let Some(unit) = self.units.of(role) else {
            let remedy = format!("add `units.{}`, one of {}", role.name(), role.known_units());
            let lacking = self.refused(role.name(), "it has no unit", &remedy);
            return if length == 0 { Ok(1.0) } else { Err(lacking) };
        };
        let named = self.asked.unit(role).filter(|_| length > 0);
        if let Some([message, remedy]) = named.and_then(|named| role.contradiction("it", (unit, named))) {
            return Err(self.refused(role.name(), message, &remedy));
        }
        let remedy = format!("use one of {}", role.known_units());
        let unknown = || self.refused(role.name(), format!("the unit `{unit}` is not known"), &remedy);
        role.factor(unit).ok_or_else(unknown)
    }

    /// A list in our unit; none where it is empty.
    fn list(&self, role: Role, list: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        let factor = self.factor(role, list.len())?;
        let wanted = self.contact.position.len();
        if list.is_empty() && role != Role::Position {
            return Ok(None);
        }
        if list.len() != wanted {
            let message = format!("it has {} entries, `position` {wanted}", list.len());
            return Err(self.refused(role.name(), message, "give one entry a point"));
        }
        Ok(Some(list.iter().map(|value| factor * value).collect()))
    }

    /// One contact in our units.
    fn handed(&self) -> Result<Handed, Error> {
        let Reader { scene, asked, units, contact, .. } = self;
        let name = contact.name.as_deref().or(asked.contact.as_deref());
        let index = contact_named(scene, name, |message, remedy| self.refused("name", message, &remedy))?;
        let pair = &scene.contacts[index];
        let straight = pair.path.is_straight();
        if units.position.as_deref().is_some_and(|unit| is_angle(unit) == straight) {
            let wanted = if straight { "mm, m or um" } else { "deg or rad" };
            let message = "its unit is not one of the path of the contact";
            return Err(self.refused("position", message, &format!("give {wanted}")));
        }
        let position = self.list(Role::Position, &contact.position)?.unwrap_or_default();
        let pressure = self.list(Role::Pressure, &contact.pressure)?;
        let force = self.list(Role::Force, &contact.force)?;
        let area = self.list(Role::Area, &contact.area)?;
        let gaps: Vec<f64> = contact.gap.iter().map(|gap| gap.unwrap_or(f64::INFINITY)).collect();
        let gap = self.list(Role::Gap, &gaps)?;
        let forces = pressure.is_none();
        let Some(values) = pressure.or(force) else {
            let message = "neither pressures nor forces were handed in";
            return Err(self.refused("pressure", message, "give one of the two lists"));
        };
        let told = contact.order.map(|number| {
            let unknown = || self.refused("order", format!("it is {number}"), "give 1, 2, or 4 to 8");
            Order::numbered(number.into()).ok_or_else(unknown)
        });
        let order = asked.order.map(Ok).or(told).transpose()?;
        // Means over edges are those between two points.
        let order = order.or((!contact.edges.is_empty()).then_some(Order::Linear));
        let point = |k: usize| Point {
            position: position[k],
            value: asked.sign() * values[k],
            area: area.as_ref().map(|area| area[k]),
            gap: gap.as_ref().map(|gap| gap[k]),
        };
        let points = (0..position.len()).map(point).collect();
        let own =
            handed((scene, index), points, order, forces, |message, remedy| self.refused("position", message, remedy))?;
        let edges = self.edges(&pair.path)?;
        if let Some([from, to]) = wrong_step(&edges, &own.points) {
            let ends = places(pair, &[from, to]);
            let message = format!("none, or more than one, reaches from {ends}");
            let remedy = "give one for every part of the contact from its first point to its last, or none at all";
            return Err(self.refused("edges", message, remedy));
        }
        let across = |edge: &EdgeState| pair.path.metric() * scene.depth(pair.path.point(edge.position()));
        let of_length = |edge: &EdgeState| edge.length() * across(edge);
        let is_other = |edge: &&EdgeState| (edge.weight / of_length(edge) - 1.0).abs() > OTHER;
        if let Some(edge) = edges.iter().find(is_other) {
            let message = format!(
                "the area of the one from {} is {} mm², its length times depth {}",
                edge.ends[0],
                edge.weight,
                of_length(edge)
            );
            return Err(self.refused("edges", message, "give the areas of the undeformed path in `units.area`"));
        }
        Ok(Handed { edges, ..own })
    }

    /// Its edges in our units.
    fn edges(&self, path: &scene::Path) -> Result<Vec<EdgeState>, Error> {
        let edges = &self.contact.edges;
        let [place, area, pressure] =
            [Role::Position, Role::Area, Role::Pressure].map(|role| self.factor(role, edges.len()));
        let [place, area, pressure] = [place?, area?, pressure?];
        let radial = self.scene.plane.radial();
        let state = |edge: &Edge| EdgeState {
            ends: [place * edge.from, place * edge.to],
            weight: area * edge.area,
            pressure: self.asked.sign() * pressure * edge.pressure,
            axis: radial.and_then(|radial| path.axis(radial, [edge.from, edge.to].map(|s| place * s))),
        };
        let mut edges: Vec<EdgeState> = edges.iter().map(state).collect();
        edges.sort_by(|a, b| a.ends[0].total_cmp(&b.ends[0]));
        let sound = |edge: &EdgeState| edge.length() > 0.0 && edge.weight > 0.0;
        let unsound = edges.iter().find(|edge| !sound(edge)).map(|edge| {
            let message = format!("the one from {} has no length or area", edge.ends[0]);
            self.refused("edges", message, "give `from` < `to`, `area` > 0")
        });
        unsound.map_or(Ok(edges), Err)
    }
}

/// From where to where edges in order leave out, or have twice, a part of the contact; none where they are none. The
/// first and the last point may lie within edges.
fn wrong_step(edges: &[EdgeState], points: &[Point]) -> Option<[f64; 2]> {
    let ([first, .., last], [begin, .., end]) = (points, edges) else { return None };
    let (first, last) = (first.position, last.position);
    let same = SAME * (last - first);
    let inside = edges.windows(2).map(|two| [two[0].ends[1], two[1].ends[0]]);
    let is_wrong = |[from, to]: &[f64; 2]| (to - from).abs() > same;
    let ends = [
        (begin.ends[0] - first > same || begin.ends[1] - first <= same).then_some([first, begin.ends[0]]),
        (last - end.ends[1] > same || last - end.ends[0] <= same).then_some([end.ends[1], last]),
    ];
    inside.into_iter().find(is_wrong).or(ends[0]).or(ends[1])
}

/// Part by which the area of an edge may differ from its length times the depth: on an arc its chord is shorter.
const OTHER: f64 = 0.05;
/// Part of the length of a contact that rounding of places explains.
const SAME: f64 = 1e-6;
