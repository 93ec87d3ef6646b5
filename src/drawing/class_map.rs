//! Maps of classes: small panels of coloured cells, regions labelled, with a boundary between cells that were predicted
//! apart.

use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::drawing::Drawing;
use super::frame::{Frame, Point};
use super::legend::Legend;
use super::palette::{CARD, CLASSES, GREY, INK, ON_CLASSES};
use super::pen::{Lettering, Pen, text_width};

/// One cell: its class, and which side of the predicted boundary it is on, if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Number of its class, which colours it.
    pub class: usize,
    /// A few characters that stand once in the region of cells that are alike.
    pub label: String,
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
    /// What columns and rows are, with their units.
    pub axes: [String; 2],
    /// Panels, row by row.
    pub panels: Vec<MapPanel>,
    /// Panels in a row.
    pub columns: usize,
    /// Column numbers that carry a tick, with its text.
    pub ticks: Vec<(usize, String)>,
    /// What each class is, from the first on.
    pub classes: Vec<String>,
    /// What the boundary is; none where there is none.
    pub boundary: Option<String>,
    /// Small print below.
    pub notes: Vec<String>,
}

const ROW: f64 = 16.0;
/// Least room for the labels of rows.
const LABELS: f64 = 30.0;
const SIZE: f64 = 10.0;
const LABEL: f64 = 8.5;
/// By how much the cells of a label are wider, so that it does not run into the next one.
const ROOM: f64 = 1.5;
/// Between a label and its row.
const GAP: f64 = 5.0;
/// Room of the title of the rows.
const SIDE: f64 = 15.0;
const HEAD: f64 = 20.0;
const FOOT: f64 = 28.0;
const BOUNDARY: f64 = 2.0;

impl ClassMap {
    /// The maps, drawn.
    pub fn drawing(&self) -> Drawing {
        let columns = self.columns.max(1);
        let pitch = (WIDTH - 2.0 * EDGE) / columns as f64;
        let names = self.panels.iter().flat_map(|panel| &panel.rows).map(|(name, _)| text_width(name, SIZE));
        let labels = SIDE + names.fold(LABELS - GAP, f64::max) + GAP;
        let (mut canvas, mut top) = (Canvas::new(), TITLE);
        for panels in self.panels.chunks(columns) {
            let tallest = panels.iter().map(|panel| panel.rows.len()).max().unwrap_or(0);
            for (place, panel) in panels.iter().enumerate() {
                let left = EDGE + pitch * place as f64 + labels;
                let bottom = top + HEAD + ROW * panel.rows.len() as f64;
                let frame = Frame { left, top: top + HEAD, right: left + pitch - labels - 12.0, bottom };
                self.panel(&mut canvas, panel, frame);
                let middle = frame.middle();
                let beside = (left - labels + 0.5 * SIDE, middle.1);
                canvas.label(beside, &self.axes[1], Lettering::middle(SIZE).upright());
                canvas.label((middle.0, bottom + 24.0), &self.axes[0], Lettering::middle(SIZE));
            }
            top += HEAD + ROW * tallest as f64 + FOOT + 8.0;
        }
        let mut legend = Legend::of_classes(&self.classes.iter().cloned().zip(CLASSES).collect::<Vec<_>>());
        legend.line(self.boundary.as_deref().unwrap_or_default(), Pen::solid(INK, BOUNDARY));
        let (_, bottom) = legend.draw(&mut canvas, (EDGE, top), WIDTH - 2.0 * EDGE);
        canvas.drawing(&self.title, (WIDTH - EDGE, bottom + 10.0), &self.notes)
    }

