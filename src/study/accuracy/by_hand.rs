//! Meshes made by hand, and the one that stands for the truth.

use serde::Serialize;

use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Scene};
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::accuracy::subject::{Subject, closed_form, error};

/// Loads under which a mesh made by hand must keep its error.
const LOADS: usize = 8;
/// Tolerance of the iterations on meshes made by hand.
const TOLERANCE: f64 = 1e-6;
/// Elements within the contact of the mesh that stands for the truth, and its growth.
const TRUTH: (usize, [f64; 3]) = (32, [1.2, 1.15, 0.08]);

/// A mesh made by hand: uniform or graded candidates that reach so many elements beyond the nominal contact.
#[derive(Clone, Copy, Debug)]
pub struct ByHand {
    /// Element order.
    pub order: Order,
    /// Elements within the nominal contact, were they equal.
    pub elements: usize,
    /// Elements beyond it.
    pub beyond: usize,
    /// Last candidate element over the first.
    pub end: f64,
    /// First row over the size along the surface.
    pub first: f64,
    /// Growth along and into the depth, coarsest element over the body.
    pub growth: [f64; 3],
}

/// What a mesh made by hand costs, and what it keeps.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Price {
    /// Degrees of freedom.
    pub dofs: usize,
    /// Worst error over the loads against the closed form.
    pub worst: f64,
}

impl ByHand {
    /// Worst error over the loads against the closed form, and the degrees of freedom.
    pub fn price(&self, subject: Subject) -> Result<Price, Error> {
        let mut price = Price { dofs: 0, worst: 0.0 };
        for k in 0..LOADS {
            let place = (k as f64 - 0.5 * (LOADS - 1) as f64) / LOADS as f64;
            let case = subject.loaded(1.0 + place / self.elements as f64);
            let run = self.solved(&case.scene, subject.nominal())?;
            price.worst = larger(price.worst, error(&run, closed_form(&case)));
            price.dofs = run.dofs;
        }
        Ok(price)
    }

    fn solved(&self, scene: &Scene, nominal: f64) -> Result<Run, Error> {
        let mut scene = scene.clone();
        let [along, depth, coarsest] = self.growth;
        let unit = nominal * scene.contact().path.metric();
        scene.contacts[0].stretch = nominal * (self.elements + self.beyond) as f64 / self.elements as f64;
        scene.grading = Grading { unit, along, depth, first: self.first, coarsest, end: self.end };
        let resolution = Resolution { elements: self.elements, refinement: 0, order: self.order };
        Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification().tolerance(TOLERANCE))
    }
}

/// Peak and second-moment width of the same scene on a mesh far finer than any that is answered.
pub fn truth(subject: Subject) -> Result<[f64; 2], Error> {
    let (elements, growth) = TRUTH;
    let fine = ByHand { order: Order::Quadratic, elements, beyond: elements / 8, end: 1.0, first: 1.0, growth };
    let run = fine.solved(&subject.loaded(1.0).scene, subject.nominal())?;
    Ok([run.measures().peak.pressure, run.measures().second_moment_width])
}
