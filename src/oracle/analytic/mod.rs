//! Closed forms, one file each; a parameter outside its range makes a reading unavailable, never a panic.
//!
//! * [`hertz`]: line contact and the stresses below it.
//! * [`even_gap`]: a rigid profile of even gap on a half-plane, and the stresses below it.
//! * [`persson`]: a pin in a hole with clearance.
//! * [`on_arc`]: one of a straight line, read on an arc.
//! * [`lame`]: press fit of two rings.
//! * [`bars`]: two bars closing a gap.
//! * [`punch`]: a rigid flat punch on a half-plane.
//! * [`uniform`]: a patch under uniform pressure.
//! * [`waves`]: a sinusoidal gap on a half-plane.
//! * [`weight`]: a block under its own weight.

use super::{Quantity, Reading};

pub mod bars;
pub mod even_gap;
pub mod hertz;
pub mod lame;
pub mod on_arc;
pub mod persson;
pub mod punch;
pub mod uniform;
pub mod waves;
pub mod weight;

pub use crate::scene::PlaneHypothesis as Plane;

/// A parameter of a closed form and whether it may hold the value it has.
struct Parameter {
    name: &'static str,
    value: f64,
    holds: bool,
    range: &'static str,
}

fn finite(name: &'static str, value: f64) -> Parameter {
    Parameter { name, value, holds: value.is_finite(), range: "finite" }
}

fn positive(name: &'static str, value: f64) -> Parameter {
    Parameter { name, value, holds: value.is_finite() && value > 0.0, range: "positive" }
}

fn non_negative(name: &'static str, value: f64) -> Parameter {
    Parameter { name, value, holds: value.is_finite() && value >= 0.0, range: "zero or positive" }
}

fn poisson_ratio(name: &'static str, value: f64) -> Parameter {
    Parameter { name, value, holds: value > -1.0 && value <= 0.5, range: "above -1 and at most 0.5" }
}

/// The value as a reading, or which parameter keeps it from being one.
fn answer(parameters: &[Parameter], value: f64) -> Reading {
    if let Some(wrong) = parameters.iter().find(|parameter| !parameter.holds) {
        return Reading::Unavailable(format!("{} is {}, must be {}", wrong.name, wrong.value, wrong.range));
    }
    if value.is_finite() {
        return Reading::Value { value, uncertainty: 0.0 };
    }

    let given: Vec<String> =
        parameters.iter().map(|parameter| format!("{} = {}", parameter.name, parameter.value)).collect();
    Reading::Unavailable(format!("no finite value with {}", given.join(", ")))
}

/// A quantity of a contact under one pressure everywhere.
fn uniform_answer(mut parameters: Vec<Parameter>, quantity: &Quantity, pressure: f64, resultant: f64) -> Reading {
    let value = match quantity {
        Quantity::Resultant => resultant,
        Quantity::PeakPressure => pressure,
        Quantity::Pressure { at } => {
            parameters.push(finite("at", *at));
            pressure
        }
        _ => return Reading::Silent,
    };
    answer(&parameters, value)
}
