//! Where on a body, and in which direction.

use std::borrow::Cow;
use std::fmt;

/// Name of a boundary: the shape's own, or one that a user gave.
pub type BoundaryName = Cow<'static, str>;

/// A named boundary of a shape, or the node at a point \[mm\].
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Where", description = "A place as JSON has it."))]
#[serde(untagged)]
pub enum Place {
    /// A boundary of the body.
    Boundary(BoundaryName),
    /// The node at a point.
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

/// One displacement component of a side, as its mean, or of a point of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Displaced {
    /// Index of the body.
    pub body: usize,
    /// The side, or any point of the body \[mm\].
    pub at: Place,
    /// Which component, positive along x or y.
    pub component: Component,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Boundary(name) => f.write_str(name),
            Self::Point([x, y]) => write!(f, "({x}, {y})"),
        }
    }
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Component {
    /// `x` or `y`.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }

    /// Index into a Cartesian vector.
    pub fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }
}
