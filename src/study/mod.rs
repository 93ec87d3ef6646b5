//! What is found out over many solves: studies as rooms, and what they share.
//!
//! * [`about`] — what a study is called, what it asks, and what it cannot tell.
//! * [`trial`] — one piece of a study that can run alone.
//! * `rooms` — what a room must have, and how the page meets all of them.
//! * [`described`] — a scene in words and numbers.
//! * [`drawn`] — colours and dashes of formulations, and curves.
//! * [`class`](mod@class), [`method`], [`pairing`] — how a run ended and what was run, as they are recorded.
//! * [`random`] — random scenes of closed form.
//! * [`records`] — recorded surveys; [`present`] — whether what scripts record is of the present sources.
//! * [`machine`] — on what seconds were measured.
//! * [`handed_over`] — our discretisation as plain numbers, for other codes; [`answers`] — where theirs come from; [`differences`] — how far
//!   two of them are apart.

pub mod about;
pub mod answers;
pub mod atlas;
pub mod cases;
pub mod class;
pub mod cross_code;
pub mod described;
pub mod differences;
pub mod drawn;
pub mod faults;
pub mod fields;
pub mod fitted;
pub mod handed_over;
pub mod independent;
pub mod limits;
pub mod machine;
pub mod measured;
pub mod method;
pub mod pairing;
pub mod paper;
pub mod present;
pub mod promised;
pub mod random;
pub mod records;
pub mod references;
pub mod refinement;
mod rooms;
pub mod scoreboard;
pub mod stability;
pub mod timings;
pub mod trial;

use crate::case::judged::{Judged, Verdict, worst};
use crate::error::Error;
use crate::oracle::cross_code::live::Live;
use about::About;
use answers::Answers;
use rooms::rooms;

pub use trial::{Found, Planned};

rooms! {
    /// The cases of the suite.
    Cases in cases,
    /// Observed orders, the cylinder, the pin–rod and its family.
    Refinement in refinement,
    /// Digitised curves of pins, and a photograph of a disc between two plates.
    Measured in measured,
    /// Fields and iteration paths.
    Fields in fields,
    /// Other codes.
    CrossCode in cross_code,
    /// Independent codes.
    Independent in independent,
    /// Other codes on exported cases.
    Scoreboard in scoreboard,
    /// Reference answers to five digits, and benchmark sheets.
    References in references,
    /// The paper: what it says, under readings of it, and what it leaves open.
    Paper in paper,
    /// Speed against accuracy.
    Timings in timings,
    /// What is promised: converged, error bars, accuracies.
    Promised in promised,
    /// Cells of high order, fitted to the end of the contact.
    Fitted in fitted,
    /// Where methods fail: the recorded survey, and iterations on the paper's scenes.
    Atlas in atlas,
    /// Where methods fail: predicted rates and iterations.
    Stability in stability,
    /// Limits of validity.
    Limits in limits,
    /// Fault injection.
    Faults in faults,
}

/// A trial of any room.
pub type Trial = Planned<Finding>;

/// What a trial found.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The room it belongs to.
    pub room: Room,
    /// Name of the case or study.
    pub case: String,
    /// Name of the trial.
    pub name: String,
    /// Its numbers.
    pub numbers: Numbers,
    /// Checks with their verdicts.
    pub judged: Vec<Judged>,
}

impl Finding {
    /// Worst verdict of its checks; without one it is no pass.
    pub fn verdict(&self) -> Verdict {
        worst(&self.judged).cloned().unwrap_or(Verdict::Fail)
    }
}

/// The trials of all rooms, in the order of the page.
pub fn trials() -> Vec<Trial> {
    Room::ALL.iter().flat_map(|room| room.plan()).collect()
}

/// The finding on the error bars of all checks, made of the findings of the others.
pub fn on_bars(findings: &[Finding]) -> Result<Finding, Error> {
    let checks = findings
        .iter()
        .flat_map(|Finding { case, name, judged, .. }| judged.iter().map(move |one| (format!("{case} × {name}"), one)));
    let numbers = Numbers::Promised(promised::Numbers::of_checks(checks));
    let (case, name) = ("error bars of checks".to_string(), "all trials".to_string());
    let judged = trial::complete(&case, numbers.judge()?)?;
    Ok(Finding { room: Room::Promised, case, name, numbers, judged })
}

/// Trials that ask the other codes themselves.
pub fn live(live: Live) -> Vec<Trial> {
    let answers = Answers::Live(live);
    let twins = cross_code::against(answers).into_iter();
    let twins = twins.map(|planned| judged(planned, Room::CrossCode, Numbers::CrossCode));
    let others = independent::against(answers).into_iter();
    twins.chain(others.map(|planned| judged(planned, Room::Independent, Numbers::Independent))).collect()
}

/// A trial of a room among those of all, judged.
fn judged<N: 'static>(planned: Planned<N>, room: Room, numbers: fn(N) -> Numbers) -> Trial {
    let (case, name) = (planned.case.clone(), planned.name.clone());
    Trial::new(case.clone(), name.clone(), move || {
        let numbers = numbers(planned.run()?);
        let judged = trial::complete(&planned.title(), numbers.judge()?)?;
        Ok(Finding { room, case: case.clone(), name: name.clone(), numbers, judged })
    })
}
