//! What every converged run must satisfy, whatever the problem: equilibrium, invariance, condensed = full, path
//! independence.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::elasticity::{ElasticSystem, numbered};
use crate::error::Error;
use crate::measure::{larger, profile};
use crate::mesh::Mesh;
use crate::mesh::variant::noise;
use crate::scene::{Path, Scene};
use crate::solution::{EdgeState, EnergyError, Share};
use crate::solve::run::{BALANCED, Run};
use crate::solve::{Discretisation, Formulation};
use crate::stability::conditioning::{self, Influence};

/// Load increments of the path-independence check.
const INCREMENTS: usize = 4;
/// Relative noise on the stiffness of every cell, so that rigid motions stay free of force.
const NOISE: f64 = 1e-12;
/// The variant in which x has the other sign.
const MIRROR_IMAGE: &str = "mirror image";

/// What is left over of the forces on a body.
const IMBALANCE: &str =
    "imbalance of loads, contact and reactions of a body, in force and moment, over the largest of them";

/// Round-off in sums over the whole system, relative to the size of their terms.
const ROUND_OFF: f64 = 1e-9;

/// What every run must satisfy, converged or not: the bound on its error in the energy norm.
pub fn bounded(run: &Run) -> Option<Judged> {
    let EnergyError { error, bound } = run.solution.energy?;
    // Where round-off is larger, a square may come out below zero.
    let [error, bound] = [error, bound].map(|square| larger(square, 0.0).sqrt());
    let check = Check::error(
        "excess of the last iterate's error over its bound, error / (bound + 1e-8) − 1 in the energy norm",
        Reference::own("active set", 0.0),
        1e-6,
        "an inequality, derived beside it; 1e-8 of the stored energy's root is round-off",
    );
    Some(check.universal().judge(larger(error / (bound + SQUARED) - 1.0, 0.0)))
}

/// Root of the round-off of an energy.
const SQUARED: f64 = 1e-8;

/// All universal checks of a converged run.
pub fn checks(discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let mut checks = Vec::new();
    let limit = limit(discretisation, run)?;
    checks.push(equilibrium(discretisation, run));
    checks.extend(nothing_where_open(discretisation, run, limit));
    for contact in 0..discretisation.scene.contacts.len() {
        checks.push(frictionless(discretisation, run, contact)?);
    }
    checks.push(condensed_is_full(discretisation, run, limit)?);
    checks.extend(invariance(discretisation, run, limit)?);
    if run.formulation.is_like(&Formulation::verification()) && run.formulation.settings.tolerance <= 1e-8 {
        checks.push(path_independence(discretisation, run)?);
    }
    Ok(checks.into_iter().map(|judged| Judged { check: judged.check.universal(), ..judged }).collect())
}

/// Loads, contact pressures as they are reported, and reactions of every body add up to nothing, in force and in
/// moment.
fn equilibrium(discretisation: &Discretisation, run: &Run) -> Judged {
    let worst = run.equilibrium.iter().max_by(|a, b| a.largest().total_cmp(&b.largest()));
    let body = worst.map_or("", |worst| discretisation.scene.bodies[worst.body].name.as_str());
    let check = Check::error(
        Quantity::at(IMBALANCE, body),
        Reference::own("equilibrium", 0.0),
        run.formulation.settings.tolerance.max(BALANCED),
        "balance is part of convergence: the run's own tolerance, or 1e-7 for the round-off of the stiffness",
    );
    check.judge(run.imbalance())
}

