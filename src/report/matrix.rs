//! The verdict matrix, and the tables of verdicts by kind and by study.

use crate::case::judged::worst;
use crate::case::{Judged, Verdict};
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::solution::Outcome;
use crate::solve::{Element, Iteration, Run};
use crate::study::{Finding, Numbers};

/// The run of a finding that is one.
fn run(finding: &Finding) -> Option<&Run> {
    match &finding.numbers {
        Numbers::Cases(numbers) => Some(&numbers.run),
        _ => None,
    }
}

/// All runs of cases.
pub fn runs(findings: &[Finding]) -> impl Iterator<Item = &Run> {
    findings.iter().filter_map(run)
}

/// Findings by case, in the order of the suite.
fn by_case<'a>(findings: impl Iterator<Item = &'a Finding>) -> Vec<(&'a str, Vec<&'a Finding>)> {
    let mut groups: Vec<(&str, Vec<&Finding>)> = Vec::new();
    for finding in findings {
        match groups.iter_mut().find(|(case, _)| *case == finding.case) {
            Some((_, members)) => members.push(finding),
            None => groups.push((&finding.case, vec![finding])),
        }
    }
    groups
}

/// The verdict matrix in Markdown: sign and iterations of every case under every formulation.
pub fn verdict_matrix(findings: &[Finding]) -> String {
    let columns: Vec<(Element, Iteration)> =
        Element::ALL.into_iter().flat_map(|e| Iteration::ALL.map(move |a| (e, a))).collect();
    let names = columns.iter().map(|(element, algorithm)| format!("{} · {}", element.name(), algorithm.name()));
    let head: Vec<String> = std::iter::once("case".into()).chain(names).collect();
    let cases = by_case(findings.iter().filter(|finding| run(finding).is_some()));
    let row = |(case, members): &(&str, Vec<&Finding>)| {
        let cells = columns.iter().map(|column| cell(members, *column));
        std::iter::once(case.to_string()).chain(cells).collect()
    };
    markdown::table(&head, &cases.iter().map(row).collect::<Vec<_>>())
}

fn cell(members: &[&Finding], (element, algorithm): (Element, Iteration)) -> String {
    let of_column = |finding: &&&Finding| {
        run(finding).is_some_and(|run| run.formulation.element == element && run.formulation.algorithm == algorithm)
    };
    members.iter().filter(of_column).map(|finding| sign(finding)).collect::<Vec<_>>().join(", ")
}

fn sign(finding: &Finding) -> String {
    let Numbers::Cases(numbers) = &finding.numbers else { return String::new() };
    let sign = match finding.verdict() {
        _ if numbers.case.is_reported() => "·",
        Verdict::Pass => "✓",
        Verdict::Fail => "✗",
        Verdict::NotRun(_) => "○",
    };
    match numbers.run.solution.outcome {
        Outcome::Converged => format!("{sign} {}", numbers.run.solution.work.iterations),
        other => format!("{sign} {other}"),
    }
}

/// Verdicts of the studies in Markdown.
pub fn study_table(findings: &[Finding]) -> String {
    let head = ["study", "checks", "verdict"].map(String::from);
    let studies = by_case(findings.iter().filter(|finding| run(finding).is_none()));
    let row = |(case, members): &(&str, Vec<&Finding>)| {
        let judged = || members.iter().flat_map(|finding| &finding.judged);
        let verdict = worst(judged()).map_or("**no check**".into(), Verdict::to_string);
        vec![case.to_string(), judged().count().to_string(), verdict]
    };
    markdown::table(&head, &studies.iter().map(row).collect::<Vec<_>>())
}

/// Checks against truths that are not ours, by kind, one table each.
pub fn by_kind(findings: &[Finding]) -> String {
    let kinds = [
        ("Verification: closed forms and orders of accuracy", ReferenceKind::Analytic),
        ("Code checks and benchmarking: other codes", ReferenceKind::CrossCode),
        ("Validation: measurements", ReferenceKind::Measured),
    ];
    kinds.map(|(title, kind)| format!("**{title}**\n\n{}\n", of_kind(findings, kind))).concat()
}

fn of_kind(findings: &[Finding], kind: ReferenceKind) -> String {
    let head = ["case", "checks", "closest to its limit", "verdict"].map(String::from);
    let row = |(case, members): (&str, Vec<&Finding>)| {
        let judged = members.iter().flat_map(|finding| &finding.judged);
        let own: Vec<&Judged> = judged.filter(|judged| judged.reference.kind == kind).collect();
        let verdict = worst(own.iter().copied())?.to_string();
        Some(vec![case.to_string(), own.len().to_string(), closest(&own), verdict])
    };
    markdown::table(&head, &by_case(findings.iter()).into_iter().filter_map(row).collect::<Vec<_>>())
}

/// The passed check that is closest to its tolerance, with its error.
fn closest(judged: &[&Judged]) -> String {
    let passed = judged.iter().filter(|judged| judged.verdict == Verdict::Pass && judged.error > 0.0);
    let worst = passed.max_by(|a, b| a.share_of_tolerance().total_cmp(&b.share_of_tolerance()));
    worst.map_or(String::new(), |judged| {
        let bound = markdown::tolerance(judged.check.tolerance);
        format!("{}: {}, {bound} allowed", judged.check.quantity, markdown::error(judged.error))
    })
}

/// Numbers of checks that passed, failed and were not run.
pub fn counts<'a>(findings: impl IntoIterator<Item = &'a Finding>) -> [usize; 3] {
    let mut counts = [0; 3];
    for judged in findings.into_iter().flat_map(|finding| &finding.judged) {
        match judged.verdict {
            Verdict::Pass => counts[0] += 1,
            Verdict::Fail => counts[1] += 1,
            Verdict::NotRun(_) => counts[2] += 1,
        }
    }
    counts
}
