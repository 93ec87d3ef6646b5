//! A line of a plane: all but the initial stiffness is fixed.

use crate::case::Case;
use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::contact::Quadrature;
use crate::mesh::Resolution;
use crate::solve::Formulation;
use crate::study::atlas::plane::{ELEMENTS, Plane, STRETCH};
use crate::study::method::Method;

/// One line of a plane: all but the initial stiffness is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The plane.
    pub plane: Plane,
    /// The other number.
    pub ordinate: f64,
    /// What is run.
    pub method: Method,
}

impl Plane {
    /// Its lines, in the order of the record.
    pub fn rows(self) -> Vec<Row> {
        let methods = || self.elements().iter().flat_map(|&element| Method::of(element));
        let at = |&ordinate: &f64| methods().map(move |method| Row { plane: self, ordinate, method });
        self.ordinates().iter().flat_map(at).collect()
    }
}

impl Row {
    /// The formulation at an initial stiffness.
    pub fn formulation(&self, stiffness: f64) -> Formulation {
        let mut formulation = self.method.formulation(stiffness);
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

    /// The case on its mesh.
    pub fn case(&self) -> Case {
        let case = match self.plane {
            Plane::Cylinder => Cylinder::default().case(),
            Plane::PinRod => PinRod::default().case(),
            _ => TruncatedHertz { stretch: self.stretch(), ..Default::default() }.case(),
        };
        Case { resolution: Resolution { elements: self.elements(), ..case.resolution }, ..case }
    }
}
