//! What became of some checks, in a sentence.

use crate::case::judged::{self, Mark};
use crate::case::{Judged, Relation, Verdict};
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::study::Finding;
use crate::study::grouped::in_order;

/// Kinds of references, the most independent first, and how a check by one is told.
pub const KINDS: [(ReferenceKind, &str); 4] = [
    (ReferenceKind::Measured, "against measurements"),
    (ReferenceKind::Analytic, "against closed forms"),
    (ReferenceKind::CrossCode, "against other codes"),
    (ReferenceKind::SelfConsistency, "of the code against itself"),
];

/// Failures that are named; further ones are counted.
const NAMED: usize = 3;

/// What is asked, once each, by its worst run.
pub fn once<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> Vec<&'a Judged> {
    let requirements = judged::requirements(judged.into_iter().map(|one| ((), one)));
    requirements.iter().map(|runs| runs[0].1).collect()
}

/// The checks of each study, once each: the rows of the record.
pub fn each<'a>(findings: impl IntoIterator<Item = &'a Finding>) -> Vec<&'a Judged> {
    let of_studies = in_order(findings.into_iter().map(|finding| (finding.study, &finding.judged)));
    of_studies.into_iter().flat_map(|(_, judged)| once(judged.into_iter().flatten())).collect()
}

/// How many propositions checks are: a quantity, how it shall stand to a reference, and the kind of that.
pub fn propositions<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> usize {
    let asked = |one: &'a Judged| (one.check.quantity.name(), one.check.relation, one.reference.kind);
    in_order(judged.into_iter().map(|one| (asked(one), ()))).len()
}

/// Numbers of those that passed, failed and were not run.
pub fn tally<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> [usize; 3] {
    let marks: Vec<Mark> = judged.into_iter().map(|one| one.verdict.mark()).collect();
    [Mark::Pass, Mark::Fail, Mark::NotRun].map(|mark| marks.iter().filter(|own| **own == mark).count())
}

/// The sentence on checks, [`once`] each.
pub fn of(judged: &[&Judged]) -> String {
    let [pass, fail, absent] = tally(judged.iter().copied());
    let own = |kind: ReferenceKind| judged.iter().filter(|one| one.reference.kind == kind).count();
    let kinds = KINDS.iter().map(|(kind, told)| (own(*kind), told)).filter(|(number, _)| *number > 0);
    let kinds: Vec<String> = kinds.map(|(number, told)| format!("{number} {told}")).collect();
    let verdict = match (fail, absent) {
        _ if judged.is_empty() => return "**Nothing was checked.**".into(),
        (0, 0) if pass == 1 => "✓ **The one check passes**".into(),
        (0, 0) if pass == 2 => "✓ **Both checks pass**".into(),
        (0, 0) => format!("✓ **All {pass} checks pass**"),
        (0, _) if pass == 1 => format!("○ **1 check passes, none fails, {absent} could not be run**"),
        (0, _) => format!("○ **{pass} checks pass, none fails, {absent} could not be run**"),
        _ => format!("✗ **{fail} of {} checks fail**", judged.len()),
    };
    let closest = closest(judged).map_or(String::new(), |told| format!(" Closest to its limit: {told}."));
    format!("{verdict}: {}.{}{closest}", kinds.join(", "), failures(judged))
}

/// The first failures by name, and how many more there are.
pub fn failures(judged: &[&Judged]) -> String {
    let failed: Vec<&&Judged> = judged.iter().filter(|one| one.verdict == Verdict::Fail).collect();
    let named: Vec<String> =
        failed.iter().take(NAMED).map(|one| format!("{} (error {})", one.requirement(), error(one))).collect();
    match failed.len() {
        0 => String::new(),
        number if number <= NAMED => format!(" ✗ {}.", named.join("; ")),
        number => format!(" ✗ {}; and {} more.", named.join("; "), number - NAMED),
    }
}

/// Errors below are round-off.
pub const ROUND_OFF: f64 = 1e-9;

/// The passed check that is closest to its tolerance, with its error, unless that is round-off.
pub fn closest(judged: &[&Judged]) -> Option<String> {
    let passed = judged.iter().filter(|one| one.verdict == Verdict::Pass && one.error >= ROUND_OFF);
    let bounded = passed.filter(|one| one.check.tolerance > 0.0);
    let worst = bounded.max_by(|a, b| a.share_of_tolerance().total_cmp(&b.share_of_tolerance()))?;
    let tolerance = in_unit(worst, worst.check.tolerance, markdown::tolerance);
    Some(format!("{}, {} of {tolerance} allowed", worst.check.quantity, error(worst)))
}

/// The error of a check: relative ones in per cent, others in the unit of the quantity. Round-off, which differs
/// between machines, is told by the tolerance that it keeps.
pub fn error(one: &Judged) -> String {
    let tolerance = one.check.tolerance;
    match one.error {
        kept if kept > 0.0 && kept <= tolerance && tolerance < ROUND_OFF => {
            format!("≤ {}", markdown::tolerance(tolerance))
        }
        lost if lost > tolerance && lost < ROUND_OFF => markdown::tolerance(lost),
        usual => in_unit(one, usual, markdown::error),
    }
}

/// An error, a bar or a tolerance in the terms of a check: as it is told where the quantity is itself an error, else in
/// its unit.
pub fn in_unit(one: &Judged, number: f64, told: fn(f64) -> String) -> String {
    let of_tolerance = one.check.tolerance;
    let relative = match one.check.relation {
        Relation::Near => true,
        Relation::Error => of_tolerance < 1.0,
        Relation::NearAbsolutely | Relation::AtLeast | Relation::AtMost => false,
    };
    if relative || number.abs() < 1e-4 || !number.is_finite() { told(number) } else { markdown::significant(number, 2) }
}
