//! Where values stand on an axis, which ticks it carries, and how numbers are written.

use super::chart::{Axis, Scale};
use super::drawing::Error;

/// An axis with its ends: in decades when logarithmic.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    scale: Scale,
    from: f64,
    to: f64,
}

/// One mark on an axis: at what fraction of it, and with which label; without one it is minor.
pub(super) type Tick = (f64, Option<String>);

impl Span {
    /// The ends of an axis: as given, or around the values with a margin.
    pub fn around(axis: &Axis, values: &[f64], figure: &str) -> Result<Span, Error> {
        let given = axis.range.map(|(from, to)| [from, to]);
        let values = given.as_ref().map_or(values, |ends| ends.as_slice());
        let places = values.iter().map(|&value| coordinate(axis.scale, value)).filter(|place| place.is_finite());
        let Some((from, to)) = ends(places) else {
            let reason = format!("the axis `{}` has no finite value", axis.label);
            return Err(Error::of(figure, reason, "give it a range or a series"));
        };
        let span = Span { scale: axis.scale, from, to };
        Ok(if given.is_some() { span } else { span.with_margin() })
    }

    fn with_margin(self) -> Span {
        let extent = self.to - self.from;
        if extent < 1e-12 * self.from.abs().max(self.to.abs()).max(1e-300) {
            let room = match self.scale {
                Scale::Log => 0.5,
                Scale::Linear => 0.5 * self.from.abs().max(1e-12),
            };
            return Span { from: self.from - room, to: self.to + room, ..self };
        }
        let margin = 0.05 * extent;
        // Positive values that begin near zero show it.
        let from = match self.scale {
            Scale::Linear if self.from >= 0.0 && self.from < 0.25 * self.to => 0.0,
            _ => self.from - margin,
        };
        Span { from, to: self.to + margin, ..self }
    }

    /// Place of a value, 0 at the lower end and 1 at the upper; what a logarithm cannot show stands at the lower end.
    pub fn fraction(&self, value: f64) -> f64 {
        let place = coordinate(self.scale, value);
        if place.is_infinite() && value <= 0.0 {
            return 0.0;
        }
        (place - self.from) / (self.to - self.from)
    }

    /// About as many labelled ticks as wanted; where values have names, a tick each.
    pub fn ticks(&self, axis: &Axis, wanted: f64) -> Vec<Tick> {
        let wanted = wanted.round().max(1.0) as usize;
        let named = |(n, name): (usize, &String)| (self.fraction(n as f64 + 1.0), Some(name.clone()));
        let mut ticks: Vec<Tick> = match self.scale {
            _ if !axis.names.is_empty() => axis.names.iter().enumerate().map(named).collect(),
            Scale::Linear => self.linear_ticks(wanted),
            // Powers of ten are short: more of them fit.
            Scale::Log => self.log_ticks(wanted + wanted.div_ceil(4)),
        };
        ticks.retain(|(fraction, _)| *fraction > -1e-9 && *fraction < 1.0 + 1e-9);
        ticks
    }

    fn linear_ticks(&self, wanted: usize) -> Vec<Tick> {
        let (step, values) = round_values(self.from, self.to, wanted);
        let largest = self.from.abs().max(self.to.abs());
        let tick = |value| (self.fraction(value), Some(number(value, step, largest)));
        values.into_iter().map(tick).collect()
    }

    /// Powers of ten, each so many of them labelled; within a decade 1, 2 and 5 times them, or all digits.
    fn log_ticks(&self, wanted: usize) -> Vec<Tick> {
        let (first, last) = ((self.from - 1e-9).ceil() as i32, (self.to + 1e-9).floor() as i32);
        let stride = ((last - first).max(1) as usize).div_ceil(wanted) as i32;
        let (narrow, short, plain) = (self.to - self.from < 0.5, self.to - self.from < 1.2, first >= -2 && last <= 3);
        let tick = |(digit, decade): (i32, i32)| {
            let (step, main) = (10_f64.powi(decade), digit == 1 && decade.rem_euclid(stride) == 0);
            let value = f64::from(digit) * step;
            let label = if short {
                (narrow || [1, 2, 5].contains(&digit)).then(|| number(value, step, 10_f64.powf(self.from)))
            } else {
                main.then(|| if plain { number(value, step, 1.0) } else { power(decade) })
            };
            (self.fraction(value), label)
        };
        let digits = if last - first <= 6 { 1..10 } else { 1..2 };
        (first - 1..=last).flat_map(|decade| digits.clone().map(move |digit| (digit, decade))).map(tick).collect()
    }
}

fn coordinate(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log if value > 0.0 => value.log10(),
        Scale::Log => f64::NEG_INFINITY,
    }
}

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
fn power(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(0x2070 + (digit as u32 - 0x30)).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}
