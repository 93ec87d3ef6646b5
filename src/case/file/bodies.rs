//! Bodies from their tables.

use std::sync::Arc;

use toml::Spanned;

use crate::case::file::tables::{
    BodyTable, Keyed, LawTable, LoadTable, PlaceTable, RingTable, ShapeTable, SupportTable, TractionTable,
};
use crate::case::file::units::Units;
use crate::case::file::{Source, blocks, disc, gmsh};
use crate::error::Error;
use crate::scene::{
    Body, BoundaryName, Circle, Component, Face, Load, Material, Place, PlaneHypothesis, Shape, StressField, Support,
    TractionField,
};

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
    let loads = table.loads.iter().map(|load| self::load(source, units, &shape, load));
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
        let tied = |load: &LoadTable| match load {
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
fn boundary(source: Source, units: &Units, shape: &Shape, name: &Spanned<String>) -> Result<BoundaryName, Error> {
    disc::refuse_axis(source, units, shape, name)?;
    let boundaries = shape.boundaries();
    let known: Vec<_> = boundaries.iter().enumerate().map(|(k, name)| (name.as_ref(), k)).collect();
    Ok(boundaries[source.choice("boundary", name, &known)?].clone())
}

/// Refuses a pressure on a line inside the body, which has no outer side.
fn refuse_inside(source: Source, shape: &Shape, name: &Spanned<String>) -> Result<(), Error> {
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

fn support(source: Source, units: &Units, shape: &Shape, table: &SupportTable) -> Result<Support, Error> {
    let at = place(source, units, shape, &table.at)?;
    let value = table.value.as_ref().map_or(Ok(0.0), |value| source.finite("value", value))?;
    Ok(Support { at, component: component(source, &table.component)?, value: units.length * value })
}

fn load(source: Source, units: &Units, shape: &Shape, table: &LoadTable) -> Result<Load, Error> {
    Ok(match table {
        LoadTable::Traction(table) => traction(source, units, shape, table)?,
        LoadTable::Pressure(table) => {
            refuse_inside(source, shape, &table.at)?;
            Load::Stress {
                boundary: boundary(source, units, shape, &table.at)?,
                field: pressure(source, units, &table.law)?,
            }
        }
        LoadTable::Hertz(table) => {
            refuse_inside(source, shape, &table.at)?;
            Load::Stress { boundary: boundary(source, units, shape, &table.at)?, field: table.field(source, units)? }
        }
        LoadTable::BodyForce(pair) => {
            let density = units.force / units.length.powi(3);
            Load::BodyForce(source.pair("body-force", pair)?.map(|f| density * f))
        }
        LoadTable::Force(table) => Load::Force {
            at: source.pair("at", &table.at)?.map(|x| units.length * x),
            force: source.pair("value", &table.value)?.map(|f| units.force * f),
        },
        LoadTable::RigidFace(table) => Load::RigidFace {
            boundary: boundary(source, units, shape, &table.at)?,
            component: component(source, &table.component)?,
            force: units.force * source.finite("force", &table.force)?,
        },
    })
}

/// Most coefficients of a law.
const MOST_TERMS: usize = 16;

/// A traction: the same everywhere, or each component by its law.
fn traction(source: Source, units: &Units, shape: &Shape, table: &TractionTable) -> Result<Load, Error> {
    let boundary = boundary(source, units, shape, &table.at)?;
    match (&table.value, &table.x, &table.y) {
        (Some(pair), None, None) => {
            Ok(Load::Traction { boundary, traction: source.pair("value", pair)?.map(|t| units.stress * t) })
        }
        (None, None, None) | (Some(_), ..) => {
            let remedy = "give `value = [tx, ty]`, or a law for `x`, `y` or both";
            Err(source.refused(table.at.span(), "the traction has no value, or two", remedy))
        }
        (None, x, y) => {
            let component = |given: &Option<Spanned<LawTable>>| {
                given.as_ref().map_or_else(|| Ok(Box::new(|_: [f64; 2]| 0.0) as Law), |given| law(source, units, given))
            };
            let (x, y) = (component(x)?, component(y)?);
            Ok(Load::TractionField { boundary, field: TractionField(Arc::new(move |point| [x(point), y(point)])) })
        }
    }
}

/// The stress `σ = −p I`, whose traction on any side is the pressure.
fn pressure(source: Source, units: &Units, given: &Spanned<LawTable>) -> Result<StressField, Error> {
    let at = law(source, units, given)?;
    Ok(StressField(Arc::new(move |point| {
        let p = at(point);
        [-p, -p, 0.0]
    })))
}

/// A stress as a function of the place \[MPa\].
type Law = Box<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

/// Uniform, a polynomial in a coordinate, or a cosine series in the angle.
fn law(source: Source, units: &Units, law: &Spanned<LawTable>) -> Result<Law, Error> {
    let list = |given: &[Spanned<f64>], per: f64| -> Result<Vec<f64>, Error> {
        if given.is_empty() || given.len() > MOST_TERMS {
            let message = format!("the law has {} coefficients", given.len());
            return Err(source.refused(law.span(), message, format!("give 1 to {MOST_TERMS}")));
        }
        let each = given
            .iter()
            .enumerate()
            .map(|(k, value)| Ok(units.stress * source.finite("coefficients", value)? / per.powi(k as i32)));
        each.collect()
    };
    Ok(match law.get_ref() {
        LawTable::Uniform(value) => {
            let value = units.stress * source.finite("uniform", value)?;
            Box::new(move |_| value)
        }
        LawTable::Polynomial(table) => {
            let k = component(source, &table.along)?.index();
            let coefficients = list(&table.coefficients, units.length)?;
            Box::new(move |point| coefficients.iter().rev().fold(0.0, |sum, c| c + sum * point[k]))
        }
        LawTable::Cosine(table) => {
            let [x, y] = source.pair("centre", &table.centre)?.map(|x| units.length * x);
            let coefficients = list(&table.coefficients, 1.0)?;
            Box::new(move |point| {
                let angle = (point[0] - x).atan2(y - point[1]);
                coefficients.iter().zip(0..).map(|(c, k)| c * (f64::from(k) * angle).cos()).sum()
            })
        }
    })
}
