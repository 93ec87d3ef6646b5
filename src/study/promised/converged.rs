//! What is called converged: every scene, library and file, under all nine formulations, from candidates that hardly
//! reach beyond the contact to such that are a hundred times as long, and under loads a ten-thousandth of the scene's
//! own. No run may be called converged whose peak or half-width is not that of its own discrete problem.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::case::Case;
use crate::case::file::files_in;
use crate::case::library::{self, NAMES, TruncatedHertz};
use crate::checkout::root;
use crate::drawing::{Axis, Chart, Drawing, Series, panels};
use crate::error::{Error, Kind};
use crate::markdown;
use crate::solution::EnergyError;
use crate::solve::{Change, Discretisation, Ended, Formulation, Iteration, Run, Settings};
use crate::study::drawn;
use crate::study::grouped::in_order;
use crate::study::records::{Millionths, Survey};

/// The survey.
pub const SURVEY: Survey<Site, Record> =
    Survey { name: "converged", head, sites, key: Site::key, of: |record| record.site.key(), run: records };

/// Candidate stretches over the half-width under the nominal load; 0 is the scene's own.
const STRETCHES: [f64; 7] = [0.0, 1.05, 2.0, 5.0, 20.0, 50.0, 150.0];
/// Loads over the nominal one.
const LOADS: [f64; 3] = [1.0, 1e-2, 1e-4];
/// Tolerances: the default and one that hardly any iteration but kinematic load reaches.
const TOLERANCES: [f64; 2] = [1e-3, 1e-6];
/// A block long enough for every stretch.
const LONG: &str = "long-block";
/// Its size over the half-width.
const SIZE: f64 = 400.0;
/// Where scene files are.
const FILES: &str = "tests/cases";
/// Candidate elements of a contact: beyond them elements get longer with the stretch.
const ELEMENTS: f64 = 64.0;
/// Scenes, tolerances or loads up to which each is named.
const FEW: usize = 4;
/// Error over the tolerance that is round-off, and recorded as none.
pub const ROUND_OFF: f64 = 1e-3;

/// A scene on a candidate stretch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Site {
    /// Name in the library, that of the long block, or a scene file.
    pub scene: String,
    /// Candidate stretch over the half-width under the nominal load; 0 is the scene's own.
    pub stretch: f64,
}

/// The runs of all nine under a load and a tolerance; none where a formulation is not defined for the scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The scene on its stretch.
    pub site: Site,
    /// Load over the nominal one.
    pub load: f64,
    /// Tolerance.
    pub tolerance: f64,
    /// How each ended.
    pub classes: [Option<Ended>; 9],
    /// Iterations made.
    pub iterations: [Option<usize>; 9],
    /// Largest error of p₀ and a against the solution of the same discrete problem; 0 where it is round-off, none where
    /// there is no such solution.
    pub errors: [Option<Millionths>; 9],
}

fn head() -> Vec<String> {
    let site = ["scene", "stretch", "load", "tolerance"].map(String::from);
    let each = |what: &'static str| Formulation::nine().into_iter().map(move |one| format!("{} {what}", one.name()));
    site.into_iter().chain(each("class")).chain(each("iterations")).chain(each("error")).collect()
}

/// Every scene on every stretch: the library, the long block, the files.
fn sites() -> Result<Vec<Site>, Error> {
    let files = files_in(&root().join(FILES))?;
    let files = files.iter().filter_map(|path| Some(path.file_name()?.to_string_lossy().into_owned()));
    let library = NAMES.iter().map(|(name, _)| (*name).to_owned());
    let scenes = library.chain([LONG.to_owned()]).chain(files);
    Ok(scenes.flat_map(|scene| STRETCHES.map(|stretch| Site { scene: scene.clone(), stretch })).collect())
}

impl Site {
    /// Name of its own.
    fn key(&self) -> String {
        format!("{}-{}", self.scene, self.stretch)
    }

    /// The scene on its own stretch.
    fn case(&self) -> Result<Case, Error> {
        match self.scene.as_str() {
            LONG => Ok(TruncatedHertz { size: SIZE, ..Default::default() }.case()),
            name if NAMES.iter().any(|(known, _)| *known == name) => library::find(name, None),
            file => Case::read(&root().join(FILES).join(file)),
        }
    }

