//! Runs all trials with a progress bar and prints what they found.

use comfy_table::{ContentArrangement, Table, presets};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::case::{Finding, Verdict, suite};
use crate::cli::say;
use crate::error::Error;
use crate::report::{format, matrix};

/// Runs every trial, two or more at a time, in the order of the page.
pub fn run() -> Result<Vec<Finding>, Error> {
    let trials = suite::all();
    let bar = ProgressBar::new(trials.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    let findings = trials
        .par_iter()
        .map(|trial| {
            bar.set_message(trial.title());
            let finding = trial.run();
            bar.inc(1);
            finding
        })
        .collect();
    bar.finish_and_clear();
    findings
}

/// Prints one row per trial and the counts of verdicts.
pub fn print(findings: &[Finding]) {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_header(["case", "formulation", "outcome", "steps", "errors against closed forms", "verdict"]);
    for row in matrix::summary_rows(findings) {
        table.add_row(row);
    }
    say(format!("{table}"));
    let [pass, fail, not_run] = matrix::counts(findings);
    say(format!("\nchecks: {pass} passed, {fail} failed, {not_run} not run"));
    for finding in findings {
        for check in finding.checks.iter().filter(|check| check.verdict != Verdict::Pass) {
            let error = format::error(check.error);
            say(format!(
                "{} × {}: {} — {}: error {error}",
                finding.case,
                finding.name,
                format::verdict(&check.verdict),
                check.requirement
            ));
        }
    }
}

/// Whether no check failed.
pub fn all_pass(findings: &[Finding]) -> bool {
    findings.iter().all(|finding| finding.verdict() != Verdict::Fail)
}
