//! What a check is: a sentence rendered from data, an error that NaN fails, a row on the page, and a line for other
//! programs.

use contact_vv::case::judged::requirements;
use contact_vv::case::{Check, Judged, Reference, Verdict};
use contact_vv::checkout::root;
use contact_vv::cli;
use contact_vv::cli::json::Line;
use contact_vv::oracle::ReferenceKind;
use contact_vv::report::{checks, told};
use contact_vv::study::about::complete;
use serde_json::Value;

use crate::outputs::{contact_vv, json, scene};
use crate::program::Folder;
use crate::scene_file::text_of;

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
fn a_check_that_is_asked_of_nothing_fails() {
    let none = |number: usize| Check::none("run that is lost", "none may be").asked_of(number).judge(0.0);
    assert_eq!([1, 7].map(|number| none(number).verdict), [Verdict::Pass, Verdict::Pass]);
    assert!(none(0).verdict == Verdict::Fail && none(0).value.is_nan());
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
fn sentence_on_failures_names_each_with_its_own_error_and_counts_all_that_was_asked() {
    let judged = |name: &'static str, error: f64| {
        Check::error(name, Reference::own("exact", 0.0), 1e-3, "a reason").judge(error)
    };
    let absent = Check::error("third", Reference::own("exact", 0.0), 0.1, "a reason");
    let absent = absent.not_run(ReferenceKind::SelfConsistency, "exact", "it did not end".into());
    let all = [judged("first", 0.02), judged("second", 0.05), absent];
    let told = told::failures(&all.each_ref());
    assert!(
        told.contains("First shall") && told.contains("(error 2.0 %); Second") && told.contains("(error 5.0 %)"),
        "{told}"
    );
    let table = checks::of(&[("trial", &all)]);
    assert!(table.starts_with("✗ 2 of 3 checks failed"), "{table}");
}

#[test]
fn end_of_a_contact_is_judged_in_its_unit_and_not_in_per_cent() {
    let folder = Folder::made();
    let csv = folder.at("p.csv");
    assert!(contact_vv(&["solve", "truncated-hertz", "--no-error-bar", "--csv", &csv]).0);
    let (_, table, _) = contact_vv(&["judge", "truncated-hertz", &csv]);
    let row = |name: &str| table.lines().find(|line| line.contains(name)).expect("a row").contains('%');
    assert_eq!(["end of the contact [mm]", "peak pressure [MPa]"].map(row), [false, true], "{table}");
}

#[test]
fn tension_of_half_a_per_cent_is_not_met() {
    let folder = Folder::made();
    let csv = folder.at("p.csv");
    assert!(contact_vv(&["solve", "truncated-hertz", "--no-error-bar", "--csv", &csv]).0);
    let text = folder.read("p.csv");
    let (rows, last) = text.trim_end().rsplit_once('\n').expect("rows");
    let cells: Vec<&str> = last.split(',').collect();
    let pulled = folder.with("q.csv", format!("{rows}\n{},-29,{}\n", cells[0], cells[2..].join(",")));
    let verdict = |file: &str| {
        let [judged] = &lines(&["judge", "truncated-hertz", file, "--json"])[..] else {
            panic!("one answer is a line")
        };
        let checks = judged["checks"].as_array().expect("checks");
        let tension = checks.iter().find(|one| one["quantity"].as_str().is_some_and(|name| name.contains("tension")));
        tension.expect("judged")["verdict"].clone()
    };
    assert_eq!([verdict(&csv), verdict(&pulled)], ["pass", "fail"]);
}

