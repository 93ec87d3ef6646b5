//! The paper: what it says of iterations, what it leaves open, misprints. It leaves open how stiffnesses are changed, what has one,
//! when a run ends and when it is given up: its sentences are held against the reading nearest to its text, every single departure
//! from it, and a few pairs. Above 400 lines, so a folder; the report puts the judged statements in front, which need the findings of
//! other studies too.
//!
//! * `reading` — one choice on every axis; the designed set.
//! * `runs` — iterations from every start, and when each criterion would have stopped them.
//! * `sentence` — what the paper says, and whether it holds.
//! * `statement` — which departures flip a sentence, and what is made of it.
//! * `decided` — misprints, decisions where the paper is silent, what is not covered, sources.

pub mod decided;
pub mod reading;
pub mod runs;
pub mod sentence;
pub mod statement;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::drawing::Drawing;
use crate::error::Error;
use crate::solve::Formulation;
use crate::study::about::About;
use crate::study::{Found, Planned};
use reading::Reading;
use runs::{Course, starts};
use sentence::{GOOD, Met, STRONG};
use statement::Fared;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "The paper",
    asked: "What of János Égert's paper of 1999 is reproduced, and what had to be decided.",
    limits: "A reading that nobody thought of is not tried, and of departures together only a few pairs.",
};

/// What was run.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// Every start of every site of the designed set.
    pub courses: Vec<Course>,
}

/// Difference of two errors that is round-off.
const SAME: f64 = 1e-9;

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    let run = || Ok(Numbers { courses: runs::courses(&Reading::designed())? });
    vec![Planned::new("readings of the paper", "designed set", run)]
}

/// Whether a run that a criterion stops ends where the course of a run without it tells.
pub fn judge(Numbers { courses }: &Numbers) -> Result<Vec<Judged>, Error> {
    let stopped: Vec<&[Option<Met>; 2]> = courses.iter().flat_map(|course| &course.alone).collect();
    let is_told = |[told, own]: &[Option<Met>; 2]| match (told, own) {
        (Some(told), Some(own)) => told.iterations == own.iterations && (told.error - own.error).abs() <= SAME,
        (None, None) => true,
        _ => false,
    };
    let wrong = stopped.iter().filter(|pair| !is_told(pair)).count();
    let at = format!("of {}", stopped.len());
    let check = Check::at_most(
        Quantity::at("run that stops elsewhere than the course of one tells", at),
        Reference::own("runs of their own", 0.0),
        "the same iterations, stopped or not",
    );
    Ok(vec![check.judge(if stopped.iter().any(|pair| pair[1].is_some()) { wrong as f64 } else { f64::NAN })])
}

/// What is told of it besides its statements.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let own: Vec<String> = Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
    let readings: String = findings.iter().map(|found| readings(&found.numbers.courses)).collect();
    let sources: String = decided::REFERENCES.iter().map(|item| format!("* {item}\n")).collect();
    Ok(format!(
        "The paper itself shows {} of the nine formulations: {}. The others are ours.\n\n\
         ## How it is read\n\n{readings}\
         ## Where it is silent\n\nThe figures of the paper are not at hand: none of its dimensions, loads or plotted values is known.\n\n{}\n\
         ## Misprints and gaps\n\n{}\n## Sources\n\n{sources}",
        own.len(),
        own.join(", "),
        decided::open_points(),
        decided::misprints(),
    ))
}

/// The designed set, and which departures do not count.
fn readings(courses: &[Course]) -> String {
    let [departures, pairs] = [Reading::departures().len(), Reading::pairs().len()];
    let (starts, agreement) = (starts(), Fared::agreement(courses));
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
         does at each tolerance; under one with another stop, at that.\n\n\
         Only departures under which every combination still agrees are counted: the paper's do, so that others are not the paper's. \
         Every combination is in good agreement with the exact solution (Figs 10, 14, 15) under the nearest reading: this {}; it {}.\n\n",
        Reading::nearest().name(),
        Reading::designed().len(),
        courses.len(),
        starts.len(),
        starts[0],
        starts[starts.len() - 1],
        100.0 * GOOD,
        agreement.at(),
        agreement.told(),
    )
}

/// None: the atlas draws Fig. 11.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(Vec::new())
}
