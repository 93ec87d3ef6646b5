//! Where everything else breaks: one trial for each thing that is pushed until it fails, with the onset that was measured.
//!
//! * `points` — three Gauss points on an edge.
//! * `springs` — stiffness against digits.
//! * `rules` — layer thickness, cycling.
//! * `loads` — no load, the wrong sign, too little for the mesh.
//! * `surfaces` — candidates that end too early, bodies that do.
//! * `cells` — near incompressibility, distorted cells.
//! * `interface` — unequal sizes on the two sides.
//! * `facing` — nodes that do not face one another.
//! * `theory` — a/R, where it is the reference that fails.

mod cells;
mod facing;
mod interface;
mod loads;
mod points;
mod rules;
mod springs;
mod surfaces;
mod theory;

use crate::case::library::TruncatedHertz;
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::error::{Error, Place};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the case.
pub const CASE: &str = "limits";
/// Title of the table of one row that every trial gives first.
pub const SUMMARY: &str = "limit";
/// Columns of that row.
pub const HEAD: [&str; 5] =
    ["what is pushed", "range tried", "measured onset", "what the user sees", "what to do instead"];

/// Name of a row and what finds it.
type Row = (&'static str, fn() -> Result<Finding, Error>);

/// Trials, one for each row.
pub fn trials() -> Vec<Trial> {
    let rows: [Row; 14] = [
        ("three Gauss points", points::three_gauss_points),
        ("spring stiffness", springs::stiffness),
        ("held by contact alone", loads::pulled_apart),
        ("zero load", loads::none),
        ("load too small for the mesh", loads::small),
        ("candidates too short", surfaces::short),
        ("surface too short", surfaces::end),
        ("near incompressibility", cells::incompressible),
        ("distorted cells", cells::distorted),
        ("element sizes across the interface", interface::across),
        ("nodes that do not face", facing::across),
        ("layer thickness", rules::layer_thickness),
        ("a/R", theory::large_contact),
        ("cycling", rules::cycling),
    ];
    rows.into_iter().map(|(name, work)| Trial::new(CASE, name, work)).collect()
}

/// One row of the table of limits.
struct Limit {
    pushed: &'static str,
    range: String,
    onset: String,
    seen: String,
    instead: String,
}

impl Limit {
    /// The finding: the row, the tables that show more, the checks.
    fn finding(self, details: Vec<Table>, checks: Vec<Judged>) -> Finding {
        let row = vec![self.pushed.into(), self.range, self.onset, self.seen, self.instead];
        let summary = table(SUMMARY, &HEAD, vec![row]);
        Finding { tables: std::iter::once(summary).chain(details).collect(), checks, ..Default::default() }
    }
}

fn table(title: impl Into<String>, head: &[&str], rows: Vec<Vec<String>>) -> Table {
    Table { title: title.into(), head: head.iter().map(|cell| cell.to_string()).collect(), rows }
}

/// What an error says, and its remedy.
fn said(error: &Error) -> (String, String) {
    (format!("error: {}", error.finding()), error.remedy.clone())
}

/// What the user sees of a run: its outcome with its note, or an error.
fn seen(result: &Result<Run, Error>) -> String {
    match result {
        Ok(run) => match run.note(0) {
            Some(note) => format!("{}, note: {note}", run.solution.outcome),
            None => run.solution.outcome.to_string(),
        },
        Err(error) => said(error).0,
    }
}

/// The error a result must be; the reason why a trial has nothing to show where it is none.
fn refusal<T>(result: Result<T, Error>, what: &str) -> Result<Error, Error> {
    match result {
        Err(error) => Ok(error),
        Ok(_) => Err(Error::at(Place::Nowhere, format!("{what} was accepted"), "refuse it")),
    }
}

/// A requirement that holds or does not.
fn holds(requirement: &str, quantity: &str, true_so: bool, because: &str) -> Judged {
    let missing = if true_so { 0.0 } else { 1.0 };
    Judged::norm(requirement, quantity, missing, Reference::own("none", 0.0), 0.0, because)
}

/// Truncated Hertz of some numbers on a mesh of `elements` per half-width.
fn truncated(numbers: TruncatedHertz, elements: usize, order: Order) -> Result<Discretisation, Error> {
    meshed(problem::truncated_hertz(numbers).0, elements, order)
}

fn meshed(scene: Scene, elements: usize, order: Order) -> Result<Discretisation, Error> {
    Discretisation::of(scene, Resolution { elements, refinement: 0, order })
}

/// Relative errors of p₀ and a against the scene's reference values; NaN where the run did not converge.
fn hertz_errors(scene: &Scene, run: &Run) -> [f64; 2] {
    let reference = &scene.reference;
    let all = [run.measures().peak.pressure / reference.pressure, run.measures().half_width / reference.length];
    all.map(|ratio| if run.solution.converged() { ratio - 1.0 } else { f64::NAN })
}

/// The verification formulation on a discretisation.
fn verified(discretisation: &Discretisation) -> Result<Run, Error> {
    Run::of(discretisation, &Formulation::verification())
}

/// A fraction as a percentage of two decimals.
fn percent(x: f64) -> String {
    match x {
        x if x.is_nan() => "–".into(),
        x if x.abs() < 5e-5 => "< 0.01 %".into(),
        x => format!("{:+.2} %", 100.0 * x),
    }
}

/// The larger of the sizes of two numbers; NaN if either is.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.abs().max(b.abs()) }
}

/// The largest size of some values; NaN if any is.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |worst, x| worse(worst, *x))
}

/// Below a bound, or the size of what is not; NaN is not.
fn within(error: f64, bound: f64) -> String {
    if error <= bound { format!("below {bound:e}") } else { format!("{error:.0e}") }
}

/// The size of a fraction as a percentage.
fn size(x: f64) -> String {
    if x >= 0.1 { format!("{:.0} %", 100.0 * x) } else { format!("{:.2} %", 100.0 * x) }
}

/// The first of some values from which on a criterion holds, and the one before it, in words.
fn bracket(values: &[f64], holds: impl Fn(usize) -> bool, name: &str) -> (String, Option<usize>) {
    let first = (0..values.len()).find(|&i| holds(i));
    let text = match first {
        None => format!("none up to {name} = {}", number(values[values.len() - 1])),
        Some(0) => format!("from {name} = {} on, the first tried", number(values[0])),
        Some(i) => format!("between {name} = {} and {}", number(values[i - 1]), number(values[i])),
    };
    (text, first)
}

/// A number as people write it: eight digits, powers of ten where it is large or small.
fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.7e}").parse().unwrap_or(x);
    if x.abs() > 0.0 && !(1e-3..1e4).contains(&x.abs()) { format!("{rounded:e}") } else { rounded.to_string() }
}

fn range(values: &[f64], name: &str) -> String {
    format!("{name} = {} … {}", number(values[0]), number(values[values.len() - 1]))
}
