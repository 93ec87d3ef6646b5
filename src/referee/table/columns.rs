//! Which columns of a table are read, and in which units.

use crate::error::Error;
use crate::referee::asked::Asked;
use crate::referee::source::Source;
use crate::referee::table::cells::{is_like_unit, split, unknown_unit};
use crate::referee::units::{Role, is_angle};
use crate::scene::Scene;

/// What a file needs.
pub(super) const HEADER: &str = "begin with a line of names and units such as `position [mm],pressure [MPa]`, or name \
    columns by --column and --unit; where there are no names, by their numbers, --column position=1 --column \
    pressure=2";
/// What a list of nodes without their places needs.
const PLACES: &str = "it lists nodes by their numbers: write their places beside them, as Abaqus does with COORD, \
    Ansys with LOCX and LOCY; or hand in a grid, or the .frd";
/// What the coordinates of bodies of revolution are called.
const RADIUS_AND_AXIS: [&str; 2] = ["r", "z"];
/// What places along a line are called, which may begin anywhere: read where there are no coordinates.
const ALONG: [&str; 7] =
    ["arc_length", "arc length", "length", "distance", "true distance along path", "theta", "angle"];

/// A column that is read.
pub(super) struct Column {
    /// What it holds.
    pub(super) role: Role,
    /// Its place.
    pub(super) index: usize,
    /// From its unit to ours.
    pub(super) factor: f64,
    /// Its name and unit, as it was read.
    pub(super) title: String,
    /// Its unit; none of names.
    pub(super) unit: Option<String>,
}

/// Whether a column has a name in small letters; COMSOL puts the pair of the contact behind it.
pub(super) fn is_called(title: &str, name: &str) -> bool {
    let own = split(title).0.to_lowercase().replace('-', " ");
    let is_of_pair =
        |rest: &str| rest.starts_with(", contact pair") || name.starts_with("solid.") && rest.starts_with('_');
    own.strip_prefix(name).is_some_and(|rest| rest.is_empty() || is_of_pair(rest))
}

impl Asked {
    /// Whether a title is the column that was named for a role.
    fn names(&self, role: Role, title: &str) -> bool {
        self.column(role).is_some_and(|named| named == title || named == split(title).0)
    }

    /// Whether a title is that, or one of the usual names of the role.
    pub(super) fn means(&self, role: Role, title: &str) -> bool {
        self.names(role, title) || role.usual().iter().any(|name| is_called(title, name))
    }
}

impl Asked {
    /// A title with the unit of all lengths, where it is that of a coordinate without one.
    pub(super) fn in_unit(&self, title: String, unit: &str) -> String {
        let is_length = [Role::Position, Role::X, Role::Y].into_iter().any(|role| self.means(role, &title));
        if is_length && split(&title).1.is_none() { format!("{title} [{unit}]") } else { title }
    }
}

/// The columns that are read, by what they hold. Others are passed over, and asked for no unit.
pub(super) fn columns(source: &Source, head: &[String], scene: &Scene, asked: &Asked) -> Result<Vec<Column>, Error> {
    let shown = || head.iter().map(|title| format!("`{title}`")).collect::<Vec<_>>().join(", ");
    let is_of_angles = |k: usize| split(&head[k]).1.is_some_and(is_angle);
    let mut found: Vec<(Role, usize)> = Vec::new();
    for role in Role::OF_TABLES {
        match (of_role(role, head, scene, asked).as_slice(), asked.column(role)) {
            ([], None) => {}
            ([], Some(named)) => {
                let message = format!("there is no column `{named}` among {}", shown());
                return Err(source.refused(message, format!("name the column of {} by --column", role.name())));
            }
            ([index], _) => found.push((role, *index)),
            // Of contacts along straight lines and along arcs, as our own table has them.
            ([a, b], None) if role == Role::Position && is_of_angles(*a) != is_of_angles(*b) => {
                found.extend([(role, *a), (role, *b)]);
            }
            ([first, ..], _) => {
                let (name, first) = (role.name(), first + 1);
                let message = format!("more than one column is called {name}: {}", shown());
                let remedy =
                    format!("name it by --column, with its unit or by its number, as in --column {name}={first}");
                return Err(source.refused(message, remedy));
            }
        }
    }
    let has = |role: Role| found.iter().any(|(known, _)| *known == role);
    if !has(Role::Position) && !has(Role::X) {
        let is_list = head.first().is_some_and(|title| title.to_lowercase().starts_with("node"));
        let remedy = if is_list { PLACES } else { HEADER };
        let unknown = unknown(head, [Role::Position, Role::X]);
        return Err(source.refused(format!("no column is called `position` or `x`, but {}{unknown}", shown()), remedy));
    }
    if !has(Role::Pressure) && !has(Role::Force) {
        let unknown = unknown(head, [Role::Pressure, Role::Force]);
        let message = format!("no column is called `pressure` or `force`, but {}{unknown}", shown());
        return Err(source.refused(message, HEADER));
    }
    let unit = |role: Role| {
        let own = found.iter().find(|(known, _)| *known == role).and_then(|(_, index)| split(&head[*index]).1);
        own.filter(|unit| role.factor(unit).is_some()).or(asked.unit(role))
    };
    let is_used = |role: Role| match role {
        Role::X | Role::Y => !has(Role::Position),
        Role::Force => !has(Role::Pressure),
        _ => true,
    };
    let used = found.iter().filter(|(role, _)| is_used(*role));
    // Where y has no unit, it has that of x.
    let named = |role: Role| match asked.unit(role) {
        None if role == Role::Y && unit(role).is_none() => unit(Role::X),
        own => own,
    };
    used.map(|&(role, index)| column(source, role, index, &head[index], named(role))).collect()
}

