//! Is it right, and against what?

use crate::case::Verdict;
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::report::links::to_page as link;
use crate::report::{checks_page, study_page, told};
use crate::solve::Settings;
use crate::study::drawn::picture;
use crate::study::{Finding, Study, measured, paper, promised};

/// What a check of each kind can show.
const SHOWS: [(ReferenceKind, &str, &str); 4] = [
    (ReferenceKind::SelfConsistency, "the code itself, asked in another way", "that nothing contradicts itself"),
    (ReferenceKind::Analytic, "closed forms and orders of accuracy", "that the equations are solved (verification)"),
    (ReferenceKind::CrossCode, "other codes", "that others find the same (benchmarking)"),
    (ReferenceKind::Measured, "measurements", "that the equations are the right ones (validation)"),
];

/// The share from which on a kind is called most of all.
const MOST: f64 = 0.5;

/// Whether any check fails, and how many error bars hold.
pub fn right(findings: &[Finding]) -> String {
    let all = told::once(findings.iter().flat_map(|finding| &finding.judged));
    let [pass, fail, absent] = told::counts(all.iter().copied());
    let not_run = if absent > 0 { format!(", {absent} could not be run") } else { String::new() };
    let verdict = match (all.len(), fail) {
        (0, _) => "**Nothing was checked.**".to_string(),
        (number, 0) => format!("**No check fails**: {pass} of {number} pass{not_run}."),
        (number, _) => format!("**✗ {fail} of {number} checks fail**; {pass} pass{not_run}.{}", told::failures(&all)),
    };
    let bars = findings.iter().filter_map(|finding| match finding.numbers() {
        Some(promised::Numbers::Checks(all, outside)) => {
            let unknown = outside.iter().filter(|(_, one)| !one.has_known_bar()).count();
            let beyond = outside.len() - unknown;
            Some(format!(
                " Of {all} numbers beside a closed form {beyond} are off by more than their error bar; of {unknown} the bar is not known."
            ))
        }
        _ => None,
    });
    format!(
        "{verdict}{} All nine below are stopped within {:e} of the solution of the discrete problem, which an active set finds before: they \
         show elements and mesh. How they end by criteria of their own, {}.\n\n{}",
        bars.collect::<String>(),
        Settings::default().tolerance,
        link("the paper's statements tell", &study_page::file(paper::Numbers::NAME)),
        picture(
            "pressure-cylinder.svg",
            "Contact pressure on the cylinder by all nine formulations, and their difference to Hertz",
        )
    )
}

/// Counts of checks by kind, and what no measurement has seen.
pub fn against(findings: &[Finding]) -> String {
    let all = told::once(findings.iter().flat_map(|finding| &finding.judged));
    let own = |kind: ReferenceKind| all.iter().copied().filter(move |one| one.reference.kind == kind);
    let mut kinds = SHOWS;
    kinds.sort_by_key(|(kind, ..)| std::cmp::Reverse(own(*kind).count()));
    let (largest, name, _) = kinds[0];
    let share = own(largest).count() as f64 / all.len() as f64;
    let most = if share > MOST { "Most" } else { "Many" };
    let rows = kinds.map(|(kind, against, shows)| {
        let [pass, fail, absent] = told::counts(own(kind)).map(|number| number.to_string());
        vec![format!("{against} ({kind})"), shows.into(), own(kind).count().to_string(), pass, fail, absent]
    });
    let head = ["held against", "what it can show", "checks", "pass", "fail", "not run"].map(String::from);
    format!(
        "**{most} checks are held against {name}: {} of {} ({} %).** {} {}.\n\n{}",
        own(largest).count(),
        all.len(),
        markdown::significant(100.0 * share, 2),
        experiments(findings),
        link("Each check, and how near it is to its limit", checks_page::FILE),
        markdown::table(&head, &rows),
    )
}

/// How many comparisons with measurements were judged, and of what kind.
fn experiments(findings: &[Finding]) -> String {
    let of_photographs = |yes: bool| {
        let own = findings.iter().filter(move |finding| {
            finding.numbers().is_some_and(|numbers| matches!(numbers, measured::Numbers::Photograph(_)) == yes)
        });
        own.flat_map(|finding| &finding.judged).filter(|judged| !matches!(judged.verdict, Verdict::NotRun(_)))
    };
    let shape = if of_photographs(true).next().is_some() {
        "One shape-only comparison with a photograph"
    } else {
        "No photograph compared"
    };
    let measured = of_photographs(false).filter(|judged| judged.reference.kind == ReferenceKind::Measured);
    match measured.count() {
        0 => format!("**{shape}; no calibrated experiment yet.**"),
        n => format!("**{shape}; calibrated curves compared: {n}.**"),
    }
}
