//! What a check is: a sentence rendered from data, an error that NaN fails, and a row on the page.

use contact_vv::case::judged::requirements;
use contact_vv::case::{Check, Judged, Reference, Verdict};
use contact_vv::oracle::ReferenceKind;
use contact_vv::report::{checks, told};
use contact_vv::study::about::complete;

/// One of each relation to a reference of 2, with a value that passes.
fn each() -> [(Check, f64); 5] {
    let two = || Reference::analytic("Hertz", 2.0);
    [
        (Check::near("width", two(), 0.1, "a reason"), 2.1),
        (Check::absolute("width", two(), 0.1, "a reason"), 2.05),
        (Check::error("error", two(), 0.1, "a reason"), 0.1),
        (Check::at_least("order", two(), "a reason"), 2.0),
        (Check::at_most("faults", two(), "a reason"), 2.0),
    ]
}

#[test]
fn value_beyond_its_bound_fails_and_so_does_nan() {
    let beyond = [2.3, 2.2, 0.2, 1.9, 2.1];
    for ((check, good), bad) in each().into_iter().zip(beyond) {
        let verdict = |value: f64| check.clone().judge(value).verdict;
        assert_eq!([verdict(good), verdict(bad), verdict(f64::NAN)], [Verdict::Pass, Verdict::Fail, Verdict::Fail]);
        let without = check.clone().judge_by(good, Reference::own("none", f64::NAN));
        assert!(without.verdict == Verdict::Fail || without.check.quantity.name() == "error", "{:?}", without.check);
    }
}

#[test]
fn sentence_is_rendered_from_quantity_reference_and_tolerance() {
    let sentences = each().map(|(check, value)| check.judge(value).requirement());
    assert_eq!(
        sentences,
        [
            "Width shall agree with Hertz within 10 %",
            "Width shall agree with Hertz (2) within 0.100000 in its unit",
            "Error shall be at most 10 % against Hertz",
            "Order shall be at least 2 (Hertz)",
            "Faults shall be at most 2 (Hertz)",
        ]
    );
    let none = Check::none("fault that nothing sees", "a reason").judge(0.0);
    assert_eq!(none.requirement(), "There shall be no fault that nothing sees");
    let order = Check::at_least("order", Reference::own("second order", 1.8), "a reason").judge(2.0);
    assert_eq!(order.requirement(), "Order shall be at least 1.8 (second order)");
}

/// A passed, a failed and an absent check of every run.
fn of_every_run() -> [Judged; 3] {
    let check = || Check::error("error", Reference::own("exact", 0.0), 0.1, "a reason").universal();
    let absent = check().not_run(ReferenceKind::SelfConsistency, "exact", "it did not end".into());
    [check().judge(0.05), check().judge(0.2), absent]
}

#[test]
fn check_of_every_run_that_was_not_run_is_neither_a_failure_nor_the_worst_error() {
    let [pass, fail, absent] = of_every_run();
    let table = checks::of_every_run([&pass, &absent].into_iter(), true);
    assert!(table.contains("1 and 1 not run") && table.contains("5.0 %") && table.contains("✓ pass"), "{table}");
    assert!(!table.contains("FAIL") && !table.contains("not a number"), "{table}");
    let table = checks::of_every_run([&pass, &fail, &absent].into_iter(), true);
    assert!(table.contains("20 %") && table.contains("✗ FAIL"), "{table}");
}

#[test]
fn every_check_of_a_case_has_a_row_with_reference_tolerance_and_reason() {
    let judged: Vec<Judged> = each().map(|(check, value)| check.judge(value)).into();
    let page = checks::of(&[("first", &judged), ("second", &judged)]);
    let rows: Vec<&str> = page.lines().filter(|line| line.contains("a reason")).collect();
    assert_eq!(rows.len(), judged.len(), "{page}");
    assert!(rows.iter().all(|row| row.contains("Hertz") && row.contains("analytic")), "{page}");
    assert!(page.contains("In all rows: all 2 trials, reference 2, verdict ✓ pass."), "{page}");
    let [_, fail, absent] = of_every_run().map(|one| {
        let check = Check { scope: contact_vv::case::Scope::Own, ..one.check };
        Judged { check, ..one }
    });
    assert!(checks::of(&[("first", std::slice::from_ref(&absent))]).contains("0 checks passed, 1 not run"));
    assert!(checks::of(&[("first", &[fail, absent])]).contains("✗ 1 of 2 checks failed"));
}

#[test]
fn both_error_bars_stand_beside_their_values_where_they_are_known() {
    let row = |ours: Option<f64>, theirs: Option<f64>| {
        let reference = Reference { uncertainty: theirs, ..Reference::own("series", 2.0) };
        let judged = Judged { uncertainty: ours, ..Check::near("peak", reference, 0.1, "a reason").judge(2.01) };
        checks::of(&[("first", &[judged])])
    };
    let both = row(Some(0.01), Some(0.04));
    assert!(both.contains("| 2.01000 ± 0.020 | 2.00000 ± 0.080 |"), "{both}");
    assert!(!row(None, Some(0.0)).contains('±') && !row(None, None).contains('±'));
    assert_eq!(Reference::analytic("Hertz", 3.0).times(-2.0).uncertainty, Some(0.0));
    let doubled = Reference { uncertainty: Some(0.5), ..Reference::own("series", 3.0) }.times(-2.0);
    assert_eq!((doubled.value, doubled.uncertainty), (-6.0, Some(1.0)));
}

