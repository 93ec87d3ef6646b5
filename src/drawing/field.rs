//! A nodal scalar on the deformed mesh, in discrete bands, with enlarged details, and each panel of it.

use super::axis::ends;
use super::drawing::Error;
use super::frame::{Frame, Point};
use super::palette::ColourMap;

/// A rectangle of the drawn (deformed) shape, in its length unit.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// Left and right end.
    pub x: (f64, f64),
    /// Lower and upper end.
    pub y: (f64, f64),
}

/// What a further panel shows enlarged.
#[derive(Clone, Debug)]
pub struct Detail {
    /// What stands above it; empty where there is no other.
    pub name: String,
    /// What of the detail's own deformed shape is shown.
    pub window: Window,
    /// Factor on the displacements in the detail.
    pub magnification: f64,
    /// Where the detail lies in the whole.
    pub marked: Window,
}

impl Detail {
    /// A window of the shape as the whole draws it, displacements times the same factor.
    pub fn of(window: Window, magnification: f64) -> Detail {
        Detail { name: String::new(), window, magnification, marked: window }
    }
}

/// A mark on the deformed bodies of a field.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A node that is fixed along a direction, outwards.
    Fixed(usize, (f64, f64)),
    /// A node that is loaded, or displaced, in a direction.
    Pushed(usize, (f64, f64)),
    /// Points of a rigid surface with the directions into it; it does not move.
    Rigid(Vec<[(f64, f64); 2]>),
}

/// Room for marks around the bodies, over the larger of their sizes.
const MARGIN: f64 = 0.06;

/// Values of the shape functions of a cell of so many nodes at (ξ, η).
pub type Shapes = fn(usize, [f64; 2]) -> Vec<f64>;

/// A nodal scalar on a mesh of quadrilaterals.
#[derive(Clone, Debug)]
pub struct Field {
    /// What is shown, in a few words.
    pub title: String,
    /// The scalar with its unit, beside the colour bar.
    pub quantity: String,
    /// Undeformed nodes, in any length unit.
    pub points: Vec<(f64, f64)>,
    /// Nodes of each cell: corners counter-clockwise, then all others in the order of its shape functions.
    pub cells: Vec<Vec<usize>>,
    /// The shape functions.
    pub shapes: Shapes,
    /// The scalar at the nodes.
    pub values: Vec<f64>,
    /// Displacements of the nodes, in the same unit.
    pub displacements: Vec<(f64, f64)>,
    /// Factor on the displacements in the drawing.
    pub magnification: f64,
    /// Colours.
    pub map: ColourMap,
    /// Ends of the colour bar; those of the values when absent.
    pub range: Option<(f64, f64)>,
    /// What further panels show enlarged.
    pub details: Vec<Detail>,
    /// Supports, loads and rigid sides.
    pub marks: Vec<Mark>,
    /// Small print below.
    pub notes: Vec<String>,
}

impl Field {
    /// Counts and numbers that fit together.
    pub(super) fn check(&self) -> Result<(), Error> {
        let (nodes, values, shifts) = (self.points.len(), self.values.len(), self.displacements.len());
        let (reason, remedy) = if values != nodes || shifts != nodes {
            (format!("{nodes} nodes, {values} values, {shifts} displacements"), "give one of each per node")
        } else if let Some(cell) =
            self.cells.iter().find(|cell| (self.shapes)(cell.len(), [0.0; 2]).len() != cell.len())
        {
            (format!("no shape functions of a cell with {} nodes", cell.len()), "give those of its element")
        } else if let Some(node) = self.cells.iter().flatten().find(|&&node| node >= nodes) {
            (format!("a cell names node {node} of {nodes}"), "count nodes from 0")
        } else if self.cells.is_empty() {
            ("no cells".to_string(), "give at least one")
        } else {
            return Ok(());
        };
        Err(Error::of(&self.title, reason, remedy))
    }

    /// Ends of the drawn shape, before and after, with room for marks.
    pub(super) fn extent(&self) -> Window {
        let nodes = [0.0, self.magnification].map(|factor| self.deformed(factor));
        let both = |of: fn(&Point) -> f64| {
            ends(self.cells.iter().flatten().flat_map(|&node| nodes.each_ref().map(|all| of(&all[node]))))
        };
        let [x, y] = [both(|at| at.0), both(|at| at.1)].map(Option::unwrap_or_default);
        let room = if self.marks.is_empty() { 0.0 } else { MARGIN * (x.1 - x.0).max(y.1 - y.0) };
        Window { x: (x.0 - room, x.1 + room), y: (y.0 - room, y.1 + room) }
    }

    /// Smallest and largest of a number of the nodes.
    pub(super) fn ends(&self, of: impl Fn(usize) -> f64) -> Option<(f64, f64)> {
        ends(self.cells.iter().flatten().map(|&node| of(node)))
    }

    /// The nodes, their displacements times a factor added.
    pub(super) fn deformed(&self, factor: f64) -> Vec<Point> {
        let moved = |(point, shift): (&Point, &Point)| (point.0 + factor * shift.0, point.1 + factor * shift.1);
        self.points.iter().zip(&self.displacements).map(moved).collect()
    }
}

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
