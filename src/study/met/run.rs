//! One scene solved to one accuracy, against the truth; and the part of the record that is solved again.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::accuracy::{self, Answer, Asked, Quantity};
use crate::error::Error;
use crate::measure::larger;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::met::NAME;
use crate::study::met::sites::{ASKED, sites};
use crate::study::random::{Family, Sample, Site};
use crate::study::records::{self, rounded};

/// One of so many scenes is solved again, to the accuracies that are cheap.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 8;
/// Accuracies to which they are solved again.
const AGAIN: usize = 2;

/// The record, and a part of it solved again.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// All answers recorded.
    pub recorded: Vec<Record>,
    /// Those of the fixed part as they are now.
    pub fresh: Vec<Record>,
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Family of the scene.
    pub family: Family,
    /// Its number in the family.
    pub number: usize,
    /// Relative error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Estimated relative error, the larger one of peak and half-width; NaN where there is none.
    pub estimate: f64,
    /// Relative error of the peak, with sign; the larger one of several contacts.
    pub peak: f64,
    /// Relative error of the half-width, with sign.
    pub half_width: f64,
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
    /// Those of all meshes solved.
    pub dofs_in_all: usize,
}

impl Record {
    /// Of an answer.
    pub fn of(site: &Site, asked: f64, sample: &Sample, answer: &Answer) -> Self {
        let error = |k: usize| {
            let quantity = Quantity::ASKED[k];
            let each = answer.run.contacts.iter().enumerate();
            let errors = each.map(|(at, one)| quantity.of(&one.measures) / sample.truth(at, quantity) - 1.0);
            rounded(errors.reduce(|a, b| if a.abs() >= b.abs() || a.is_nan() { a } else { b }).unwrap_or(f64::NAN))
        };
        let [peak, half_width] = [error(0), error(1)];
        Self {
            family: site.family,
            number: site.number,
            asked,
            met: answer.unmet.is_none(),
            estimate: rounded(answer.estimate()),
            peak,
            half_width,
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
        }
    }

    /// The larger error of peak and half-width; NaN where either is.
    pub fn error(&self) -> f64 {
        larger(self.peak.abs(), self.half_width.abs())
    }

    /// Said to be met, and not so.
    pub fn is_falsely_met(&self) -> bool {
        let within = self.error() <= self.asked && self.estimate <= self.asked;
        self.met && !within
    }

    /// Said not to be met beside an estimate within what is asked.
    pub fn is_contradictory(&self) -> bool {
        !self.met && self.estimate <= self.asked
    }
}

/// A scene solved to every accuracy.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let sample = site.sample()?;
    ASKED.into_iter().map(|asked| record(site, asked, &sample)).collect()
}

/// A scene solved to one accuracy.
pub fn record(site: &Site, asked: f64, sample: &Sample) -> Result<Record, Error> {
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let answer = accuracy::solve(&sample.scene, &formulation, &Asked::new(asked))?;
    Ok(Record::of(site, asked, sample, &answer))
}

/// The record, and a fixed twentieth of its scenes once more.
pub fn numbers() -> Result<Numbers, Error> {
    let recorded = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let again: Vec<Site> = sites().into_iter().skip(FIRST).step_by(OF).collect();
    let solved = |site: &Site| -> Result<Vec<Record>, Error> {
        let sample = site.sample()?;
        ASKED.into_iter().take(AGAIN).map(|asked| record(site, asked, &sample)).collect()
    };
    let fresh = again.par_iter().map(solved).collect::<Result<Vec<_>, Error>>()?.concat();
    Ok(Numbers { recorded, fresh })
}
