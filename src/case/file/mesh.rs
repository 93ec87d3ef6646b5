//! `[mesh]`: elements on a length, or an accuracy that chooses them.

use crate::accuracy::{self, Asked, KINKED, UNKINKED};
use crate::case::file::form::Form::{Byte, Count, List, Number, Table, Text};
use crate::case::file::form::{Form, may};
use crate::case::file::value::Value;
use crate::case::file::wanted::{OF_ACCURACY, QUANTITIES};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Scene, Shape};

/// `[mesh]`: `elements` of the candidate stretch on every length `per`, or an `accuracy`; bodies whose mesh is given
/// need neither.
pub(super) const MESH: Form = Table(&[
    may("elements", Count).told("candidate elements on every length `per`"),
    may("per", Number).told("the length that has so many `elements`"),
    may("order", Byte).told("of the cells: 1 of 4 nodes, 2 of 8 nodes, 4 to 8"),
    may("growth", GROWTH).told("ratios of neighbouring elements away from the contact"),
    may("accuracy", Text).told("relative error of peak and half-width that chooses the mesh, such as \"0.1 %\""),
    may("quantity", List(&Text)).told("what the accuracy is of"),
]);

/// Size ratios of neighbours beyond the candidates and into the depth; the coarsest element over the size of the body,
/// the height of the first one over its width, and the last candidate element over the first.
const GROWTH: Form = Table(&[
    may("along", Number),
    may("depth", Number),
    may("coarsest", Number),
    may("first", Number),
    may("end", Number),
]);

/// Growth of meshes whose file does not say: that of the Hertz scenes.
const USUAL: Grading = Grading { unit: 1.0, along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 };
/// Elements up to which it is as it is described; beyond, it follows them.
const FEW: f64 = 16.0;

/// What is asked; none where the mesh is given.
pub(super) fn asked(mesh: Value) -> Result<Option<Asked>, Error> {
    let list = mesh.get("quantity");
    let Some(accuracy) = mesh.get("accuracy") else {
        Value::refuse(list, "`quantity` without `accuracy`", "leave it out, or give `accuracy`")?;
        return Ok(None);
    };
    if let Some(given) = mesh.first(["elements", "per", "order", "growth"]) {
        let remedy = format!("leave `{}` out, or `accuracy`", given.key);
        return Err(given.refused(format!("`{}` cannot be used: `accuracy` chooses the mesh", given.key), remedy));
    }
    let relative = accuracy::percentage(accuracy.text()).map_err(|expected| {
        let message = format!("`accuracy` is \"{}\", but {expected}", accuracy.text());
        accuracy.refused(message, accuracy::remedy())
    })?;
    let mut asked = Asked::new(relative);
    if let Some(list) = list {
        let known = &QUANTITIES[..OF_ACCURACY];
        let quantity = |name: Value| name.choice("quantity with an accuracy", known).cloned();
        asked.quantities = list.entries().into_iter().map(quantity).collect::<Result<_, _>>()?;
        list.refuse_if(asked.quantities.is_empty(), "no `quantity` is named", "name one, or leave it out for both")?;
    }
    Ok(Some(asked))
}

/// How the mesh grows, on the length that holds the elements; where an accuracy chooses the mesh, on the stretch as it
/// is written.
pub(super) fn grading(mesh: Value, stretch: Value) -> Result<Grading, Error> {
    let per = if mesh.get("accuracy").is_some() { Some(stretch.called("per")) } else { mesh.get("per") };
    let unit = per.map_or(Ok(mesh.units.length), Value::length)?;
    let growth = |key, default: f64, expected: &str, [least, most]: [f64; 2]| {
        let given = mesh.get("growth").and_then(|growth| growth.get(key));
        given.map_or(Ok(default), |given| given.within(expected, |x| (least..=most).contains(&x)))
    };
    let ratio = |key, default| growth(key, default, "a ratio between 1 and 5", [1.0, 5.0]);
    let share = |key, default| growth(key, default, "a number between 0.01 and 5", [0.01, 5.0]);
    Ok(Grading {
        unit,
        along: ratio("along", USUAL.along)?,
        depth: ratio("depth", USUAL.depth)?,
        coarsest: share("coarsest", USUAL.coarsest)?,
        first: share("first", USUAL.first)?,
        end: share("end", USUAL.end)?,
    })
}

/// Scene and mesh: those given, or the first ones of the search for an accuracy.
pub(super) fn resolution(mesh: Value, mut scene: Scene) -> Result<(Scene, Resolution), Error> {
    if let Some(accuracy) = mesh.get("accuracy") {
        accuracy.refuse_if(scene.contacts.iter().any(|pair| !pair.profile.kinks().is_empty()), KINKED, UNKINKED)?;
        // Refuses given meshes of several orders.
        order(mesh, &scene)?;
        return Ok(accuracy::first(&scene));
    }
    let needed = scene.bodies.iter().any(|body| !body.shape.has_given_mesh());
    if let Some(given) = mesh.first(["elements", "per", "growth"]).filter(|_| !needed) {
        let message = format!("`{}` cannot be used: the meshes of all bodies are given", given.key);
        return Err(given.refused(message, "leave it out, and refine those meshes"));
    }
    let missing = |key: &str| {
        let remedy =
            "give `elements` and `per` in [mesh], or an `accuracy` that chooses the mesh; `--accuracy` takes its place";
        Err(mesh.refused(format!("missing field `{key}`"), remedy))
    };
    let elements = match mesh.get("elements") {
        Some(given) => given.count(4096, "; 8 to 32 are usual")?,
        None if needed => return missing("elements"),
        None => 1,
    };
    if needed && mesh.get("per").is_none() {
        return missing("per");
    }
    let order = order(mesh, &scene)?;
    if mesh.get("growth").is_none() {
        scene.grading = order.refined(&scene.grading, elements as f64 / FEW);
    }
    Ok((scene, Resolution { elements, refinement: 0, order }))
}

/// The order asked for, else that of a mesh that is given; refuses meshes of another one.
fn order(mesh: Value, scene: &Scene) -> Result<Order, Error> {
    let given = scene.bodies.iter().filter_map(|body| match &body.shape {
        Shape::Given(mesh) => Some(mesh.order()),
        _ => None,
    });
    let given: Vec<Order> = given.collect();
    let order = match mesh.get("order").map(|asked| (asked, asked.read::<u8>())) {
        None => given.first().copied().unwrap_or(Order::Quadratic),
        Some((asked, number)) => Order::numbered(number.into()).ok_or_else(|| {
            let remedy = "give 1 for 4-node or 2 for 8-node cells, or 4 to 8 for cells of high order";
            asked.refused(format!("`order` is {number}"), remedy)
        })?,
    };
    let Some(other) = given.iter().find(|given| **given != order) else { return Ok(order) };
    let [own, others] = [other, &order].map(|order| order.nodes_per_cell());
    let message = format!("a mesh has cells of {own} nodes, others have {others}");
    let place = mesh.get("order").unwrap_or(mesh);
    Err(place.refused(message, "mesh all bodies with one order, and leave `order` out or give the same"))
}

/// Where a mesh that is too large was asked for.
pub(super) fn size(mesh: Value) -> Value {
    mesh.first(["elements", "accuracy"]).unwrap_or(mesh)
}