    fn panel(&self, canvas: &mut Canvas, panel: &MapPanel, frame: Frame) {
        canvas.label((frame.left, frame.top - 9.0), &panel.title, Lettering::start(11.5).bold());
        let count = panel.rows.first().map_or(1, |(_, cells)| cells.len().max(1));
        let x = |column: usize| frame.left + frame.width() * column as f64 / count as f64;
        let y = |row: usize| frame.bottom - ROW * row as f64;
        let rows: Vec<&[Cell]> = panel.rows.iter().map(|(_, cells)| cells.as_slice()).collect();
        for (class, colour) in CLASSES.into_iter().enumerate() {
            let square = |row: usize, column: usize| Frame {
                left: x(column),
                right: x(column + 1),
                top: y(row + 1),
                bottom: y(row),
            };
            let of_row = |(row, cells): (usize, &&[Cell])| {
                let own = cells.iter().enumerate().filter(|(_, cell)| cell.class == class);
                own.map(|(column, _)| square(row, column).corners().to_vec()).collect::<Vec<_>>()
            };
            let squares: Vec<Vec<Point>> = rows.iter().enumerate().flat_map(of_row).collect();
            if !squares.is_empty() {
                canvas.tiles(&squares, colour);
            }
        }
        for (row, (label, _)) in panel.rows.iter().enumerate() {
            canvas.label((frame.left - GAP, y(row) - 0.5 * ROW), label, Lettering::end(SIZE));
        }
        canvas.line(&frame.outline(), Pen::solid(GREY, 1.0));
        let middle = |column: usize| 0.5 * (x(column) + x(column + 1));
        let tick =
            |(column, _): &(usize, String)| [0.0, 3.5].map(|below| (middle(*column), frame.bottom + below)).to_vec();
        canvas.lines(&self.ticks.iter().map(tick).collect::<Vec<_>>(), Pen::solid(GREY, 0.8));
        for (column, text) in &self.ticks {
            canvas.label((middle(*column), frame.bottom + 10.0), text, Lettering::middle(SIZE));
        }
        let edges = boundary(&rows).into_iter().map(|ends| ends.map(|(column, row)| (x(column), y(row))).to_vec());
        let edges: Vec<_> = edges.collect();
        // On a rim of the card the line is seen on dark classes too.
        canvas.lines(&edges, Pen::solid(CARD, BOUNDARY + 1.6));
        canvas.lines(&edges, Pen::solid(INK, BOUNDARY));
        for (row, from, to) in regions(&rows) {
            let Cell { class, label, .. } = &rows[row][from];
            if !label.is_empty() && text_width(label, LABEL) + ROOM <= x(to) - x(from) {
                let middle = (0.5 * (x(from) + x(to)), y(row) - 0.5 * ROW);
                canvas.label(middle, label, Lettering::middle(LABEL).coloured(ON_CLASSES[*class]));
            }
        }
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

/// The regions of a map, cells side by side, or one above the other, that have one class and one label: of each the
/// longest stretch of cells in one row, where its label has most room, as row, first column, and the one after the
/// last.
fn regions(rows: &[&[Cell]]) -> Vec<(usize, usize, usize)> {
    let mut seen: Vec<Vec<bool>> = rows.iter().map(|cells| vec![false; cells.len()]).collect();
    let mut found = Vec::new();
    for row in 0..rows.len() {
        for column in 0..rows[row].len() {
            if !seen[row][column] {
                found.push(longest(filled(rows, (row, column), &mut seen)));
            }
        }
    }
    found
}

/// All cells of the region that a cell is in, marked as seen.
fn filled(rows: &[&[Cell]], start: (usize, usize), seen: &mut [Vec<bool>]) -> Vec<(usize, usize)> {
    let alike = |a: (usize, usize), b: (usize, usize)| {
        let [a, b] = [a, b].map(|(row, column)| &rows[row][column]);
        a.class == b.class && a.label == b.label
    };
    seen[start.0][start.1] = true;
    let (mut members, mut next) = (vec![start], 0);
    while let Some(&(row, column)) = members.get(next) {
        next += 1;
        let beside =
            [(row, column + 1), (row + 1, column), (row, column.wrapping_sub(1)), (row.wrapping_sub(1), column)];
        for place in beside {
            let inside = seen.get(place.0).is_some_and(|row| row.get(place.1) == Some(&false));
            if inside && alike(start, place) {
                seen[place.0][place.1] = true;
                members.push(place);
            }
        }
    }
    members
}

/// The longest stretch of members in one row, of equal ones that nearest to the middle row.
fn longest(mut members: Vec<(usize, usize)>) -> (usize, usize, usize) {
    members.sort_unstable();
    let middle = members[members.len() / 2].0;
    let pieces = members.chunk_by(|a, b| a.0 == b.0 && a.1 + 1 == b.1);
    let stretches = pieces.map(|piece| (piece[0].0, piece[0].1, piece[0].1 + piece.len()));
    let best = stretches.max_by_key(|(row, from, to)| (to - from, usize::MAX - row.abs_diff(middle), usize::MAX - row));
    best.unwrap_or((members[0].0, members[0].1, members[0].1 + 1))
}
