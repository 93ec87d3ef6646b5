//! Where values stand on an axis, and which ticks it carries.

use super::canvas::drawing;
use super::chart::{Axis, Scale};
use super::numbers::{number, power, round_values};
use crate::error::Error;

/// An axis with its ends: in decades when logarithmic.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    scale: Scale,
    from: f64,
    to: f64,
}

/// One mark on an axis: without a label it is a minor one.
pub(super) struct Tick {
    pub fraction: f64,
    pub label: Option<String>,
}

impl Span {
    /// The ends of an axis: as given, or around the values with a margin.
    pub fn around(axis: &Axis, values: &[f64], figure: &str) -> Result<Span, Error> {
        let coordinates = match axis.range {
            Some((from, to)) => vec![coordinate(axis.scale, from), coordinate(axis.scale, to)],
            None => values.iter().map(|&value| coordinate(axis.scale, value)).collect(),
        };
        let finite = || coordinates.iter().copied().filter(|value| value.is_finite());
        let (from, to) =
            finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        if from > to {
            let reason = format!("the axis `{}` has no finite value", axis.label);
            return Err(drawing(figure, reason, "give it a range or a series"));
        }
        Ok(match axis.range {
            Some(_) => Span { scale: axis.scale, from, to },
            None => Span { scale: axis.scale, from, to }.with_margin(),
        })
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

    /// About as many ticks as wanted.
    pub fn ticks(&self, wanted: usize) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => self.linear_ticks(wanted),
            Scale::Log if self.to - self.from < 1.2 => self.ticks_within_a_decade(),
            // Powers of ten are short: more of them fit.
            Scale::Log => self.decades(wanted + wanted.div_ceil(4)),
        }
    }

    fn linear_ticks(&self, wanted: usize) -> Vec<Tick> {
        let (step, values) = round_values(self.from, self.to, wanted);
        let label = |value: f64| Some(number(value, step, self.from.abs().max(self.to.abs())));
        values.into_iter().map(|value| Tick { fraction: self.fraction(value), label: label(value) }).collect()
    }

    fn ticks_within_a_decade(&self) -> Vec<Tick> {
        let decades = self.from.floor() as i32..=self.to.ceil() as i32;
        let values = decades.flat_map(|decade| (1..10).map(move |digit| (digit, decade)));
        let tick = |(digit, decade): (i32, i32)| {
            let value = f64::from(digit) * 10_f64.powi(decade);
            let labelled = [1, 2, 5].contains(&digit) || self.to - self.from < 0.5;
            Tick {
                fraction: self.fraction(value),
                label: labelled.then(|| number(value, 10_f64.powi(decade), 10_f64.powf(self.from))),
            }
        };
        values.map(tick).filter(Tick::is_on_axis).collect()
    }

    fn decades(&self, wanted: usize) -> Vec<Tick> {
        let (first, last) = ((self.from - 1e-9).ceil() as i32, (self.to + 1e-9).floor() as i32);
        let stride = ((last - first).max(1) as usize).div_ceil(wanted.max(1)) as i32;
        let plain = first >= -2 && last <= 3;
        let decade = |n: i32| Tick {
            fraction: (f64::from(n) - self.from) / (self.to - self.from),
            label: (n.rem_euclid(stride) == 0)
                .then(|| if plain { number(10_f64.powi(n), 10_f64.powi(n), 1.0) } else { power(n) }),
        };
        let mut ticks: Vec<Tick> = (first..=last).map(decade).collect();
        if last - first <= 6 {
            let between = (first - 1..=last).flat_map(|n| (2..10).map(move |digit| f64::from(digit) * 10_f64.powi(n)));
            ticks.extend(between.map(|value| Tick { fraction: self.fraction(value), label: None }));
        }
        ticks.retain(Tick::is_on_axis);
        ticks
    }
}

impl Tick {
    /// Length of the mark [display pixels].
    pub fn length(&self) -> f64 {
        if self.label.is_some() { 5.0 } else { 3.0 }
    }

    fn is_on_axis(&self) -> bool {
        self.fraction > -1e-9 && self.fraction < 1.0 + 1e-9
    }
}

fn coordinate(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log if value > 0.0 => value.log10(),
        Scale::Log => f64::NEG_INFINITY,
    }
}
