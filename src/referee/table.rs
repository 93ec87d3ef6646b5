//! Answers as tables: a line of names with their units, then a line a point; separated by commas, semicolons, tabs or blanks.
//!
//! A column is called what it holds, `position [mm]`, `pressure [MPa]`, `force [N]`, `gap [mm]`, `area [mm2]`, `x [mm]`, `y [mm]` or
//! `contact`, or has a name that other programs give it ([`Role::usual`]), or is named by `--column`. A unit stands in its brackets or behind `in`, in a row
//! of units behind the names, or is named by `--unit`; none is guessed. What stands before the names, and comments, are passed over; where a
//! comment is all that stands before the numbers, it has the names. Numbers may have decimal commas, and exponents of Fortran.

use std::collections::BTreeSet;
use std::path::Path;

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Answer, BESIDE, FEWEST, Handed, Point, contact_named};
use crate::referee::asked::Asked;
use crate::referee::profile::handed;
use crate::referee::side::{signed_coordinate, surface};
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::units::{Role, Units, is_angle};
use crate::scene::{ContactPair, Scene};

/// What a file needs.
const HEADER: &str = "begin with a line of names and units such as `position [mm],pressure [MPa]`, or name columns by --column and --unit; where \
                      there are no names, by their numbers, --column position=1 --column pressure=2";
/// What a list of nodes without their places needs.
const PLACES: &str = "it lists nodes by their numbers: write their places beside them, as Abaqus does with COORD, Ansys with LOCX and LOCY; or hand in a \
                      grid, or the .frd";
/// What to do about a line with other cells than the head.
const WRONG_CELLS: &str = "the file is cut, or a cell is missing: write it again; numbers with decimal commas need semicolons between them, or quotes";
/// What to do about numbers of rows that no name stands above.
const ROW_NUMBERS: &str =
    "name the first column too, such as `row`, or write the table without the numbers of its rows";
/// What to do about a second table.
const ONE: &str = "keep the table of the side, step and frame that is to be judged, and remove the others; of one that was printed in pages remove the \
                   lines between them";

/// What to do about a column of times that is none.
const TIMED: &str =
    "write the time of its state as a number beside every point, or leave the column out where all are of one state";

/// What is said of edges whose areas tell their order.
const BY_AREAS: &str = "corners and mid-sides by turns, of which the areas are";

/// A column that is read.
struct Column {
    /// What it holds.
    role: Role,
    /// Its place.
    index: usize,
    /// From its unit to ours.
    factor: f64,
    /// Its name and unit, as it was read.
    title: String,
    /// Its unit; none of names.
    unit: Option<String>,
}

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

/// What separates cells: the mark by which most lines are rows of numbers.
const MARKS: [char; 4] = [';', '\t', ',', ' '];
/// Lines by which what separates cells is found.
const SEEN: usize = 1000;
/// What columns of times are called, by code_aster too.
const TIMES: [&str; 2] = ["time", "inst"];
/// What the coordinates of bodies of revolution are called.
const RADIUS_AND_AXIS: [&str; 2] = ["r", "z"];
/// What places along a line are called, which may begin anywhere: read where there are no coordinates.
const ALONG: [&str; 2] = ["arc_length", "length"];
/// What comments begin with.
const COMMENTS: [&str; 6] = ["#", "%", "!", "//", "$", "*"];
/// What lines below the numbers of a report begin with; `at` where no number follows.
const BELOW: [&str; 4] = ["minimum", "maximum", "total", "at"];

/// A file as names and lines of cells.
struct Table<'a> {
    head: Vec<String>,
    rows: Vec<(&'a str, Vec<String>)>,
    /// Whether numbers have a decimal comma.
    comma: bool,
    /// The time whose rows it has, and all times of the file.
    states: Option<(State, Vec<State>)>,
}

