//! Medians, quantiles and worst values, which NaN spoils.

use serde::{Deserialize, Serialize};

/// Median, least and most of repeated measurements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Median.
    pub median: f64,
    /// Least.
    pub least: f64,
    /// Most.
    pub most: f64,
}

impl Spread {
    /// Of some values; NaN where there is none, or one is NaN.
    pub fn of(values: &[f64]) -> Self {
        let [least, median, most] = [0.0, 0.5, 1.0].map(|share| quantile(values, share));
        Self { median, least, most }
    }
}

/// Quotients of two lists, pair by pair.
pub fn ratios(above: &[f64], below: &[f64]) -> Vec<f64> {
    above.iter().zip(below).map(|(a, b)| a / b).collect()
}

/// The value below which this share of some values is, on a straight line between the two around it; NaN where there is no value, or
/// one is NaN.
pub fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    if values.is_empty() || values.iter().any(|value| value.is_nan()) {
        return f64::NAN;
    }
    let place = share * (sorted.len() - 1) as f64;
    let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    below + place.fract() * (above - below)
}
