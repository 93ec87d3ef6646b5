//! Functionals of a pressure profile given at contact points.

use crate::scene::Path;
use crate::solution::PointState;

/// Peak of a profile.
#[derive(Clone, Copy, Debug)]
pub struct Peak {
    /// Contact coordinate of the peak.
    pub position: f64,
    /// Pressure there \[MPa\].
    pub pressure: f64,
}

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

/// `a = 2 √(Σ A p s² / Σ A p)`, exact for a semi-ellipse.
pub fn second_moment_half_width(points: &[PointState]) -> f64 {
    let moment: f64 = points.iter().map(|p| p.weight * p.pressure * p.position * p.position).sum();
    let total: f64 = points.iter().map(|p| p.weight * p.pressure).sum();
    2.0 * (moment / total).sqrt()
}

/// The same functional of a given pressure, taken at the same points with the same weights.
pub fn half_width_of(points: &[PointState], pressure: impl Fn(f64) -> f64) -> f64 {
    second_moment_half_width(&with_pressure(points, pressure))
}

/// The peak functional of a given pressure, taken at the same points.
pub fn peak_of(points: &[PointState], half_width: f64, pressure: impl Fn(f64) -> f64) -> Peak {
    peak(&with_pressure(points, pressure), half_width)
}

/// Contact force along the load line on the modelled part, `Σ A p cos θ` (cos θ = 1 on planes) \[N\].
pub fn resultant(points: &[PointState], path: &Path) -> f64 {
    points.iter().map(|p| p.weight * p.pressure * path.share(p.position)).sum()
}

/// Peak pressure, from least-squares fits weighted by the tributary areas.
///
/// Where the profile falls from the centre: value at 0 of the even parabola through the points with `|s| < a/4` (at least
/// three). Where it rises first: the top of the parabola through the five points around the maximum. The weights matter:
/// consistent nodal pressures of 3-node edges lie above the profile at corners and below it at mid-sides.
pub fn peak(points: &[PointState], half_width: f64) -> Peak {
    let near: Vec<[f64; 3]> = points
        .iter()
        .enumerate()
        .filter(|(i, p)| p.position < 0.25 * half_width || *i < 3)
        .map(|(_, p)| [p.position * p.position, p.pressure, p.weight])
        .collect();
    let (value, curvature) = weighted_line(&near);
    let highest = (0..points.len()).max_by(|&i, &j| points[i].pressure.total_cmp(&points[j].pressure)).unwrap_or(0);
    let beyond = points.get(highest).is_some_and(|p| p.position > 0.25 * half_width);
    let central = Peak { position: 0.0, pressure: value };
    if !beyond {
        return central;
    }
    let local = local_peak(points, highest);
    // Away from a centre that is no top the highest point is the peak; also where it stands far above a centre that is one.
    if curvature > 0.0 || local.pressure > ELSEWHERE * value { local } else { central }
}

/// Peak pressure of a profile on both sides of s = 0, its centre of pressure.
///
/// The top of the parabola through the points with `|s| < a/4` (at least the five nearest), where it has one there; of a
/// profile that is even in s this is the even parabola's. Else the top around the highest point, as on one side.
pub fn peak_across(points: &[PointState], half_width: f64) -> Peak {
    let mut distances: Vec<f64> = points.iter().map(|p| p.position.abs()).collect();
    distances.sort_by(f64::total_cmp);
    let nearest = distances.get(4).or(distances.last()).map_or(0.0, |fifth| fifth * (1.0 + 1e-9));
    let reach = 0.25 * half_width;
    let within = |p: &&PointState| p.position.abs() < reach || p.position.abs() <= nearest;
    let near: Vec<PointState> = points.iter().filter(within).copied().collect();
    let width = reach.max(nearest).max(f64::MIN_POSITIVE);
    let [value, slope, bend] = parabola(&near, 0.0, width).map_or([f64::NAN; 3], |fit| fit.into());
    let top = if bend < 0.0 { -slope / (2.0 * bend) } else { 0.0 };
    let gain = 0.5 * slope * top;
    let moved = gain > ROUNDING * value;
    let central = match moved {
        true => Peak { position: width * top, pressure: value + gain },
        false => Peak { position: 0.0, pressure: value },
    };
    let highest = (0..points.len()).max_by(|&i, &j| points[i].pressure.total_cmp(&points[j].pressure)).unwrap_or(0);
    let beyond = points.get(highest).is_some_and(|p| p.position.abs() > reach);
    let outside = moved && top.abs() > 1.0;
    if !beyond && !outside {
        return central;
    }
    let local = local_peak(points, highest);
    if outside || bend > ROUNDING * value || local.pressure > ELSEWHERE * value { local } else { central }
}

