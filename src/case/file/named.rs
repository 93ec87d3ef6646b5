//! Boundaries, points and components by the names that a file gives them.

use toml::Spanned;

use crate::case::file::tables::PlaceTable;
use crate::case::file::units::Units;
use crate::case::file::{Source, disc};
use crate::error::Error;
use crate::scene::{BoundaryName, Component, Place, Shape};

/// A component by its name.
pub(super) fn component(source: Source, name: &Spanned<String>) -> Result<Component, Error> {
    source.choice("component", name, &[("x", Component::X), ("y", Component::Y)])
}

/// A boundary that the shape has, or a point.
pub(super) fn place(source: Source, units: &Units, shape: &Shape, at: &Spanned<PlaceTable>) -> Result<Place, Error> {
    let span = at.span();
    Ok(match at.get_ref() {
        PlaceTable::Boundary(name) => {
            Place::Boundary(boundary(source, units, shape, &Spanned::new(span, name.clone()))?)
        }
        PlaceTable::Point(point) => {
            let list = point.iter().map(|x| Spanned::new(span.clone(), *x)).collect();
            Place::Point(source.pair("at", &Spanned::new(span, list))?.map(|x| units.length * x))
        }
    })
}

/// A boundary that the shape has.
pub(super) fn boundary(
    source: Source,
    units: &Units,
    shape: &Shape,
    name: &Spanned<String>,
) -> Result<BoundaryName, Error> {
    disc::refuse_axis(source, units, shape, name)?;
    let boundaries = shape.boundaries();
    let known: Vec<_> = boundaries.iter().enumerate().map(|(k, name)| (name.as_ref(), k)).collect();
    Ok(boundaries[source.choice("boundary", name, &known)?].clone())
}

/// Refuses a pressure on a line inside the body, which has no outer side.
pub(super) fn refuse_inside(source: Source, shape: &Shape, name: &Spanned<String>) -> Result<(), Error> {
    let inside = match shape {
        Shape::Given(mesh) => mesh.inner.contains(name.get_ref().as_str()),
        Shape::Disc { sector, .. } if sector.has_upper_part() => name.get_ref() == "middle",
        _ => false,
    };
    if !inside {
        return Ok(());
    }
    let message = format!("`{}` runs inside the body, where a pressure has no side to act on", name.get_ref());
    Err(source.refused(name.span(), message, "give a traction there, or a pressure on the outline"))
}
