//! Limit of a rule: correction with varying stiffness on two bars, whose cycle can be predicted.
//!
//! With `w = u − p/s` and `κ_j = k_0` the rule is an affine map, `k⁺ = k (1 − k₀ g/(u s)) + k₀ (1 − g/u)`. Its fixed point
//! repels once `k₀ > 2 u s/g`; k then falls to zero at every other iteration: a cycle of period 2. Equal bars of the length ℓ
//! have `s ℓ/E* = 1`, so that the onset is `κ₀ = 2 u/g`.

use serde::Serialize;

use crate::algorithm::StiffnessRule;
use crate::case::library::Bars;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::solve::run::Run;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::meshed;
use crate::study::limits::written::{bracket, number, range};

/// Initial stiffnesses over the predicted onset.
const FACTORS: [f64; 8] = [0.3, 0.5, 0.9, 0.97, 1.03, 1.1, 10.0, 1000.0];

/// Two bars, started at stiffnesses about the onset.
#[derive(Clone, Debug, Serialize)]
pub struct Cycling {
    /// The predicted onset, 2u/g.
    pub onset: f64,
    /// How each start ended.
    pub outcomes: Vec<Outcome>,
    /// What the user sees of the last.
    pub seen: Seen,
}

/// Every start.
pub(super) fn run() -> Result<Cycling, Error> {
    let numbers = Bars::default();
    let discretisation = meshed(numbers.scene(), 2, Order::Quadratic)?;
    let onset = 2.0 * numbers.push;
    let base = Formulation::new(Element::Node, Iteration::Varying).tolerance(1e-8);
    let run = |factor: f64| {
        let stiffness = factor * onset;
        Run::of(&discretisation, &Formulation { rule: StiffnessRule::Correction, stiffness, ..base.clone() })
    };
    let outcomes = FACTORS.map(|factor| run(factor).map(|run| run.solution.outcome));
    Ok(Cycling {
        onset,
        outcomes: outcomes.into_iter().collect::<Result<_, _>>()?,
        seen: Seen::of(&run(FACTORS[FACTORS.len() - 1])),
    })
}

impl Cycling {
    pub(super) fn judge(&self) -> Vec<Judged> {
        let judged = |(factor, outcome): (f64, &Outcome)| {
            let (period, predicted) = (period(*outcome), if factor < 1.0 { 1.0 } else { 2.0 });
            let quantity = Quantity::at(
                "period of the state in which correction with varying stiffness ends",
                format!("κ₀ = {factor} · 2u/g"),
            );
            let reference = Reference::analytic("the affine map of one spring", predicted);
            Check::near(quantity, reference, 0.0, "periods are whole numbers").judge(period)
        };
        FACTORS.into_iter().zip(&self.outcomes).map(judged).collect()
    }

    pub(super) fn limit(&self) -> Limit {
        let starts = FACTORS.map(|factor| factor * self.onset);
        let measured = bracket(&starts, |i| self.outcomes[i] != Outcome::Converged, "κ₀");
        Limit {
            pushed: "a rule that cycles: correction with varying stiffness on two bars",
            range: range(&starts, "κ₀"),
            onset: format!("{measured}; predicted at 2u/g = {}", self.onset),
            seen: self.seen.to_string(),
            instead: "a softer start, or the rule secant".into(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row =
            |(factor, outcome): (f64, &Outcome)| vec![number(factor * self.onset), number(factor), outcome.to_string()];
        Detail::of(
            "Two bars, node.varying.correction: outcome by initial stiffness",
            &["κ₀", "κ₀ / (2u/g)", "outcome"],
            FACTORS.into_iter().zip(&self.outcomes).map(row),
        )
    }
}

/// Iterations from one return of the state to the next; NaN where there is none.
fn period(outcome: Outcome) -> f64 {
    match outcome {
        Outcome::Cycling { period } => period as f64,
        Outcome::Converged => 1.0,
        _ => f64::NAN,
    }
}
