//! Limits of the load: of the wrong sign, of zero, too small for the mesh. And of the contact's extent: candidates and
//! bodies that end before it.

use crate::algorithm::{Kinematic, iterate};
use crate::case::library::{Bars, Cylinder, TruncatedHertz};
use crate::case::{Check, Quantity, Reference, notes};
use crate::error::{Error, Kind};
use crate::measure::{Measures, larger, largest};
use crate::mesh::Order;
use crate::scene::{Action, Load, Scene};
use crate::solution::Outcome;
use crate::solve::{Discretisation, Formulation};
use crate::study::limits::push::{
    Limit, ORDERS, Push, Solved, against_hertz, folded, meshed, number, percent, size, told, told_with_remedy, worst,
};

/// What the nine formulations make of a discretisation, in their order.
fn nine(discretisation: &Discretisation) -> Vec<Result<Solved, Error>> {
    Formulation::nine().iter().map(|formulation| Solved::by(formulation, discretisation)).collect()
}

/// What the user sees of a run or of its error.
fn seen(result: &Result<Solved, Error>) -> String {
    result.as_ref().map_or_else(told, Solved::seen)
}

fn first_error(results: &[Result<Solved, Error>]) -> Option<&Error> {
    results.iter().find_map(|result| result.as_ref().err())
}

/// How many results are what they should be.
fn count(results: &[Result<Solved, Error>], is_right: fn(&Result<Solved, Error>) -> bool) -> f64 {
    results.iter().filter(|result| is_right(result)).count() as f64
}

/// The cylinder under its load times a factor.
fn cylinder(factor: f64) -> Result<Discretisation, Error> {
    let mut scene = Cylinder::default().scene();
    for load in scene.bodies.iter_mut().flat_map(|body| &mut body.loads) {
        if let Load::OnSide { action: Action::Uniform(traction), .. } = load {
            *traction = traction.map(|t| t * factor);
        }
    }
    meshed(scene, 8, Order::Quadratic)
}

/// The load pulls the cylinder off the plane, and every spring opens.
pub(super) fn pulled_apart() -> Result<Limit, Error> {
    let results = nine(&cylinder(-1.0)?);
    let all = results.len();
    let named = count(&results, |result| matches!(result, Err(Error { kind: Kind::NoSpringLeft { .. }, .. })));
    let capped = count(&results, |result| matches!(result, Ok(run) if run.run.solution.outcome == Outcome::Capped));
    let [message, instead] = told_with_remedy(first_error(&results));
    let rows: Vec<[String; 2]> =
        Formulation::nine().iter().zip(&results).map(|(of, result)| [of.name(), seen(result)]).collect();
    Ok(Limit {
        pushed: "a body supported by contact alone, every spring open",
        range: "the load of the cylinder, reversed".into(),
        onset: "once the last spring is open".into(),
        seen: format!("{named} of {all}: {message}; {capped}: {}", Outcome::Capped),
        instead,
        judged: vec![
            Check::none(
                "run that ends neither in the error of a lost spring nor at the cap of its iterations",
                "nothing balances the load",
            )
            .asked_of(all)
            .judge((all as f64 - named - capped).abs()),
        ],
        table: folded(
            "Cylinder pulled off the plane",
            &rows,
            &[("formulation", |[name, _]| name.clone()), ("what the user sees", |[_, seen]| seen.clone())],
        ),
    })
}

/// No load, on a body that only contact supports and on bodies that are fixed.
pub(super) fn no_load() -> Result<Limit, Error> {
    let mut scene = Bars::default().scene();
    scene.bodies.iter_mut().flat_map(|body| &mut body.supports).for_each(|support| support.value = 0.0);
    let (cylinder, bars) = (nine(&cylinder(0.0)?), nine(&meshed(scene, 2, Order::Quadratic)?));
    let all = cylinder.len();
    let named = count(&cylinder, |result| matches!(result, Err(Error { kind: Kind::NothingPresses, .. })));
    let silent = count(&bars, |result| {
        let highest = |bars: &Solved| bars.run.solution.points.iter().map(|point| point.pressure).reduce(larger);
        matches!(result, Ok(bars) if bars.run.solution.converged() && highest(bars).is_some_and(|p| p <= 0.0))
    });
    let [message, instead] = told_with_remedy(first_error(&cylinder));
    Ok(Limit {
        pushed: "no load",
        range: "cylinder on a plane; two fixed bars".into(),
        onset: format!(
            "zero: {named} of {all} formulations refuse the cylinder, {silent} find no pressure between the bars"
        ),
        seen: format!("cylinder: {message}; bars: {}", seen(&bars[0])),
        instead,
        judged: vec![
            Check::none(
                "formulation that finds a pressure between fixed bodies without a load",
                "the bars do not touch: p = 0 exactly, whatever the formulation",
            )
            .asked_of(all)
            .judge(all as f64 - silent),
        ],
        table: String::new(),
    })
}