    /// The scene with its candidates as long as the site asks; none where its surfaces are shorter.
    fn discretised(&self) -> Result<Option<Discretisation>, Error> {
        let Case { mut scene, resolution, .. } = self.case()?;
        if self.stretch <= 0.0 {
            return Discretisation::of(scene, resolution).map(Some);
        }
        let nominal = Run::of(&Discretisation::of(scene.clone(), resolution)?, &Formulation::verification())?;
        let mut elements = 0.0_f64;
        for (pair, contact) in scene.contacts.iter_mut().zip(&nominal.contacts) {
            pair.stretch = self.stretch * contact.measures.edge().abs().max(contact.measures.begin().abs());
            elements =
                elements.max(resolution.elements as f64 * pair.stretch * pair.path.metric() / scene.grading.unit);
        }
        scene.grading.unit *= (elements / ELEMENTS).max(1.0);
        // A surface that is too short is no site; what else may be wrong shows on the scene's own stretch.
        Ok(Discretisation::of(scene, resolution).ok())
    }
}

/// All runs of a site: condensed once, under every load and tolerance; none where nothing presses.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let Some(discretisation) = site.discretised()? else { return Ok(Vec::new()) };
    let mut records = Vec::new();
    for [load, tolerance] in LOADS.into_iter().flat_map(|load| TOLERANCES.map(|tolerance| [load, tolerance])) {
        let (classes, iterations, errors) = ([None; 9], [None; 9], [None; 9]);
        let mut record = Record { site: site.clone(), load, tolerance, classes, iterations, errors };
        for (k, formulation) in Formulation::nine().into_iter().enumerate() {
            let formulation = formulation.tolerance(tolerance);
            let run = Run::from(None, &discretisation, &formulation, Change { load, ..Change::NONE });
            if let Err(Error { kind: Kind::Input | Kind::NothingPresses, .. }) = run {
                continue;
            }
            let (class, iterations) = Ended::of(&run)?;
            let error = run.ok().map(|run| match run.iteration_error() {
                error if error < ROUND_OFF * tolerance => Millionths(0.0),
                error => Millionths(error),
            });
            (record.classes[k], record.iterations[k], record.errors[k]) = (Some(class), Some(iterations), error);
        }
        records.extend(record.classes.iter().any(Option::is_some).then_some(record));
    }
    Ok(records)
}

/// Scenes of the library on which the bound of the energy error is measured, under all nine formulations.
const BOUNDED: [&str; 5] = ["cylinder", "truncated-hertz", "pin-rod", "bars", "flat-punch"];

/// Errors in the energy norm and their bounds of all nine on scenes of the library; none where they are not known.
pub(super) fn energies() -> Result<Vec<Option<EnergyError>>, Error> {
    let of_scene = |name: &&str| {
        let case = library::find(name, None)?;
        let discretisation = Discretisation::of(case.scene, case.resolution)?;
        let energy = |formulation: &Formulation| Ok(Run::of(&discretisation, formulation)?.solution.energy);
        Formulation::compared().iter().map(energy).collect::<Result<Vec<_>, Error>>()
    };
    Ok(BOUNDED.par_iter().map(of_scene).collect::<Result<Vec<_>, Error>>()?.concat())
}

/// Share of the runs of one of the nine that converge, of the records that are meant; none of no runs.
fn share(recorded: &[Record], formulation: usize, is_meant: impl Fn(&Record) -> bool) -> Option<f64> {
    let classes = recorded.iter().filter(|record| is_meant(record)).filter_map(|record| record.classes[formulation]);
    let ended: Vec<bool> = classes.map(|class| class == Ended::Converged).collect();
    let converged = ended.iter().filter(|converged| **converged).count();
    (!ended.is_empty()).then(|| converged as f64 / ended.len() as f64)
}

