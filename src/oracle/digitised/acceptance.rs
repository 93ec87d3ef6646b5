//! How far our curve may lie from a digitised one.

use super::{CurvePoint, DigitisedCurve};
use crate::measure::larger;
use crate::uncertainty::{Comparison, combined};

/// Our value at an abscissa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OurPoint {
    /// The value.
    pub value: f64,
    /// Its own standard uncertainty, such as the discretisation error.
    pub uncertainty: f64,
}

/// Holds our curve against a digitised one, point by point: differences, each with `√(u_dig² + u_ours²)`.
///
/// `ours` takes the abscissa of the curve (rad, mm or N) and is asked one abscissa error to both sides
/// of each point too, so a symmetric curve must take negative arguments.
pub fn compare(curve: &DigitisedCurve, ours: &dyn Fn(f64) -> OurPoint) -> Vec<Comparison> {
    curve.points.iter().map(|point| at(point, ours)).collect()
}

/// `u_dig² = u_y² + (s u_x)²` with the slope `s` of our curve over `x ± u_x`.
fn at(point: &CurvePoint, ours: &dyn Fn(f64) -> OurPoint) -> Comparison {
    let (x, error) = (point.abscissa, point.abscissa_error);
    let mine = ours(x);
    let slope = (ours(x + error).value - ours(x - error).value) / (2.0 * error);
    let digitising = combined([point.ordinate_error, slope * error]);
    Comparison::of(mine.value, point.ordinate, [digitising, mine.uncertainty])
}

/// The largest difference in units of its uncertainty; NaN, which no check passes, where one is no number or there is none.
pub fn worst(compared: &[Comparison]) -> f64 {
    compared.iter().map(Comparison::ratio).reduce(larger).unwrap_or(f64::NAN)
}

/// What the source models and we do not, which no uncertainty covers.
pub fn model_form(curve: &DigitisedCurve) -> Option<String> {
    let friction = curve.scene.friction();
    (friction > 0.0).then(|| format!("the source has a coefficient of friction of {friction}, ours has none"))
}
