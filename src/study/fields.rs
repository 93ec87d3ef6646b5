//! Stress on the deformed bodies, and the path of the iterations.

use crate::case::library::{Bars, Cylinder, PinRod};
use crate::case::{Case, Check, Judged, Quantity, Reference, universal};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Axis, Chart, ColourMap, Detail, Direction, Drawing, Guide, Remark, Series, Window, panels};
use crate::error::Error;
use crate::markdown::significant;
use crate::measure;
use crate::mesh::BodyMesh;
use crate::solve::{Discretisation, Element, Fields, Formulation, Iteration, Run, shapes};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::{WITHOUT_GAERTNER, label, marks, picture, style};

/// Start stiffness of the bars, so soft that every iteration has a way to go.
const SOFT: f64 = 0.4;

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// A run on two bars closing a gap; its history is the path.
    Path(Box<Run>),
    /// The fields of a scene.
    Field(Box<Field>),
    /// Pin and rod along their contact arcs.
    Along(Along),
}

impl Study for Numbers {
    const NAME: &'static str = "fields";
    const ABOUT: About = About {
        title: "Fields and iteration paths",
        asked: "What the deformed bodies look like, and which way the iterations go.",
        limits: "Pictures; the resultants of the stresses are checked, not every stress.",
    };

    fn plan() -> Vec<Planned<Self>> {
        let paths = Iteration::ALL.map(|algorithm| {
            let formulation = Formulation { stiffness: SOFT, ..Formulation::new(Element::Node, algorithm) };
            Planned::new("iteration paths, two bars", formulation.name(), move || path(&formulation))
        });
        let fields = SHOWN.map(|shown| {
            let name = format!("fields, {}", shown.0().name);
            Planned::new(name, "node.kinematic", move || field(shown).map(Box::new).map(Numbers::Field))
        });
        let along = Formulation::compared().into_iter().filter(Formulation::is_in_the_paper).map(|formulation| {
            Planned::new("along pin and rod", formulation.name(), move || along(&formulation).map(Numbers::Along))
        });
        paths.into_iter().chain(fields).chain(along).collect()
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Path(run) => universal::bounded(run).into_iter().collect(),
            Numbers::Along(along) => vec![agrees(along)],
            Numbers::Field(field) => field.resultants.iter().map(|resultant| carries(field, resultant)).collect(),
        })
    }

    /// Charts with their captions.
    fn section(_: &[Found<Self>]) -> Result<String, Error> {
        let charts = [
            ("field-cylinder.svg", "As Fig. 9. Cylinder: mesh and vertical stress on the deformed shape"),
            ("field-pin-rod.svg", "As Fig. 13. Pin and rod: mesh and vertical stress on the deformed shape"),
            (
                "figure-15.svg",
                "Fig. 15, which quantity it shows not being known: hoop stress and displacement along pin and rod by \
                the five combinations that the paper shows, without Gaertner's curves",
            ),
            ("iteration-paths.svg", "Figs 6 and 7, and kinematic load beside them: the path of the iterations"),
        ];
        let charts = charts.map(|(file, caption)| picture(file, caption));
        Ok(charts.concat())
    }

    /// All charts of what was found.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let (mut runs, mut alongs, mut charts) = (Vec::new(), Vec::new(), Vec::new());
        for found in findings {
            match found.numbers {
                Numbers::Path(run) => runs.push(&**run),
                Numbers::Field(field) => charts.push((format!("field-{}.svg", field.scene), field.stress.drawing())),
                Numbers::Along(along) => alongs.push(along),
            }
        }
        charts.push(("figure-15.svg".into(), along_chart(&alongs)));
        charts.push(("iteration-paths.svg".into(), paths(&runs)));
        Ok(charts)
    }
}

/// Pin and rod along their contact arcs, by a formulation.
#[derive(Clone, Debug)]
pub struct Along {
    /// Contact element and algorithm.
    pub formulation: Formulation,
    /// Whether the run converged.
    pub converged: bool,
    /// Along the candidates of each body.
    pub arcs: Vec<Arc>,
    /// Largest difference of the hoop stress to that of node elements with kinematic load, over the largest hoop
    /// stress.
    pub off: f64,
}

/// A body along its candidates: its name, and angle \[°\] with hoop stress \[MPa\], and with displacement along the
/// outward normal \[mm\].
pub type Arc = (String, [Vec<[f64; 2]>; 2]);

/// A scene whose fields are shown: the case, the factor on its displacements, the largest stress that is told apart
/// over the pressure of the scene, none where all of it is compression, and the part that is enlarged over its length.
pub type Shown = (fn() -> Case, f64, Option<f64>, [[f64; 2]; 2]);

/// The cylinder on its plane, and the pin in the eye of the rod.
pub const SHOWN: [Shown; 2] = [
    (|| Cylinder::default().case(), 1.0, None, [[0.0, 4.0], [-0.4, 3.6]]),
    (|| PinRod::default().case(), 20.0, Some(1.5), [[0.0, 1.3], [-1.3, 0.0]]),
];

