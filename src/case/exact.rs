//! Cases with exact solutions: patch test, two bars, own weight, press fit, flat punch.

use crate::case::library::{Bars, FlatPunch, OwnWeight, Patch, PressFit};
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::{Quantity, ReferenceKind};
use crate::scene::PlaneHypothesis;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::{Trial, trials as trials_of};

/// Factors on the start stiffness of neighbouring points in the patch test.
const UNEVEN: [f64; 5] = [1.0, 30.0, 5.0, 100.0, 10.0];
/// Pushes of the two bars, over the gap.
const PUSHES: [f64; 3] = [0.5, 1.5, 3.0];
/// Load increments of the two bars.
const INCREMENTS: [usize; 3] = [1, 2, 7];

/// Trials of all exact cases.
pub fn trials() -> Vec<Trial> {
    let mut all = Vec::new();
    for (case, order) in [("patch, 4-node", Order::Linear), ("patch, 8-node", Order::Quadratic)] {
        let problem = Problem::new("patch", "two blocks under uniform pressure", problem::patch(Patch::default()));
        let uneven =
            |f: Formulation| Formulation { stiffness_pattern: UNEVEN.to_vec(), stiffness: 1.0, ..f }.tolerance(1e-11);
        let formulations = Formulation::nine().into_iter().map(uneven).collect();
        all.extend(trials_of(
            case,
            problem.clone(),
            Resolution { order, ..problem.resolution },
            formulations,
            Some(uniform),
        ));
    }
    for push in PUSHES {
        let problem =
            Problem::new("bars", "two bars closing a gap", problem::bars(Bars { push, ..Default::default() }));
        all.extend(trials_of(
            &format!("bars, u/g = {push}"),
            problem.clone(),
            problem.resolution,
            bars(),
            Some(bilinear),
        ));
    }
    let touching =
        Problem::new("bars", "two bars just touching", problem::bars(Bars { push: 1.0, ..Default::default() }));
    all.extend(trials_of("bars, u/g = 1 (reported)", touching.clone(), touching.resolution, bars(), None));
    for (case, order) in [("own weight, 4-node", Order::Linear), ("own weight, 8-node", Order::Quadratic)] {
        let problem = Problem::new("own-weight", "own weight", problem::own_weight(OwnWeight::default()));
        let resolution = Resolution { order, ..problem.resolution };
        all.extend(trials_of(case, problem, resolution, vec![Formulation::verification()], Some(weight)));
    }
    for (case, plane) in
        [("press fit, plane stress", PlaneHypothesis::Stress), ("press fit, plane strain", PlaneHypothesis::Strain)]
    {
        let problem =
            Problem::new("press-fit", "press fit", problem::press_fit(PressFit { plane, ..Default::default() }));
        let constant = Formulation::new(Element::Node, Iteration::Constant).tolerance(1e-8);
        all.extend(trials_of(
            case,
            problem.clone(),
            problem.resolution,
            vec![Formulation::verification(), constant],
            Some(lame),
        ));
    }
    for size in [20.0, 40.0] {
        let problem =
            Problem::new("flat-punch", "flat punch", problem::flat_punch(FlatPunch { size, ..Default::default() }));
        let case = format!("flat punch, block {size} half-widths");
        all.extend(trials_of(
            &case,
            problem.clone(),
            problem.resolution,
            vec![Formulation::verification()],
            Some(punch),
        ));
    }
    all
}

fn bars() -> Vec<Formulation> {
    let of = |algorithm, increments| {
        let mut formulation = Formulation::new(Element::Node, algorithm).tolerance(1e-12);
        formulation.settings.increments = increments;
        formulation
    };
    Iteration::ALL.into_iter().flat_map(|algorithm| INCREMENTS.map(move |n| of(algorithm, n))).collect()
}

/// Largest deviation of any point from the oracle's pressure, over the scale; NaN counts as a deviation.
fn worst_deviation(problem: &Problem, run: &Run, scale: f64) -> f64 {
    let deviation = |p: &crate::solution::PointState| (p.pressure - problem.reference_pressure(p.position)).abs();
    let worst = run.solution.points.iter().map(deviation).fold(0.0, |a: f64, d| if d.is_nan() { d } else { a.max(d) });
    if run.solution.converged() { worst / scale } else { f64::NAN }
}

fn pressure_everywhere(problem: &Problem, run: &Run, requirement: &str, tolerance: f64, because: &str) -> Vec<Judged> {
    let scale = problem.scene.reference.pressure;
    let name = problem.oracle.as_ref().map_or("none", |oracle| oracle.name()).to_string();
    let reference = Reference { name, kind: ReferenceKind::Analytic, value: problem.reference_pressure(0.0) };
    let error = worst_deviation(problem, run, scale);
    vec![Judged::norm(requirement, "max |p − p_ref| / p_scale", error, reference, tolerance, because)]
}

fn uniform(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let requirement = "A uniform pressure shall be transmitted uniformly, whatever the start stiffness of each point";
    Ok(pressure_everywhere(problem, run, requirement, 1e-8, "exact in the discrete space; iterated to 1e-11"))
}

fn bilinear(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let requirement = "Two bars shall carry nothing before the gap is closed and F = EA(u − g)/(L₁ + L₂) after";
    Ok(pressure_everywhere(problem, run, requirement, 1e-9, "exact in the discrete space; iterated to 1e-12"))
}

fn weight(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let requirement = "A block shall rest on its plane with p = ρgH at every point";
    Ok(pressure_everywhere(
        problem,
        run,
        requirement,
        1e-9,
        "exact in the discrete space; iterated to 1e-8, balance to round-off",
    ))
}

fn lame(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let requirement = "The pressure of a press fit shall follow Lamé at every point";
    let scale = problem.reference_pressure(0.0);
    let reference = Reference::analytic("Lamé", scale);
    let error = worst_deviation(problem, run, scale);
    let because = "edges of 8-node cells are parabolas, not arcs";
    Ok(vec![Judged::norm(requirement, "max |p − p_ref| / p_ref", error, reference, 1e-4, because)])
}

fn punch(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let Some(oracle) = &problem.oracle else { return Ok(Vec::new()) };
    let reference = Reference::read(oracle.as_ref(), Quantity::Pressure { at: 0.0 });
    let pressure = run.solution.points.first().map_or(f64::NAN, |p| p.pressure);
    Ok(vec![Judged::relative(
        "Under a flat punch p(0) shall be P/πa",
        "p(0)",
        pressure,
        reference,
        5e-3,
        "the block is finite: two sizes are shown; the corner singularity is resolved to a/250",
    )])
}
