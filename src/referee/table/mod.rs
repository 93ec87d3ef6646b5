//! Answers as tables: a line of names with their units, then a line a point; separated by commas, semicolons, tabs or
//! blanks.
//!
//! A column is called what it holds, `position [mm]`, `pressure [MPa]`, `force [N]`, `gap [mm]`, `area [mm2]`,
//! `x [mm]`, `y [mm]` or `contact`, or has a name that other programs give it ([`Role::usual`]), or is named by
//! `--column`. A unit stands in its brackets or behind `in`, in a row of units behind the names, or is named by
//! `--unit`; none is guessed. What stands before the names, and comments, are passed over; where a comment is all that
//! stands before the numbers, it has the names. Numbers may have decimal commas, and exponents of Fortran.

mod apart;
mod cells;
mod columns;
mod lines;

use std::collections::BTreeSet;
use std::path::Path;

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, BESIDE, FEWEST, Handed, Point, contact_named};
use crate::referee::asked::Asked;
use crate::referee::profile::handed;
use crate::referee::side::{signed_coordinate, surface};
use crate::referee::source::Source;
use crate::referee::units::{Role, Units, is_angle};
use crate::scene::{ContactPair, Scene};

use apart::{ONE_SIDE, Pressed, apart};
use cells::number;
use columns::{Column, columns};
use lines::{ANOTHER, ONE, Table};

pub use cells::{comment, split};

/// What to do about a line with other cells than the head.
const WRONG_CELLS: &str = "the file is cut, or a cell is missing: write it again; numbers with decimal commas need \
    semicolons between them, or quotes";
/// What to do about numbers of rows that no name stands above.
const ROW_NUMBERS: &str =
    "name the first column too, such as `row`, or write the table without the numbers of its rows";
/// What is said of edges whose areas tell their order.
const BY_AREAS: &str = "corners and mid-sides by turns, of which the areas are";

/// The answer in a text.
pub fn parse(file: &Path, text: &str, scene: &Scene, asked: &Asked) -> Result<Answer, Error> {
    let source = Source { file, text };
    let table = Table::of(&source, asked)?;
    let mut columns = columns(&source, &table.head, scene, asked)?;
    // Of one contact the column may say something else, such as whether it sticks.
    let is_name = |column: &Column| {
        let names = |(_, cells): &(&str, Vec<String>)| cells.get(column.index) == Some(&scene.contacts[0].name);
        column.role != Role::Contact || scene.contacts.len() > 1 || table.rows.iter().any(names)
    };
    let is_asked = asked.contact.is_some() || asked.column(Role::Contact).is_some();
    columns.retain(|column| is_asked || is_name(column));
    let reader = Reader { source, columns, scene, asked, comma: table.comma };
    let (mut groups, mut rows): (Vec<(usize, Vec<Point>)>, Vec<Row>) = Default::default();
    for (k, (line, cells)) in table.rows.iter().enumerate() {
        if cells.len() != table.head.len() {
            let message = format!("this line has {} cells, but the head names {}", cells.len(), table.head.len());
            let is_numbered = cells.len() == table.head.len() + 1 && cells[0].parse::<usize>().is_ok();
            return Err(source.at(line, message, if is_numbered { ROW_NUMBERS } else { WRONG_CELLS }));
        }
        let Some(contact) = reader.contact(line, cells)? else { continue };
        let point = reader.point(contact, line, cells)?;
        match groups.iter_mut().find(|(known, _)| *known == contact) {
            Some((_, points)) => points.push(point),
            None => groups.push((contact, vec![point])),
        }
        rows.push((k, contact, point.position, *line));
    }
    if let Some(line) = another(&rows, |k| table.is_behind_break(text, k)) {
        return Err(source.at(line, ANOTHER, ONE));
    }
    if let (true, Some(name), false) = (groups.is_empty(), &asked.contact, table.rows.is_empty()) {
        let message = format!("it has no line of contact `{name}`");
        return Err(source.refused(message, "name by --contact one that stands in its column `contact`"));
    }
    if groups.is_empty() {
        return Err(source.refused("it has no line behind its head", "the file is cut: write it again"));
    }
    // A depth may tell them apart, and what is not read.
    let is_free = |k: &usize| reader.columns.iter().all(|column| column.index != *k || column.role == Role::Y);
    let free: Vec<usize> = (0..table.head.len()).filter(is_free).collect();
    let of_contact = |(contact, points): &(usize, Vec<Point>)| {
        let own = rows.iter().filter(|row| row.1 == *contact).zip(points);
        let pressed: Vec<Pressed> =
            own.map(|(row, point)| (point.position, point.value, &*table.rows[row.0].1)).collect();
        apart(&table.head, &free, pressed)
    };
    if let Some(message) = groups.iter().find_map(of_contact) {
        return Err(source.refused(message, ONE_SIDE));
    }
    let forces = !reader.columns.iter().any(|column| column.role == Role::Pressure);
    let of_contact = |(contact, points): (usize, Vec<Point>)| {
        handed((scene, contact), points, asked.order, forces, |message, remedy| source.refused(message, remedy))
    };
    let contacts: Vec<Handed> = groups.into_iter().map(of_contact).collect::<Result<_, Error>>()?;
    let is_beside = !forces && table.head.iter().any(|title| asked.means(Role::Force, title));
    let mut read: Vec<String> =
        reader.columns.iter().map(|column| format!("`{}` as {}", column.title, column.role.name())).collect();
    read.extend(is_beside.then(|| BESIDE.to_owned()));
    let of_areas = |one: &Handed| asked.order.is_none() && one.order == Order::Quadratic;
    read.extend(contacts.iter().any(of_areas).then(|| BY_AREAS.to_owned()));
    read.extend(table.states.as_ref().map(|(state, _)| format!("the rows of {state}")));
    let notes = table.states.as_ref().map_or_else(Vec::new, |(state, all)| state.notes(all));
    let unit = |roles: &[Role]| {
        reader.columns.iter().find(|column| roles.contains(&column.role)).and_then(|column| column.unit.clone())
    };
    let units = Units {
        position: unit(&[Role::Position, Role::X]),
        pressure: unit(&[Role::Pressure]),
        force: unit(&[Role::Force]),
        ..Default::default()
    };
    Ok(Answer { file: file.into(), code: None, read, notes, units, contacts, field: None })
}

