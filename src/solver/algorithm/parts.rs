//! Contact by contact: which points and edges belong to each, and the means over its edges.

use std::ops::Range;

use crate::contact::{ContactEdge, ContactPoint};
use crate::solution::{EdgeState, PointState};

/// Which points belong to each contact, in their order.
pub fn points(points: &[ContactPoint]) -> impl Iterator<Item = Range<usize>> + '_ {
    ranges(points.chunk_by(|a, b| a.contact == b.contact).map(<[ContactPoint]>::len))
}

/// Which edges belong to each contact, in their order.
pub fn edges(edges: &[ContactEdge]) -> impl Iterator<Item = Range<usize>> + '_ {
    ranges(edges.chunk_by(|a, b| a.contact == b.contact).map(<[ContactEdge]>::len))
}

fn ranges(lengths: impl Iterator<Item = usize>) -> impl Iterator<Item = Range<usize>> {
    lengths.scan(0, |first, length| {
        let own = *first..*first + length;
        *first = own.end;
        Some(own)
    })
}

/// Which points carry more pressure than a share of the largest of their contact.
pub fn pressed(points: &[ContactPoint], pressure: &[f64], share: f64) -> Vec<bool> {
    let of_contact = |own: Range<usize>| {
        let floor = share * pressure[own.clone()].iter().copied().fold(0.0, f64::max);
        pressure[own].iter().map(move |p| *p > floor)
    };
    self::points(points).flat_map(of_contact).collect()
}

/// `Σ A p b` at every retained dof from the pressures as reported \[N\].
pub fn forces(points: &[ContactPoint], states: &[PointState], dofs: usize) -> Vec<f64> {
    let mut forces = vec![0.0; dofs];
    points.iter().zip(states).for_each(|(point, state)| point.add_row(point.weight * state.pressure, &mut forces));
    forces
}

/// `p̄ = Σ A_ie p_i / Σ A_ie` over each edge e of one contact, from the parts of the points' areas that belong to it.
pub fn means(edges: &[ContactEdge], points: &[ContactPoint], states: &[PointState]) -> Vec<EdgeState> {
    let empty = |edge: &ContactEdge| EdgeState { ends: edge.ends, weight: 0.0, pressure: 0.0, axis: edge.axis };
    let mut means: Vec<EdgeState> = edges.iter().map(empty).collect();
    for (point, state) in points.iter().zip(states) {
        for &(edge, area) in &point.shares {
            means[edge].weight += area;
            means[edge].pressure += area * state.pressure;
        }
    }
    means.iter_mut().for_each(|mean| mean.pressure /= mean.weight);
    means
}
