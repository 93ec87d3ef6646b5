//! What every converged run must satisfy, whatever the problem: equilibrium, invariance, condensed = full, path independence.

use crate::case::check::{Check, Reference};
use crate::case::run::{Contact, Run};
use crate::elasticity::ElasticSystem;
use crate::error::Error;
use crate::formulation::{Discretisation, Formulation};
use crate::measure::whole;
use crate::mesh::Mesh;
use crate::scene::{ContactPair, Path, Scene};

/// Load increments of the path-independence check.
const INCREMENTS: usize = 4;
/// Relative noise on the stiffness of every cell, so that rigid motions stay free of force.
const NOISE: f64 = 1e-12;
/// The variant in which x has the other sign.
const MIRROR_IMAGE: &str = "mirror image";

/// All universal checks of a converged run.
pub fn checks(discretisation: &Discretisation, run: &Run) -> Result<Vec<Check>, Error> {
    let mut checks = Vec::new();
    checks.extend(equilibrium(discretisation, run));
    for contact in 0..discretisation.scene.contacts.len() {
        checks.push(frictionless(discretisation, run, contact)?);
    }
    checks.push(condensed_is_full(discretisation, run)?);
    checks.extend(invariance(discretisation, run)?);
    if run.formulation.name() == Formulation::verification().name() && run.formulation.settings.tolerance <= 1e-8 {
        checks.push(path_independence(discretisation, run)?);
    }
    Ok(checks)
}

/// Contact resultant = applied load, on a body that only contact holds along the load line.
fn equilibrium(discretisation: &Discretisation, run: &Run) -> Option<Check> {
    let scene = &discretisation.scene;
    let [pair] = &scene.contacts[..] else { return balance(discretisation, run) };
    let free = pair.bodies().find(|&body| !held_vertically(scene, body))?;
    let applied = whole(pair) * discretisation.system.bodies[free].applied_vertical().abs();
    Some(Check::relative(
        "The resultant of the reported pressures shall equal the applied load",
        "resultant",
        run.transmitted(),
        Reference::own("applied load", applied),
        run.formulation.settings.tolerance,
        "balance is part of convergence: the run's own tolerance",
    ))
}

/// Several contacts: on each body that only they hold along the load line, their forces and the applied load add up to 0.
fn balance(discretisation: &Discretisation, run: &Run) -> Option<Check> {
    let scene = &discretisation.scene;
    let free: Vec<usize> = (0..scene.bodies.len()).filter(|&body| !held_vertically(scene, body)).collect();
    let imbalance = |&body: &usize| {
        let force = |(pair, contact): (&ContactPair, &Contact)| {
            let upwards = if pair.above == (body == pair.first) { 1.0 } else { -1.0 };
            let takes_part = pair.bodies().any(|other| other == body);
            if takes_part { upwards * contact.transmitted / whole(pair) } else { 0.0 }
        };
        let forces: Vec<f64> = scene.contacts.iter().zip(&run.contacts).map(force).collect();
        let applied = discretisation.system.bodies[body].applied_vertical();
        let pressing: f64 = forces.iter().map(|force| force.abs()).sum();
        (applied + forces.iter().sum::<f64>()).abs() / pressing.max(applied.abs())
    };
    let worst = free.iter().map(imbalance).reduce(|a, b| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) })?;
    Some(Check::norm(
        "The contact forces on every free body shall balance its load",
        "imbalance / pressing forces",
        worst,
        Reference::own("equilibrium", 0.0),
        run.formulation.settings.tolerance,
        "balance is part of convergence: the run's own tolerance",
    ))
}

fn held_vertically(scene: &Scene, body: usize) -> bool {
    scene.bodies[body].supports.iter().any(|support| support.component == crate::scene::Component::Y)
}