impl<'a> Table<'a> {
    fn of(source: &Source<'a>, asked: &Asked) -> Result<Self, Error> {
        let lines: Vec<&str> = source.text.lines().filter(|line| !is_rule(line)).collect();
        if lines.is_empty() {
            return Err(source.refused("it holds nothing", HEADER));
        }
        let is_data = |line: &str, mark: char| comment(line).is_none() && is_data(&cells(line, mark));
        let rows = |mark: &char| lines.iter().take(SEEN).filter(|line| is_data(line, *mark)).count();
        let most = MARKS.iter().map(rows).max().unwrap_or_default();
        let stands = |mark: &char| lines.first().is_some_and(|line| line.trim().contains(*mark));
        let is_it = |mark: &char| if most > 0 { rows(mark) == most } else { stands(mark) };
        let mark = MARKS.into_iter().find(is_it).unwrap_or(',');
        // Where names stand behind a row or two of numbers, such as counts, and none before these, the rows behind them are the first.
        let is_head = |line: &str| is_head(&cells(comment(line).unwrap_or(line), mark), asked);
        let data = (0..lines.len()).filter(|&k| is_data(lines[k], mark)).take(FEWEST).collect::<Vec<usize>>();
        let headed = || data.iter().copied().find(|&k| k > 0 && is_head(lines[k - 1]));
        let is_plain = data.first().is_some_and(|&first| lines[..first].iter().any(|line| is_head(line)));
        let first = data.first().map(|&first| if is_plain { first } else { headed().unwrap_or(first) });
        // What all rows have behind their last mark is no cell.
        let ends =
            |first: usize| mark != ' ' && lines[first..].iter().take(SEEN).all(|line| line.trim_end().ends_with(mark));
        let count = first.map(|first| cells(lines[first], mark).len() - usize::from(ends(first)));
        let (begin, mut head) = match (head(&lines[..first.unwrap_or(lines.len().min(1))], mark, count, asked), count) {
            (Some((index, head)), _) => (index + 1, head),
            // Names of columns without a head are their numbers.
            (None, Some(count)) if !asked.columns.is_empty() => {
                (first.unwrap_or(0), (1..=count).map(|number| number.to_string()).collect())
            }
            _ => {
                let shown = lines.first().map_or_else(Vec::new, |line| cells(line, mark)).join("`, `");
                return Err(source.refused(format!("its first line holds no names but `{shown}`"), HEADER));
            }
        };
        let names = head.clone();
        let mut rows: Vec<(&str, Vec<String>)> = Vec::new();
        for (k, line) in lines.iter().enumerate().skip(begin) {
            if let Some(said) = comment(line) {
                let own = fitting(said, mark, head.len());
                if first.is_some_and(|first| k < first) && are_units(&own, head.len()) {
                    head = with_units(&head, &own);
                }
                continue;
            }
            let own = fitting(line, mark, head.len());
            // What begins like a number is of a row, which is refused where it is none.
            let is_word = |cell: &String| is_unit(cell) || number(cell).is_none() && !is_like_number(cell);
            match first.is_some_and(|first| k < first) && own.iter().all(is_word) {
                true if own.len() == head.len() && own.iter().any(|cell| is_known_unit(inner(cell))) => {
                    // Units of columns that are not read need not be known.
                    let is_read = |title: &str| {
                        let mut roles = [Role::Position, Role::X, Role::Pressure].into_iter();
                        roles.any(|role| asked.means(role, title))
                    };
                    let unknown = head.iter().zip(&own).find(|(title, cell)| !is_unit(cell) && is_read(title));
                    if let Some((_, unknown)) = unknown {
                        let message = format!("this row of units has `{unknown}`, which is none that is known");
                        let remedy = "write units that `--help` tells, or remove the row and name them by --unit";
                        return Err(source.at(line, message, remedy));
                    }
                    head = with_units(&head, &own);
                }
                // The second line of a head of two.
                true => {}
                false if is_below(line, mark) => {
                    let is_more = |line: &&&str| {
                        is_data(line, mark)
                            && !is_below(line, mark)
                            && fitting(line, mark, head.len()).len() == head.len()
                    };
                    if let Some(more) = lines[k..].iter().find(is_more) {
                        return Err(source.at(more, ANOTHER, ONE));
                    }
                    break;
                }
                false if own == names => return Err(source.at(line, ANOTHER, ONE)),
                false => rows.push((line, own)),
            }
        }
        // ParaView writes zeros where a line leaves the grid, and masks them.
        if let Some(mask) = head.iter().position(|title| title.eq_ignore_ascii_case("vtkValidPointMask")) {
            rows.retain(|(_, cells)| cells.get(mask).and_then(|cell| number(cell)) != Some(0.0));
        }
        // Of several times the last one is judged, as of grids.
        let column = head.iter().position(|title| TIMES.iter().any(|time| split(title).0.eq_ignore_ascii_case(time)));
        if asked.has_state() && column.is_none() {
            return Err(State::only(source.file));
        }
        let mut chosen = None;
        if let Some(column) = column.filter(|_| !rows.is_empty()) {
            let time =
                |cells: &[String]| cells.get(column).and_then(|cell| number(cell)).filter(|time| time.is_finite());
            if let Some((line, cells)) = rows.iter().find(|(_, cells)| time(cells).is_none()) {
                let own = cells.get(column).map_or("", String::as_str);
                let message = format!("`{}` is `{own}`, which is no number", head[column]);
                return Err(source.at(line, message, TIMED));
            }
            let time = |cells: &[String]| time(cells).unwrap_or(f64::NAN);
            let mut states: Vec<State> =
                rows.iter().map(|(_, cells)| State { step: None, time: time(cells) }).collect();
            let last = states.iter().map(|state| state.time).fold(f64::NEG_INFINITY, f64::max);
            states.dedup_by(|a, b| a.is_at(b.time));
            let asked = Asked { time: asked.time.or(Some(last)), ..asked.clone() };
            let state = states[State::chosen(source, &states, &asked)?];
            rows.retain(|(_, cells)| state.is_at(time(cells)));
            if rows.len() < FEWEST {
                let message = format!("{} of its rows are of {state}, and a profile needs {FEWEST}", rows.len());
                return Err(source.refused(message, TIMED));
            }
            chosen = Some((state, states));
        }
        // Where commas separate cells, one within a cell stood in quotes.
        let has_comma = |cell: &String| cell.contains(',') && number(&cell.replace([',', '.'], "")).is_some();
        // A list in a column that is not read is none.
        let is_read = |k: usize| {
            let is = |role: &Role| {
                let number = asked.column(*role).and_then(|column| column.parse().ok());
                head.get(k).is_none_or(|title| asked.means(*role, title)) || number == Some(k + 1)
            };
            Role::OF_TABLES.iter().any(is)
        };
        let commas = || {
            let all = rows.iter().flat_map(|(line, own)| own.iter().enumerate().map(move |(k, cell)| (k, line, cell)));
            all.filter(|(k, _, cell)| has_comma(cell) && is_read(*k)).map(|(_, line, cell)| (line, cell))
        };
        let comma = commas().next().is_some();
        let has_marks = |(_, cell): &(_, &String)| cell.matches(',').count() > 1;
        let may_be = || commas().next().filter(|_| commas().all(|(_, cell)| is_of_thousands(cell)));
        if let Some((line, cell)) = commas().find(has_marks).or_else(may_be) {
            let message = format!("`{cell}` may be a number with a decimal comma, or one with marks between thousands");
            return Err(source.at(line, message, "write numbers with a decimal point, and no mark between thousands"));
        }
        Ok(Self { head, rows, comma, states: chosen })
    }
}

