//! One scene on one stretch: condensed once, run under every load by all nine.

use serde::{Deserialize, Serialize};

use crate::error::{Error, Kind};
use crate::mesh::Resolution;
use crate::solve::run::Run;
use crate::solve::{Change, Discretisation, Formulation, Origin};
use crate::study::atlas::Class;
use crate::study::converged::plan::{LOADS, Site, TOLERANCES, formulations};
use crate::study::records::rounded;

/// Candidate elements of a contact: beyond them elements get longer with the stretch.
const ELEMENTS: f64 = 64.0;

/// Error over the tolerance that is round-off, and recorded as none.
pub const ROUND_OFF: f64 = 1e-3;

/// One run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The scene.
    pub scene: String,
    /// Candidate stretch over the nominal half-width; 0 is the scene's own.
    pub stretch: f64,
    /// Load over the nominal one.
    pub load: f64,
    /// `element.algorithm`.
    pub formulation: String,
    /// Tolerance.
    pub tolerance: f64,
    /// How it ended.
    pub class: Class,
    /// Steps made.
    pub steps: usize,
    /// Largest error of p₀ and a against the solution of the same discrete problem; 0 where it is round-off, NaN where
    /// there is none.
    pub error: f64,
}

/// All runs of a site; none where its surfaces are shorter than the stretch.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let Some(discretisation) = discretised(site)? else { return Ok(Vec::new()) };
    let mut records = Vec::new();
    for load in LOADS {
        for tolerance in TOLERANCES {
            records.extend(
                formulations(tolerance).iter().filter_map(|formulation| one(site, &discretisation, load, formulation)),
            );
        }
    }
    Ok(records)
}

/// The scene with its candidates as long as the site asks.
fn discretised(site: &Site) -> Result<Option<Discretisation>, Error> {
    let problem = site.problem()?;
    let (mut scene, resolution) = (problem.scene, problem.resolution);
    if site.stretch <= 0.0 {
        return Discretisation::of(scene, resolution).map(Some);
    }
    let nominal = Run::of(&Discretisation::of(scene.clone(), resolution)?, &Formulation::verification())?;
    let mut elements = 0.0_f64;
    for (pair, contact) in scene.contacts.iter_mut().zip(&nominal.contacts) {
        pair.stretch = site.stretch * contact.measures.edge().abs().max(contact.measures.begin().abs());
        elements = elements.max(resolution.elements as f64 * pair.stretch * pair.path.metric() / scene.grading.unit);
    }
    scene.grading.unit *= (elements / ELEMENTS).max(1.0);
    let resolution = Resolution { elements: resolution.elements, ..resolution };
    // A surface that is too short is no site; what else may be wrong shows on the scene's own stretch.
    Ok(Discretisation::of(scene, resolution).ok())
}

/// A run; none where the formulation is not defined for the scene, or nothing presses.
fn one(site: &Site, discretisation: &Discretisation, load: f64, formulation: &Formulation) -> Option<Record> {
    let record = |class, steps, error| Record {
        scene: site.scene(),
        stretch: site.stretch,
        load,
        formulation: formulation.name(),
        tolerance: formulation.settings.tolerance,
        class,
        steps,
        error: if error < ROUND_OFF * formulation.settings.tolerance { 0.0 } else { rounded(error) },
    };
    match Run::from_origin(Origin::Own, discretisation, formulation, Change { load, ..Change::NONE }) {
        Ok(run) => {
            let error = run.iteration_error();
            Some(record(Class::of(run.solution.outcome), run.solution.work.steps, error))
        }
        Err(Error { kind: Kind::NoSpringLeft { steps }, .. }) => Some(record(Class::Unsupported, steps, f64::NAN)),
        Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => Some(record(Class::Spilled, 0, f64::NAN)),
        Err(_) => None,
    }
}