/// Elements per half-width of the contact under ever smaller loads.
const SIZES: [f64; 9] = [8.0, 4.0, 3.0, 2.0, 1.5, 1.0, 0.5, 0.25, 0.1];
/// Error of p₀ and a that counts as wrong.
const WRONG: f64 = 0.05;

/// The load is too small for the mesh, so that the contact falls between the nodes.
pub(super) fn small_load() -> Result<Limit, Error> {
    let sizes = Push::of("elements per half-width", &SIZES, ORDERS, |size, order| {
        Solved::on(&meshed(falling(size), SIZES[0] as usize, order)?)
    })?;
    let [four, eight] = [0, 1].map(|k| sizes.onset(|found| found[k].is_off(WRONG)));
    let enough = sizes.last_before(|found| found.iter().any(|solved| solved.is_off(WRONG)));
    Ok(Limit {
        pushed: "a load too small for two contact nodes",
        range: format!("{} … {} elements per half-width", SIZES[0], SIZES[SIZES.len() - 1]),
        onset: format!("errors beyond {}: 4-node {four}; 8-node {eight}", size(WRONG)),
        seen: sizes.last()[1].seen(),
        instead: format!("a mesh made for the load: at least {} elements in the half-width", number(enough)),
        judged: vec![against_hertz(
            Quantity::at("largest error of p₀ and a of a contact reported without a note", "every load"),
            worst(sizes.all().filter(|solved| notes::of(&solved.run, 0).is_empty())),
            WRONG,
            "four points: the edge is known to a third of the half-width, and enters the error of p₀ squared",
        )],
        table: sizes.table(
            "Cylinder: contact falling between the nodes",
            &[
                ("elements per half-width", |(size, _)| number(*size)),
                ("4-node: points", |(_, [four, _])| four.run.measures().active.to_string()),
                ("p₀", |(_, [four, _])| percent(four.errors().peak)),
                ("a", |(_, [four, _])| percent(four.errors().half_width)),
                ("user sees", |(_, [four, _])| four.seen()),
                ("8-node: points", |(_, [_, eight])| eight.run.measures().active.to_string()),
                ("p₀", |(_, [_, eight])| percent(eight.errors().peak)),
                ("a", |(_, [_, eight])| percent(eight.errors().half_width)),
                ("user sees", |(_, [_, eight])| eight.seen()),
            ],
        ),
    })
}

/// The cylinder whose Hertz half-width is `size / 8` of the default one, on the mesh made for that.
fn falling(size: f64) -> Scene {
    let base = Cylinder::default();
    let mut scene = Cylinder { a_over_r: base.a_over_r * size / SIZES[0], ..base }.scene();
    scene.grading.unit = base.half_width();
    scene.contacts[0].stretch = base.stretch * base.half_width();
    scene
}

/// Candidate stretches over the true half-width.
const STRETCHES: [f64; 8] = [2.0, 1.1, 1.0, 0.98, 0.95, 0.9, 0.8, 0.5];
/// Index of candidates that end where the contact ends.
const EXACT: usize = 2;
/// Index of candidates that are too short by more than a node spacing of the finer meshes.
const CUT: usize = 5;
/// Elements per half-width.
const ELEMENTS: [usize; 3] = [4, 8, 16];

/// What comes of candidates that end before the contact: what the user gets, and the error of p₀ of what the iteration
/// finds, whether it is accepted or not.
type Cut = (Result<Solved, Error>, f64);

fn cut_at(stretch: f64, elements: usize) -> Result<Cut, Error> {
    let scene = TruncatedHertz { stretch, ..Default::default() }.scene();
    let discretisation = meshed(scene, elements, Order::Quadratic)?;
    Ok((Solved::on(&discretisation), peak_of_any(&discretisation)? - 1.0))
}

fn is_refused((result, _): &Cut) -> bool {
    matches!(result, Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }))
}

fn cell((result, unchecked): &Cut) -> String {
    let refused = if result.is_ok() { "" } else { "refused, else " };
    format!("{refused}{}", percent(*unchecked))
}

/// Peak over p₀ of whatever the loop converges to, whether the contact reaches the end of its candidates or not.
fn peak_of_any(discretisation: &Discretisation) -> Result<f64, Error> {
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let settings = formulation.settings;
    let mut algorithm = Kinematic::new(formulation.rule, settings.tolerance);
    let solution = iterate(&problem, &mut algorithm, settings)?;
    let measures = Measures::of(&discretisation.scene, 0, solution.part(0));
    Ok(measures.peak.pressure / discretisation.scene.reference.pressure)
}

