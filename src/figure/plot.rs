//! One chart in a rectangle: frame, ticks, bands, guides, curves and signs.

use super::annotations::GUIDE_SIZE;
use super::axis::{Span, Tick};
use super::canvas::{Canvas, Point};
use super::chart::{Chart, Direction, Series};
use super::curves::{Curve, curves};
use super::frame::Frame;
use super::legend::{hollow_marker, marker};
use super::palette::{Dash, GREY, PALE};
use super::pen::{Lettering, Pen, text_width};
use crate::error::Error;

/// Width of an ordinary curve [display pixels].
pub(super) const LINE_WIDTH: f64 = 1.8;

const TICK_SIZE: f64 = 11.0;
const LABEL_SIZE: f64 = 12.0;
const LANE: f64 = 11.0;

/// A chart with its axes fixed and its frame placed.
pub(super) struct Plot<'a> {
    chart: &'a Chart,
    x: Span,
    y: Span,
    outer: Frame,
    inner: Frame,
}

impl<'a> Plot<'a> {
    /// Fits the axes to the data and the frame into the rectangle.
    pub fn new(chart: &'a Chart, outer: Frame) -> Result<Plot<'a>, Error> {
        let (xs, ys) = extents(chart);
        let x = Span::around(&chart.x, &xs, &chart.title)?;
        let y = Span::around(&chart.y, &ys, &chart.title)?;
        let mut plot = Plot { chart, x, y, outer, inner: outer };
        plot.inner = plot.frame();
        Ok(plot)
    }

    /// Draws everything and returns the frame.
    pub fn draw(&self, canvas: &mut Canvas) -> Frame {
        self.chart.bands.iter().for_each(|band| self.band(canvas, band));
        self.axes(canvas);
        self.guides(canvas);
        self.chart.bands.iter().for_each(|band| self.band_label(canvas, band));
        // References lie on top: their gaps show what they cover.
        let (references, runs): (Vec<Curve>, Vec<Curve>) =
            curves(self).into_iter().partition(|curve| curve.style.dash == Dash::Long);
        let curves: Vec<Curve> = runs.into_iter().chain(references).collect();
        curves.iter().for_each(|curve| self.line(canvas, curve));
        canvas.line(&self.inner.outline(), Pen::solid(GREY, 1.0));
        curves.iter().for_each(|curve| signs(canvas, curve));
        self.hollows(canvas);
        self.inner
    }

    /// What is drawn.
    pub fn chart(&self) -> &'a Chart {
        self.chart
    }

    /// Height of the lanes of hollow signs above the frame.
    pub fn lanes_height(&self) -> f64 {
        LANE * self.hollow_lanes().len() as f64
    }

    /// The rectangle of the data.
    pub fn data_frame(&self) -> Frame {
        self.inner
    }

    /// Place of a point on the canvas.
    pub fn place(&self, (x, y): (f64, f64)) -> Point {
        let frame = &self.inner;
        (frame.left + self.x.fraction(x) * frame.width(), frame.bottom - self.y.fraction(y) * frame.height())
    }

    fn frame(&self) -> Frame {
        let ticks = self.y_ticks(self.outer.height());
        let labels = ticks.iter().filter_map(|tick| tick.label.as_deref());
        let tick_width = labels.map(|label| text_width(label, TICK_SIZE)).fold(0.0, f64::max);
        let right = width_on_the_right(self.chart);
        let above =
            if self.chart.guides.iter().any(|guide| guide.direction == Direction::Vertical) { 16.0 } else { 0.0 };
        let lanes = self.lanes_height();
        Frame {
            left: self.outer.left + 22.0 + tick_width + 8.0,
            top: self.outer.top + 4.0 + above + lanes,
            right: self.outer.right - (right + 6.0).max(10.0),
            bottom: self.outer.bottom - 44.0,
        }
    }

    fn x_ticks(&self, width: f64) -> Vec<Tick> {
        self.x.ticks((width / 58.0).round() as usize)
    }

    fn y_ticks(&self, height: f64) -> Vec<Tick> {
        self.y.ticks((height / 52.0).round() as usize)
    }