impl Table<'_> {
    /// Whether a line without numbers, or a blank one, stands before a row.
    fn is_behind_break(&self, text: &str, k: usize) -> bool {
        let begin = |k: usize| self.rows[k].0.as_ptr() as usize - text.as_ptr() as usize;
        let before = k.checked_sub(1).map_or(0, |before| begin(before) + self.rows[before].0.len());
        let between = text.get(before..begin(k)).unwrap_or_default();
        between.trim_start_matches('\r').strip_prefix('\n').is_some_and(|between| !between.is_empty())
    }
}

/// What is said of a second table.
const ANOTHER: &str = "this line begins another table";

/// Whether a line only rules a table off.
fn is_rule(line: &str) -> bool {
    line.chars().all(|mark| "-=+|,; \t\u{c}".contains(mark))
}

/// A row as it was read: its number in the table, its contact, its place, and the line.
type Row<'a> = (usize, usize, f64, &'a str);

/// The first of some rows behind a line without numbers, whose places do not go on from those of its contact before it, where both parts are long
/// enough for a profile and reach over one another: the next data set of gnuplot, or the other side of the contact.
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

/// Whether a comma may stand between thousands: up to three digits before it, the first not 0, and three behind.
fn is_of_thousands(cell: &str) -> bool {
    let are_digits = |text: &str| text.bytes().all(|letter| letter.is_ascii_digit());
    cell.trim_start_matches(['+', '-', '−']).split_once(',').is_some_and(|(before, behind)| {
        (1..4).contains(&before.len())
            && behind.len() == 3
            && !before.starts_with('0')
            && are_digits(before)
            && are_digits(behind)
    })
}

