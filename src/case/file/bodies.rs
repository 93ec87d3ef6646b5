//! `[[body]]`: outline, material, supports and loads.

use crate::case::file::blocks::BLOCK;
use crate::case::file::form::Form::{Flag, List, Number, OneOf, Table, Text, Word};
use crate::case::file::form::{Form, PAIR, may, must};
use crate::case::file::loads::LOAD;
use crate::case::file::named::{PLACE, component, place, same_place};
use crate::case::file::value::Value;
use crate::case::file::{blocks, loads, mesh_file};
use crate::error::Error;
use crate::scene::{Body, Circle, Face, Material, PlaneHypothesis, Sector, Shape, Support};

/// `[[body]]`.
pub(super) const BODY: Form = Table(&[
    must("name", Text).told("in messages, results and checks"),
    must("young", Number).told("Young's modulus"),
    must("poisson", Number).told("Poisson's ratio: above -1, below 1/2 but in plane stress"),
    must("shape", SHAPE).told("its outline, blocks, or cells of a mesh file"),
    may("density", Number).told("its candidate elements over those of the mesh; 1 by default"),
    may("supports", List(&SUPPORT)).told("what is fixed, or displaced by a value"),
    may("loads", List(&LOAD)).told("what acts on it"),
]);

/// `{ at = "left", component = "x", value = 0.0 }`: no displacement where `value` is left out.
const SUPPORT: Form = Table(&[must("at", PLACE), must("component", Word(|| vec!["x", "y"])), may("value", Number)]);

const SHAPE: Form = OneOf(&[
    // Axis-parallel, with its side `contact`: bottom or top.
    ("rectangle", Table(&[must("x", PAIR), must("y", PAIR), must("contact", Text)])),
    // Its lower right quarter, or the lower half where the contact has both sides; `half` is the right half, `whole`
    // all of it.
    (
        "disc",
        Table(&[
            must("centre", PAIR),
            must("radius", Number),
            may("half", Flag),
            may("whole", Flag),
            may("contact", Text),
        ]),
    ),
    // From the downward vertical over an angle `sweep` [°], counter-clockwise, or to either side where the contact has
    // both; `contact` is inner or outer.
    (
        "ring",
        Table(&[
            must("centre", PAIR),
            must("inner", Number),
            must("outer", Number),
            must("sweep", Number),
            must("contact", Text),
        ]),
    ),
    ("blocks", List(&BLOCK)),
    // A group of cells of a mesh, and the group of sides that carries the contact.
    (mesh_file::SHAPES[0], MESH),
    (mesh_file::SHAPES[1], MESH),
]);

const MESH: Form = Table(&[must("file", Text), must("group", Text), must("contact", Text)]);

/// A body with its supports and loads, in a contact on one side of x = 0 or across it.
pub fn body(plane: PlaneHypothesis, across: bool, table: Value) -> Result<Body, Error> {
    let shape = shape(plane, across, table.at("shape"))?;
    let [supports, loads] = ["supports", "loads"].map(|key| table.list(key));
    refuse_fixed_twice(&shape, &supports, &loads)?;
    let material = material(plane, table)?;
    Ok(Body {
        name: table.at("name").text().into(),
        material,
        density: density(table)?,
        supports: supports.into_iter().map(|table| support(&shape, table)).collect::<Result<_, _>>()?,
        loads: loads
            .into_iter()
            .map(|table| loads::load((plane, material), &shape, table))
            .collect::<Result<_, _>>()?,
        shape,
    })
}

/// Refuses two bodies of one name.
pub fn refuse_equal_names(bodies: &[Value]) -> Result<(), Error> {
    let names: Vec<Value> = bodies.iter().map(|body| body.at("name")).collect();
    match (0..names.len()).find(|&k| names[..k].iter().any(|other| other.text() == names[k].text())) {
        Some(k) => {
            let message = format!("a second body is called `{}`", names[k].text());
            Err(names[k].refused(message, "give every body a name of its own"))
        }
        None => Ok(()),
    }
}

/// Refuses a component that is prescribed twice at one place, or prescribed and loaded as a rigid face.
fn refuse_fixed_twice(shape: &Shape, supports: &[Value], loads: &[Value]) -> Result<(), Error> {
    let is_same = |one: Value, other: Value| {
        one.at("component").text() == other.at("component").text() && same_place(shape, one.at("at"), other.at("at"))
    };
    for (k, support) in supports.iter().enumerate() {
        if supports[..k].iter().any(|other| is_same(*other, *support)) {
            return Err(support.at("at").refused("this component is already fixed there", "leave one of them out"));
        }
        if loads.iter().filter_map(|load| load.get("rigid-face")).any(|face| is_same(face, *support)) {
            let remedy = "leave out the support or the force: a rigid face moves under its force";
            return Err(support.at("at").refused("the face is fixed and loaded as rigid", remedy));
        }
    }
    Ok(())
}

