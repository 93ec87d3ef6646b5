//! Requirement by requirement: what shall hold is stated once, and what was found stands below it, trial by trial.

use crate::case::{Check, Judged, Quantity, Relation, Scope, Verdict, judged};
use crate::markdown;
use crate::report::told;
use crate::study::Finding;
use crate::study::grouped::{in_order, sorted};
use crate::uncertainty::COVERAGE;

/// Name of the first column.
const TRIAL: &str = "trial";
/// What a check is told by in a column; the flag tells whether the sentence above the table has its reference and
/// tolerance, which the cell then has not.
type Cell = fn(&Judged, bool) -> String;
const COLUMNS: [(&str, Cell); 8] = [
    ("at", |one, _| place(&one.check)),
    ("found", |one, _| match one.check.relation {
        Relation::Error => String::new(),
        _ => with_uncertainty(one.value, one.uncertainty),
    }),
    ("reference", held),
    ("error", |one, _| if matches!(one.verdict, Verdict::NotRun(_)) { "–".into() } else { told::error(one) }),
    ("tolerance", |one, in_sentence| match one.check.tolerance > 0.0 && !in_sentence {
        true => told::in_unit(one, one.check.tolerance, markdown::tolerance),
        false => String::new(),
    }),
    ("bar", |one, _| match one.bar_as_error() {
        Some(bar) if bar.is_nan() => "unknown".into(),
        bar => bar.map_or_else(String::new, |bar| told::in_unit(one, bar, markdown::error)),
    }),
    ("because", |one, _| one.check.because.to_string()),
    ("verdict", |one, _| one.verdict.to_string()),
];
/// Column of the reason.
const BECAUSE: usize = 6;
/// What a row has.
type Cells = [String; COLUMNS.len()];
/// Tables of more rows than this are folded.
const FOLDED: usize = 12;

/// Name of a trial with its checks.
pub type Named<'a> = (&'a str, &'a [Judged]);

/// Checks that ask the same of one quantity, perhaps against several references, each behind the name of its trial.
type Requirement<'a> = Vec<(&'a str, &'a Judged)>;

/// Whether every check of a requirement asks for the same number.
fn is_one(checks: &Requirement) -> bool {
    checks.iter().all(|(_, one)| one.requirement() == checks[0].1.requirement())
}

fn has_failed(checks: &Requirement) -> bool {
    checks.iter().any(|(_, one)| one.verdict == Verdict::Fail)
}

/// The sentence of a requirement, without numbers that only some of the checks have.
fn sentence(checks: &Requirement) -> String {
    let first = checks[0].1;
    if is_one(checks) {
        return first.requirement();
    }
    let shall = match first.check.relation {
        Relation::Near | Relation::NearAbsolutely => "shall agree with its reference within its tolerance",
        Relation::Error => "shall be at most its tolerance against its reference",
        Relation::AtLeast => "shall be at least its reference",
        Relation::AtMost => "shall be at most its reference",
    };
    format!("{} {shall}", markdown::capitalised(first.check.quantity.name()))
}

/// A row for each trial; what is alike in several of them is one row.
fn rows<'a>(checks: &Requirement<'a>) -> Vec<(Vec<&'a str>, Cells)> {
    let is_one = is_one(checks);
    let mut rows: Vec<(Vec<&str>, Cells)> = Vec::new();
    for &(name, one) in checks {
        let cells = COLUMNS.map(|(_, cell)| cell(one, is_one));
        match rows.iter_mut().find(|(names, other)| !names.contains(&name) && *other == cells) {
            Some((names, _)) => names.push(name),
            None => rows.push((vec![name], cells)),
        }
    }
    rows
}

/// The requirements of each case with whatever else is told of it, below its name where there are several.
pub fn by_case(findings: &[&Finding], with: impl Fn(String, &[&Finding]) -> String) -> String {
    let parts: Vec<&[&Finding]> = findings.chunk_by(|a, b| a.case == b.case).collect();
    let part = |members: &&[&Finding]| {
        let named: Vec<Named> = members.iter().map(|one| (one.name.as_str(), &one.judged[..])).collect();
        let table = with(of(&named), members);
        if parts.len() > 1 && !table.is_empty() { format!("### {}\n\n{table}", members[0].case) } else { table }
    };
    parts.iter().map(part).collect()
}

