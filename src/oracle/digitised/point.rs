//! A digitised point, and what its coordinates are.

/// A digitised point; errors are standard uncertainties (one standard deviation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Angle from the load line \[rad\], distance from it \[mm\], or force \[N\].
    pub abscissa: f64,
    /// Error of the abscissa, in its unit, above zero.
    pub abscissa_error: f64,
    /// Pressure (positive in compression) or hoop stress (tension positive) \[MPa\], or half-angle of the contact \[rad\].
    pub ordinate: f64,
    /// Error of the ordinate, in its unit, above zero.
    pub ordinate_error: f64,
}

/// What the abscissa of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Abscissa {
    /// Angle from the load line, held in radians.
    Angle,
    /// Distance from the load line \[mm\].
    Distance,
    /// Full force on the pin \[N\].
    Force,
}

/// What the ordinate of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ordinate {
    /// Contact pressure \[MPa\].
    Pressure,
    /// Circumferential stress on the rim of the hole \[MPa\].
    HoopStress,
    /// Angle from the load line at which the contact ends, held in radians.
    HalfAngle,
}
