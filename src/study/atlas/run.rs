//! What is run: points, each predicted from the condensed matrices before; and the paper's formulations beside what the
//! program takes in their place. And what the atlas must hold: the predictions are right, and what the program takes
//! converges.

use std::path::Path;

use rayon::prelude::*;

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::measure::larger;
use crate::solution::IterationError;
use crate::solve::{Discretisation, Element, Ended, Formulation, Iteration, Run, Settings};
use crate::stability::halving::{self, SOFT};
use crate::stability::{Limit, linear, rate, release};
use crate::study::Found;
use crate::study::atlas::plane::{self, Chart, Line, Plane, Record, STRETCH, Site};
use crate::study::method::Method;
use crate::study::records::{self as kept, rounded};

/// What came out of a trial; of a plane what was recorded.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// A plane.
    Surveyed(Chart),
    /// What acceleration and initial stiffness save each formulation on a scene of the paper.
    Saved(Plane, Vec<Saved>),
}

/// The surveyed planes of what was found.
pub fn charts<'a>(findings: &[Found<'a, Numbers>]) -> Vec<&'a Chart> {
    let chart = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Surveyed(chart) => Some(chart),
        Numbers::Saved(..) => None,
    });
    chart.collect()
}

/// A formulation as it stands in the paper, and as the program takes it: names, and iterations; none where it does not
/// converge.
pub type Saved = [(String, Option<usize>); 2];

/// A spectral radius up to here is 1 to round-off: pressures that no displacement feels stay as they are, and hurt
/// nobody.
const INDIFFERENT: f64 = 1.0 + 1e-6;
/// Most iterations of a formulation of the paper: more than any takes on the cylinder; on the pin–rod some take fifty
/// thousand, which would tell no more.
pub const ENOUGH: usize = 6_000;

/// Surveys a plane into a file; what is finished of it is kept in the folder `unfinished`.
pub fn renew(plane: Plane, unfinished: &Path, file: &Path, done: impl Fn() + Sync) -> Result<usize, Error> {
    kept::survey([unfinished, file], &plane::head(), &plane.sites(), Site::key, of_site, done)
}

/// Every line of a site, in the order of the record.
fn of_site(site: &Site) -> Result<Vec<Line>, Error> {
    let records: Vec<Record> = points(site, |_, _| true)?.into_iter().map(|(_, record)| record).collect();
    Ok(plane::lines(&records))
}

/// The points of a site that are chosen by the places of their method and of their initial stiffness, with these
/// places.
pub fn points(site: &Site, chosen: impl Fn(usize, usize) -> bool) -> Result<Vec<([usize; 2], Record)>, Error> {
    let case = site.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let (methods, stiffnesses) = (Method::all(), Plane::stiffnesses());
    // Every element has as many methods.
    let by_element: Vec<&[Method]> = methods.chunk_by(|a, b| a.element == b.element).collect();
    let grounds: Vec<Ground> =
        by_element.iter().map(|own| Ground::of(&discretisation, site.ordinate, own[0])).collect();
    let all = (0..methods.len()).flat_map(|row| (0..stiffnesses.len()).map(move |column| [row, column]));
    let places: Vec<[usize; 2]> = all.filter(|[row, column]| chosen(*row, *column)).collect();
    let fresh = |&[row, column]: &[usize; 2]| {
        let ground = &grounds[row / by_element[0].len()];
        Ok(([row, column], ground.record(methods[row], stiffnesses[column])?))
    };
    places.par_iter().map(fresh).collect()
}

/// What the points of one contact element on a site share.
pub struct Ground<'a> {
    discretisation: &'a Discretisation,
    ordinate: f64,
    points: Vec<ContactPoint>,
    limit: Option<Limit>,
}

impl<'a> Ground<'a> {
    /// Contact points of a method on a mesh, condensed, and the contact that it shall end in.
    pub fn of(discretisation: &'a Discretisation, ordinate: f64, method: Method) -> Self {
        let formulation = method.formulation(1.0);
        let points = discretisation.points(&formulation);
        let limit = Limit::of(&discretisation.problem(&formulation, &points));
        Self { discretisation, ordinate, points, limit }
    }

