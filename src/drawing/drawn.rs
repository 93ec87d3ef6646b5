//! A chart drawn: areas, axes, guides, curves and signs, in this order.

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::chart::Chart;
use super::curves::{Curve, curves};
use super::drawing::Drawing;
use super::frame::{Frame, Point};
use super::legend::Legend;
use super::palette::{Dash, Marker, Style};
use super::pen::Pen;
use super::plot::Plot;
use super::signs;

const PLOT_WIDTH: f64 = 560.0;
const PLOT_HEIGHT: f64 = 372.0;
/// Room of the labels of guides, right of a plot as wide as the drawing.
const OF_GUIDES: f64 = 56.0;
/// Room of the axis below such a plot.
const OF_AXIS: f64 = 14.0;

impl Chart {
    /// The chart, drawn: its legend on the right, or below where that is a row.
    pub fn drawing(&self) -> Drawing {
        let mut canvas = Canvas::new();
        let (legend, whole) = (Legend::of([self]), WIDTH - 2.0 * EDGE);
        let row = legend.row().filter(|row| *row <= whole);
        let width = if row.is_some() { whole - OF_GUIDES } else { PLOT_WIDTH };
        let outer = Frame { left: EDGE, top: TITLE, right: EDGE + width, bottom: TITLE + PLOT_HEIGHT };
        let plot = Plot::new(self, outer, Plot::headroom(self))?;
        plot.draw(&mut canvas);
        let (right, bottom) = match row {
            Some(row) => {
                let left = plot.frame.left.min(EDGE + whole - row);
                (outer.right, legend.draw(&mut canvas, (left, outer.bottom + OF_AXIS), whole).1)
            }
            None => legend.draw(&mut canvas, (outer.right + EDGE, plot.frame.top - 4.0), 0.0),
        };
        canvas.drawing(&self.title, (right, bottom.max(outer.bottom)), &self.notes)
    }
}

impl Plot<'_> {
    /// Draws everything.
    pub fn draw(&self, canvas: &mut Canvas) {
        self.axes(canvas);
        self.chart.guides.iter().for_each(|guide| self.guide(canvas, guide));
        let mut curves = curves(self);
        // References lie on top: their gaps show what they cover.
        curves.sort_by_key(|curve| curve.style.dash == Dash::Long);
        curves.iter().for_each(|curve| self.line(canvas, curve));
        self.chart.slopes.iter().for_each(|slope| self.slope(canvas, slope));
        self.outline(canvas);
        self.chart.bars.iter().for_each(|bars| self.bars(canvas, bars));
        for Curve { style, signs, .. } in &curves {
            if style.marker == Marker::Dot {
                signs::cloud(canvas, signs, style.colour);
                continue;
            }
            signs.iter().for_each(|&(at, radius)| signs::filled(canvas, at, style.marker, radius, style.colour));
        }
        self.hollows(canvas);
        self.remarks(canvas, &curves);
    }

    fn line(&self, canvas: &mut Canvas, curve: &Curve) {
        let Style { colour, dash, .. } = curve.style;
        if dash != Dash::Absent {
            let pieces: Vec<Vec<Point>> = curve.runs.iter().flat_map(|run| self.frame.clip(run)).collect();
            canvas.lines(&pieces, Pen { colour, width: curve.width, dash });
        }
    }
}
