//! Why `secant` and `literal` fail with constant stiffness.

use crate::algorithm::StiffnessRule;
use crate::case::{Judged, Reference};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, rate};
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the trials.
pub const FAILING: &str = "constant stiffness, rules that fail";

/// Initial stiffnesses that are shown.
const STARTS: [f64; 5] = [0.1, 1.0, 1e2, 1e4, 1e6];

/// Columns of the table.
pub const HEAD: [&str; 7] = [
    "element",
    "κ₀",
    "largest κ*/2",
    "secant: predicted ρ",
    "secant: outcome",
    "literal: outcome",
    "literal: force left in open points, over the peak",
];

/// One trial an element.
pub(super) fn trials() -> Vec<Trial> {
    Element::ALL.map(|element| Trial::new(FAILING, element.name(), move || failing(element))).into()
}

fn failing(element: Element) -> Result<Finding, Error> {
    let problem = super::truncated();
    let discretisation = Discretisation::of(problem.scene.clone(), problem.resolution)?;
    let (mut rows, mut converged, mut least) = (Vec::new(), 0, f64::INFINITY);
    for stiffness in STARTS {
        let with = |rule| Formulation { rule, stiffness, ..Formulation::new(element, Iteration::Constant) };
        let secant = with(StiffnessRule::Secant);
        let points: Vec<ContactPoint> = discretisation.points(&secant);
        let problem = discretisation.problem(&secant, &points);
        let Some(limit) = Limit::of(&problem) else {
            least = f64::NAN;
            continue;
        };
        let asked = limit.target(&problem).into_iter().map(|k| problem.scale.clip(k)).fold(0.0, f64::max);
        let needed = 0.5 * asked / problem.scale.stiffness;
        let predicted = rate::secant_force(&problem, &limit).unwrap_or(f64::NAN);
        let [secant, literal] = [discretisation.solve(&secant)?, discretisation.solve(&with(StiffnessRule::Literal))?];
        converged += usize::from(secant.converged()) + usize::from(literal.converged());
        let left = force_left(&literal, &limit);
        least = if left.is_nan() || least.is_nan() { f64::NAN } else { least.min(left) };
        rows.push(vec![
            element.name().into(),
            format!("{stiffness:e}"),
            format!("{needed:.1e}"),
            if predicted > 10.0 { format!("{predicted:.0}") } else { format!("{predicted:.6}") },
            secant.outcome.to_string(),
            literal.outcome.to_string(),
            format!("{left:.1e}"),
        ]);
    }
    let head = HEAD.map(String::from).into();
    let table = Table { title: FAILING.into(), head, rows };
    Ok(Finding { checks: checks(converged, least), tables: vec![table], ..Default::default() })
}

fn checks(converged: usize, least: f64) -> Vec<Judged> {
    vec![
        Judged::at_most(
            "With constant stiffness neither secant nor literal shall reach the contact",
            "starts that converged",
            if least.is_nan() { f64::NAN } else { converged as f64 },
            Reference::own("predicted", 0.0),
            "secant needs springs of half what the gap-free point asks for; literal forgets Σ k Δw in its forces",
        ),
        Judged::at_least(
            "The literal sum shall leave forces in open points",
            "least force left over the peak",
            least,
            Reference::own("error accepted", 1e-3),
            "Σ (k⁺ − k) w is not the change of k w: what is missing stays in the point",
        ),
    ]
}

/// Largest force that the last step left in a point that is open in the limit, over the limit's largest.
fn force_left(solution: &Solution, limit: &Limit) -> f64 {
    let open = solution.spring_pressures.iter().zip(&limit.closed).filter(|(_, closed)| !**closed);
    open.map(|(p, _)| p.abs()).fold(0.0, f64::max) / limit.pressure.iter().copied().fold(0.0, f64::max)
}
