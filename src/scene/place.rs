//! Where on a body, and in which direction.

use std::borrow::Cow;

/// Name of a boundary: the shape's own, or one that a user gave.
pub type BoundaryName = Cow<'static, str>;

/// A named boundary of a shape, or the node at a point.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// Named boundary of the shape.
    Boundary(BoundaryName),
    /// The node at this point \[mm\].
    Point([f64; 2]),
}

/// Cartesian component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Horizontal.
    X,
    /// Vertical, positive upwards.
    Y,
}

impl Component {
    /// Index into a Cartesian vector.
    pub fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }
}
