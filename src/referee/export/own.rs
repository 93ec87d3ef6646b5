//! Our own answer as a document that is judged like any other, and an empty one to begin with.

use crate::measure::display_factor;
use crate::mesh::Order;
use crate::referee::document::{Contact, Document, Edge};
use crate::referee::units::Units;
use crate::scene::ContactPair;
use crate::solution::PointState;
use crate::solve::{Discretisation, Element, Run};

/// What a run found, with its edge means.
pub fn answer(name: &str, discretisation: &Discretisation, run: &Run) -> Document {
    let of = |(index, _): (usize, &ContactPair)| contact(discretisation, run, index);
    Document {
        case: Some(name.into()),
        code: Some(format!("contact-vv {}", env!("CARGO_PKG_VERSION"))),
        units: units(discretisation.scene.contact()),
        contacts: discretisation.scene.contacts.iter().enumerate().map(of).collect(),
    }
}

/// The same without numbers: what another code fills in.
pub fn template(name: &str, discretisation: &Discretisation) -> Document {
    let nodes = |(index, pair): (usize, &ContactPair)| {
        let factor = display_factor(&pair.path);
        let places = discretisation.interfaces[index].nodes.iter().map(|node| factor * node.coordinate);
        let order = Some(discretisation.mesh.order.number());
        let (name, units) = (Some(pair.name.clone()), others(discretisation, pair));
        Contact { name, units, order, position: places.collect(), ..Contact::default() }
    };
    Document {
        case: Some(name.into()),
        code: None,
        units: units(discretisation.scene.contact()),
        contacts: discretisation.scene.contacts.iter().enumerate().map(nodes).collect(),
    }
}

/// Our units; degrees where a contact runs along an arc.
fn units(pair: &ContactPair) -> Units {
    let straight = pair.path.is_straight();
    let named = |unit: &str| Some(unit.to_owned());
    Units {
        position: named(if straight { "mm" } else { "deg" }),
        pressure: named("MPa"),
        force: named("N"),
        gap: named("mm"),
        area: named("mm2"),
    }
}

/// Those of a contact, where they are others than those of the document.
fn others(discretisation: &Discretisation, pair: &ContactPair) -> Option<Units> {
    Some(units(pair)).filter(|own| *own != units(discretisation.scene.contact()))
}

/// Points of node elements are the nodes; those of other elements lie inside the edges.
fn order(discretisation: &Discretisation, run: &Run) -> Order {
    if run.formulation.element == Element::Node { discretisation.mesh.order } else { Order::Linear }
}

/// Its contact points; of edges of order 2 and more with that on the axis of revolution, which has no area, so that
/// edges are whole.
fn points(discretisation: &Discretisation, run: &Run, index: usize, order: Order) -> Vec<PointState> {
    let points = run.solution.points_of(index);
    let first = discretisation.interfaces[index].nodes.first();
    let axis = first.filter(|node| order != Order::Linear && node.coordinate < points[0].position);
    let axis = axis.map(|node| PointState { position: node.coordinate, weight: 0.0, ..points[0] });
    axis.into_iter().chain(points.iter().copied()).collect()
}

fn contact(discretisation: &Discretisation, run: &Run, index: usize) -> Contact {
    let pair = &discretisation.scene.contacts[index];
    let (order, factor) = (order(discretisation, run), display_factor(&pair.path));
    let points = points(discretisation, run, index, order);
    let list = |of: fn(&PointState) -> f64| points.iter().map(of).collect::<Vec<f64>>();
    let edge = |edge: &crate::solution::EdgeState| Edge {
        from: factor * edge.ends[0],
        to: factor * edge.ends[1],
        area: edge.weight,
        pressure: edge.pressure,
    };
    Contact {
        name: Some(pair.name.clone()),
        units: others(discretisation, pair),
        order: Some(order.number()),
        position: points.iter().map(|point| factor * point.position).collect(),
        pressure: list(|point| point.pressure),
        force: vec![],
        gap: points.iter().map(|point| Some(point.gap).filter(|gap| gap.is_finite())).collect(),
        area: list(|point| point.weight),
        edges: run.solution.edges_of(index).iter().map(edge).collect(),
    }
}
