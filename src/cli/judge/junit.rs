//! The verdicts as JUnit XML: a suite an answer, a test case a check, skipped where something is not handed in; an error where it could not be judged.

use std::path::PathBuf;

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use crate::case::{Case, Judged, Verdict};
use crate::cli::verify;
use crate::error::Error;
use crate::referee::Verdicts;
use crate::referee::series::Series;

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
        suite.add_test_cases(found.absent.iter().map(|name| missing(&of.name, name, "its points")));
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
