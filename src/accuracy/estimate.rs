//! What a ladder of meshes says of its own errors: Richardson with the observed order as a check.

use crate::measure::largest;

/// Factor of safety of three meshes whose order is consistent (Roache 1994).
const CONSISTENT: f64 = 1.25;
/// Factor of safety of two meshes, and of three whose order is not (Roache 1994).
const CAUTIOUS: f64 = 3.0;
/// Orders taken for consistent begin here: a square-root edge gives about 2, noise of the contact edge anything.
const LOWEST: f64 = 0.9;
/// Order that is counted on, however high the observed one is.
const HIGHEST: f64 = 2.0;

/// Where a ladder leads, and how far that may be wrong.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// Extrapolated value.
    pub limit: f64,
    /// Uncertainty of the finest value, and of the limit, in the unit of the value.
    pub uncertainty: f64,
    /// Observed order; NaN where there are two meshes only, or the values do not fall into line.
    pub order: f64,
}

/// Richardson from values on meshes of sizes `r²h` (where there is one), `rh` and `h`.
///
/// `p = ln((f₂−f₁)/(f₁−f₀)) / ln r`. Consistent, `p ≥ 0.9`: `1.25 |f₁−f₀| / (r^p − 1)` with p kept to at most 2. Without
/// a third mesh: `3 |f₁−f₀| / (r² − 1)`. Inconsistent: the same with first order, and no less than the range of the
/// three; the limit is then the finest value.
pub fn richardson(coarse: Option<f64>, medium: f64, fine: f64, ratio: f64) -> Estimate {
    let step = fine - medium;
    let safe = |factor: f64, order: f64| factor * step.abs() / (ratio.powf(order) - 1.0);
    let Some(coarse) = coarse else {
        return Estimate { limit: fine, uncertainty: safe(CAUTIOUS, HIGHEST), order: f64::NAN };
    };
    let order = ((medium - coarse) / step).ln() / ratio.ln();
    if order >= LOWEST {
        let counted = order.min(HIGHEST);
        let limit = fine + step / (ratio.powf(counted) - 1.0);
        return Estimate { limit, uncertainty: safe(CONSISTENT, counted), order };
    }
    let range = coarse.max(medium).max(fine) - coarse.min(medium).min(fine);
    // Maxima pass over what is not a number.
    let known = [coarse, medium, fine].iter().all(|value| value.is_finite());
    let uncertainty = if known { safe(CAUTIOUS, 1.0).max(range) } else { f64::NAN };
    Estimate { limit: fine, uncertainty, order }
}

/// The same from values over levels of growth, whose logarithm falls by √2 from one to the next.
///
/// The row counts of a mesh are whole numbers, so that two neighbours may agree by accident. What counts is the range of
/// the last three, over which the logarithm is halved: Roache's 3 for two meshes of ratio 2 and second order,
/// `3 Δ/(2² − 1)`; 8-node cells show about the fourth. Five levels in line, `p = log₂ (f₄−f₂)/(f₂−f₀) ≥ 0.9`, earn 1.25.
pub fn levels(values: &[f64]) -> Estimate {
    let [.., first, middle, last] = *values else {
        return Estimate { limit: f64::NAN, uncertainty: f64::NAN, order: f64::NAN };
    };
    let range = envelope([first, middle].into_iter(), last);
    let earlier = values.len().checked_sub(5).map(|at| values[at]);
    let order = earlier.map_or(f64::NAN, |earlier| ((first - earlier) / (last - first)).log2());
    let factor = if order >= LOWEST { CONSISTENT } else { CAUTIOUS };
    Estimate { limit: last, uncertainty: factor * range / 3.0, order }
}

/// Largest distance from a value over a rung and all finer ones: that one rung agrees by accident is not counted.
pub fn envelope(finer: impl Iterator<Item = f64>, limit: f64) -> f64 {
    largest(finer.map(|value| (value - limit).abs()))
}
