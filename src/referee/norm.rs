//! The distance of a profile from the truth, edge by edge.

use crate::solution::EdgeState;

/// Points of an edge at which the truth is read: its root at the end of a contact is integrated to about 1e-3 of the
/// edge's mean.
const READ: usize = 32;
/// Points of all edges together from which on fewer of each will do: the edge at the end is a small part of the
/// contact.
const ALL: usize = 64_000;

/// `√(Σ A (p̄ − p̄_ref)² / Σ A p̄_ref²)` of the means over edges, those of the truth by the midpoint rule, weighted by
/// the radius over rings.
pub fn of_means(edges: &[EdgeState], truth: impl Fn(f64) -> f64) -> f64 {
    let points = (ALL / edges.len().max(1)).clamp(1, READ);
    let of = |edge: &EdgeState| match edge.axis {
        None => mean(edge.ends, points, &truth),
        Some(axis) => mean(edge.ends, points, |s| (s - axis) * truth(s)) / mean(edge.ends, points, |s| s - axis),
    };
    let pairs: Vec<[f64; 3]> = edges.iter().map(|edge| [edge.weight, edge.pressure, of(edge)]).collect();
    let error: f64 = pairs.iter().map(|[weight, own, wanted]| weight * (own - wanted).powi(2)).sum();
    let scale: f64 = pairs.iter().map(|[weight, _, wanted]| weight * wanted.powi(2)).sum();
    (error / scale).sqrt()
}

/// Mean of a function over a stretch, by the midpoint rule on so many points.
pub fn mean([from, to]: [f64; 2], points: usize, of: impl Fn(f64) -> f64) -> f64 {
    let at = |k: usize| from + (to - from) * (k as f64 + 0.5) / points as f64;
    (0..points).map(|k| of(at(k))).sum::<f64>() / points as f64
}
