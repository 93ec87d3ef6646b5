//! The verdict matrix: case × formulation, and the summary table of the terminal.

use crate::case::Verdict;
use crate::markdown;
use crate::solution::Outcome;
use crate::solve::{Element, Iteration};
use crate::study::{self, unsorted::Finding};

/// Names of the nine formulations, in the order of the columns.
fn columns() -> Vec<String> {
    let pairs = Element::ALL.into_iter().flat_map(|e| Iteration::ALL.map(move |a| (e, a)));
    pairs.map(|(element, algorithm)| format!("{}.{}", element.name(), algorithm.name())).collect()
}

/// Cases that are runs, each with its findings, in the order of the suite.
pub fn cases(findings: &[Finding]) -> Vec<(&str, Vec<&Finding>)> {
    group(findings.iter().filter(|finding| finding.run.is_some()))
}

/// Studies: everything that is not a run.
pub fn studies(findings: &[Finding]) -> Vec<(&str, Vec<&Finding>)> {
    group(findings.iter().filter(|finding| finding.run.is_none() && !finding.checks.is_empty()))
}

fn group<'a>(findings: impl Iterator<Item = &'a Finding>) -> Vec<(&'a str, Vec<&'a Finding>)> {
    let mut groups: Vec<(&str, Vec<&Finding>)> = Vec::new();
    for finding in findings {
        match groups.iter_mut().find(|(case, _)| *case == finding.case) {
            Some((_, members)) => members.push(finding),
            None => groups.push((&finding.case, vec![finding])),
        }
    }
    groups
}

/// The verdict matrix in Markdown: sign and steps of every case under every formulation.
pub fn verdict_matrix(findings: &[Finding]) -> String {
    let head: Vec<String> =
        std::iter::once("case".into()).chain(columns().iter().map(|name| name.replace('.', " · "))).collect();
    let rows: Vec<Vec<String>> = cases(findings)
        .iter()
        .map(|(case, members)| {
            let cells = columns().into_iter().map(|column| cell(members, &column));
            std::iter::once(case.to_string()).chain(cells).collect()
        })
        .collect();
    markdown::table(&head, &rows)
}

/// Verdicts of the studies in Markdown.
pub fn study_table(findings: &[Finding]) -> String {
    let head = ["study", "checks", "verdict"].map(String::from);
    let rows: Vec<Vec<String>> = studies(findings)
        .iter()
        .map(|(case, members)| {
            let checks: usize = members.iter().map(|finding| finding.checks.len()).sum();
            let worst = members.iter().map(|finding| finding.verdict()).max_by_key(severity).unwrap_or(Verdict::Pass);
            vec![case.to_string(), checks.to_string(), worst.to_string()]
        })
        .collect();
    markdown::table(&head, &rows)
}

fn severity(verdict: &Verdict) -> u8 {
    match verdict {
        Verdict::Pass => 0,
        Verdict::NotRun(_) => 1,
        Verdict::Fail => 2,
    }
}

fn cell(members: &[&Finding], column: &str) -> String {
    let of_column = |finding: &&&Finding| finding.name.split(',').next() == Some(column);
    let cells: Vec<String> = members.iter().filter(of_column).map(|finding| sign(finding)).collect();
    if cells.is_empty() { String::new() } else { cells.join(", ") }
}

fn sign(finding: &Finding) -> String {
    let Some(run) = &finding.run else { return String::new() };
    let sign = match finding.verdict() {
        _ if finding.checks.is_empty() => "·",
        Verdict::Pass => "✓",
        Verdict::Fail => "✗",
        Verdict::NotRun(_) => "○",
    };
    match run.solution.outcome {
        Outcome::Converged => format!("{sign} {}", run.solution.work.steps),
        other => format!("{sign} {other}"),
    }
}

/// Numbers of checks that passed, failed and were not run.
pub fn counts(findings: &[study::Finding]) -> [usize; 3] {
    let mut counts = [0; 3];
    for judged in findings.iter().flat_map(|finding| &finding.judged) {
        match judged.verdict {
            Verdict::Pass => counts[0] += 1,
            Verdict::Fail => counts[1] += 1,
            Verdict::NotRun(_) => counts[2] += 1,
        }
    }
    counts
}

/// One row per run for the terminal: case, formulation, outcome, steps, worst error over its tolerance, verdict.
pub fn summary_rows(findings: &[Finding]) -> Vec<Vec<String>> {
    findings
        .iter()
        .filter(|finding| finding.run.is_some() || !finding.checks.is_empty())
        .map(|finding| {
            let (outcome, steps) = finding.run.as_ref().map_or((String::new(), String::new()), |run| {
                (run.solution.outcome.to_string(), run.solution.work.steps.to_string())
            });
            let truth =
                finding.checks.iter().filter(|check| check.reference.kind == crate::oracle::ReferenceKind::Analytic);
            let errors = truth.map(|check| {
                let found = if check.check.tolerance > 0.0 {
                    markdown::error(check.error)
                } else {
                    markdown::significant(check.value, 3)
                };
                format!("{} {found}", check.check.quantity)
            });
            let errors = errors.collect::<Vec<_>>().join("; ");
            vec![finding.case.clone(), finding.name.clone(), outcome, steps, errors, finding.verdict().to_string()]
        })
        .collect()
}