/// Tangential contact forces vanish; on arcs this is the moment about the centre.
///
/// Taken from `K u − f` of the recovered displacements, not from the pressures.
fn frictionless(discretisation: &Discretisation, run: &Run, contact: usize) -> Result<Check, Error> {
    let fields = discretisation.recover(&run.solution)?;
    let scene = &discretisation.scene;
    let pair = &scene.contacts[contact];
    let (mut moment, mut force) = (0.0_f64, 0.0_f64);
    for body in pair.bodies() {
        let system = &discretisation.system.bodies[body];
        let internal = system.product(&fields.unknowns[body]);
        let (mut turning, mut pressing) = (0.0, 0.0);
        let part = &discretisation.mesh.bodies[body];
        for candidate in &part.candidates[part.candidates_of(contact)] {
            let residual = nodal_force(discretisation, body, candidate.node, &internal);
            let arm = arm(&pair.path, discretisation.mesh.points[candidate.node]);
            turning += arm[0] * residual[1] - arm[1] * residual[0];
            pressing += residual[0].hypot(residual[1]) * arm[0].hypot(arm[1]);
        }
        moment = moment.max(turning.abs());
        force = force.max(pressing);
    }
    let scale = force.max(scene.reference.pressure * scene.thickness * scene.reference.length * scene.reference.length);
    Ok(match pair.path {
        Path::Arc(_) => Check::norm(
            "The contact forces shall have no moment about the pin's centre",
            "moment / F R",
            moment / scale,
            Reference::own("zero", 0.0),
            1e-9,
            "frictionless on a circle; round-off of the recovered forces",
        ),
        Path::Straight(_) => Check::norm(
            "Contact shall exert no tangential force",
            "moment of tangential forces / F ℓ",
            moment / scale,
            Reference::own("zero", 0.0),
            1e-9,
            "frictionless on a plane; round-off of the recovered forces",
        ),
    })
}

/// Arm about the centre of an arc; on a plane a vertical unit arm, so that the moment is that of tangential forces.
fn arm(path: &Path, point: [f64; 2]) -> [f64; 2] {
    match path {
        Path::Straight(_) => [0.0, 1.0],
        Path::Arc(circle) => [point[0] - circle.centre[0], point[1] - circle.centre[1]],
    }
}

/// `K u − f` at a node in Cartesian components \[N\]; prescribed components give none.
fn nodal_force(discretisation: &Discretisation, body: usize, node: usize, internal: &[f64]) -> [f64; 2] {
    let system = &discretisation.system.bodies[body];
    let mut force = [0.0; 2];
    for (freedom, axis) in system.freedoms.of_node(node).into_iter().zip(system.freedoms.frame(node)) {
        if let crate::elasticity::Freedom::Equation(equation) = freedom {
            let value = internal[equation] - system.force[equation];
            force = [force[0] + value * axis[0], force[1] + value * axis[1]];
        }
    }
    force
}

fn condensed_is_full(discretisation: &Discretisation, run: &Run) -> Result<Check, Error> {
    let full = discretisation.uncondensed_pressures(&run.formulation, &run.solution)?;
    let several = discretisation.interfaces.len() > 1;
    let pressures = run.solution.spring_pressures.iter().copied();
    Ok(Check::norm(
        "Condensed and full system shall give the same contact pressures",
        "max |Δp| / p_max",
        largest_difference(pressures, full.into_iter()) / scale(discretisation, run),
        Reference::own("full system", 0.0),
        if several { 1e-7 } else { 1e-9 },
        match several {
            true => "the same equations; round-off of two factorisations, through bodies that contact alone may hold",
            false => "the same equations; round-off of two factorisations",
        },
    ))
}

