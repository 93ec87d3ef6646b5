//! Lines of a table as names and rows of cells: what separates them, where the names stand, and which rows are of the
//! state that is judged.

use std::collections::BTreeSet;

use crate::error::Error;
use crate::referee::answer::FEWEST;
use crate::referee::asked::Asked;
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::table::cells::{
    cells, comment, fitting, inner, is_data, is_known_unit, is_like_number, is_marked_row, is_of_thousands, is_rule,
    is_unit, number, split,
};
use crate::referee::table::columns::HEADER;
use crate::referee::units::Role;

/// What to do about a second table.
pub(super) const ONE: &str = "keep the table of the side, step and frame that is to be judged, and remove the others; \
    of one that was printed in pages remove the lines between them";

/// What to do about a column of times that is none.
const TIMED: &str =
    "write the time of its state as a number beside every point, or leave the column out where all are of one state";

/// What to do about rows of several states.
const KEEP: &str = "name one of them by --time, or keep the rows of the state that is to be judged alone";

/// What separates cells: the mark by which most lines are rows of numbers.
const MARKS: [char; 5] = ['&', ';', '\t', ',', ' '];
/// Lines by which what separates cells is found.
const SEEN: usize = 1000;
/// What columns of times are called, by code_aster and Ansys too.
const TIMES: [&str; 3] = ["time", "inst", "time/freq"];
/// What columns are called that tell states by their numbers.
const STATES: [&str; 13] = [
    "step",
    "frame",
    "increment",
    "inc",
    "substep",
    "load step",
    "loadstep",
    "timestep",
    "time step",
    "nume ordre",
    "step time",
    "state",
    "t",
];
/// Most states that are shown.
const SHOWN: usize = 12;
/// What lines below the numbers of a report begin with; `at` where no number follows.
const BELOW: [&str; 4] = ["minimum", "maximum", "total", "at"];
/// What lines behind these begin with, by Ansys.
const EXTREMES: [&str; 2] = ["node", "value"];
/// What COMSOL writes above a table before the unit of its lengths.
const LENGTH: &str = "length unit:";

/// A file as names and lines of cells.
pub(super) struct Table<'a> {
    pub(super) head: Vec<String>,
    pub(super) rows: Vec<(&'a str, Vec<String>)>,
    /// Whether numbers have a decimal comma.
    pub(super) comma: bool,
    /// The time whose rows it has, and all times of the file.
    pub(super) states: Option<(State, Vec<State>)>,
}

impl<'a> Table<'a> {
    pub(super) fn of(source: &Source<'a>, asked: &Asked) -> Result<Self, Error> {
        let lines: Vec<&str> = source.text.lines().filter(|line| !is_rule(line)).collect();
        if lines.is_empty() {
            return Err(source.refused("it holds nothing", HEADER));
        }
        let begins = Begins::of(&lines, asked);
        let (begin, head) = begins.names(source, &lines, asked)?;
        let head = match unit_of_lengths(&lines[..begin]) {
            Some(unit) => head.into_iter().map(|title| asked.in_unit(title, unit)).collect(),
            None => head,
        };
        let mut table = Self { head, rows: Vec::new(), comma: false, states: None };
        table.read(source, (&lines, begin), begins, asked)?;
        // ParaView writes zeros where a line leaves the grid, and masks them.
        if let Some(mask) = table.head.iter().position(|title| title.eq_ignore_ascii_case("vtkValidPointMask")) {
            table.rows.retain(|(_, cells)| cells.get(mask).and_then(|cell| number(cell)) != Some(0.0));
        }
        table.choose_state(source, asked)?;
        table.comma = table.has_decimal_commas(source, asked)?;
        Ok(table)
    }

