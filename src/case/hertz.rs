//! The Hertz cases: truncated Hertz, and the cylinder of the paper.

use crate::case::library::{Cylinder, TruncatedHertz};
use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::Resolution;
use crate::oracle::Quantity;
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Trial, trials as trials_of};

/// Name of the case of all nine on the cylinder.
pub const CYLINDER: &str = "cylinder";
/// Name of the case of all nine on truncated Hertz.
pub const TRUNCATED: &str = "truncated hertz";

/// Trials of the Hertz cases.
pub fn trials() -> Vec<Trial> {
    let truncated =
        Problem::new("truncated-hertz", "truncated Hertz", problem::truncated_hertz(TruncatedHertz::default()));
    let cylinder = Problem::new("cylinder", "cylinder", problem::cylinder(Cylinder::default()));
    let small = Cylinder { a_over_r: 0.005, ..Default::default() };
    let small = Problem::new("cylinder", "cylinder, a/R = 0.005", problem::cylinder(small));
    let verification = || vec![Formulation::verification()];
    let mut all = trials_of(
        "truncated hertz, verification",
        truncated.clone(),
        truncated.resolution,
        verification(),
        Some(truncated_hertz),
    );
    all.extend(trials_of(TRUNCATED, truncated.clone(), truncated.resolution, Formulation::compared(), Some(nine)));
    all.extend(trials_of(
        "cylinder, verification",
        cylinder.clone(),
        cylinder.resolution,
        verification(),
        Some(default_cylinder),
    ));
    let fine = Resolution { elements: 16, ..small.resolution };
    all.extend(trials_of("cylinder, a/R = 0.005", small, fine, verification(), Some(small_cylinder)));
    all.extend(trials_of(CYLINDER, cylinder.clone(), cylinder.resolution, Formulation::compared(), Some(nine)));
    all
}

/// Relative errors of p₀, of a, and L2(p) over one and a half half-widths, against Hertz; NaN where the run did not converge.
///
pub fn errors(run: &Run, exact: &Hertz) -> [f64; 3] {
    if !run.solution.converged() {
        return [f64::NAN; 3];
    }
    let (points, measures) = (&run.solution.points, &run.measures());
    let pressure = |x: f64| exact.pressure(x);
    let away = |value: f64, reference: f64| (value - reference).abs() / reference;
    [
        away(measures.peak.pressure, exact.peak_pressure()),
        away(measures.half_width, exact.half_width()),
        profile::relative_l2(points, pressure, 1.5 * exact.half_width()),
    ]
}

/// Peak and half-width against the oracle.
fn peak_and_half_width(problem: &Problem, run: &Run, tolerance: [f64; 2], because: [&str; 2]) -> Vec<Judged> {
    let Some(oracle) = &problem.oracle else { return Vec::new() };
    let measures = converged(run);
    vec![
        Judged::relative(
            "Peak pressure shall follow Hertz",
            "p₀ [MPa]",
            measures.0,
            Reference::read(oracle.as_ref(), Quantity::PeakPressure),
            tolerance[0],
            because[0],
        ),
        Judged::relative(
            "Half-width shall follow Hertz",
            "a [mm]",
            measures.1,
            Reference::read(oracle.as_ref(), Quantity::SecondMoment),
            tolerance[1],
            because[1],
        ),
    ]
}

/// Peak and half-width of a converged run; NaN, which no check passes, of any other.
fn converged(run: &Run) -> (f64, f64) {
    if run.solution.converged() {
        (run.measures().peak.pressure, run.measures().half_width)
    } else {
        (f64::NAN, f64::NAN)
    }
}

fn truncated_hertz(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let because = ["8-node cells, 8 per half-width; no model error", "the edge lies between two nodes at worst"];
    let mut checks = peak_and_half_width(problem, run, [5e-4, 2e-3], because);
    let a = problem.scene.reference.length;
    let error = profile::relative_l2(&run.solution.points, |x| problem.reference_pressure(x), 1.5 * a);
    let name = problem.oracle.as_ref().map_or("none", |oracle| oracle.name());
    checks.push(Judged::norm(
        "The pressure profile shall follow Hertz",
        "L2(p)",
        if run.solution.converged() { error } else { f64::NAN },
        Reference::analytic(name, 0.0),
        1.5e-2,
        "square-root edge: order capped near 1",
    ));
    Ok(checks)
}

fn default_cylinder(problem: &Problem, discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let because = "model error at a/R = 0.05 plus discretisation; see the model error beside it";
    let mut checks = peak_and_half_width(problem, run, [1e-3, 1e-3], [because, because]);
    checks.push(size(discretisation, 4000.0));
    Ok(checks)
}

fn small_cylinder(problem: &Problem, discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let because =
        ["model error about 2e-5 at a/R = 0.005; 16 8-node cells per half-width", "the edge lies between two nodes"];
    let mut checks = peak_and_half_width(problem, run, [2e-4, 5e-4], because);
    checks.push(size(discretisation, 8000.0));
    Ok(checks)
}

fn nine(problem: &Problem, _: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let because = "engineering tolerance of the paper's comparison; iteration error to 3e-3";
    Ok(peak_and_half_width(problem, run, [1e-2, 1e-2], [because, because]))
}

/// No more than the scene needs.
fn size(discretisation: &Discretisation, limit: f64) -> Judged {
    let freedoms = discretisation.system.freedoms() as f64;
    Judged::at_most(
        "The mesh shall not need more freedoms than this",
        "freedoms",
        freedoms,
        Reference::own("at most", limit),
        "grading, not brute force",
    )
}
