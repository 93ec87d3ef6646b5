//! The planes and slices of the atlas: initial stiffness against one other number.

use crate::solve::Element;

/// Candidate stretch over the half-width at the centre: no node lies on the contact edge.
pub const STRETCH: f64 = 1.9;
/// Elements per half-width at the centre.
pub(super) const ELEMENTS: usize = 8;
/// Elements per 10 mm of arc of the pin-rod.
const PIN_ROD_ELEMENTS: usize = 12;

/// Initial stiffness against one other number, all else at the centre: truncated Hertz, candidates to 1.9 half-widths, 8
/// elements per half-width, one increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub enum Plane {
    /// Candidate stretch over the half-width.
    Stretch,
    /// Elements per half-width.
    Mesh,
    /// The cylinder.
    Cylinder,
    /// The pin-rod.
    PinRod,
    /// Load increments.
    Increments,
    /// Thickness of the layer element over its edge length.
    Thickness,
    /// Quadrature of line and layer elements.
    Quadrature,
}

impl Plane {
    /// The two full planes first, then the slices.
    pub const ALL: [Self; 7] =
        [Self::Stretch, Self::Mesh, Self::Cylinder, Self::PinRod, Self::Increments, Self::Thickness, Self::Quadrature];

    /// Name of its record.
    pub fn name(self) -> &'static str {
        match self {
            Self::Stretch => "stretch",
            Self::Mesh => "mesh",
            Self::Cylinder => "cylinder",
            Self::PinRod => "pin-rod",
            Self::Increments => "increments",
            Self::Thickness => "thickness",
            Self::Quadrature => "quadrature",
        }
    }

    /// The values of the other number.
    pub fn ordinates(self) -> &'static [f64] {
        match self {
            Self::Stretch => &[1.0, 1.3, 1.6, STRETCH, 2.4, 3.1, 4.0],
            Self::Mesh => &[4.0, 6.0, 8.0, 12.0, 16.0],
            Self::Cylinder => &[ELEMENTS as f64],
            Self::PinRod => &[PIN_ROD_ELEMENTS as f64],
            Self::Increments => &[2.0, 5.0, 10.0],
            Self::Thickness => &[1e-4, 1e-2, 1.0],
            Self::Quadrature => &[3.0, 0.0],
        }
    }

    /// What the other number is.
    pub fn label(self) -> &'static str {
        match self {
            Self::Stretch => "L/a",
            Self::Mesh | Self::Cylinder => "elements per a",
            Self::PinRod => "elements per 10 mm",
            Self::Increments => "increments",
            Self::Thickness => "t₀ / edge length",
            Self::Quadrature => "Gauss points per edge (0: Lobatto)",
        }
    }

    /// Initial stiffnesses over twelve decades: halves of them in the planes and on both paper scenes, whole ones else.
    pub fn stiffnesses(self) -> Vec<f64> {
        let halves = match self {
            Self::Increments | Self::Thickness | Self::Quadrature => 2,
            _ => 1,
        };
        (-12..=12).step_by(halves).map(|k| 10f64.powf(0.5 * f64::from(k))).collect()
    }

    /// The contact elements it is made with.
    pub(super) fn elements(self) -> &'static [Element] {
        match self {
            Self::Thickness => &[Element::Layer],
            Self::Quadrature => &[Element::Line, Element::Layer],
            _ => &Element::ALL,
        }
    }
}
