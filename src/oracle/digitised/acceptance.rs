//! How far our curve may lie from a digitised one.

use super::{CurvePoint, DigitisedCurve};
use crate::uncertainty::{COVERAGE, Comparison as Compared, combined};

/// Our value at an abscissa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OurPoint {
    /// The value.
    pub value: f64,
    /// Its own standard uncertainty, such as the discretisation error.
    pub uncertainty: f64,
}

/// Our value beside theirs at one digitised point, in the units of the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Where the point lies.
    pub abscissa: f64,
    /// The digitised ordinate.
    pub theirs: f64,
    /// Our value.
    pub ours: f64,
    /// Combined standard uncertainty `√(u_dig² + u_ours²)`.
    pub uncertainty: f64,
    /// `|ours − theirs| / √(u_dig² + u_ours²)`; NaN where either is not finite.
    pub ratio: f64,
}

/// Our curve beside a digitised one.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// One entry per digitised point.
    pub deviations: Vec<Deviation>,
    /// What the source models and we do not: friction; no uncertainty here covers it.
    pub model_form: Option<String>,
}

impl Comparison {
    /// Whether every point deviates by at most [`COVERAGE`] uncertainties; no point, or NaN, fails.
    pub fn accepted(&self) -> bool {
        let within = |deviation: &Deviation| deviation.ratio <= COVERAGE;
        !self.deviations.is_empty() && self.deviations.iter().all(within)
    }

    /// The point that deviates most, NaN counting as most; `None` without points.
    pub fn worst(&self) -> Option<&Deviation> {
        // The sign of NaN is arbitrary and total_cmp puts a negative one first.
        let rank = |deviation: &Deviation| deviation.ratio.abs();
        self.deviations.iter().max_by(|one, other| rank(one).total_cmp(&rank(other)))
    }
}

/// Holds our curve against a digitised one, point by point.
///
/// `ours` takes the abscissa of the curve (rad, mm or N) and is asked one abscissa error to both sides
/// of each point too, so a symmetric curve must take negative arguments.
pub fn compare(curve: &DigitisedCurve, ours: &dyn Fn(f64) -> OurPoint) -> Comparison {
    Comparison {
        deviations: curve.points.iter().map(|point| deviation(point, ours)).collect(),
        model_form: model_form(curve.scene.friction()),
    }
}

/// `u_dig² = u_y² + (s u_x)²` with the slope `s` of our curve over `x ± u_x`.
fn deviation(point: &CurvePoint, ours: &dyn Fn(f64) -> OurPoint) -> Deviation {
    let (x, error) = (point.abscissa, point.abscissa_error);
    let mine = ours(x);
    let slope = (ours(x + error).value - ours(x - error).value) / (2.0 * error);
    let digitising = combined([point.ordinate_error, slope * error]);
    let compared = Compared::of(mine.value, point.ordinate, [digitising, mine.uncertainty]);

    let (uncertainty, ratio) = (compared.uncertainty, compared.ratio());
    Deviation { abscissa: x, theirs: point.ordinate, ours: mine.value, uncertainty, ratio }
}

fn model_form(friction: f64) -> Option<String> {
    (friction > 0.0).then(|| format!("the source has a coefficient of friction of {friction}, ours has none"))
}
