//! Bodies from their tables.

use toml::Spanned;

use crate::case::file::load_keys::LoadTable;
use crate::case::file::named::{component, place};
use crate::case::file::tables::{BodyTable, Keyed, PlaceTable, RingTable, ShapeTable, SupportTable};
use crate::case::file::units::Units;
use crate::case::file::{Source, blocks, disc, gmsh, loads};
use crate::error::Error;
use crate::scene::{Body, Circle, Face, Material, PlaneHypothesis, Shape, Support};

/// A body with its supports and loads, in a contact on one side of x = 0 or across it.
pub fn body(
    source: Source,
    units: &Units,
    plane: PlaneHypothesis,
    across: bool,
    table: &BodyTable,
) -> Result<Body, Error> {
    let shape = shape(source, units, across, &table.shape)?;
    let supports = table.supports.iter().map(|support| self::support(source, units, &shape, support));
    refuse_fixed_twice(source, table)?;
    let loads = table.loads.iter().map(|load| loads::load(source, units, &shape, load));
    Ok(Body {
        name: table.name.get_ref().clone(),
        material: material(source, units, plane, table)?,
        density: density(source, table)?,
        supports: supports.collect::<Result<_, _>>()?,
        loads: loads.collect::<Result<_, _>>()?,
        shape,
    })
}

/// Refuses two bodies of one name.
pub fn refuse_equal_names(source: Source, bodies: &[Keyed<BodyTable>]) -> Result<(), Error> {
    for (k, body) in bodies.iter().enumerate() {
        if bodies[..k].iter().any(|other| other.name.get_ref() == body.name.get_ref()) {
            let message = format!("a second body is called `{}`", body.name.get_ref());
            return Err(source.refused(body.name.span(), message, "give every body a name of its own"));
        }
    }
    Ok(())
}

/// Refuses a component that is prescribed twice at one place, or prescribed and loaded as a rigid face.
fn refuse_fixed_twice(source: Source, table: &BodyTable) -> Result<(), Error> {
    for (k, support) in table.supports.iter().enumerate() {
        let same = |other: &Keyed<SupportTable>| {
            other.component.get_ref() == support.component.get_ref() && other.at.get_ref() == support.at.get_ref()
        };
        if table.supports[..k].iter().any(same) {
            return Err(source.refused(
                support.at.span(),
                "this component is already fixed there",
                "leave one of them out",
            ));
        }
        let tied = |load: &Spanned<LoadTable>| match load.get_ref() {
            LoadTable::RigidFace(face) => {
                let there = PlaceTable::Boundary(face.at.get_ref().clone());
                face.component.get_ref() == support.component.get_ref() && *support.at.get_ref() == there
            }
            _ => false,
        };
        if table.loads.iter().any(tied) {
            let remedy = "leave out the support or the force: a rigid face moves under its force";
            return Err(source.refused(support.at.span(), "the face is fixed and loaded as rigid", remedy));
        }
    }
    Ok(())
}

fn material(source: Source, units: &Units, plane: PlaneHypothesis, table: &BodyTable) -> Result<Material, Error> {
    let expected = format!("a ratio {}", plane.poisson_range());
    let poisson = source.number("poisson", &table.poisson, &expected, |nu| plane.takes(nu))?;
    Ok(Material { young: units.stress * source.positive("young", &table.young)?, poisson })
}

fn density(source: Source, table: &BodyTable) -> Result<f64, Error> {
    let expected = "a number from 0.05 to 20: elements of this body over those of the mesh, not mass";
    let within = |x: f64| (0.05..=20.0).contains(&x);
    table.density.as_ref().map_or(Ok(1.0), |density| source.number("density", density, expected, within))
}

fn shape(source: Source, units: &Units, across: bool, table: &Spanned<ShapeTable>) -> Result<Shape, Error> {
    let span = table.span();
    let length = |pair: [f64; 2]| pair.map(|x| units.length * x);
    Ok(match table.get_ref() {
        ShapeTable::Rectangle(table) => {
            let (x, y) = (length(source.pair("x", &table.x)?), length(source.pair("y", &table.y)?));
            if x[0] >= x[1] || y[0] >= y[1] {
                return Err(source.refused(span, "the rectangle has no area", "give `x` and `y` as [smaller, larger]"));
            }
            let faces = [("bottom", Face::Bottom), ("top", Face::Top)];
            Shape::Rectangle { x, y, contact: source.choice("side of a rectangle", &table.contact, &faces)? }
        }
        ShapeTable::Disc(table) => disc::shape(source, units, across, table)?,
        ShapeTable::Ring(table) => ring(source, units, table)?,
        ShapeTable::Blocks(tables) => blocks::shape(source, units, span, tables)?,
        ShapeTable::Gmsh(table) => gmsh::shape(source, units, table)?,
    })
}

fn ring(source: Source, units: &Units, table: &RingTable) -> Result<Shape, Error> {
    let centre = source.pair("centre", &table.centre)?.map(|x| units.length * x);
    let inner = source.positive("inner", &table.inner)?;
    let outer = source.number("outer", &table.outer, &format!("a radius above {inner}"), |outer| outer > inner)?;
    let circle = |radius: f64| Circle { centre, radius: units.length * radius };
    let faces = [("inner", Face::Bottom), ("outer", Face::Top)];
    let sweep = source.number("sweep", &table.sweep, "an angle from 1 to 180", |x| (1.0..=180.0).contains(&x))?;
    Ok(Shape::Ring {
        pole: centre,
        inner: circle(inner),
        outer: circle(outer),
        sweep: sweep.to_radians(),
        contact: source.choice("side of a ring", &table.contact, &faces)?,
    })
}

fn support(source: Source, units: &Units, shape: &Shape, table: &SupportTable) -> Result<Support, Error> {
    let at = place(source, units, shape, &table.at)?;
    let value = table.value.as_ref().map_or(Ok(0.0), |value| source.finite("value", value))?;
    Ok(Support { at, component: component(source, &table.component)?, value: units.length * value })
}