    /// Predicts and runs a method at an initial stiffness.
    pub fn record(&self, method: Method, stiffness: f64) -> Result<Record, Error> {
        let formulation = method.formulation(stiffness);
        let run = Run::of(self.discretisation, &formulation);
        let (class, iterations) = Ended::of(&run)?;
        let [error, penalty] = run.map_or([f64::NAN; 2], |run| [run.iteration_error(), run.penalty_error()]);
        Ok(Record {
            method,
            ordinate: self.ordinate,
            stiffness: rounded(stiffness),
            class,
            iterations,
            error: rounded(error),
            penalty: (method.rule == StiffnessRule::Penalty).then_some(rounded(penalty)),
            predicted_iterations: self.predicted(method, &formulation).map(rounded),
        })
    }

    /// The iterations that the spectral radius on the limit's active set asks for; the halving law for kinematic load;
    /// nothing of what is accelerated.
    fn predicted(&self, method: Method, formulation: &Formulation) -> Option<f64> {
        let limit = self.limit.as_ref()?;
        if method.is_accelerated() {
            return None;
        }
        let problem = self.discretisation.problem(formulation, &self.points);
        let tolerance = formulation.settings.tolerance;
        let (rate, iterations) = match (method.algorithm, method.rule) {
            (Iteration::Kinematic, StiffnessRule::Switching) => {
                let scene = &self.discretisation.scene;
                let stretch = scene.contact().stretch;
                let spacing = stretch / (self.discretisation.interfaces[0].nodes.len() - 1) as f64;
                let edge = limit.edge(&problem).max(spacing);
                let law = if scene.is_of_revolution() { halving::of_revolution } else { halving::iterations };
                return Some(law(stretch, edge, spacing, formulation.stiffness) as f64);
            }
            (Iteration::Constant, StiffnessRule::Correction) => {
                let iterations = linear::iterations(&problem, limit, IterationError::largest, tolerance);
                let iterations = iterations.map(|iterations| iterations.max(linear::worked_off(&problem, limit)));
                rate::correction(&problem, &limit.closed).zip(iterations)
            }
            (Iteration::Constant, StiffnessRule::Secant) => {
                rate::secant_force(&problem, limit).map(|rate| (rate, rate::iterations(rate, tolerance)))
            }
            (Iteration::Varying, rule) => {
                let rate = match rule {
                    StiffnessRule::Correction => rate::varying_correction(&problem, limit),
                    _ => rate::secant(&problem, &limit.target(&problem), &limit.approach, tolerance * limit.length()),
                };
                rate.zip(release::iterations(&problem, limit, rule, tolerance))
            }
            _ => None,
        }?;
        Some(if rate > INDIFFERENT { f64::INFINITY } else { iterations })
    }
}

/// Every formulation as it stands in the paper, for as long as it takes, and as the program takes it, on the mesh of
/// the library.
pub(super) fn saved(scene: Plane) -> Result<Numbers, Error> {
    let case = scene.case(STRETCH);
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let pairs = Formulation::nine().into_iter().zip(Formulation::compared());
    let of = |(mut paper, program): (Formulation, Formulation)| {
        paper.settings.max_iterations = ENOUGH;
        let ended = |formulation: &Formulation| {
            let solution = Run::of(&discretisation, formulation)?.solution;
            let (stiffness, unit) = (formulation.stiffness, formulation.stiffness_unit.name());
            let name = format!("{}, κ₀ = {stiffness:e} by the {unit}", formulation.name());
            Ok((name, solution.converged().then_some(solution.work.iterations)))
        };
        Ok([ended(&paper)?, ended(&program)?])
    };
    Ok(Numbers::Saved(scene, pairs.map(of).collect::<Result<_, Error>>()?))
}