/// The same problem told differently must give the same steps and pressures.
fn invariance(discretisation: &Discretisation, run: &Run) -> Result<Vec<Check>, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let resolution = discretisation.resolution;
    let with = |scene: Scene, mesh: Mesh| -> Result<Discretisation, Error> {
        let system = ElasticSystem::assemble(&scene, &mesh)?;
        Discretisation::of_system(scene, resolution, mesh, system)
    };
    let metres = scene.in_metres();
    let mut variants = vec![
        (
            "metres",
            with(metres.clone(), Mesh::of(&metres, resolution)?)?,
            scene.reference.pressure / metres.reference.pressure,
        ),
        (MIRROR_IMAGE, with(scene.mirrored(), mesh.mirrored())?, 1.0),
        ("renumbered nodes", with(scene.clone(), mesh.renumbered())?, 1.0),
    ];
    let noisy = ElasticSystem::assemble_scaled(scene, mesh, &|cell| 1.0 + NOISE * noise(cell))?;
    variants.push((
        "noise of 1e-12 on K",
        Discretisation::of_system(scene.clone(), resolution, mesh.clone(), noisy)?,
        1.0,
    ));
    if let Some(swapped) = scene.swapped() {
        let mesh = Mesh::of(&swapped, resolution)?;
        variants.push(("swapped bodies", with(swapped, mesh)?, 1.0));
    }
    variants.iter().map(|(name, variant, unit)| same(run, name, variant, *unit, scale(discretisation, run))).collect()
}

/// `p_ref`, or the largest pressure of the run where that is larger (it is at the corner of the flat punch) \[MPa\].
fn scale(discretisation: &Discretisation, run: &Run) -> f64 {
    let pressures = run.solution.points.iter().map(|p| p.pressure);
    pressures.fold(discretisation.scene.reference.pressure, f64::max)
}

/// A number in −1 … 1 from an index (SplitMix64; Steele, Lea & Flood 2014).
fn noise(index: usize) -> f64 {
    let mut z = (index as u64).wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
}

/// `unit` turns the variant's pressures into the run's.
fn same(run: &Run, name: &str, variant: &Discretisation, unit: f64, scale: f64) -> Result<Check, Error> {
    let other = variant.solve(&run.formulation)?;
    let pressures = run.solution.points.iter().map(|p| p.pressure);
    let mut others: Vec<f64> = other.points.iter().map(|p| p.pressure * unit).collect();
    let turned = variant.scene.contacts.iter().zip(&other.contacts);
    for (_, share) in turned.filter(|(pair, _)| name == MIRROR_IMAGE && pair.path.has_both_sides()) {
        others[share.points.clone()].reverse();
    }
    let difference = largest_difference(pressures, others.into_iter()) / scale;
    // Where the tolerance is as small as the perturbation itself, one step more or less is no difference.
    let decidable = run.formulation.settings.tolerance >= 100.0 * NOISE;
    let same_steps = other.outcome == run.solution.outcome && (!decidable || other.work == run.solution.work);
    Ok(Check::norm(
        if decidable {
            format!("Steps and pressures shall not change under: {name}")
        } else {
            format!("Pressures shall not change under: {name} (steps not compared: tolerance as small as the noise)")
        },
        "max |Δp| / p_max, infinite where the work differs",
        if same_steps { difference } else { f64::INFINITY },
        Reference::own(name, 0.0),
        1e-9,
        "the same problem told differently",
    ))
}

fn path_independence(discretisation: &Discretisation, run: &Run) -> Result<Check, Error> {
    let mut formulation: Formulation = run.formulation.clone();
    formulation.settings.increments = if formulation.settings.increments == 1 { INCREMENTS } else { 1 };
    formulation.settings.max_steps *= INCREMENTS;
    let other = discretisation.solve(&formulation)?;
    let pressures = run.solution.points.iter().map(|p| p.pressure);
    let difference = largest_difference(pressures, other.points.iter().map(|p| p.pressure));
    Ok(Check::norm(
        "The load applied at once and in increments shall give the same pressures",
        "max |Δp| / p_max",
        if other.converged() { difference / scale(discretisation, run) } else { f64::NAN },
        Reference::own("load increments", 0.0),
        10.0 * run.formulation.settings.tolerance,
        "frictionless contact has no memory; both runs stop within their tolerance",
    ))
}

/// Largest difference; NaN where there is one or where the lengths differ.
fn largest_difference(a: impl ExactSizeIterator<Item = f64>, b: impl ExactSizeIterator<Item = f64>) -> f64 {
    if a.len() != b.len() {
        return f64::NAN;
    }
    a.zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, |worst: f64, d| if d.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(d) })
}
