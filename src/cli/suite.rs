//! Runs all trials with a progress bar and prints what they found.

use comfy_table::{ContentArrangement, Table, presets};
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::case::{Judged, Verdict};
use crate::cli::terminal::{progress, say, show};
use crate::error::Error;
use crate::markdown;
use crate::report::matrix;
use crate::study::present::{MADE, Made};
use crate::study::{self, Finding};

/// Runs every trial, two or more at a time, in the order of the page; the first that breaks off ends it.
pub fn run() -> Result<Vec<Finding>, Error> {
    let trials = study::trials();
    let bar = progress(trials.len());
    let findings: Vec<Result<Finding, Error>> = trials
        .par_iter()
        .map(|trial| {
            bar.set_message(trial.title());
            let finding = trial.run();
            bar.inc(1);
            finding
        })
        .collect();
    bar.finish_and_clear();
    findings.into_iter().collect()
}

/// Prints one row per trial and the counts of verdicts.
pub fn print(findings: &[Finding]) {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_header(["case", "formulation", "outcome", "iterations", "errors against closed forms", "verdict"]);
    for row in matrix::summary_rows(findings) {
        table.add_row(row);
    }
    say(format!("{table}"));
    let [pass, fail, not_run] = matrix::counts(findings);
    say(format!("\nchecks: {pass} passed, {fail} failed, {not_run} not run"));
    for finding in findings {
        finding
            .judged
            .iter()
            .for_each(|check| print_unless_passed(&format!("{} × {}", finding.case, finding.name), check));
    }
    for made in MADE {
        match made.check() {
            Ok(check) => print_unless_passed(&title(&made), &check),
            Err(error) => show(&error),
        }
    }
}

/// What is said here of a record, and not on the page.
fn title(made: &Made) -> String {
    format!("{}s × the present sources", made.entry)
}

fn print_unless_passed(title: &str, check: &Judged) {
    let error = match check.verdict {
        Verdict::Pass => return,
        Verdict::NotRun(_) => String::new(),
        Verdict::Fail => format!(": error {}", markdown::error(check.error)),
    };
    say(format!("{title}: {} — {}{error}", check.verdict, check.requirement()));
}

/// Prints every check of every trial as a line of JSON, a trial's as soon as it ends, and tells whether none failed.
///
/// A trial that panics takes none of the others along: each is a piece of work of its own.
pub fn verdicts() -> bool {
    let told = |lines: Vec<Value>| {
        lines.iter().for_each(say);
        lines.iter().all(|line| line["verdict"] != "fail")
    };
    let trials = study::trials();
    let all = trials.par_iter().with_max_len(1).map(|trial| {
        let title = trial.title();
        told(trial.run().map_or_else(|error| vec![broken(&title, &error)], |found| lines(&title, &found.judged)))
    });
    let sound = all.reduce(|| true, |one, other| one && other);
    let made = MADE.map(|made| {
        let title = title(&made);
        told(vec![made.check().map_or_else(|error| broken(&title, &error), |check| line(&title, &check))])
    });
    sound && made.iter().all(|sound| *sound)
}

/// The checks of a trial, a line of JSON each.
pub fn lines<'a>(title: &str, checks: impl IntoIterator<Item = &'a Judged>) -> Vec<Value> {
    checks.into_iter().map(|check| line(title, check)).collect()
}

/// The line of a trial that broke off.
pub fn broken(title: &str, error: &Error) -> Value {
    json!({ "trial": title, "verdict": "fail", "requirement": error.to_string() })
}

fn line(title: &str, check: &Judged) -> Value {
    let verdict = match check.verdict {
        Verdict::Pass => "pass",
        Verdict::Fail => "fail",
        Verdict::NotRun(_) => "not run",
    };
    json!({
        "trial": title,
        "requirement": check.requirement(),
        "quantity": check.check.quantity.to_string(),
        "kind": check.reference.kind,
        "value": check.value,
        "uncertainty": check.uncertainty,
        "reference": check.reference.value,
        "reference_uncertainty": check.reference.uncertainty,
        "error": check.error,
        "tolerance": check.check.tolerance,
        "verdict": verdict,
    })
}

/// Whether no check failed.
pub fn all_pass(findings: &[Finding]) -> bool {
    findings.iter().all(|finding| finding.verdict() != Verdict::Fail)
}