/// A row as it was read: its number in the table, its contact, its place, and the line.
type Row<'a> = (usize, usize, f64, &'a str);

/// The first of some rows behind a line without numbers, whose places do not go on from those of its contact before it,
/// where both parts are long enough for a profile and reach over one another: the next data set of gnuplot, or the
/// other side of the contact.
fn another<'a>(rows: &[Row<'a>], is_behind_break: impl Fn(usize) -> bool) -> Option<&'a str> {
    let contacts: BTreeSet<usize> = rows.iter().map(|(_, contact, ..)| *contact).collect();
    contacts.into_iter().find_map(|contact| {
        let own: Vec<&Row> = rows.iter().filter(|row| row.1 == contact).collect();
        // Runs of places that go one way, which may begin behind a break only.
        let mut runs: Vec<Vec<&Row>> = Vec::new();
        let mut last = None;
        for row in own {
            let broken = last.is_none_or(|last| (last + 1..=row.0).any(&is_behind_break));
            last = Some(row.0);
            match runs.last_mut().filter(|run| !broken || goes_on(run, row.2)) {
                Some(run) => run.push(row),
                None => runs.push(vec![row]),
            }
        }
        runs.retain(|run| run.len() >= FEWEST);
        let ends = |run: &[&Row]| {
            let places = || run.iter().map(|row| row.2);
            [places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max)]
        };
        let over_one_another = |two: &&[Vec<&Row>]| {
            let [[from, to], [begin, end]] = [ends(&two[0]), ends(&two[1])];
            begin < to && from < end
        };
        runs.windows(2).find(over_one_another).map(|two| two[1][0].3)
    })
}

/// Whether a place goes on from those of a run, which go one way.
fn goes_on(run: &[&Row], place: f64) -> bool {
    match run {
        [.., before, last] => (place - last.2) * (last.2 - before.2) > 0.0,
        _ => true,
    }
}

/// Part of the candidate stretch by which a point may lie off the side, beside the gap there: displaced, or on the
/// other side.
const OFF: f64 = 0.05;
/// What to do about a point that does.
const UNDEFORMED: &str =
    "hand in the points of the contact side alone, in the coordinates of the scene, or leave the column out";

/// How far a point lies off a contact's side \[mm\]; none where that does not matter.
fn off_the_side(scene: &Scene, pair: &ContactPair, point: [f64; 2]) -> Option<f64> {
    let off = (pair.path.depth(point) - surface(scene, pair, point)?).abs();
    let gap = pair.profile.gap(pair.path.coordinate(point)).abs();
    (off > OFF * pair.stretch * pair.path.metric() + gap).then_some(off)
}

/// What turns lines into points.
struct Reader<'a> {
    source: Source<'a>,
    columns: Vec<Column>,
    scene: &'a Scene,
    asked: &'a Asked,
    /// Whether numbers have a decimal comma.
    comma: bool,
}

