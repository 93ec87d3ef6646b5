//! Functionals of a pressure profile given at contact points.

use crate::scene::Path;
use crate::solution::{EdgeState, PointState, largest};

/// Centre of pressure `Σ A p s / Σ A p`; 0 without pressure.
pub fn centre(points: &[PointState]) -> f64 {
    let moment: f64 = points.iter().map(|p| p.weight * p.pressure * p.position).sum();
    let total: f64 = points.iter().map(|p| p.weight * p.pressure).sum();
    if total > 0.0 { moment / total } else { 0.0 }
}

/// The profile with its contact coordinates counted from a place.
pub fn about(points: &[PointState], place: f64) -> Vec<PointState> {
    points.iter().map(|p| PointState { position: p.position - place, ..*p }).collect()
}

/// Width over how far its centre is from s = 0, which rounding leaves of a single point.
const ROUNDING: f64 = 1e-14;

/// `a = 2 √(Σ A p (s − c)² / Σ A p)` about a centre c, exact for a semi-ellipse; 0 on a single point.
pub fn second_moment_width(points: &[PointState], centre: f64) -> f64 {
    let moment: f64 = points.iter().map(|p| p.weight * p.pressure * (p.position - centre).powi(2)).sum();
    let total: f64 = points.iter().map(|p| p.weight * p.pressure).sum();
    let width = 2.0 * (moment / total).sqrt();
    if width <= ROUNDING * centre.abs() { 0.0 } else { width }
}

/// Contact force along the load line on the modelled part, `Σ A p cos θ` (cos θ = 1 on planes) \[N\].
pub fn resultant(points: &[PointState], path: &Path) -> f64 {
    points.iter().map(|p| p.weight * p.pressure * path.share(p.position)).sum()
}

/// Intercept and slope of the least-squares line through `[x, y, weight]`.
pub fn weighted_line(points: &[[f64; 3]]) -> (f64, f64) {
    let total: f64 = points.iter().map(|p| p[2]).sum();
    let mean = |k: usize| points.iter().map(|p| p[2] * p[k]).sum::<f64>() / total;
    let (x, y) = (mean(0), mean(1));
    let spread: f64 = points.iter().map(|p| p[2] * (p[0] - x).powi(2)).sum();
    let slope = points.iter().map(|p| p[2] * (p[0] - x) * (p[1] - y)).sum::<f64>() / spread;
    (y - slope * x, slope)
}

/// `√( Σ A (p − p_ref)² / Σ A p_ref² )` over the points with `s ≤ limit`.
pub fn relative_l2(points: &[PointState], reference: impl Fn(f64) -> f64, limit: f64) -> f64 {
    let within = || points.iter().filter(|p| p.position <= limit);
    let error: f64 = within().map(|p| p.weight * (p.pressure - reference(p.position)).powi(2)).sum();
    let scale: f64 = within().map(|p| p.weight * reference(p.position).powi(2)).sum();
    (error / scale).sqrt()
}

/// Share of the force that another profile has elsewhere, `½ Σ A |p̄ − p̄_ref| / Σ A p̄_ref` over the same edges; NaN
/// where their numbers differ.
pub fn misplaced(edges: &[EdgeState], reference: &[EdgeState]) -> f64 {
    if edges.len() != reference.len() {
        return f64::NAN;
    }
    let pairs = edges.iter().zip(reference);
    let moved: f64 = pairs.map(|(own, other)| other.weight * (own.pressure - other.pressure).abs()).sum();
    0.5 * moved / reference.iter().map(|other| other.weight * other.pressure).sum::<f64>()
}

/// Largest departure of a pressure from the line through its two neighbours, over the points with `|s| ≤ limit`
/// \[MPa\].
pub fn oscillation(points: &[PointState], limit: f64) -> f64 {
    let within: Vec<&PointState> = points.iter().filter(|p| p.position.abs() <= limit).collect();
    let departures = within.windows(3).map(|three| {
        let t = (three[1].position - three[0].position) / (three[2].position - three[0].position);
        let line = three[0].pressure + t * (three[2].pressure - three[0].pressure);
        (three[1].pressure - line).abs()
    });
    largest(departures)
}

/// Pressure of a profile between its points, linear; that of the outermost points beyond them, up to the ends of the
/// candidate stretch, and zero beyond it.
pub fn interpolate(points: &[PointState], stretch: f64, position: f64) -> f64 {
    let after = points.partition_point(|p| p.position < position);
    match (after.checked_sub(1).map(|i| &points[i]), points.get(after)) {
        (Some(a), Some(b)) => {
            let t = (position - a.position) / (b.position - a.position);
            a.pressure + t * (b.pressure - a.pressure)
        }
        (Some(outermost), None) | (None, Some(outermost)) if position.abs() <= stretch * (1.0 + 1e-9) => {
            outermost.pressure
        }
        _ => 0.0,
    }
}

/// Mean pressures over stretches of equal length with these middles.
///
/// From the force between 0 and s, linear within each edge: a mean feels the square-root end of a contact as force,
/// where a value would feel how far it lies from the next node.
pub fn means(edges: &[EdgeState], middles: &[f64]) -> Vec<f64> {
    let from = edges.first().map_or(0.0, |edge| edge.ends[0]);
    let mut carried = vec![[from, 0.0]];
    for edge in edges {
        let [_, force] = carried[carried.len() - 1];
        carried.push([edge.ends[1], force + edge.length() * edge.pressure]);
    }
    let half = match middles {
        [first, second, ..] => 0.5 * (second - first),
        _ => 0.5 * (carried[carried.len() - 1][0] - from),
    };
    let force_to = |s: f64| linear(&carried, s);
    middles.iter().map(|s| (force_to(s + half) - force_to(s - half)) / (2.0 * half)).collect()
}

/// Value of a line through points of growing abscissa, constant beyond its ends.
fn linear(points: &[[f64; 2]], at: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < at);
    match (after.checked_sub(1).map(|i| points[i]), points.get(after)) {
        (Some([x0, y0]), Some([x1, y1])) => y0 + (y1 - y0) * (at - x0) / (x1 - x0),
        (Some([_, y]), None) | (None, Some(&[_, y])) => y,
        (None, None) => f64::NAN,
    }
}
