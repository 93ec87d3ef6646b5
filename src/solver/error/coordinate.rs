//! A contact coordinate as messages give it.

use std::fmt;

/// A contact coordinate: a length, printed in mm, or an angle, printed in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coordinate {
    /// Along a straight path \[mm\].
    Length(f64),
    /// Along an arc \[rad\].
    Angle(f64),
}

impl Coordinate {
    /// The number itself \[mm, or rad on an arc\].
    pub fn value(self) -> f64 {
        match self {
            Self::Length(value) | Self::Angle(value) => value,
        }
    }
}

impl fmt::Display for Coordinate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "{length:.6} mm"),
            Self::Angle(angle) => write!(f, "{:.6}°", angle.to_degrees()),
        }
    }
}
