//! Steps of kinematic load from every candidate closed, and from the contact set of coarser meshes.

use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::{Measures, larger, relative_error};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solution::Solution;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Start};
use crate::study::unsorted::{Finding, Table};

/// Elements per half-width, or per 10 mm of arc.
const DENSITIES: [usize; 5] = [4, 8, 16, 32, 64];
/// Finest mesh on which every candidate closed is tried too: with line and layer elements its steps grow with the mesh.
const COMPARED: usize = 16;
/// Steps that a nested start may take on every mesh.
const STEPS: f64 = 3.0;

/// Columns of the tables of steps.
pub fn head() -> Vec<String> {
    let densities = DENSITIES.map(|elements| format!("{elements} elements"));
    ["scene", "element", "κ₀"].map(String::from).into_iter().chain(densities).collect()
}

/// Scenes of the study.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let truncated = |stretch| problem::truncated_hertz(TruncatedHertz { stretch, ..Default::default() }).0;
    vec![
        ("truncated Hertz, L/a = 1.5", truncated(1.5)),
        ("truncated Hertz, L/a = 2", truncated(2.0)),
        ("truncated Hertz, L/a = 3", truncated(3.0)),
        ("truncated Hertz, L/a = 4", truncated(4.0)),
        ("cylinder", problem::cylinder(Cylinder::default()).0),
        ("pin-rod", PinRod::default().scene()),
    ]
}

/// Steps of both starts on every mesh, for every element, from its default stiffness and from a soft one.
pub fn steps(name: &str, scene: &Scene) -> Result<Finding, Error> {
    let mesh =
        |elements| Discretisation::of(scene.clone(), Resolution { elements, refinement: 0, order: Order::Quadratic });
    let meshes = DENSITIES.into_iter().map(mesh).collect::<Result<Vec<_>, _>>()?;
    let (mut rows, mut checks) = (Vec::new(), Vec::new());
    for element in Element::ALL {
        for stiffness in [Iteration::Kinematic.default_stiffness(), 1.0] {
            let closed = Formulation { stiffness, ..Formulation::new(element, Iteration::Kinematic) };
            let (mut most, mut apart) = (0.0_f64, 0.0_f64);
            let mut row = vec![name.to_string(), element.name().into(), format!("{stiffness:e}")];
            for mesh in &meshes {
                let nested = mesh.solve(&Formulation { start: Start::Nested, ..closed.clone() })?;
                most = larger(most, if nested.converged() { nested.work.steps as f64 } else { f64::NAN });
                let mut cell = format!("{} (+{})", count(&nested), nested.coarser.steps);
                if mesh.resolution.elements <= COMPARED {
                    let other = mesh.solve(&closed)?;
                    apart = larger(apart, difference(scene, [&nested, &other]));
                    cell = format!("{} → {cell}", count(&other));
                }
                row.push(cell);
            }
            rows.push(row);
            checks.extend(check(element, stiffness, most, apart));
        }
    }
    let table = Table { title: name.into(), head: head(), rows };
    Ok(Finding { checks, tables: vec![table], ..Default::default() })
}

fn check(element: Element, stiffness: f64, most: f64, apart: f64) -> [Judged; 2] {
    let of = format!("{}.kinematic, κ₀ = {stiffness:e}", element.name());
    [
        Judged::at_most(
            "Started from the contact set of a coarser mesh, kinematic load shall take at most three steps on every mesh",
            format!("most steps on a mesh, {of}"),
            most,
            Reference::own("at most", STEPS),
            "a step for the set, one for its edge, one to spare, whatever the mesh",
        ),
        Judged::norm(
            "The start shall not change the contact that is found",
            format!("largest difference of half-widths, {of}"),
            apart,
            Reference::own("every candidate closed", 0.0),
            1e-3,
            "both converge to an iteration error of 1e-3",
        ),
    ]
}

fn difference(scene: &Scene, solutions: [&Solution; 2]) -> f64 {
    let [one, other] = solutions.map(|solution| Measures::of(scene, 0, solution.part(0)).half_width);
    relative_error(one, other)
}

fn count(solution: &Solution) -> String {
    if solution.converged() { solution.work.steps.to_string() } else { solution.outcome.to_string() }
}