/// Whether a line is a row of units for so many columns.
fn are_units(cells: &[String], wanted: usize) -> bool {
    cells.len() == wanted && cells.iter().all(|cell| is_unit(cell))
}

/// Names with the units of a row.
fn with_units(head: &[String], units: &[String]) -> Vec<String> {
    let one = |(name, unit): (&String, &String)| match split(name).1 {
        Some(own) if own == inner(unit) => name.clone(),
        _ => format!("{name} [{}]", inner(unit)),
    };
    head.iter().zip(units).map(one).collect()
}

/// Whether cells are names of a place and of what presses there.
fn is_head(cells: &[String], asked: &Asked) -> bool {
    let has = |roles: [Role; 2]| roles.iter().any(|role| cells.iter().any(|title| asked.means(*role, title)));
    has([Role::Position, Role::X]) && has([Role::Pressure, Role::Force])
}

/// The line of names and its place: the last above the numbers that names a place and what presses there; else the last with as many cells as
/// they have, a comment where there is no other; else the last.
fn head(above: &[&str], mark: char, count: Option<usize>, asked: &Asked) -> Option<(usize, Vec<String>)> {
    let candidate = |(k, line): (usize, &&str)| {
        let fit = |mark: char| fitting(comment(line).unwrap_or(line), mark, count.unwrap_or(0));
        // Names may have blanks between where numbers have commas.
        let blank = Some(fit(' ')).filter(|names| Some(names.len()) == count && is_head(names, asked));
        let names = Some(fit(mark)).filter(|names| Some(names.len()) == count).or(blank).unwrap_or_else(|| fit(mark));
        let is_no_name = |cell: &String| is_unit(cell) || number(cell).is_some();
        (!names.iter().all(is_no_name) && count.is_none_or(|count| names.len() == count)).then_some((k, names))
    };
    let all: Vec<(usize, Vec<String>)> = above.iter().enumerate().filter_map(candidate).collect();
    let known = all.iter().rfind(|(_, head)| is_head(head, asked));
    let is_plain = |k: usize| comment(above[k]).is_none();
    let last = || all.iter().rfind(|(k, _)| is_plain(*k)).or(all.last());
    let any = || (0..above.len()).rev().find(|k| is_plain(*k)).map(|k| (k, cells(above[k], mark)));
    known.or_else(last).cloned().or_else(any)
}

