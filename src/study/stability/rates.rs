//! Rates of constant stiffness with `correction` and varying stiffness with `secant`: predicted against measured.

use crate::algorithm::StiffnessRule;
use crate::case::{Judged, Reference, Verdict};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::measure::profile::weighted_line;
use crate::solution::Solution;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, linear, rate};
use crate::study::unsorted::{Finding, Table, Trial};

/// Initial stiffnesses of the rate studies: constant stiffness depends on them, varying stiffness does not.
const STARTS: [f64; 9] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
const FEW_STARTS: [f64; 3] = [0.1, 3.0, 100.0];
/// Rates between which prediction and measurement are compared: faster ones leave no steps to measure.
const MEASURABLE: [f64; 2] = [0.05, 0.999];
/// Misplaced force between which the rate is measured, in the latter half of the steps: below the first the contact set is
/// final, above the last is no round-off.
const WINDOW: [f64; 2] = [1e-5, 2e-12];
/// The least error of a run, times this, is still above what springs at their limit leave.
const ABOVE_LEAST: f64 = 20.0;
/// Steps that half must hold.
const STEPS: usize = 20;
/// Where the slope of the linearised iteration over the measured errors differs from ln ρ by more than this, the start
/// hardly holds the slowest mode and round-off comes before it is alone: the linearised slope is the prediction.
const ALONE: f64 = 0.02;
/// Starts that must be compared for each element and algorithm.
const COMPARED: f64 = 3.0;
/// Error of ln ρ that is accepted.
const ACCEPTED: f64 = 0.05;

/// Trials of the rates.
pub(super) fn trials() -> Vec<Trial> {
    let mut trials: Vec<Trial> = Vec::new();
    for element in Element::ALL {
        let name = format!("{}.constant.correction", element.name());
        trials.push(Trial::new(RATES, name, move || rates(element, Iteration::Constant)));
        let name = format!("{}.varying.secant", element.name());
        trials.push(Trial::new(RATES, name, move || rates(element, Iteration::Varying)));
    }
    trials
}

/// Columns of the tables of rates.
pub const RATES_HEAD: [&str; 8] = [
    "formulation",
    "κ₀",
    "predicted ρ",
    "linearised, same errors",
    "measured",
    "ln ρ off",
    "linearised off",
    "verdict",
];
/// Name of the trials of rates.
pub const RATES: &str = "predicted rate of convergence";

fn rates(element: Element, algorithm: Iteration) -> Result<Finding, Error> {
    let problem = super::truncated();
    let discretisation = Discretisation::of(problem.scene.clone(), problem.resolution)?;
    let (mut rows, mut checks) = (Vec::new(), Vec::new());
    let starts: &[f64] = if algorithm == Iteration::Varying { &FEW_STARTS } else { &STARTS };
    for &stiffness in starts {
        let mut formulation = Formulation { stiffness, ..Formulation::new(element, algorithm) }.tolerance(1e-12);
        formulation.settings.max_steps = 12_000;
        let (row, check) = one_start(&discretisation, &formulation)?;
        rows.push(row);
        checks.extend(check);
    }
    checks.push(Judged::at_least(
        "Enough starts shall be compared with the prediction",
        "starts compared",
        checks.len() as f64,
        Reference::own("at least", COMPARED),
        "a prediction that is compared with nothing predicts nothing",
    ));
    let head = RATES_HEAD.map(String::from).into();
    let table = Table { title: RATES.into(), head, rows };
    Ok(Finding { checks, tables: vec![table], ..Default::default() })
}

