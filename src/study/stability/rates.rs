//! Rates of convergence: on the final active set by the condensed matrices, beforehand by Hertz's closed form, and as
//! measured.

use crate::algorithm::{ContactProblem, StiffnessRule};
use crate::case::library::{Cylinder, TruncatedHertz};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::larger;
use crate::measure::profile::weighted_line;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solution::Solution;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, linear, rate};
use crate::study::method::Method;

/// Initial stiffnesses of the rate studies: constant stiffness depends on them, varying stiffness does not.
const STARTS: [f64; 9] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
const FEW_STARTS: [f64; 3] = [0.1, 3.0, 100.0];
/// Misplaced force between which the rate is measured, in the latter half of the iterations: below the first the active
/// set is final, above the last is no round-off.
const WINDOW: [f64; 2] = [1e-5, 2e-12];
/// The least error of a run, times this, is still above what springs at their limit leave.
const ABOVE_LEAST: f64 = 20.0;
/// Iterations that half must hold.
const STEPS: usize = 20;
/// Tolerance and limit of iterations of a run whose rate is measured.
const TOLERANCE: f64 = 1e-12;
const LIMIT: usize = 12_000;

/// A scene with candidates over the half-width.
type Stretched = fn(f64) -> Scene;
/// Scenes whose half-width is known beforehand.
pub(super) const SCENES: [(&str, Stretched); 2] = [
    ("truncated hertz", |stretch| TruncatedHertz { stretch, ..Default::default() }.scene()),
    ("cylinder", |stretch| Cylinder { stretch, ..Default::default() }.scene()),
];

/// A start of a method, predicted and measured.
#[derive(Clone, Copy, Debug)]
pub struct Rate {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Spectral radius on the final active set; NaN where there is none.
    pub predicted: f64,
    /// Slope of the linearised iteration over the measured errors; constant stiffness alone has one.
    pub linearised: Option<f64>,
    /// Measured rate; none where there are too few iterations to measure it.
    pub measured: Option<f64>,
}

/// Truncated Hertz whose contact edge lies on no node: on one, a point neither open nor closed converges at no rate at
/// all.
pub(super) fn discretised() -> Result<Discretisation, Error> {
    let case = TruncatedHertz { stretch: 1.9, ..Default::default() }.case();
    Discretisation::of(case.scene, case.resolution)
}

/// The contact that an iteration ends in.
pub(super) fn limit(problem: &ContactProblem) -> Result<Limit, Error> {
    Limit::of(problem).ok_or_else(|| {
        Error::at(
            "stability",
            "the problem on which rates are predicted has no discrete solution",
            "give it a scene whose contact holds its bodies",
        )
    })
}

/// Every start of a method: constant stiffness with `correction`, or varying stiffness with `secant`.
pub fn rates(method: Method) -> Result<Vec<Rate>, Error> {
    let discretisation = discretised()?;
    let starts: &[f64] = if method.algorithm == Iteration::Varying { &FEW_STARTS } else { &STARTS };
    starts.iter().map(|&stiffness| start(&discretisation, method, stiffness)).collect()
}

fn start(discretisation: &Discretisation, method: Method, stiffness: f64) -> Result<Rate, Error> {
    let formulation = to_the_end(method, stiffness);
    let measured = measured(&discretisation.solve(&formulation)?);
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let limit = limit(&problem)?;
    let predicted = match formulation.rule {
        StiffnessRule::Correction => rate::correction(&problem, &limit.closed),
        _ => rate::secant(&problem, &limit.target(&problem), &limit.approach, 0.0),
    };
    // Mean slope of constant stiffness linearised on its final active set, between the errors that were measured.
    let slope = |errors: [f64; 2]| {
        let [first, last] = errors.map(|error| linear::iterations(&problem, &limit, |error| error.force, error));
        first.zip(last).map(|(first, last)| ((errors[1] / errors[0]).ln() / (last - first)).exp())
    };
    let constant = measured.filter(|_| formulation.algorithm == Iteration::Constant);
    Ok(Rate {
        stiffness,
        predicted: predicted.unwrap_or(f64::NAN),
        linearised: constant.and_then(|(_, errors)| slope(errors)),
        measured: measured.map(|(rate, _)| rate),
    })
}

