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
    let mut findings = run_all().into_iter().map(|(_, finding)| finding).collect::<Result<Vec<_>, Error>>()?;
    findings.push(study::on_bars(&findings)?);
    Ok(findings)
}

/// Every trial's title with what it found.
fn run_all() -> Vec<(String, Result<Finding, Error>)> {
    let trials = study::trials();
    let bar = progress(trials.len());
    let findings = trials
        .par_iter()
        .map(|trial| {
            bar.set_message(trial.title());
            let finding = trial.run();
            bar.inc(1);
            (trial.title(), finding)
        })
        .collect();
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

/// Prints every check of every trial as a line of JSON, and tells whether none failed.
pub fn verdicts() -> bool {
    let (mut lines, mut sound) = (Vec::new(), Vec::new());
    for (title, finding) in run_all() {
        match finding {
            Ok(finding) => {
                lines.extend(self::lines(&title, &finding.judged));
                sound.push(finding);
            }
            Err(error) => lines.push(broken(&title, &error)),
        }
    }
    match study::on_bars(&sound) {
        Ok(finding) => lines.extend(self::lines(&finding.case, &finding.judged)),
        Err(error) => lines.push(broken("error bars of checks", &error)),
    }
    for made in MADE {
        lines
            .push(made.check().map_or_else(|error| broken(&title(&made), &error), |check| line(&title(&made), &check)));
    }
    lines.iter().for_each(say);
    lines.iter().all(|line| line["verdict"] != "fail")
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
