//! The bars by one iteration, and the fields of a scene.

use serde::Serialize;

use crate::case::Case;
use crate::case::library::{Bars, Cylinder, PinRod};
use crate::error::Error;
use crate::measure;
use crate::mesh::BodyMesh;
use crate::solve::{Discretisation, Fields, Formulation, Run};

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// A run on two bars closing a gap; its history is the path.
    Path(Box<Run>),
    /// The fields of a scene.
    Field(Field),
    /// Pin and rod along their contact arcs.
    Along(Along),
}

/// Pin and rod along their contact arcs, by a formulation.
#[derive(Clone, Debug, Serialize)]
pub struct Along {
    /// Contact element and algorithm.
    pub formulation: Formulation,
    /// Whether the run converged.
    pub converged: bool,
    /// Along the candidates of each body.
    pub arcs: Vec<Arc>,
    /// Largest difference of the hoop stress to that of node elements with kinematic load, over the largest hoop stress.
    pub off: f64,
}

/// A scene whose fields are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Shown {
    /// The cylinder on its plane.
    Cylinder,
    /// The pin in the eye of the rod.
    PinRod,
}

/// Stress and displacement of a scene under node elements and kinematic load.
#[derive(Clone, Debug, Serialize)]
pub struct Field {
    /// The scene.
    pub scene: Shown,
    /// Length \[mm\] and pressure \[MPa\] that the scene is measured by.
    pub reference: [f64; 2],
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Node lists of the cells.
    pub cells: Vec<Vec<usize>>,
    /// σ_y at the nodes \[MPa\].
    pub stress: Vec<f64>,
    /// Displacements of the nodes \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// Load of the scene on the modelled part \[N\].
    pub load: f64,
    /// Vertical force of the recovered stresses on some lines.
    pub resultants: Vec<Resultant>,
}

/// Stress and displacement along the candidates of a body.
#[derive(Clone, Debug, Serialize)]
pub struct Arc {
    /// Name of the body.
    pub body: String,
    /// Angle \[°\] and hoop stress \[MPa\].
    pub hoop: Vec<[f64; 2]>,
    /// Angle \[°\] and displacement along the outward normal \[mm\].
    pub displacement: Vec<[f64; 2]>,
}

/// Vertical force of the recovered stresses on a line.
#[derive(Clone, Debug, Serialize)]
pub struct Resultant {
    /// Name of the body.
    pub body: String,
    /// The line.
    pub on: Where,
    /// Its size \[N\].
    pub force: f64,
}

/// A line that takes the whole load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Where {
    /// The candidates of the contact.
    Contact,
    /// The horizontal cut of the disc.
    Cut,
}

impl Shown {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Cylinder, Self::PinRod];

    fn case(self) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::PinRod => "pin-rod",
        }
    }
}

/// The bars, pushed together by three gaps.
pub fn bars() -> Bars {
    Bars { push: 3.0, ..Default::default() }
}

/// A run on the bars.
pub fn path(formulation: &Formulation) -> Result<Numbers, Error> {
    let case = bars().case();
    Ok(Numbers::Path(Box::new(Run::of(&Discretisation::of(case.scene, case.resolution)?, formulation)?)))
}

/// Vertical stress on the deformed mesh, hoop stress and normal displacement along the candidates, and what the stresses
/// carry.
pub fn field(scene: Shown) -> Result<Field, Error> {
    let case = scene.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let fields = discretisation.recover(&run.solution)?;
    let Discretisation { scene: given, mesh, system, .. } = &discretisation;
    let bodies = || given.bodies.iter().zip(&mesh.bodies);
    let thickness = given.thickness;
    let contact = bodies().map(|(body, part)| {
        let force = thickness * on_candidates(&mesh.points, part, &fields);
        Resultant { body: body.name.clone(), on: Where::Contact, force }
    });
    let edges = mesh.boundary(given, 0, "cut")?;
    let cut = thickness * edges.iter().map(|edge| on_edge(&mesh.points, edge, &fields)).sum::<f64>();
    let cut = Resultant { body: given.bodies[0].name.clone(), on: Where::Cut, force: cut.abs() };
    Ok(Field {
        scene,
        reference: [given.reference.length, given.reference.pressure],
        points: mesh.points.clone(),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        stress: fields.stress.iter().map(|stress| stress[1]).collect(),
        displacement: fields.displacement.clone(),
        load: system.bodies.iter().map(|body| body.applied_vertical().abs()).sum(),
        resultants: contact.chain([cut]).collect(),
    })
}

/// Pin and rod along their contact arcs.
pub fn along(formulation: &Formulation) -> Result<Along, Error> {
    let case = Shown::PinRod.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let by = |formulation: &Formulation| -> Result<_, Error> {
        let run = Run::of(&discretisation, formulation)?;
        let fields = discretisation.recover(&run.solution)?;
        let bodies = discretisation.scene.bodies.iter().zip(&discretisation.mesh.bodies);
        let arcs: Vec<Arc> = bodies.map(|(body, part)| arc(&body.name, part, &fields)).collect();
        Ok((run.solution.converged(), arcs))
    };
    let ((converged, arcs), (_, other)) = (by(formulation)?, by(&Formulation::verification())?);
    let hoop = |arcs: &[Arc]| arcs.iter().flat_map(|arc| &arc.hoop).map(|[_, stress]| *stress).collect::<Vec<f64>>();
    let [own, other] = [hoop(&arcs), hoop(&other)];
    let difference = measure::largest(own.iter().zip(&other).map(|(own, other)| (own - other).abs()));
    let off = if converged { difference / measure::largest(other.iter().map(|stress| stress.abs())) } else { f64::NAN };
    Ok(Along { formulation: formulation.clone(), converged, arcs, off })
}

fn arc(body: &str, part: &BodyMesh, fields: &Fields) -> Arc {
    let along = |of: &dyn Fn(usize, [f64; 2]) -> f64| {
        part.candidates.iter().map(|c| [c.coordinate.to_degrees(), of(c.node, c.normal)]).collect()
    };
    let hoop = |node: usize, n: [f64; 2]| {
        let [x, y, xy]: [f64; 3] = fields.stress[node];
        x * n[1] * n[1] + y * n[0] * n[0] - 2.0 * xy * n[0] * n[1]
    };
    let normal = |node: usize, n: [f64; 2]| fields.displacement[node][0] * n[0] + fields.displacement[node][1] * n[1];
    Arc { body: body.into(), hoop: along(&hoop), displacement: along(&normal) }
}

/// `|∫ (σ n)_y ds|` over the candidates of a body, by the trapezoidal rule [N/mm].
fn on_candidates(points: &[[f64; 2]], part: &BodyMesh, fields: &Fields) -> f64 {
    let traction = |node: usize, n: [f64; 2]| fields.stress[node][2] * n[0] + fields.stress[node][1] * n[1];
    let pairs = part.candidates.windows(2).map(|pair| {
        let sum: f64 = pair.iter().map(|candidate| traction(candidate.node, candidate.normal)).sum();
        0.5 * sum * distance(points[pair[0].node], points[pair[1].node])
    });
    pairs.sum::<f64>().abs()
}

/// `∫ σ_y dx` over an edge, by Simpson's rule where it has a middle node [N/mm].
fn on_edge(points: &[[f64; 2]], edge: &[usize], fields: &Fields) -> f64 {
    let stress = |index: usize| fields.stress[edge[index]][1];
    let mean = match edge.len() {
        3 => (stress(0) + stress(1) + 4.0 * stress(2)) / 6.0,
        _ => 0.5 * (stress(0) + stress(1)),
    };
    mean * distance(points[edge[0]], points[edge[1]])
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
