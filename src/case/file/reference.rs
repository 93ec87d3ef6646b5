//! `[reference]`: what makes spring stiffnesses pure numbers. Springs start from it; what converges does not depend on
//! it.

use crate::case::file::form::Form::{Number, Table};
use crate::case::file::form::{Form, may};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::{ReferenceValues, Scene};

/// `[reference]`: ℓ, p_ref and g_ref.
pub(super) const REFERENCE: Form = Table(&[may("length", Number), may("pressure", Number), may("gap", Number)]);

/// `g_ref/ℓ` where the gap tells none.
const SLOPE: f64 = 1e-3;

/// Reference values, those not given by the scene itself: ℓ half the candidate stretch, `g_ref = |g(ℓ)|` without a
/// clearance, and `p_ref = E* g_ref/ℓ`, which on Hertz scenes is p₀ for a = ℓ.
///
/// With several contacts the first one tells them. Where the gap vanishes at ℓ it is taken as a thousandth of ℓ.
pub(super) fn values(table: Value, scene: &Scene) -> Result<ReferenceValues, Error> {
    let pair = scene.contact();
    let modulus = scene.modulus_of(pair);
    let half = 0.5 * pair.stretch;
    let length = table.get("length").map(Value::length).transpose()?.unwrap_or(half * pair.path.metric());
    let pressure =
        table.get("pressure").map(|given| Ok::<f64, Error>(given.units.stress * given.positive()?)).transpose()?;
    let widest = (0..=8).map(|k| pair.profile.gap(0.125 * f64::from(k) * pair.stretch).abs()).fold(0.0, f64::max);
    let ends: &[f64] = if pair.path.has_both_sides() { &[half, -half] } else { &[half] };
    // Waves may return to zero there, but for round-off.
    let own = Some(ends.iter().map(|s| pair.profile.gap(*s).abs()).fold(0.0, f64::max))
        .filter(|own| own.is_finite() && *own > 1e-6 * widest);
    let given = table.get("gap").map(Value::length).transpose()?;
    let told = given.or_else(|| pressure.map(|p| p * length / modulus)).or(own);
    let opening = told.unwrap_or(SLOPE * length);
    Ok(ReferenceValues { length, pressure: pressure.unwrap_or(modulus * opening / length), gap: opening })
}
