//! The page of a case: problem, equations, input, reference, results, checks, charts and limits.

use crate::case::{Case, Judged, Verdict};
use crate::markdown;
use crate::measure::display_factor;
use crate::oracle::ReferenceKind;
use crate::report::{checks, links, told};
use crate::study::cases::{self, Numbers, charts, page as name_of, remark, sketch};
use crate::study::grouped::{counted, in_order};
use crate::study::{Finding, described};

/// A run with its checks.
type Ran<'a> = (&'a Finding, &'a Numbers);
/// Name of a page, which the file has too, and the runs that share it.
pub type Shared<'a> = (String, Vec<Ran<'a>>);

/// Name of the file.
pub fn file(name: &str) -> String {
    format!("case-{name}.md")
}

/// All pages of cases, in the order of the suite.
pub fn shared(findings: &[Finding]) -> Vec<Shared<'_>> {
    let runs = findings.iter().filter_map(|finding| {
        let numbers: &Numbers = finding.numbers()?;
        Some((name_of(&numbers.case), (finding, numbers)))
    });
    in_order(runs)
}

/// The page; it links the benchmark sheet where there is one.
pub fn page((name, runs): &Shared, has_sheet: bool) -> String {
    let case = &runs[0].1.case;
    let judged: Vec<&Judged> = runs.iter().flat_map(|(finding, _)| &finding.judged).collect();
    let parts = [
        problem(name, case, has_sheet),
        described::equations(case.scene.plane) + "\n\n",
        reference(runs, &judged),
        results(runs),
        charts(name).map_or(String::new(), |charts| format!("## Charts\n\n{charts}")),
        checked(runs),
        limits(runs, &judged),
    ];
    let title = format!("{name}: {}", case.title);
    let mut names: Vec<&str> = runs.iter().map(|(finding, _)| finding.case.as_str()).collect();
    names.dedup();
    let asked = format!("{}: {}.", names.join("; "), markdown::counted(runs.len(), "run"));
    links::page(&title, &asked, &told::once(judged), &parts.concat())
}

/// Sketch, and the input: the text of the scene file, or the numbers of the scene.
fn problem(name: &str, case: &Case, has_sheet: bool) -> String {
    let input = match &case.places {
        Some(places) => format!(
            "Input: [tests/cases/{0}](../../tests/cases/{0}), solved by `contact-vv solve \
            tests/cases/{0}`.\n\n```toml\n{1}\n```\n\n",
            case.name,
            places.text().trim_end()
        ),
        None if has_sheet => format!(
            "Input: the [benchmark sheet](../sheets/{name}.md) has geometry, material, loads, supports and reference \
            values; `contact-vv solve {name}` solves it.\n\n"
        ),
        None => described::scene(&case.scene).join("\n\n") + "\n\n",
    };
    let plane = described::hypothesis(&case.scene, " mm") + "\n\n";
    format!("## Problem\n\n{plane}{}{}{input}", remark(name), sketch(name).unwrap_or_default())
}

/// Where the truth comes from, and how far it can be trusted.
fn reference(runs: &[Ran], judged: &[&Judged]) -> String {
    let sources = counted(runs.iter().flat_map(|(_, numbers)| described::sources(&numbers.case)));
    let listed: String = sources.iter().map(|(source, _)| format!("* {source}\n")).collect();
    let analytic = || judged.iter().filter(|one| one.reference.kind == ReferenceKind::Analytic);
    let model = analytic().map(|one| one.check.model).fold(0.0, f64::max);
    let uncertain = analytic().any(|one| one.reference.uncertainty.is_none_or(|u| u > 0.0));
    let trust = match (analytic().count(), model > 0.0, uncertain) {
        (0, ..) => "No closed form: the case is held against its own checks.".to_string(),
        (_, true, _) => format!(
            "The closed form is of an idealised scene: the case states that it may be off by up to {} of the value.",
            markdown::error(model)
        ),
        (_, _, true) => "The closed form has an uncertainty, given beside its values.".into(),
        _ => "The closed form is of this very scene; its values are exact but for round-off.".into(),
    };
    format!("## Reference\n\n{trust}\n\n{listed}\n")
}

/// What was found; the case is named where there are several.
fn results(runs: &[Ran]) -> String {
    let rows: Vec<(String, &Numbers, &[Judged])> =
        named(runs).map(|(name, finding, numbers)| (name, numbers, &finding.judged[..])).collect();
    format!(
        "## Results\n\n± is the error bar of the number, where the suite asks for one.\n\n{}\n",
        cases::results(&rows)
    )
}

fn named<'a>(runs: &'a [Ran<'a>]) -> impl Iterator<Item = (String, &'a Finding, &'a Numbers)> {
    let several = runs.iter().any(|(finding, _)| finding.case != runs[0].0.case);
    runs.iter().map(move |(finding, numbers)| {
        let name = if several { format!("{} × {}", finding.case, finding.name) } else { finding.name.clone() };
        (name, *finding, *numbers)
    })
}

/// All checks: the declared ones of each case, then what every run must satisfy.
fn checked(runs: &[Ran]) -> String {
    let findings: Vec<&Finding> = runs.iter().map(|(finding, _)| *finding).collect();
    let own = checks::by_case(&findings, |own, _| own);
    let every = checks::of_every_run(findings.iter().flat_map(|finding| &finding.judged), false);
    format!(
        "## Checks\n\n{own}What every run must satisfy, for reasons given with [all checks](checks.md):\n\n{every}\n"
    )
}

/// What the case does not show: where its candidates end, what did not converge, what it was not held against.
fn limits(runs: &[Ran], judged: &[&Judged]) -> String {
    let scene = &runs[0].1.case.scene;
    let mut told = Vec::new();
    for (at, pair) in scene.contacts.iter().enumerate() {
        let factor = display_factor(&pair.path);
        let unit = if factor > 1.0 { "°" } else { "mm" };
        let stretches = runs.iter().filter_map(|(_, numbers)| numbers.case.scene.contacts.get(at));
        let ends = counted(stretches.map(|own| markdown::significant(factor * own.stretch, 4)));
        let end = |(end, count): &(String, usize)| match ends.len() {
            1 => format!("{end} {unit}"),
            _ => format!("{end} {unit} in {}", markdown::counted(*count, "run")),
        };
        told.push(format!(
            "Contact `{}` may occur up to {} from the origin of its coordinate, not beyond.",
            pair.name,
            ends.iter().map(end).collect::<Vec<_>>().join(" and ")
        ));
    }
    let open = runs.iter().filter(|(_, numbers)| !numbers.run.solution.converged()).count();
    if open > 0 {
        told.push(format!("{open} of {} runs did not converge.", runs.len()));
    }
    let measured = judged
        .iter()
        .any(|one| one.reference.kind == ReferenceKind::Measured && !matches!(one.verdict, Verdict::NotRun(_)));
    if !measured {
        told.push("No measurement is held against it.".into());
    }
    format!("## Limits\n\n{}\n", told.iter().map(|one| format!("* {one}\n")).collect::<String>())
}
