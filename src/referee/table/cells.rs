//! Cells of a line: numbers, names and units.

use std::borrow::Cow;

use crate::referee::units::Role;

/// What comments begin with.
const COMMENTS: [&str; 7] = ["#", "%", "!", "//", "$", "*", "\\"];
/// What stands behind the mark of a comment; none of a line that is none.
pub fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let mark = COMMENTS.iter().find(|mark| line.starts_with(**mark))?;
    Some(line[mark.len()..].trim_start_matches(*mark).trim())
}

/// What spreadsheets write where a cell has no number.
const NO_NUMBER: [&str; 12] = [
    "#N/A", "#NV", "#NUM!", "#ZAHL!", "#DIV/0!", "#REF!", "#BEZUG!", "#VALUE!", "#WERT!", "#NULL!", "#NAME?",
    "#VALEUR!",
];

/// Whether a line that begins as comments do is a row of so many cells, of which the first is no number: one of
/// [`NO_NUMBER`], or marks alone, as where a number was too wide; where blanks separate cells a mark alone is one of a
/// comment.
pub(super) fn is_marked_row(line: &str, mark: char, wanted: usize) -> bool {
    let own = fitting(line, mark, wanted);
    let [first, others @ ..] = &own[..] else { return false };
    let is_marks = comment(first) == Some("") && (mark != ' ' || first.len() > 1);
    let is_none = NO_NUMBER.contains(&first.to_uppercase().as_str()) || is_marks;
    own.len() == wanted && is_none && others.iter().any(|cell| number(cell).is_some())
}

/// The cells of a line, without blanks and quotes around them; where blanks separate them, a unit in brackets belongs
/// to the name before it.
pub(super) fn cells(line: &str, mark: char) -> Vec<String> {
    let (mut all, mut quoted, mut deep) = (vec![String::new()], false, 0);
    // Rows of LaTeX have their own end, and formulas within dollars.
    let latex = || line.split(r"\\").next().unwrap_or_default().replace('$', "");
    let line: Cow<str> = if mark == '&' { latex().into() } else { line.into() };
    for letter in line.trim_matches([' ', '\r']).chars() {
        quoted ^= letter == '"';
        deep += match letter {
            '[' | '(' if mark == ' ' => 1,
            ']' | ')' if mark == ' ' => -1,
            _ => 0,
        };
        match all.last_mut() {
            _ if (letter == mark || mark == ' ' && letter == '\t') && !quoted && deep <= 0 => all.push(String::new()),
            Some(last) if letter != '"' => last.push(letter),
            _ => {}
        }
    }
    let mut all: Vec<String> = all.into_iter().map(|cell| cell.trim().to_owned()).collect();
    if mark == ' ' {
        all.retain(|cell| !cell.is_empty());
        while let Some(k) = (1..all.len()).find(|&k| all[k].starts_with(['[', '('])) {
            let unit = all.remove(k);
            all[k - 1] += &format!(" {unit}");
        }
        // In a row of units it is the inch.
        let is_of_name = |three: &[String]| three[1] == "in" && is_known_unit(&three[2]) && !is_unit(&three[0]);
        while let Some(k) = (2..all.len()).find(|&k| is_of_name(&all[k - 2..=k])) {
            let unit = all.drain(k - 1..=k).collect::<Vec<_>>().join(" ");
            all[k - 2] += &format!(" {unit}");
        }
    }
    all
}

/// The cells of a line, as many as wanted where blanks separate them: names of several words have two blanks or more
/// between them.
pub(super) fn fitting(line: &str, mark: char, wanted: usize) -> Vec<String> {
    let mut own = cells(line, mark);
    // Fortran, and Excel, put a mark behind the last cell too.
    own.truncate(own.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1).max(wanted));
    if mark != ' ' || own.len() == wanted {
        return own;
    }
    let apart: Vec<String> =
        line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_owned).collect();
    // Names of several words with a unit behind each have one blank between them too.
    let behind: Vec<String> = line.split_inclusive([']', ')']).map(|cell| cell.trim().to_owned()).collect();
    [apart, behind].into_iter().find(|cells| cells.len() == wanted).unwrap_or(own)
}

/// Whether the cells are those of a row: two numbers or more, and fewer names, or as many cells as are wanted.
pub(super) fn is_data(cells: &[String], wanted: &[usize]) -> bool {
    let (numbers, others): (Vec<&String>, Vec<&String>) =
        cells.iter().partition(|cell| number(cell).is_some_and(f64::is_finite));
    numbers.len() > 1
        && (numbers.len() > others.len() || wanted.contains(&cells.len()))
        && others.iter().all(|cell| !cell.starts_with(|first: char| first.is_ascii_digit()))
}

/// A number with a point or a comma; its exponent may begin with the D of Fortran, or with its sign where that of
/// Fortran has three digits.
pub(super) fn number(cell: &str) -> Option<f64> {
    let plain = cell.replace(['D', 'd'], "E").replace('−', "-");
    // Where both stand in it, one may be between thousands.
    if plain.contains(',') && plain.contains('.') {
        return None;
    }
    let plain = plain.replacen(',', ".", 1);
    let signed = || {
        let (own, power) = plain.split_at(plain.rfind(['+', '-'])?);
        let is_it = own.contains('.') && POWERS.contains(&power.len());
        format!("{own}E{power}").parse().ok().filter(|_| is_it)
    };
    plain.parse().ok().or_else(signed)
}

