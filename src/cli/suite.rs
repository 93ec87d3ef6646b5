//! Runs all trials with a progress bar and prints what they found.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use comfy_table::{ContentArrangement, Table, presets};
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::case::{Judged, Verdict};
use crate::cli::terminal::{progress, say, show};
use crate::error::Error;
use crate::markdown;
use crate::report::matrix;
use crate::study::present::{MADE, Made};
use crate::study::{self, Finding, Trial};

/// Runs every trial, two or more at a time, in the order of the page; the first that breaks off ends it.
pub fn run() -> Result<Vec<Finding>, Error> {
    let mut findings = run_all(|_, _| ()).into_iter().collect::<Result<Vec<_>, Error>>()?;
    findings.push(study::on_bars(&findings)?);
    Ok(findings)
}

/// What every trial found, in the order of the page; each is told as soon as it ends.
///
/// A trial that panics takes none of the others along: each is a piece of work of its own.
fn run_all(told: impl Fn(&str, &Result<Finding, Error>) + Sync) -> Vec<Result<Finding, Error>> {
    let trials = study::trials();
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
pub fn verdicts() -> bool {
    let sound = AtomicBool::new(true);
    let told = |lines: Vec<Value>| {
        lines.iter().for_each(say);
        sound.fetch_and(lines.iter().all(|line| line["verdict"] != "fail"), Relaxed);
    };
    let of_trial = |title: &str, found: &Result<Finding, Error>| match found {
        Ok(found) => lines(title, &found.judged),
        Err(error) => vec![broken(title, error)],
    };
    let findings: Vec<Finding> =
        run_all(|title, found| told(of_trial(title, found))).into_iter().filter_map(Result::ok).collect();
    told(of_trial("error bars of checks", &study::on_bars(&findings)));
    for made in MADE {
        let title = title(&made);
        told(vec![made.check().map_or_else(|error| broken(&title, &error), |check| line(&title, &check))]);
    }
    sound.into_inner()
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
        "bar": check.bar,
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
