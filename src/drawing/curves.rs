//! Curves on the canvas, kept apart where they coincide.
//!
//! Curves that lie on one another are drawn as stripes, the first widest; signs on one another are nested, the first
//! largest; on densely sampled curves the signs of each series are staggered along it.

use super::chart::Series;
use super::frame::{Point, between, distance};
use super::palette::{Dash, Marker, Style};
use super::pen::LINE_WIDTH;
use super::plot::Plot;

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
    let count = plot.chart.series.len();
    let radius = if plot.frame.width() < NARROW { RADII.1 } else { RADII.0 };
    let shown = plot.frame.widened(0.5);
    let curve = |(rank, series): (usize, &Series)| {
        let places: Vec<Point> = series.points.iter().map(|&point| plot.place(point)).collect();
        let runs = places.split(|place| !(place.0.is_finite() && place.1.is_finite()));
        let runs: Vec<Vec<Point>> = runs.filter(|run| !run.is_empty()).map(<[Point]>::to_vec).collect();
        let phase = (rank as f64 + 0.5) / count as f64;
        let signs = match series.style {
            Style { marker: Marker::Absent, .. } => Vec::new(),
            Style { dash, .. } if dash == Dash::Absent || places.len() <= SPARSE => runs.concat(),
            _ => runs.iter().flat_map(|run| staggered(run, phase)).collect(),
        };
        let signs = signs.into_iter().filter(|&at| shown.holds(at)).map(|at| (at, radius)).collect();
        Curve { style: series.style, width: LINE_WIDTH, runs, signs }
    };
    let mut curves: Vec<Curve> = plot.chart.series.iter().enumerate().map(curve).collect();
    for first in (0..curves.len()).filter(|&first| plot.chart.series[first].style.marker != Marker::Dot) {
        let (earlier, later) = curves.split_at_mut(first + 1);
        nest(&mut earlier[first], later);
        let covering = later.iter().filter(|later| covers(later, &earlier[first])).count();
        earlier[first].width += 2.1 * covering.min(3) as f64;
    }
    curves
}

/// Every so many pixels along the line the nearest data point, beginning at a phase of the distance.
fn staggered(run: &[Point], phase: f64) -> Vec<Point> {
    let (mut walked, mut next) = (0.0, phase * STAGGER);
    let mut chosen = Vec::new();
    for pair in run.windows(2) {
        walked += distance(pair[0], pair[1]);
        if walked >= next {
            chosen.push(pair[1]);
            next = ((walked / STAGGER - phase + 1e-9).floor() + 1.0 + phase) * STAGGER;
        }
    }
    chosen
}

/// Enlarges each sign by the number of later ones that stand on it.
fn nest(curve: &mut Curve, later: &[Curve]) {
    for (sign, radius) in &mut curve.signs {
        let upon = |curve: &&Curve| curve.signs.iter().any(|(other, _)| distance(*other, *sign) < COINCIDENT);
        *radius *= 1.42_f64.powi(later.iter().filter(upon).count().min(2) as i32);
    }
}

/// True when most of the earlier curve lies under the later, and the later does not show it through its gaps.
fn covers(later: &Curve, earlier: &Curve) -> bool {
    let transparent = later.style.dash != Dash::Solid && earlier.style.dash != later.style.dash;
    let striped = |curve: &Curve| !matches!(curve.style.dash, Dash::Absent | Dash::Long);
    if transparent || !striped(later) || !striped(earlier) {
        return false;
    }
    let (under, over) = (sampled(earlier, SAMPLE), sampled(later, COINCIDENT));
    let close = under.iter().filter(|&&point| over.iter().any(|&other| distance(point, other) < COINCIDENT)).count();
    !under.is_empty() && 10 * close >= 6 * under.len()
}

/// Points along a curve a few pixels apart.
pub(super) fn sampled(curve: &Curve, pitch: f64) -> Vec<Point> {
    let along = |pair: &[Point]| {
        let (a, b) = (pair[0], pair[1]);
        let pieces = (distance(a, b) / pitch).ceil().clamp(1.0, 1000.0);
        (0..pieces as usize).map(move |n| between(a, b, (n as f64 + 0.5) / pieces))
    };
    curve.runs.iter().flat_map(|run| run.windows(2)).flat_map(along).collect()
}
