//! What the suite found, on a terminal: first what did not pass, then the passes, summed up study by study.

use crate::case::judged::worst;
use crate::case::{Judged, Verdict};
use crate::cli::terminal::{say, table_on, width};
use crate::report::{study_page, told};
use crate::study::Finding;

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
    let [pass, fail, not_run] = told::counts(findings.iter().flat_map(|finding| &finding.judged));
    let studies = studies(findings, columns);
    let remedy = if fail > 0 { AFTER_FAILURE } else { "" };
    format!("{told}{studies}\n\n{remedy}checks: {pass} passed, {fail} failed, {not_run} not run")
}

/// Where to go from a failure.
const AFTER_FAILURE: &str = "what moved: `contact-vv report diff`; inputs: snapshots/pages\n";

/// A row of a check that did not pass, and whether it failed.
fn row(title: &str, check: &Judged) -> Option<(bool, Row)> {
    let reason = check.reason()?;
    let failed = check.verdict == Verdict::Fail;
    let sign = if failed { "✗ FAIL" } else { "○ not run" };
    Some((failed, [sign.into(), title.into(), format!("{}: {reason}", check.requirement())]))
}

/// A row for each study: worst verdict, trials, and its checks by verdict.
fn studies(findings: &[Finding], columns: u16) -> String {
    let mut told = table_on(columns, ["verdict", "study", "trials", "checks", "passed", "failed", "not run"]);
    for room in study_page::asked(findings) {
        let own: Vec<&Finding> = study_page::of(room.name, findings).collect();
        let judged = || own.iter().flat_map(|finding| &finding.judged);
        let sign = match worst(judged()) {
            Some(Verdict::Pass) => "✓ pass",
            Some(Verdict::NotRun(_)) => "○ not run",
            Some(Verdict::Fail) | None => "✗ FAIL",
        };
        let [pass, fail, not_run] = told::counts(judged());
        let counts = [own.len(), pass + fail + not_run, pass, fail, not_run].map(|count| count.to_string());
        told.add_row([sign.to_string(), room.name.replace('_', " ")].into_iter().chain(counts));
    }
    told.to_string()
}
