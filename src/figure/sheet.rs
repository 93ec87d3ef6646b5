//! A sheet: a field above charts that stand side by side, on one card.

use super::canvas::Canvas;
use super::chart::Chart;
use super::field::Field;
use super::field_panels::{Panels, Room};
use super::frame::Frame;
use super::legend::Legend;
use super::page::{EDGE, TITLE, TITLE_SIZE, heading, notes_height, small_print, wrapped};
use super::pen::{Lettering, text_width};
use super::plot::Plot;
use crate::error::Error;

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

const WIDTH: f64 = 920.0;
/// Room of the title of a panel.
const CAPTION: f64 = 20.0;
/// Room of the word above a detail.
const ABOVE_DETAIL: f64 = 16.0;
/// Largest height of the field, and its largest widths without and with a detail.
const TALLEST: f64 = 380.0;
const WHOLE: f64 = 740.0;
const HALF: f64 = 352.0;
const CHART_HEIGHT: f64 = 290.0;
const BETWEEN: f64 = 22.0;

impl Sheet {
    /// The sheet as SVG.
    pub fn svg(&self) -> Result<String, Error> {
        let width = WIDTH.max(text_width(&self.title, TITLE_SIZE) + 2.0 * EDGE);
        let panels = self.field.as_ref().map(|field| placed(field, width)).transpose()?;
        let charts_top = panels.as_ref().map_or(TITLE, |panels| panels.bottom() + BETWEEN);
        let columns = self.charts.iter().map(Vec::len).max().unwrap_or(0).max(1);
        let pitch = (width - 2.0 * EDGE + BETWEEN) / columns as f64;
        let rows = self.charts.iter().scan(charts_top, |top, charts| {
            let row = Row::of(charts, *top, pitch);
            *top = row.bottom() + BETWEEN;
            Some(row)
        });
        let rows: Vec<Row> = rows.collect();
        let notes = wrapped(&self.all_notes(panels.as_ref()), width - 2.0 * EDGE);
        let notes_top = rows.last().map_or(charts_top, Row::bottom) + 14.0;

        let mut canvas = Canvas::new(width, notes_top + notes_height(&notes));
        heading(&mut canvas, &self.title);
        if let (Some(field), Some(panels)) = (&self.field, &panels) {
            canvas.label((EDGE, TITLE + 0.5 * CAPTION), &field.title, Lettering::start(12.0).bold());
            panels.draw(&mut canvas);
        }
        rows.iter().try_for_each(|row| row.draw(&mut canvas))?;
        small_print(&mut canvas, &notes, notes_top);
        canvas.svg(&self.title)
    }

    fn all_notes(&self, panels: Option<&Panels<'_>>) -> Vec<String> {
        let of_field = panels.map(Panels::notes);
        let of_charts = self.charts.iter().flatten().flat_map(|chart| chart.notes.clone());
        of_field.into_iter().chain(of_charts).chain(self.notes.clone()).collect()
    }
}

/// Charts side by side, each over its own legend.
struct Row<'a> {
    charts: Vec<(&'a Chart, Legend)>,
    top: f64,
    pitch: f64,
}

impl<'a> Row<'a> {
    fn of(charts: &'a [Chart], top: f64, pitch: f64) -> Self {
        let charts = charts.iter().map(|chart| (chart, Legend::of(std::slice::from_ref(chart)))).collect();
        Self { charts, top, pitch }
    }

    fn columns(&self, legend: &Legend) -> usize {
        legend.columns(self.pitch - BETWEEN - LEGEND_INDENT)
    }

    /// Lower end of the charts, below which the legends stand.
    fn charts_bottom(&self) -> f64 {
        self.top + CAPTION + CHART_HEIGHT
    }

    fn bottom(&self) -> f64 {
        let heights = self.charts.iter().map(|(_, legend)| legend.height(self.columns(legend)));
        self.charts_bottom() + heights.fold(0.0, f64::max)
    }

    fn draw(&self, canvas: &mut Canvas) -> Result<(), Error> {
        let bottom = self.charts_bottom();
        for (place, (chart, legend)) in self.charts.iter().enumerate() {
            let left = EDGE + self.pitch * place as f64;
            let outer = Frame { left, top: self.top + CAPTION, right: left + self.pitch - BETWEEN, bottom };
            canvas.label((left, self.top + 0.5 * CAPTION), &chart.title, Lettering::start(12.0).bold());
            let inner = Plot::new(chart, outer)?.draw(canvas);
            legend.draw(canvas, (inner.left.min(left + LEGEND_INDENT), bottom + 2.0), self.columns(legend));
        }
        Ok(())
    }
}

/// Indent of a legend, that of a chart's frame or less.
const LEGEND_INDENT: f64 = 40.0;

/// The field in the middle of the width.
fn placed(field: &Field, width: f64) -> Result<Panels<'_>, Error> {
    let above = if field.zoom.is_some() { ABOVE_DETAIL } else { 4.0 };
    let largest = if field.zoom.is_some() { HALF } else { WHOLE };
    let room = |left: f64| Room { corner: (left, TITLE + CAPTION + above), panel: (largest, TALLEST) };
    let used = field.panels(&room(0.0))?.end();
    field.panels(&room((0.5 * (width - used)).max(EDGE)))
}