/// A run that goes on until its rate can be measured.
fn to_the_end(method: Method, stiffness: f64) -> Formulation {
    let mut formulation = method.formulation(stiffness).tolerance(TOLERANCE);
    formulation.settings.max_iterations = LIMIT;
    formulation
}

/// Slope of the errors in the latter half of the window, and between which errors; none where that holds too few
/// iterations.
fn measured(solution: &Solution) -> Option<(f64, [f64; 2])> {
    let errors: Vec<f64> = solution.history.iter().map(|iteration| iteration.error.force).collect();
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    let [from, to] = [WINDOW[0], WINDOW[1].max(ABOVE_LEAST * least)];
    let first = errors.iter().rposition(|r| *r > from).map_or(0, |index| index + 1);
    let within: Vec<f64> = errors[first..].iter().copied().take_while(|r| *r > to).collect();
    let latter = &within[within.len() / 2..];
    if latter.len() < STEPS {
        return None;
    }
    let line: Vec<[f64; 3]> = latter.iter().enumerate().map(|(step, r)| [step as f64, r.ln(), 1.0]).collect();
    Some((weighted_line(&line).1.exp(), [latter[0], latter[latter.len() - 1]]))
}

/// Rates between which prediction and measurement are compared: faster ones leave no iterations to measure.
pub(super) const MEASURABLE: [f64; 2] = [0.05, 0.999];
/// Where the slope of the linearised iteration over the measured errors differs from ln ρ by more than this, the start
/// hardly holds the slowest mode and round-off comes before it is alone: by prediction, no rate is to be measured
/// there.
const ALONE: f64 = 0.02;
/// Error of ln ρ that is accepted.
pub(super) const ACCEPTED: f64 = 0.05;

impl Rate {
    /// Against its spectral radius; none where by the linearised iteration the slowest mode is not alone above
    /// round-off.
    fn asymptotic(&self) -> Option<Judged> {
        let alone = self.linearised.is_none_or(|slope| (slope.ln() / self.predicted.ln() - 1.0).abs() <= ALONE);
        alone.then(|| self.against("spectral radius", self.predicted))
    }

    /// Measured against predicted rate, by their logarithms: the iterations a decade takes.
    pub fn against(&self, prediction: &str, predicted: f64) -> Judged {
        let measured = self.measured.unwrap_or(f64::NAN);
        Check::error(
            Quantity::at("error of ln ρ, ρ the rate of convergence", format!("κ₀ = {}", self.stiffness)),
            Reference::own(prediction, 0.0),
            ACCEPTED,
            "asymptotic: slope of the last errors against what the condensed matrices say on the final active set",
        )
        .judge((measured.ln() - predicted.ln()).abs() / predicted.ln().abs())
    }
}

/// Every start against each of its predictions.
pub fn judge_rates(starts: &[Rate]) -> Vec<Judged> {
    let is_measurable =
        |start: &&Rate| start.measured.is_some() && (MEASURABLE[0]..=MEASURABLE[1]).contains(&start.predicted);
    // The linearised iteration over the same errors, which constant stiffness has.
    let followed = |start: &Rate| start.linearised.map(|slope| start.against("linearised iteration", slope));
    let compared = starts.iter().filter(is_measurable);
    compared.flat_map(|start| [followed(start), start.asymptotic()]).flatten().collect()
}

/// Every start with the name of its method, predicted and measured.
pub(super) fn table_of_rates(starts: &[(&str, &Rate)]) -> String {
    fn optional(rate: Option<f64>) -> String {
        rate.map_or("–".into(), |rate| format!("{rate:.6}"))
    }
    let columns: [Column<(&str, &Rate)>; 5] = [
        ("method", |(method, _)| method.to_string()),
        ("κ₀", |(_, start)| start.stiffness.to_string()),
        ("measured", |(_, start)| optional(start.measured)),
        ("predicted ρ", |(_, start)| format!("{:.6}", start.predicted)),
        ("linearised, same errors", |(_, start)| optional(start.linearised)),
    ];
    markdown::columns(&columns, starts)
}

