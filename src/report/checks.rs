//! Requirement by requirement: each check with its oracle, error, tolerance and reason.

use std::collections::BTreeMap;

use crate::case::check::Scope;
use crate::case::{Check, Verdict};
use crate::markdown;
use crate::study::Finding;

/// The requirements of some findings, each once, and the table of their checks; requirements that every run must meet are
/// left to [`universal`].
pub fn table(members: &[&Finding]) -> String {
    let own = || members.iter().flat_map(|finding| &finding.checks).filter(|check| !is_universal(check));
    let mut requirements: Vec<&str> = Vec::new();
    for check in own() {
        if !requirements.contains(&check.requirement.as_str()) {
            requirements.push(&check.requirement);
        }
    }
    let sentences: String = requirements.iter().map(|requirement| format!("* {requirement}.\n")).collect();
    format!("{sentences}\n{}", rows(members))
}

/// How many of the checks passed; what did not is said first.
fn counted(members: &[&Finding]) -> (String, bool) {
    let own = || members.iter().flat_map(|finding| &finding.checks).filter(|check| !is_universal(check));
    let (all, passed) = (own().count(), own().filter(|check| check.verdict == Verdict::Pass).count());
    let text = if passed == all {
        format!("✓ {all} checks passed")
    } else {
        format!("✗ {} of {all} checks did not pass", all - passed)
    };
    (text, passed == all)
}

fn rows(members: &[&Finding]) -> String {
    let head = ["formulation", "quantity", "found", "reference", "kind", "error", "tolerance", "because", "verdict"];
    let mut rows = Vec::new();
    for finding in members {
        for check in finding.checks.iter().filter(|check| !is_universal(check)) {
            rows.push(row(&finding.name, check));
        }
    }
    let (summary, passed) = counted(members);
    markdown::folded(&summary, &markdown::table(&head.map(String::from), &rows), !passed)
}

fn row(name: &str, check: &Check) -> Vec<String> {
    let is_norm = (check.value - check.error).abs() <= 0.0;
    let found = if is_norm { String::new() } else { markdown::value(check.value) };
    let reference = match check.reference.value {
        v if v.abs() > 0.0 => format!("{} {}", check.reference.name, markdown::value(v)),
        _ => check.reference.name.clone(),
    };
    let error = match check.verdict {
        Verdict::NotRun(_) => "–".into(),
        _ => markdown::error(check.error),
    };
    let tolerance = if check.tolerance > 0.0 { markdown::error(check.tolerance) } else { "–".into() };
    vec![
        name.into(),
        check.quantity.clone(),
        found,
        reference,
        check.reference.kind.to_string(),
        error,
        tolerance,
        check.because.clone(),
        markdown::verdict(&check.verdict),
    ]
}

/// Whether a check is one that every run must meet.
fn is_universal(check: &Check) -> bool {
    check.scope == Scope::Universal
}

/// The universal requirements: number of runs, worst error over its tolerance, verdict.
pub fn universal(findings: &[Finding]) -> String {
    let mut rows: BTreeMap<&str, Vec<&Check>> = BTreeMap::new();
    for check in findings.iter().flat_map(|finding| &finding.checks).filter(|check| is_universal(check)) {
        rows.entry(&check.requirement).or_default().push(check);
    }
    let head = ["every run", "runs", "worst error", "its tolerance", "because", "verdict"].map(String::from);
    let rows: Vec<Vec<String>> = rows
        .into_iter()
        .map(|(requirement, checks)| {
            let worst = checks.iter().max_by(|a, b| (a.error / a.tolerance).total_cmp(&(b.error / b.tolerance)));
            let verdict =
                if checks.iter().all(|check| check.verdict == Verdict::Pass) { Verdict::Pass } else { Verdict::Fail };
            let (error, tolerance, because) =
                worst.map_or((f64::NAN, f64::NAN, ""), |check| (check.error, check.tolerance, check.because.as_str()));
            vec![
                requirement.into(),
                checks.len().to_string(),
                bounded(error, tolerance),
                markdown::error(tolerance),
                because.into(),
                markdown::verdict(&verdict),
            ]
        })
        .collect();
    markdown::table(&head, &rows)
}

/// Round-off is not worth its digits: what is below its tolerance of 1e-9 is shown as that.
fn bounded(error: f64, tolerance: f64) -> String {
    if tolerance <= 1e-9 && error <= tolerance { "< 1e-9".into() } else { markdown::error(error) }
}