/// Whether a line stands below the numbers of a report.
fn is_below(line: &str, mark: char) -> bool {
    let mut words = line.split(|letter: char| letter == mark || letter.is_whitespace()).filter(|word| !word.is_empty());
    let word = words.next().unwrap_or_default().trim_matches('"').to_lowercase();
    // `At Node 12`, and no point that is called `at 12`.
    let is_called = word == "at" && words.next().is_some_and(|next| number(next).is_some());
    BELOW.contains(&word.as_str()) && !is_called
}

/// What stands behind the mark of a comment; none of a line that is none.
pub fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let mark = COMMENTS.iter().find(|mark| line.starts_with(**mark))?;
    Some(line[mark.len()..].trim_start_matches(*mark).trim())
}

/// The cells of a line, without blanks and quotes around them; where blanks separate them, a unit in brackets belongs to the name before it.
fn cells(line: &str, mark: char) -> Vec<String> {
    let (mut all, mut quoted, mut deep) = (vec![String::new()], false, 0);
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
        while let Some(k) = (2..all.len()).find(|&k| all[k - 1] == "in" && is_known_unit(&all[k])) {
            let unit = all.drain(k - 1..=k).collect::<Vec<_>>().join(" ");
            all[k - 2] += &format!(" {unit}");
        }
    }
    all
}

/// The cells of a line, as many as wanted where blanks separate them: names of several words have two blanks or more between them.
fn fitting(line: &str, mark: char, wanted: usize) -> Vec<String> {
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

/// Whether the cells are those of a row: two numbers or more, and fewer names.
fn is_data(cells: &[String]) -> bool {
    let (numbers, others): (Vec<&String>, Vec<&String>) =
        cells.iter().partition(|cell| number(cell).is_some_and(f64::is_finite));
    numbers.len() > 1.max(others.len())
        && others.iter().all(|cell| !cell.starts_with(|first: char| first.is_ascii_digit()))
}

/// A number with a point or a comma; its exponent may begin with the D of Fortran.
fn number(cell: &str) -> Option<f64> {
    let plain = cell.replace(['D', 'd'], "E").replace('−', "-");
    // Where both stand in it, one may be between thousands.
    if plain.contains(',') && plain.contains('.') { None } else { plain.replacen(',', ".", 1).parse().ok() }
}

/// Whether a cell begins as numbers do, or stands for one that is not there.
fn is_like_number(cell: &str) -> bool {
    let plain = cell.trim_start_matches(['+', '-', '−']).trim_start_matches(['.', ',']);
    plain.starts_with(|first: char| first.is_ascii_digit()) || cell.eq_ignore_ascii_case("n/a")
}

/// What stands within brackets, where a cell is in any.
fn inner(cell: &str) -> &str {
    cell.trim_matches(|mark: char| "[]() ".contains(mark))
}

/// Whether a cell is a unit, or says that there is none.
fn is_unit(cell: &str) -> bool {
    ["", "-", "–", "1"].contains(&inner(cell)) || is_known_unit(inner(cell))
}

fn is_known_unit(name: &str) -> bool {
    Role::ALL.iter().any(|role| role.factor(name).is_some())
}

/// Whether it is written as units are, known or not: a quotient, a power, or a known one in other letters.
fn is_like_unit(name: &str) -> bool {
    let mut known = Role::ALL.iter().flat_map(|role| role.units());
    name.contains(['/', '^', '²']) || known.any(|(known, _)| known.eq_ignore_ascii_case(name))
}

/// Name and unit of a column: `pressure [MPa]`, `pressure (MPa)`, `pressure / MPa`, `pressure in MPa` or `pressure_MPa`.
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
    inside('[', ']')
        .or_else(|| inside('(', ')'))
        .or_else(over)
        .or_else(within)
        .or_else(close)
        .or_else(joined)
        .unwrap_or((title.trim(), None))
}

