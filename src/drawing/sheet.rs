//! A sheet: a field above charts that stand side by side, on one card.

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::chart::Chart;
use super::drawing::Drawing;
use super::field::Field;
use super::legend::Legend;
use super::multiples::row;
use super::pen::Lettering;

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
const BETWEEN: f64 = 22.0;

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
            bottom = panels.bottom() + BETWEEN;
        }
        let columns = self.charts.iter().map(Vec::len).max().unwrap_or(1);
        for charts in &self.charts {
            let foot = bottom + CHART_HEIGHT;
            for plot in row(&mut canvas, charts, columns, (bottom, foot))? {
                let legend = Legend::of([plot.chart]);
                let (_, end) = legend.draw(&mut canvas, (plot.frame.left, foot + 2.0), plot.frame.width());
                bottom = bottom.max(end + BETWEEN);
            }
        }
        notes.extend(self.charts.iter().flatten().flat_map(|chart| chart.notes.clone()));
        notes.extend(self.notes.clone());
        canvas.drawing(&self.title, (WIDTH - EDGE, bottom), &notes)
    }
}
