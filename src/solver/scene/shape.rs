//! The outlines the mesher knows, and how their mesh coarsens.
//!
//! Angles are measured from the downward vertical, counter-clockwise positive:
//! the point at angle `θ` and radius `r` about a centre `c` is `c + r (sin θ, −cos θ)`.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use crate::scene::contact_pair::CONTACT;
use crate::scene::{BoundaryName, Circle, Component, GivenMesh, Path};

/// Outline of a body; each names its boundaries.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Axis-parallel rectangle; boundaries `left`, `right`, `contact` and `far` (opposite to the contact).
    Rectangle {
        /// Left and right end \[mm\].
        x: [f64; 2],
        /// Lower and upper end \[mm\].
        y: [f64; 2],
        /// The side that carries the contact.
        contact: Face,
    },
    /// A disc or a sector of it; boundaries `contact` (the lower arc), `axis` (x = centre, where it ends there) and
    /// `cut` (the horizontal diameter, where it ends there); with its upper part also `top` (the upper arc) and, inside
    /// it, the line `middle` (the horizontal diameter). Turned over, it touches at its highest point.
    Disc {
        /// Centre \[mm\].
        centre: [f64; 2],
        /// Radius \[mm\].
        radius: f64,
        /// How much of it.
        sector: Sector,
        /// The side that carries the contact: `Top` is the disc seen in a mirror on the horizontal through its centre.
        contact: Face,
    },
    /// Part of a ring from the downward vertical; boundaries `start`, `end` (the straight sides), `inner`, `outer`; the
    /// side named in `contact` is called `contact` instead. On both sides of the vertical it has no `start`, and a
    /// whole one no `end`.
    Ring {
        /// Rays on which the nodes lie start here: the centre of the contact path \[mm\].
        pole: [f64; 2],
        /// Inner circle.
        inner: Circle,
        /// Outer circle.
        outer: Circle,
        /// Angle swept, on either side of the vertical where the ring lies on both \[rad\].
        sweep: f64,
        /// Whether it lies on both sides of the vertical through the pole.
        both_sides: bool,
        /// The face that carries the contact: `Bottom` is the inner one, `Top` the outer one.
        contact: Face,
    },
    /// Half a rod eye with a shank upwards; boundaries `contact` (the hole), `axis`, `end`.
    Eye {
        /// Rays on which the hole's nodes lie start here: the centre of the pin \[mm\].
        pole: [f64; 2],
        /// The hole.
        hole: Circle,
        /// Outer radius of the eye, about the hole's centre \[mm\].
        outer_radius: f64,
        /// Half the width of the shank \[mm\].
        shank_half_width: f64,
        /// Height of the shank's flat end above the hole's centre \[mm\].
        shank_end: f64,
    },
    /// Blocks that share whole sides; boundaries as they name them, one of them `contact`.
    Blocks(Vec<BlockShape>),
    /// A mesh made elsewhere; boundaries as it names them, one of them `contact`.
    Given(Arc<GivenMesh>),
}

/// A block of four sides: bottom, right, top, left, counter-clockwise, the first from corner 0 to corner 1.
#[derive(Clone, Debug)]
pub struct BlockShape {
    /// Corners, counter-clockwise \[mm\].
    pub corners: [[f64; 2]; 4],
    /// Centres of the sides that are arcs \[mm\].
    pub arcs: [Option<[f64; 2]>; 4],
    /// Names of the sides on boundaries.
    pub names: [Option<BoundaryName>; 4],
    /// Elements along bottom and top, and along left and right.
    pub elements: [usize; 2],
    /// Size ratio of neighbouring elements, from left to right and from bottom to top.
    pub growth: [f64; 2],
}

/// Parts of a disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sector {
    /// Its lower right quarter.
    Quarter,
    /// Its right half.
    RightHalf,
    /// Its lower half.
    LowerHalf,
    /// All of it.
    Whole,
}

/// Which of two opposite faces carries the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The lower, or inner, one.
    Bottom,
    /// The upper, or outer, one.
    Top,
}

/// Length of a rectangle over its height beyond which it bends like a beam: clamped ones 2.1 and 2.3 times as long as
/// high were 0.4 % off where 0.3 % was asked.
const SLENDER: f64 = 2.0;
/// Inner radius of a ring over the outer one from which on it bends: a wide plate around a hole does not.
const THIN: f64 = 0.2;

