//! Medians and worst values; NaN spoils both.

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
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let broken = values.is_empty() || values.iter().any(|value| value.is_nan());
        let at = |index: usize| if broken { f64::NAN } else { sorted[index] };
        let (n, half) = (sorted.len(), sorted.len() / 2);
        let lower = half.saturating_sub(usize::from(n.is_multiple_of(2)));
        Self { median: 0.5 * (at(lower) + at(half)), least: at(0), most: at(n.saturating_sub(1)) }
    }

    /// Of the quotients of two lists, pair by pair.
    pub fn of_ratios(above: &[f64], below: &[f64]) -> Self {
        Self::of(&above.iter().zip(below).map(|(a, b)| a / b).collect::<Vec<_>>())
    }
}

/// The value below which three quarters of some values are, on a straight line between the two around it; NaN as for a spread.
pub fn upper_quartile(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    if values.is_empty() || values.iter().any(|value| value.is_nan()) {
        return f64::NAN;
    }
    let place = 0.75 * (sorted.len() - 1) as f64;
    let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    below + place.fract() * (above - below)
}

/// Exponent e of `y = c xᵉ` by least squares of the logarithms.
pub fn exponent(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k].ln()).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let product =
        |a: usize, b: usize| -> f64 { points.iter().map(|p| (p[a].ln() - [x, y][a]) * (p[b].ln() - [x, y][b])).sum() };
    product(0, 1) / product(0, 0)
}
