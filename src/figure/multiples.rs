//! Small multiples: charts side by side over one legend.

use super::canvas::Canvas;
use super::chart::Chart;
use super::frame::Frame;
use super::legend::Legend;
use super::page::{EDGE, TITLE, heading, notes_height, small_print, wrapped};
use super::pen::Lettering;
use super::plot::Plot;
use crate::error::Error;

const WIDTH: f64 = 880.0;

/// Small multiples: the charts side by side, so many to a row, over one legend and all their notes.
pub fn panels(title: &str, charts: &[Chart], columns: usize) -> Result<String, Error> {
    let columns = columns.clamp(1, charts.len().max(1));
    let legend = Legend::of(charts);
    let (panel, height) = panel_size(columns);
    let rows = charts.len().div_ceil(columns) as f64;
    let legend_columns = legend.columns(WIDTH - 2.0 * EDGE);
    let notes = wrapped(&distinct_notes(charts), WIDTH - 2.0 * EDGE);
    let legend_top = TITLE + rows * height;
    let notes_top = legend_top + legend.height(legend_columns) + 10.0;
    let mut canvas = Canvas::new(WIDTH, notes_top + notes_height(&notes));
    heading(&mut canvas, title);
    for (place, chart) in charts.iter().enumerate() {
        let left = EDGE + panel * (place % columns) as f64;
        let top = TITLE + height * (place / columns) as f64;
        let outer = Frame { left, top, right: left + panel - 10.0, bottom: top + height - 8.0 };
        let inner = Plot::new(chart, Frame { top: top + 20.0, ..outer })?.draw(&mut canvas);
        canvas.label((inner.left, top + 9.0), &chart.title, Lettering::start(12.0).bold());
    }
    legend.draw(&mut canvas, (EDGE + 8.0, legend_top), legend_columns);
    small_print(&mut canvas, &notes, notes_top);
    canvas.svg(title)
}

fn panel_size(columns: usize) -> (f64, f64) {
    let width = (WIDTH - 2.0 * EDGE + 10.0) / columns as f64;
    (width, (0.82 * width).clamp(280.0, 345.0))
}

fn distinct_notes(charts: &[Chart]) -> Vec<String> {
    let mut notes: Vec<String> = Vec::new();
    for note in charts.iter().flat_map(|chart| &chart.notes) {
        if !notes.contains(note) {
            notes.push(note.clone());
        }
    }
    notes
}