/// How elements grow away from the candidate stretch.
#[derive(Clone, Copy, Debug)]
pub struct Grading {
    /// Length that holds `N` elements of the candidate stretch: half-width \[mm\], or 10 mm of arc.
    pub unit: f64,
    /// Size ratio of neighbouring elements beyond the candidate stretch, along the surface.
    pub along: f64,
    /// Size ratio of neighbouring elements into the depth.
    pub depth: f64,
    /// Size of the first element below the surface over the size along it.
    pub first: f64,
    /// Coarsest element, as a fraction of the body's size.
    pub coarsest: f64,
    /// Size of the last candidate element over the first one: below 1 refines towards the end of the stretch.
    pub end: f64,
}

impl Shape {
    /// Whether it bends far away from what presses it, so that the cells there decide too: rings, eyes and slender
    /// rectangles. Discs in holes do not.
    pub fn bends(&self) -> bool {
        match self {
            Self::Ring { inner, outer, .. } => inner.radius >= THIN * outer.radius,
            Self::Eye { .. } => true,
            Self::Rectangle { x, y, .. } => x[1] - x[0] > SLENDER * (y[1] - y[0]),
            _ => false,
        }
    }

    /// Whether the mesh of the body is given instead of made here.
    pub fn has_given_mesh(&self) -> bool {
        matches!(self, Self::Given(_) | Self::Blocks(_))
    }

    /// The circle of a disc, or that of a ring on which one of its sides lies; none of other bodies.
    pub fn circle(&self, side: &str) -> Option<Circle> {
        match *self {
            Self::Disc { centre, radius, .. } => Some(Circle { centre, radius }),
            Self::Ring { inner, outer, contact, .. } => {
                let is_outer = side == "outer" || side == CONTACT && contact == Face::Top;
                Some(if is_outer { outer } else { inner })
            }
            _ => None,
        }
    }

    /// The coordinate that all points of a side of a rectangle have in common, and its value \[mm\]; none of other
    /// bodies.
    pub fn lies_at(&self, side: &str) -> Option<(Component, f64)> {
        let Self::Rectangle { x, y, contact } = *self else { return None };
        let contact = if contact == Face::Bottom { y } else { [y[1], y[0]] };
        match side {
            "left" => Some((Component::X, x[0])),
            "right" => Some((Component::X, x[1])),
            CONTACT => Some((Component::Y, contact[0])),
            "far" => Some((Component::Y, contact[1])),
            _ => None,
        }
    }

    /// How far a side of a disc or a ring goes along a straight path, to its outermost point at most \[mm\]; none for
    /// other bodies, which end elsewhere.
    pub fn reach(&self, side: &str, path: &Path) -> Option<f64> {
        let swept = if let Self::Ring { sweep, .. } = self { *sweep } else { FRAC_PI_2 };
        self.circle(side).filter(|_| path.is_straight()).map(|circle| circle.radius * swept.min(FRAC_PI_2).sin())
    }

    /// Names of the boundaries that supports and loads may refer to.
    pub fn boundaries(&self) -> Vec<BoundaryName> {
        let own: &[&'static str] = match self {
            Self::Rectangle { .. } => &["left", "right", "contact", "far"],
            Self::Disc { sector: Sector::Quarter, .. } => &["axis", "cut", "contact"],
            Self::Disc { sector: Sector::RightHalf, .. } => &["axis", "contact", "top", "middle"],
            Self::Disc { sector: Sector::LowerHalf, .. } => &["cut", "contact"],
            Self::Disc { sector: Sector::Whole, .. } => &["contact", "top", "middle"],
            Self::Ring { both_sides: false, .. } => &["start", "end", "inner", "outer", "contact"],
            Self::Ring { sweep, .. } if *sweep < PI => &["end", "inner", "outer", "contact"],
            Self::Ring { .. } => &["inner", "outer", "contact"],
            Self::Eye { .. } => &["contact", "axis", "end"],
            Self::Blocks(blocks) => {
                let mut names: Vec<_> = blocks.iter().flat_map(|block| block.names.iter().flatten().cloned()).collect();
                names.sort();
                names.dedup();
                return names;
            }
            Self::Given(mesh) => return mesh.boundaries.keys().cloned().collect(),
        };
        own.iter().map(|name| (*name).into()).collect()
    }
}

impl Sector {
    /// Whether it goes on above the horizontal diameter.
    pub fn has_upper_part(self) -> bool {
        matches!(self, Self::RightHalf | Self::Whole)
    }

    /// Whether it lies on both sides of the vertical diameter.
    pub fn has_both_sides(self) -> bool {
        matches!(self, Self::LowerHalf | Self::Whole)
    }
}