/// Whether a column has a name in small letters; COMSOL puts the pair of the contact behind it.
fn is_called(title: &str, name: &str) -> bool {
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
    fn means(&self, role: Role, title: &str) -> bool {
        self.names(role, title) || role.usual().iter().any(|name| is_called(title, name))
    }
}

/// The columns that are read, by what they hold. Others are passed over, and asked for no unit.
fn columns(source: &Source, head: &[String], scene: &Scene, asked: &Asked) -> Result<Vec<Column>, Error> {
    let shown = || head.iter().map(|title| format!("`{title}`")).collect::<Vec<_>>().join(", ");
    let of = |is_it: &dyn Fn(&str) -> bool| (0..head.len()).filter(|&k| is_it(&head[k])).collect::<Vec<usize>>();
    let is_of_angles = |k: usize| split(&head[k]).1.is_some_and(is_angle);
    // By title, or by its number where no title is it.
    let named = |role: Role| -> Vec<usize> {
        let all = of(&|title: &str| asked.names(role, title));
        let number = || asked.column(role)?.parse().ok().filter(|k| (1..=head.len()).contains(k)).map(|k: usize| k - 1);
        if all.is_empty() { number().into_iter().collect() } else { all }
    };
    let mut found: Vec<(Role, usize)> = Vec::new();
    for role in Role::OF_TABLES {
        // What is named for one role has no other, and what is named is not passed over for what is called as usual.
        let is_taken = |k: &usize| Role::OF_TABLES.iter().any(|other| *other != role && named(*other).contains(k));
        let usual = |name: &&str| -> Vec<usize> {
            of(&|title: &str| is_called(title, name)).into_iter().filter(|k| !is_taken(k)).collect()
        };
        let is_passed_over = match role {
            Role::Pressure => asked.column(Role::Force).is_some(),
            Role::Position => asked.column(Role::X).is_some(),
            _ => false,
        };
        let all = match asked.column(role) {
            Some(_) => named(role),
            None if is_passed_over => Vec::new(),
            None => {
                let has_x = head.iter().any(|title| asked.means(Role::X, title));
                let is_other = |name: &str| RADIUS_AND_AXIS.contains(&name) || has_x && ALONG.contains(&name);
                let plain = role.usual().iter().copied().filter(|name| !is_other(name));
                // What x and y are of bodies of revolution.
                let own = scene.plane.radial().and_then(|radial| match role {
                    Role::X => Some(RADIUS_AND_AXIS[radial]),
                    Role::Y => Some(RADIUS_AND_AXIS[1 - radial]),
                    _ => None,
                });
                plain.chain(own).map(|name| usual(&name)).find(|all| !all.is_empty()).unwrap_or_default()
            }
        };
        match (all.as_slice(), asked.column(role)) {
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
                let (message, first) =
                    (format!("more than one column is called {}: {}", role.name(), shown()), first + 1);
                let remedy = format!(
                    "name it by --column, with its unit or by its number, as in --column {}={first}",
                    role.name()
                );
                return Err(source.refused(message, remedy));
            }
        }
    }
    let has = |role: Role| found.iter().any(|(known, _)| *known == role);
    if !has(Role::Position) && !has(Role::X) {
        let is_list = head.first().is_some_and(|title| title.to_lowercase().starts_with("node"));
        let remedy = if is_list { PLACES } else { HEADER };
        return Err(source.refused(format!("no column is called `position` or `x`, but {}", shown()), remedy));
    }
    if !has(Role::Pressure) && !has(Role::Force) {
        return Err(source.refused(format!("no column is called `pressure` or `force`, but {}", shown()), HEADER));
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

/// Part of the candidate stretch by which a point may lie off the side, beside the gap there: displaced, or on the other side.
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
                let remedy = "write finite numbers, all with a decimal point or all with a comma, and no mark between thousands; leave out only nodes beyond the contact";
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
        Ok(Point { position, value, area: number(Role::Area)?, gap: number(Role::Gap)? })
    }
}
