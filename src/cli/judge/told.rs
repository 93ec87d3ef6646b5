//! The verdicts on an answer, in lines and as Markdown; and as JUnit XML: a suite an answer, a test case a check,
//! skipped where something is not handed in, but failed where that is a contact; an error where it could not be judged.

use std::path::PathBuf;

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use crate::case::{Case, Judged, Relation, Verdict};
use crate::cli::terminal::{say, table, table_on, width};
use crate::cli::verify;
use crate::error::Error;
use crate::markdown;
use crate::measure::order::Why;
use crate::oracle::ReferenceKind;
use crate::referee::series::Series;
use crate::referee::{Ruled, Truth, Verdicts};
use crate::uncertainty::COVERAGE;

const HEAD: [&str; 6] = ["quantity", "value", "reference", "error", "at most", "verdict"];

/// Prints what was judged, and the verdicts.
pub fn print(truth: &Truth, found: &Verdicts) {
    say(title(truth, found));
    say(verdicts(truth, found, width()));
}

/// A table a contact, no wider than so many columns, what explains what is not met, and what could not be judged.
pub fn verdicts(truth: &Truth, found: &Verdicts, columns: u16) -> String {
    let of = |ruled: &Ruled| {
        let mut table = table_on(columns, HEAD);
        table.add_rows(ruled.judged.iter().map(row));
        format!("contact `{}`:\n{table}", truth.case.scene.contacts[ruled.contact].name)
    };
    let tables = found.ruled.iter().map(of);
    tables.chain(remarks(found)).collect::<Vec<_>>().join("\n")
}

/// The same as Markdown.
pub fn markdown(truth: &Truth, found: &Verdicts) -> String {
    let mut text = format!("## {}\n", title(truth, found));
    for ruled in &found.ruled {
        let rows: Vec<Vec<String>> = ruled.judged.iter().map(|judged| row(judged).into()).collect();
        let name = &truth.case.scene.contacts[ruled.contact].name;
        text += &format!("\nContact `{name}`:\n\n{}", markdown::table(&HEAD.map(String::from), &rows));
    }
    let remarks: String = remarks(found).iter().map(|remark| format!("* {remark}\n")).collect();
    text + "\n" + &remarks
}

/// Prints a series: a line a mesh, then what it says of its limit.
pub fn series(truth: &Truth, found: &Series) {
    say(format!("contact `{}`:", truth.case.scene.contacts[found.contact].name));
    let mut table = table(["quantity", "h/a", "value", "error", "order"]);
    for one in &found.along {
        for k in 0..one.values.len() {
            let order = k.checked_sub(1).map_or("–".into(), |before| match one.orders[before] {
                Ok(order) => markdown::significant(order, 3),
                Err(Why::NotMonotone) => "not monotone".into(),
                Err(Why::Floor) => "below what the truth is known to".into(),
            });
            let error = markdown::signed(100.0 * one.errors[k], 3) + " %";
            table.add_row([
                one.name.to_owned(),
                markdown::significant(found.sizes[k], 3),
                markdown::value(one.values[k]),
                error,
                order,
            ]);
        }
    }
    say(table);
    for one in &found.along {
        let limit = one.limit.map_or_else(String::new, |limit| {
            let order = if limit.order.is_nan() { "none".into() } else { markdown::significant(limit.order, 3) };
            let found = markdown::with_bar(limit.limit, Some(limit.bar));
            format!("{}: limit {found}, order of the last three {order}; ", one.name)
        });
        let reference = markdown::value(one.judged.reference.value);
        say(format!("{limit}{}: {} against {reference} ({})", one.judged.verdict, one.name, one.judged.reference.name));
    }
}

fn title(truth: &Truth, found: &Verdicts) -> String {
    let code = found.answer.code.as_ref().map_or_else(String::new, |code| format!(" of {code}"));
    let verdict = match (found.fails(), found.absent.is_empty()) {
        (true, _) => "does not meet its truth",
        (false, true) => "meets all that could be judged",
        (false, false) => "lacks a contact, and meets all that could be judged",
    };
    format!("`{}`{code}, held against {}: {verdict}", found.answer.file.display(), truth.case.name)
}

fn row(judged: &Judged) -> [String; 6] {
    let Judged { check, value, reference, verdict, .. } = judged;
    let bar = reference.uncertainty.map_or(0.0, |u| COVERAGE * u);
    // What a closed form may be off is stated, and no estimate.
    let sign = if reference.kind == ReferenceKind::Analytic { ", model error " } else { " ± " };
    let bar = if bar > 0.0 { format!("{sign}{}", markdown::significant(bar, 2)) } else { String::new() };
    let reference = format!("{}{bar} ({})", markdown::value(reference.value), reference.name);
    let verdict = match verdict {
        Verdict::Pass => "✓ met".into(),
        Verdict::Fail => "✗ NOT MET".into(),
        Verdict::NotRun(_) => verdict.to_string(),
    };
    let error = |of: f64| {
        let is_absolute = check.relation == Relation::NearAbsolutely;
        if is_absolute { markdown::value(of) } else { markdown::error(of) }
    };
    [
        check.quantity.to_string(),
        markdown::value(*value),
        reference,
        error(judged.error),
        error(check.tolerance),
        verdict,
    ]
}

