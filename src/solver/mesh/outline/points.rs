//! Where a body is held or pressed at points, or on parts of its sides: lines of cells lie there.

use crate::mesh::block::Point;
use crate::scene::{Along, Body, Component, Load, Place, Shape, SidePart};

/// Points at which a body is held or [pressed].
pub(super) fn points(body: &Body) -> Vec<Point> {
    let held = body.supports.iter().filter_map(|support| match support.at {
        Place::Point(at) => Some(at),
        Place::Boundary(_) => None,
    });
    held.chain(pressed(body)).collect()
}

/// Points at which a force acts, and on the sides of a rectangle those at which a pressed part begins or ends.
pub(in crate::mesh) fn pressed(body: &Body) -> Vec<Point> {
    let pressed = body.loads.iter().flat_map(|load| match load {
        Load::Force { at, .. } => vec![*at],
        Load::OnSide { boundary, part: Some(part), .. } => ends_of(part, body.shape.lies_at(boundary)),
        _ => vec![],
    });
    pressed.collect()
}

/// Those of them that lie on the lower or upper side of a rectangle, along x.
pub(super) fn above(body: &Body) -> Vec<f64> {
    let Shape::Rectangle { y, .. } = body.shape else { return vec![] };
    points(body).iter().filter(|point| y.contains(&point[1])).map(|point| point[0]).collect()
}

/// Where a part of a side begins and ends, on which one coordinate of the points is always the same.
fn ends_of(part: &SidePart, lies_at: Option<(Component, f64)>) -> Vec<Point> {
    let ends = [part.from, part.to];
    match (part.along, lies_at) {
        (Along::Axis(Component::X), Some((Component::Y, y))) => ends.map(|x| [x, y]).to_vec(),
        (Along::Axis(Component::Y), Some((Component::X, x))) => ends.map(|y| [x, y]).to_vec(),
        _ => vec![],
    }
}
