//! Answers as CSV: a line of names with their units, then a line a point.
//!
//! A column is called what it holds, `position [mm]`, `pressure [MPa]`, `force [N]`, `gap [mm]`, `area [mm2]`, `x [mm]`, `y [mm]` or
//! `contact`, or is named by `--column`. A unit stands in its brackets, or is named by `--unit`; none is guessed.

use std::path::Path;

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::error::{Error, Located};
use crate::mesh::Order;
use crate::referee::answer::{Answer, Handed, Point, contact_named, ordered, signed_coordinate};
use crate::referee::asked::Asked;
use crate::referee::units::{Role, is_angle};
use crate::scene::Scene;

/// What a file needs.
const HEADER: &str = "begin with a line of names and units such as `position [mm],pressure [MPa]`, or name columns by --column and --unit";

/// A column that is read.
#[derive(Clone, Debug)]
pub struct Column {
    /// What it holds.
    pub role: Role,
    /// Its place.
    pub index: usize,
    /// From its unit to ours.
    pub factor: f64,
    /// Its name and unit, as it was read.
    pub title: String,
    /// Whether it holds angles.
    pub angle: bool,
}

/// A file with its text.
struct Source<'a> {
    file: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    /// What is wrong with the file as a whole.
    fn refused(&self, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::file(self.file, message, remedy)
    }

    /// What is wrong with a line.
    fn at(&self, record: &StringRecord, message: String, remedy: &str) -> Error {
        let begin = record.position().map_or(0, |place| place.byte() as usize);
        let length = self.text.get(begin..).and_then(|rest| rest.find('\n')).unwrap_or(self.text.len());
        Error::at(Located::new((self.file, self.text), begin..begin + length), message, remedy)
    }
}

/// The answer in a text.
pub fn parse(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let source = Source { file, text };
    let delimiter = delimiter(text);
    let mut builder = ReaderBuilder::new();
    builder.delimiter(delimiter).comment(Some(b'#')).trim(Trim::All).flexible(true);
    let mut reader = builder.from_reader(text.as_bytes());
    let head = reader.headers().map_err(|error| source.refused(format!("cannot be read: {error}"), HEADER))?.clone();
    let columns = columns(&source, &head, asked)?;
    let mut groups: Vec<(usize, Vec<Point>)> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| source.refused(format!("cannot be read: {error}"), HEADER))?;
        if record.iter().all(str::is_empty) {
            continue;
        }
        if record.len() != head.len() {
            let message = format!("this line has {} cells, but the head names {}", record.len(), head.len());
            return Err(source.at(&record, message, "the file is cut, or a cell is missing: write it again"));
        }
        let (contact, point) = point(&source, &record, &columns, scene, asked)?;
        match groups.iter_mut().find(|(known, _)| *known == contact) {
            Some((_, points)) => points.push(point),
            None => groups.push((contact, vec![point])),
        }
    }
    if groups.is_empty() {
        return Err(source.refused("it has no line behind its head", "the file is cut: write it again"));
    }
    let order = asked.order.unwrap_or(Order::Linear);
    let forces = !columns.iter().any(|column| column.role == Role::Pressure);
    let handed = |(contact, points): (usize, Vec<Point>)| {
        let points = ordered(points, order, |message, remedy| source.refused(message, remedy))?;
        Ok(Handed { contact, points, order, edges: vec![], forces })
    };
    let contacts = groups.into_iter().map(handed).collect::<Result<_, Error>>()?;
    let read = columns.iter().map(|column| format!("`{}` as {}", column.title, column.role.name())).collect();
    Ok(Answer { file: file.into(), code: None, read, contacts, field: None })
}

/// A comma, unless the first line has none but semicolons or tabs.
fn delimiter(text: &str) -> u8 {
    let head = text.lines().find(|line| !line.trim_start().starts_with('#')).unwrap_or_default();
    [b',', b';', b'\t'].into_iter().find(|mark| head.as_bytes().contains(mark)).unwrap_or(b',')
}

/// Name and unit of a column: `pressure [MPa]` or `pressure (MPa)`.
fn split(title: &str) -> (&str, Option<&str>) {
    let inside = |open: char, close: char| {
        let (name, rest) = title.split_once(open)?;
        Some((name.trim(), Some(rest.trim().strip_suffix(close)?.trim())))
    };
    inside('[', ']').or_else(|| inside('(', ')')).unwrap_or((title.trim(), None))
}