/// How the file was read, closed forms that are not of the case, usual mistakes, and what is missing.
fn remarks(found: &Verdicts) -> Vec<String> {
    let read = format!("read: {}", found.answer.read.join(", "));
    let mistakes = found.mistakes.iter().map(|mistake| format!("usual mistake: {mistake}; corrected so, all is met"));
    let of = |ruled: &Ruled| {
        ruled.missing.iter().map(|[what, how]| format!("not judged: {what}; hand in {how}")).collect::<Vec<_>>()
    };
    let missing = found.ruled.iter().flat_map(of);
    let absent = found.absent.iter().map(|name| format!("NOT HANDED IN: contact `{name}`; {LACKING}"));
    let notes = found.notes.iter().map(|note| format!("note: {note}"));
    std::iter::once(read).chain(notes).chain(mistakes).chain(missing).chain(absent).collect()
}

/// What to do about a contact that is not handed in.
const LACKING: &str = "hand in its points too, or name by --contact the one that is to be judged";
/// What reports are called: those of other programs are not replaced.
const NAME: &str = "contact-vv";

/// Whether a text is a report of this kind.
pub fn is_report(text: &str) -> bool {
    Report::deserialize_from_str(text).is_ok_and(|report| report.name.is_some_and(|name| name.as_str() == NAME))
}

/// The report on all answers, on those that could not be judged, and on the series that they are.
pub fn report(of: &Case, answers: &[Verdicts], wrong: &[(PathBuf, Error)], series: &[Series]) -> String {
    let contact = |index: usize| format!("{}.{}", of.name, of.scene.contacts[index].name);
    let mut report = Report::new(NAME);
    for (file, error) in wrong {
        let mut suite = TestSuite::new(file.display().to_string());
        let failed = TestCaseStatus::non_success(NonSuccessKind::Error);
        suite.add_test_case(case(&of.name, "the answer is read", said(failed, &error.to_string())));
        report.add_test_suite(suite);
    }
    for found in answers {
        let mut suite = TestSuite::new(found.answer.file.display().to_string());
        for ruled in &found.ruled {
            let name = contact(ruled.contact);
            suite.add_test_cases(ruled.judged.iter().map(|judged| judged_case(&name, judged)));
            suite.add_test_cases(ruled.missing.iter().map(|[what, hand_in]| missing(&name, what, hand_in)));
        }
        suite.add_test_cases(found.absent.iter().map(|name| {
            let failed = TestCaseStatus::non_success(NonSuccessKind::Failure);
            case(&of.name, name, said(failed, &format!("not handed in: {LACKING}")))
        }));
        found.mistakes.iter().for_each(|mistake| {
            suite.add_property(("usual mistake", mistake.as_str()));
        });
        report.add_test_suite(suite);
    }
    if !series.is_empty() {
        let judged = series.iter().flat_map(|one| one.along.iter().map(|along| (contact(one.contact), &along.judged)));
        let mut suite = TestSuite::new("series");
        suite.add_test_cases(judged.map(|(name, judged)| judged_case(&name, judged)));
        report.add_test_suite(suite);
    }
    report.to_string().expect("a report in memory can be written")
}

/// A check: what failed says by how much, what was not run says why.
fn judged_case(contact: &str, judged: &Judged) -> TestCase {
    let status = match &judged.verdict {
        Verdict::Pass => TestCaseStatus::success(),
        Verdict::NotRun(why) => said(TestCaseStatus::skipped(), why),
        Verdict::Fail => {
            let failed = TestCaseStatus::non_success(NonSuccessKind::Failure);
            said(failed, &verify::told(contact, judged))
        }
    };
    case(contact, &judged.check.quantity.to_string(), status)
}

/// What could not be judged, and what to hand in for it.
fn missing(contact: &str, what: &str, hand_in: &str) -> TestCase {
    case(contact, what, said(TestCaseStatus::skipped(), &format!("not judged; hand in {hand_in}")))
}

fn said(mut status: TestCaseStatus, message: &str) -> TestCaseStatus {
    status.set_message(message);
    status
}

fn case(contact: &str, name: &str, status: TestCaseStatus) -> TestCase {
    let mut case = TestCase::new(name, status);
    case.set_classname(contact);
    case
}
