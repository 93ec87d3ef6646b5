//! Limits of the load: none, the wrong sign, too little for the mesh.

use super::{Limit, bracket, hertz_errors, meshed, number, percent, said, seen, size, table, verified, worse};
use crate::case::library::{Bars, Cylinder};
use crate::case::{Judged, Reference};
use crate::error::{Error, Kind};
use crate::mesh::Order;
use crate::scene::{Load, Scene};
use crate::solution::Outcome;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::Finding;

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

/// What all nine formulations make of a discretisation.
fn nine(discretisation: &Discretisation) -> Vec<(Formulation, Result<Run, Error>)> {
    let solved = |formulation: Formulation| {
        let run = Run::of(discretisation, &formulation);
        (formulation, run)
    };
    Formulation::nine().into_iter().map(solved).collect()
}

/// How many results meet a criterion.
fn count(results: &[(Formulation, Result<Run, Error>)], criterion: impl Fn(&Result<Run, Error>) -> bool) -> f64 {
    results.iter().filter(|(_, result)| criterion(result)).count() as f64
}

/// A load that pulls the cylinder off the plane: every spring opens, and nothing holds it.
pub(super) fn pulled_apart() -> Result<Finding, Error> {
    let results = nine(&cylinder(-1.0)?);
    let errors = count(&results, |result| matches!(result, Err(Error { kind: Kind::NoSpringLeft { .. }, .. })));
    let exhausted = count(&results, |result| matches!(result, Ok(run) if run.solution.outcome == Outcome::Exhausted));
    let first = results.iter().find_map(|(_, result)| result.as_ref().err()).map(said).unwrap_or_default();
    let rows = results.iter().map(|(formulation, result)| vec![formulation.name(), seen(result)]);
    let checks = vec![
        Judged::norm(
            "A body that is pulled off shall end in an error that says so, or not converge",
            "runs with another end",
            (results.len() as f64 - errors - exhausted).abs(),
            Reference::own("none", 0.0),
            0.0,
            "nothing balances the load",
        ),
        Judged::at_least(
            "Algorithms that open springs shall name the loss of the last",
            "runs with the error",
            errors,
            Reference::own("varying and kinematic", 6.0),
            "constant stiffness never opens a spring: it goes on until its steps are used up",
        ),
    ];
    let limit = Limit {
        pushed: "a body held by contact alone, every spring open",
        range: "the load of the cylinder, reversed".into(),
        onset: "once the last spring is open, which nothing prevents".into(),
        seen: format!("{errors} of {}: {}; {exhausted}: exhausted", results.len(), first.0),
        instead: first.1,
    };
    let rows = rows.collect();
    Ok(limit
        .finding(vec![table("Cylinder pulled off the plane", &["formulation", "what the user sees"], rows)], checks))
}

/// No load at all, on a body that only contact holds and on bodies that are held.
pub(super) fn none() -> Result<Finding, Error> {
    let free = nine(&cylinder(0.0)?);
    let mut scene = Bars::default().scene();
    scene.bodies.iter_mut().flat_map(|body| &mut body.supports).for_each(|support| support.value = 0.0);
    let held = nine(&meshed(scene, 2, Order::Quadratic)?);
    let named = count(&free, |result| matches!(result, Err(Error { kind: Kind::NothingPresses, .. })));
    let silent = |run: &Run| run.solution.converged() && run.solution.points.iter().all(|p| p.pressure <= 0.0);
    let zero = count(&held, |result| result.as_ref().is_ok_and(silent));
    let (said, remedy) = free.iter().find_map(|(_, result)| result.as_ref().err()).map(said).unwrap_or_default();
    let all = |requirement: &str, quantity: &str, found: f64, because: &str| {
        Judged::at_least(requirement, quantity, found, Reference::own("all nine", free.len() as f64), because)
    };
    let checks = vec![
        all(
            "Without a load a body held by contact alone shall be refused by name",
            "formulations, cylinder",
            named,
            "its position is undetermined",
        ),
        all(
            "Without a load held bodies shall converge to no pressure",
            "formulations, bars",
            zero,
            "the bars do not touch: p = 0 exactly, whatever the formulation",
        ),
    ];
    let limit = Limit {
        pushed: "no load",
        range: "cylinder on a plane; two held bars".into(),
        onset: "zero".into(),
        seen: format!("cylinder: {said}; bars: {}", held.first().map(|(_, result)| seen(result)).unwrap_or_default()),
        instead: remedy,
    };
    Ok(limit.finding(vec![], checks))
}

/// Elements per half-width of the contact under ever smaller loads.
const SIZES: [f64; 9] = [8.0, 4.0, 3.0, 2.0, 1.5, 1.0, 0.5, 0.25, 0.1];
/// Error of p₀ and a that counts as wrong.
const WRONG: f64 = 0.05;

/// A load whose contact falls between the nodes: the mesh stays, the load falls.
pub(super) fn small() -> Result<Finding, Error> {
    let orders = [("4-node", Order::Linear), ("8-node", Order::Quadratic)];
    let mut rows: Vec<Vec<String>> = SIZES.iter().map(|size| vec![number(*size)]).collect();
    let (mut onsets, mut unnoted, mut unresolved) = (Vec::new(), 0.0_f64, String::new());
    for (name, order) in orders {
        let mut wrong = Vec::new();
        for (size, row) in SIZES.into_iter().zip(&mut rows) {
            let result = verified(&falling(size, order)?);
            unresolved = seen(&result);
            let run = result?;
            let errors = hertz_errors(&falling_scene(size), &run);
            let worst = worse(errors[0], errors[1]);
            wrong.push(worst > WRONG);
            unnoted = if run.note(0).is_none() { worse(unnoted, worst) } else { unnoted };
            row.extend([run.measures().active.to_string(), percent(errors[0]), percent(errors[1]), seen(&Ok(run))]);
        }
        onsets.push(format!("{name} {}", bracket(&SIZES, |i| wrong[i], "elements per half-width").0));
    }
    let check = Judged::norm(
        "A contact too small for the mesh shall not be called converged without a note",
        "largest error of p₀ and a among runs without one",
        unnoted,
        Reference::analytic("Hertz", 0.0),
        WRONG,
        "four points: the edge is known to a third of the half-width, and enters the error of p₀ squared",
    );
    let limit = Limit {
        pushed: "a load too small for two contact nodes",
        range: format!("{} … {} elements per half-width", SIZES[0], SIZES[SIZES.len() - 1]),
        onset: format!("errors beyond {}: {}", size(WRONG), onsets.join("; ")),
        seen: unresolved,
        instead: "a mesh made for the load: at least two elements in the half-width".into(),
    };
    let head =
        ["elements per half-width", "4-node: points", "p₀", "a", "user sees", "8-node: points", "p₀", "a", "user sees"];
    Ok(limit.finding(vec![table("Cylinder: contact falling between the nodes", &head, rows)], vec![check]))
}

/// The cylinder whose Hertz half-width is `size / 8` of the default one.
fn falling_scene(size: f64) -> Scene {
    let base = Cylinder::default();
    Cylinder { a_over_r: base.a_over_r * size / SIZES[0], ..base }.scene()
}

/// The same on the mesh made for the default load.
fn falling(size: f64, order: Order) -> Result<Discretisation, Error> {
    let base = Cylinder::default();
    let mut scene = falling_scene(size);
    scene.grading.unit = base.half_width();
    scene.contacts[0].stretch = base.stretch * base.half_width();
    meshed(scene, SIZES[0] as usize, order)
}
