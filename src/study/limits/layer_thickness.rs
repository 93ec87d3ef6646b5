//! Limit of a parameter: the thickness of the layer.

use serde::Serialize;

use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::solve::run::{Errors, Run};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Refusal;
use crate::study::limits::solved::{exceeds, hertz_errors, truncated, worst};
use crate::study::limits::written::{bracket, number, percents, range, size};

/// Thicknesses over the length of an edge.
const THICKNESSES: [f64; 7] = [1e-6, 1e-4, 1e-2, 0.05, 0.2, 0.5, 1.0];
/// Error that counts as wrong.
const WRONG: f64 = 1e-2;

/// Truncated Hertz with layers of every thickness.
#[derive(Clone, Debug, Serialize)]
pub struct LayerThickness {
    /// By thickness, under each algorithm.
    pub thicknesses: Vec<[OfAlgorithm; 3]>,
    /// The error of a layer of no thickness.
    pub refused: Refusal,
}

/// A run under one algorithm.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OfAlgorithm {
    /// How it ended.
    pub outcome: Outcome,
    /// Iterations made.
    pub iterations: usize,
    /// Errors against Hertz.
    pub errors: Errors,
}

/// Every thickness under every algorithm.
pub(super) fn run() -> Result<LayerThickness, Error> {
    let discretisation = truncated(TruncatedHertz::default(), 8, Order::Quadratic)?;
    let at = |thickness: f64| {
        let [varying, constant, kinematic] = Iteration::ALL.map(|of| of_algorithm(&discretisation, thickness, of));
        Ok([varying?, constant?, kinematic?])
    };
    Ok(LayerThickness {
        thicknesses: THICKNESSES.into_iter().map(at).collect::<Result<_, Error>>()?,
        refused: Refusal::expected(discretisation.solve(&layer(0.0, Iteration::Kinematic)), "a layer of no thickness")?,
    })
}

fn layer(layer_thickness: f64, algorithm: Iteration) -> Formulation {
    Formulation { layer_thickness, ..Formulation::new(Element::Layer, algorithm) }
}

fn of_algorithm(discretisation: &Discretisation, thickness: f64, algorithm: Iteration) -> Result<OfAlgorithm, Error> {
    let run = Run::of(discretisation, &layer(thickness, algorithm))?;
    Ok(OfAlgorithm {
        outcome: run.solution.outcome,
        iterations: run.solution.work.iterations,
        errors: hertz_errors(&discretisation.scene, &run),
    })
}

impl OfAlgorithm {
    fn cell(&self) -> String {
        let [peak, width] = percents(self.errors);
        format!("{}, {} iterations, p₀ {peak}, a {width}", self.outcome, self.iterations)
    }
}

impl LayerThickness {
    fn worst(&self) -> f64 {
        worst(self.thicknesses.iter().flatten().map(|found| found.errors))
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let check = Check::error(
            "largest error of p₀ and a with layers between 1e-6 and 1 edge length thick",
            Reference::analytic("Hertz", 0.0),
            WRONG,
            "engineering tolerance of the paper's comparison; iterations to 1e-3",
        );
        vec![check.judge(self.worst())]
    }

    pub(super) fn limit(&self) -> Limit {
        let wrong = |i: usize| exceeds(worst(self.thicknesses[i].map(|found| found.errors)), WRONG);
        let last = self.thicknesses[THICKNESSES.len() - 1][2].outcome;
        Limit {
            pushed: "thickness t₀ of the layer",
            range: format!("{}, and 0", range(&THICKNESSES, "t₀/h")),
            onset: format!(
                "errors of p₀ and a beyond {}: {}; the largest is {}",
                size(WRONG),
                bracket(&THICKNESSES, wrong, "t₀/h"),
                size(self.worst())
            ),
            seen: format!("{last}; at zero {}", self.refused),
            instead: self.refused.remedy.clone(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(thickness, runs): (f64, &[OfAlgorithm; 3])| {
            std::iter::once(number(thickness)).chain(runs.iter().map(OfAlgorithm::cell)).collect()
        };
        Detail::of(
            "Layer thickness on truncated Hertz",
            &["t₀ / h", "layer.varying", "layer.constant", "layer.kinematic"],
            THICKNESSES.into_iter().zip(&self.thicknesses).map(row),
        )
    }
}