/// Tangential contact forces vanish; on arcs this is the moment about the centre.
///
/// Taken from `K u − f` of the recovered displacements, not from the pressures.
fn frictionless(discretisation: &Discretisation, run: &Run, contact: usize) -> Result<Judged, Error> {
    let fields = discretisation.recover(&run.solution)?;
    let scene = &discretisation.scene;
    let pair = &scene.contacts[contact];
    let (mut moment, mut force, mut rounding) = (0.0_f64, 0.0_f64, 0.0_f64);
    for body in pair.bodies() {
        let system = &discretisation.system.bodies[body];
        let internal = system.product(&fields.unknowns[body]);
        let terms = system.terms_of_product(&fields.unknowns[body]);
        let (mut turning, mut pressing, mut rounded) = (0.0, 0.0, 0.0);
        let part = &discretisation.mesh.bodies[body];
        for candidate in &part.candidates[part.candidates_of(contact)] {
            let residual = nodal_force(discretisation, body, candidate.node, &internal);
            let arm = arm(&pair.path, discretisation.mesh.points[candidate.node]);
            turning += arm[0] * residual[1] - arm[1] * residual[0];
            pressing += residual[0].hypot(residual[1]) * arm[0].hypot(arm[1]);
            let equations = system.dofs.of_node(candidate.node).into_iter().filter_map(|dof| dof.equation());
            rounded += equations.map(|equation| f64::EPSILON * terms[equation]).sum::<f64>() * arm[0].hypot(arm[1]);
        }
        moment = moment.max(turning.abs());
        force = force.max(pressing);
        rounding = rounding.max(rounded);
    }
    let scale = force.max(scene.reference.pressure * scene.thickness * scene.reference.length * scene.reference.length);
    let limit = ROUND_OFF.max(rounding / scale);
    let (quantity, because) = match pair.path {
        Path::Arc(_) => (
            "moment of the contact forces about the centre of the arc, over F R",
            "frictionless on a circle; round-off of the recovered forces",
        ),
        Path::Straight { .. } => (
            "moment of tangential contact forces, over F ℓ",
            "frictionless on a plane; round-off of the recovered forces",
        ),
    };
    Ok(Check::error(quantity, Reference::own("zero", 0.0), limit, because).judge(moment / scale))
}

/// Arm about the centre of an arc; on a plane a vertical unit arm, so that the moment is that of tangential forces.
fn arm(path: &Path, point: [f64; 2]) -> [f64; 2] {
    match path {
        Path::Straight { .. } => [0.0, 1.0],
        Path::Arc(circle) => [point[0] - circle.centre[0], point[1] - circle.centre[1]],
    }
}

/// `K u − f` at a node in Cartesian components \[N\]; prescribed components give none.
fn nodal_force(discretisation: &Discretisation, body: usize, node: usize, internal: &[f64]) -> [f64; 2] {
    let system = &discretisation.system.bodies[body];
    let mut force = [0.0; 2];
    for (dof, axis) in system.dofs.of_node(node).into_iter().zip(system.dofs.frame(node)) {
        if let Some(equation) = dof.equation() {
            let value = internal[equation] - system.force[equation];
            force = [force[0] + value * axis[0], force[1] + value * axis[1]];
        }
    }
    force
}

fn condensed_is_full(discretisation: &Discretisation, run: &Run, limit: f64) -> Result<Judged, Error> {
    let full = discretisation.uncondensed_pressures(&run.formulation, &run.solution)?;
    let pressures = run.solution.spring_pressures.iter().copied();
    let quantity = "difference of contact pressures between condensed and full system, over the largest";
    let because =
        "the same equations; 1e-9, or what one rounding of every product grows to through the contact's own condition";
    let difference = largest_difference(pressures, full.into_iter()) / scale(discretisation, run);
    Ok(Check::error(quantity, Reference::own("the full system", 0.0), limit, because).judge(difference))
}

/// An open contact carries nothing, whatever its neighbours do.
fn nothing_where_open(discretisation: &Discretisation, run: &Run, limit: f64) -> Option<Judged> {
    let open = || run.contacts.iter().filter(|contact| contact.open == Some(true));
    let applied: f64 = discretisation.condensed.load.iter().map(|force| force.abs()).sum();
    let largest = run.contacts.iter().map(|contact| contact.transmitted.abs()).fold(applied, f64::max);
    let carried = open().map(|contact| contact.transmitted.abs()).fold(0.0, larger);
    (open().count() > 0).then(|| {
        let tolerance = run.formulation.settings.tolerance.max(limit);
        let quantity = "force of a contact that is called open, over the largest force or the load";
        let because = "the run's own tolerance, but for round-off";
        Check::error(quantity, Reference::own("zero", 0.0), tolerance, because).judge(carried / largest)
    })
}

