//! `[reference]`: what makes spring stiffnesses pure numbers. Springs start from it; what converges does not depend on it.

use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::ReferenceTable;
use crate::case::file::units::Units;
use crate::error::Error;
use crate::scene::{ReferenceValues, Scene};

/// `g_ref/ℓ` where the gap tells none.
const SLOPE: f64 = 1e-3;

/// Reference values, those not given by the scene itself: ℓ half the candidate stretch, `g_ref = |g(ℓ)|` and
/// `p_ref = E* g_ref/ℓ`, which on Hertz scenes is p₀ for a = ℓ.
///
/// With several contacts the first one tells them. Where the gap vanishes at ℓ it is taken as a thousandth of ℓ.
pub(super) fn values(
    source: Source,
    units: &Units,
    scene: &Scene,
    table: Option<&ReferenceTable>,
) -> Result<ReferenceValues, Error> {
    let none = ReferenceTable::default();
    let table = table.unwrap_or(&none);
    let given = |key: &str, value: &Option<Spanned<f64>>, unit: f64| {
        value.as_ref().map(|value| Ok::<f64, Error>(unit * source.positive(key, value)?)).transpose()
    };
    let pair = scene.contact();
    let modulus = scene.modulus_of(pair);
    let half = 0.5 * pair.stretch;
    let length = given("length", &table.length, units.length)?.unwrap_or(half * pair.path.metric());
    let pressure = given("pressure", &table.pressure, units.stress)?;
    let widest = (0..=8).map(|k| pair.profile.gap(0.125 * f64::from(k) * pair.stretch).abs()).fold(0.0, f64::max);
    let ends: &[f64] = if pair.path.has_both_sides() { &[half, -half] } else { &[half] };
    // Waves may return to zero there, but for round-off.
    let own = Some(ends.iter().map(|s| pair.profile.gap(*s).abs()).fold(0.0, f64::max))
        .filter(|own| own.is_finite() && *own > 1e-6 * widest);
    let told = given("gap", &table.gap, units.length)?.or_else(|| pressure.map(|p| p * length / modulus)).or(own);
    let opening = told.unwrap_or(SLOPE * length);
    Ok(ReferenceValues { length, pressure: pressure.unwrap_or(modulus * opening / length), gap: opening })
}
