//! The ends of values, round values between them, and how numbers are written.

/// The smallest and the largest value, if there is any.
pub(super) fn ends(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let spread = |(low, high): (f64, f64), (value, _): (f64, f64)| (low.min(value), high.max(value));
    values.map(|value| (value, value)).reduce(spread)
}

/// Multiples of a step 1, 2 or 5 times a power of ten between two values, and the step.
pub(super) fn round_values(from: f64, to: f64, wanted: usize) -> (f64, Vec<f64>) {
    let rough = (to - from) / wanted.max(1) as f64;
    let decade = 10_f64.powf(rough.log10().floor());
    let off = |digit: &f64| (digit * decade / rough).ln().abs();
    let digit = [1.0, 2.0, 5.0, 10.0].into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    let step = digit.unwrap_or(1.0) * decade;
    let (first, last) = ((from / step - 1e-9).ceil() as i64, (to / step + 1e-9).floor() as i64);
    (step, (first..=last).map(|n| n as f64 * step).collect())
}

/// A number with the digits its step needs; `2.5`, or `3×10⁻⁴` where the largest beside it is very small or large.
pub(super) fn number(value: f64, step: f64, largest: f64) -> String {
    let exponent = (step.log10() + 1e-9).floor() as i32;
    if value.abs() < 1e-9 * step {
        return "0".to_string();
    }
    if (0.01..1e6).contains(&largest.abs()) {
        let decimals = (-exponent).max(0) as usize;
        return format!("{value:.decimals$}").replace('-', "−");
    }
    let lead = (value.abs().log10() + 1e-9).floor() as i32;
    let decimals = (lead - exponent).max(0) as usize;
    let mantissa = format!("{:.decimals$}", value / 10_f64.powi(lead)).replace('-', "−");
    if mantissa == "1" { power(lead) } else { format!("{mantissa}×{}", power(lead)) }
}

/// A power of ten, `10⁻³`.
pub(super) fn power(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(0x2070 + (digit as u32 - 0x30)).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}