/// The requirements of some trials with their checks; those that every run must meet are left to [`of_every_run`].
pub fn of(members: &[Named]) -> String {
    let named = members.iter().flat_map(|(name, judged)| judged.iter().map(move |one| (*name, one)));
    let own: Vec<(&str, &Judged)> = named.filter(|(_, one)| one.check.scope == Scope::Own).collect();
    if own.is_empty() {
        return String::new();
    }
    // Each requirement once, in the order in which they come.
    let asked = |one: &Judged| (one.check.quantity.name().to_owned(), one.check.relation, one.reference.kind);
    let requirements = in_order(own.iter().map(|&(name, one)| (asked(one), (name, one))));
    let requirements = requirements.into_iter().map(|(_, checks)| checks);
    let (single, several): (Vec<_>, Vec<_>) = requirements.partition(|one| rows(one).len() == 1);
    let several: String = several.iter().map(|one| spread(one, members.len())).collect();
    format!("{}\n\n{}{several}", summary(&own), together(&single, members.len()))
}

fn summary(own: &[(&str, &Judged)]) -> String {
    match told::tally(told::once(own.iter().map(|(_, one)| *one))) {
        [passed, 0, 0] => format!("✓ {} passed", markdown::counted(passed, "check")),
        [passed, 0, absent] => format!("○ {} passed, {absent} not run", markdown::counted(passed, "check")),
        [passed, failed, absent] => {
            format!("✗ {failed} of {} failed", markdown::counted(passed + failed + absent, "check"))
        }
    }
}

/// The names of the columns.
fn head() -> impl Iterator<Item = String> {
    std::iter::once(TRIAL).chain(COLUMNS.iter().map(|(name, _)| *name)).map(String::from)
}

/// Requirements of one row each, in one table.
fn together(single: &[Requirement], trials: usize) -> String {
    if single.is_empty() {
        return String::new();
    }
    let row = |one: &Requirement| {
        let (names, mut cells) = rows(one).remove(0);
        let shall = format!("{} ({}; {})", sentence(one), one[0].1.reference.kind, std::mem::take(&mut cells[BECAUSE]));
        std::iter::once(shall).chain(with_trials(&names, &cells, trials)).collect()
    };
    let head = std::iter::once("what shall hold (kind; because)".into()).chain(head()).collect();
    let (head, rows, told) = without_repeats(head, single.iter().map(row).collect(), single.len() > 1);
    let failed = single.iter().any(has_failed);
    let told = if told.is_empty() { told } else { format!("In all rows: {told}.\n\n") };
    told + &shown(&head, &rows, failed)
}

/// A requirement of several rows: what is alike in all of them is told once.
fn spread(one: &Requirement, trials: usize) -> String {
    let rows = rows(one).iter().map(|(names, cells)| with_trials(names, cells, trials)).collect();
    let (head, rows, told) = without_repeats(head().collect(), rows, true);
    let told = if told.is_empty() { told } else { format!(" In all rows: {told}.") };
    let (kind, number) = (one[0].1.reference.kind, one.len());
    format!("**{}** ({kind}), {number} runs.{told}\n\n{}", sentence(one), shown(&head, &rows, has_failed(one)))
}

/// A table, folded where it is long; open where something failed.
fn shown(head: &[String], rows: &[Vec<String>], failed: bool) -> String {
    let table = markdown::table(head, rows);
    match rows.len() {
        few if few <= FOLDED => table + "\n",
        many => markdown::folded(&format!("{many} rows"), &table, failed),
    }
}

/// Cells with the names of the trials in front.
fn with_trials(names: &[&str], cells: &Cells, trials: usize) -> Vec<String> {
    let told = match names {
        [_, _, ..] if names.len() == trials => format!("all {trials} trials"),
        _ => names.join(", "),
    };
    std::iter::once(told).chain(cells.iter().cloned()).collect()
}

