//! The legend: one entry per style, in columns outside the data.

use super::annotations;
use super::canvas::Canvas;
use super::chart::Chart;
use super::frame::{Frame, Point};
use super::palette::{Dash, GREY, Marker, Style};
use super::pen::{LINE_WIDTH, Lettering, Pen, widest};
use super::signs;
use super::theme::Colour;

const SIZE: f64 = 11.5;
const ROW: f64 = 18.0;
const SAMPLE: f64 = 44.0;
const GAP: f64 = 8.0;

/// What stands before a text.
enum Sample {
    Curve(Style),
    Hollow(Marker, Colour),
    Area(Colour),
    Line(Pen),
    Bar(Colour),
    Ring,
}

/// Texts with their samples, each text once.
pub(super) struct Legend {
    entries: Vec<(String, Sample)>,
}

impl Legend {
    /// Every labelled series once, in order of appearance, and what hollow signs mean.
    pub fn of<'a>(charts: impl IntoIterator<Item = &'a Chart>) -> Legend {
        let mut legend = Legend { entries: Vec::new() };
        let mut failures = false;
        let charts: Vec<&Chart> = charts.into_iter().collect();
        for series in charts.iter().flat_map(|chart| &chart.series) {
            failures |= !series.hollow.is_empty();
            let Style { marker, colour, .. } = series.style;
            let mut alike = charts.iter().flat_map(|chart| &chart.series).filter(|other| other.label == series.label);
            let only_failures = !series.hollow.is_empty() && alike.all(|other| other.points.is_empty());
            let sample = if only_failures { Sample::Hollow(marker, colour) } else { Sample::Curve(series.style) };
            legend.add(&series.label, sample);
        }
        for chart in &charts {
            chart.bars.iter().for_each(|bars| legend.add(&bars.label, Sample::Bar(bars.colour)));
            let rings = chart.remarks.iter().filter_map(|remark| remark.ring.as_deref());
            rings.for_each(|label| legend.add(label, Sample::Ring));
        }
        if failures {
            legend.add("hollow: not converged", Sample::Hollow(Marker::Circle, GREY));
        }
        legend
    }

    /// Classes and their colours.
    pub fn of_classes(classes: &[(String, Colour)]) -> Legend {
        Legend { entries: classes.iter().map(|(text, colour)| (text.clone(), Sample::Area(*colour))).collect() }
    }

    /// Adds a line of a pen; none without a text.
    pub fn line(&mut self, label: &str, pen: Pen) {
        self.add(label, Sample::Line(pen));
    }

    fn add(&mut self, label: &str, sample: Sample) {
        let known = self.entries.iter().any(|(text, _)| text == label);
        if !known && !label.is_empty() {
            self.entries.push((label.to_string(), sample));
        }
    }

    /// Width of its entries side by side; none of none.
    pub fn row(&self) -> Option<f64> {
        (!self.entries.is_empty()).then(|| self.entries.len() as f64 * self.pitch())
    }

    /// Width of an entry and of the room to the next.
    fn pitch(&self) -> f64 {
        SAMPLE + widest(self.entries.iter().map(|(text, _)| text.as_str()), SIZE) + 4.0 * GAP
    }

    /// Draws the entries from an upper left corner, column by column within a width; returns the lower right corner.
    pub fn draw(&self, canvas: &mut Canvas, (left, top): Point, width: f64) -> Point {
        if self.entries.is_empty() {
            return (left, top);
        }
        let pitch = self.pitch();
        let columns = ((width / pitch) as usize).clamp(1, self.entries.len());
        let rows = self.entries.len().div_ceil(columns);
        for (place, (text, sample)) in self.entries.iter().enumerate() {
            let x = left + pitch * (place / rows) as f64;
            let y = top + ROW * ((place % rows) as f64 + 0.5);
            sample.draw(canvas, (x, y));
            canvas.label((x + SAMPLE + GAP, y), text, Lettering::start(SIZE));
        }
        (left + pitch * columns as f64 - 3.0 * GAP, top + ROW * rows as f64)
    }
}

impl Sample {
    fn draw(&self, canvas: &mut Canvas, (x, y): Point) {
        let centre = (x + 0.5 * SAMPLE, y);
        match *self {
            Sample::Bar(colour) => canvas.lines(
                &annotations::bar([(centre.0 - 9.0, y), (centre.0 + 9.0, y)]),
                Pen::solid(colour, annotations::BAR),
            ),
            Sample::Ring => annotations::ring(canvas, centre, Pen::solid(GREY, 1.6)),
            Sample::Line(pen) => canvas.line(&[(x, y), (x + SAMPLE, y)], pen),
            Sample::Hollow(marker, colour) => signs::hollow(canvas, centre, marker, colour),
            Sample::Area(colour) => {
                let frame = Frame { left: x + 14.0, top: y - 6.0, right: x + SAMPLE, bottom: y + 6.0 };
                canvas.area(&frame.corners(), colour);
                canvas.line(&frame.outline(), Pen::solid(GREY, 0.6));
            }
            Sample::Curve(Style { colour, dash, marker }) => {
                if dash != Dash::Absent {
                    canvas.line(&[(x, y), (x + SAMPLE, y)], Pen { colour, width: LINE_WIDTH, dash });
                }
                signs::filled(canvas, centre, marker, 3.8, colour);
            }
        }
    }
}
