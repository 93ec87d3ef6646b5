//! Runs all trials with a progress bar, and tells on a terminal what they found: first what did not pass, then the
//! passes, summed up study by study.

use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;

use rayon::prelude::*;

use crate::case::judged::worst;
use crate::case::{Judged, Verdict};
use crate::cli::json::{Answer, Line};
use crate::cli::terminal::{progress, say, table_on, width};
use crate::error::Error;
use crate::report::{study_page, told};
use crate::study::{self, Finding, Study, Trial, faults};

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

/// A check that did not pass: its verdict, its trial, and what it asked.
type Row = [String; 3];

/// Prints the checks that failed, then those that were not run, then a row for each study, and the counts of verdicts.
pub fn print(findings: &[Finding]) {
    say(text(findings, width()));
}

/// The same on so many columns.
pub fn text(findings: &[Finding], columns: u16) -> String {
    let of_trial = |finding: &Finding| {
        let title = format!("{} × {}", finding.case, finding.name);
        finding.judged.iter().filter_map(move |check| row(&title, check)).collect::<Vec<_>>()
    };
    let mut rows: Vec<(bool, Row)> = findings.iter().flat_map(of_trial).collect();
    // Failures first, each kind in the order of the page.
    rows.sort_by_key(|(failed, _)| !failed);
    let mut told = String::new();
    if !rows.is_empty() {
        let mut open = table_on(columns, ["verdict", "trial", "check"]);
        open.add_rows(rows.into_iter().map(|(_, row)| row));
        told = format!("{open}\n\n");
    }
    let [pass, fail, not_run] = told::tally(told::each(findings));
    let studies = studies(findings, columns);
    let remedy = if fail > 0 { AFTER_FAILURE } else { "" };
    let is_of_faults = findings.iter().any(|finding| finding.study == faults::Numbers::NAME);
    let rooms = is_of_faults.then(faults::rooms).and_then(Result::ok);
    let spoiled = rooms.map_or_else(String::new, |rooms| {
        format!("Mutants caught by a truth alone:\n  {}\n", faults::by_truths_alone(&rooms))
    });
    format!("{told}{studies}\n\n{remedy}{spoiled}checks: {pass} passed, {fail} failed, {not_run} not run")
}

/// Where to go from a failure.
const AFTER_FAILURE: &str = "what moved: `contact-vv report diff`; inputs: snapshots/pages\n";

/// A row of a check that did not pass, and whether it failed.
fn row(title: &str, check: &Judged) -> Option<(bool, Row)> {
    let reason = check.reason()?;
    let failed = check.verdict == Verdict::Fail;
    let sign = check.verdict.mark().told().join(" ");
    Some((failed, [sign, title.into(), format!("{}: {reason}", check.requirement())]))
}

/// A row for each study: worst verdict, trials, and its checks by verdict.
fn studies(findings: &[Finding], columns: u16) -> String {
    let mut told = table_on(columns, ["verdict", "study", "trials", "checks", "passed", "failed", "not run"]);
    for room in study_page::asked(findings) {
        let own: Vec<&Finding> = study_page::of(room.name, findings).collect();
        let judged = || own.iter().flat_map(|finding| &finding.judged);
        let sign = worst(judged()).map_or("· no check".into(), |worst| worst.mark().told().join(" "));
        let [pass, fail, not_run] = told::tally(told::once(judged()));
        let counts = [own.len(), pass + fail + not_run, pass, fail, not_run].map(|count| count.to_string());
        told.add_row([sign, room.name.replace('_', " ")].into_iter().chain(counts));
    }
    told.to_string()
}
