//! Observed order of accuracy and the uncertainty that a refinement series gives itself.

use super::profile::weighted_line;

/// Least-squares slope of `ln error` over `ln h`.
pub fn observed(sizes: &[f64], errors: &[f64]) -> f64 {
    let logs: Vec<[f64; 3]> = sizes.iter().zip(errors).map(|(h, e)| [h.ln(), e.abs().ln(), 1.0]).collect();
    weighted_line(&logs).1
}

/// What three results on meshes of sizes 4h, 2h, h say of their limit.
#[derive(Clone, Copy, Debug)]
pub struct Richardson {
    /// Observed order `log₂ (f₄ − f₂)/(f₂ − f₁)`; NaN where the series is not monotone.
    pub order: f64,
    /// Uncertainty of the finest value relative to it: `1.25 |f₂ − f₁| / (2^p − 1) / |f₁|`, with p kept within 1 … 2;
    /// where the series is not monotone, the range of the three over `|f₁|`.
    pub uncertainty: f64,
    /// Extrapolated value.
    pub limit: f64,
}

/// Richardson extrapolation from results on three nested meshes, coarse to fine; factor of safety 1.25 (Roache 1994).
pub fn richardson([coarse, medium, fine]: [f64; 3]) -> Richardson {
    let order = ((coarse - medium) / (medium - fine)).log2();
    let used = if order.is_nan() { 1.0 } else { order.clamp(1.0, 2.0) };
    let correction = (fine - medium) / (2f64.powf(used) - 1.0);
    let uncertainty = if order.is_nan() {
        coarse.max(medium).max(fine) - coarse.min(medium).min(fine)
    } else {
        1.25 * correction.abs()
    };
    Richardson { order, uncertainty: uncertainty / fine.abs(), limit: fine + correction }
}