impl Reader<'_> {
    /// The column of a role; of positions that of the kind of a path, where there are both.
    fn column(&self, role: Role, straight: bool) -> Option<&Column> {
        let all = || self.columns.iter().filter(|column| column.role == role);
        let is_of_path = |column: &&Column| column.unit.as_deref().is_some_and(is_angle) != straight;
        all().find(is_of_path).or_else(|| all().next())
    }

    /// The number of a role in our unit; none where there is no such column.
    fn number(&self, line: &str, cells: &[String], column: Option<&Column>) -> Result<Option<f64>, Error> {
        let Some(column) = column else { return Ok(None) };
        let text = &cells[column.index];
        let mixed = self.comma && text.contains('.');
        match number(text).filter(|_| !mixed) {
            Some(value) if value.is_finite() => Ok(Some(column.factor * value)),
            // Far from the other side there is no gap.
            Some(value) if column.role == Role::Gap && value == f64::INFINITY => Ok(Some(value)),
            _ => {
                let also = if mixed { ": other numbers of the file have a decimal comma" } else { "" };
                let message = format!("`{}` is `{text}`, which is no number{also}", column.title);
                let remedy = "write finite numbers, all with a decimal point or all with a comma, and no mark between \
                    thousands; leave out only nodes beyond the contact";
                Err(self.source.at(line, message, remedy))
            }
        }
    }

    /// The contact that a line belongs to; none of one that is not asked for.
    fn contact(&self, line: &str, cells: &[String]) -> Result<Option<usize>, Error> {
        let asked = self.asked.contact.as_deref();
        let named = self.columns.iter().find(|column| column.role == Role::Contact);
        let own = named.map(|column| cells[column.index].as_str());
        let index = |name| contact_named(self.scene, name, |message, remedy| self.source.at(line, message, remedy));
        let is_other = asked.is_some_and(|asked| own.is_some_and(|own| own != asked));
        let wanted = index(asked.or(own))?;
        Ok(Some(wanted).filter(|_| !is_other))
    }

    /// The other contact on whose candidates a point lies that is beyond those of its own.
    fn elsewhere(&self, own: &ContactPair, place: [f64; 2]) -> Option<&str> {
        let is_on = |pair: &ContactPair| {
            let s = signed_coordinate(pair, place).abs();
            s <= pair.stretch * (1.0 + OFF) && off_the_side(self.scene, pair, place).is_none()
        };
        let other = self.scene.contacts.iter().find(|other| other.name != own.name && is_on(other));
        other.filter(|_| !is_on(own)).map(|other| other.name.as_str())
    }

    /// The point of a line of a contact.
    fn point(&self, contact: usize, line: &str, cells: &[String]) -> Result<Point, Error> {
        let pair = &self.scene.contacts[contact];
        let straight = pair.path.is_straight();
        let column = |role: Role| self.column(role, straight);
        let number = |role: Role| self.number(line, cells, column(role));
        let position = match (number(Role::Position)?, number(Role::X)?, number(Role::Y)?) {
            (Some(position), ..) => {
                if column(Role::Position).and_then(|column| column.unit.as_deref()).is_some_and(is_angle) == straight {
                    let [is, wanted] = if straight { ["angles", "mm, m or um"] } else { ["lengths", "deg or rad"] };
                    let along = if straight { "a straight line" } else { "an arc, from the load line on" };
                    let message = format!("positions are {is}, but the contact runs along {along}");
                    let remedy = format!("give positions in {wanted}, or columns `x [mm]` and `y [mm]`");
                    return Err(self.source.refused(message, remedy));
                }
                position
            }
            (None, Some(x), Some(y)) => {
                if let Some(off) = off_the_side(self.scene, pair, [x, y]) {
                    let title = column(Role::Y).map_or("y", |column| &column.title);
                    let message = format!(
                        "the point {x}, {y} mm, by the column `{title}`, lies {off:.3} mm off the side of contact `{}`",
                        pair.name
                    );
                    return Err(self.source.at(line, message, UNDEFORMED));
                }
                signed_coordinate(pair, [x, y])
            }
            (None, Some(x), None) if straight => signed_coordinate(pair, [x, pair.path.origin()[1]]),
            _ => {
                let message = "the contact runs along an arc, and there is no column `y`";
                return Err(self.source.refused(message, "add `y [mm]`, or give `position [deg]`"));
            }
        };
        let value = number(Role::Pressure)?.map_or_else(|| number(Role::Force), |pressure| Ok(Some(pressure)))?;
        let value = self.asked.sign() * value.unwrap_or(f64::NAN);
        let place = number(Role::X)?.map(|x| Ok([x, number(Role::Y)?.unwrap_or(pair.path.origin()[1])])).transpose()?;
        if let Some((place, other)) = place.and_then(|place| Some((place, self.elsewhere(pair, place)?)))
            && value.abs() > 0.0
        {
            let [x, y] = place;
            let message =
                format!("the point {x}, {y} mm lies on contact `{other}`, beyond the stretch of `{}`", pair.name);
            return Err(self.source.at(
                line,
                message,
                "hand in the points of each contact, which a column `contact` names",
            ));
        }
        Ok(Point { position, value, area: number(Role::Area)?, gap: number(Role::Gap)? })
    }
}
