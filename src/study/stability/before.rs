//! Varying stiffness on nodes: the rate that Hertz's closed form says before anything is solved, against the measured one.

use serde::Serialize;

use crate::case::library::{Cylinder, TruncatedHertz};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Element, Iteration};
use crate::stability::rate;
use crate::study::method::Method;
use crate::study::stability::rates;

/// Candidates over the half-width, and elements per half-width.
const STRETCHES: [f64; 3] = [1.3, 1.9, 2.4];
const ELEMENTS: [usize; 3] = [4, 8, 16];

/// A scene whose half-width is known beforehand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Scene {
    /// Truncated Hertz.
    TruncatedHertz,
    /// The cylinder.
    Cylinder,
}

/// A mesh, predicted and measured.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Start {
    /// Candidate stretch over the half-width.
    pub stretch: f64,
    /// Elements per half-width.
    pub elements: usize,
    /// Place of the first node outside the contact, over the half-width; infinite where there is none.
    pub place: f64,
    /// Rate by the closed form.
    pub predicted: f64,
    /// Measured rate; none where it cannot be measured.
    pub measured: Option<f64>,
}

impl Scene {
    /// Both.
    pub const ALL: [Self; 2] = [Self::TruncatedHertz, Self::Cylinder];

    /// Name of its trial.
    pub fn name(self) -> &'static str {
        match self {
            Self::TruncatedHertz => "truncated hertz",
            Self::Cylinder => "cylinder",
        }
    }

    fn scene(self, stretch: f64) -> crate::scene::Scene {
        match self {
            Self::TruncatedHertz => TruncatedHertz { stretch, ..Default::default() }.scene(),
            Self::Cylinder => Cylinder { stretch, ..Default::default() }.scene(),
        }
    }
}

impl Start {
    /// ln ρ as measured over ln ρ by the closed form; none where it cannot be measured.
    pub fn ratio(&self) -> Option<f64> {
        self.measured.map(|measured| measured.ln() / self.predicted.ln())
    }
}

/// Every mesh of a scene.
pub fn starts(scene: Scene) -> Result<Vec<Start>, Error> {
    let meshes = STRETCHES.iter().flat_map(|&stretch| ELEMENTS.map(|elements| (stretch, elements)));
    meshes.map(|(stretch, elements)| start(scene.scene(stretch), stretch, elements)).collect()
}

fn start(scene: crate::scene::Scene, stretch: f64, elements: usize) -> Result<Start, Error> {
    let half_width = scene.reference.length;
    let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })?;
    let formulation = rates::to_the_end(Method::usual(Element::Node, Iteration::Varying), 1.0);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let outside = points.iter().map(|point| point.position / half_width).filter(|place| *place > 1.0);
    let place = outside.fold(f64::INFINITY, f64::min);
    let measured = rates::measured(&discretisation.solve(&formulation)?).map(|measured| measured.rate);
    Ok(Start { stretch, elements, place, predicted: rate::outside_hertz(place), measured })
}
