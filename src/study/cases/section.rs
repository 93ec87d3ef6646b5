//! What each case is, and the numbers of its runs.

use crate::case::{Judged, Quantity};
use crate::error::Error;
use crate::markdown::{significant, table};
use crate::measure::display_factor;
use crate::study::Found;
use crate::study::cases::page::page;
use crate::study::cases::run::Numbers;

/// What is shown of every run.
const HEAD: [&str; 10] = [
    "run",
    "outcome",
    "iterations",
    "factorisations",
    "back-substitutions",
    "peak [MPa]",
    "second-moment width",
    "by counting",
    "last active point",
    "resultant [N]",
];

/// What each problem is, what it is held against, and where that comes from.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for Found { numbers, .. } in findings {
        let name = page(&numbers.case);
        let link = format!("[{name}](case-{name}.md)");
        if rows.iter().any(|row| row[0] == link) {
            continue;
        }
        let reference = numbers.case.oracle().map_or("its own checks".into(), |oracle| oracle.name().to_owned());
        rows.push(vec![link, numbers.case.title.clone(), reference, sources(numbers).join("; ")]);
    }
    Ok(table(&["case", "what it is", "reference", "source"].map(String::from), &rows) + "\n")
}

/// Where a case and its closed form come from.
pub fn sources(numbers: &Numbers) -> Vec<String> {
    let cited = numbers.case.oracle().into_iter().map(|oracle| {
        let source = oracle.source();
        format!("{}: {} ({})", oracle.name(), source.citation, source.note)
    });
    std::iter::once(numbers.case.source.clone()).filter(|source| !source.is_empty()).chain(cited).collect()
}

/// What one quotes of every run, with its bar where that is known; each run by the name given.
pub fn results(runs: &[(String, &Numbers, &[Judged])]) -> String {
    let straight = runs.iter().all(|(_, numbers, _)| numbers.case.scene.contact().path.is_straight());
    let unit = if straight { "mm" } else { "°" };
    let rows: Vec<Vec<String>> = runs.iter().map(|(name, numbers, judged)| row(name, numbers, judged)).collect();
    let head = HEAD.map(|name| match name {
        "second-moment width" | "by counting" | "last active point" => format!("{name} [{unit}]"),
        other => other.into(),
    });
    table(&head, &rows)
}

fn row(name: &str, Numbers { case, run, .. }: &Numbers, judged: &[Judged]) -> Vec<String> {
    let (work, measures) = (&run.solution.work, run.measures());
    let factor = display_factor(&case.scene.contact().path);
    let bar = |quantity: Quantity| {
        let own = judged.iter().find(|one| one.check.quantity == quantity && one.check.contact == 0);
        own.and_then(|one| one.bar).filter(|bar| bar.is_finite())
    };
    let quoted = [
        (measures.peak.pressure, bar(Quantity::PeakPressure)),
        (factor * measures.second_moment_width, bar(Quantity::SecondMomentWidth).map(|bar| factor * bar)),
        (factor * measures.half_width_nodes, None),
        (factor * measures.edge(), None),
        (run.transmitted(), bar(Quantity::Resultant)),
    ];
    let shown = |(value, bar): (f64, Option<f64>)| match bar {
        _ if !run.solution.converged() => "–".into(),
        Some(bar) => format!("{} ± {}", significant(value, 6), significant(bar, 2)),
        None => significant(value, 5),
    };
    let counts = [work.iterations, work.factorisations, work.back_substitutions].map(|n| n.to_string());
    let first = [name.to_string(), run.solution.outcome.to_string()];
    first.into_iter().chain(counts).chain(quoted.map(shown)).collect()
}
