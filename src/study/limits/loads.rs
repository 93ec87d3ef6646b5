//! Limits of the load: of the wrong sign, of zero, too small for the mesh.

use crate::case::library::{Bars, Cylinder};
use crate::case::{Check, Quantity, Reference, notes};
use crate::error::{Error, Kind};
use crate::measure::larger;
use crate::mesh::Order;
use crate::scene::{Load, Scene};
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
        if let Load::Traction { traction, .. } = load {
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
                Quantity::at(
                    "run that ends neither in the error of a lost spring nor at the cap of its iterations",
                    format!("of {all}"),
                ),
                "nothing balances the load",
            )
            .judge((all as f64 - named - capped).abs()),
            Check::at_least(
                "number of runs that end in the error of a lost spring",
                Reference::own("varying stiffness and kinematic load", 6.0),
                "constant stiffness never opens a spring: it runs until its iterations are used up",
            )
            .judge(named),
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
    let all_nine = || Reference::own("all nine", all as f64);
    Ok(Limit {
        pushed: "no load",
        range: "cylinder on a plane; two fixed bars".into(),
        onset: format!(
            "zero: {named} of {all} formulations refuse the cylinder, {silent} find no pressure between the bars"
        ),
        seen: format!("cylinder: {message}; bars: {}", seen(&bars[0])),
        instead,
        judged: vec![
            Check::at_least(
                "number of formulations that refuse a body without a load supported by contact alone",
                all_nine(),
                "its position is undetermined",
            )
            .judge(named),
            Check::at_least(
                "number of formulations that converge to no pressure between fixed bodies without a load",
                all_nine(),
                "the bars do not touch: p = 0 exactly, whatever the formulation",
            )
            .judge(silent),
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
