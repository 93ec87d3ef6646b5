//! Limits of parameters and rules: the thickness of the layer, a rule that cycles.

use super::{
    Limit, bracket, hertz_errors, meshed, number, percent, range, refusal, said, seen, size, table, truncated, worse,
};
use crate::algorithm::StiffnessRule;
use crate::case::library::{Bars, TruncatedHertz};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::solve::run::Run;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::unsorted::Finding;

/// The layer's own thickness.
pub(super) fn layer_thickness() -> Result<Finding, Error> {
    let thicknesses = [1e-6, 1e-4, 1e-2, 0.05, 0.2, 0.5, 1.0];
    let discretisation = truncated(TruncatedHertz::default(), 8, Order::Quadratic)?;
    let (mut rows, mut worst) = (Vec::new(), 0.0_f64);
    for layer_thickness in thicknesses {
        let mut cells = vec![number(layer_thickness)];
        for algorithm in Iteration::ALL {
            let formulation = Formulation { layer_thickness, ..Formulation::new(Element::Layer, algorithm) };
            let run = Run::of(&discretisation, &formulation)?;
            let [peak, width] = hertz_errors(&discretisation.scene, &run);
            worst = worse(worst, worse(peak, width));
            cells.push(format!(
                "{}, {} steps, p₀ {}, a {}",
                run.solution.outcome,
                run.solution.work.steps,
                percent(peak),
                percent(width)
            ));
        }
        rows.push(cells);
    }
    let none = Formulation { layer_thickness: 0.0, ..Formulation::new(Element::Layer, Iteration::Kinematic) };
    let (refused, remedy) = said(&refusal(discretisation.solve(&none), "a layer of no thickness")?);
    let check = Judged::norm(
        "Every layer between 1e-6 and 1 element length thick shall find the contact",
        "largest error of p₀ and a",
        worst,
        Reference::analytic("Hertz", 0.0),
        1e-2,
        "engineering tolerance of the paper's comparison; iterations to 1e-3",
    );
    let head = ["t₀ / h", "layer.varying", "layer.constant", "layer.kinematic"];
    let limit = Limit {
        pushed: "thickness t₀ of the layer",
        range: format!("{}, and 0", range(&thicknesses, "t₀/h")),
        onset: format!("none but zero: errors of p₀ and a stay below {}", size(worst)),
        seen: format!("converged; at zero {refused}"),
        instead: format!("any thickness; {remedy}"),
    };
    Ok(limit.finding(vec![table("Layer thickness on truncated Hertz", &head, rows)], vec![check]))
}

/// Initial stiffnesses over the predicted onset.
const FACTORS: [f64; 8] = [0.3, 0.5, 0.9, 0.97, 1.03, 1.1, 10.0, 1000.0];

/// Two bars are one spring, whose cycle can be foretold.
///
/// With `w = u − p/s` and `κ_j = k_0` the rule correction is an affine map, `k⁺ = k (1 − k₀ g/(u s)) + k₀ (1 − g/u)`. Its
/// fixed point repels once `k₀ > 2 u s/g`; k then falls to zero at every other step: a cycle of period 2. Equal bars of the
/// length ℓ have `s ℓ/E* = 1`, so that the onset is `κ₀ = 2 u/g`.
pub(super) fn cycling() -> Result<Finding, Error> {
    let numbers = Bars::default();
    let discretisation = meshed(numbers.scene(), 2, Order::Quadratic)?;
    let onset = 2.0 * numbers.push;
    let (mut rows, mut checks, mut outcomes) = (Vec::new(), Vec::new(), Vec::new());
    let mut last = String::new();
    for factor in FACTORS {
        let base = Formulation::new(Element::Node, Iteration::Varying).tolerance(1e-8);
        let run = Run::of(
            &discretisation,
            &Formulation { rule: StiffnessRule::Correction, stiffness: factor * onset, ..base },
        );
        last = seen(&run);
        let outcome = run?.solution.outcome;
        let period = match outcome {
            Outcome::Cycling { period } => period as f64,
            Outcome::Converged => 1.0,
            _ => f64::NAN,
        };
        checks.push(Judged::relative(
            "Correction with varying stiffness on two bars shall converge below κ₀ = 2u/g and cycle with period 2 above",
            format!("period, κ₀ = {factor} · 2u/g"),
            period,
            Reference::analytic("affine map of one spring", if factor < 1.0 { 1.0 } else { 2.0 }),
            0.0,
            "periods are whole numbers",
        ));
        rows.push(vec![number(factor * onset), number(factor), outcome.to_string()]);
        outcomes.push(outcome);
    }
    let starts = FACTORS.map(|factor| factor * onset);
    let (measured, _) = bracket(&starts, |i| outcomes[i] != Outcome::Converged, "κ₀");
    let limit = Limit {
        pushed: "a rule that cycles: correction with varying stiffness on two bars",
        range: range(&starts, "κ₀"),
        onset: format!("{measured}; foretold at 2u/g = {onset}"),
        seen: last,
        instead: "a softer start, or the rule secant".into(),
    };
    let title = "Two bars, node.varying.correction: outcome by start stiffness";
    Ok(limit.finding(vec![table(title, &["κ₀", "κ₀ / (2u/g)", "outcome"], rows)], checks))
}
