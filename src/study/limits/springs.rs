//! Limits of the springs: where they stand on an edge, how stiff and how thick they are, and a rule that cycles.

use crate::algorithm::StiffnessRule;
use crate::case::library::{Bars, Cylinder, PinRod, TruncatedHertz};
use crate::case::{Check, Quantity, Reference};
use crate::contact::Quadrature;
use crate::error::Error;
use crate::measure::{largest, order, profile};
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::solve::run::INSIDE;
use crate::solve::{Discretisation, Element, Formulation, Iteration, LIMITS};
use crate::stability::conditioning::{self, Conditioning};
use crate::study::limits::push::{
    Limit, Push, Solved, against_hertz, exceeds, meshed, number, percent, refused, size, told, worst,
};

/// Stiffnesses of springs on edges; the two hardest are judged.
const ON_EDGES: [f64; 6] = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
/// Departure over the peak that counts as oscillation.
const VISIBLE: f64 = 0.05;

/// Largest departure of a pressure from its neighbours' line inside the contact, over the peak.
fn departure(Solved { run, .. }: &Solved) -> f64 {
    profile::oscillation(&run.solution.points, INSIDE * run.measures().edge()) / run.measures().peak.pressure
}

/// The departure of a run that converged, or how it ended.
fn departure_or_end(solved: &Solved) -> String {
    if solved.run.solution.converged() { percent(departure(solved)) } else { solved.seen() }
}

/// Three Gauss points on an edge: more conditions than its displacements can meet.
pub(super) fn gauss_points() -> Result<Limit, Error> {
    let pin_rod = meshed(PinRod::default().scene(), 8, Order::Quadratic)?;
    let cylinder = meshed(Cylinder::default().scene(), 8, Order::Quadratic)?;
    let ways = [
        (&pin_rod, Quadrature::GaussFull),
        (&pin_rod, Quadrature::Gauss),
        (&pin_rod, Quadrature::Lobatto),
        (&cylinder, Quadrature::GaussFull),
        (&cylinder, Quadrature::Gauss),
        (&cylinder, Quadrature::Lobatto),
    ];
    let base = Formulation { rule: StiffnessRule::Penalty, ..Formulation::new(Element::Line, Iteration::Kinematic) };
    let stiffnesses = Push::of("κ", &ON_EDGES, ways, |stiffness, (discretisation, quadrature)| {
        Solved::by(&Formulation { stiffness, quadrature, ..base.clone() }, discretisation)
    })?;
    let [hard, hardest] = [2, 1].map(|back| &stiffnesses.tried[ON_EDGES.len() - back].1);
    let most = |way: usize| largest(stiffnesses.tried.iter().map(|(_, runs)| departure(&runs[way])));
    let [on_rod, on_cylinder] = [1, 4].map(most);
    let lobatto = stiffnesses.tried.iter().flat_map(|(_, [_, _, pin_rod, _, _, cylinder])| [pin_rod, cylinder]);
    let visible = || Reference::own("visible", VISIBLE);
    let limited = |at: &'static str, way: usize| {
        let reference = Reference::own("that at κ = 1e5", departure(&hard[way]));
        let because = "two conditions on an edge that adds two displacements can be met: hard springs have a limit";
        Check::near(Quantity::at("departure over the peak at two Gauss points", at), reference, 0.1, because)
            .judge(departure(&hardest[way]))
    };
    Ok(Limit {
        pushed: "3-point Gauss on stiff quadratic line elements",
        range: stiffnesses.range("κ"),
        onset: format!(
            "departure of {} {} on the pin–rod; 2-point Gauss: at most {} there; on the cylinder {}, and at most {}",
            size(VISIBLE),
            stiffnesses.onset(|[three, ..]| exceeds(departure(three), VISIBLE)),
            size(on_rod),
            stiffnesses.onset(|[_, _, _, _, two, _]| exceeds(departure(two), VISIBLE)),
            size(on_cylinder)
        ),
        seen: format!("κ = 1e5: {}; κ = 1e6: {}", hard[0].seen(), hardest[0].seen()),
        instead: "Lobatto points, or node elements; with Gauss points quote means over edges".into(),
        judged: vec![
            Check::at_least(
                Quantity::at("departure over the peak at three Gauss points", "pin–rod, κ = 1e5"),
                visible(),
                "three conditions on an edge that adds two displacements: a finding, locked",
            )
            .judge(departure(&hard[0])),
            limited("pin–rod, κ = 1e6", 1),
            limited("cylinder, κ = 1e6", 4),
            Check::at_most(
                Quantity::at("departure over the peak at two Gauss points", "pin–rod, every κ"),
                visible(),
                "a finding, of this scene alone",
            )
            .judge(on_rod),
            Check::at_least(
                Quantity::at("departure over the peak at two Gauss points", "cylinder, the largest of all κ"),
                visible(),
                "a finding: their alternating mode grows with κ until the edges follow it",
            )
            .judge(on_cylinder),
            Check::at_most(
                Quantity::at("departure over the peak at Lobatto points", "both scenes, every κ"),
                visible(),
                "Lobatto points are the nodes: one condition for each displacement",
            )
            .judge(largest(lobatto.map(departure))),
        ],
        table: stiffnesses.table(
            "Line element on 8-node cells, springs fixed at κ: largest departure of a pressure from the line through \
            its neighbours, over the peak",
            &[
                ("κ", |(stiffness, _)| number(*stiffness)),
                ("pin–rod, 3-point Gauss", |(_, runs)| departure_or_end(&runs[0])),
                ("pin–rod, 2-point Gauss", |(_, runs)| departure_or_end(&runs[1])),
                ("pin–rod, Lobatto", |(_, runs)| departure_or_end(&runs[2])),
                ("cylinder, 3-point Gauss", |(_, runs)| departure_or_end(&runs[3])),
                ("cylinder, 2-point Gauss", |(_, runs)| departure_or_end(&runs[4])),
                ("cylinder, Lobatto", |(_, runs)| departure_or_end(&runs[5])),
            ],
        ),
    })
}

