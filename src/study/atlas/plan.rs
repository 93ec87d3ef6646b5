//! Which points the atlas holds: planes and slices of initial stiffness against one other number.

use crate::algorithm::StiffnessRule;
use crate::case::library::TruncatedHertz;
use crate::case::problem::{self, Problem};
use crate::contact::Quadrature;
use crate::mesh::Resolution;
use crate::solve::{Element, Formulation, Iteration};

/// Candidate stretch over the half-width at the centre: no node lies on the contact edge.
pub const STRETCH: f64 = 1.9;
/// Elements per half-width at the centre.
const ELEMENTS: usize = 8;
/// Elements per 10 mm of arc of the pin-rod.
const PIN_ROD_ELEMENTS: usize = 12;

/// Initial stiffness against one other number, all else at the centre: truncated Hertz, candidates to 1.9 half-widths, 8
/// elements per half-width, one increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// One line of a plane: all but the initial stiffness is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The plane.
    pub plane: Plane,
    /// The other number.
    pub ordinate: f64,
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
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

    fn elements(self) -> &'static [Element] {
        match self {
            Self::Thickness => &[Element::Layer],
            Self::Quadrature => &[Element::Line, Element::Layer],
            _ => &Element::ALL,
        }
    }

    /// Its lines, in the order of the record.
    pub fn rows(self) -> Vec<Row> {
        let mut rows = Vec::new();
        for &ordinate in self.ordinates() {
            for &element in self.elements() {
                for algorithm in Iteration::ALL {
                    let rules = algorithm.rules().iter();
                    rows.extend(rules.map(|&rule| Row { plane: self, ordinate, element, algorithm, rule }));
                }
            }
        }
        rows
    }
}

impl Row {
    /// `element.algorithm.rule`, the rule always named.
    pub fn name(&self) -> String {
        format!("{}.{}.{}", self.element.name(), self.algorithm.name(), self.rule.name())
    }

    /// The formulation at an initial stiffness.
    pub fn formulation(&self, stiffness: f64) -> Formulation {
        let centre = Formulation::new(self.element, self.algorithm);
        let mut formulation = Formulation { rule: self.rule, stiffness, ..centre };
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

    /// Candidate stretch over the half-width, where the plane says it.
    fn stretch(&self) -> f64 {
        if self.plane == Plane::Stretch { self.ordinate } else { STRETCH }
    }

    /// Elements per half-width or per 10 mm.
    fn elements(&self) -> usize {
        match self.plane {
            Plane::Mesh | Plane::Cylinder | Plane::PinRod => self.ordinate as usize,
            _ => ELEMENTS,
        }
    }

    /// What rows on the same mesh share: scene, candidate stretch, elements.
    pub fn mesh(&self) -> (&'static str, u64, usize) {
        let (scene, stretch) = match self.plane {
            Plane::Cylinder | Plane::PinRod => (self.plane.name(), 0.0),
            _ => ("truncated-hertz", self.stretch()),
        };
        (scene, stretch.to_bits(), self.elements())
    }

    /// The scene and its mesh.
    pub fn problem(&self) -> Result<(Problem, Resolution), crate::error::Error> {
        let problem = match self.plane {
            Plane::Cylinder => problem::problem("cylinder", None)?,
            Plane::PinRod => problem::problem("pin-rod", None)?,
            _ => {
                let numbers = TruncatedHertz { stretch: self.stretch(), ..Default::default() };
                Problem::new("truncated-hertz", "truncated Hertz", problem::truncated_hertz(numbers))
            }
        };
        let resolution = Resolution { elements: self.elements(), ..problem.resolution };
        Ok((problem, resolution))
    }
}
