//! One scene solved, its errors and bars; and the part of the record that is solved again.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::accuracy::{Quantity, Subject, bars};
use crate::error::Error;
use crate::solve::{Discretisation, Element, Run};
use crate::study::coverage::NAME;
use crate::study::coverage::setup::Setup;
use crate::study::coverage::sites::sites;
use crate::study::random::{Family, Sample, Site, Truth};
use crate::study::records::{file, read, renewal, rounded};

/// One of so many scenes is solved again.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 7;

/// The record, and a part of it solved again.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// All errors and bars recorded.
    pub recorded: Vec<Record>,
    /// Those of the fixed part as they are now.
    pub fresh: Vec<Record>,
}

/// A number whose bars are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Peak pressure.
    Peak,
    /// Where it lies.
    Place,
    /// Half-width.
    HalfWidth,
    /// Second-moment width.
    SecondMomentWidth,
    /// Centre of pressure.
    Centre,
    /// Where a stretch begins or ends.
    Edge,
    /// Contact resultant, its moment, or a reaction.
    Force,
    /// Displacement or approach.
    Displacement,
    /// Largest shear stress below the contact.
    Shear,
    /// Its depth.
    Depth,
}

/// A number of a scene: its error and its bar, over the size of such a number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Family of the scene.
    pub family: Family,
    /// Its number in the family.
    pub number: usize,
    /// Nodes of a cell.
    pub cell: usize,
    /// Contact element.
    pub element: Element,
    /// Elements on half of the contact.
    pub per: f64,
    /// Which number.
    pub kind: Kind,
    /// True error; NaN where the run did not converge.
    pub error: f64,
    /// Its bar; NaN where it is not known.
    pub bar: f64,
}

impl Kind {
    /// All.
    pub const ALL: [Self; 10] = [
        Self::Peak,
        Self::Place,
        Self::HalfWidth,
        Self::SecondMomentWidth,
        Self::Centre,
        Self::Edge,
        Self::Force,
        Self::Displacement,
        Self::Shear,
        Self::Depth,
    ];

    /// Name in results.
    pub fn title(self) -> &'static str {
        match self {
            Self::Peak => "peak pressure",
            Self::Place => "place of the peak",
            Self::HalfWidth => "half-width",
            Self::SecondMomentWidth => "second-moment width",
            Self::Centre => "centre",
            Self::Edge => "ends of the contact",
            Self::Force => "forces and moment",
            Self::Displacement => "displacement and approach",
            Self::Shear => "largest shear stress",
            Self::Depth => "its depth",
        }
    }

    fn of(subject: &Subject) -> Self {
        match subject {
            Subject::Contact(_, Quantity::PeakPressure) => Self::Peak,
            Subject::Contact(_, Quantity::PeakPlace) => Self::Place,
            Subject::Contact(_, Quantity::HalfWidth) => Self::HalfWidth,
            Subject::Contact(_, Quantity::SecondMomentWidth) => Self::SecondMomentWidth,
            Subject::Contact(_, Quantity::Centre) => Self::Centre,
            Subject::Contact(_, Quantity::Begin(_) | Quantity::End(_)) => Self::Edge,
            Subject::Contact(_, Quantity::Resultant | Quantity::Moment) | Subject::Reaction(..) => Self::Force,
            Subject::Displacement(_) | Subject::Approach(_) => Self::Displacement,
            Subject::Shear(..) => Self::Shear,
            Subject::ShearDepth(..) => Self::Depth,
        }
    }
}

/// What errors of a number are relative to: the true peak, half-width, force or shear stress, the largest true displacement.
fn size(sample: &Sample, subject: &Subject, value: f64) -> f64 {
    let true_one = |quantity| sample.truth(0, quantity);
    match subject {
        Subject::Contact(_, Quantity::PeakPressure) | Subject::Reaction(..) | Subject::Shear(..) => value.abs(),
        Subject::Contact(_, Quantity::Resultant) => value,
        Subject::Contact(_, Quantity::Moment) => true_one(Quantity::Resultant) * true_one(Quantity::SecondMomentWidth),
        Subject::Contact(..) | Subject::ShearDepth(..) => true_one(Quantity::SecondMomentWidth),
        Subject::Displacement(_) | Subject::Approach(_) => {
            let own = sample.truths.iter().filter(|truth| Kind::of(&truth.subject) == Kind::Displacement);
            own.map(|truth| truth.value.abs()).fold(0.0, f64::max)
        }
    }
}

/// All numbers of a scene whose truth is known.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let sample = site.sample()?;
    let Setup { scene, resolution, formulation, per } = Setup::of(site, &sample);
    let discretisation = Discretisation::of(scene, resolution)?;
    // As it is told: without the peaks that are said to have no limit.
    let run = Run::of(&discretisation, &formulation)?.with_limits(&discretisation)?;
    let bars = bars(&discretisation, &run, &sample.displaced())?;
    let record = |truth: &Truth| {
        let size = size(&sample, &truth.subject, truth.value);
        let found = bars.all.iter().find(|one| one.subject == truth.subject && run.solution.converged());
        let [error, bar] = found.map_or([f64::NAN; 2], |one| match truth.value.is_finite() {
            true => [(one.value - truth.value).abs(), one.bar.total()],
            // What has no limit must not be quoted.
            false => [if one.value.is_nan() { 0.0 } else { f64::INFINITY }, 0.0],
        });
        let size = if truth.value.is_finite() { size } else { 1.0 };
        Record {
            family: site.family,
            number: site.number,
            cell: resolution.order.nodes_per_cell(),
            element: formulation.element,
            per: rounded(per),
            kind: Kind::of(&truth.subject),
            error: rounded(error / size),
            bar: rounded(bar / size),
        }
    };
    Ok(sample.truths.iter().map(record).collect())
}

/// The record, and a fixed twentieth of its scenes once more.
pub fn numbers() -> Result<Numbers, Error> {
    let recorded = read(&file(NAME), &renewal(NAME))?;
    let again: Vec<Site> = sites().into_iter().skip(FIRST).step_by(OF).collect();
    let fresh = again.par_iter().map(records).collect::<Result<Vec<_>, Error>>()?.concat();
    Ok(Numbers { recorded, fresh })
}
