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
        Profile::Wedge { slope } => slope * s.signum(),
        Profile::Cosine { amplitude, wavelength } => {
            let wave = 2.0 * PI / wavelength;
            amplitude * wave * (wave * s).sin()
        }
        Profile::Table(ref points) => through(points, s, |[a, b], _| (b[1] - a[1]) / (b[0] - a[0])),
        Profile::Smooth(ref cubic) => through(&cubic.points, s, |_, s| cubic.slope(s)),
        _ => f64::NAN,
    }
}

/// Slope by points, which tell one side of an even gap where they begin at 0.
fn through(points: &[[f64; 2]], s: f64, of: impl Fn([[f64; 2]; 2], f64) -> f64) -> f64 {
    let even = points.first().is_none_or(|[first, _]| *first >= 0.0);
    let (side, at) = if even { (1f64.copysign(s), s.abs()) } else { (1.0, s) };
    let after = points.partition_point(|point| point[0] < at).max(1);
    let ends = after.checked_sub(1).and_then(|before| points.get(before..=after));
    match ends {
        Some(&[a, b]) if at >= a[0] => side * of([a, b], at),
        _ => f64::NAN,
    }
}

/// Places at which some derivative of the gap leaps, ascending \[mm\].
pub fn breaks(profile: &Profile) -> Vec<f64> {
    let points: &[[f64; 2]] = match profile {
        Profile::Table(points) => points,
        Profile::Smooth(cubic) => &cubic.points,
        Profile::Wedge { .. } => return vec![0.0],
        _ => return Vec::new(),
    };
    let own = points.iter().map(|[s, _]| *s);
    let even = points.first().is_some_and(|[first, _]| *first >= 0.0);
    let mut places: Vec<f64> = if even { own.clone().chain(own.map(|s| -s)).collect() } else { own.collect() };
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
