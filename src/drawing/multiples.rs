//! Charts side by side on one card: small multiples over one legend, and a sheet, rows of charts below a field.

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::chart::Chart;
use super::drawing::{Drawing, Error};
use super::field::Field;
use super::frame::Frame;
use super::legend::Legend;
use super::pen::{Lettering, text_width};
use super::plot::Plot;

/// Size of the title of a panel that has room.
const TITLE_SIZE: f64 = 12.0;
/// Room of the title above a panel, and between panels.
const CAPTION: f64 = 20.0;
const BETWEEN: f64 = 10.0;

/// Small multiples: the charts side by side, so many to a row, over one legend and all their notes.
pub fn panels(title: &str, charts: &[Chart], columns: usize) -> Drawing {
    let mut canvas = Canvas::new();
    let columns = columns.clamp(1, charts.len().max(1));
    let height = (0.82 * pitch(columns)).clamp(280.0, 345.0);
    let mut top = TITLE;
    for charts in charts.chunks(columns) {
        row(&mut canvas, charts, columns, (top, top + height - 8.0))?;
        top += height;
    }
    let (_, bottom) = Legend::of(charts).draw(&mut canvas, (EDGE + 8.0, top), WIDTH - 2.0 * EDGE);
    let mut notes: Vec<String> = Vec::new();
    for note in charts.iter().flat_map(|chart| &chart.notes) {
        if !notes.contains(note) {
            notes.push(note.clone());
        }
    }
    canvas.drawing(title, (WIDTH - EDGE, bottom + 10.0), &notes)
}

/// Draws charts side by side below their titles, their frames in line.
fn row<'a>(
    canvas: &mut Canvas,
    charts: &'a [Chart],
    columns: usize,
    (top, bottom): (f64, f64),
) -> Result<Vec<Plot<'a>>, Error> {
    let headroom = charts.iter().map(Plot::headroom).fold(0.0, f64::max);
    let mut plots = Vec::new();
    for (place, chart) in charts.iter().enumerate() {
        let left = EDGE + pitch(columns) * place as f64;
        let outer = Frame { left, top: top + CAPTION, right: left + pitch(columns) - BETWEEN, bottom };
        let plot = Plot::new(chart, outer, headroom)?;
        plot.draw(canvas);
        // Bold letters are wider than the estimate of plain ones.
        let size =
            TITLE_SIZE * (0.95 * (outer.right - plot.frame.left) / text_width(&chart.title, TITLE_SIZE)).min(1.0);
        canvas.label((plot.frame.left, top + 9.0), &chart.title, Lettering::start(size).bold());
        plots.push(plot);
    }
    Ok(plots)
}

/// From one panel to the next.
fn pitch(columns: usize) -> f64 {
    (WIDTH - 2.0 * EDGE + BETWEEN) / columns as f64
}

/// A field above charts, each chart with its own legend.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// What is shown, in a few words.
    pub title: String,
    /// The field; its title stands above it.
    pub field: Option<Field>,
    /// The charts, row by row from left to right.
    pub charts: Vec<Vec<Chart>>,
    /// Small print below all that of the field and the charts.
    pub notes: Vec<String>,
}

const CHART_HEIGHT: f64 = 310.0;
/// Between the field and the charts, and their rows.
const ROWS: f64 = 22.0;

impl Sheet {
    /// The sheet, drawn.
    pub fn drawing(&self) -> Drawing {
        let mut canvas = Canvas::new();
        let (mut bottom, mut notes) = (TITLE, Vec::new());
        if let Some(field) = &self.field {
            canvas.label((EDGE, TITLE + 10.0), &field.title, Lettering::start(12.0).bold());
            let panels = field.panels(TITLE + 20.0)?;
            panels.draw(&mut canvas);
            notes.push(panels.notes());
            bottom = panels.bottom() + ROWS;
        }
        let columns = self.charts.iter().map(Vec::len).max().unwrap_or(1);
        for charts in &self.charts {
            let foot = bottom + CHART_HEIGHT;
            for plot in row(&mut canvas, charts, columns, (bottom, foot))? {
                let legend = Legend::of([plot.chart]);
                let (_, end) = legend.draw(&mut canvas, (plot.frame.left, foot + 2.0), plot.frame.width());
                bottom = bottom.max(end + ROWS);
            }
        }
        notes.extend(self.charts.iter().flatten().flat_map(|chart| chart.notes.clone()));
        notes.extend(self.notes.clone());
        canvas.drawing(&self.title, (WIDTH - EDGE, bottom), &notes)
    }
}
