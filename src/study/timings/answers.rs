//! What errors are held against: Hertz where he is exact, and the converged answer of its own scene for the cylinder.
//!
//! The cylinder under a uniform load is not quite Hertz's problem. Its p₀ and a are those of a mesh far finer than any that is
//! timed; between the loads that are solved so they follow a parabola in the half-width.

use crate::case::hertz;
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::timings::family::{Family, TOLERANCE};

/// Half-widths over the nominal one under which the scene is solved; those that are timed lie between.
const RATIOS: [f64; 3] = [1.0, 1.25, 1.5];
/// Elements per half-width of the finest mesh, and of the one that tells how far it is from converged.
const FINE: [usize; 2] = [64, 48];

/// p₀ and a of the scene over those of Hertz, at each of the ratios.
#[derive(Clone, Copy, Debug)]
pub struct Answers([[f64; 2]; 3]);

impl Answers {
    /// Of scenes whose answer is Hertz's.
    pub const HERTZ: Self = Self([[1.0; 2]; 3]);

    /// Of a family.
    pub fn of(family: Family) -> Result<Self, Error> {
        if family != Family::Cylinder {
            return Ok(Self::HERTZ);
        }
        let [first, second, third] = RATIOS.map(|ratio| over_hertz(ratio, FINE[0]));
        Ok(Self([first?, second?, third?]))
    }

    /// What p₀ and a of the cylinder still change by from the second finest mesh to the finest.
    pub fn unsettled() -> Result<[f64; 2], Error> {
        let [fine, coarser] = FINE.map(|elements| over_hertz(RATIOS[0], elements));
        let (fine, coarser) = (fine?, coarser?);
        Ok([0, 1].map(|k| (fine[k] - coarser[k]).abs() / fine[k]))
    }

    /// p₀ and a over those of Hertz at a ratio of half-widths, by the parabola through the three.
    pub fn at(&self, ratio: f64) -> [f64; 2] {
        let weight = |k: usize| -> f64 {
            let others = (0..RATIOS.len()).filter(|other| *other != k);
            others.map(|other| (ratio - RATIOS[other]) / (RATIOS[k] - RATIOS[other])).product()
        };
        [0, 1].map(|quantity| (0..RATIOS.len()).map(|k| weight(k) * self.0[k][quantity]).sum())
    }

    /// Relative errors of p₀ and a against the answer, and L2(p) against Hertz; NaN where the run did not converge.
    pub fn errors(&self, run: &Run, exact: &Hertz, ratio: f64) -> [f64; 3] {
        if !run.solution.converged() {
            return [f64::NAN; 3];
        }
        let [peak, half_width] = self.at(ratio);
        let (measures, [.., l2]) = (run.measures(), hertz::errors(run, exact));
        [
            (measures.peak.pressure / (peak * exact.peak_pressure()) - 1.0).abs(),
            (measures.second_moment_width / (half_width * exact.half_width()) - 1.0).abs(),
            l2,
        ]
    }
}

fn over_hertz(ratio: f64, elements: usize) -> Result<[f64; 2], Error> {
    let (scene, exact) = Family::Cylinder.loaded(ratio * Family::Cylinder.nominal());
    let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })?;
    let run = Run::of(&discretisation, &Formulation::new(Element::Node, Iteration::Kinematic).tolerance(TOLERANCE))?;
    if !run.solution.converged() {
        let found = format!("{elements} elements per half-width do not converge: {}", run.solution.outcome);
        return Err(Error::at("timings", found, "choose another mesh for the converged answer of the cylinder"));
    }
    let measures = run.measures();
    Ok([measures.peak.pressure / exact.peak_pressure(), measures.second_moment_width / exact.half_width()])
}
