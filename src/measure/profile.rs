//! Functionals of a pressure profile given at contact points.

use crate::scene::Path;
use crate::solution::PointState;

/// Peak of a profile.
#[derive(Clone, Copy, Debug)]
pub struct Peak {
    /// Contact coordinate of the peak.
    pub position: f64,
    /// Pressure there [MPa].
    pub pressure: f64,
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

/// Contact force along the load line on the modelled part, `Σ A p cos θ` (cos θ = 1 on planes) [N].
pub fn resultant(points: &[PointState], path: &Path) -> f64 {
    points.iter().map(|p| p.weight * p.pressure * path.share(p.position)).sum()
}

/// Peak pressure.
///
/// Where the profile falls from the centre: value at 0 of the least-squares even parabola through the points with
/// `|s| < a/4` (at least three). Where it rises first: the top of the parabola through the five points around the maximum.
pub fn peak(points: &[PointState], half_width: f64) -> Peak {
    let near: Vec<[f64; 2]> = points
        .iter()
        .enumerate()
        .filter(|(i, p)| p.position < 0.25 * half_width || *i < 3)
        .map(|(_, p)| [p.position * p.position, p.pressure])
        .collect();
    let (value, curvature) = least_squares_line(&near);
    let highest = (0..points.len()).max_by(|&i, &j| points[i].pressure.total_cmp(&points[j].pressure)).unwrap_or(0);
    let beyond = points.get(highest).is_some_and(|p| p.position > 0.25 * half_width);
    if curvature <= 0.0 || !beyond {
        return Peak { position: 0.0, pressure: value };
    }
    local_peak(points, highest)
}

/// Top of the least-squares parabola through the five points around index `highest`.
fn local_peak(points: &[PointState], highest: usize) -> Peak {
    let from = highest.saturating_sub(2);
    let five = &points[from..(highest + 3).min(points.len())];
    let centre = points[highest].position;
    let width = (five[five.len() - 1].position - five[0].position).max(f64::MIN_POSITIVE);
    let scaled: Vec<[f64; 2]> = five.iter().map(|p| [(p.position - centre) / width, p.pressure]).collect();
    let [c, b, a] = least_squares_parabola(&scaled);
    let top = if a < 0.0 { (-b / (2.0 * a)).clamp(-0.5, 0.5) } else { 0.0 };
    Peak { position: centre + width * top, pressure: c + b * top + a * top * top }
}

/// `[c, b, a]` of the least-squares `c + b x + a x²`.
fn least_squares_parabola(points: &[[f64; 2]]) -> [f64; 3] {
    let mut normal = nalgebra::Matrix3::<f64>::zeros();
    let mut rhs = nalgebra::Vector3::<f64>::zeros();
    for &[x, y] in points {
        let row = nalgebra::Vector3::new(1.0, x, x * x);
        normal += row * row.transpose();
        rhs += row * y;
    }
    normal.lu().solve(&rhs).map_or([f64::NAN; 3], |s| [s[0], s[1], s[2]])
}

/// Intercept and slope of the least-squares line.
pub fn least_squares_line(points: &[[f64; 2]]) -> (f64, f64) {
    let n = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let spread: f64 = points.iter().map(|p| (p[0] - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum::<f64>() / spread;
    (y - slope * x, slope)
}

/// `√( Σ A (p − p_ref)² / Σ A p_ref² )` over the points with `s ≤ limit`.
pub fn relative_l2(points: &[PointState], reference: impl Fn(f64) -> f64, limit: f64) -> f64 {
    let within = || points.iter().filter(|p| p.position <= limit);
    let error: f64 = within().map(|p| p.weight * (p.pressure - reference(p.position)).powi(2)).sum();
    let scale: f64 = within().map(|p| p.weight * reference(p.position).powi(2)).sum();
    (error / scale).sqrt()
}

/// Pressure of a profile between its points, linear; constant before the first point, zero beyond the last.
pub fn interpolate(points: &[PointState], position: f64) -> f64 {
    let after = points.partition_point(|p| p.position < position);
    match (after.checked_sub(1).map(|i| &points[i]), points.get(after)) {
        (None, Some(first)) => first.pressure,
        (Some(a), Some(b)) => {
            let t = (position - a.position) / (b.position - a.position);
            a.pressure + t * (b.pressure - a.pressure)
        }
        _ => 0.0,
    }
}

fn with_pressure(points: &[PointState], pressure: impl Fn(f64) -> f64) -> Vec<PointState> {
    points.iter().map(|p| PointState { pressure: pressure(p.position), ..*p }).collect()
}
