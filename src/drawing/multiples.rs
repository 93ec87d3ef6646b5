//! Charts side by side: small multiples over one legend, and rows of a sheet.

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::chart::Chart;
use super::drawing::{Drawing, Error};
use super::frame::{Frame, Point};
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
    let (_, corner) = grid(&mut canvas, charts, columns)?;
    let mut notes: Vec<String> = Vec::new();
    for note in charts.iter().flat_map(|chart| &chart.notes) {
        if !notes.contains(note) {
            notes.push(note.clone());
        }
    }
    canvas.drawing(title, corner, &notes)
}

/// Draws the charts in rows over one legend; returns the plots and the lower right corner.
pub(super) fn grid<'a>(
    canvas: &mut Canvas,
    charts: &'a [Chart],
    columns: usize,
) -> Result<(Vec<Plot<'a>>, Point), Error> {
    let columns = columns.clamp(1, charts.len().max(1));
    let height = (0.82 * pitch(columns)).clamp(280.0, 345.0);
    let (mut plots, mut top) = (Vec::new(), TITLE);
    for charts in charts.chunks(columns) {
        plots.extend(row(canvas, charts, columns, (top, top + height - 8.0))?);
        top += height;
    }
    let (_, bottom) = Legend::of(charts).draw(canvas, (EDGE + 8.0, top), WIDTH - 2.0 * EDGE);
    Ok((plots, (WIDTH - EDGE, bottom + 10.0)))
}

/// Draws charts side by side below their titles, their frames in line.
pub(super) fn row<'a>(
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
