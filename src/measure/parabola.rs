//! The peak as the other codes measure it (`oracles/python/measures.py`), so that what their measure differs from ours by is
//! known.

use nalgebra::{Matrix3, Vector3};

use crate::measure::larger;
use crate::measure::profile::weighted_line;
use crate::solution::EdgeState;

/// Part of the half-width within which edges take part.
const NEAR: f64 = 0.25;
/// Fewest edges of the fit about the symmetry line; as many on both sides and the highest make the other one.
const FEWEST: usize = 3;

/// Peak by least squares over the means of edges from the symmetry line on: `c₀` of `c₀ + c₁ s²` over those within a quarter of the
/// half-width; where that rises and the highest mean lies farther out, the top of the parabola over five edges around it.
pub fn peak(edges: &[EdgeState], half_width: f64) -> f64 {
    let near = |k: usize| k < FEWEST || edges[k].position() < NEAR * half_width;
    let squares = |edge: &EdgeState| mean_square(edge.ends);
    let own: Vec<[f64; 3]> = (0..edges.len())
        .filter(|&k| near(k))
        .map(|k| [squares(&edges[k]), edges[k].pressure, edges[k].weight])
        .collect();
    let (value, rise) = weighted_line(&own);
    let largest = edges.iter().map(|edge| edge.pressure).fold(f64::NEG_INFINITY, larger);
    let Some(highest) = edges.iter().position(|edge| edge.pressure >= largest) else { return f64::NAN };
    if rise <= 0.0 || edges[highest].position() <= NEAR * half_width {
        return value;
    }
    top(&edges[highest.saturating_sub(2)..(highest + 3).min(edges.len())]).unwrap_or(largest)
}

/// Mean of s² between two ends.
fn mean_square([a, b]: [f64; 2]) -> f64 {
    (a * a + a * b + b * b) / 3.0
}

/// Top of the parabola over some edges; none where it bends upwards.
fn top(edges: &[EdgeState]) -> Option<f64> {
    let (mut normal, mut rhs) = (Matrix3::zeros(), Vector3::zeros());
    let centre = edges[edges.len() / 2].position();
    for edge in edges {
        let ends = edge.ends.map(|end| end - centre);
        let row = Vector3::new(1.0, 0.5 * (ends[0] + ends[1]), mean_square(ends));
        normal += row * row.transpose() * edge.weight;
        rhs += row * (edge.pressure * edge.weight);
    }
    let c = normal.lu().solve(&rhs)?;
    (c[2] < 0.0).then(|| c[0] - c[1] * c[1] / (4.0 * c[2]))
}
