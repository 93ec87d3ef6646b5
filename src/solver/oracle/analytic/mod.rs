//! Closed forms, one file each; a parameter outside its range makes a reading unavailable, never a panic.
//!
//! * [`hertz`]: line contact and the stresses below it.
//! * [`even_gap`]: a rigid profile of even gap on a half-plane, and the stresses below it.
//! * [`persson`]: a pin in a hole with clearance.
//! * [`on_arc`]: one of a straight line, read on an arc.
//! * [`shell`]: Lamé's thick rings, cylinders and spheres, alone and fitted.
//! * [`michell`]: a ring under a harmonic of pressure.
//! * [`punch`]: a rigid flat punch on a half-plane.
//! * [`revolution`]: bodies of revolution on a half-space.
//! * [`uniform`]: one pressure all over: a patch, a block under its own weight, two bars closing a gap.
//! * [`waves`]: a sinusoidal gap on a half-plane.

use super::{Quantity, Reading};

pub mod even_gap;
pub mod hertz;
pub mod michell;
pub mod on_arc;
pub mod persson;
pub mod punch;
pub mod revolution;
pub mod shell;
pub mod uniform;
pub mod waves;

pub use crate::scene::PlaneHypothesis as Plane;

/// Places of the coarse search for a largest value.
const PLACES: usize = 720;
/// Iterations of a golden section.
const SECTIONS: usize = 60;
/// Halvings that leave nothing of an interval of any width.
const HALVINGS: usize = 200;

/// A parameter of a closed form and whether it may hold the value it has.
#[derive(Clone, Copy, Debug)]
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

/// The value of a quantity as a reading, or which parameter, its place among them, keeps it from being one.
fn answer(mut parameters: Vec<Parameter>, quantity: &Quantity, value: f64) -> Reading {
    if let Quantity::Pressure { at } | Quantity::HoopStress { at } | Quantity::PinHoopStress { at } = quantity {
        parameters.push(finite("at", *at));
    }
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

/// Where a function is largest between two places, about the second of which it is even: the best of many, then a
/// golden section.
fn largest([from, to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let place = |k: usize| from + (to - from) * k as f64 / PLACES as f64;
    let best = (1..=PLACES).max_by(|&k, &l| of(place(k)).total_cmp(&of(place(l)))).unwrap_or(PLACES);
    let inside = top([place(best - 1), place(best + 1)], &of);
    if of(inside) > of(to) { inside } else { to }
}

/// Where a function with one top between two places has it, by golden sections.
pub(super) fn top([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5_f64.sqrt() - 1.0);
    for _ in 0..SECTIONS {
        let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
        if of(left) < of(right) { low = left } else { high = right }
    }
    0.5 * (low + high)
}

/// The positive place between `low` and `high` where a function that grows has a value; by bisection in the logarithm.
fn grown_to(value: f64, [mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        *if of(middle) < value { &mut low } else { &mut high } = middle;
    }
    (low * high).sqrt()
}
