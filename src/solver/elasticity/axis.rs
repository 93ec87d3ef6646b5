//! The axis of bodies of revolution, x = 0: which nodes lie on it, and what cannot be there.
//!
//! A point on the axis stays on it, `u_r = 0`: of all that a support along x could do there, this is the only thing, and it
//! holds without one.

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Action, Component, Load, Place, Scene};

/// Distance from the axis, over the largest radius of the body, up to which a node lies on it.
const ON_AXIS: f64 = 1e-9;

/// Which nodes of a body lie on the axis, by their number in the mesh; none of a plane scene.
pub fn holds<'a>(scene: &Scene, mesh: &'a Mesh, body: usize) -> impl Fn(usize) -> bool + 'a {
    let near = match scene.is_of_revolution() {
        true => ON_AXIS * largest_radius(mesh, body),
        false => f64::NEG_INFINITY,
    };
    move |node| mesh.points[node][0] <= near
}

fn largest_radius(mesh: &Mesh, body: usize) -> f64 {
    mesh.bodies[body].nodes.clone().map(|node| mesh.points[node][0].abs()).fold(0.0, f64::max)
}

/// Refuses a body of revolution that goes on beyond the axis, that a support moves off it, or whose loads have a sum that
/// vanishes all around or act where there is no area.
pub fn refuse(scene: &Scene, mesh: &Mesh, body: usize) -> Result<(), Error> {
    if !scene.is_of_revolution() {
        return Ok(());
    }
    let place = || scene.place_of_body(body);
    let least = mesh.bodies[body].nodes.clone().map(|node| mesh.points[node][0]).fold(f64::INFINITY, f64::min);
    if least.is_nan() || least < -ON_AXIS * largest_radius(mesh, body) {
        let expected = "a body of revolution lies at radii x ≥ 0, on one side of its axis x = 0";
        let remedy = "model the half of its section that lies at x ≥ 0";
        return Err(Error::value(place(), "least x", least, expected, remedy));
    }
    let on_axis = holds(scene, mesh, body);
    for support in &scene.bodies[body].supports {
        let moves = support.component == Component::X && support.value.abs() > 0.0;
        if moves && mesh.nodes_at(scene, body, &support.at)?.into_iter().any(&on_axis) {
            let expected = format!("`{}` touches the axis, and a point on the axis stays there", support.at);
            let remedy = "give 0, or leave the support out: the axis holds by itself";
            return Err(Error::value(place(), "support along x", support.value, expected, remedy));
        }
    }
    for (index, load) in scene.bodies[body].loads.iter().enumerate() {
        let refused = |message: &str, remedy: &str| Err(Error::at(scene.place_of_load(body, index), message, remedy));
        let radial = "radial forces add up to nothing around a body of revolution";
        let pressure = "give a traction or a pressure in MPa, or leave the component along x at 0";
        match load {
            Load::OnSide { action: Action::Moment(_), .. } => {
                let message = "a moment has no meaning on a body of revolution, whose loads are the same all around";
                return refused(message, "leave it out, or give a pressure that depends on x");
            }
            Load::OnSide { action: Action::Total([x, _]), .. } | Load::Force { force: [x, _], .. } if x.abs() > 0.0 => {
                return refused(radial, pressure);
            }
            Load::RigidFace { component: Component::X, .. } => return refused(radial, pressure),
            _ => {}
        }
        let (Load::Traction { boundary, .. }
        | Load::TractionField { boundary, .. }
        | Load::Stress { boundary, .. }
        | Load::OnSide { boundary, .. }
        | Load::RigidFace { boundary, .. }) = load
        else {
            continue;
        };
        if mesh.nodes_at(scene, body, &Place::Boundary(boundary.clone()))?.into_iter().all(&on_axis) {
            let message = format!("`{boundary}` lies on the axis of revolution, where a side has no area");
            return refused(&message, "load another side");
        }
    }
    Ok(())
}
