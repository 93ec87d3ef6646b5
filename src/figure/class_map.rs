//! Maps of classes: small panels of coloured cells, with a boundary drawn between cells that were predicted apart.

use std::collections::BTreeMap;

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::frame::{Frame, Point};
use super::legend::Legend;
use super::palette::{Colour, GREY, INK};
use super::pen::{Lettering, Pen, text_width};
use crate::error::Error;

/// One cell: how it ended, and which side of the predicted boundary it is on, if there is one.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Colour of its class.
    pub colour: Colour,
    /// Side of the predicted boundary.
    pub predicted: Option<bool>,
}

/// Rows of cells, the first at the bottom.
#[derive(Clone, Debug)]
pub struct MapPanel {
    /// What is mapped.
    pub title: String,
    /// Label and cells of each row.
    pub rows: Vec<(String, Vec<Cell>)>,
}

/// Panels side by side over one legend.
#[derive(Clone, Debug)]
pub struct ClassMap {
    /// What is shown, in a few words.
    pub title: String,
    /// Panels, row by row.
    pub panels: Vec<MapPanel>,
    /// Panels in a row.
    pub columns: usize,
    /// Column numbers that carry a tick, with its text.
    pub ticks: Vec<(usize, String)>,
    /// Classes and their colours.
    pub legend: Vec<(String, Colour)>,
    /// Small print below.
    pub notes: Vec<String>,
}

const ROW: f64 = 13.0;
/// Least room for the labels of rows.
const LABELS: f64 = 30.0;
const SIZE: f64 = 10.0;
/// Between a label and its row.
const GAP: f64 = 5.0;
const HEAD: f64 = 20.0;
const FOOT: f64 = 28.0;

impl ClassMap {
    /// The maps as SVG.
    pub fn svg(&self) -> Result<String, Error> {
        let columns = self.columns.max(1);
        let pitch = (WIDTH - 2.0 * EDGE) / columns as f64;
        let names = self.panels.iter().flat_map(|panel| &panel.rows).map(|(name, _)| text_width(name, SIZE));
        let labels = names.fold(LABELS - GAP, f64::max) + GAP;
        let (mut canvas, mut top) = (Canvas::new(), TITLE);
        for panels in self.panels.chunks(columns) {
            let tallest = panels.iter().map(|panel| panel.rows.len()).max().unwrap_or(0);
            for (place, panel) in panels.iter().enumerate() {
                let left = EDGE + pitch * place as f64 + labels;
                let bottom = top + HEAD + ROW * panel.rows.len() as f64;
                let frame = Frame { left, top: top + HEAD, right: left + pitch - labels - 12.0, bottom };
                self.panel(&mut canvas, panel, frame);
            }
            top += HEAD + ROW * tallest as f64 + FOOT;
        }
        let (_, bottom) = Legend::of_classes(&self.legend).draw(&mut canvas, (EDGE, top), WIDTH - 2.0 * EDGE);
        canvas.svg(&self.title, (WIDTH - EDGE, bottom + 10.0), &self.notes)
    }

    fn panel(&self, canvas: &mut Canvas, panel: &MapPanel, frame: Frame) {
        canvas.label((frame.left, frame.top - 9.0), &panel.title, Lettering::start(11.5).bold());
        let count = panel.rows.first().map_or(1, |(_, cells)| cells.len().max(1));
        let x = |column: usize| frame.left + frame.width() * column as f64 / count as f64;
        let y = |row: usize| frame.bottom - ROW * row as f64;
        let mut squares: BTreeMap<Colour, Vec<Vec<Point>>> = BTreeMap::new();
        for (row, (label, cells)) in panel.rows.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let square = Frame { left: x(column), right: x(column + 1), top: y(row + 1), bottom: y(row) };
                squares.entry(cell.colour).or_default().push(square.corners().to_vec());
            }
            canvas.label((frame.left - GAP, y(row) - 0.5 * ROW), label, Lettering::end(SIZE));
        }
        squares.iter().for_each(|(colour, squares)| canvas.tiles(squares, *colour));
        canvas.line(&frame.outline(), Pen::solid(GREY, 0.8));
        for (column, text) in &self.ticks {
            let middle = 0.5 * (x(*column) + x(column + 1));
            canvas.line(&[(middle, frame.bottom), (middle, frame.bottom + 3.5)], Pen::solid(GREY, 0.8));
            canvas.label((middle, frame.bottom + 11.0), text, Lettering::middle(10.0));
        }
        let rows: Vec<&[Cell]> = panel.rows.iter().map(|(_, cells)| cells.as_slice()).collect();
        let edges = boundary(&rows).into_iter().map(|ends| ends.map(|(column, row)| (x(column), y(row))).to_vec());
        canvas.lines(&edges.collect::<Vec<_>>(), Pen::solid(INK, 1.8));
    }
}

/// Corner of a cell: column and row.
type Corner = (usize, usize);

/// Cell edges between neighbours on different sides of the prediction.
fn boundary(rows: &[&[Cell]]) -> Vec<[Corner; 2]> {
    let apart = |a: &Cell, b: &Cell| a.predicted.zip(b.predicted).is_some_and(|(a, b)| a != b);
    let mut edges = Vec::new();
    for (row, cells) in rows.iter().enumerate() {
        for column in 0..cells.len() {
            if column > 0 && apart(&cells[column - 1], &cells[column]) {
                edges.push([(column, row), (column, row + 1)]);
            }
            if row > 0 && apart(&rows[row - 1][column], &cells[column]) {
                edges.push([(column, row), (column + 1, row)]);
            }
        }
    }
    edges
}
