//! Runs all trials with a progress bar.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use rayon::prelude::*;

use crate::case::{Judged, Verdict};
use crate::cli::json::{Answer, Line};
use crate::cli::terminal::{progress, say};
use crate::error::Error;
use crate::study::{self, Finding, Trial};

/// Runs some trials, those of a page.
pub fn of(trials: &[Trial]) -> Result<Vec<Finding>, Error> {
    run_all(trials, |_, _| ()).into_iter().collect()
}

/// Runs every trial, two or more at a time, in the order of the page; the first that breaks off ends it.
pub fn run() -> Result<Vec<Finding>, Error> {
    let mut findings = run_all(&study::trials(), |_, _| ()).into_iter().collect::<Result<Vec<_>, Error>>()?;
    findings.push(study::on_bars(&findings)?);
    Ok(findings)
}

/// What every trial found, in the order of the page; each is told as soon as it ends.
///
/// A trial that panics takes none of the others along: each is a piece of work of its own.
fn run_all(trials: &[Trial], told: impl Fn(&str, &Result<Finding, Error>) + Sync) -> Vec<Result<Finding, Error>> {
    let bar = progress(trials.len());
    let one = |trial: &Trial| {
        let title = trial.title();
        bar.set_message(title.clone());
        let found = trial.run();
        bar.inc(1);
        told(&title, &found);
        found
    };
    let findings = trials.par_iter().with_max_len(1).map(one).collect();
    bar.finish_and_clear();
    findings
}

/// Prints every check of every trial as a line of JSON, a trial's as soon as it ends, and tells whether none failed.
pub fn verdicts() -> bool {
    let sound = AtomicBool::new(true);
    let told = |lines: Vec<Line>| {
        sound.fetch_and(!lines.iter().any(Line::failed), Relaxed);
        tell(lines);
    };
    let of_trial = |title: &str, found: &Result<Finding, Error>| match found {
        Ok(found) => lines(title, &found.judged),
        Err(error) => vec![Line::broken(title, error)],
    };
    let findings: Vec<Finding> = run_all(&study::trials(), |title, found| told(of_trial(title, found)))
        .into_iter()
        .filter_map(Result::ok)
        .collect();
    told(of_trial("error bars of checks", &study::on_bars(&findings)));
    sound.into_inner()
}

/// Prints checks, a line of JSON each.
pub fn tell(lines: Vec<Line>) {
    lines.into_iter().for_each(|line| say(Answer::Line(line.into()).line()));
}

/// The checks of a trial.
pub fn lines<'a>(title: &str, checks: impl IntoIterator<Item = &'a Judged>) -> Vec<Line> {
    checks.into_iter().map(|check| Line::of(title, check)).collect()
}

/// Whether no check failed.
pub fn all_pass(findings: &[Finding]) -> bool {
    findings.iter().all(|finding| finding.verdict() != Verdict::Fail)
}
