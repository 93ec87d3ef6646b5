//! Observed orders of accuracy between successive meshes, and what a refinement series says of its own limit.

use serde::Serialize;

use super::profile::weighted_line;
use crate::uncertainty::standard;

/// Least-squares slope of `ln error` over `ln h`.
pub fn slope(sizes: &[f64], errors: &[f64]) -> f64 {
    let logs: Vec<[f64; 3]> = sizes.iter().zip(errors).map(|(h, e)| [h.ln(), e.abs().ln(), 1.0]).collect();
    weighted_line(&logs).1
}

/// Error over its floor from which on its order is read: at five times, the floor changes an order by about
/// `0.2/ln 2 = 0.3` where meshes are halved.
const ABOVE_FLOOR: f64 = 5.0;

/// Why a series has no order between two of its meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Why {
    /// Errors of the series change their sign, do not fall, or are no numbers.
    NotMonotone,
    /// The finer error is so small that what limits it is not the mesh: round-off, or the model.
    Floor,
}

/// The order of accuracy that is observed between two successive meshes, or why it is withheld.
pub type Observed = Result<f64, Why>;

/// Observed orders `ln(e₁/e₂)/ln(h₁/h₂)` of errors with their signs between each two successive sizes, the largest size
/// first.
///
/// An order is a property of errors that fall and keep their sign: where those above the floor do not, every order of
/// the series is withheld, since one pair of such a series may fall by accident.
pub fn pairs(sizes: &[f64], errors: &[f64], floor: f64) -> Vec<Observed> {
    let above = |error: f64| error.abs() > ABOVE_FLOOR * floor;
    let read: Vec<f64> = errors.iter().copied().take_while(|&error| above(error)).collect();
    // Acceptance is stated, so that what is no number is not monotone.
    let known = errors.iter().all(|error| error.is_finite()) && floor.is_finite();
    let falls = read.windows(2).all(|two| two[0] * two[1] > 0.0 && two[1].abs() < two[0].abs());
    let pair = |k: usize| match (known && falls, k + 1 < read.len()) {
        (false, _) => Err(Why::NotMonotone),
        (true, false) => Err(Why::Floor),
        (true, true) => Ok((errors[k] / errors[k + 1]).ln() / (sizes[k] / sizes[k + 1]).ln()),
    };
    (0..errors.len().saturating_sub(1)).map(pair).collect()
}

/// Order of accuracy that is counted on: that of linear elements, and of a contact whose edge is found within an
/// element.
const FORMAL: f64 = 2.0;
/// Orders between this and one above the formal one are taken for asymptotic.
const SLOWEST: f64 = 0.5;
/// An order above this says that the last change is small by accident.
const FASTEST: f64 = FORMAL + 1.0;
/// Factor of safety of three meshes whose order is asymptotic (Roache 1994).
const CONSISTENT: f64 = 1.25;
/// Factor of safety where no order is relied on (Roache 1994; Eça & Hoekstra 2014).
const CAUTIOUS: f64 = 3.0;

/// What three results on meshes of sizes 4h, 2h, h say of their limit.
#[derive(Clone, Copy, Debug)]
pub struct Richardson {
    /// Observed order `log₂ (f₄ − f₂)/(f₂ − f₁)`; NaN where the series is not monotone.
    pub order: f64,
    /// Error bar of the finest value, an estimate that covers about 95 % (Roache's GCI), in its unit.
    pub bar: f64,
    /// Extrapolated value; the finest one where the order does not allow to extrapolate.
    pub limit: f64,
}

impl Richardson {
    /// Standard uncertainty of the finest value, in its unit.
    pub fn uncertainty(&self) -> f64 {
        standard(self.bar)
    }
}

/// What results on three nested meshes, coarse to fine, say of their limit, with `Δ = f₁ − f₂`:
///
/// | order p | bar | limit |
/// |---|---|---|
/// | 0.5 … 2 | `1.25 Δ/(2^p − 1)` | `f₁ + Δ/(2^p − 1)` |
/// | 2 … 3 | `1.25 Δ/3`, as of order 2 | `f₁ + Δ/3` |
/// | above 3 | the larger of `3 Δ`, of order 1 with Roache's factor of two meshes, and `1.25/15` of the range | `f₁` |
/// | 0 … 0.5 | three times the range of the three, or `1.25 Δ/(2^p − 1)` if that is larger | `f₁` |
/// | none: not monotone | the range of the three | `f₁` |
/// | none: changes that do not fall | NaN: such a series tells nothing | `f₁` |
///
/// An oscillation is not extrapolated: it goes on within its range, twice the half range of Stern et al. (2001).
pub fn richardson([coarse, medium, fine]: [f64; 3]) -> Richardson {
    let [before, change] = [medium - coarse, fine - medium];
    let range = coarse.max(medium).max(fine) - coarse.min(medium).min(fine);
    let known = [coarse, medium, fine].iter().all(|value| value.is_finite());
    let monotone = before * change > 0.0;
    let order = if monotone { (before / change).log2() } else { f64::NAN };
    let correction = |order: f64| change / (2f64.powf(order) - 1.0);
    let (bar, limit) = match order {
        _ if !known => (f64::NAN, f64::NAN),
        _ if !monotone => (range, fine),
        p if p > FASTEST => {
            // Of order 2 from the coarsest on: a last change that is small by chance tells nothing.
            let from_coarsest = CONSISTENT * range / (4f64.powf(FORMAL) - 1.0);
            ((CAUTIOUS * correction(1.0).abs()).max(from_coarsest), fine)
        }
        p if p >= SLOWEST => (CONSISTENT * correction(p.min(FORMAL)).abs(), fine + correction(p.min(FORMAL))),
        p if p > 0.0 => ((CAUTIOUS * range).max(CONSISTENT * correction(p).abs()), fine),
        _ => (f64::NAN, fine),
    };
    Richardson { order, bar, limit }
}

/// Error bar of the finer of two results on meshes of sizes 2h and h, an estimate that covers about 95 %:
/// `3 |f₁ − f₂|/(2² − 1)` (Roache 1994).
pub fn bar_of_two([coarse, fine]: [f64; 2]) -> f64 {
    CAUTIOUS * (fine - coarse).abs() / (2f64.powf(FORMAL) - 1.0)
}