fn material(plane: PlaneHypothesis, table: Value) -> Result<Material, Error> {
    let expected = format!("a ratio {}", plane.poisson_range());
    let poisson = table.at("poisson").within(&expected, |nu| plane.takes(nu))?;
    Ok(Material { young: table.units.stress * table.at("young").positive()?, poisson })
}

fn density(table: Value) -> Result<f64, Error> {
    let expected = "a number from 0.05 to 20: elements of this body over those of the mesh, not mass";
    table.get("density").map_or(Ok(1.0), |density| density.within(expected, |x| (0.05..=20.0).contains(&x)))
}

fn support(shape: &Shape, table: Value) -> Result<Support, Error> {
    let at = place(shape, table.at("at"))?;
    let value = table.get("value").map_or(Ok(0.0), Value::finite)?;
    Ok(Support { at, component: component(table.at("component"))?, value: table.units.length * value })
}

fn shape(plane: PlaneHypothesis, across: bool, given: Value) -> Result<Shape, Error> {
    let (name, table) = given.only();
    match name {
        "rectangle" => rectangle(given, table),
        "disc" => disc(plane, across, table),
        "ring" => ring(across, table),
        "blocks" => blocks::shape(given, table),
        name if mesh_file::SHAPES.contains(&name) => mesh_file::shape(plane.is_of_revolution(), table),
        _ => table.unknown(),
    }
}

/// The sides of a rectangle and of a disc that may carry the contact.
const FACES: [(&str, Face); 2] = [("bottom", Face::Bottom), ("top", Face::Top)];

fn rectangle(given: Value, table: Value) -> Result<Shape, Error> {
    let (x, y) = (table.at("x").point()?, table.at("y").point()?);
    let is_empty = x[0] >= x[1] || y[0] >= y[1];
    given.refuse_if(is_empty, "the rectangle has no area", "give `x` and `y` as [smaller, larger]")?;
    Ok(Shape::Rectangle { x, y, contact: table.at("contact").choice("side of a rectangle", &FACES)? })
}

/// A disc, in a contact on one side of x = 0 or across it.
fn disc(plane: PlaneHypothesis, across: bool, table: Value) -> Result<Shape, Error> {
    Ok(Shape::Disc {
        centre: table.at("centre").point()?,
        radius: table.at("radius").length()?,
        sector: sector(plane, across, table)?,
        contact: table.get("contact").map_or(Ok(Face::Bottom), |side| side.choice("side of a disc", &FACES))?,
    })
}

/// The part of a disc that is modelled: one side of x = 0, or both.
fn sector(plane: PlaneHypothesis, across: bool, table: Value) -> Result<Sector, Error> {
    match (across, table.asked("half"), table.asked("whole")) {
        (_, Some(_), Some(whole)) => Err(whole.refused("the disc is `half` and `whole`", "leave one of them out")),
        (true, Some(half), None) => {
            let remedy = "leave `half` out for the lower half, or give `whole = true`; or leave out `both-sides`";
            Err(half.refused("the right half of a disc touches on one side of x = 0 only", remedy))
        }
        (false, None, Some(whole)) if plane.is_of_revolution() => {
            let message = "a whole disc goes on beyond the axis, on which its contact begins";
            Err(whole.refused(message, "give `half = true`: its right half makes the whole sphere"))
        }
        (false, None, Some(whole)) => {
            let remedy = "add `both-sides = true` to [contact], or give `half = true` for its right half";
            Err(whole.refused("a whole disc touches on both sides of x = 0", remedy))
        }
        (false, None, None) => Ok(Sector::Quarter),
        (false, Some(_), None) => Ok(Sector::RightHalf),
        (true, None, None) => Ok(Sector::LowerHalf),
        (true, None, Some(_)) => Ok(Sector::Whole),
    }
}

fn ring(across: bool, table: Value) -> Result<Shape, Error> {
    let centre = table.at("centre").point()?;
    let inner = table.at("inner").positive()?;
    let outer = table.at("outer").within(&format!("a radius above {inner}"), |outer| outer > inner)?;
    let circle = |radius: f64| Circle { centre, radius: table.units.length * radius };
    let faces = [("inner", Face::Bottom), ("outer", Face::Top)];
    let sweep = table.at("sweep").within("an angle from 1 to 180", |x| (1.0..=180.0).contains(&x))?;
    Ok(Shape::Ring {
        pole: centre,
        inner: circle(inner),
        outer: circle(outer),
        sweep: sweep.to_radians(),
        both_sides: across,
        contact: table.at("contact").choice("side of a ring", &faces)?,
    })
}