/// Stress of a scene under node elements and kinematic load, and what it carries.
#[derive(Clone, Debug)]
pub struct Field {
    /// Name of the scene.
    pub scene: String,
    /// σ_y, or where all is compression −σ_y, on the deformed mesh, the contact enlarged \[MPa\].
    pub stress: drawing::Field,
    /// Load of the scene on the modelled part \[N\].
    pub load: f64,
    /// Vertical force of the recovered stresses on the candidates of each body, by its name, and on the horizontal cut
    /// of the disc, which the flag tells \[N\].
    pub resultants: Vec<(String, bool, f64)>,
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

/// Values are rounded to this fraction of the range, so that round-off cannot move one across the edge of a band.
const GRAIN: f64 = 1e-6;

/// Vertical stress on the deformed mesh, and what the stresses carry.
pub fn field((case, magnification, largest, around): Shown) -> Result<Field, Error> {
    let case = case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let fields = discretisation.recover(&run.solution)?;
    let Discretisation { scene: given, mesh, system, .. } = &discretisation;
    let bodies = || given.bodies.iter().zip(&mesh.bodies);
    let thickness = given.thickness;
    let contact =
        bodies().map(|(body, part)| (body.name.clone(), false, thickness * on_candidates(&mesh.points, part, &fields)));
    let edges = mesh.boundary(given, 0, "cut")?;
    let cut = thickness * edges.iter().map(|edge| on_edge(&mesh.points, edge, &fields)).sum::<f64>();
    let cut = (given.bodies[0].name.clone(), true, cut.abs());
    let (pressure, length) = (given.reference.pressure, given.reference.length);
    let grain = GRAIN * 2.0 * pressure;
    let [x, y] = around.map(|[from, to]| (from * length, to * length));
    let pairs = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| (x, y)).collect();
    let sign = if largest.is_some() { 1.0 } else { -1.0 };
    let values: Vec<f64> = fields.stress.iter().map(|stress| (sign * stress[1] / grain).round() * grain).collect();
    let [tension, most] = [-1.0, 1.0].map(|sign: f64| values.iter().map(|value| sign * value).fold(0.0, f64::max));
    let (quantity, map, range, note) = match largest {
        Some(largest) => ("σ_y [MPa]", ColourMap::Diverging, (-largest * pressure, largest * pressure), None),
        None => {
            let note = format!("Tension, at most {} MPa, has the first colour.", significant(tension, 2));
            ("−σ_y [MPa]", ColourMap::Sequential, (0.0, most), (tension > 0.0).then_some(note))
        }
    };
    let stress = drawing::Field {
        title: format!("{}: vertical stress on the deformed mesh", case.name),
        quantity: quantity.into(),
        points: pairs(&mesh.points),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        shapes,
        values,
        displacements: pairs(&fields.displacement),
        magnification,
        map,
        range: Some(range),
        details: vec![Detail::of(Window { x, y }, magnification)],
        marks: marks(&discretisation)?,
        notes: note.into_iter().collect(),
    };
    let load = system.bodies.iter().map(|body| body.applied_vertical().abs()).sum();
    Ok(Field { scene: case.name, stress, load, resultants: contact.chain([cut]).collect() })
}

