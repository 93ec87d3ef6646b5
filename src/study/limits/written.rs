//! Numbers in words.

use crate::solve::run::Errors;

/// A fraction as a percentage of two decimals.
pub(super) fn percent(x: f64) -> String {
    match x {
        x if x.is_nan() => "–".into(),
        x if x.abs() < 5e-5 => "< 0.01 %".into(),
        x => format!("{:+.2} %", 100.0 * x),
    }
}

/// Errors of p₀ and a as percentages.
pub(super) fn percents(errors: Errors) -> [String; 2] {
    [errors.peak, errors.half_width].map(percent)
}

/// Below a bound, or the size of what is not; NaN is not.
pub(super) fn within(error: f64, bound: f64) -> String {
    if error <= bound { format!("below {bound:e}") } else { format!("{error:.0e}") }
}

/// The size of a fraction as a percentage.
pub(super) fn size(x: f64) -> String {
    if x >= 0.1 { format!("{:.0} %", 100.0 * x) } else { format!("{:.2} %", 100.0 * x) }
}

/// The first of some values from which on a criterion holds, and the one before it.
pub(super) fn bracket(values: &[f64], holds: impl Fn(usize) -> bool, name: &str) -> String {
    match (0..values.len()).find(|&i| holds(i)) {
        None => format!("none up to {name} = {}", number(values[values.len() - 1])),
        Some(0) => format!("from {name} = {} on, the first tried", number(values[0])),
        Some(i) => format!("between {name} = {} and {}", number(values[i - 1]), number(values[i])),
    }
}

/// A number as people write it: eight digits, powers of ten where it is large or small.
pub(super) fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.7e}").parse().unwrap_or(x);
    if x.abs() > 0.0 && !(1e-3..1e4).contains(&x.abs()) { format!("{rounded:e}") } else { rounded.to_string() }
}

/// The first and the last of some values.
pub(super) fn range(values: &[f64], name: &str) -> String {
    format!("{name} = {} … {}", number(values[0]), number(values[values.len() - 1]))
}