/// A table without its empty columns and, where that is wanted, without those that say the same in every row, but for
/// the first; the latter are told.
fn without_repeats(head: Vec<String>, rows: Vec<Vec<String>>, lift: bool) -> (Vec<String>, Vec<Vec<String>>, String) {
    let same = |column: usize| rows.iter().all(|row| row[column] == rows[0][column]);
    let is_empty = |column: usize| same(column) && rows[0][column].is_empty();
    let lifted: Vec<usize> = (1..head.len()).filter(|&k| lift && same(k) && !is_empty(k)).collect();
    let kept = |k: &usize| !is_empty(*k) && !lifted.contains(k);
    let keep = |row: &[String]| (0..row.len()).filter(kept).map(|k| row[k].clone()).collect::<Vec<_>>();
    let named = |k: usize| if head[k] == TRIAL { rows[0][k].clone() } else { format!("{} {}", head[k], rows[0][k]) };
    let told: Vec<String> = lifted.iter().map(|&k| named(k)).collect();
    (keep(&head), rows.iter().map(|row| keep(row)).collect(), told.join(", "))
}

/// The reference, where it is not 0; its name where the sentence has not.
fn held(one: &Judged, in_sentence: bool) -> String {
    let held = match one.reference.value.abs() > 0.0 {
        true => with_uncertainty(one.reference.value, one.reference.uncertainty),
        false => String::new(),
    };
    if in_sentence { held } else { format!("{} {held}", one.reference.name).trim_end().to_string() }
}

/// Where a number was found and its unit, and of how many it is.
fn place(check: &Check) -> String {
    let place = match &check.quantity {
        Quantity::Named { at, .. } => at.clone(),
        number => number.coordinate().unwrap_or_default(),
    };
    let unit = check.quantity.unit().map(|unit| format!("[{unit}]"));
    let number = (check.number != 1).then(|| format!("of {}", check.number));
    let at = [Some(place), unit].into_iter().flatten().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ");
    [Some(at), number].into_iter().flatten().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

/// A value, with its error bar where its standard uncertainty is known and more than none.
fn with_uncertainty(value: f64, uncertainty: Option<f64>) -> String {
    match uncertainty.filter(|uncertainty| *uncertainty > 0.0) {
        None if value.fract().abs() <= 0.0 => markdown::bound(value),
        uncertainty => markdown::with_bar(value, uncertainty.map(|uncertainty| COVERAGE * uncertainty)),
    }
}

/// The universal requirements, number of runs, worst error over its tolerance, verdict; with their reasons on the page
/// of all checks alone.
pub fn of_every_run<'a>(judged: impl Iterator<Item = &'a Judged>, with_reasons: bool) -> String {
    let head = ["every run", "runs checked", "worst error", "its tolerance", "verdict", "because"];
    let head = &head[..if with_reasons { 6 } else { 5 }];
    let own = judged.filter(|one| one.check.scope == Scope::Universal);
    let rows = sorted(own.map(|one| (one.check.quantity.name(), one)));
    if rows.is_empty() {
        return String::new();
    }
    let cells = |(name, all): (&&str, &Vec<&Judged>)| universal_row(name, all).into_iter().take(head.len()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    markdown::table(&head.iter().map(|name| name.to_string()).collect::<Vec<_>>(), &rows)
}

/// What was not run has no error, and its number stands beside that of the runs.
fn universal_row(name: &str, all: &[&Judged]) -> [String; 6] {
    let mut places: Vec<String> = all.iter().map(|one| place(&one.check)).filter(|place| !place.is_empty()).collect();
    places.sort();
    places.dedup();
    let places = if places.is_empty() { String::new() } else { format!(": {}", places.join(", ")) };
    let (run, absent): (Vec<&Judged>, Vec<&Judged>) =
        all.iter().partition(|one| !matches!(one.verdict, Verdict::NotRun(_)));
    let worst = run.iter().max_by(|a, b| a.share_of_tolerance().total_cmp(&b.share_of_tolerance()));
    let number = match absent.len() {
        0 => run.len().to_string(),
        absent => format!("{} and {absent} not run", run.len()),
    };
    [
        format!("{name}{places}"),
        number,
        worst.map_or("–".into(), |one| told::error(one)),
        worst.map_or("–".into(), |one| markdown::tolerance(one.check.tolerance)),
        judged::worst(run.iter().copied()).map_or("–".into(), Verdict::to_string),
        worst.map_or(String::new(), |one| one.check.because.to_string()),
    ]
}