#[test]
fn round_off_is_told_by_the_tolerance_that_it_keeps_where_that_is_finer_than_what_errors_are_told_to() {
    let told = |tolerance: f64, error: f64| {
        let check = Check::error("error", Reference::own("exact", 0.0), tolerance, "a reason");
        let row = |check: Check| checks::of_every_run([&check.judge(error)].into_iter(), false);
        assert_eq!(
            told::error(&check.clone().judge(error)),
            row(check.clone().universal()).split('|').nth(15).expect("a cell").trim()
        );
        told::error(&check.judge(error))
    };
    assert_eq!([told(2e-12, 1e-13), told(1e-6, 1e-13), told(2e-12, 0.0)], ["≤ 2e-12", "< 1e-9", "0"]);
    assert_eq!([told(2e-12, 1e-11), told(2e-12, 1e-3)], ["1e-11", "0.10 %"], "what is not kept");
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
    assert!(checks::of(&[("first", &[fail, absent])]).contains("✗ 1 of 1 check failed"));
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
fn trial_with_a_check_that_gives_no_reason_or_reference_is_an_error() {
    let of = |judged: Vec<Judged>| complete("cylinder × node", judged).map(|judged| judged.len());
    let check =
        |because: &'static str, name: &str| Check::at_most("fault", Reference::own(name, 0.0), because).judge(0.0);
    assert_eq!(of(vec![check("a reason", "none")]).expect("a check"), 1);
    for (judged, says) in [
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
    let path = scene("eccentric-load");
    let told = |options: &[&str]| {
        let all = [&["solve", &path, "--all", "--no-error-bar"], options].concat();
        let (well, text, _) = contact_vv(&all);
        (well, text.contains("not judged"))
    };
    assert_eq!(told(&["--element", "node", "--algorithm", "varying"]), (true, true));
    assert_eq!(told(&["--tolerance", "1e-3", "--algorithm", "kinematic"]), (true, false));
    // What is not judged has not passed.
    let varying = ["solve", &path, "--no-error-bar", "--element", "node", "--algorithm", "varying"];
    let document = json(&varying);
    let checks = document["checks"].as_array().expect("checks");
    let passed = checks.iter().filter(|one| one["verdict"] == "pass").count();
    let (_, brief, _) = contact_vv(&varying);
    assert!(passed < checks.len() && brief.contains(&format!("{passed} of {} pass", checks.len())), "{brief}");
}

#[test]
fn what_is_asked_of_several_runs_is_one_check_and_as_bad_as_its_worst_run() {
    let own = |error: f64| Check::error("imbalance", Reference::own("zero", 0.0), 1e-9, "statics").judge(error);
    let hertz = |value: f64| Check::near("width", Reference::analytic("Hertz", 2.0), 0.1, "a reason").judge(value);
    let absent =
        || Check::none("imbalance", "statics").not_run(ReferenceKind::SelfConsistency, "zero", "no run".into());
    let fold = |all: &[Judged]| told::tally(told::once(all));
    assert_eq!(fold(&[own(1e-12), own(1e-10), own(0.0), hertz(2.1), hertz(2.15)]), [2, 0, 0]);
    assert_eq!(fold(&[hertz(2.1), hertz(2.3), hertz(f64::NAN)]), [0, 1, 0]);
    // Another reference, or another tolerance, is another check.
    let other = |reference: f64, tolerance: f64| {
        Check::near("width", Reference::analytic("Hertz", reference), tolerance, "a reason").judge(2.0)
    };
    let others = [hertz(2.0), other(2.05, 0.1), other(2.0, 0.2), other(2.0, 0.1)];
    assert_eq!(fold(&others), [3, 0, 0]);
    // But the same is asked; not so of another quantity, by another relation, or of a reference of another kind.
    let [at_most, by_code] = [
        Check::at_most("width", Reference::analytic("Hertz", 2.0), "a reason"),
        Check::near("width", Reference::own("another mesh", 2.0), 0.1, "a reason"),
    ];
    assert_eq!(told::propositions(&others), 1);
    let further = [own(0.0), at_most.judge(2.0), by_code.judge(2.0)];
    assert_eq!(told::propositions(others.iter().chain(&further)), 4);
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

fn lines(arguments: &[&str]) -> Vec<Value> {
    let (_, text, _) = contact_vv(arguments);
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn published_schema_is_that_of_the_program() {
    let file = root().join("snapshots/schema.json");
    let published = std::fs::read_to_string(&file).expect("published");
    let (sound, printed, _) = contact_vv(&["schema"]);
    assert!(sound && printed == format!("{}\n", cli::json::schema()));
    assert_eq!(published, printed, "`cargo run --release -- schema > snapshots/schema.json`, and read the difference");
    let schema: Value = serde_json::from_str(&published).expect("JSON");
    assert_eq!(schema["anyOf"].as_array().map(Vec::len), Some(5));
}

#[test]
fn line_of_a_check_carries_its_numbers_its_verdict_and_why_it_failed() {
    let folder = Folder::made();
    let path = folder.with("off.toml", text_of("blocks.toml").replace("value = 4000", "value = 4100"));
    let lines = lines(&["verify", &path, "--json"]);
    let own: Vec<&Value> = lines.iter().filter(|line| line["scope"] == "own").collect();
    assert!(own.len() == 2 && lines.iter().any(|line| line["scope"] == "every-run"), "{lines:?}");
    let [held, off] = [own[0], own[1]];
    assert!(held["verdict"] == "pass" && held["passed"] == true && held["reason"].is_null(), "{held}");
    assert!(off["verdict"] == "fail" && off["passed"] == false, "{off}");
    let number = |key: &str| off[key].as_f64().unwrap_or_else(|| panic!("{key}: {off}"));
    let error = (number("value") - number("reference")).abs() / number("reference");
    assert!((number("error") - error).abs() < 1e-12 && number("error") > number("tolerance"), "{off}");
    let text = |key: &str| off[key].as_str().unwrap_or_else(|| panic!("{key}: {off}"));
    assert_eq!((text("unit"), text("kind"), text("because")), ("N", "self-consistency", "equilibrium"));
    assert!(text("reason").contains("2.4 %") && text("reason").contains("tolerance"), "{off}");
    // The check of `solve` is the same one, under the keys that it had.
    let solved = json(&["solve", &path]);
    let same = &solved["checks"][1];
    for key in ["quantity", "value", "reference", "source", "error", "tolerance", "passed", "verdict", "reason"] {
        assert_eq!(same[key], off[key], "{key}");
    }
}

#[test]
fn a_line_has_the_uncertainty_of_its_value_and_twice_that_of_its_reference_for_a_bar() {
    let judged = Check::near("width", Reference::analytic("Hertz", 2.0), 0.1, "a reason").judge(2.1);
    let reference = Reference { uncertainty: Some(0.03), ..judged.reference.clone() };
    let line = Line::of("a trial", &Judged { uncertainty: Some(0.01), reference, ..judged });
    let line = serde_json::to_value(line).expect("JSON");
    let told = ["uncertainty", "reference_uncertainty", "reference_bar"].map(|key| line[key].as_f64());
    assert_eq!(told, [Some(0.01), Some(0.03), Some(0.06)]);
}

#[test]
fn every_contact_is_read_beside_its_own_oracle_and_every_quantity_beside_a_reference_of_the_same() {
    let roller = scene("roller-between-plates");
    for (case, most) in
        [("flat-punch", 0.01), ("cylinder", 0.01), ("truncated-hertz", 0.01), ("pin-plate", 0.02), (&roller, 0.05)]
    {
        let solved = json(&["solve", case]);
        let list = |key: &str| solved[key].as_array().unwrap_or_else(|| panic!("{key}: {solved}")).clone();
        let oracles = list("oracles");
        assert_eq!(list("contacts").len(), if case == roller { 2 } else { 1 }, "{solved}");
        for contact in list("contacts") {
            let own = oracles.iter().filter(|one| one["contact"] == contact["name"]);
            let errors: Vec<f64> = own.filter_map(|one| one["error"].as_f64()).collect();
            let near = errors.iter().all(|error| error.abs() <= most);
            assert!(errors.len() >= 2 && near, "{case}, {}: {oracles:?}", contact["name"]);
        }
    }
}

#[test]
fn angles_are_told_and_judged_in_degrees_where_they_are_given_in_degrees() {
    let folder = Folder::made();
    let csv = folder.at("p.csv");
    let (sound, table, _) = contact_vv(&["solve", &scene("press-fit"), "--all", "--csv", &csv]);
    let words = table.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(sound && words.contains("contact pressure at s = 45° [MPa]") && !table.contains("0.785"), "{table}");
    let mut rows = csv::Reader::from_path(&csv).expect("a table");
    assert_eq!(rows.headers().expect("a head").get(0), Some("position [deg]"));
    let last = rows.deserialize::<(f64, f64, f64, f64, String)>().last().expect("a row").expect("numbers");
    assert!((last.0 - 90.0).abs() < 1e-9, "{}", last.0);
    let solved = json(&["solve", &scene("press-fit")]);
    assert_eq!(solved["units"]["angle"], "rad");
    let end = solved["contacts"][0]["profile"].as_array().and_then(|all| all.last()).expect("a point");
    assert!((end["position"].as_f64().expect("a number") - std::f64::consts::FRAC_PI_2).abs() < 1e-9);

    let (_, text, _) = contact_vv(&["new", "pin-in-hole"]);
    let asked = "\n[[check]]\nquantity = \"second-moment-width\"\nvalue = 90\ntolerance = 0.9\nbecause = \"any\"\n";
    let solved = json(&["solve", &folder.with("pin.toml", text + asked)]);
    let check = solved["checks"].as_array().and_then(|all| all.last()).expect("a check");
    let angle = solved["contacts"][0]["second_moment_width"].as_f64().expect("an angle");
    let judged = check["value"].as_f64().expect("a number");
    assert!(check["unit"] == "°" && (judged - angle.to_degrees()).abs() < 1e-9 && judged > 10.0, "{check}");

    // Of several contacts every point names its own.
    let (sound, _, error) = contact_vv(&["solve", &scene("three-rings"), "--no-error-bar", "--csv", &csv, "--force"]);
    assert!(sound, "{error}");
    let mut rows = csv::Reader::from_path(&csv).expect("a table");
    let head: Vec<String> = rows.headers().expect("a head").iter().map(String::from).collect();
    assert_eq!(head, ["position [deg]", "pressure [MPa]", "gap [mm]", "area [mm2]", "contact"]);
    let contacts = rows.records().map(|row| row.expect("a row").get(4).expect("a name").to_string());
    assert_eq!(contacts.collect::<std::collections::BTreeSet<_>>().len(), 2);
}

#[test]
fn line_of_a_judged_answer_holds_its_points_on_the_truth_and_the_table_that_is_printed() {
    let folder = Folder::made();
    let [csv, case] = [folder.at("p.csv"), scene("roller-between-plates")];
    assert!(contact_vv(&["solve", &case, "--no-error-bar", "--csv", &csv]).0);
    let (_, printed, _) = contact_vv(&["judge", &case, &csv]);
    let [judged] = &lines(&["judge", &case, &csv, "--json"])[..] else { panic!("one answer is a line") };
    let (title, table) = printed.split_once('\n').expect("a title, and the table");
    // Of our own fine answer the bar is an estimate; what a closed form may be off is stated.
    assert!(table.contains(" ± ") && !table.contains("model error"), "{table}");
    let hertz = folder.at("hertz.csv");
    assert!(contact_vv(&["solve", "cylinder", "--no-error-bar", "--csv", &hertz]).0);
    let (_, stated, _) = contact_vv(&["judge", "cylinder", &hertz, "--markdown"]);
    assert!(stated.contains(", model error "), "{stated}");
    assert!(!title.is_empty() && judged["table"] == table.trim_end(), "{judged}");
    let contacts = judged["contacts"].as_array().expect("contacts");
    let names: Vec<&Value> = contacts.iter().map(|one| &one["name"]).collect();
    assert_eq!(names, ["above", "below"]);
    for contact in contacts {
        let number = |of: &Value, key: &str| of[key].as_f64().unwrap_or_else(|| panic!("{key}: {of}"));
        let checks = judged["checks"].as_array().expect("checks");
        let peak =
            checks.iter().find(|one| one["contact"] == contact["name"] && one["quantity"] == "peak pressure [MPa]");
        let peak = peak.expect("judged");
        let [reference, bar] = ["reference", "reference_bar"].map(|key| number(peak, key));
        assert!((bar / number(peak, "reference_uncertainty") - 2.0).abs() < 1e-9, "{peak}");
        // At the middle both profiles are at their peak, but for what elements round off.
        let top = &contact["profile"][0];
        assert_eq!((&contact["unit"], number(top, "position")), (&"mm".into(), 0.0));
        for profile in ["pressure", "reference"] {
            assert!((number(top, profile) / reference - 1.0).abs() < 1e-3, "{profile}: {top}");
        }
    }
}

#[test]
fn points_of_a_judged_answer_on_an_arc_lie_at_degrees() {
    let folder = Folder::made();
    let csv = folder.at("p.csv");
    assert!(contact_vv(&["solve", "pin-rod", "--no-error-bar", "--csv", &csv]).0);
    let [judged] = &lines(&["judge", "pin-rod", &csv, "--json"])[..] else { panic!("one answer is a line") };
    let contact = &judged["contacts"][0];
    let last = contact["profile"].as_array().and_then(|points| points.last()).expect("points");
    let place = last["position"].as_f64().expect("an angle");
    assert!(contact["unit"] == "°" && (place - 75.0).abs() <= 1e-9, "{last}");
}
