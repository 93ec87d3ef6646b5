//! A part of a side, by a coordinate of its points.

use std::f64::consts::{PI, TAU};

use crate::scene::place::Component;

/// A part of a side: where a coordinate of its points lies between two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidePart {
    /// The coordinate.
    pub along: Along,
    /// Where the part begins \[mm, or rad\].
    pub from: f64,
    /// Where it ends, above `from`.
    pub to: f64,
}

/// A coordinate along a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// x or y \[mm\].
    Axis(Component),
    /// Angle from the downward vertical about a point, counter-clockwise \[rad\].
    Angle {
        /// The point \[mm\].
        centre: [f64; 2],
    },
}

impl SidePart {
    /// The coordinate of a point; an angle is the one nearest to the middle of the part.
    pub fn coordinate(&self, point: [f64; 2]) -> f64 {
        match self.along {
            Along::Axis(component) => point[component.index()],
            Along::Angle { centre } => {
                let middle = 0.5 * (self.from + self.to);
                let angle = (point[0] - centre[0]).atan2(centre[1] - point[1]);
                middle + (angle - middle + PI).rem_euclid(TAU) - PI
            }
        }
    }

    /// How fast the coordinate changes along a direction at a point, but for a positive factor.
    pub fn slope(&self, point: [f64; 2], direction: [f64; 2]) -> f64 {
        match self.along {
            Along::Axis(component) => direction[component.index()],
            Along::Angle { centre } => (point[0] - centre[0]) * direction[1] - (point[1] - centre[1]) * direction[0],
        }
    }

    /// A coordinate as messages give it.
    pub fn shown(&self, coordinate: f64) -> String {
        match self.along {
            Along::Axis(component) => format!("{component} = {coordinate} mm"),
            Along::Angle { .. } => format!("{:.6}°", coordinate.to_degrees()),
        }
    }
}
