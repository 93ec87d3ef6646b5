//! The paper leaves open how stiffnesses are changed, what has one, when a run ends and when it is given up. Its sentences are held
//! against the reading nearest to its text, every single departure from it, and a few pairs.
//!
//! * `reading` — one choice on every axis; the designed set.
//! * `sentence` — what the paper says, and whether it holds.
//! * `runs` — iterations from every start, and when each criterion would have stopped them.
//! * `fared` — which departures flip a sentence.

pub mod fared;
pub mod reading;
pub mod runs;
pub mod sentence;

use serde::Serialize;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::drawing::Drawing;
use crate::error::Error;
use crate::markdown::table;
use crate::study::about::About;
use crate::study::{Found, Planned};
use fared::Fared;
use reading::{JUDGED, Reading};
use runs::{Course, starts};
use sentence::{GOOD, Met, STRONG, Sentence};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Readings of the paper",
    asked: "Which of the paper's sentences hold under the reading nearest to its text, and which choice flips them.",
    limits: "A reading that nobody thought of is not tried, and of departures together only a few pairs.",
};

/// What was run.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Every start of every site of the designed set.
    pub courses: Vec<Course>,
    /// When a criterion was met as the course of a run tells, and by a run that it stops.
    pub stopped: Vec<[Option<Met>; 2]>,
}

/// Difference of two errors that is round-off.
const SAME: f64 = 1e-9;

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("readings of the paper", "designed set", run)]
}

fn run() -> Result<Numbers, Error> {
    let courses = runs::courses(&Reading::designed())?;
    Ok(Numbers { stopped: runs::stopped(&courses)?, courses })
}

/// The checks.
pub fn judge(Numbers { stopped, .. }: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![stops_where_told(stopped)])
}

/// Whether a run that a criterion stops ends where the course of a run without it tells.
pub fn stops_where_told(stopped: &[[Option<Met>; 2]]) -> Judged {
    let is_told = |[told, own]: &[Option<Met>; 2]| match (told, own) {
        (Some(told), Some(own)) => told.iterations == own.iterations && (told.error - own.error).abs() <= SAME,
        (None, None) => true,
        _ => false,
    };
    let wrong = stopped.iter().filter(|pair| !is_told(pair)).count();
    let quantity =
        Quantity::at("run that stops elsewhere than the course of one tells", format!("of {}", stopped.len()));
    Check::at_most(quantity, Reference::own("runs of their own", 0.0), "the same iterations, stopped or not")
        .judge(if stopped.iter().any(|pair| pair[1].is_some()) { wrong as f64 } else { f64::NAN })
}

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    Ok(findings.iter().map(|found| of(&found.numbers.courses)).collect())
}

fn of(courses: &[Course]) -> String {
    let [departures, pairs] = [Reading::departures().len(), Reading::pairs().len()];
    let starts = starts();
    format!(
        "The paper leaves open by which rule stiffnesses change (its reference 12), what has one, how thick layers are, how far the \
         candidates reach, its meshes, when a run has converged and when it is given up. The reading nearest to its text: {}. Beside it: \
         {departures} single departures, and {pairs} pairs of candidates that end where the contact does with another stop; with the tolerances that \
         each is judged at these are {} readings. {} courses from {} initial stiffnesses each, κ₀ = {:e} to {:e} by decades, tell of all of them. \
         Criteria are those that can be had without the discrete solution: the contact conditions (penetration, tension, pressure across a gap), \
         the residuals (change of displacements, penetration, tension), the change of displacements alone, the contact state alone.\n\n\
         A sentence holds where it does in both examples, with the elements and algorithms that the paper shows. Agreement is a peak \
         within {} % of the discrete solution whenever a run ends, a strong dependence {STRONG} times as many iterations from one start as \
         from another; constant stiffness and kinematic load save operations where they do from every start. Under a reading it holds where it \
         does at each tolerance; under one with another stop, at that. Only departures under which every combination still agrees are counted: \
         the paper's do, so that others are not the paper's. The first row names those others.\n\n{}\n",
        Reading::nearest().name(),
        Reading::designed().len(),
        courses.len(),
        starts.len(),
        starts[0],
        starts[starts.len() - 1],
        100.0 * GOOD,
        by_sentence(courses),
    )
}

fn by_sentence(courses: &[Course]) -> String {
    let tolerances = JUDGED.map(|tolerance| format!("at {tolerance:.0e}"));
    let head = [&["sentence".to_string()][..], &tolerances, &["which choice flips it".to_string()]].concat();
    let row = |sentence: Sentence| {
        let fared = Fared::of(sentence, courses);
        let held = fared.held.map(|held| if held { "holds" } else { "fails" }.to_string());
        [&[sentence.name().to_string()][..], &held, &[fared.told()]].concat()
    };
    table(&head, &Sentence::ALL.map(row))
}

/// None: the study of the initial stiffness draws Fig. 11.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(Vec::new())
}
