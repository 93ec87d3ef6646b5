//! The slope of a gap, and where it is not smooth.

use std::f64::consts::PI;

use crate::scene::Profile;

/// Slope `g'` at `s`; NaN where the profile does not tell it, or has ended.
pub fn slope(profile: &Profile, s: f64) -> f64 {
    match *profile {
        Profile::Uniform(_) => 0.0,
        Profile::Parabola { radius } => s / radius,
        Profile::Circle { radius } => s / (radius * radius - s * s).sqrt(),
        Profile::Circles { radii } => radii.iter().map(|r| s / r.signum() / (r * r - s * s).sqrt()).sum(),
        Profile::Even { ref coefficients } => {
            let terms = coefficients.iter().enumerate().rev();
            terms.fold(0.0, |sum, (k, c)| 2.0 * (k + 1) as f64 * c + sum * s * s) * s
        }
        Profile::Powers { ref terms } => {
            s.signum() * terms.iter().map(|[c, n]| c * n * s.abs().powf(n - 1.0)).sum::<f64>()
        }
        Profile::Wedge { slope } => slope * s.signum(),
        Profile::Cosine { amplitude, wavelength } => {
            let wave = 2.0 * PI / wavelength;
            amplitude * wave * (wave * s).sin()
        }
        Profile::Table(ref points) => on_its_side(points, s, |at| secant(points, at)),
        Profile::Smooth(ref cubic) => on_its_side(&cubic.points, s, |at| cubic.slope(at)),
        _ => f64::NAN,
    }
}

/// Slope by points, which tell one side of an even gap where they begin at 0.
fn on_its_side(points: &[[f64; 2]], s: f64, of: impl Fn(f64) -> f64) -> f64 {
    let even = points.first().is_none_or(|[first, _]| *first >= 0.0);
    if even { 1f64.copysign(s) * of(s.abs()) } else { of(s) }
}

/// Slope between two neighbouring points; NaN before the first and beyond the last.
fn secant(points: &[[f64; 2]], s: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < s).max(1);
    match points.get(after - 1..=after) {
        Some(&[a, b]) if s >= a[0] => (b[1] - a[1]) / (b[0] - a[0]),
        _ => f64::NAN,
    }
}

/// Places at which some derivative of the gap leaps, ascending \[mm\].
pub fn breaks(profile: &Profile) -> Vec<f64> {
    let mut places = if let Profile::Wedge { .. } = profile { vec![0.0] } else { profile.places() };
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// How far a profile goes to the left, and to the right \[mm\].
pub fn reach(profile: &Profile) -> [f64; 2] {
    match (breaks(profile).as_slice(), profile) {
        ([first, .., last], Profile::Table(_) | Profile::Smooth(_)) => [*first, *last],
        _ => profile.reach().map_or([f64::NEG_INFINITY, f64::INFINITY], |reach| [-reach, reach]),
    }
}
