//! Where a contact ends, from pressures that were found with all points closed up to an expected end.

use nalgebra::{DMatrix, DVector};

/// Distance from the end, over the cell next to it, up to which pressures take part: the outermost layer.
const NEAR: f64 = 0.3501;
/// Distance up to which a point lies at the end itself.
const AT_END: f64 = 1e-9;
/// Fewest and most terms of the series, and pressures for each of them. With three the end of the cylinder's contact wandered by 7e-5 from
/// mesh to mesh, with these by 1e-5.
const TERMS: [usize; 2] = [4, 6];
const EACH: usize = 3;
/// Most that an end moves at once, over the half-width.
const FARTHEST: f64 = 0.5;

/// How far an end lies beyond the place that was expected.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Beyond {
    /// By the series of most terms.
    pub(super) by: f64,
    /// How far the series of one term less is from that.
    pub(super) apart: f64,
}

/// How far the end lies beyond the expected one, over the half-width, from `[distance from that end, pressure]` of closed points, and how
/// wide the cell next to it is.
///
/// Closed up to a place e that is not the end, a frictionless contact has the pressure of a sharp corner,
/// `p √d = A₀ + B₀ d + C₀ d² + …` at the distance d from e. At the end itself A₀, its stress intensity, vanishes. Where the end
/// lies at e + δ, `p ∝ √(δ + d) = √d + δ/(2√d) + …`, so that `δ = 2 A₀/B₀`.
pub(super) fn beyond(points: &[[f64; 2]], half_width: f64, cell: f64) -> Result<Beyond, String> {
    let near = points.iter().filter(|[d, _]| *d > AT_END * half_width && *d <= NEAR * cell);
    let near: Vec<[f64; 2]> = near.map(|[d, p]| [d / half_width, *p]).collect();
    let (found, [least, most]) = (near.len(), TERMS);
    if found < least {
        return Err(format!("{found} closed points lie within {NEAR:.2} half-widths of it, and {least} are needed"));
    }
    let terms = (near.len() / EACH).clamp(least, most);
    let both = by_series(&near, terms).zip(by_series(&near, terms - 1));
    let (delta, other) = both.ok_or("the pressure does not fall towards it")?;
    Ok(Beyond { by: delta.clamp(-FARTHEST, FARTHEST), apart: (delta - other).abs() })
}

/// `δ = 2 A₀/B₀` of the series of so many terms, in half-widths; none where the pressure does not fall towards an end.
fn by_series(near: &[[f64; 2]], terms: usize) -> Option<f64> {
    let powers = DMatrix::from_fn(near.len(), terms, |row, k| near[row][0].powi(k as i32));
    let rooted = DVector::from_fn(near.len(), |row, _| near[row][1] * near[row][0].sqrt());
    let series = powers.svd(true, true).solve(&rooted, f64::EPSILON).ok()?;
    let delta = 2.0 * series[0] / series[1];
    (series[1] > 0.0 && delta.is_finite()).then_some(delta)
}
