//! Discs: how much of one is modelled.

use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::DiscTable;
use crate::case::file::units::Units;
use crate::error::Error;
use crate::scene::{Face, Sector, Shape};

/// A disc, in a contact on one side of x = 0 or across it.
pub(super) fn shape(source: Source, units: &Units, across: bool, table: &DiscTable) -> Result<Shape, Error> {
    Ok(Shape::Disc {
        centre: source.pair("centre", &table.centre)?.map(|x| units.length * x),
        radius: units.length * source.positive("radius", &table.radius)?,
        sector: sector(source, across, table)?,
        contact: match &table.contact {
            Some(side) => source.choice("side of a disc", side, &[("bottom", Face::Bottom), ("top", Face::Top)])?,
            None => Face::Bottom,
        },
    })
}

/// The part of a disc that is modelled: one side of x = 0, or both.
fn sector(source: Source, across: bool, table: &DiscTable) -> Result<Sector, Error> {
    let asked = |given: &Option<Spanned<bool>>| given.as_ref().filter(|given| *given.get_ref()).map(Spanned::span);
    match (across, asked(&table.half), asked(&table.whole)) {
        (_, Some(_), Some(whole)) => {
            Err(source.refused(whole, "the disc is `half` and `whole`", "leave one of them out"))
        }
        (true, Some(half), None) => {
            let remedy = "leave `half` out for the lower half, or give `whole = true`; or leave out `both-sides`";
            Err(source.refused(half, "the right half of a disc touches on one side of x = 0 only", remedy))
        }
        (false, None, Some(whole)) => {
            let remedy = "add `both-sides = true` to [contact], or give `half = true` for its right half";
            Err(source.refused(whole, "a whole disc touches on both sides of x = 0", remedy))
        }
        (false, None, None) => Ok(Sector::Quarter),
        (false, Some(_), None) => Ok(Sector::RightHalf),
        (true, None, None) => Ok(Sector::LowerHalf),
        (true, None, Some(_)) => Ok(Sector::Whole),
    }
}

/// Refuses the axis of a disc on both sides of it, where it is no boundary.
pub(super) fn refuse_axis(source: Source, units: &Units, shape: &Shape, name: &Spanned<String>) -> Result<(), Error> {
    match shape {
        Shape::Disc { sector, centre, .. } if sector.has_both_sides() && name.get_ref() == "axis" => {
            let [x, y] = centre.map(|x| x / units.length);
            let message = "there is no boundary `axis`: with `both-sides` it lies inside the disc";
            let remedy = format!("fix a node, as in {{ at = [{x}, {y}], component = \"x\" }}");
            Err(source.refused(name.span(), message, remedy))
        }
        _ => Ok(()),
    }
}