    /// Takes the lines behind the names: rows of units before the numbers, and rows of numbers up to what stands below
    /// them.
    fn read(
        &mut self,
        source: &Source<'a>,
        (lines, begin): (&[&'a str], usize),
        Begins { mark, first, .. }: Begins,
        asked: &Asked,
    ) -> Result<(), Error> {
        let (names, wanted) = (self.head.clone(), self.head.len());
        for (k, line) in lines.iter().enumerate().skip(begin) {
            let is_above = first.is_some_and(|first| k < first);
            if let Some(said) = comment(line).filter(|_| !is_marked_row(line, mark, wanted)) {
                let own = fitting(said, mark, wanted);
                if is_above && are_units(&own, wanted) {
                    self.head = with_units(&self.head, &own);
                }
                continue;
            }
            let mut own = fitting(line, mark, wanted);
            // What begins like a number is of a row, which is refused where it is none.
            let is_word = |cell: &String| is_unit(cell) || number(cell).is_none() && !is_like_number(cell);
            match is_above && own.iter().all(is_word) {
                true if own.len() == wanted && own.iter().any(|cell| is_known_unit(inner(cell))) => {
                    self.take_units(source, line, &own, asked)?;
                }
                // The second line of a head of two.
                true => {}
                false if is_below(line, mark) => {
                    let is_extreme = |line: &str| EXTREMES.contains(&&*first_word(line, mark));
                    let is_row =
                        |line: &str| is_row(line, mark, &[wanted]) && !is_below(line, mark) && !is_extreme(line);
                    let is_more = |line: &&&str| is_row(line) && fitting(line, mark, wanted).len() == wanted;
                    let more = lines[k..].iter().find(is_more);
                    return more.map_or(Ok(()), |more| Err(source.at(more, ANOTHER, ONE)));
                }
                false if own == names => return Err(source.at(line, ANOTHER, ONE)),
                false => {
                    own.shrink_to_fit();
                    self.rows.push((line, own));
                }
            }
        }
        Ok(())
    }

    /// Takes a row of units; those of columns that are not read need not be known.
    fn take_units(&mut self, source: &Source, line: &str, units: &[String], asked: &Asked) -> Result<(), Error> {
        let is_read =
            |title: &str| [Role::Position, Role::X, Role::Pressure].into_iter().any(|role| asked.means(role, title));
        let unknown = self.head.iter().zip(units).find(|(title, cell)| !is_unit(cell) && is_read(title));
        if let Some((_, unknown)) = unknown {
            let message = format!("this row of units has `{unknown}`, which is none that is known");
            let remedy = "write units that `--help` tells, or remove the row and name them by --unit";
            return Err(source.at(line, message, remedy));
        }
        self.head = with_units(&self.head, units);
        Ok(())
    }

    /// Keeps the rows of the time that is asked for; of several times the last one is judged, as of grids.
    fn choose_state(&mut self, source: &Source, asked: &Asked) -> Result<(), Error> {
        let is_time = |title: &String| TIMES.iter().any(|time| split(title).0.eq_ignore_ascii_case(time));
        let numbered = || self.numbered().filter(|_| asked.has_state());
        let column = self.head.iter().position(is_time).or_else(numbered);
        if asked.has_state() && column.is_none() {
            return Err(State::only(source.file));
        }
        let Some(column) = column.filter(|_| !self.rows.is_empty()) else { return self.of_one_state(source, KEEP) };
        let time = |cells: &[String]| cells.get(column).and_then(|cell| state_number(cell)).filter(|t| t.is_finite());
        if let Some((line, cells)) = self.rows.iter().find(|(_, cells)| time(cells).is_none()) {
            let own = cells.get(column).map_or("", String::as_str);
            let message = format!("`{}` is `{own}`, which is no number", self.head[column]);
            return Err(source.at(line, message, TIMED));
        }
        let time = |cells: &[String]| time(cells).unwrap_or(f64::NAN);
        let mut states: Vec<State> =
            self.rows.iter().map(|(_, cells)| State { step: None, time: time(cells) }).collect();
        let last = states.iter().map(|state| state.time).fold(f64::NEG_INFINITY, f64::max);
        states.dedup_by(|a, b| a.is_at(b.time));
        let asked = Asked { time: asked.time.or(Some(last)), ..asked.clone() };
        let state = states[State::chosen(source, &states, &asked)?];
        self.rows.retain(|(_, cells)| state.is_at(time(cells)));
        if self.rows.len() < FEWEST {
            let message = format!("{} of its rows are of {state}, and a profile needs {FEWEST}", self.rows.len());
            return Err(source.refused(message, TIMED));
        }
        self.states = Some((state, states));
        self.of_one_state(source, ONE)
    }

    /// The first column of numbers of states that are several, with as many rows each as a profile needs: not one that
    /// counts the rows.
    fn numbered(&self) -> Option<usize> {
        let is_it = |title: &String| STATES.contains(&&*split(title).0.to_lowercase().replace(['_', '-'], " "));
        let mut columns = (0..self.head.len()).filter(|&k| is_it(&self.head[k]));
        columns.find(|&k| (2..=self.rows.len() / FEWEST).contains(&self.values(k).len()))
    }

    /// The values of a column, each once.
    fn values(&self, column: usize) -> BTreeSet<&str> {
        self.rows.iter().filter_map(|(_, cells)| cells.get(column)).map(String::as_str).collect()
    }

    /// Refuses rows of several states of which none is asked for.
    fn of_one_state(&self, source: &Source, remedy: &str) -> Result<(), Error> {
        let Some(column) = self.numbered() else { return Ok(()) };
        let values: Vec<&str> = self.values(column).into_iter().collect();
        let cut = if values.len() > SHOWN { ", …" } else { "" };
        let shown = values[..values.len().min(SHOWN)].join(", ");
        let message = format!("its rows are of several states: the column `{}` has {shown}{cut}", self.head[column]);
        Err(source.refused(message, remedy))
    }

    /// Whether numbers have decimal commas: where commas separate cells, one within a cell stood in quotes. A list in a
    /// column that is not read has none.
    fn has_decimal_commas(&self, source: &Source, asked: &Asked) -> Result<bool, Error> {
        let has_comma = |cell: &String| cell.contains(',') && number(&cell.replace([',', '.'], "")).is_some();
        let is_read = |k: usize| {
            let is = |role: &Role| {
                let number = asked.column(*role).and_then(|column| column.parse().ok());
                self.head.get(k).is_none_or(|title| asked.means(*role, title)) || number == Some(k + 1)
            };
            Role::OF_TABLES.iter().any(is)
        };
        let all =
            self.rows.iter().flat_map(|(line, own)| own.iter().enumerate().map(move |(k, cell)| (k, *line, cell)));
        let commas: Vec<(&str, &String)> =
            all.filter(|(k, _, cell)| has_comma(cell) && is_read(*k)).map(|(_, line, cell)| (line, cell)).collect();
        let has_marks = |(_, cell): &&(&str, &String)| cell.matches(',').count() > 1;
        let may_be = || commas.first().filter(|_| commas.iter().all(|(_, cell)| is_of_thousands(cell)));
        if let Some((line, cell)) = commas.iter().find(has_marks).or_else(may_be) {
            let message = format!("`{cell}` may be a number with a decimal comma, or one with marks between thousands");
            return Err(source.at(line, message, "write numbers with a decimal point, and no mark between thousands"));
        }
        Ok(!commas.is_empty())
    }
}

/// Where the numbers of a table begin.
struct Begins {
    /// What separates cells.
    mark: char,
    /// The first row; none where there is none.
    first: Option<usize>,
    /// Its cells.
    count: Option<usize>,
}

impl Begins {
    fn of(lines: &[&str], asked: &Asked) -> Self {
        // Lines that name a place and what presses there, each with its cells, of which rows behind it have as many.
        let heads = |mark: char| -> Vec<(usize, usize)> {
            let names = |line: &str| cells(comment(line).unwrap_or(line), mark);
            let all = lines.iter().take(SEEN).map(|line| names(line)).enumerate();
            all.filter(|(_, names)| is_head(names, asked)).map(|(k, names)| (k, names.len())).collect()
        };
        let is_row = |k: usize, mark: char, heads: &[(usize, usize)]| {
            let wanted: Vec<usize> = heads.iter().filter(|head| head.0 < k).map(|head| head.1).collect();
            is_row(lines[k], mark, &wanted)
        };
        let counts = MARKS.map(|mark| {
            let heads = heads(mark);
            (0..lines.len().min(SEEN)).filter(|&k| is_row(k, mark, &heads)).count()
        });
        let most = counts.into_iter().max().unwrap_or_default();
        let stands = |mark: char| lines.first().is_some_and(|line| line.trim().contains(mark));
        let is_it = |(mark, count): &(char, usize)| if most > 0 { *count == most } else { stands(*mark) };
        let mark = MARKS.into_iter().zip(counts).find(is_it).map_or(',', |(mark, _)| mark);
        // Where names stand behind a row or two of numbers, such as counts, the rows behind them are the first.
        let heads = heads(mark);
        let data: Vec<usize> = (0..lines.len()).filter(|&k| is_row(k, mark, &heads)).take(FEWEST).collect();
        let headed = data.iter().copied().find(|&k| heads.iter().any(|head| head.0 < k));
        let first = headed.or(data.first().copied());
        // What all rows have behind their last mark is no cell.
        let ends =
            |first: usize| mark != ' ' && lines[first..].iter().take(SEEN).all(|line| line.trim_end().ends_with(mark));
        let count = first.map(|first| cells(lines[first], mark).len() - usize::from(ends(first)));
        Self { mark, first, count }
    }

    /// The names, and the line behind them.
    fn names(&self, source: &Source, lines: &[&str], asked: &Asked) -> Result<(usize, Vec<String>), Error> {
        let &Self { mark, first, count } = self;
        match (head(&lines[..first.unwrap_or(lines.len().min(1))], mark, count, asked), count) {
            (Some((index, head)), _) => Ok((index + 1, head)),
            // Names of columns without a head are their numbers.
            (None, Some(count)) if !asked.columns.is_empty() => {
                Ok((first.unwrap_or(0), (1..=count).map(|number| number.to_string()).collect()))
            }
            _ => {
                let shown = lines.first().map_or_else(Vec::new, |line| cells(line, mark)).join("`, `");
                Err(source.refused(format!("its first line holds no names but `{shown}`"), HEADER))
            }
        }
    }
}

/// Whether a line is a row of numbers, or has two beside other cells, as many as are wanted.
fn is_row(line: &str, mark: char, wanted: &[usize]) -> bool {
    comment(line).is_none() && is_data(&cells(line, mark), wanted)
}

impl Table<'_> {
    /// Whether a line without numbers, or a blank one, stands before a row.
    pub(super) fn is_behind_break(&self, text: &str, k: usize) -> bool {
        let begin = |k: usize| self.rows[k].0.as_ptr() as usize - text.as_ptr() as usize;
        let before = k.checked_sub(1).map_or(0, |before| begin(before) + self.rows[before].0.len());
        let between = text.get(before..begin(k)).unwrap_or_default();
        between.trim_start_matches('\r').strip_prefix('\n').is_some_and(|between| !between.is_empty())
    }
}

/// What is said of a second table.
pub(super) const ANOTHER: &str = "this line begins another table";

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

/// The line of names and its place: the last above the numbers that names a place and what presses there; else the last
/// with as many cells as they have, a comment where there is no other; else the last.
fn head(above: &[&str], mark: char, count: Option<usize>, asked: &Asked) -> Option<(usize, Vec<String>)> {
    let candidate = |(k, line): (usize, &&str)| {
        let fit = |mark: char| fitting(comment(line).unwrap_or(line), mark, count.unwrap_or(0));
        // Names may have blanks between where numbers have commas, and the other way round.
        let other = if mark == ' ' { ',' } else { ' ' };
        let heads = [mark, other].map(fit).into_iter();
        let names = heads.filter(|names| Some(names.len()) == count).find(|names| is_head(names, asked));
        let names = names.unwrap_or_else(|| fit(mark));
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
    let word = first_word(line, mark);
    // `At Node 12`, and no point that is called `at 12`.
    let is_called = word == "at" && words(line, mark).nth(1).is_some_and(|next| number(next).is_some());
    BELOW.contains(&word.as_str()) && !is_called
}

/// The words of a line, whatever separates them.
fn words(line: &str, mark: char) -> impl Iterator<Item = &str> {
    line.split(move |letter: char| letter == mark || letter.is_whitespace()).filter(|word| !word.is_empty())
}

/// The first of them in small letters, without quotes.
fn first_word(line: &str, mark: char) -> String {
    words(line, mark).next().unwrap_or_default().trim_matches('"').to_lowercase()
}

/// The number of a state: the cell, or what stands behind its last `=`, as in Abaqus's `Increment 1: Step Time = 0.5`.
fn state_number(cell: &str) -> Option<f64> {
    let behind = || cell.rsplit_once('=').and_then(|(_, time)| number(time.trim()));
    number(cell).or_else(behind)
}

/// The unit of lengths that lines above a table tell.
fn unit_of_lengths<'a>(above: &[&'a str]) -> Option<&'a str> {
    let told = |line: &&'a str| {
        let said = comment(line)?.trim();
        let is_it = said.get(..LENGTH.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(LENGTH));
        is_it.then(|| said[LENGTH.len()..].trim())
    };
    above.iter().find_map(told)
}
