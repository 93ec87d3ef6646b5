//! One chart in a rectangle: its frame, its axes with their ticks, and the signs above it.

use super::axis::Span;
use super::canvas::Canvas;
use super::chart::{Chart, Direction, Series};
use super::drawing::Error;
use super::frame::{Frame, Point};
use super::palette::{GREY, PALE};
use super::pen::{Lettering, Pen, widest};
use super::signs;

/// Size of the labels of guides.
pub(super) const GUIDE_SIZE: f64 = 10.5;

const TICK_SIZE: f64 = 11.0;
const LABEL_SIZE: f64 = 12.0;
const LANE: f64 = 11.0;

/// A chart with its axes fixed and its frame placed.
pub(super) struct Plot<'a> {
    pub chart: &'a Chart,
    /// The rectangle of the data.
    pub frame: Frame,
    x: Span,
    y: Span,
    outer: Frame,
}

impl<'a> Plot<'a> {
    /// Fits the axes to the data and the frame into the rectangle, with room above it.
    pub fn new(chart: &'a Chart, outer: Frame, headroom: f64) -> Result<Plot<'a>, Error> {
        let (xs, ys) = extents(chart);
        let x = Span::around(&chart.x, &xs, &chart.title)?;
        let y = Span::around(&chart.y, &ys, &chart.title)?;
        let ticks = y.ticks(&chart.y, outer.height() / 52.0);
        let frame = Frame {
            left: outer.left + 30.0 + widest(ticks.iter().filter_map(|(_, label)| label.as_deref()), TICK_SIZE),
            top: outer.top + 4.0 + headroom,
            right: outer.right - (width_on_the_right(chart) + 6.0).max(10.0),
            bottom: outer.bottom - 44.0,
        };
        Ok(Plot { chart, frame, x, y, outer })
    }

    /// Room above the frame for the labels of vertical guides and the lanes of hollow signs.
    pub fn headroom(chart: &Chart) -> f64 {
        let labelled = chart.guides.iter().any(|guide| guide.direction == Direction::Vertical);
        LANE * hollow_lanes(chart).len() as f64 + if labelled { 17.0 } else { 0.0 }
    }

    /// Upper end of the lanes of hollow signs.
    pub fn above(&self) -> f64 {
        self.frame.top - LANE * hollow_lanes(self.chart).len() as f64
    }

    /// Draws the rim of the frame.
    pub fn outline(&self, canvas: &mut Canvas) {
        canvas.line(&self.frame.outline(), Pen::solid(GREY, 1.0));
    }

    /// Place of a point on the canvas.
    pub fn place(&self, (x, y): (f64, f64)) -> Point {
        self.at(self.x.fraction(x), self.y.fraction(y))
    }

    fn at(&self, x: f64, y: f64) -> Point {
        (self.frame.left + x * self.frame.width(), self.frame.bottom - y * self.frame.height())
    }

    /// Draws ticks, grid and labels of both axes.
    pub fn axes(&self, canvas: &mut Canvas) {
        let (mut marks, mut lines, mut labels) = (Vec::new(), Vec::new(), Vec::new());
        for (fraction, label) in self.x.ticks(&self.chart.x, self.frame.width() / 58.0) {
            let (x, y) = self.at(fraction, 0.0);
            marks.push(vec![(x, y), (x, y + if label.is_some() { 5.0 } else { 3.0 })]);
            lines.extend(label.is_some().then(|| vec![(x, y), self.at(fraction, 1.0)]));
            labels.extend(label.map(|label| ((x, y + 14.0), label, Lettering::middle(TICK_SIZE))));
        }
        for (fraction, label) in self.y.ticks(&self.chart.y, self.outer.height() / 52.0) {
            let (x, y) = self.at(0.0, fraction);
            marks.push(vec![(x - if label.is_some() { 5.0 } else { 3.0 }, y), (x, y)]);
            lines.extend(label.is_some().then(|| vec![(x, y), self.at(1.0, fraction)]));
            labels.extend(label.map(|label| ((x - 8.0, y), label, Lettering::end(TICK_SIZE))));
        }
        let ((x, y), lettering) = (self.frame.middle(), Lettering::middle(LABEL_SIZE));
        labels.push(((x, self.frame.bottom + 33.0), self.chart.x.label.clone(), lettering));
        labels.push(((self.outer.left + 8.0, y), self.chart.y.label.clone(), lettering.upright()));
        canvas.lines(&lines, Pen::solid(PALE, 0.8));
        canvas.lines(&marks, Pen::solid(GREY, 0.9));
        labels.iter().for_each(|(at, label, lettering)| canvas.label(*at, label, *lettering));
    }

    /// Draws the runs that did not converge, above the frame.
    pub fn hollows(&self, canvas: &mut Canvas) {
        for (lane, series) in hollow_lanes(self.chart).into_iter().enumerate() {
            let y = self.frame.top - LANE * (lane as f64 + 0.5) - 1.0;
            for &abscissa in &series.hollow {
                let (x, _) = self.at(self.x.fraction(abscissa).clamp(0.0, 1.0), 0.0);
                signs::hollow(canvas, (x, y), series.style.marker, series.style.colour);
            }
        }
    }
}

/// Series with hollow signs: each has a lane of its own above the frame.
fn hollow_lanes(chart: &Chart) -> Vec<&Series> {
    chart.series.iter().filter(|series| !series.hollow.is_empty()).collect()
}

/// Room for the labels of horizontal guides.
fn width_on_the_right(chart: &Chart) -> f64 {
    let horizontal = chart.guides.iter().filter(|guide| guide.direction == Direction::Horizontal);
    widest(horizontal.map(|guide| guide.label.as_str()), GUIDE_SIZE)
}

fn extents(chart: &Chart) -> (Vec<f64>, Vec<f64>) {
    let points = || chart.series.iter().flat_map(|series| &series.points);
    let hollow = chart.series.iter().flat_map(|series| &series.hollow);
    let guides = |direction| {
        let own = chart.guides.iter().filter(move |guide| guide.direction == direction);
        own.map(|guide| guide.at)
    };
    let xs = points().map(|point| point.0).chain(hollow.copied()).chain(guides(Direction::Vertical));
    let ys = points().map(|point| point.1).chain(guides(Direction::Horizontal));
    let bars = || chart.bars.iter().flat_map(|bars| &bars.ends).flatten();
    let xs = xs.chain(bars().map(|end| end.0));
    let ys = ys.chain(bars().map(|end| end.1));
    (xs.collect(), ys.collect())
}
