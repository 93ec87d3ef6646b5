//! Iterations of kinematic load from every candidate closed, and from the active set of coarser meshes.

use serde::Serialize;

use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::error::Error;
use crate::measure::{Measures, relative_error};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solution::Solution;
use crate::solve::{self, Discretisation, Element, Formulation, Iteration};
use crate::study::cures::rules::Ended;

/// Elements per half-width, or per 10 mm of arc.
pub(super) const DENSITIES: [usize; 5] = [4, 8, 16, 32, 64];
/// Finest mesh on which every candidate closed is tried too: with line and layer elements its iterations grow with the mesh.
const COMPARED: usize = 16;

/// Nested starts on a scene.
#[derive(Clone, Debug, Serialize)]
pub struct Nested {
    /// Name of the scene.
    pub scene: &'static str,
    /// Every element from its default stiffness and from a soft one.
    pub starts: Vec<Start>,
}

/// An element from one stiffness.
#[derive(Clone, Debug, Serialize)]
pub struct Start {
    /// Contact element.
    pub element: Element,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// On every mesh.
    pub meshes: Vec<OnMesh>,
}

/// Both starts on one mesh.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OnMesh {
    /// From the active set of coarser meshes.
    pub nested: Ended,
    /// All iterations on those.
    pub coarser: usize,
    /// From every candidate closed, where that is tried.
    pub closed: Option<Ended>,
    /// Relative difference of the half-widths found from both.
    pub apart: Option<f64>,
}

/// Scenes of the study.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let truncated = |stretch| TruncatedHertz { stretch, ..Default::default() }.scene();
    vec![
        ("truncated Hertz, L/a = 1.5", truncated(1.5)),
        ("truncated Hertz, L/a = 2", truncated(2.0)),
        ("truncated Hertz, L/a = 3", truncated(3.0)),
        ("truncated Hertz, L/a = 4", truncated(4.0)),
        ("cylinder", Cylinder::default().scene()),
        ("pin-rod", PinRod::default().scene()),
    ]
}

/// Both starts on every mesh.
pub(super) fn run(name: &'static str, scene: &Scene) -> Result<Nested, Error> {
    let mesh =
        |elements| Discretisation::of(scene.clone(), Resolution { elements, refinement: 0, order: Order::Quadratic });
    let meshes = DENSITIES.into_iter().map(mesh).collect::<Result<Vec<_>, _>>()?;
    let stiffnesses = [Iteration::Kinematic.default_stiffness(), 1.0];
    let starts = Element::ALL.into_iter().flat_map(|element| stiffnesses.map(|stiffness| (element, stiffness)));
    let start = |(element, stiffness)| {
        let closed = Formulation { stiffness, ..Formulation::new(element, Iteration::Kinematic) };
        let meshes = meshes.iter().map(|mesh| on_mesh(mesh, &closed)).collect::<Result<_, Error>>()?;
        Ok(Start { element, stiffness, meshes })
    };
    Ok(Nested { scene: name, starts: starts.map(start).collect::<Result<_, Error>>()? })
}

fn on_mesh(mesh: &Discretisation, closed: &Formulation) -> Result<OnMesh, Error> {
    let nested = mesh.solve(&Formulation { start: solve::Start::Nested, ..closed.clone() })?;
    let compared = mesh.resolution.elements <= COMPARED;
    let other = compared.then(|| mesh.solve(closed)).transpose()?;
    Ok(OnMesh {
        nested: Ended::of(&nested),
        coarser: nested.coarser.iterations,
        closed: other.as_ref().map(Ended::of),
        apart: other.map(|other| difference(&mesh.scene, [&nested, &other])),
    })
}

fn difference(scene: &Scene, solutions: [&Solution; 2]) -> f64 {
    let [one, other] = solutions.map(|solution| Measures::of(scene, 0, solution.part(0)).second_moment_width);
    relative_error(one, other)
}