/// Factor within which iterations on nodes are predicted, and factor off the limit of iterations from which a class is.
pub(super) const FACTOR: f64 = 2.5;
/// Iterations within which the halving law is met.
pub(super) const HALVINGS: f64 = 1.0;
/// From this κ₀ on starts are hard of a body of revolution too: where soft ones cease is known of plane scenes, and on
/// candidates that are little longer than the contact of the sphere κ₀ = 1 is still as soft.
pub(super) const HARD: f64 = 10.0;
/// Fewer iterations than this are over before a rate matters.
const FEW: usize = 20;

/// The checks of a plane.
pub(super) fn judge_chart(chart: &Chart) -> Vec<Judged> {
    [predicted(chart), vec![halved(chart), averaged(chart)]].concat()
}

/// Whether a run converged.
fn converged(record: &Record) -> bool {
    record.class == Ended::Converged
}

/// A converged run long enough to be judged by a prediction.
fn is_long(record: &Record) -> bool {
    converged(record) && record.iterations >= FEW && record.predicted_iterations.is_some_and(f64::is_finite)
}

/// Measured over predicted iterations or the inverse, whichever is above 1.
fn ratio(record: &Record) -> f64 {
    let ratio = record.iterations as f64 / record.predicted_iterations.unwrap_or(f64::NAN);
    ratio.max(1.0 / ratio)
}

/// Iterations between measured and predicted; NaN where a run did not converge.
fn iterations_off(record: &Record) -> f64 {
    let iterations = if converged(record) { record.iterations as f64 } else { f64::NAN };
    (iterations - record.predicted_iterations.unwrap_or(f64::NAN)).abs()
}

/// Whether a run is predicted to fail: far more iterations than the limit.
fn shall_fail(record: &Record) -> bool {
    record.predicted_iterations.is_some_and(|predicted| predicted > FACTOR * Settings::default().max_iterations as f64)
}

/// Whether it is predicted to converge: far fewer.
fn shall_converge(record: &Record) -> bool {
    record.predicted_iterations.is_some_and(|predicted| predicted * FACTOR <= Settings::default().max_iterations as f64)
}

/// Of a method how many runs converged of those predicted to fail, failed of those predicted to converge, and took
/// iterations off by more than [`FACTOR`], or under kinematic load by more than [`HALVINGS`], each with of how many;
/// none where nothing is predicted.
pub(super) fn agreement(charts: &[&Chart], method: Method) -> Option<[[usize; 2]; 3]> {
    let all: Vec<&Record> = charts.iter().flat_map(|chart| chart.of_method(method)).flatten().collect();
    let share = |of: fn(&Record) -> bool, counted: fn(&Record) -> bool| {
        let of: Vec<&&Record> = all.iter().filter(|record| of(record)).collect();
        [of.iter().filter(|record| counted(record)).count(), of.len()]
    };
    // A run that does not converge is no number of iterations off: it is counted as failed.
    let off = match method.algorithm {
        Iteration::Kinematic => share(|r| r.predicted_iterations.is_some(), |r| iterations_off(r) > HALVINGS),
        _ => share(is_long, |r| ratio(r) > FACTOR),
    };
    let is_predicted = all.iter().any(|record| record.predicted_iterations.is_some());
    is_predicted.then(|| [share(shall_fail, converged), share(shall_converge, |r| !converged(r)), off])
}

/// The largest; NaN where any is or there is none.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.reduce(larger).unwrap_or(f64::NAN)
}

