//! How formulations are drawn everywhere: colour = element, dash = algorithm; what holds and loads a scene, as marks on
//! its field; and what a page's picture is called.

use crate::algorithm::Acceleration;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Drawing, Mark};
use crate::elasticity::loads;
use crate::error::Error;
use crate::mesh::Candidate;
use crate::scene::{Component, Load, Place, Support};
use crate::solve::{Discretisation, Formulation, Iteration, Settings};

/// The SVG of a figure.
pub fn svg(figure: &Drawing) -> Result<String, Error> {
    figure.clone().map_err(|drawing::Error { figure, reason, remedy }| {
        Error::at(format!("figure `{figure}`").as_str(), reason, remedy)
    })
}

/// Files of figures by their names.
pub fn written(figures: &[(String, Drawing)]) -> Result<Vec<(String, String)>, Error> {
    figures.iter().map(|(name, figure)| Ok((name.clone(), svg(figure)?))).collect()
}

/// Colour = element, dash = algorithm.
pub fn style(formulation: &Formulation) -> Style {
    let colour = palette::CURVES[formulation.element as usize % palette::CURVES.len()];
    let (dash, marker) = match formulation.algorithm {
        Iteration::Varying => (Dash::Solid, Marker::Circle),
        Iteration::Constant => (Dash::Dashed, Marker::Square),
        Iteration::Kinematic => (Dash::Dotted, Marker::Diamond),
    };
    Style::run(colour, dash, marker)
}

/// Label of a formulation in legends, with its acceleration.
pub fn label(formulation: &Formulation) -> String {
    let Formulation { element, algorithm, acceleration, .. } = formulation;
    let added = if *acceleration == Acceleration::None { String::new() } else { format!(" + {}", acceleration.name()) };
    format!("{} · {}{added}", element.name(), algorithm.name())
}

/// What the paper's Figs 14 and 15 have besides.
pub const WITHOUT_GAERTNER: &str =
    "The paper's figure has curves of Gaertner (1977) beside its own; none are drawn here.";

/// Supports, loads and rigid sides of a discretised scene, for its field.
pub fn marks(discretisation: &Discretisation) -> Result<Vec<Mark>, Error> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let mut marks = Vec::new();
    let along = |component: Component, sign: f64| if component.index() == 0 { (sign, 0.0) } else { (0.0, sign) };
    for (index, (body, part)) in scene.bodies.iter().zip(&mesh.bodies).enumerate() {
        let count = part.nodes.len() as f64;
        let middle = [0, 1].map(|k| part.nodes.clone().map(|node| mesh.points[node][k]).sum::<f64>() / count);
        for Support { at, component, value } in &body.supports {
            let k = component.index();
            for node in mesh.nodes_at(scene, index, at)? {
                let side = if mesh.points[node][k] < middle[k] { -1.0 } else { 1.0 };
                marks.push(match value.abs() > 0.0 {
                    true => Mark::Pushed(node, along(*component, value.signum())),
                    false => Mark::Fixed(node, along(*component, side)),
                });
            }
        }
        let forces = loads::at_nodes(scene, mesh, index)?;
        let sizes = || forces.iter().map(|[x, y]| x.hypot(*y));
        let largest = sizes().fold(0.0, f64::max);
        let unit = |[x, y]: [f64; 2]| (x / x.hypot(y), y / x.hypot(y));
        let loaded = forces.iter().zip(part.nodes.clone()).filter(|([x, y], _)| x.hypot(*y) > LEAST * largest);
        let loaded: Vec<Mark> = loaded.map(|(force, node)| Mark::Pushed(node, unit(*force))).collect();
        // What acts in the volume acts everywhere: its middle says as much.
        let nearest = part.nodes.clone().min_by(|a, b| {
            let [a, b] = [a, b].map(|node| [0, 1].map(|k| mesh.points[*node][k] - middle[k])).map(|[x, y]| x.hypot(y));
            a.total_cmp(&b)
        });
        let total = [0, 1].map(|k| forces.iter().map(|force| force[k]).sum::<f64>());
        match nearest.filter(|_| loaded.len() > forces.len() / 2) {
            Some(node) => marks.push(Mark::Pushed(node, unit(total))),
            None => marks.extend(loaded),
        }
        for load in &body.loads {
            if let Load::RigidFace { boundary, component, force } = load {
                let along = along(*component, force.signum());
                let nodes = mesh.nodes_at(scene, index, &Place::Boundary(boundary.clone()))?;
                marks.extend(nodes.into_iter().map(|node| Mark::Pushed(node, along)));
            }
        }
    }
    for (contact, pair) in scene.contacts.iter().enumerate().filter(|(_, pair)| pair.second.is_none()) {
        let part = &mesh.bodies[pair.first];
        let own = part.candidates[part.candidates_of(contact)].iter().filter(|at| pair.gap(at.coordinate).is_finite());
        let across = |at: &Candidate| {
            let ([x, y], [nx, ny], gap) =
                (mesh.points[at.node], pair.normal(mesh.points[at.node]), pair.gap(at.coordinate));
            [(x + gap * nx, y + gap * ny), (nx, ny)]
        };
        marks.push(Mark::Rigid(own.map(across).collect()));
    }
    Ok(marks)
}

/// Nodal forces below this part of the largest are round-off.
const LEAST: f64 = 1e-9;

/// A picture of the page, with its caption below.
pub fn picture(file: &str, caption: &str) -> String {
    let attribute = caption.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
    format!("<img alt=\"{attribute}\" src=\"snapshots/charts/{file}\">\n\n*{caption}.*\n\n")
}

/// What is to be known beside a picture of all nine formulations: what their agreement cannot show.
pub fn how_stopped() -> String {
    format!(
        "Each run stops once it is within {:e} of the solution of the discrete problem, which an active set has found \
        before: what differs here is due to element and mesh.",
        Settings::default().tolerance
    )
}
