//! Varying stiffness with `correction`: stable where predicted when started next to the contact, and cycling from afar.

use crate::algorithm::{Algorithm, ContactProblem, Springs, StiffnessRule, Varying};
use crate::case::{Judged, Reference};
use crate::contact::ContactPoint;
use crate::error::{Error, Kind};
use crate::solution::Work;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, rate};
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the trials.
pub const BASIN: &str = "varying stiffness with correction, near and far";

/// Initial stiffnesses around the boundary.
const STARTS: [f64; 10] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// Relative change of the limit's springs at the start, steps followed, and what error tells staying from leaving.
const NUDGE: f64 = 1e-3;
const STEPS: usize = 3000;
const LEFT: f64 = 1e-2;

/// One trial an element.
pub(super) fn trials() -> Vec<Trial> {
    Element::ALL.map(|element| Trial::new(BASIN, element.name(), move || near_and_far(element))).into()
}

fn near_and_far(element: Element) -> Result<Finding, Error> {
    let problem = super::truncated();
    let discretisation = Discretisation::of(problem.scene.clone(), problem.resolution)?;
    let (mut rows, mut wrong, mut judged) = (Vec::new(), 0, 0);
    for stiffness in STARTS {
        let base = Formulation::new(element, Iteration::Varying);
        let formulation = Formulation { rule: StiffnessRule::Correction, stiffness, ..base };
        let points: Vec<ContactPoint> = discretisation.points(&formulation);
        let problem = discretisation.problem(&formulation, &points);
        let limit = Limit::of(&problem);
        let rate = limit.as_ref().and_then(|limit| rate::varying_correction(&problem, limit)).unwrap_or(f64::NAN);
        let stays = limit.is_some_and(|limit| stays(&problem, &limit));
        judged += 1;
        wrong += usize::from(rate.is_nan() || stays != (rate < 1.0));
        let far = match discretisation.solve(&formulation) {
            Ok(solution) => format!("{} after {}", solution.outcome, solution.work.steps),
            Err(error @ Error { kind: Kind::NoSpringLeft { .. }, .. }) => error.to_string(),
            Err(error) => return Err(error),
        };
        let near = if stays { "stays" } else { "leaves" };
        rows.push(vec![element.name().into(), stiffness.to_string(), format!("{rate:.3}"), near.into(), far]);
    }
    let check = Judged::at_most(
        "Started next to the contact, varying stiffness with correction shall stay if and only if its spectral radius is below 1",
        format!("starts of {judged} that do otherwise"),
        if judged == 0 { f64::NAN } else { wrong as f64 },
        Reference::own("predicted", 0.0),
        "the boundary is where 2 (S + K*) − max(K*, K₀) ceases to be positive definite on the closed points",
    );
    let table = Table { title: BASIN.into(), head: HEAD.map(String::from).into(), rows };
    Ok(Finding { checks: vec![check], tables: vec![table], ..Default::default() })
}

/// Columns of the table.
pub const HEAD: [&str; 5] = ["element", "κ₀", "predicted ρ", "next to the contact", "from equal springs"];

/// Whether springs nudged off the limit's bring the error down, or away.
fn stays(problem: &ContactProblem, limit: &Limit) -> bool {
    let nudge =
        |(i, k): (usize, &f64)| problem.scale.clip(k * (1.0 + NUDGE * ((0.618 * (i + 1) as f64).fract() - 0.5)));
    let stiffness: Vec<f64> = limit.target(problem).iter().enumerate().map(nudge).collect();
    let mut springs = Springs { force: vec![0.0; stiffness.len()], stiffness };
    let mut algorithm = Varying::new(StiffnessRule::Correction);
    let mut error = f64::NAN;
    for _ in 0..STEPS {
        let Some(iterate) = algorithm.step(problem, problem.load, &mut springs, &mut Work::default()) else {
            return false;
        };
        error = limit.error(problem, iterate.pressure, iterate.approach).largest();
    }
    error < LEFT * NUDGE
}
