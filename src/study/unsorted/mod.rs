//! Studies that have no room of their own yet.

use std::sync::{Arc, OnceLock};

use crate::case::{Judged, Verdict};
use crate::case::{Problem, universal};
use crate::solve::Run;
use crate::study::cross_code::{self, Answers};
use crate::study::{family, gaertner, pictures, refinement};

use crate::error::Error;
use crate::markdown;
use crate::study::trial::{Found, Planned};
use crate::mesh::Resolution;
use crate::solve::{Discretisation, Formulation};

/// A trial.
pub type Trial = Planned<Finding>;
/// What came out.
pub type Numbers = Finding;

/// What a trial found.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// Name of the case or study.
    pub case: String,
    /// Name of the trial.
    pub name: String,
    /// The run, for trials that are one.
    pub run: Option<Run>,
    /// Checks with their verdicts.
    pub checks: Vec<Judged>,
    /// Tables for the page.
    pub tables: Vec<Table>,
    /// Curves for the page.
    pub series: Vec<Series>,
    /// Fields on meshes for the page.
    pub fields: Vec<FieldData>,
}

/// A scalar on a deformed mesh.
#[derive(Clone, Debug)]
pub struct FieldData {
    /// What is shown.
    pub title: String,
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Node lists of the cells.
    pub cells: Vec<Vec<usize>>,
    /// Values at the nodes \[MPa\].
    pub values: Vec<f64>,
    /// Displacements of the nodes \[mm\].
    pub displacements: Vec<[f64; 2]>,
}

/// A table of a study.
#[derive(Clone, Debug)]
pub struct Table {
    /// Title.
    pub title: String,
    /// Column heads.
    pub head: Vec<String>,
    /// Rows, formatted.
    pub rows: Vec<Vec<String>>,
}

/// A curve of a study; abscissae without a converged run are kept apart.
#[derive(Clone, Debug)]
pub struct Series {
    /// What the curve shows; curves of one picture share it.
    pub picture: String,
    /// Name of the curve.
    pub label: String,
    /// Points.
    pub points: Vec<[f64; 2]>,
    /// Abscissae of runs that did not converge.
    pub failed: Vec<f64>,
}

/// All trials.
pub fn plan() -> Vec<Trial> {
    let named = |trial: Trial| {
        let (case, name) = (trial.case.clone(), trial.name.clone());
        Trial::new(case.clone(), name.clone(), move || {
            Ok(Finding { case: case.clone(), name: name.clone(), ..trial.run()? })
        })
    };
    all().into_iter().map(named).collect()
}

/// The checks.
pub fn judge(numbers: &Finding) -> Result<Vec<Judged>, Error> {
    Ok(numbers.checks.clone())
}

/// Nothing: the page has its sections.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    Ok(String::new())
}

/// Nothing: the page has its charts.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    Ok(Vec::new())
}

impl Finding {
    /// Worst verdict: a failure, else a check not run, else a pass.
    pub fn verdict(&self) -> Verdict {
        if self.checks.iter().any(|check| check.verdict == Verdict::Fail) {
            return Verdict::Fail;
        }
        let absent = self.checks.iter().find(|check| matches!(check.verdict, Verdict::NotRun(_)));
        absent.map_or(Verdict::Pass, |check| check.verdict.clone())
    }
}

/// What judges a run of a case against its truth; none where a run is reported, not gated.
pub type Judge = Option<fn(&Problem, &Discretisation, &Run) -> Result<Vec<Judged>, Error>>;

/// Trials of one problem under several formulations; they share one condensation.
pub fn trials(
    case: &str,
    problem: Problem,
    resolution: Resolution,
    formulations: Vec<Formulation>,
    judge: Judge,
) -> Vec<Trial> {
    let shared: Arc<OnceLock<Result<Discretisation, Error>>> = Arc::default();
    let problem = Arc::new(problem);
    let trial = |formulation: Formulation| {
        let (shared, problem) = (shared.clone(), problem.clone());
        Trial::new(case, title(&formulation), move || {
            let discretisation = shared
                .get_or_init(|| Discretisation::of(problem.scene.clone(), resolution))
                .as_ref()
                .map_err(Error::clone)?;
            let run = Run::of(discretisation, &formulation)?;
            let mut checks: Vec<Judged> = universal::bounded(&run).into_iter().collect();
            if let Some(judge) = judge {
                checks.extend(judge(&problem, discretisation, &run)?);
                if run.solution.converged() {
                    checks.extend(universal::checks(discretisation, &run)?);
                }
            }
            Ok(Finding { run: Some(run), checks, ..Default::default() })
        })
    };
    formulations.into_iter().map(trial).collect()
}

/// Name of a trial: the formulation, and its increments and tolerance where they are not the default.
fn title(formulation: &Formulation) -> String {
    let mut title = formulation.name();
    if formulation.settings.increments > 1 {
        title += &format!(", {} increments", formulation.settings.increments);
    }
    title
}

/// Every trial of the suite, in the order of the page.
pub fn all() -> Vec<Trial> {
    let mut trials = refinement::trials();
    trials.extend(family::trials());
    trials.extend(cross_code::trials(Answers::Frozen));
    trials.extend(gaertner::trials());
    trials.extend(pictures::trials());
    trials
}

/// A study's table with its title.
pub fn titled(of: &Table) -> String {
    format!("**{}**\n\n{}", of.title, markdown::table(&of.head, &of.rows))
}

/// A study's table behind its title.
pub fn folded_table(of: &Table) -> String {
    markdown::folded(&of.title, &markdown::table(&of.head, &of.rows), false)
}