/// Largest change of a pressure, over the largest, that round-off may make: 1e-9, or where the contact is sensitive,
/// such as to what turns a body on a short contact, what one rounding of every product in `K U`, `S u` and `b·u` adds
/// up to.
///
/// A product of `K U` off by ε is a force `ε |K||U|` on its dof; it changes the pressure of a point by that times the
/// displacement v of the dof under a unit of the point (reciprocity). One of `b·u` is a gap of `ε |b||u|`:
/// `|δp| ≤ ε (Σ |v| |K||U| + Σ |v| |S||u| + Σ |m| |b||u|)`.
fn limit(discretisation: &Discretisation, run: &Run) -> Result<f64, Error> {
    let points = discretisation.points(&run.formulation);
    let problem = discretisation.problem(&run.formulation, &points);
    let pressures: Vec<f64> = run.solution.points.iter().map(|point| point.pressure).collect();
    let Some(influence) = conditioning::influence(&problem, &pressures) else { return Ok(ROUND_OFF) };
    let unknowns = discretisation.recover(&run.solution)?.unknowns;
    let bodies = discretisation.system.bodies.iter().zip(&unknowns);
    let forces: Vec<Vec<f64>> = bodies.map(|(body, u)| body.terms_of_product(u)).collect();
    let condensed = problem.stiffness.terms(&run.solution.displacement);
    let gaps: Vec<f64> = points.iter().map(|point| point.size_of_approach(&run.solution.displacement)).collect();
    let change = |felt: &Influence| {
        let displaced = discretisation.condensed.recover(0.0, &felt.of_forces);
        let by_forces = displaced.iter().zip(&forces).flat_map(|(v, f)| v.iter().zip(f).map(|(v, f)| (v * f).abs()));
        let by_condensed = felt.of_forces.iter().zip(&condensed).map(|(v, f)| (v * f).abs());
        let by_gaps = felt.of_gaps.iter().map(|(j, m)| (m * gaps[*j]).abs());
        f64::EPSILON * by_forces.chain(by_condensed).chain(by_gaps).sum::<f64>()
    };
    let largest = influence.iter().map(change).fold(0.0, f64::max);
    Ok(ROUND_OFF.max(largest / scale(discretisation, run)))
}

/// The same problem told differently must give the same iterations and pressures.
fn invariance(discretisation: &Discretisation, run: &Run, limit: f64) -> Result<Vec<Judged>, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let resolution = discretisation.resolution;
    let with = |scene: Scene, mesh: Mesh| -> Result<Discretisation, Error> {
        let system = ElasticSystem::assemble(&scene, &mesh)?;
        Discretisation::of_system(scene, resolution, mesh, system)
    };
    let metres = scene.in_metres();
    let mut variants = vec![(
        "metres",
        with(metres.clone(), Mesh::of(&metres, resolution)?)?,
        scene.reference.pressure / metres.reference.pressure,
    )];
    // A body of revolution is its own mirror image, and its section lies at x ≥ 0.
    if !scene.is_of_revolution() {
        variants.push((MIRROR_IMAGE, with(scene.mirrored(), mesh.mirrored())?, 1.0));
    }
    variants.push(("renumbered nodes", with(scene.clone(), mesh.renumbered())?, 1.0));
    let noisy =
        ElasticSystem::assemble_numbered(scene, mesh, numbered(scene, mesh)?, &|cell| 1.0 + NOISE * noise(cell))?;
    variants.push((
        "noise of 1e-12 on K",
        Discretisation::of_system(scene.clone(), resolution, mesh.clone(), noisy)?,
        1.0,
    ));
    if let Some(swapped) = scene.swapped() {
        let mesh = Mesh::of(&swapped, resolution)?;
        variants.push(("swapped bodies", with(swapped, mesh)?, 1.0));
    }
    let scale = scale(discretisation, run);
    variants.iter().map(|(name, variant, unit)| same(run, name, variant, *unit, [scale, limit])).collect()
}