/// Pin and rod along their contact arcs.
pub fn along(formulation: &Formulation) -> Result<Along, Error> {
    let case = PinRod::default().case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let by = |formulation: &Formulation| -> Result<_, Error> {
        let run = Run::of(&discretisation, formulation)?;
        let fields = discretisation.recover(&run.solution)?;
        let bodies = discretisation.scene.bodies.iter().zip(&discretisation.mesh.bodies);
        let arcs: Vec<Arc> = bodies.map(|(body, part)| arc(&body.name, part, &fields)).collect();
        Ok((run.solution.converged(), arcs))
    };
    let ((converged, arcs), (_, other)) = (by(formulation)?, by(&Formulation::verification())?);
    let hoop =
        |arcs: &[Arc]| arcs.iter().flat_map(|(_, [hoop, _])| hoop).map(|[_, stress]| *stress).collect::<Vec<f64>>();
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
    (body.into(), [along(&hoop), along(&normal)])
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

/// Difference of hoop stresses that is accepted.
const HOOP: f64 = 0.03;

/// What the paper says of its Figs 14 and 15: a reasonable agreement of the different solutions.
fn agrees(along: &Along) -> Judged {
    Check::error(
        "hoop stress along pin and rod, largest difference over the largest",
        Reference::own("node elements with kinematic load", 0.0),
        HOOP,
        "elements weight the last of the contact differently, and the stress at its edge bends sharply",
    )
    .judge(along.off)
}

/// The vertical resultant of the recovered stresses is the load.
fn carries(field: &Field, (body, on_cut, force): &(String, bool, f64)) -> Judged {
    let (name, tolerance, because) = match on_cut {
        false => (
            "force of the recovered stresses on the contact [N]",
            1e-2,
            "trapezoids between nodes, nodal means of the cells; the edge of the contact lies inside an element",
        ),
        true => {
            ("force of the recovered stresses on the cut [N]", 5e-3, "nodal means of the cells, which are coarse there")
        }
    };
    let load = Reference::own("load", field.load);
    Check::near(Quantity::at(name, body.clone()), load, tolerance, because).judge(*force)
}

/// Hoop stress and normal displacement along the arcs of pin and rod, by every formulation.
fn along_chart(alongs: &[&Along]) -> Drawing {
    let chart = |body: usize, which: usize, quantity: &str, axis: &str| {
        let name = alongs.first().map_or("", |along| &along.arcs[body].0);
        let angle = Axis::linear("θ from the load line [°]").over(0.0, PinRod::default().stretch.to_degrees());
        let mut chart = Chart::new(&format!("{name}: {quantity}"), angle, Axis::linear(axis));
        chart.series.extend(alongs.iter().filter(|along| along.converged).map(|along| {
            let style = Style { marker: Marker::Absent, ..style(&along.formulation) };
            Series::new(label(&along.formulation), along.arcs[body].1[which].iter().copied(), style)
        }));
        chart.notes.push(WITHOUT_GAERTNER.into());
        chart
    };
    let of_body = |body: usize| {
        [chart(body, 0, "hoop stress", "σ_θθ [MPa]"), chart(body, 1, "normal displacement", "u_n, outward [mm]")]
    };
    let bodies = alongs.iter().map(|along| along.arcs.len()).min().unwrap_or(0);
    let charts: Vec<Chart> = (0..bodies).flat_map(of_body).collect();
    panels("Fig. 15: pin and rod along their contact arcs", &charts, 2)
}

/// Iterations that have their numbers: later ones lie too near to one another.
const NUMBERED: usize = 4;

/// The way of each iteration to the solution of two bars closing a gap, in the plane of approach and pressure of their
/// contact.
fn paths(runs: &[&Run]) -> Drawing {
    let bars = bars();
    let (push, stiffness) = (bars.push * bars.gap, bars.young / (2.0 * bars.length));
    let on_bodies = |approach: f64| (approach, stiffness * (push - approach));
    let states = || runs.iter().flat_map(|run| &run.solution.history).map(|iteration| iteration.first_point);
    let width = 1.15 * states().map(|[approach, ..]| approach).fold(bars.gap, f64::max);
    let height = 1.25 * states().map(|[_, pressure, _]| pressure).fold(on_bodies(bars.gap).1, f64::max);
    let chart = |run: &&Run| {
        let title = format!("{}, {} iterations", run.formulation.algorithm.name(), run.solution.work.iterations);
        let [x, y] = [("approach w [mm]", width), ("spring force p [MPa]", height)]
            .map(|(label, end)| Axis::linear(label).over(0.0, end));
        let mut chart = Chart::new(&title, x, y);
        let states: Vec<State> = run.solution.history.iter().map(|iteration| iteration.first_point).collect();
        let places = || states.iter().map(|[approach, pressure, _]| (*approach, *pressure));
        let springs = states.iter().flat_map(|state| {
            let relaxed = if state[2] > 0.0 { state[0] - state[1] / state[2] } else { 0.0 };
            [(relaxed.max(0.0), on_spring(state, relaxed.max(0.0))), (state[0], state[1]), (f64::NAN, f64::NAN)]
        });
        let line = |colour, dash| Style::run(colour, dash, Marker::Absent);
        chart.series = vec![
            Series::new("spring of an iteration", springs, line(palette::GREY, Dash::Solid)),
            Series::new("elastic bodies", [0.0, width].map(on_bodies), Style::reference()),
            Series::new("path", walk(&states), line(palette::NODE, style(&run.formulation).dash)),
            Series::new("iteration", places(), Style::run(palette::NODE, Dash::Absent, Marker::Circle)),
            Series::new("solution", [on_bodies(bars.gap)], Style::run(palette::INK, Dash::Absent, Marker::Diamond)),
        ];
        chart.guides.push(Guide { direction: Direction::Vertical, at: bars.gap, label: "closed".into() });
        let numbered = places().take(NUMBERED).enumerate().map(|(k, at)| (at, (k + 1).to_string()));
        chart.remarks = numbered.map(|(at, text)| Remark { at, text, ring: None, colour: palette::NODE }).collect();
        chart
    };
    panels(
        "The path of the iterations: two bars closing a gap",
        &runs.iter().map(chart).collect::<Vec<_>>(),
        runs.len(),
    )
}

/// Approach, pressure, and stiffness of the spring that holds it.
type State = [f64; 3];

/// Pressure on the spring of a state at an approach.
fn on_spring([approach, pressure, stiffness]: &State, at: f64) -> f64 {
    pressure + stiffness * (at - approach)
}

/// The states joined over the corners between them: first its spring changes at a fixed approach, then it returns to
/// equilibrium along that.
pub fn walk(states: &[State]) -> Vec<(f64, f64)> {
    let first = states.first().map(|state| (state[0], state[1]));
    let more = states.windows(2).flat_map(|two| [(two[0][0], on_spring(&two[1], two[0][0])), (two[1][0], two[1][1])]);
    first.into_iter().chain(more).collect()
}
