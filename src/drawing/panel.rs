//! One panel of a field.

use super::field::{Field, Window};
use super::frame::{Frame, Point};

/// One panel: where it stands, and the nodes of the mesh on the canvas.
pub(super) struct Panel<'a> {
    pub field: &'a Field,
    pub frame: Frame,
    pub nodes: Vec<Point>,
    window: Window,
    /// Display pixels per length.
    pub scale: f64,
}

impl<'a> Panel<'a> {
    /// A panel with the nodes placed, their displacements times a factor.
    pub fn of(field: &'a Field, window: Window, magnification: f64, frame: Frame) -> Panel<'a> {
        let scale = frame.width() / (window.x.1 - window.x.0);
        let mut panel = Panel { field, frame, nodes: vec![], window, scale };
        panel.nodes = field.deformed(magnification).into_iter().map(|node| panel.place(node)).collect();
        panel
    }

    /// Place of a point of the drawn shape.
    pub fn place(&self, (x, y): Point) -> Point {
        (self.frame.left + self.scale * (x - self.window.x.0), self.frame.bottom - self.scale * (y - self.window.y.0))
    }

    /// The same panel with the bodies as they were.
    pub fn undeformed(&self) -> Panel<'a> {
        Panel::of(self.field, self.window, 0.0, self.frame)
    }
}