/// The columns that are read, by what they hold.
fn columns(source: &Source, head: &StringRecord, asked: &Asked) -> Result<Vec<Column>, Error> {
    let shown = || head.iter().map(|title| format!("`{title}`")).collect::<Vec<_>>().join(", ");
    if head.iter().all(|title| title.parse::<f64>().is_ok()) {
        return Err(source.refused(format!("its first line holds no names but {}", shown()), HEADER));
    }
    let mut found = Vec::new();
    for role in Role::OF_TABLES {
        let is_it = |title: &str| match asked.column(role) {
            Some(named) => named == title || named == split(title).0,
            None => split(title).0.to_lowercase() == role.name(),
        };
        let all: Vec<usize> = (0..head.len()).filter(|&k| is_it(&head[k])).collect();
        match (all.as_slice(), asked.column(role)) {
            ([], None) => {}
            ([], Some(named)) => {
                let message = format!("there is no column `{named}` among {}", shown());
                return Err(source.refused(message, format!("name the column of {} by --column", role.name())));
            }
            ([index], _) => found.push(column(source, role, *index, &head[*index], asked)?),
            (_, _) => {
                let message = format!("more than one column is called {}: {}", role.name(), shown());
                return Err(source.refused(message, "name it by --column, with its unit"));
            }
        }
    }
    let has = |role: Role| found.iter().any(|column| column.role == role);
    if !has(Role::Position) && !has(Role::X) {
        return Err(source.refused(format!("no column is called `position` or `x`, but {}", shown()), HEADER));
    }
    match (has(Role::Pressure), has(Role::Force)) {
        (false, false) => {
            Err(source.refused(format!("no column is called `pressure` or `force`, but {}", shown()), HEADER))
        }
        _ => Ok(found),
    }
}

/// One column with its unit.
fn column(source: &Source, role: Role, index: usize, title: &str, asked: &Asked) -> Result<Column, Error> {
    let written = split(title).1;
    let unit = asked.unit(role).or(written);
    let remedy = || {
        format!(
            "write `{} [UNIT]`, or give --unit {}=UNIT, with one of {}",
            split(title).0,
            role.name(),
            role.known_units()
        )
    };
    let (factor, angle) = match unit {
        _ if role == Role::Contact => (1.0, false),
        None => return Err(source.refused(format!("the column `{title}` has no unit"), remedy())),
        Some(unit) => match role.factor(unit) {
            Some(factor) => (factor, is_angle(unit)),
            None => {
                return Err(source.refused(format!("the unit `{unit}` of the column `{title}` is not known"), remedy()));
            }
        },
    };
    let named =
        asked.unit(role).filter(|_| written != asked.unit(role)).map_or(String::new(), |unit| format!(", in {unit}"));
    Ok(Column { role, index, factor, title: format!("{title}{named}"), angle })
}

/// The point of a line, and the contact it belongs to.
fn point(
    source: &Source,
    record: &StringRecord,
    columns: &[Column],
    scene: &Scene,
    asked: &Asked,
) -> Result<(usize, Point), Error> {
    let cell =
        |role: Role| columns.iter().find(|column| column.role == role).map(|column| (column, &record[column.index]));
    let number = |role: Role| -> Result<Option<f64>, Error> {
        let Some((column, text)) = cell(role) else { return Ok(None) };
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Some(column.factor * value)),
            // Far from the other side there is no gap.
            Ok(value) if role == Role::Gap && value == f64::INFINITY => Ok(Some(value)),
            _ => {
                let message = format!("`{}` is `{}`, which is no number", column.title, text);
                Err(source.at(
                    record,
                    message,
                    "write a finite number with a decimal point; leave nodes out that have none",
                ))
            }
        }
    };
    let name = cell(Role::Contact).map(|(_, text)| text).or(asked.contact.as_deref());
    let contact = contact_named(scene, name, |message, remedy| source.at(record, message, &remedy))?;
    let pair = &scene.contacts[contact];
    let position = match (number(Role::Position)?, number(Role::X)?, number(Role::Y)?) {
        (Some(position), ..) => {
            let angle = cell(Role::Position).is_some_and(|(column, _)| column.angle);
            if angle == pair.path.is_straight() {
                let [is, wanted] = if angle { ["angles", "mm, m or um"] } else { ["lengths", "deg or rad"] };
                let message =
                    format!("positions are {is}, but the contact runs along {}", along(pair.path.is_straight()));
                return Err(
                    source.refused(message, format!("give positions in {wanted}, or columns `x [mm]` and `y [mm]`"))
                );
            }
            position
        }
        (None, Some(x), Some(y)) => signed_coordinate(pair, [x, y]),
        (None, Some(x), None) if pair.path.is_straight() => signed_coordinate(pair, [x, pair.path.origin()[1]]),
        _ => {
            return Err(source.refused(
                "the contact runs along an arc, and there is no column `y`",
                "add `y [mm]`, or give `position [deg]`",
            ));
        }
    };
    let value = number(Role::Pressure)?.map_or_else(|| number(Role::Force), |pressure| Ok(Some(pressure)))?;
    let value = asked.sign() * value.unwrap_or(f64::NAN);
    Ok((contact, Point { position, value, area: number(Role::Area)?, gap: number(Role::Gap)? }))
}

fn along(straight: bool) -> &'static str {
    if straight { "a straight line" } else { "an arc, from the load line on" }
}
