//! A trial of the suite as a test: all its checks hold.

use std::fmt::Write;
use std::sync::{Arc, Mutex};

use contact_vv::case::Verdict;
use contact_vv::oracle::ReferenceKind;
use contact_vv::study::{self, Finding};
use libtest_mimic::{Completion, Failed, Trial};

/// What the trials found.
pub type Findings = Arc<Mutex<Vec<Finding>>>;

/// The test; what its trial finds is kept.
pub fn truth(trial: study::Trial, findings: Findings) -> Trial {
    Trial::ignorable_test(trial.title(), move || {
        let finding = trial.run().map_err(|error| Failed::from(error.to_string()))?;
        let mut message = String::new();
        for check in finding.judged.iter().filter(|check| check.verdict == Verdict::Fail) {
            let (name, value) = (&check.reference.name, check.reference.value);
            let _ = writeln!(message, "{}: {}", check.reference.kind, check.requirement());
            let _ = writeln!(message, "  quantity: {}", check.check.quantity.name());
            let _ = writeln!(message, "  {}: {} against {name} {value}", check.check.quantity, check.value);
            let _ = writeln!(
                message,
                "  error {:.3e}, tolerance {:.3e}: {}",
                check.error, check.check.tolerance, check.check.because
            );
        }
        let verdict = finding.verdict();
        findings.lock().expect("no test panics while keeping").push(finding);
        match verdict {
            Verdict::Pass => Ok(Completion::Completed),
            Verdict::Fail => Err(message.into()),
            Verdict::NotRun(why) => Ok(Completion::ignored_with(why)),
        }
    })
}

/// How many checks passed, failed and were not run, and how many of all are against other codes.
pub fn counted(findings: &[Finding]) -> String {
    let checks = || findings.iter().flat_map(|finding| &finding.judged);
    let pass = checks().filter(|check| check.verdict == Verdict::Pass).count();
    let fail = checks().filter(|check| check.verdict == Verdict::Fail).count();
    let other_codes = checks().filter(|check| check.reference.kind == ReferenceKind::CrossCode).count();
    let not_run = checks().count() - pass - fail;
    format!("checks: {pass} passed, {fail} failed, {not_run} not run; {other_codes} of them against other codes")
}