/// The candidates end before the contact does.
pub(super) fn short_candidates() -> Result<Limit, Error> {
    let stretches = Push::of("L/a", &STRETCHES, ELEMENTS, cut_at)?;
    let [exact, cut] = [EXACT, CUT].map(|index| &stretches.tried[index].1);
    let refusing = exact.iter().filter(|cut| is_refused(cut)).count();
    let accepting = cut[1..].iter().filter(|cut| !is_refused(cut)).count();
    let accepted =
        stretches.all().filter_map(|(result, _)| result.as_ref().ok()).map(|solved| solved.errors().peak.abs());
    let onsets = [0, 1, 2].map(|mesh| {
        let onset = stretches.onset(|cuts| is_refused(&cuts[mesh]));
        format!("{} elements per a: {onset}", ELEMENTS[mesh])
    });
    let shortest = stretches.tried.iter().rev().find_map(|(_, [.., (fine, _)])| fine.as_ref().err());
    let [seen, instead] = told_with_remedy(shortest);
    Ok(Limit {
        pushed: "candidate surface shorter than the true contact",
        range: stretches.range("L/a"),
        onset: onsets.join("; "),
        seen,
        instead,
        judged: vec![
            Check::none(
                Quantity::at("mesh that refuses candidates ending where the contact ends", "L = a"),
                "beyond the true edge the surfaces part: nothing penetrates",
            )
            .judge(refusing as f64),
            Check::none(
                Quantity::at(
                    "mesh that accepts candidates too short by more than a node spacing",
                    "L = 0.9 a, 8 and 16 elements",
                ),
                "the node beyond the end then lies inside the true contact and penetrates",
            )
            .judge(accepting as f64),
            against_hertz(
                "largest error of p₀ of what is accepted",
                largest(accepted),
                1e-2,
                "what no node can see is shorter than a node spacing, and enters the peak squared",
            ),
        ],
        table: stretches.table(
            "Truncated Hertz, candidates ending at L: what is refused, and how wrong it would have been",
            &[
                ("L / a", |(stretch, _)| number(*stretch)),
                ("error of p₀, 4 elements per a", |(_, [four, ..])| cell(four)),
                ("8 elements", |(_, [_, eight, _])| cell(eight)),
                ("16 elements", |(_, [.., sixteen])| cell(sixteen)),
            ],
        ),
    })
}

/// Loads over that whose Hertz contact is half as wide as the block.
const LOADS: [f64; 7] = [0.2, 1.0, 2.0, 4.0, 6.0, 8.0, 50.0];

/// A block of two half-widths.
fn block() -> TruncatedHertz {
    TruncatedHertz { size: 2.0, stretch: 2.0, ..Default::default() }
}

/// The block pressed evenly on the parabola by a multiple of the Hertz load.
fn pressed(factor: f64) -> Scene {
    let (load, width) = (factor * block().load(), 2.0 * block().half_width());
    let mut scene = block().scene();
    scene.bodies[0].loads = vec![Load::on("far", Action::Uniform([0.0, -0.5 * load / width]))];
    scene
}

/// Last closed point over the width of the block.
fn edge(solved: &Solved) -> f64 {
    solved.run.measures().edge() / (2.0 * block().half_width())
}

/// Pressure at the corner over the peak.
fn at_corner(solved: &Solved) -> f64 {
    let corner = solved.run.solution.points.last().map_or(f64::NAN, |point| point.pressure);
    corner / solved.run.measures().peak.pressure
}

/// The contact grows until it reaches the end of the body.
pub(super) fn body_end() -> Result<Limit, Error> {
    let loads = Push::of("P/P₁", &LOADS, [8], |factor, elements| {
        Solved::on(&meshed(pressed(factor), elements, Order::Quadratic)?)
    })?;
    let balance = |(factor, [solved]): &(f64, [Solved; 1])| {
        let error = (solved.run.transmitted() / (factor * block().load()) - 1.0).abs();
        if solved.run.solution.converged() { error } else { f64::NAN }
    };
    let [before, last] = [2, 1].map(|back| at_corner(&loads.tried[LOADS.len() - back].1[0]));
    Ok(Limit {
        pushed: "contact reaching the end of the body",
        range: loads.range("P/P₁, with the Hertz half-width of P₁ half the block's"),
        onset: loads.onset(|[solved]| edge(solved) > 1.0 - 1e-9),
        seen: format!("{}; the pressure is that of a body that ends there", loads.last()[0].seen()),
        instead: "nothing; model the body as long as it is".into(),
        judged: vec![
            Check::error(
                Quantity::at("largest |ΣA p − P| / P of a contact that reaches the end of the body", "every load"),
                Reference::own("the applied load", 0.0),
                1e-8,
                "the tolerance of the runs; there is no surface beyond the end",
            )
            .judge(largest(loads.tried.iter().map(balance))),
            Check::at_least(
                Quantity::at("pressure at the corner over the peak", "largest load"),
                Reference::own("that under the load before", before),
                "towards a punch of the block's width, whose pressure is largest at the corner",
            )
            .judge(last),
        ],
        table: loads.table(
            "Block between a flat plate and a parabola",
            &[
                ("P / P₁", |(load, _)| number(*load)),
                ("outcome", |(_, [solved])| solved.run.solution.outcome.to_string()),
                ("last closed point / width", |(_, [solved])| format!("{:.3}", edge(solved))),
                ("p at the corner / peak", |(_, [solved])| format!("{:.3}", at_corner(solved))),
            ],
        ),
    })
}