/// Three predictions that are made of a rate: what fails, what converges, and in how many iterations.
fn predicted(chart: &Chart) -> Vec<Judged> {
    let is = |r: &Record, algorithm, rule| (r.method.algorithm, r.method.rule) == (algorithm, rule);
    // The instability of constant stiffness with secant sits in the point nearest the centre: where that point's whole
    // gap is below the tolerance, it may swing unseen by the error. Varying stiffness with correction does not go to
    // its limit from afar.
    let is_unseen = |r: &Record| is(r, Iteration::Constant, StiffnessRule::Secant);
    let is_attracted_nearby = |r: &Record| is(r, Iteration::Varying, StiffnessRule::Correction);
    let records = || {
        let all = chart.rows.iter().flatten();
        all.filter(|r| r.method.algorithm != Iteration::Kinematic && !is_unseen(r))
    };
    let on_nodes = || records().filter(|r| r.method.element == Element::Node);
    let failing: Vec<&Record> = records().filter(|r| shall_fail(r)).collect();
    let ending: Vec<&Record> = on_nodes().filter(|r| shall_converge(r) && !is_attracted_nearby(r)).collect();
    let ratios: Vec<f64> = on_nodes().filter(|r| is_long(r)).map(ratio).collect();
    let named = |records: &[&Record]| {
        let mut names: Vec<String> = records.iter().map(|r| r.method.to_string()).collect();
        names.sort_unstable();
        names.dedup();
        names.join(" or ")
    };
    let never_converge = Check::none(
        "run, but of constant stiffness with secant, that converges where the condensed matrices predict failure",
        format!(
            "spectral radius above 1, or more than {FACTOR} times the limit of iterations; what swings below the \
            tolerance may be called converged"
        ),
    )
    .asked_of(failing.len())
    .judge(failing.iter().filter(|r| converged(r)).count() as f64);
    let always_converge = Check::none(
        Quantity::at(format!("run of {} that fails where it is predicted to converge", named(&ending)), ""),
        format!(
            "less than the limit of iterations over {FACTOR}; other methods are in the table of predictions and not \
            judged: varying stiffness with correction is attracted from nearby only"
        ),
    )
    .asked_of(ending.len())
    .judge(ending.iter().filter(|r| !converged(r)).count() as f64);
    let in_iterations = Check::at_most(
        "largest factor between predicted and measured iterations on nodes",
        Reference::own("factor accepted", FACTOR),
        "constant stiffness linearised on the final active set, or its gaps worked off; varying stiffness by its \
        points near the edge, each alone: on fine meshes their neighbours help",
    );
    let in_iterations = in_iterations.asked_of(ratios.len()).judge(worst(ratios.iter().copied()));
    vec![never_converge, always_converge, in_iterations]
}

/// Kinematic load on nodes against the halving law; soft starts not where their threshold was taken, nor of bodies of
/// revolution. The last closed point of the pin–rod is that of the solved contact.
pub(super) fn halved(chart: &Chart) -> Judged {
    let (which, least) = match chart.plane {
        Plane::Cylinder | Plane::PinRod => ("any start", 0.0),
        Plane::Sphere => ("hard starts", HARD),
        Plane::Stretch | Plane::Mesh => ("starts that are not soft", SOFT),
    };
    let switching = chart.of_method(Method::usual(Element::Node, Iteration::Kinematic)).flatten();
    let check = Check::at_most(
        Quantity::at("largest number of iterations off the halving law on nodes under kinematic load", which),
        Reference::own("halving of L² − a²", HALVINGS),
        "the law counts halvings; the last one may end anywhere within a node spacing",
    );
    check.judge(worst(switching.filter(|r| r.stiffness >= least).map(iterations_off)))
}

/// Constant stiffness with correction, by itself: whatever the scene and the start, it neither diverges nor cycles.
pub(super) fn averaged(chart: &Chart) -> Judged {
    let plain = Element::ALL.map(|element| Method::usual(element, Iteration::Constant));
    let own: Vec<&Record> = chart.rows.iter().flatten().filter(|r| plain.contains(&r.method)).collect();
    let wrong = own.iter().filter(|r| [Ended::Diverged, Ended::Cycling].contains(&r.class)).count();
    let what = "run of constant stiffness with correction that diverges or cycles";
    let because =
        "predicted before any contact is solved: an averaged map comes no farther from its limit at any iteration";
    Check::none(what, because).asked_of(own.len()).judge(wrong as f64)
}

/// What the program takes converges, all nine of it.
pub(super) fn taken(scene: &str, saved: &[Saved]) -> Vec<Judged> {
    let converging = Check::none(
        Quantity::at("formulation that does not converge as the program takes it", scene),
        "acceleration, κ₀ and tolerance are chosen so that all nine do",
    );
    let failing = saved.iter().filter(|[_, (_, program)]| program.is_none()).count();
    vec![converging.judge(failing as f64)]
}
