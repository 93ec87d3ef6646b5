//! Fields and iteration paths that are shown, not judged.

use crate::case::library::Bars;
use crate::case::problem::{self, Problem};
use crate::error::Error;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::{FieldData, Finding, Series, Trial, trials as trials_of};

/// Name of the case whose runs show the path of the iterations.
pub const PATHS: &str = "iteration paths, two bars";
/// Displacement of the upper bar over the gap in that case.
pub const PUSH: f64 = 3.0;
/// Start stiffness in that case, so soft that every algorithm has a way to go.
const SOFT: f64 = 0.4;

/// Name of the field picture of a scene.
pub fn field(scene: &str) -> String {
    format!("fields, {scene}")
}

/// Trials that only show.
pub fn trials() -> Vec<Trial> {
    let bars = Problem::new("bars", "two bars", problem::bars(Bars { push: PUSH, ..Default::default() }));
    let soft = |algorithm| Formulation { stiffness: SOFT, ..Formulation::new(Element::Node, algorithm) };
    let mut trials = trials_of(PATHS, bars.clone(), bars.resolution, Iteration::ALL.map(soft).into(), None);
    for scene in ["cylinder", "pin-rod"] {
        trials.push(Trial::new(field(scene), "node.kinematic", move || fields(scene)));
    }
    trials
}

/// Vertical stress on the deformed mesh, and the hoop stress and radial displacement of the first body's contact arc.
fn fields(scene: &str) -> Result<Finding, Error> {
    let problem = problem::problem(scene, None)?;
    let discretisation = Discretisation::of(problem.scene, problem.resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let fields = discretisation.recover(&run.solution)?;
    let mesh = &discretisation.mesh;
    let data = FieldData {
        title: format!("{scene}: σ_y on the deformed mesh"),
        points: mesh.points.clone(),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        values: fields.stress.iter().map(|stress| stress[1]).collect(),
        displacements: fields.displacement.clone(),
    };
    let mut series = Vec::new();
    for (body, part) in discretisation.scene.bodies.iter().zip(&mesh.bodies) {
        let along = |of: &dyn Fn(usize, [f64; 2]) -> f64| -> Vec<[f64; 2]> {
            let candidates = part.candidates.iter();
            candidates.map(|c| [c.coordinate.to_degrees(), of(c.node, c.normal)]).collect()
        };
        let hoop = along(&|node, n| {
            let [x, y, xy] = fields.stress[node];
            x * n[1] * n[1] + y * n[0] * n[0] - 2.0 * xy * n[0] * n[1]
        });
        let radial = along(&|node, n| fields.displacement[node][0] * n[0] + fields.displacement[node][1] * n[1]);
        for (picture, points) in [("hoop stress", hoop), ("normal displacement", radial)] {
            series.push(Series { picture: picture.into(), label: body.name.clone(), points, failed: Vec::new() });
        }
    }
    Ok(Finding { series, fields: vec![data], ..Default::default() })
}
