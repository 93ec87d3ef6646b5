//! Bodies, boundaries, points, components and supports by the names that a file gives them.

use crate::case::file::form::Form::{Own, Table, Text};
use crate::case::file::form::{Form, PAIR, must};
use crate::case::file::mesh_file;
use crate::case::file::value::Value;
use crate::error::Error;
use crate::measure::Quantity;
use crate::scene::{Body, BoundaryName, Component, Place, Shape};
use crate::solve::Displaced;

/// A boundary's name, or a point.
pub(super) const PLACE: Form = Own(&[Text, PAIR], |value| {
    let is_place = |form: Form| form.check(value).is_ok();
    match is_place(Text) || is_place(PAIR) {
        true => Ok(()),
        false => Err((value.span(), "a place is the name of a boundary or a point [x, y]".into())),
    }
});

/// `{ body = "…", at = "…", component = "…" }`: a support, or a side or point whose displacement is meant.
pub(super) const OF_BODY: Form = Table(&[must("body", Text), must("at", PLACE), must("component", Text)]);

/// Index of the body of a name.
pub(super) fn body(name: Value, bodies: &[Body]) -> Result<usize, Error> {
    let known: Vec<_> = bodies.iter().enumerate().map(|(index, body)| (body.name.as_str(), index)).collect();
    name.choice("body", &known)
}

/// A component by its name.
pub(super) fn component(name: Value) -> Result<Component, Error> {
    name.choice("component", &[("x", Component::X), ("y", Component::Y)])
}

/// A boundary that the shape has, or a point.
pub(super) fn place(shape: &Shape, at: Value) -> Result<Place, Error> {
    match at.word() {
        Some(_) => Ok(Place::Boundary(boundary(shape, at)?)),
        None => Ok(Place::Point(at.point()?)),
    }
}

/// Whether two places of a shape are the same.
pub(super) fn same_place(shape: &Shape, a: Value, b: Value) -> bool {
    place(shape, a).is_ok_and(|a| place(shape, b).is_ok_and(|b| a == b))
}

/// The coordinates of a point as they are written.
fn numbers(at: Value) -> Vec<f64> {
    at.entries().into_iter().map(Value::number).collect()
}

/// A boundary that the shape has.
pub(super) fn boundary(shape: &Shape, name: Value) -> Result<BoundaryName, Error> {
    refuse_axis(shape, name)?;
    if let Shape::Given(mesh) = shape
        && let Some(own) = mesh_file::boundary(mesh, name)?
    {
        return Ok(own);
    }
    let boundaries = shape.boundaries();
    let known: Vec<_> = boundaries.iter().enumerate().map(|(k, name)| (name.as_ref(), k)).collect();
    Ok(boundaries[name.choice("boundary", &known)?].clone())
}

/// Refuses the axis of a disc, or the beginning of a ring, on both sides of it, where it is no boundary.
fn refuse_axis(shape: &Shape, name: Value) -> Result<(), Error> {
    let (key, body, node) = match shape {
        Shape::Disc { sector, centre, .. } if sector.has_both_sides() => ("axis", "disc", *centre),
        Shape::Ring { both_sides: true, inner, .. } => {
            ("start", "ring", [inner.centre[0], inner.centre[1] - inner.radius])
        }
        _ => return Ok(()),
    };
    if name.text() != key {
        return Ok(());
    }
    let [x, y] = node.map(|x| x / name.units.length);
    let message = format!("there is no boundary `{key}`: with `both-sides` it lies inside the {body}");
    Err(name.refused(message, format!("fix a node, as in {{ at = [{x}, {y}], component = \"x\" }}")))
}

/// A boundary that the shape has, for a pressure: refused is a line inside the body, which has no outer side.
pub(super) fn outer(shape: &Shape, name: Value) -> Result<BoundaryName, Error> {
    let own = boundary(shape, name)?;
    let is_inside = match shape {
        Shape::Given(mesh) => mesh.inner.contains(&own),
        Shape::Disc { sector, .. } if sector.has_upper_part() => own == "middle",
        _ => false,
    };
    let message = format!("`{own}` runs inside the body, where a pressure has no side to act on");
    name.refuse_if(is_inside, message, "give a traction there, or a pressure on the outline")?;
    Ok(own)
}

/// The displacement of a side or a point; what does not exist is told with its line and what there is.
pub(super) fn displaced(of: Value, bodies: &[Body]) -> Result<Displaced, Error> {
    let body = body(of.at("body"), bodies)?;
    let at = place(&bodies[body].shape, of.at("at"))?;
    Ok(Displaced { body, at, component: component(of.at("component"))? })
}

/// The force of a support of a body, as the body lists it among its `supports`; the same is told of what does not
/// exist.
pub(super) fn reaction(of: Value, tables: &[Value], bodies: &[Body]) -> Result<Quantity, Error> {
    let body = body(of.at("body"), bodies)?;
    let supports = tables[body].list("supports");
    let is_it = |support: &Value| {
        same_place(&bodies[body].shape, support.at("at"), of.at("at"))
            && support.at("component").text() == of.at("component").text()
    };
    supports.iter().position(is_it).map(|support| Quantity::Reaction { body, support }).ok_or_else(|| {
        let shown = |support: Value| {
            let at = support.at("at");
            let place = at.word().map_or_else(|| format!("{:?}", numbers(at)), |name| format!("`{name}`"));
            format!("{place} along {}", support.at("component").text())
        };
        let known: Vec<String> = supports.iter().map(|support| shown(*support)).collect();
        let message = format!("`{}` has no support at {}", bodies[body].name, shown(of));
        let remedy = if known.is_empty() { "it has none".into() } else { format!("known: {}", known.join(", ")) };
        of.at("at").refused(message, remedy)
    })
}