/// What is said of a name that one of these roles usually has, with a unit behind it that is not known.
fn unknown(head: &[String], roles: [Role; 2]) -> String {
    let of = |role: Role| head.iter().find_map(move |title| Some((role, title, unknown_unit(title, role)?)));
    let says = |(role, title, unit): (Role, &String, &str)| {
        format!("; the unit `{unit}` of `{title}` is not known, as {} are", role.known_units())
    };
    roles.into_iter().find_map(of).map_or_else(String::new, says)
}

/// The columns that are named for a role, by title, or by number where no title is it.
fn named(role: Role, head: &[String], asked: &Asked) -> Vec<usize> {
    let all: Vec<usize> = (0..head.len()).filter(|&k| asked.names(role, &head[k])).collect();
    let number = || asked.column(role)?.parse().ok().filter(|k| (1..=head.len()).contains(k)).map(|k: usize| k - 1);
    if all.is_empty() { number().into_iter().collect() } else { all }
}

/// The columns of a role: those named for it, or else those of the first usual name that any has.
fn of_role(role: Role, head: &[String], scene: &Scene, asked: &Asked) -> Vec<usize> {
    if asked.column(role).is_some() {
        return named(role, head, asked);
    }
    let is_passed_over = match role {
        Role::Pressure => asked.column(Role::Force).is_some(),
        Role::Position => asked.column(Role::X).is_some(),
        _ => false,
    };
    if is_passed_over {
        return Vec::new();
    }
    // What is named for one role has no other, and what is named is not passed over for what is called as usual.
    let is_taken =
        |k: usize| Role::OF_TABLES.iter().any(|other| *other != role && named(*other, head, asked).contains(&k));
    let usual =
        |name: &str| -> Vec<usize> { (0..head.len()).filter(|&k| is_called(&head[k], name) && !is_taken(k)).collect() };
    let has_x = head.iter().any(|title| asked.means(Role::X, title));
    let is_other = |name: &str| RADIUS_AND_AXIS.contains(&name) || has_x && ALONG.contains(&name);
    let plain = role.usual().iter().copied().filter(|name| !is_other(name));
    // What x and y are of bodies of revolution.
    let own = scene.plane.radial().and_then(|radial| match role {
        Role::X => Some(RADIUS_AND_AXIS[radial]),
        Role::Y => Some(RADIUS_AND_AXIS[1 - radial]),
        _ => None,
    });
    plain.chain(own).map(usual).find(|all| !all.is_empty()).unwrap_or_default()
}

/// One column with its unit: that of the file, or the one that is named; where both are there they are one.
fn column(source: &Source, role: Role, index: usize, title: &str, named: Option<&str>) -> Result<Column, Error> {
    let written = split(title).1;
    // What brackets hold may be no unit: `pressure (nodal)`.
    let says_unit = |unit: &&str| role.factor(unit).is_some() || title.ends_with(']') || is_like_unit(unit);
    let written = written.filter(|unit| named.is_none() || says_unit(unit));
    let what = format!("the column `{title}`");
    let factor = if role == Role::Contact { 1.0 } else { source.factor(role, &what, written, named)? };
    let said = named.filter(|_| written.is_none()).map_or_else(String::new, |named| format!(", in {named}"));
    Ok(Column { role, index, factor, title: format!("{title}{said}"), unit: written.or(named).map(str::to_owned) })
}
