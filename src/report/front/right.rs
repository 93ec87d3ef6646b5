//! Is it right, and against what?

use crate::case::{Judged, Relation, Verdict};
use crate::markdown::{self, Column};
use crate::oracle::ReferenceKind;
use crate::report::grouped::in_order;
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

/// Truths of a kind that are named, those with the most checks.
const NAMED: usize = 4;

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

/// Counts of checks by kind, the truths with the agreement with each, and what no measurement has seen.
pub fn against(findings: &[Finding]) -> String {
    let all = told::once(findings.iter().flat_map(|finding| &finding.judged));
    let own = |kind: ReferenceKind| all.iter().copied().filter(move |one| one.reference.kind == kind);
    let mut kinds = SHOWS;
    kinds.sort_by_key(|(kind, ..)| std::cmp::Reverse(own(*kind).count()));
    let rows = kinds.map(|(kind, against, shows)| {
        let [pass, fail, absent] = told::counts(own(kind)).map(|number| number.to_string());
        let share = markdown::significant(100.0 * own(kind).count() as f64 / all.len().max(1) as f64, 2);
        vec![format!("{against} ({kind})"), shows.into(), own(kind).count().to_string(), share, pass, fail, absent]
    });
    let head = ["held against", "what it can show", "checks", "%", "pass", "fail", "not run"].map(String::from);
    let truths: Vec<Agreement> = [ReferenceKind::Analytic, ReferenceKind::CrossCode, ReferenceKind::Measured]
        .into_iter()
        .flat_map(|kind| agreements(&own(kind).collect::<Vec<_>>()))
        .collect();
    let columns: [Column<Agreement>; 4] = [
        ("truth", |(name, all)| format!("{name} ({})", all[0].reference.kind)),
        ("numbers", |(_, all)| all.len().to_string()),
        ("tightest agreement", |(_, all)| told_agreement(all.first())),
        ("loosest", |(_, all)| told_agreement(all.last())),
    ];
    format!(
        "{}\n{} {}. Of closed forms and of other codes the {NAMED} with the most numbers that agree \
         with them, not by round-off alone:\n\n{}",
        markdown::table(&head, &rows),
        experiments(findings),
        link("Each check, and how near it is to its limit", checks_page::FILE),
        markdown::columns(&columns, &truths),
    )
}

/// A truth with the passed checks against it that have a relative error, by this.
type Agreement<'a> = (&'a str, Vec<&'a Judged>);

fn told_agreement(one: Option<&&Judged>) -> String {
    one.map_or("–".into(), |one| format!("{}: {}", markdown::error(one.error), one.check.quantity.name()))
}

/// A tolerance from which on an error is counted in what it may be, and is no agreement; an agreement below the second is round-off.
const COUNTED: f64 = 1.0;
const ROUND_OFF: f64 = 1e-9;

/// The truths of a kind that are named.
fn agreements<'a>(own: &[&'a Judged]) -> Vec<Agreement<'a>> {
    let is_agreement = |one: &&Judged| {
        let near = !matches!(one.check.relation, Relation::AtMost | Relation::AtLeast);
        one.verdict == Verdict::Pass && near && one.check.tolerance < COUNTED && one.error >= ROUND_OFF
    };
    let told = own.iter().copied().filter(is_agreement);
    let mut truths = in_order(told.map(|one| (&*one.reference.name, one)));
    truths.sort_by_key(|(_, all)| std::cmp::Reverse(all.len()));
    truths.truncate(NAMED);
    truths.iter_mut().for_each(|(_, all)| all.sort_by(|a, b| a.error.total_cmp(&b.error)));
    truths
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