/// Error of one solve that leaves three digits of the pressure.
const THREE_DIGITS: f64 = 1e-3;

/// Springs of κ where pressures of the verified solution press.
fn conditioned(discretisation: &Discretisation, pressures: &[f64], kappa: f64) -> Conditioning {
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let spring = |p: &f64| if *p > 0.0 { kappa * problem.scale.stiffness } else { 0.0 };
    let springs: Vec<f64> = pressures.iter().map(spring).collect();
    let nothing = Conditioning { condition: f64::NAN, plain: f64::NAN, refined: f64::NAN };
    conditioning::of(&problem, &springs).unwrap_or(nothing)
}

/// Stiff springs, beyond what users may ask for, cost digits.
pub(super) fn stiffness() -> Result<Limit, Error> {
    let plane = meshed(TruncatedHertz::default().scene(), 8, Order::Quadratic)?;
    let pin_rod = meshed(PinRod::default().scene(), 8, Order::Quadratic)?;
    let values: Vec<f64> = (0..=8).map(|k| 10f64.powi(2 * k)).collect();
    let [on_plane, on_rod] = [&plane, &pin_rod].map(|scene| scene.solve(&Formulation::verification()));
    let scenes = [(&plane, &on_plane?), (&pin_rod, &on_rod?)];
    let stiffnesses = Push::of("κ", &values, scenes, |kappa, (scene, solution)| {
        Ok(conditioned(scene, &solution.spring_pressures, kappa))
    })?;
    let beyond = Formulation { stiffness: 10.0 * LIMITS[1], ..Formulation::verification() };
    let beyond = refused(plane.solve(&beyond), "a spring stiffer than the limit")?;
    let value_where = |is_so: fn(&[Conditioning; 2]) -> bool| {
        stiffnesses.tried.iter().find(|(_, found)| is_so(found)).map_or(f64::NAN, |(kappa, _)| *kappa)
    };
    let first_refused = value_where(|[_, pin_rod]| pin_rod.refined.is_nan());
    // `d log / d log κ` on the rigid plane.
    let slope = |of: fn(&Conditioning) -> f64, range: std::ops::Range<usize>| {
        let found = stiffnesses.tried[range.clone()].iter().map(|(_, [plane, _])| of(plane));
        order::slope(&values[range], &found.collect::<Vec<f64>>())
    };
    let [of_condition, of_error] = [slope(|found| found.condition, 2..6), slope(|found| found.plain, 2..8)];
    let allowed = stiffnesses.tried.iter().filter(|(kappa, _)| *kappa <= LIMITS[1]);
    let proportional = |quantity: &'static str, slope: f64, because: &'static str| {
        Check::error(quantity, Reference::analytic("growth in proportion to κ", 0.0), 0.1, because)
            .judge((slope - 1.0).abs())
    };
    Ok(Limit {
        pushed: "stiffness of the springs",
        range: stiffnesses.range("κ"),
        onset: format!(
            "one solve loses {of_error:.1} digits with every decade of κ, all but three by {}; after refinement errors \
            are {}; two bodies are refused from {}",
            number(value_where(|[plane, _]| plane.plain > THREE_DIGITS)),
            digits(largest(stiffnesses.tried.iter().map(|(_, [plane, _])| plane.refined))),
            number(first_refused)
        ),
        seen: told(&beyond),
        instead: beyond.remedy,
        judged: vec![
            proportional("|d log condition / d log κ − 1|", of_condition, "the largest eigenvalue is A κ"),
            proportional("|d log error / d log κ − 1|", of_error, "p = k (w − g), and w − g carries round-off of w"),
            Check::error(
                Quantity::at("largest error of a refined pressure over p_ref", "κ ≤ 1e6"),
                Reference::own("the mixed system", 0.0),
                1e-9,
                "the accuracy to which every run is compared with its variants",
            )
            .judge(largest(allowed.flat_map(|(_, found)| found.iter().map(|found| found.refined)))),
            Check::at_least(
                "first κ at which two bodies are refused as having no spring left",
                Reference::own("two decades beyond the limit", 100.0 * LIMITS[1]),
                "a pivot falls as 1/κ, and is taken for round-off below 1e-10",
            )
            .judge(first_refused),
        ],
        table: stiffnesses.table(
            "Springs of κ on the final active set: condition of S + K, errors of the pressures over p_ref",
            &[
                ("κ", |(kappa, _)| number(*kappa)),
                ("condition, rigid plane", |(_, [plane, _])| condition(plane.condition)),
                ("error of one solve", |(_, [plane, _])| digits(plane.plain)),
                ("after refinement", |(_, [plane, _])| digits(plane.refined)),
                ("condition, pin–rod", |(_, [_, pin_rod])| condition(pin_rod.condition)),
                ("error of one solve", |(_, [_, pin_rod])| digits(pin_rod.plain)),
                ("after refinement", |(_, [_, pin_rod])| digits(pin_rod.refined)),
            ],
        ),
    })
}