/// The row of a start, and its check where there is enough to measure.
///
/// Held against ρ; where that fails and the linearised iteration departs from ρ over the same errors too, against its slope.
fn one_start(
    discretisation: &Discretisation,
    formulation: &Formulation,
) -> Result<(Vec<String>, Option<Judged>), Error> {
    let solution = discretisation.solve(formulation)?;
    let predicted = predicted(discretisation, formulation)?;
    let measured = measured(&solution);
    let linearised = linearised(discretisation, formulation, measured)?;
    let rate = measured.map_or(f64::NAN, |measured| measured.rate);
    let against = |expected: f64| rate_check(formulation.stiffness, expected, rate);
    let asymptotic = against(predicted);
    let followed = linearised.filter(|slope| (slope.ln() / predicted.ln() - 1.0).abs() > ALONE).map(against);
    let measurable = measured.is_some() && (MEASURABLE[0]..=MEASURABLE[1]).contains(&predicted);
    let passed = asymptotic.verdict == Verdict::Pass;
    let judgement = match &followed {
        _ if !measurable => "not measurable",
        _ if passed => "✓",
        Some(check) if check.verdict == Verdict::Pass => "✗ ρ, ✓ linearised",
        _ => "✗",
    };
    let optional = |rate: Option<f64>| rate.map_or("–".into(), |rate| format!("{rate:.6}"));
    let off = |expected: Option<f64>| match expected.filter(|_| measured.is_some()) {
        Some(expected) => format!("{:.1} %", 100.0 * against(expected).error),
        None => "–".into(),
    };
    let row = vec![
        formulation.name(),
        formulation.stiffness.to_string(),
        format!("{predicted:.6}"),
        optional(linearised),
        optional(measured.map(|measured| measured.rate)),
        off(Some(predicted)),
        off(linearised),
        judgement.into(),
    ];
    let check = if passed { asymptotic } else { followed.unwrap_or(asymptotic) };
    Ok((row, measurable.then_some(check)))
}

/// Measured against predicted rate, by their logarithms: the steps a decade takes.
pub fn rate_check(stiffness: f64, predicted: f64, measured: f64) -> Judged {
    Judged::norm(
        "The rate of convergence shall be what the condensed matrices predict",
        format!("ln ρ, κ₀ = {stiffness}"),
        (measured.ln() - predicted.ln()).abs() / predicted.ln().abs(),
        Reference::own("spectral radius", 0.0),
        ACCEPTED,
        "asymptotic: slope of the last errors against the spectral radius on the final contact set",
    )
}

/// The predicted rate on the limit.
fn predicted(discretisation: &Discretisation, formulation: &Formulation) -> Result<f64, Error> {
    let points: Vec<ContactPoint> = discretisation.points(formulation);
    let problem = discretisation.problem(formulation, &points);
    let Some(limit) = Limit::of(&problem) else { return Ok(f64::NAN) };
    let found = match formulation.rule {
        StiffnessRule::Correction => rate::correction(&problem, &limit.closed),
        _ => rate::secant(&problem, &limit.target(&problem), &limit.approach, 0.0),
    };
    Ok(found.unwrap_or(f64::NAN))
}

/// A slope of the errors, and between which of them.
#[derive(Clone, Copy)]
struct Measured {
    rate: f64,
    from: f64,
    to: f64,
}

/// Slope of the errors in the latter half of the window; none where that holds too few steps.
fn measured(solution: &Solution) -> Option<Measured> {
    let errors: Vec<f64> = solution.history.iter().map(|step| step.error.force).collect();
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    let [from, to] = [WINDOW[0], WINDOW[1].max(ABOVE_LEAST * least)];
    let first = errors.iter().rposition(|r| *r > from).map_or(0, |index| index + 1);
    let within: Vec<f64> = errors[first..].iter().copied().take_while(|r| *r > to).collect();
    let latter = &within[within.len() / 2..];
    if latter.len() < STEPS {
        return None;
    }
    let line: Vec<[f64; 3]> = latter.iter().enumerate().map(|(step, r)| [step as f64, r.ln(), 1.0]).collect();
    Some(Measured { rate: weighted_line(&line).1.exp(), from: latter[0], to: latter[latter.len() - 1] })
}

/// Mean slope of constant stiffness linearised on its final contact set, between the errors that were measured.
fn linearised(
    discretisation: &Discretisation,
    formulation: &Formulation,
    measured: Option<Measured>,
) -> Result<Option<f64>, Error> {
    let Some(Measured { from, to, .. }) = measured.filter(|_| formulation.algorithm == Iteration::Constant) else {
        return Ok(None);
    };
    let points: Vec<ContactPoint> = discretisation.points(formulation);
    let problem = discretisation.problem(formulation, &points);
    let Some(limit) = Limit::of(&problem) else { return Ok(None) };
    let steps = |tolerance: f64| linear::steps(&problem, &limit, |error| error.force, tolerance);
    Ok(steps(from).zip(steps(to)).map(|(first, last)| ((to / from).ln() / (last - first)).exp()))
}
