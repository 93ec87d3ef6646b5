//! The axis of bodies of revolution, x = 0 or y = 0: which nodes lie on it, and what cannot be there.
//!
//! A point on the axis stays on it, `u_r = 0`: of all that a support along the radius could do there, this is the only
//! thing, and it holds without one.

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Action, Component, Load, Place, Scene};

/// Distance from the axis, over the largest radius of the body, up to which a node lies on it.
const ON_AXIS: f64 = 1e-9;

/// Which nodes of a body lie on the axis, by their number in the mesh; none of a plane scene.
pub fn holds<'a>(scene: &Scene, mesh: &'a Mesh, body: usize) -> impl Fn(usize) -> bool + 'a {
    let near = match scene.is_of_revolution() {
        true => ON_AXIS * largest_radius(scene, mesh, body),
        false => f64::NEG_INFINITY,
    };
    let radial = radial(scene).index();
    move |node| mesh.points[node][radial] <= near
}

/// The component along the radius of bodies of revolution.
pub fn radial(scene: &Scene) -> Component {
    if scene.plane.radial() == Some(1) { Component::Y } else { Component::X }
}

fn largest_radius(scene: &Scene, mesh: &Mesh, body: usize) -> f64 {
    let radial = radial(scene).index();
    mesh.bodies[body].nodes.clone().map(|node| mesh.points[node][radial].abs()).fold(0.0, f64::max)
}

/// Refuses a body of revolution that goes on beyond the axis, that a support moves off it, or whose loads have a sum
/// that vanishes all around or act where there is no area.
pub fn refuse(scene: &Scene, mesh: &Mesh, body: usize) -> Result<(), Error> {
    if !scene.is_of_revolution() {
        return Ok(());
    }
    let place = || scene.place_of_body(body);
    let radial = radial(scene);
    let radii = mesh.bodies[body].nodes.clone().map(|node| mesh.points[node][radial.index()]);
    let least = radii.fold(f64::INFINITY, f64::min);
    if least.is_nan() || least < -ON_AXIS * largest_radius(scene, mesh, body) {
        let expected = format!("a body of revolution lies at radii {radial} ≥ 0, on one side of its axis {radial} = 0");
        let remedy = format!("model the half of its section that lies at {radial} ≥ 0");
        return Err(Error::value(place(), &format!("least {radial}"), least, expected, remedy));
    }
    let on_axis = holds(scene, mesh, body);
    for support in &scene.bodies[body].supports {
        let moves = support.component == radial && support.value.abs() > 0.0;
        if moves && mesh.nodes_at(scene, body, &support.at)?.into_iter().any(&on_axis) {
            let expected = format!("`{}` touches the axis, and a point on the axis stays there", support.at);
            let remedy = "give 0, or leave the support out: the axis holds by itself";
            return Err(Error::value(place(), &format!("support along {radial}"), support.value, expected, remedy));
        }
    }
    for (index, load) in scene.bodies[body].loads.iter().enumerate() {
        let refused = |message: &str, remedy: &str| Err(Error::at(scene.place_of_load(body, index), message, remedy));
        let cancels = "radial forces add up to nothing around a body of revolution";
        let pressure = format!("give a traction or a pressure in MPa, or leave the component along {radial} at 0");
        match load {
            Load::OnSide { action: Action::Moment(_), .. } => {
                let message = "a moment has no meaning on a body of revolution, whose loads are the same all around";
                return refused(message, "leave it out, or give a pressure that depends on the place");
            }
            Load::OnSide { action: Action::Total(force), .. } | Load::Force { force, .. }
                if force[radial.index()].abs() > 0.0 =>
            {
                return refused(cancels, &pressure);
            }
            Load::RigidFace { component, .. } if *component == radial => return refused(cancels, &pressure),
            _ => {}
        }
        let (Load::OnSide { boundary, .. } | Load::RigidFace { boundary, .. }) = load else { continue };
        if mesh.nodes_at(scene, body, &Place::Boundary(boundary.clone()))?.into_iter().all(&on_axis) {
            let message = format!("`{boundary}` lies on the axis of revolution, where a side has no area");
            return refused(&message, "load another side");
        }
    }
    Ok(())
}