/// A condition number, as far as round-off lets it be known.
fn condition(condition: f64) -> String {
    if condition < 1e13 { format!("{condition:.0e}") } else { "> 1e13".into() }
}

/// An error of round-off by the next even power of ten above it: its digits are the machine's.
fn digits(error: f64) -> String {
    match error {
        e if e.is_nan() => "refused".into(),
        e if e < 1e-8 => "< 1e-8".into(),
        e => format!("< {:e}", 10f64.powi(2 * (0.5 * e.log10()).ceil() as i32)),
    }
}

/// Thicknesses of the layer over the length of an edge.
const THICKNESSES: [f64; 7] = [1e-6, 1e-4, 1e-2, 0.05, 0.2, 0.5, 1.0];
/// Error of p₀ and a that counts as wrong.
const WRONG: f64 = 1e-2;

/// How a run ended, and its errors.
fn ended(solved: &Solved) -> String {
    let ([peak, half_width], solution) = (solved.percents(), &solved.run.solution);
    format!("{}, {} iterations, p₀ {peak}, a {half_width}", solution.outcome, solution.work.iterations)
}

/// The thickness of the layer.
pub(super) fn layer_thickness() -> Result<Limit, Error> {
    let discretisation = meshed(TruncatedHertz::default().scene(), 8, Order::Quadratic)?;
    let layer = |layer_thickness: f64, algorithm: Iteration| Formulation {
        layer_thickness,
        ..Formulation::new(Element::Layer, algorithm)
    };
    let thicknesses = Push::of("t₀/h", &THICKNESSES, Iteration::ALL, |thickness, algorithm| {
        Solved::by(&layer(thickness, algorithm), &discretisation)
    })?;
    let none = refused(discretisation.solve(&layer(0.0, Iteration::Kinematic)), "a layer of no thickness")?;
    let worst = worst(thicknesses.all());
    Ok(Limit {
        pushed: "thickness t₀ of the layer",
        range: format!("{}, and 0", thicknesses.range("t₀/h")),
        onset: format!(
            "errors of p₀ and a beyond {}: {}; the largest is {}",
            size(WRONG),
            thicknesses.onset(|runs| runs.iter().any(|solved| solved.is_off(WRONG))),
            size(worst)
        ),
        seen: format!("{}; at zero {}", thicknesses.last()[2].run.solution.outcome, told(&none)),
        instead: none.remedy,
        judged: vec![against_hertz(
            "largest error of p₀ and a with layers between 1e-6 and 1 edge length thick",
            worst,
            WRONG,
            "engineering tolerance of the paper's comparison; iterations to 1e-3",
        )],
        table: thicknesses.table(
            "Layer thickness on truncated Hertz",
            &[
                ("t₀ / h", |(thickness, _)| number(*thickness)),
                ("layer.varying", |(_, [varying, ..])| ended(varying)),
                ("layer.constant", |(_, [_, constant, _])| ended(constant)),
                ("layer.kinematic", |(_, [.., kinematic])| ended(kinematic)),
            ],
        ),
    })
}

