//! What is cheapest for an error: the points that no other beats, and the first within an error that is asked for.

use crate::study::timings::precision::Point;

/// Quantities whose error is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Peak pressure.
    Peak,
    /// Half-width.
    HalfWidth,
}

impl Measure {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Peak, Self::HalfWidth];

    /// Symbol and name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Peak => "peak pressure p₀",
            Self::HalfWidth => "half-width a",
        }
    }

    /// Its median and its worst error over the loads.
    pub fn errors(self, point: &Point) -> [f64; 2] {
        match self {
            Self::Peak => [point.peak, point.peak_worst],
            Self::HalfWidth => [point.half_width, point.half_width_worst],
        }
    }
}

/// Our points on meshes that do not know where the contact ends, under all of whose loads the runs converge.
pub fn sound(points: &[Point]) -> Vec<&Point> {
    points.iter().filter(|point| point.series.order().is_some() && point.peak_worst.is_finite()).collect()
}

/// The points to which none is both as cheap and as exact, the cheapest first.
pub fn front<'a>(points: &[&'a Point], cost: fn(&Point) -> f64, error: &dyn Fn(&Point) -> f64) -> Vec<&'a Point> {
    let mut sorted: Vec<&Point> =
        points.iter().copied().filter(|point| cost(point).is_finite() && error(point).is_finite()).collect();
    sorted.sort_by(|a, b| cost(a).total_cmp(&cost(b)).then(error(a).total_cmp(&error(b))));
    let mut least = f64::INFINITY;
    sorted.retain(|point| {
        let better = error(point) < least;
        least = least.min(error(point));
        better
    });
    sorted
}

/// The point of least cost within an error.
pub fn cheapest<'a>(
    points: impl IntoIterator<Item = &'a Point>,
    cost: fn(&Point) -> f64,
    error: impl Fn(&Point) -> f64,
    most: f64,
) -> Option<&'a Point> {
    let enough = points.into_iter().filter(|point| error(point) <= most);
    enough.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}
