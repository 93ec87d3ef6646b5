//! Curves on the canvas, kept apart where they coincide.
//!
//! Curves that lie on one another are drawn as stripes, the first widest; signs on one another are nested, the first
//! largest; on densely sampled curves the signs of each series are staggered along it.

use super::canvas::Point;
use super::frame::distance;
use super::palette::{Dash, Marker, Style};
use super::plot::{LINE_WIDTH, Plot};

/// One series on the canvas.
pub(super) struct Curve {
    pub style: Style,
    pub width: f64,
    /// The line, broken where a value is missing.
    pub runs: Vec<Vec<Point>>,
    /// Places of the signs and their radii.
    pub signs: Vec<(Point, f64)>,
}

/// Radius of a sign: smaller in narrow frames.
const RADII: (f64, f64) = (3.8, 3.0);
const NARROW: f64 = 320.0;
/// Closer than this two points are one to the eye [display pixels].
const COINCIDENT: f64 = 1.6;
/// Up to so many points each carries its sign.
const SPARSE: usize = 16;
const STAGGER: f64 = 78.0;
const SAMPLE: f64 = 8.0;

/// All series of a plot on the canvas.
pub(super) fn curves(plot: &Plot<'_>) -> Vec<Curve> {
    let count = plot.chart().series.len();
    let radius = if plot.data_frame().width() < NARROW { RADII.1 } else { RADII.0 };
    let mut curves: Vec<Curve> = Vec::new();
    for (rank, series) in plot.chart().series.iter().enumerate() {
        let places: Vec<Point> = series.points.iter().map(|&point| plot.place(point)).collect();
        let runs = runs(&places);
        let phase = (rank as f64 + 0.5) / count as f64;
        let shown = |place: &Point| plot.data_frame().holds(*place);
        let signs = match series.style {
            Style { marker: Marker::Absent, .. } => Vec::new(),
            Style { dash: Dash::Absent, .. } => runs.concat(),
            _ if places.len() <= SPARSE => runs.concat(),
            _ => runs.iter().flat_map(|run| staggered(run, phase)).collect(),
        };
        let signs = signs.into_iter().filter(shown).map(|sign| (sign, radius)).collect();
        curves.push(Curve { style: series.style, width: LINE_WIDTH, runs, signs });
    }
    widen(&mut curves);
    nest(&mut curves);
    curves
}

fn runs(places: &[Point]) -> Vec<Vec<Point>> {
    let finite = |place: &Point| place.0.is_finite() && place.1.is_finite();
    let split = places.split(|place| !finite(place));
    split.filter(|run| !run.is_empty()).map(<[Point]>::to_vec).collect()
}

/// Every so many pixels along the line the nearest data point, beginning at a phase of the distance.
fn staggered(run: &[Point], phase: f64) -> Vec<Point> {
    let (mut walked, mut next) = (0.0, phase * STAGGER);
    let mut chosen = Vec::new();
    for pair in run.windows(2) {
        walked += distance(pair[0], pair[1]);
        if walked >= next {
            chosen.push(pair[1]);
            next = (walked / STAGGER - phase + 1e-9).floor() * STAGGER + (1.0 + phase) * STAGGER;
        }
    }
    chosen
}

/// Enlarges each sign by the number of later ones that stand on it.
fn nest(curves: &mut [Curve]) {
    for first in 0..curves.len() {
        let (earlier, later) = curves.split_at_mut(first + 1);
        for (sign, radius) in &mut earlier[first].signs {
            let upon = |curve: &&Curve| curve.signs.iter().any(|(other, _)| distance(*other, *sign) < COINCIDENT);
            *radius *= 1.42_f64.powi(later.iter().filter(upon).count().min(3) as i32);
        }
    }
}

/// Widens each line by the number of later ones that lie on it.
fn widen(curves: &mut [Curve]) {
    for first in 0..curves.len() {
        let covering = curves[first + 1..].iter().filter(|later| covers(later, &curves[first])).count();
        curves[first].width += 2.1 * covering.min(3) as f64;
    }
}

/// True when most of the earlier curve lies under the later, and the later does not show it through its gaps.
fn covers(later: &Curve, earlier: &Curve) -> bool {
    let transparent = later.style.dash != Dash::Solid && earlier.style.dash != later.style.dash;
    let unstriped = |curve: &Curve| matches!(curve.style.dash, Dash::Absent | Dash::Long);
    if unstriped(later) || unstriped(earlier) || transparent {
        return false;
    }
    let points: Vec<Point> = earlier.runs.iter().flat_map(|run| sampled(run)).collect();
    let close = points.iter().filter(|&&point| later.runs.iter().any(|run| near(run, point))).count();
    !points.is_empty() && 10 * close >= 6 * points.len()
}

/// Points along a line a few pixels apart.
fn sampled(run: &[Point]) -> Vec<Point> {
    let between = |pair: &[Point]| {
        let (a, b) = (pair[0], pair[1]);
        let pieces = (distance(a, b) / SAMPLE).ceil().clamp(1.0, 200.0) as usize;
        let at = move |n: usize| (n as f64 + 0.5) / pieces as f64;
        (0..pieces).map(move |n| (a.0 + at(n) * (b.0 - a.0), a.1 + at(n) * (b.1 - a.1)))
    };
    run.windows(2).flat_map(between).collect()
}

fn near(run: &[Point], point: Point) -> bool {
    run.windows(2).any(|pair| to_segment(point, pair[0], pair[1]) < COINCIDENT)
}

fn to_segment(point: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let along = ((point.0 - a.0) * dx + (point.1 - a.1) * dy) / (dx * dx + dy * dy).max(1e-12);
    let along = along.clamp(0.0, 1.0);
    distance(point, (a.0 + along * dx, a.1 + along * dy))
}
