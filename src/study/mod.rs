//! What is found out over many solves: the list of studies, and what they share.
//!
//! * [`about`] — what a study is: its name, its trials, and what is made of what they found.
//! * [`described`] — a scene in words and numbers, also in those of codes that no script of ours starts.
//! * [`sheet`] — a benchmark sheet: its page, and its values as data.
//! * [`drawn`] — colours and dashes of formulations.
//! * [`method`] — what was run and how it ended, as they are recorded.
//! * [`grouped`] — what has the same key together.
//! * [`random`] — random scenes of closed form.
//! * [`records`] — recorded surveys.
//! * [`seconds`] — on what seconds were measured, and their quantiles.
//! * [`differences`] — how far answers of other codes are apart.

pub mod about;
pub mod atlas;
pub mod cases;
pub mod cross_code;
pub mod described;
pub mod differences;
pub mod drawn;
pub mod faults;
pub mod fields;
pub mod fitted;
pub mod grouped;
pub mod independent;
pub mod limits;
pub mod measured;
pub mod method;
pub mod paper;
pub mod promised;
pub mod random;
pub mod records;
pub mod references;
pub mod refinement;
pub mod scoreboard;
pub mod seconds;
pub mod sheet;
pub mod stability;
pub mod target;
pub mod timings;

use std::any::Any;
use std::sync::Arc;

use crate::case::judged::{Judged, Verdict, worst};
use crate::error::Error;
use crate::oracle::cross_code::live::Live;
use about::{About, complete};

pub use about::{Found, Planned, Study};

/// Names and texts of files.
pub type Files = Vec<(String, String)>;

/// A study among all: what it is and does, whatever its numbers are.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    /// Name of its module, which its page has too.
    pub name: &'static str,
    /// What its page is called, what it asks, and what it cannot tell.
    pub about: About,
    /// Its trials.
    pub plan: fn() -> Vec<Trial>,
    /// Its part of the page, without the table of its checks, from all findings.
    pub section: fn(&[Finding]) -> Result<String, Error>,
    /// Its charts for light and dark pages: file names and SVG.
    pub pictures: fn(&[Finding]) -> Result<Files, Error>,
}

impl Room {
    /// All, in the order of the page.
    pub const ALL: [Self; 16] = [
        Self::of::<cases::Numbers>(),
        Self::of::<refinement::Numbers>(),
        Self::of::<measured::Numbers>(),
        Self::of::<fields::Numbers>(),
        Self::of::<cross_code::Numbers>(),
        Self::of::<independent::Numbers>(),
        Self::of::<scoreboard::Numbers>(),
        Self::of::<references::Numbers>(),
        Self::of::<paper::Numbers>(),
        Self::of::<timings::Numbers>(),
        Self::of::<promised::Numbers>(),
        Self::of::<fitted::Numbers>(),
        Self::of::<atlas::Numbers>(),
        Self::of::<stability::Numbers>(),
        Self::of::<limits::Numbers>(),
        Self::of::<faults::Numbers>(),
    ];

    const fn of<S: Study>() -> Self {
        Self {
            name: S::NAME,
            about: S::ABOUT,
            plan: || S::plan().into_iter().map(judged).collect(),
            section: |findings| S::section(&found(findings)),
            pictures: |findings| drawn::written(&S::pictures(&found(findings))?),
        }
    }
}

/// A trial of any study.
pub type Trial = Planned<Finding>;

/// What a trial found.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Name of the study that it belongs to.
    pub study: &'static str,
    /// Name of the case or study.
    pub case: String,
    /// Name of the trial.
    pub name: String,
    /// Its numbers, of the type that its study has.
    numbers: Arc<dyn Any + Send + Sync>,
    /// Checks with their verdicts.
    pub judged: Vec<Judged>,
}

impl Finding {
    /// What a trial of a study found, judged.
    pub fn of<S: Study>(case: &str, name: &str, numbers: S) -> Result<Self, Error> {
        let judged = complete(&format!("{case} × {name}"), numbers.judge()?)?;
        Ok(Self { study: S::NAME, case: case.into(), name: name.into(), numbers: Arc::new(numbers), judged })
    }

    /// Its numbers, if it is of this study.
    pub fn numbers<S: Study>(&self) -> Option<&S> {
        self.numbers.downcast_ref()
    }

    /// Worst verdict of its checks; without one it is no pass.
    pub fn verdict(&self) -> Verdict {
        worst(&self.judged).cloned().unwrap_or_else(|| Verdict::NotRun("it is reported only".into()))
    }
}

/// The trials of all studies, in the order of the page.
pub fn trials() -> Vec<Trial> {
    Room::ALL.iter().flat_map(|room| (room.plan)()).collect()
}

/// The trials of the cases that share a page.
pub fn on_page(page: &str) -> Vec<Trial> {
    cases::of_page(page).into_iter().map(judged).collect()
}

/// The finding on the error bars of all checks, made of the findings of the others.
pub fn on_bars(findings: &[Finding]) -> Result<Finding, Error> {
    let checks = findings
        .iter()
        .flat_map(|Finding { case, name, judged, .. }| judged.iter().map(move |one| (format!("{case} × {name}"), one)));
    Finding::of("error bars of checks", "all trials", promised::Numbers::of_checks(checks))
}

/// Trials that ask the other codes themselves.
pub fn live(live: Live) -> Vec<Trial> {
    let twins = cross_code::against(Some(live)).into_iter().map(judged);
    twins.chain(independent::run::against(Some(live)).into_iter().map(judged)).collect()
}

/// A trial of a study among those of all, judged.
fn judged<S: Study>(planned: Planned<S>) -> Trial {
    let (case, name) = (planned.case.clone(), planned.name.clone());
    Trial::new(case.clone(), name.clone(), move || Finding::of(&case, &name, planned.run()?))
}

/// The findings of a study among those of all.
fn found<S: Study>(findings: &[Finding]) -> Vec<Found<'_, S>> {
    let own = findings.iter().filter_map(|one| Some((one, one.numbers()?)));
    own.map(|(Finding { case, name, .. }, numbers)| Found { case, name, numbers }).collect()
}