/// Letters of a power of ten that stands behind a number without an E: its sign, and two or three digits.
const POWERS: [usize; 2] = [3, 4];

/// Whether a cell begins as numbers do, or stands for one that is not there.
pub(super) fn is_like_number(cell: &str) -> bool {
    let plain = cell.trim_start_matches(['+', '-', '−']).trim_start_matches(['.', ',']);
    plain.starts_with(|first: char| first.is_ascii_digit()) || cell.eq_ignore_ascii_case("n/a")
}

/// What stands within brackets, where a cell is in any.
pub(super) fn inner(cell: &str) -> &str {
    cell.trim_matches(|mark: char| "[]() ".contains(mark))
}

/// Whether a cell is a unit, or says that there is none.
pub(super) fn is_unit(cell: &str) -> bool {
    ["", "-", "–", "1"].contains(&inner(cell)) || is_known_unit(inner(cell))
}

pub(super) fn is_known_unit(name: &str) -> bool {
    Role::ALL.iter().any(|role| role.factor(name).is_some())
}

/// Whether it is written as units are, known or not: a quotient, a power, a known one in other letters, or one with a
/// factor before it.
pub(super) fn is_like_unit(name: &str) -> bool {
    let mut known = Role::ALL.iter().flat_map(|role| role.units());
    name.contains(['/', '^', '²']) || has_factor(name) || known.any(|(known, _)| known.eq_ignore_ascii_case(name))
}

/// Whether it is a known unit with a number before it, as `1e3 MPa`.
fn has_factor(name: &str) -> bool {
    let parts = name.rsplit_once([' ', '*', '·', '×']);
    parts.is_some_and(|(factor, unit)| is_known_unit(unit) && factor.contains(|letter: char| letter.is_ascii_digit()))
}

/// The name before the last brackets that hold a known unit, or else one with a factor, whatever stands behind them:
/// `pressure [kPa] (nodal)`, `solid.Tn (MPa) @ t=1`.
fn in_brackets(title: &str) -> Option<(&str, Option<&str>)> {
    let (mut found, mut with_factor, mut from) = (None, None, 0);
    while let Some(open) = title[from..].find(['[', '(']).map(|open| from + open) {
        let close = if title[open..].starts_with('[') { ']' } else { ')' };
        let Some(end) = title[open..].find(close).map(|end| open + end) else { break };
        let unit = title[open + 1..end].trim();
        let both = (title[..open].trim(), Some(unit));
        found = is_known_unit(unit).then_some(both).or(found);
        with_factor = has_factor(unit).then_some(both).or(with_factor);
        from = end + 1;
    }
    found.or(with_factor)
}

/// What stands behind the name that a column usually has, where units do and it is none that is known.
pub(super) fn unknown_unit(title: &str, role: Role) -> Option<&str> {
    let behind = |name: &&str| {
        let rest = title.get(name.len()..).filter(|_| title.to_lowercase().starts_with(*name))?;
        ["_", "/", " in "].iter().find_map(|mark| rest.strip_prefix(mark)).filter(|unit| !unit.is_empty())
    };
    role.usual().iter().find_map(behind)
}

/// Name and unit of a column: `pressure [MPa]`, `pressure (MPa)`, `pressure / MPa`, `pressure in MPa` or
/// `pressure_MPa`.
pub fn split<'a>(title: &'a str) -> (&'a str, Option<&'a str>) {
    let inside = |open: char, close: char| {
        let (name, rest) = title.rsplit_once(open)?;
        Some((name.trim(), Some(rest.trim().strip_suffix(close)?.trim()).filter(|unit| !unit.is_empty())))
    };
    let over = || title.split_once(" / ").map(|(name, unit)| (name.trim(), Some(unit.trim())));
    let known = |mark: char, (name, unit): (&'a str, &'a str)| {
        // `x_in` may be what goes in.
        let is_it = !name.is_empty() && is_known_unit(unit) && (mark, unit) != ('_', "in");
        is_it.then(|| (name.trim(), Some(unit.trim())))
    };
    let close = || title.split_once('/').and_then(|both| known('/', both));
    let joined = || title.rsplit_once('_').and_then(|both| known('_', both));
    let words = || title.rsplit_once(" in ").filter(|(_, unit)| is_known_unit(unit));
    let within = || words().map(|(name, unit)| (name.trim(), Some(unit.trim())));
    in_brackets(title)
        .or_else(|| inside('[', ']'))
        .or_else(|| inside('(', ')'))
        .or_else(over)
        .or_else(within)
        .or_else(close)
        .or_else(joined)
        .unwrap_or((title.trim(), None))
}

/// Whether a comma may stand between thousands: up to three digits before it, the first not 0, and three behind.
pub(super) fn is_of_thousands(cell: &str) -> bool {
    let are_digits = |text: &str| text.bytes().all(|letter| letter.is_ascii_digit());
    cell.trim_start_matches(['+', '-', '−']).split_once(',').is_some_and(|(before, behind)| {
        (1..4).contains(&before.len())
            && behind.len() == 3
            && !before.starts_with('0')
            && are_digits(before)
            && are_digits(behind)
    })
}

/// Whether a line only rules a table off.
pub(super) fn is_rule(line: &str) -> bool {
    line.chars().all(|mark| "-=+|,; \t\u{c}".contains(mark))
}
