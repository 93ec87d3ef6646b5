//! The paper: what it says of iterations, what it leaves open, misprints. It leaves open how stiffnesses are changed,
//! what has one, when a run ends and when it is given up: its sentences are held against the reading nearest to its
//! text, every single departure from it, and a few pairs. Above 400 lines, so a folder; the report puts the judged
//! statements in front, which need the findings of other studies too.
//!
//! * `reading` — one choice on every axis; the designed set.
//! * `sentence` — what the paper says, and whether it holds.
//! * `statement` — iterations from every start, and when each criterion would have stopped them; which departures flip
//!   a sentence, and what is made of it.
//!
//! Below is the page; its text is `page.md`, with misprints, decisions where the paper is silent and sources, and
//! `readings.md`; the numbers in it come from the code.

pub mod reading;
pub mod sentence;
pub mod statement;

use crate::case::library::{Cylinder, PinRod};
use crate::case::{Check, Judged, Reference};
use crate::error::Error;
use crate::solve::{Element, Formulation, Iteration, LIMITS, Settings};
use crate::study::about::{About, Found, Planned, Study};
use reading::Reading;
use sentence::{DIFFERENT, GOOD, MUCH, Met, STRONG, Sentence, UNREMARKABLE};
use statement::{Course, Fared, LONGER, later, most_fulfilled, starts};

/// Every start of every site of the designed set.
pub type Numbers = Vec<Course>;

impl Study for Numbers {
    const NAME: &'static str = "paper";
    const ABOUT: About = About {
        title: "The paper",
        asked: "What of János Égert's paper of 1999 is reproduced, and what had to be decided.",
        limits: "A reading that nobody thought of is not tried, and of departures together only a few pairs.",
    };

    fn plan() -> Vec<Planned<Self>> {
        vec![Planned::new("readings of the paper", "designed set", || statement::courses(&Reading::designed()))]
    }

    /// Whether a run that a criterion stops ends where the course of a run without it tells.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let stopped: Vec<&[Option<Met>; 2]> = self.iter().flat_map(|course| &course.alone).collect();
        let is_told = |[told, own]: &[Option<Met>; 2]| match (told, own) {
            (Some(told), Some(own)) => told.iterations == own.iterations && (told.error - own.error).abs() <= SAME,
            (None, None) => true,
            _ => false,
        };
        let wrong = stopped.iter().filter(|pair| !is_told(pair)).count();
        let check = Check::at_most(
            "run that stops elsewhere than the course of one tells",
            Reference::own("runs of their own", 0.0),
            "the same iterations, stopped or not",
        )
        .asked_of(stopped.len());
        Ok(vec![check.judge(if stopped.iter().any(|pair| pair[1].is_some()) { wrong as f64 } else { f64::NAN })])
    }

    /// What is told of it besides its statements, with the numbers that decisions where it is silent rest on.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let own: Vec<String> =
            Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
        let (cylinder, rod, settings) = (Cylinder::default(), PinRod::default(), Settings::default());
        let varying = Formulation::new(Element::Node, Iteration::Varying);
        Ok(format!(
            include_str!("page.md"),
            shown = own.len(),
            names = own.join(", "),
            readings = findings.iter().map(|found| readings(found.numbers)).collect::<String>(),
            radius = cylinder.radius,
            young = cylinder.young,
            poisson = cylinder.poisson,
            a_over_r = cylinder.a_over_r,
            stretch = cylinder.stretch,
            pin = rod.pin_radius,
            clearance = rod.clearance,
            eye = rod.eye_outer_radius,
            shank = rod.shank_width,
            end = rod.shank_end,
            thickness = rod.thickness,
            force = rod.force,
            reach = rod.stretch.to_degrees(),
            bound = varying.leeway.bound,
            soft = varying.stiffness,
            hard = Formulation::new(Element::Node, Iteration::Kinematic).stiffness,
            gauss = Formulation::new(Element::Line, Iteration::Kinematic).stiffness,
            least = LIMITS[0],
            most = LIMITS[1],
            layer = Formulation::new(Element::Layer, Iteration::Varying).layer_thickness,
            tolerance = settings.tolerance,
            limit = settings.max_iterations,
        ))
    }
}

/// Difference of two errors that is round-off.
const SAME: f64 = 1e-9;

/// The designed set, and which departures do not count.
fn readings(courses: &[Course]) -> String {
    let [departures, pairs] = [Reading::departures().len(), Reading::pairs().len()];
    let (starts, agreement) = (starts(), Fared::agreement(courses));
    format!(
        include_str!("readings.md"),
        nearest = Reading::nearest().name(),
        departures = departures,
        pairs = pairs,
        designed = Reading::designed().len(),
        courses = courses.len(),
        starts = starts.len(),
        softest = starts[0],
        hardest = starts[starts.len() - 1],
        good = 100.0 * GOOD,
        strong = STRONG,
        much = MUCH,
        different = DIFFERENT,
        unremarkable = 100.0 * UNREMARKABLE,
        together = together(courses),
        cap = Reading::nearest().cap,
        longer = LONGER,
        later = later(courses),
        at = agreement.at(),
        told = agreement.told()
    ) + "\n"
}

/// The reading that fulfils most.
pub fn together(courses: &[Course]) -> String {
    let (most, all) = (most_fulfilled(courses), Sentence::ALL.len());
    let (first, open) = &most[0];
    format!(
        "Of the {all} sentences on iterations no reading fulfils more than {} at once, each at {}. {}: {}. It does \
        not fulfil: {}.",
        all - open.len(),
        first.judged().iter().map(|one| one.stop.name()).collect::<Vec<_>>().join(", "),
        match most.len() {
            1 => "One does".to_owned(),
            some => format!("{some} do, first of them"),
        },
        first.name(),
        open.iter().map(|one| format!("*{}*", one.name())).collect::<Vec<_>>().join(", ")
    )
}

/// What is deliberately not covered.
pub const NOT_COVERED: [&str; 7] = [
    "friction",
    "three dimensions",
    "large sliding and large deformation: areas, normals and gaps belong to the undeformed surface",
    "plasticity",
    "dynamics",
    "calibrated experiments: no measured pressure, load or width is at hand",
    "wall-clock times as requirements: seconds are recorded on one machine and shown, the suite judges errors and work \
    counts only",
];