/// How every run of the default formulation ended: how many so, within which tolerances, under which loads, and on
/// which scenes.
pub fn of_default(recorded: &[Record]) -> String {
    let own = Formulation::nine().iter().position(|one| one.is_like(&Formulation::verification()));
    let ended = in_order(recorded.iter().filter_map(|record| Some((record.classes[own?]?, record))));
    let listed = |of: &dyn Fn(&Record) -> String, records: &[&Record]| {
        let all = in_order(records.iter().map(|record| (of(record), ())));
        match all.len() {
            0..=FEW => all.into_iter().map(|(name, _)| name).collect::<Vec<_>>().join(", "),
            many => many.to_string(),
        }
    };
    let row = |(ended, records): &(Ended, Vec<&Record>)| {
        let tolerances = listed(&|record| format!("{:e}", record.tolerance), records);
        let loads = listed(&|record| record.load.to_string(), records);
        let scenes = listed(&|record| record.site.scene.clone(), records);
        vec![ended.name().into(), records.len().to_string(), tolerances, loads, scenes]
    };
    let head = ["how runs of the default end", "runs", "tolerance", "load over that of the scene", "scenes"];
    markdown::table(&head.map(String::from), &ended.iter().map(row).collect::<Vec<_>>())
}

/// Whether two numbers of the plan are the same one.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

/// The section: criterion, how loose the bound in the energy norm is, and the chart.
pub(super) fn section(recorded: &[Record], energies: &[Option<EnergyError>]) -> String {
    format!(
        include_str!("converged.md"),
        bound = bound(energies),
        size = SIZE,
        stretches = list(&STRETCHES[1..]),
        loads = list(&LOADS),
        tolerances = list(&TOLERANCES),
        limit = Settings::default().max_iterations,
        surveyed = SURVEY.told(recorded)
    ) + "\n"
        + &drawn::picture(
            "converged.svg",
            "Share of the runs that converge at the default tolerance as in the paper, without acceleration, by \
            candidate stretch, over all scenes and loads",
        )
}

/// Numbers one after the other.
fn list(numbers: &[f64]) -> String {
    let each: Vec<String> = numbers.iter().map(|x| if *x < 0.1 { format!("{x:e}") } else { x.to_string() }).collect();
    each.join(", ")
}

/// Squares of errors below this part of the stored energy are round-off, of which no bound says anything.
const ENERGY_OF_ROUND_OFF: f64 = 1e-18;

/// How far the bound `‖u − u*‖²_S ≤ Σ P h + Σ F* v + Σ T (h* − h)` is above what it bounds.
fn bound(energies: &[Option<EnergyError>]) -> String {
    let above = energies.iter().flatten().filter(|energy| energy.error > ENERGY_OF_ROUND_OFF);
    let mut ratios: Vec<f64> = above.map(|energy| (energy.bound / energy.error).sqrt()).collect();
    ratios.sort_by(f64::total_cmp);
    let [least, median, largest] = [ratios.first(), ratios.get(ratios.len() / 2), ratios.last()]
        .map(|ratio| markdown::significant(ratio.copied().unwrap_or(f64::NAN), 3));
    format!(
        include_str!("bound.md"),
        scenes = BOUNDED.join(", "),
        least = least,
        largest = largest,
        median = median,
        counted = ratios.len(),
        all = energies.len()
    ) + "\n"
}

/// Share of the runs that converge at the default tolerance against the candidate stretch, one panel an algorithm.
pub(super) fn picture(recorded: &[Record]) -> (String, Drawing) {
    let all = Formulation::nine();
    let panel = |algorithm: Iteration| {
        let share_of_runs = Axis::linear("converged [%]").over(0.0, 100.0);
        let mut chart =
            Chart::new(algorithm.name(), Axis::log("candidate stretch / a [–]").over(1.0, 150.0), share_of_runs);
        for (k, formulation) in all.iter().enumerate().filter(|(_, one)| one.algorithm == algorithm) {
            let at = |stretch: f64| {
                let is_at =
                    |record: &Record| same(record.tolerance, TOLERANCES[0]) && same(record.site.stretch, stretch);
                share(recorded, k, is_at).map(|share| [stretch, 100.0 * share])
            };
            let points = STRETCHES.into_iter().filter(|stretch| *stretch > 0.0).filter_map(at);
            chart.series.push(Series::new(drawn::label(formulation), points, drawn::style(formulation)));
        }
        chart
    };
    (
        "converged.svg".into(),
        panels("Share of the runs that converge as in the paper, without acceleration", &Iteration::ALL.map(panel), 3),
    )
}