/// Part of a pressure that rounding explains: a uniform one has its top anywhere.
const ROUNDING: f64 = 1e-9;

/// Factor above the centre from which on a top elsewhere is the peak: waves, several contacts; below it lies roughness.
const ELSEWHERE: f64 = 1.25;

/// Top of the parabola through the five points around index `highest`.
fn local_peak(points: &[PointState], highest: usize) -> Peak {
    let from = highest.saturating_sub(2);
    let five = &points[from..(highest + 3).min(points.len())];
    let centre = points[highest].position;
    let width = (five[five.len() - 1].position - five[0].position).max(f64::MIN_POSITIVE);
    let Some(fit) = parabola(five, centre, width) else { return Peak { position: centre, pressure: f64::NAN } };
    // Between the outermost of the five: beyond the last point there is no surface.
    let [low, high] = [five[0], five[five.len() - 1]].map(|end| (end.position - centre) / width);
    let top = if fit[2] < 0.0 { (-fit[1] / (2.0 * fit[2])).clamp(low, high) } else { 0.0 };
    Peak { position: centre + width * top, pressure: fit[0] + fit[1] * top + fit[2] * top * top }
}

/// Coefficients of the least-squares parabola in `x = (s − centre) / width`, from the constant one on.
fn parabola(points: &[PointState], centre: f64, width: f64) -> Option<nalgebra::Vector3<f64>> {
    let mut normal = nalgebra::Matrix3::<f64>::zeros();
    let mut rhs = nalgebra::Vector3::<f64>::zeros();
    for p in points {
        let x = (p.position - centre) / width;
        let row = nalgebra::Vector3::new(1.0, x, x * x);
        normal += row * row.transpose() * p.weight;
        rhs += row * (p.pressure * p.weight);
    }
    normal.lu().solve(&rhs)
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

/// The same norm of the difference of two profiles given at the same points; NaN where their numbers differ.
pub fn relative_l2_between(points: &[PointState], reference: &[PointState]) -> f64 {
    if points.len() != reference.len() {
        return f64::NAN;
    }
    let pairs = || points.iter().zip(reference);
    let error: f64 = pairs().map(|(p, r)| r.weight * (p.pressure - r.pressure).powi(2)).sum();
    let scale: f64 = pairs().map(|(_, r)| r.weight * r.pressure.powi(2)).sum();
    (error / scale).sqrt()
}

/// Largest departure of a pressure from the line through its two neighbours, over the points with `|s| ≤ limit` \[MPa\].
pub fn oscillation(points: &[PointState], limit: f64) -> f64 {
    let within: Vec<&PointState> = points.iter().filter(|p| p.position.abs() <= limit).collect();
    let departures = within.windows(3).map(|three| {
        let t = (three[1].position - three[0].position) / (three[2].position - three[0].position);
        let line = three[0].pressure + t * (three[2].pressure - three[0].pressure);
        (three[1].pressure - line).abs()
    });
    departures.fold(0.0, |worst: f64, d| if worst.is_nan() || d.is_nan() { f64::NAN } else { worst.max(d) })
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

/// Mean pressures over stretches of equal length whose middles are the stations; the edges cover `0 … stretch`.
///
/// From the force between 0 and s, linear within each edge: a mean feels the square-root end of a contact as force, where
/// a value would feel how far it lies from the next node.
pub fn means(edges: &[PointState], stretch: f64, stations: &[f64]) -> Vec<f64> {
    let mut carried = vec![[0.0, 0.0]];
    for edge in edges {
        let [area, force] = carried[carried.len() - 1];
        carried.push([area + edge.weight, force + edge.weight * edge.pressure]);
    }
    let per_length = carried[carried.len() - 1][0] / stretch;
    let half = match stations {
        [first, second, ..] => 0.5 * (second - first),
        _ => 0.5 * stretch,
    };
    let force_to = |s: f64| linear(&carried, s * per_length);
    stations.iter().map(|s| (force_to(s + half) - force_to(s - half)) / (2.0 * half * per_length)).collect()
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

fn with_pressure(points: &[PointState], pressure: impl Fn(f64) -> f64) -> Vec<PointState> {
    points.iter().map(|p| PointState { pressure: pressure(p.position), ..*p }).collect()
}
