//! The pin cases: pin in a wide plate against Persson, pin and rod against one another.

use crate::case::problem::{self, Problem};
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::Resolution;
use crate::oracle::Quantity;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Trial, trials as trials_of};

/// Name of the case of all nine on the pin–rod.
pub const PIN_ROD: &str = "pin-rod";
/// Contact half-angles of the plate cases \[degrees\] and their elements per 10 mm of arc.
const ANGLES: [(f64, usize); 3] = [(30.0, 48), (60.0, 24), (80.0, 24)];
/// Where the hoop stress of the hole is read \[degrees\].
const HOOP: [f64; 2] = [90.0, 180.0];

/// Trials of the pin cases.
pub fn trials() -> Vec<Trial> {
    let mut all = Vec::new();
    for (angle, elements) in ANGLES {
        let problem = Problem::new("pin-plate", "pin in a wide plate", problem::pin_plate(angle));
        let resolution = Resolution { elements, ..problem.resolution };
        let case = format!("pin in plate, ε = {angle}°");
        all.extend(trials_of(&case, problem, resolution, vec![Formulation::verification()], Some(persson)));
    }
    if let Ok(rod) = problem::problem("pin-rod", None) {
        all.extend(trials_of(PIN_ROD, rod.clone(), rod.resolution, Formulation::compared(), Some(one_another)));
    }
    all
}

fn persson(problem: &Problem, discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let Some(oracle) = &problem.oracle else { return Ok(Vec::new()) };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity);
    let points = &run.solution.points;
    let pressure = |phi: f64| problem.reference_pressure(phi);
    let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
    let edge = read(Quantity::ContactAngle).value;
    let mut checks = vec![
        Judged::relative(
            "p(0) shall follow Persson",
            "p(0) [MPa]",
            converged(run.measures().peak.pressure),
            read(Quantity::PeakPressure),
            1e-3,
            "rim of the plate at 500 radii: no model error to speak of",
        ),
        Judged::norm(
            "The pressure profile shall follow Persson",
            "L2(p)",
            converged(profile::relative_l2(points, pressure, 1.5 * edge)),
            Reference::analytic(oracle.name(), 0.0),
            5e-3,
            "square-root edge, resolved by the elements on the arc",
        ),
        Judged::relative(
            "The second-moment angle shall follow Persson",
            "2 √(∫pφ²/∫p) [rad]",
            converged(run.measures().half_width),
            read(Quantity::SecondMoment),
            3e-3,
            "edge within an element, plate finite",
        ),
    ];
    for degrees in HOOP {
        let at: f64 = degrees.to_radians();
        checks.push(Judged::relative(
            "The hoop stress on the hole's rim shall follow Persson",
            format!("σ_θθ({degrees}°) [MPa]"),
            converged(hoop_stress(discretisation, run, at)?),
            read(Quantity::HoopStress { at }),
            1e-2,
            "nodal stress from 2×2 Gauss points on the growing elements away from the contact",
        ));
    }
    Ok(checks)
}

/// Hoop stress at the node of the second body's contact boundary nearest to an angle \[MPa\].
fn hoop_stress(discretisation: &Discretisation, run: &Run, at: f64) -> Result<f64, Error> {
    let fields = discretisation.recover(&run.solution)?;
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let body = scene.contact().second.unwrap_or(0);
    let path = &scene.contact().path;
    let nodes = mesh.boundary(scene, body, "contact")?.iter().flatten();
    let distance = |node: &usize| (path.coordinate(mesh.points[*node]) - at).abs();
    let nearest = nodes.copied().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let Some(node) = nearest.filter(|node| distance(node) < 1e-6) else { return Ok(f64::NAN) };
    let [x, y, xy] = fields.stress[node];
    let (sin, cos) = at.sin_cos();
    Ok(x * cos * cos + y * sin * sin + 2.0 * xy * sin * cos)
}

/// All nine agree with the node element under kinematic load at tolerance 1e-8.
fn one_another(_: &Problem, discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
    let reference = Run::of(discretisation, &Formulation::verification())?;
    let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
    let own = |value| Reference::own("node.kinematic at 1e-8", value);
    let because = "engineering tolerance of the paper's comparison; iteration error to 3e-3";
    Ok(vec![
        Judged::relative(
            "All nine shall find the same peak pressure",
            "peak [MPa]",
            converged(run.measures().peak.pressure),
            own(reference.measures().peak.pressure),
            1e-2,
            because,
        ),
        Judged::relative(
            "All nine shall find the same second-moment angle",
            "2 √(∫pθ²/∫p) [rad]",
            converged(run.measures().half_width),
            own(reference.measures().half_width),
            1e-2,
            because,
        ),
        Judged::norm(
            "All nine shall find the same profile of edge means",
            "share of the force elsewhere",
            converged(profile::misplaced(&run.solution.edges, &reference.solution.edges)),
            own(0.0),
            1e-2,
            because,
        ),
    ])
}