#[test]
fn trial_without_a_check_or_with_one_that_gives_no_reason_is_an_error() {
    let of = |judged: Vec<Judged>| complete("cylinder × node", judged).map(|judged| judged.len());
    let check =
        |because: &'static str, name: &str| Check::at_most("fault", Reference::own(name, 0.0), because).judge(0.0);
    assert_eq!(of(vec![check("a reason", "none")]).expect("a check"), 1);
    for (judged, says) in [
        (vec![], "the trial yields no check"),
        (vec![check("a reason", "none"), check("", "none")], "no reason or reference"),
        (vec![check("a reason", "")], "no reason or reference"),
    ] {
        let error = of(judged).expect_err(says).to_string();
        assert!(error.contains("cylinder × node") && error.contains(says), "{error}");
    }
}

#[test]
fn check_that_asks_for_more_than_another_formulation_accepts_is_not_judged_and_a_larger_miss_still_fails() {
    let near = |value: f64| Check::near("length", Reference::analytic("a law", 1.0), 1e-9, "exact").judge(value);
    assert_eq!(near(1.0).as_far_as(1e-3).verdict, Verdict::Pass);
    assert!(matches!(near(1.0005).as_far_as(1e-3).verdict, Verdict::NotRun(why) if why.contains("0.10 %")));
    for missed in [1.002, f64::NAN] {
        assert_eq!(near(missed).as_far_as(1e-3).verdict, Verdict::Fail, "{missed}");
    }
    let wide = |value: f64| Check::near("length", Reference::analytic("a law", 1.0), 2e-3, "mesh").judge(value);
    assert!(matches!(wide(1.0029).as_far_as(1e-3).verdict, Verdict::NotRun(_)));
    assert_eq!(wide(1.0031).as_far_as(1e-3).verdict, Verdict::Fail);
    let absolute = Check::absolute("length", Reference::analytic("a law", 0.0), 1e-9, "exact").judge(5e-4);
    assert_eq!(absolute.as_far_as(1e-3).verdict, Verdict::Fail, "in its own unit an iteration error says nothing");
    // Of a file's own formulation every check is judged.
    let path = crate::outputs::scene("eccentric-load");
    let told = |options: &[&str]| {
        let all = [&["solve", &path, "--all", "--no-error-bar"], options].concat();
        let (well, text, _) = crate::outputs::contact_vv(&all);
        (well, text.contains("not judged"))
    };
    assert_eq!(told(&["--element", "node", "--algorithm", "varying"]), (true, true));
    assert_eq!(told(&["--tolerance", "1e-3", "--algorithm", "kinematic"]), (true, false));
}

#[test]
fn what_is_asked_of_several_runs_is_one_check_and_as_bad_as_its_worst_run() {
    let own = |error: f64| Check::error("imbalance", Reference::own("zero", 0.0), 1e-9, "statics").judge(error);
    let hertz = |value: f64| Check::near("width", Reference::analytic("Hertz", 2.0), 0.1, "a reason").judge(value);
    let absent =
        || Check::none("imbalance", "statics").not_run(ReferenceKind::SelfConsistency, "zero", "no run".into());
    let fold = |all: &[Judged]| told::counts(all);
    assert_eq!(fold(&[own(1e-12), own(1e-10), own(0.0), hertz(2.1), hertz(2.15)]), [2, 0, 0]);
    assert_eq!(fold(&[hertz(2.1), hertz(2.3), hertz(f64::NAN)]), [0, 1, 0]);
    // Another reference, or another tolerance, is another check.
    let other = |reference: f64, tolerance: f64| {
        Check::near("width", Reference::analytic("Hertz", reference), tolerance, "a reason").judge(2.0)
    };
    assert_eq!(fold(&[hertz(2.0), other(2.05, 0.1), other(2.0, 0.2), other(2.0, 0.1)]), [3, 0, 0]);
    assert_eq!(fold(&[own(1e-12), own(1e-8), own(0.0), hertz(2.1)]), [1, 1, 0]);
    assert_eq!(fold(&[own(1e-12), own(f64::NAN), hertz(2.1)]), [1, 1, 0]);
    assert_eq!(fold(&[own(1e-12), absent(), hertz(2.1)]), [1, 0, 1]);
    let in_order = |runs: [Judged; 3]| -> Vec<Vec<&str>> {
        let named = ["a", "b", "c"].into_iter().zip(&runs);
        requirements(named).iter().map(|runs| runs.iter().map(|(name, _)| *name).collect()).collect()
    };
    assert_eq!(in_order([own(6e-10), own(9e-10), own(0.0)]), [["b", "a", "c"]]);
    // Of round-off machines disagree which is worst.
    assert_eq!(in_order([own(1e-12), own(1e-10), own(0.0)]), [["a", "b", "c"]]);
}
