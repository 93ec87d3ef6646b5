//! One scene on one stretch: condensed once, run under every load by all nine; and what is judged of them.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::case::{Case, library};
use crate::error::{Error, Kind};
use crate::solve::run::Run;
use crate::solve::{Change, Discretisation, Formulation, Origin};
use crate::study::class::Class;
use crate::study::converged::NAME;
use crate::study::converged::sites::{BOUNDED, LOADS, Site, TOLERANCES, formulations, sites};
use crate::study::pairing::Pairing;
use crate::study::records::{self, rounded};

/// One of so many sites is run again.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 8;

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
    /// Contact element and algorithm.
    pub formulation: Pairing,
    /// Tolerance.
    pub tolerance: f64,
    /// How it ended.
    pub class: Class,
    /// Iterations made.
    pub iterations: usize,
    /// Largest error of p₀ and a against the solution of the same discrete problem; 0 where it is round-off, NaN where
    /// there is none.
    pub error: f64,
}

/// The record, a part of it run again, and the bound of the energy error.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// All runs recorded.
    pub recorded: Vec<Record>,
    /// The fixed part as it is now.
    pub again: Vec<Again>,
    /// Error in the energy norm and its bound of runs on scenes of the library; none where it is not known.
    pub energies: Vec<Option<Energy>>,
}

/// The runs of a site as they are now.
#[derive(Clone, Debug, Serialize)]
pub struct Again {
    /// The scene.
    pub scene: String,
    /// Candidate stretch.
    pub stretch: f64,
    /// Its runs.
    pub fresh: Vec<Record>,
}

/// Square of a run's error in the energy norm, and of its bound, over what the contact forces store.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Energy {
    /// Against the discrete solution.
    pub error: f64,
    /// From the run's own forces, gaps and penetrations.
    pub bound: f64,
}

/// The record, and a fixed twentieth of its sites once more.
pub fn numbers() -> Result<Numbers, Error> {
    let recorded = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let again: Vec<Site> = sites()?.into_iter().skip(FIRST).step_by(OF).collect();
    let run = |site: &Site| Ok(Again { scene: site.scene(), stretch: site.stretch, fresh: records(site)? });
    let again = again.par_iter().map(run).collect::<Result<_, Error>>()?;
    let energies = BOUNDED.par_iter().map(|name| energies(name)).collect::<Result<Vec<_>, _>>()?.concat();
    Ok(Numbers { recorded, again, energies })
}

/// Errors and bounds of all nine on a scene of the library.
fn energies(name: &str) -> Result<Vec<Option<Energy>>, Error> {
    let case = library::find(name, None)?;
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let energy = |formulation: &Formulation| {
        let energy = Run::of(&discretisation, formulation)?.solution.energy;
        Ok(energy.map(|energy| Energy { error: energy.error, bound: energy.bound }))
    };
    Formulation::compared().iter().map(energy).collect()
}

/// All runs of a site; none where its surfaces are shorter than the stretch.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let Some(discretisation) = discretised(site)? else { return Ok(Vec::new()) };
    let mut records = Vec::new();
    for load in LOADS {
        for tolerance in TOLERANCES {
            for formulation in formulations(tolerance) {
                records.extend(one(site, &discretisation, load, &formulation)?);
            }
        }
    }
    Ok(records)
}

/// The scene with its candidates as long as the site asks.
fn discretised(site: &Site) -> Result<Option<Discretisation>, Error> {
    let Case { mut scene, resolution, .. } = site.case()?;
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
    // A surface that is too short is no site; what else may be wrong shows on the scene's own stretch.
    Ok(Discretisation::of(scene, resolution).ok())
}

/// A run; none where the formulation is not defined for the scene, or nothing presses.
fn one(
    site: &Site,
    discretisation: &Discretisation,
    load: f64,
    formulation: &Formulation,
) -> Result<Option<Record>, Error> {
    let record = |class, iterations, error| Record {
        scene: site.scene(),
        stretch: site.stretch,
        load,
        formulation: Pairing::of(formulation),
        tolerance: formulation.settings.tolerance,
        class,
        iterations,
        error: if error < ROUND_OFF * formulation.settings.tolerance { 0.0 } else { rounded(error) },
    };
    match Run::from_origin(Origin::Own, discretisation, formulation, Change { load, ..Change::NONE }) {
        Ok(run) => {
            let error = run.iteration_error();
            Ok(Some(record(Class::of(run.solution.outcome), run.solution.work.iterations, error)))
        }
        Err(Error { kind: Kind::NoSpringLeft { iterations }, .. }) => {
            Ok(Some(record(Class::Unsupported, iterations, f64::NAN)))
        }
        Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => Ok(Some(record(Class::Beyond, 0, f64::NAN))),
        Err(Error { kind: Kind::Input | Kind::NothingPresses, .. }) => Ok(None),
        Err(error) => Err(error),
    }
}