    fn axes(&self, canvas: &mut Canvas) {
        let frame = self.inner;
        for tick in self.x_ticks(frame.width()) {
            let x = frame.left + tick.fraction * frame.width();
            let foot = frame.bottom + tick.length();
            canvas.line(&[(x, frame.bottom), (x, foot)], Pen::solid(GREY, 0.9));
            if let Some(label) = &tick.label {
                canvas.line(&[(x, frame.top), (x, frame.bottom)], Pen::solid(PALE, 0.8));
                canvas.label((x, frame.bottom + 14.0), label, Lettering::middle(TICK_SIZE));
            }
        }
        for tick in self.y_ticks(self.outer.height()) {
            let y = frame.bottom - tick.fraction * frame.height();
            let foot = frame.left - tick.length();
            canvas.line(&[(foot, y), (frame.left, y)], Pen::solid(GREY, 0.9));
            if let Some(label) = &tick.label {
                canvas.line(&[(frame.left, y), (frame.right, y)], Pen::solid(PALE, 0.8));
                canvas.label((frame.left - 8.0, y), label, Lettering::end(TICK_SIZE));
            }
        }
        self.axis_labels(canvas);
    }

    fn axis_labels(&self, canvas: &mut Canvas) {
        let frame = self.inner;
        let middle = (0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom));
        let lettering = Lettering::middle(LABEL_SIZE);
        canvas.label((middle.0, frame.bottom + 33.0), &self.chart.x.label, lettering);
        canvas.label((self.outer.left + 8.0, middle.1), &self.chart.y.label, lettering.upright());
    }

    fn line(&self, canvas: &mut Canvas, curve: &Curve) {
        if curve.style.dash == Dash::Absent {
            return;
        }
        let pen = Pen { colour: curve.style.colour, width: curve.width, dash: curve.style.dash };
        for run in &curve.runs {
            self.inner.clip(run).iter().for_each(|piece| canvas.line(piece, pen));
        }
    }

    /// Series with hollow signs: each has a lane of its own above the frame.
    fn hollow_lanes(&self) -> Vec<&'a Series> {
        self.chart.series.iter().filter(|series| !series.hollow.is_empty()).collect()
    }

    fn hollows(&self, canvas: &mut Canvas) {
        for (lane, series) in self.hollow_lanes().into_iter().enumerate() {
            let y = self.inner.top - LANE * (lane as f64 + 0.5) - 1.0;
            for &abscissa in &series.hollow {
                let x = self.inner.left + self.x.fraction(abscissa).clamp(0.0, 1.0) * self.inner.width();
                hollow_marker(canvas, (x, y), series.style.marker, 4.0, series.style.colour);
            }
        }
    }
}

fn signs(canvas: &mut Canvas, curve: &Curve) {
    for &(place, radius) in &curve.signs {
        marker(canvas, place, curve.style.marker, radius, curve.style.colour);
    }
}

/// Room for the labels of horizontal guides and bands.
fn width_on_the_right(chart: &Chart) -> f64 {
    let guides = chart.guides.iter().map(|guide| (guide.direction, &guide.label));
    let bands = chart.bands.iter().map(|band| (band.direction, &band.label));
    let horizontal = guides.chain(bands).filter(|(direction, _)| *direction == Direction::Horizontal);
    horizontal.map(|(_, label)| text_width(label, GUIDE_SIZE)).fold(0.0, f64::max)
}

fn extents(chart: &Chart) -> (Vec<f64>, Vec<f64>) {
    let points = || chart.series.iter().flat_map(|series| &series.points);
    let hollow = chart.series.iter().flat_map(|series| &series.hollow);
    let guides = |direction| chart.guides.iter().filter(move |guide| guide.direction == direction);
    let xs = points().map(|point| point.0).chain(hollow.copied());
    let xs = xs.chain(guides(Direction::Vertical).map(|guide| guide.at));
    let ys = points().map(|point| point.1).chain(guides(Direction::Horizontal).map(|guide| guide.at));
    (xs.collect(), ys.collect())
}