/// `p_ref`, or the largest pressure of the run where that is larger (it is at the corner of the flat punch) \[MPa\].
fn scale(discretisation: &Discretisation, run: &Run) -> f64 {
    let pressures = run.solution.points.iter().map(|p| p.pressure);
    pressures.fold(discretisation.scene.reference.pressure, f64::max)
}

/// `unit` turns the variant's pressures into the run's.
fn same(run: &Run, name: &str, variant: &Discretisation, unit: f64, [scale, limit]: [f64; 2]) -> Result<Judged, Error> {
    let other = variant.solve(&run.formulation)?;
    let pressures = run.solution.points.iter().map(|p| p.pressure);
    let mut others: Vec<f64> = other.points.iter().map(|p| p.pressure * unit).collect();
    let turned = variant.scene.contacts.iter().zip(&other.contacts);
    for (_, share) in turned.filter(|(pair, _)| name == MIRROR_IMAGE && pair.path.has_both_sides()) {
        others[share.points.clone()].reverse();
    }
    let difference = largest_difference(pressures, others.into_iter()) / scale;
    // Where the tolerance is as small as the perturbation itself, one iteration more or less is no difference.
    let decidable = run.formulation.settings.tolerance >= 100.0 * limit * NOISE / ROUND_OFF;
    let same_iterations = other.outcome == run.solution.outcome && (!decidable || other.work == run.solution.work);
    let quantity = if decidable {
        "change of iterations (infinite) or pressures, over the largest pressure"
    } else {
        "change of pressures, over the largest (iterations not compared: tolerance as small as the noise)"
    };
    let because = "the same problem in another form; 1e-9, or what one rounding of every product grows to through the \
        contact's own condition";
    let check = Check::error(Quantity::at(quantity, name), Reference::own(name, 0.0), limit, because);
    Ok(check.judge(if same_iterations { difference } else { f64::INFINITY }))
}

fn path_independence(discretisation: &Discretisation, run: &Run) -> Result<Judged, Error> {
    let mut formulation: Formulation = run.formulation.clone();
    formulation.settings.increments = if formulation.settings.increments == 1 { INCREMENTS } else { 1 };
    formulation.settings.max_iterations *= INCREMENTS;
    let other = discretisation.solve(&formulation)?;
    let apart = |share: &Share| {
        let [own, other] = [&run.solution.edges, &other.edges].map(|edges| &edges[share.edges.clone()]);
        profile::misplaced(own, other)
    };
    // What is open both ways holds nothing to compare.
    let presses = |edges: &[EdgeState]| edges.iter().any(|edge| edge.pressure > 0.0);
    let closed = |share: &&Share| [&run.solution, &other].iter().any(|of| presses(&of.edges[share.edges.clone()]));
    let difference = run.solution.contacts.iter().filter(closed).map(apart).fold(0.0, larger);
    let check = Check::error(
        "share of the force elsewhere when the load is applied at once or in increments",
        Reference::own("load increments", 0.0),
        2.0 * run.formulation.settings.tolerance,
        "frictionless contact has no memory; both runs stop within their tolerance",
    );
    Ok(check.judge(if other.converged() { difference } else { f64::NAN }))
}

/// Largest difference; NaN where there is one or where the lengths differ.
fn largest_difference(a: impl ExactSizeIterator<Item = f64>, b: impl ExactSizeIterator<Item = f64>) -> f64 {
    if a.len() != b.len() {
        return f64::NAN;
    }
    a.zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}
