//! Limits of the surfaces: candidates that end before the contact does, bodies that end before it.

use super::{
    Limit, bracket, hertz_errors, holds, meshed, number, percent, range, said, seen, table, truncated, verified, worse,
};
use crate::algorithm::{Kinematic, iterate};
use crate::case::library::TruncatedHertz;
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::error::{Error, Kind};
use crate::measure::Measures;
use crate::mesh::Order;
use crate::scene::Load;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::Finding;

/// Candidate stretches over the true half-width.
const STRETCHES: [f64; 8] = [2.0, 1.1, 1.0, 0.98, 0.95, 0.9, 0.8, 0.5];
/// Elements per half-width.
const ELEMENTS: [usize; 3] = [4, 8, 16];

/// Candidates that end before the contact.
pub(super) fn short() -> Result<Finding, Error> {
    let mut rows: Vec<Vec<String>> = STRETCHES.iter().map(|stretch| vec![number(*stretch)]).collect();
    let (mut onsets, mut accepted, mut refusals) = (Vec::new(), 0.0_f64, Vec::new());
    for elements in ELEMENTS {
        let mut refused = Vec::new();
        for (stretch, row) in STRETCHES.into_iter().zip(&mut rows) {
            let numbers = TruncatedHertz { stretch, ..Default::default() };
            let discretisation = truncated(numbers, elements, Order::Quadratic)?;
            let result = verified(&discretisation);
            if let Ok(run) = &result {
                let [peak, _] = hertz_errors(&discretisation.scene, run);
                accepted = worse(accepted, peak);
            }
            let unchecked = peak_of_any(&discretisation)? - 1.0;
            refused.push(matches!(result, Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. })));
            row.push(format!("{}{}", if result.is_ok() { "" } else { "refused, else " }, percent(unchecked)));
            refusals.extend(result.err());
        }
        let [legitimate, far] = [2, 5].map(|i| refused[i]);
        onsets.push((elements, bracket(&STRETCHES, |i| refused[i], "L/a").0, !legitimate, far || elements < 8));
    }
    let checks = vec![
        holds(
            "Candidates that end where the contact ends shall be accepted",
            "meshes that refuse L = a",
            onsets.iter().all(|(_, _, legitimate, _)| *legitimate),
            "beyond the true edge the surfaces part: nothing penetrates",
        ),
        holds(
            "Candidates shorter than the contact by more than a node spacing shall be refused",
            "meshes of 8 and 16 elements that accept L = 0.9 a",
            onsets.iter().all(|(_, _, _, far)| *far),
            "the node beyond the end then lies inside the true contact and penetrates",
        ),
        Judged::norm(
            "What is accepted shall have the right peak",
            "largest error of p₀",
            accepted,
            Reference::analytic("Hertz", 0.0),
            1e-2,
            "what no node can see is shorter than a node spacing, and enters the peak squared",
        ),
    ];
    let (told, remedy) = refusals.last().map(said).unwrap_or_default();
    let onset = onsets.iter().map(|(n, text, ..)| format!("{n} elements per a: {text}")).collect::<Vec<_>>().join("; ");
    let limit = Limit {
        pushed: "candidate surface shorter than the true contact",
        range: range(&STRETCHES, "L/a"),
        onset,
        seen: told,
        instead: remedy,
    };
    let head = ["L / a", "error of p₀, 4 elements per a", "8 elements", "16 elements"];
    let title = "Truncated Hertz, candidates ending at L: what is refused, and how wrong it would have been";
    Ok(limit.finding(vec![table(title, &head, rows)], checks))
}

/// Peak over p₀ of whatever the loop converges to, whether the contact goes on beyond its candidates or not.
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

/// Loads over that whose Hertz contact is half as wide as the block.
const LOADS: [f64; 7] = [0.2, 1.0, 2.0, 4.0, 6.0, 8.0, 50.0];

/// A contact that grows until it reaches the end of the body.
pub(super) fn end() -> Result<Finding, Error> {
    let (mut rows, mut full, mut balance, mut corner) = (Vec::new(), Vec::new(), 0.0_f64, Vec::new());
    let mut last = String::new();
    for factor in LOADS {
        let (run, load, width) = pressed(factor)?;
        let edge = run.measures().edge() / width;
        let at_end = run.solution.points.last().map_or(f64::NAN, |point| point.pressure) / run.measures().peak.pressure;
        let error = if run.solution.converged() { (run.transmitted() / load - 1.0).abs() } else { f64::NAN };
        balance = worse(balance, error);
        full.push(edge > 1.0 - 1e-9);
        corner.push(at_end);
        rows.push(vec![number(factor), run.solution.outcome.to_string(), format!("{edge:.3}"), format!("{at_end:.3}")]);
        last = seen(&Ok(run));
    }
    let checks = vec![
        Judged::norm(
            "A contact that reaches the end of the body shall carry the whole load",
            "largest |ΣA p − P| / P",
            balance,
            Reference::own("applied load", 0.0),
            1e-8,
            "the tolerance of the runs; there is no surface for the contact to spill on",
        ),
        Judged::at_least(
            "Once the contact is as long as the body, a larger load shall press more of it on the corner",
            "pressure at the corner over the peak, largest load",
            corner[LOADS.len() - 1],
            Reference::own("the load before", corner[LOADS.len() - 2]),
            "towards a punch of the block's width, whose pressure is largest at the corner",
        ),
    ];
    let limit = Limit {
        pushed: "contact reaching the end of the body",
        range: range(&LOADS, "P/P₁, with the Hertz half-width of P₁ half the block's"),
        onset: bracket(&LOADS, |i| full[i], "P/P₁").0,
        seen: format!("{last}: no error, the pressure is that of a body which ends there"),
        instead: "nothing; model the body as long as it is".into(),
    };
    let head = ["P / P₁", "outcome", "last closed point / width", "p at the corner / peak"];
    Ok(limit.finding(vec![table("Block between a flat plate and a parabola", &head, rows)], checks))
}

/// A block of two half-widths pressed evenly on the parabola by a multiple of the Hertz load: run, load and width.
fn pressed(factor: f64) -> Result<(Run, f64, f64), Error> {
    let numbers = TruncatedHertz { size: 2.0, stretch: 2.0, ..Default::default() };
    let (load, width) = (factor * numbers.load(), 2.0 * numbers.half_width());
    let (mut scene, _, _) = problem::truncated_hertz(numbers);
    scene.bodies[0].loads = vec![Load::Traction { boundary: "far".into(), traction: [0.0, -0.5 * load / width] }];
    Ok((verified(&meshed(scene, 8, Order::Quadratic)?)?, load, width))
}
