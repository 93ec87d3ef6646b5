//! The planes and slices of the atlas: initial stiffness against one other number.

use crate::case::Case;
use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::contact::Quadrature;
use crate::mesh::Resolution;
use crate::named::named_enum;
use crate::solve::{Element, Formulation};
use crate::study::method::Method;

/// Candidate stretch over the half-width at the centre: no node lies on the contact edge.
pub const STRETCH: f64 = 1.9;
/// Elements per half-width at the centre.
const ELEMENTS: usize = 8;
/// Elements per 10 mm of arc of the pin-rod.
const PIN_ROD_ELEMENTS: usize = 12;

named_enum! {
    /// Initial stiffness against one other number, all else at the centre: truncated Hertz, candidates to 1.9 half-widths, 8
    /// elements per half-width, one increment. The two full planes first, then the slices; the name is that of the record.
    pub enum Plane {
        /// Candidate stretch over the half-width.
        Stretch = "stretch",
        /// Elements per half-width.
        Mesh = "mesh",
        /// The cylinder.
        Cylinder = "cylinder",
        /// The pin-rod.
        PinRod = "pin-rod",
        /// Load increments.
        Increments = "increments",
        /// Thickness of the layer element over its edge length.
        Thickness = "thickness",
        /// Quadrature of line and layer elements.
        Quadrature = "quadrature",
    }
}

impl Plane {
    /// The scenes of the paper.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// What the other number is, and its values.
    fn axis(self) -> (&'static str, &'static [f64]) {
        match self {
            Self::Stretch => ("L/a", &[1.0, 1.3, 1.6, STRETCH, 2.4, 3.1, 4.0]),
            Self::Mesh => ("elements per a", &[4.0, 6.0, 8.0, 12.0, 16.0]),
            Self::Cylinder => ("elements per a", &[ELEMENTS as f64]),
            Self::PinRod => ("elements per 10 mm", &[PIN_ROD_ELEMENTS as f64]),
            Self::Increments => ("increments", &[2.0, 5.0, 10.0]),
            Self::Thickness => ("t₀ / edge length", &[1e-4, 1e-2, 1.0]),
            Self::Quadrature => ("Gauss points per edge (0: Lobatto)", &[3.0, 0.0]),
        }
    }

    /// What the other number is.
    pub fn label(self) -> &'static str {
        self.axis().0
    }

    /// The values of the other number.
    pub fn ordinates(self) -> &'static [f64] {
        self.axis().1
    }

    /// Whether it has many values of both numbers.
    pub fn is_full(self) -> bool {
        [Self::Stretch, Self::Mesh].contains(&self)
    }

    /// Whether it varies how the centre is solved: fewer initial stiffnesses, and not all of them with nodes and one increment.
    pub fn is_slice(self) -> bool {
        [Self::Increments, Self::Thickness, Self::Quadrature].contains(&self)
    }

    /// Initial stiffnesses over twelve decades: halves of them in the planes and on both paper scenes, whole ones else.
    pub fn stiffnesses(self) -> Vec<f64> {
        let halves = if self.is_slice() { 2 } else { 1 };
        (-12..=12).step_by(halves).map(|k| 10f64.powf(0.5 * f64::from(k))).collect()
    }

    /// What is run at each ordinate, in the order of the record.
    pub fn methods(self) -> Vec<Method> {
        let elements: &[Element] = match self {
            Self::Thickness => &[Element::Layer],
            Self::Quadrature => &[Element::Line, Element::Layer],
            _ => &Element::ALL,
        };
        elements.iter().flat_map(|&element| Method::of(element)).collect()
    }

    /// Its meshes, in the order of the record.
    pub fn sites(self) -> Vec<Site> {
        self.ordinates().iter().map(|&ordinate| Site { plane: self, ordinate }).collect()
    }

    /// Its lines, all but the initial stiffness fixed, in the order of the record.
    pub fn rows(self) -> Vec<(Site, Method)> {
        let methods = self.methods();
        self.sites().into_iter().flat_map(|site| methods.iter().map(move |&method| (site, method))).collect()
    }

    /// The case that the library has of it, or truncated Hertz with such candidates.
    pub fn case(self, stretch: f64) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
            _ => TruncatedHertz { stretch, ..Default::default() }.case(),
        }
    }
}

/// A plane at one of its ordinates: all that is solved on one mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// The plane.
    pub plane: Plane,
    /// The other number.
    pub ordinate: f64,
}

impl Site {
    /// Name among the unfinished ones.
    pub fn key(&self) -> String {
        format!("{}-{}", self.plane.name(), self.ordinate)
    }

    /// A method as it is run here, at an initial stiffness.
    pub fn formulation(&self, method: Method, stiffness: f64) -> Formulation {
        let mut formulation = method.formulation(stiffness);
        match self.plane {
            Plane::Increments => formulation.settings.increments = self.ordinate as usize,
            Plane::Thickness => formulation.layer_thickness = self.ordinate,
            Plane::Quadrature => {
                formulation.quadrature = if self.ordinate > 0.0 { Quadrature::GaussFull } else { Quadrature::Lobatto };
            }
            _ => {}
        }
        formulation
    }

    /// The case on its mesh.
    pub fn case(&self) -> Case {
        let (stretch, elements) = match self.plane {
            Plane::Stretch => (self.ordinate, ELEMENTS),
            Plane::Mesh | Plane::Cylinder | Plane::PinRod => (STRETCH, self.ordinate as usize),
            Plane::Increments | Plane::Thickness | Plane::Quadrature => (STRETCH, ELEMENTS),
        };
        let case = self.plane.case(stretch);
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }
}
