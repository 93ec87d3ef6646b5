//! Limit of the candidates: they end before the contact does.

use serde::Serialize;

use crate::algorithm::{Kinematic, iterate};
use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::Measures;
use crate::mesh::Order;
use crate::solve::{Discretisation, Formulation};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::{Seen, Why, told};
use crate::study::limits::solved::{hertz_errors, largest, truncated, verified};
use crate::study::limits::written::{bracket, number, percent, range};

/// Candidate stretches over the true half-width.
const STRETCHES: [f64; 8] = [2.0, 1.1, 1.0, 0.98, 0.95, 0.9, 0.8, 0.5];
/// Index of candidates that end where the contact ends.
const EXACT: usize = 2;
/// Index of candidates that are too short by more than a node spacing of the finer meshes.
const CUT: usize = 5;
/// Elements per half-width.
const ELEMENTS: [usize; 3] = [4, 8, 16];

/// Candidates that end before the contact.
#[derive(Clone, Debug, Serialize)]
pub struct ShortCandidates {
    /// By stretch, on each mesh.
    pub stretches: Vec<[Cut; 3]>,
}

/// One stretch on one mesh.
#[derive(Clone, Debug, Serialize)]
pub struct Cut {
    /// What the user sees.
    pub seen: Seen,
    /// Error of p₀ of what is accepted.
    pub accepted: Option<f64>,
    /// Error of p₀ of what the iteration finds, whether it is accepted or not.
    pub unchecked: f64,
}

/// Every stretch on every mesh.
pub(super) fn run() -> Result<ShortCandidates, Error> {
    let at = |stretch: f64| {
        let [coarse, middle, fine] = ELEMENTS.map(|elements| cut(stretch, elements));
        Ok([coarse?, middle?, fine?])
    };
    Ok(ShortCandidates { stretches: STRETCHES.into_iter().map(at).collect::<Result<_, Error>>()? })
}

fn cut(stretch: f64, elements: usize) -> Result<Cut, Error> {
    let numbers = TruncatedHertz { stretch, ..Default::default() };
    let discretisation = truncated(numbers, elements, Order::Quadratic)?;
    let result = verified(&discretisation);
    Ok(Cut {
        accepted: result.as_ref().ok().map(|run| hertz_errors(&discretisation.scene, run).peak),
        seen: Seen::of(&result),
        unchecked: peak_of_any(&discretisation)? - 1.0,
    })
}

/// Peak over p₀ of whatever the loop converges to, whether the contact reaches the end of its candidates or not.
fn peak_of_any(discretisation: &Discretisation) -> Result<f64, Error> {
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let settings = formulation.settings;
    let mut algorithm = Kinematic::new(formulation.rule, settings.tolerance);
    let solution = iterate(&problem, &mut algorithm, settings)?;
    let reference = &discretisation.scene.reference;
    let measures = Measures::of(&discretisation.scene, 0, solution.part(0));
    Ok(measures.peak.pressure / reference.pressure)
}

impl Cut {
    fn is_refused(&self) -> bool {
        self.seen.is_refused(Why::BeyondCandidates)
    }

    fn cell(&self) -> String {
        let refused = if self.accepted.is_some() { "" } else { "refused, else " };
        format!("{refused}{}", percent(self.unchecked))
    }
}

impl ShortCandidates {
    pub(super) fn judge(&self) -> Vec<Judged> {
        let refusing = self.stretches[EXACT].iter().filter(|cut| cut.is_refused()).count();
        let accepting = self.stretches[CUT][1..].iter().filter(|cut| !cut.is_refused()).count();
        vec![
            Check::none(
                Quantity::at("mesh that refuses candidates ending where the contact ends", "L = a"),
                "beyond the true edge the surfaces part: nothing penetrates",
            )
            .judge(refusing as f64),
            Check::none(
                Quantity::at(
                    "mesh that accepts candidates too short by more than a node spacing",
                    "L = 0.9 a, 8 and 16 elements",
                ),
                "the node beyond the end then lies inside the true contact and penetrates",
            )
            .judge(accepting as f64),
            Check::error(
                "largest error of p₀ of what is accepted",
                Reference::analytic("Hertz", 0.0),
                1e-2,
                "what no node can see is shorter than a node spacing, and enters the peak squared",
            )
            .judge(largest(self.stretches.iter().flatten().filter_map(|cut| cut.accepted))),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let onset = |(mesh, elements): (usize, &usize)| {
            let onset = bracket(&STRETCHES, |i| self.stretches[i][mesh].is_refused(), "L/a");
            format!("{elements} elements per a: {onset}")
        };
        let shortest = self.stretches.iter().rev().find_map(|[.., fine]| fine.seen.refusal());
        let [seen, instead] = told(shortest);
        Limit {
            pushed: "candidate surface shorter than the true contact",
            range: range(&STRETCHES, "L/a"),
            onset: ELEMENTS.iter().enumerate().map(onset).collect::<Vec<_>>().join("; "),
            seen,
            instead,
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(stretch, cuts): (f64, &[Cut; 3])| {
            std::iter::once(number(stretch)).chain(cuts.iter().map(Cut::cell)).collect()
        };
        Detail::of(
            "Truncated Hertz, candidates ending at L: what is refused, and how wrong it would have been",
            &["L / a", "error of p₀, 4 elements per a", "8 elements", "16 elements"],
            STRETCHES.into_iter().zip(&self.stretches).map(row),
        )
    }
}