/// Initial stiffnesses over the predicted onset.
const FACTORS: [f64; 8] = [0.3, 0.5, 0.9, 0.97, 1.03, 1.1, 10.0, 1000.0];

/// The κ₀ from which on two bars cycle, `2 u/g`.
fn predicted_onset() -> f64 {
    2.0 * Bars::default().push
}

/// Iterations from one return of the state to the next; NaN where there is none.
fn period(outcome: Outcome) -> f64 {
    match outcome {
        Outcome::Cycling { period } => period as f64,
        Outcome::Converged => 1.0,
        _ => f64::NAN,
    }
}

/// Correction with varying stiffness on two bars, whose cycle can be predicted.
///
/// With `w = u − p/s` and `max(k, k₀) = k₀` the rule is an affine map, `k⁺ = k (1 − k₀ g/(u s)) + k₀ (1 − g/u)`. Its
/// fixed point repels once `k₀ > 2 u s/g`; k then falls to zero at every other iteration: a cycle of period 2. Equal
/// bars of the length ℓ have `s ℓ/E* = 1`, so that the onset is `κ₀ = 2 u/g`.
pub(super) fn cycling() -> Result<Limit, Error> {
    let discretisation = meshed(Bars::default().scene(), 2, Order::Quadratic)?;
    let base = Formulation::new(Element::Node, Iteration::Varying).tolerance(1e-8);
    let starts = FACTORS.map(|factor| factor * predicted_onset());
    let starts = Push::of("κ₀", &starts, [StiffnessRule::Correction], |stiffness, rule| {
        Solved::by(&Formulation { rule, stiffness, ..base.clone() }, &discretisation)
    })?;
    let judged = FACTORS.into_iter().zip(starts.all()).map(|(factor, solved)| {
        let quantity = Quantity::at(
            "period of the state in which correction with varying stiffness ends",
            format!("κ₀ = {factor} · 2u/g"),
        );
        let reference = Reference::analytic("the affine map of one spring", if factor < 1.0 { 1.0 } else { 2.0 });
        Check::near(quantity, reference, 0.0, "periods are whole numbers").judge(period(solved.run.solution.outcome))
    });
    Ok(Limit {
        pushed: "a rule that cycles: correction with varying stiffness on two bars",
        range: starts.range("κ₀"),
        onset: format!(
            "{}; predicted at 2u/g = {}",
            starts.onset(|[solved]| !solved.run.solution.converged()),
            predicted_onset()
        ),
        seen: starts.last()[0].seen(),
        instead: "a softer start, or the rule secant".into(),
        judged: judged.collect(),
        table: starts.table(
            "Two bars, node.varying.correction: outcome by initial stiffness",
            &[
                ("κ₀", |(stiffness, _)| number(*stiffness)),
                ("κ₀ / (2u/g)", |(stiffness, _)| number(stiffness / predicted_onset())),
                ("outcome", |(_, [solved])| solved.run.solution.outcome.to_string()),
            ],
        ),
    })
}
