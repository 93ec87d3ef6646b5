//! The verdict matrix, the other cases in short, and the tables of verdicts by kind.

use crate::case::Judged;
use crate::case::judged::worst;
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::report::told;
use crate::solution::Outcome;
use crate::solve::{Acceleration, Element, Formulation, Iteration, Run};
use crate::study::Finding;
use crate::study::cases::Numbers;
use crate::study::grouped::in_order;

/// The run of a finding that is one.
pub fn run(finding: &Finding) -> Option<&Run> {
    finding.numbers().map(|Numbers { run, .. }| run)
}

/// A case with its findings.
type Case<'a> = (&'a str, Vec<&'a Finding>);

/// Findings by case, in the order of the suite.
fn by_case<'a>(findings: impl Iterator<Item = &'a Finding>) -> Vec<Case<'a>> {
    in_order(findings.map(|finding| (finding.case.as_str(), finding)))
}

/// Element and algorithm.
pub type Formulated = (Element, Iteration);

/// All, the recommended one first.
fn formulations(first: Option<Formulated>) -> Vec<Formulated> {
    let all = Element::ALL.into_iter().flat_map(|e| Iteration::ALL.map(move |a| (e, a)));
    let (recommended, rest): (Vec<Formulated>, Vec<Formulated>) = all.partition(|one| Some(*one) == first);
    [recommended, rest].concat()
}

fn is_of(finding: &Finding, (element, algorithm): Formulated) -> bool {
    run(finding).is_some_and(|run| run.formulation.element == element && run.formulation.algorithm == algorithm)
}

/// Element and algorithm, and what the program adds to it.
fn told(&(element, algorithm): &Formulated) -> String {
    let acceleration = Formulation::accelerated(element, algorithm).acceleration;
    let added = match acceleration {
        Acceleration::None => String::new(),
        added => format!(" + {}", added.name()),
    };
    format!("{} {}{added}", element.name(), algorithm.name())
}

/// Cases with a run of every formulation, and the others.
fn full_and_others(findings: &[Finding]) -> (Vec<Case<'_>>, Vec<Case<'_>>) {
    let cases = by_case(findings.iter().filter(|finding| run(finding).is_some()));
    let is_full = |(_, members): &Case| {
        formulations(None).iter().all(|formulation| members.iter().any(|one| is_of(one, *formulation)))
    };
    cases.into_iter().partition(is_full)
}

/// The verdict matrix in Markdown: sign and iterations of the cases that all formulations solve, a row each
/// formulation, the recommended one first; `link` names a case and links its page.
pub fn verdict_matrix(findings: &[Finding], first: Option<Formulated>, link: impl Fn(&Finding) -> String) -> String {
    let cases = full_and_others(findings).0;
    let head: Vec<String> =
        std::iter::once("formulation".into()).chain(cases.iter().map(|(_, members)| link(members[0]))).collect();
    let row = |formulation: &Formulated| {
        let cell = |(_, members): &Case| {
            let own = members.iter().filter(|one| is_of(one, *formulation)).map(|one| sign(one));
            own.collect::<Vec<_>>().join(", ")
        };
        std::iter::once(told(formulation)).chain(cases.iter().map(cell)).collect()
    };
    let rows: Vec<Vec<String>> = formulations(first).iter().map(row).collect();
    if cases.is_empty() { String::new() } else { markdown::table(&head, &rows) }
}

/// All other cases, a row each: name, sign, runs, and their iterations.
pub fn other_cases(findings: &[Finding], link: impl Fn(&Finding) -> String) -> String {
    let row = |(_, members): &Case| {
        let sign = members.iter().map(|one| mark(one)).max_by_key(|sign| SIGNS.iter().position(|other| other == sign));
        let runs: Vec<_> = members.iter().filter_map(|one| run(one)).collect();
        let iterations = runs.iter().map(|run| run.solution.work.iterations);
        let [least, most] = [iterations.clone().min(), iterations.max()].map(Option::unwrap_or_default);
        let iterations = if least == most { least.to_string() } else { format!("{least} to {most}") };
        let open = runs.iter().filter(|run| run.solution.outcome != Outcome::Converged).count();
        let open = if open > 0 { format!(", {open} not converged") } else { String::new() };
        vec![link(members[0]), format!("{} {iterations}{open}", sign.unwrap_or_default()), runs.len().to_string()]
    };
    let rows: Vec<Vec<String>> = full_and_others(findings).1.iter().map(row).collect();
    markdown::table(&["case of one or some formulations", "iterations", "runs"].map(String::from), &rows)
}

/// Signs of runs, from good to bad.
const SIGNS: [&str; 4] = ["✓", "·", "○", "✗"];

/// Whether all checks of a run pass, it is reported only, some could not be run, or some fail.
fn mark(finding: &Finding) -> &'static str {
    let is_reported = finding.numbers().is_some_and(|Numbers { case, .. }| case.is_reported());
    if is_reported { SIGNS[1] } else { finding.verdict().mark().told()[0] }
}

fn sign(finding: &Finding) -> String {
    let (sign, Some(run)) = (mark(finding), run(finding)) else { return String::new() };
    match run.solution.outcome {
        Outcome::Converged => format!("{sign} {}", run.solution.work.iterations),
        other => format!("{sign} {other}"),
    }
}

/// Checks against truths that are not ours, by kind, one table each.
pub fn by_kind(findings: &[Finding]) -> String {
    let kinds = [
        ("Verification: closed forms and orders of accuracy", ReferenceKind::Analytic),
        ("Code checks and benchmarking: other codes", ReferenceKind::CrossCode),
        ("Validation: measurements", ReferenceKind::Measured),
    ];
    let head = ["case", "runs checked", "closest to its limit", "verdict"].map(String::from);
    let row = |(case, members): &Case, kind: ReferenceKind| {
        let judged = members.iter().flat_map(|finding| &finding.judged);
        let own: Vec<&Judged> = judged.filter(|judged| judged.reference.kind == kind).collect();
        let verdict = worst(own.iter().copied())?.to_string();
        Some(vec![case.to_string(), own.len().to_string(), told::closest(&own).unwrap_or_default(), verdict])
    };
    let cases = by_case(findings.iter());
    let of_kind = |kind| cases.iter().filter_map(|case| row(case, kind)).collect::<Vec<_>>();
    kinds.map(|(title, kind)| format!("**{title}**\n\n{}\n", markdown::table(&head, &of_kind(kind)))).concat()
}
