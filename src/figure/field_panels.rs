//! The panels of a field on a page: the whole, the enlarged detail, and the colour bar beside them.

use super::bands::{Bands, paint_cell};
use super::canvas::{Canvas, Point};
use super::colour_bar::colour_bar;
use super::field::{Detail, Drawn, Field, Window};
use super::frame::Frame;
use super::mesh_lines::mesh_lines;
use super::page::EDGE;
use super::pen::text_width;
use super::view::{View, mark_detail};
use crate::error::Error;

/// Where the panels may stand: the upper left corner, and the largest width and height of one panel.
pub(super) struct Room {
    pub corner: Point,
    pub panel: (f64, f64),
}

/// One panel: the mesh as drawn in it, and where it stands.
struct Panel<'a> {
    view: View,
    drawn: Drawn<'a>,
}

/// The panels of a field, placed.
pub(super) struct Panels<'a> {
    field: &'a Field,
    bands: Bands,
    whole: Panel<'a>,
    detail: Option<Panel<'a>>,
    top: f64,
}

const BAR: f64 = 112.0;
/// Lowest end of a colour bar beside two panels, below their top.
const LOWEST: f64 = 240.0;

impl Field {
    /// Places the panels in a room.
    pub(super) fn panels(&self, room: &Room) -> Result<Panels<'_>, Error> {
        self.check()?;
        let drawn = Drawn { field: self, nodes: self.deformed(self.magnification) };
        let (left, top) = room.corner;
        let view = View::fitting(extent(&drawn), (left, top), room.panel);
        let detail = self.zoom.map(|Detail { window, magnification, .. }| Panel {
            view: View::fitting(window, (view.frame.right + 2.0 * EDGE, top), room.panel),
            drawn: Drawn { field: self, nodes: self.deformed(magnification) },
        });
        Ok(Panels { field: self, bands: self.bands()?, whole: Panel { view, drawn }, detail, top })
    }
}

impl Panels<'_> {
    /// Right end of the panels, where the colour bar begins.
    fn right(&self) -> f64 {
        self.detail.as_ref().unwrap_or(&self.whole).view.frame.right + EDGE
    }

    /// Right end with the colour bar and what is written at it.
    pub fn end(&self) -> f64 {
        self.right() + (16.0 + text_width(&self.field.quantity, 11.5)).max(BAR)
    }

    /// Lower end.
    pub fn bottom(&self) -> f64 {
        let whole = self.whole.view.frame.bottom;
        self.detail.as_ref().map_or(whole, |detail| whole.max(detail.view.frame.bottom).max(self.top + LOWEST))
    }

    /// Paints bands and mesh, marks the detail and draws the colour bar.
    pub fn draw(&self, canvas: &mut Canvas) {
        for Panel { view, drawn } in [Some(&self.whole), self.detail.as_ref()].into_iter().flatten() {
            for cell in &self.field.cells {
                paint_cell(canvas, drawn, cell, view, &self.bands);
            }
            mesh_lines(canvas, drawn, view);
        }
        if let (Some(zoom), Some(detail)) = (self.field.zoom, &self.detail) {
            mark_detail(canvas, &self.whole.view, &detail.view, zoom.marked);
        }
        let right = self.right();
        let bar = Frame { left: right + 8.0, top: self.top + 24.0, right: right + 22.0, bottom: self.bottom() };
        colour_bar(canvas, &self.bands, bar, &self.field.quantity);
    }

    /// The field's notes, the magnification of the displacements and the enlargement of the detail.
    pub fn notes(&self) -> String {
        let field = self.field;
        let mut notes = field.notes.clone();
        if field.displacements.iter().any(|shift| shift.0.hypot(shift.1) > 0.0) && field.magnification > 0.0 {
            let other = |zoom: &Detail| (zoom.magnification - field.magnification).abs() > 0.0;
            notes.push(match field.zoom.filter(other) {
                Some(zoom) => format!("Displacements ×{}, in the detail ×{}.", field.magnification, zoom.magnification),
                None => format!("Displacements ×{}.", field.magnification),
            });
        }
        if let Some(detail) = &self.detail {
            notes.push(format!("Right: the framed detail, ×{:.1}.", detail.view.scale / self.whole.view.scale));
        }
        notes.join(" ")
    }
}

/// Ends of the drawn nodes.
fn extent(drawn: &Drawn<'_>) -> Window {
    let used = || drawn.field.cells.iter().flatten().map(|&node| drawn.nodes[node]);
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    Window { x: ends(&mut used().map(|p| p.0)), y: ends(&mut used().map(|p| p.1)) }
}