/// Candidates over the half-width, and elements per half-width.
const STRETCHES: [f64; 3] = [1.3, 1.9, 2.4];
const ELEMENTS: [usize; 3] = [4, 8, 16];
/// Factor on ln ρ within which Hertz's closed form says the rate before the contact is solved: where in the contact
/// edge's element the discrete contact ends, it does not know.
const BEFORE: f64 = 2.0;

/// The rate of varying stiffness on the nodes of a mesh, as Hertz's closed form says it before anything is solved, and
/// measured.
#[derive(Clone, Copy, Debug)]
pub struct Before {
    /// Candidate stretch over the half-width.
    pub stretch: f64,
    /// Elements per half-width.
    pub elements: usize,
    /// Place of the first node outside the contact, over the half-width; infinite where there is none.
    pub place: f64,
    /// Rate by the closed form.
    pub predicted: f64,
    /// Measured rate; none where it cannot be measured.
    pub measured: Option<f64>,
}

impl Before {
    /// On a mesh of a scene.
    fn of(stretched: Stretched, stretch: f64, elements: usize) -> Result<Self, Error> {
        let scene = stretched(stretch);
        let half_width = scene.reference.length;
        let discretisation =
            Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })?;
        let formulation = to_the_end(Method::usual(Element::Node, Iteration::Varying), 1.0);
        let points = discretisation.points(&formulation);
        let outside = points.iter().map(|point| point.position / half_width).filter(|place| *place > 1.0);
        let place = outside.fold(f64::INFINITY, f64::min);
        let measured = measured(&discretisation.solve(&formulation)?).map(|(rate, _)| rate);
        Ok(Self { stretch, elements, place, predicted: rate::outside_hertz(place), measured })
    }

    /// ln ρ as measured over ln ρ by the closed form; none where it cannot be measured.
    fn ratio(&self) -> Option<f64> {
        self.measured.map(|measured| measured.ln() / self.predicted.ln())
    }
}

/// Every mesh of a scene whose half-width is known beforehand.
pub(super) fn before(scene: Stretched) -> Result<Vec<Before>, Error> {
    let meshes = STRETCHES.iter().flat_map(|&stretch| ELEMENTS.map(|elements| (stretch, elements)));
    meshes.map(|(stretch, elements)| Before::of(scene, stretch, elements)).collect()
}

/// The rate that Hertz's closed form says, against the measured one.
pub fn judge_before(meshes: &[Before]) -> Judged {
    let factors: Vec<f64> = meshes.iter().filter_map(Before::ratio).map(|ratio| larger(ratio, 1.0 / ratio)).collect();
    Check::at_most(
        "largest factor between ln ρ by Hertz's closed form and as measured",
        Reference::own("factor accepted", BEFORE),
        "nothing is solved for it: w/g of Hertz's contact at the first node outside; where in its element the discrete \
        contact ends it does not know",
    )
    .asked_of(factors.len())
    .judge(factors.into_iter().reduce(larger).unwrap_or(f64::NAN))
}

/// Every mesh with the name of its scene, predicted by the closed form and measured.
pub(super) fn table_of_before(meshes: &[(&str, &Before)]) -> String {
    let columns: [Column<(&str, &Before)>; 7] = [
        ("scene", |(scene, _)| scene.to_string()),
        ("L/a", |(_, mesh)| mesh.stretch.to_string()),
        ("elements per a", |(_, mesh)| mesh.elements.to_string()),
        ("first node outside, x/a", |(_, mesh)| format!("{:.4}", mesh.place)),
        ("ρ by Hertz", |(_, mesh)| format!("{:.5}", mesh.predicted)),
        ("measured ρ", |(_, mesh)| mesh.measured.map_or("–".into(), |measured| format!("{measured:.5}"))),
        ("ln ρ: measured / Hertz", |(_, mesh)| mesh.ratio().map_or("–".into(), |ratio| format!("{ratio:.2}"))),
    ];
    markdown::columns(&columns, meshes)
}
