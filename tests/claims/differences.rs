//! What moved between two commits is told as what it is, in at most 40 lines.

use contact_vv::case::Relation;
use contact_vv::oracle::ReferenceKind;
use contact_vv::report::diff::Difference;
use contact_vv::report::diff::charts::no_data;
use contact_vv::report::diff::tree::Tree;
use contact_vv::report::record::{self, CHECKS, CheckRow, Mark, floored};

/// A check of a case under a formulation, at this share of its tolerance.
fn check(case: &str, trial: &str, quantity: &str, error: f64) -> CheckRow {
    let tolerance = 0.01;
    CheckRow {
        study: "cases".into(),
        case: case.into(),
        trial: trial.into(),
        quantity: quantity.into(),
        place: String::new(),
        against: "Hertz".into(),
        kind: ReferenceKind::Analytic,
        relation: Relation::Near,
        value: 100.0 * (1.0 + error),
        reference: 100.0,
        error,
        tolerance,
        share: error / tolerance,
        bar: Some(2.0 * error),
        uncertainty: None,
        verdict: if error <= tolerance { Mark::Pass } else { Mark::Fail },
        why: String::new(),
        runs: 1,
        worst: String::new(),
    }
}

/// Thirty checks of two cases.
fn checks() -> Vec<CheckRow> {
    let mut rows = Vec::new();
    for (c, case) in ["cylinder", "pin"].into_iter().enumerate() {
        for trial in 0..5 {
            for (q, quantity) in ["peak pressure", "half-width", "profile"].into_iter().enumerate() {
                let error = 1e-3 + 1e-4 * (15 * c + 3 * trial + q) as f64;
                rows.push(check(case, &format!("run {trial}"), quantity, error));
            }
        }
    }
    record::numbered(rows)
}

const SNAPSHOT: &str =
    "---\nsource: tests/suite.rs\n---\noutcome: converged\niterations: 20\nback-substitutions: 40\ndofs: 100\n";
const CHART: &str = "<svg><title>t</title><path d=\"M0 0L1 1\" fill=\"#0072B2\"/><path d=\"M2 2\" \
    fill=\"#FDFDFC\"/><text>a</text></svg>";
const TIMINGS: &str = r#"{
    "machine": {"processor": "one"},
    "growth": [{"dofs": 9, "whole": {"median": 2.0, "least": 1.0, "most": 3.0}}]
}"#;

/// A tree with these checks, three snapshots, a survey, a chart and timings.
fn tree(rows: &[CheckRow]) -> Tree {
    let mut tree = Tree { name: "a tree".into(), ..Tree::default() };
    let mut put = |path: &str, text: &str| tree.files.insert(path.into(), text.into());
    put(CHECKS, &record::text(CHECKS.as_ref(), rows).expect("written"));
    put(
        "snapshots/runs.csv",
        "case,trial,outcome,iterations,factorisations,updates,back_substitutions,dofs,retained\n",
    );
    put("snapshots/statements.csv", "statement,judgement,measured\nIt holds,reproduced,1 %\n");
    for run in ["line", "layer", "node"] {
        put(&format!("snapshots/cylinder@{run}.snap"), SNAPSHOT);
    }
    put("snapshots/met.csv", "family,number,met,error\nhertz,1,true,0.1\nhertz,2,true,0.2\n");
    put("snapshots/charts/one.svg", CHART);
    put("snapshots/timings/measured.json", TIMINGS);
    tree
}

/// What is told when a file is replaced, and whether a verdict got worse.
fn replaced(path: &str, from: &str, to: &str) -> (String, bool) {
    let before = tree(&checks());
    let text = before.text(path).expect("there").replace(from, to);
    let after = before.with("another", vec![(path.into(), text)], &[]);
    told(&before, &after)
}

fn told(before: &Tree, after: &Tree) -> (String, bool) {
    let difference = Difference::of(before, after);
    let text = difference.text(40);
    assert!(text.lines().count() <= 40, "{text}");
    (text, difference.worse)
}

fn of_checks(rows: Vec<CheckRow>) -> (String, bool) {
    told(&tree(&checks()), &tree(&rows))
}

#[test]
fn what_moved_among_the_checks_is_told_as_what_it_is() {
    let changed = |change: &dyn Fn(&mut Vec<CheckRow>)| {
        let mut rows = checks();
        change(&mut rows);
        of_checks(record::numbered(rows))
    };
    assert_eq!(changed(&|_| ()), ("a tree → a tree: nothing moved.\n".to_string(), false));
    let renamed = |row: &mut CheckRow| {
        if row.quantity == "profile" {
            row.quantity = "pressure profile".into();
        }
    };
    let spoiled = |row: &mut CheckRow| *row = check(&row.case, &row.trial, &row.quantity, 20.0 * row.error);
    let bound = |reference: f64| {
        let (relation, tolerance) = (Relation::AtLeast, 0.0);
        tree(&[CheckRow { relation, reference, tolerance, ..check("a", "b", "order", 0.0) }])
    };
    let asked = |runs: usize| {
        let worst = "pin × run 4".into();
        CheckRow { runs, worst, ..check(record::EVERY_RUN, "", "imbalance", 1e-3) }
    };
    let failing = CheckRow { error: 0.1, verdict: Mark::Fail, ..asked(30) };
    // What is told and whether it is worse, whether that is so, what must be in it, and what must not.
    type Told<'a> = ((String, bool), bool, &'a [&'a str], &'a [&'a str]);
    let twice = |first: Mark| {
        changed(&|rows: &mut Vec<CheckRow>| rows.insert(0, CheckRow { verdict: first, ..rows[0].clone() }))
    };
    let cases: [Told; 12] = [
        (
            changed(&|rows| rows.iter_mut().for_each(spoiled)),
            true,
            &[
                "Verdicts that got WORSE against closed forms, other codes and measurements: 30 checks (30 analytic)",
                "10 checks of 2 cases, half-width against Hertz; most pin × run 4: pass → FAIL; error",
                "Error bars that moved: 30 checks (30 analytic)",
                "10 checks of 2 cases, half-width against Hertz, × 20.0; most",
            ],
            &[],
        ),
        (
            changed(&|rows| rows.retain(|row| row.case != "pin")),
            false,
            &["Checks that are GONE: 15 checks (15 analytic)", "15 checks, the whole case pin; first pin × run 0"],
            &[],
        ),
        (
            changed(&|rows| rows.iter_mut().for_each(renamed)),
            false,
            &[
                "Checks that are GONE: 10 checks (10 analytic)",
                "10 checks of 2 cases, profile against Hertz",
                "New checks: 10 checks (10 analytic)",
            ],
            &["moved"],
        ),
        (
            changed(&|rows| rows.push(check("cylinder", "run 9", "centre", f64::NAN))),
            true,
            &[
                "New checks that FAIL: 1 check (1 analytic)",
                "cylinder × run 9, centre against Hertz: error not a number, tolerance 1.0 %",
            ],
            &["New checks:"],
        ),
        (told(&bound(0.9), &bound(0.8)), false, &["Tolerances LOOSENED: 1 check"], &[]),
        (told(&bound(0.9), &bound(0.95)), false, &["Tolerances tightened: 1 check"], &[]),
        (
            told(&tree(&[asked(30)]), &tree(&[asked(29)])),
            false,
            &["Checks asked of FEWER runs: 1 check", "imbalance against Hertz: 30 runs → 29 runs"],
            &[],
        ),
        (told(&tree(&[asked(30)]), &tree(&[failing])), true, &["pin × run 4", "pass → FAIL"], &[]),
        (
            changed(&|rows| rows[0].reference = 101.0),
            false,
            &["Numbers that moved: 1 check", "reference 100 → 101"],
            &["GONE"],
        ),
        (changed(&|rows| rows[0].share = 0.5), false, &["Numbers that moved: 1 check", "11 % → 50 %"], &[]),
        (
            changed(&|rows| rows[0].kind = ReferenceKind::SelfConsistency),
            false,
            &["Checks held against ANOTHER kind of truth: 1 check", "analytic → self-consistency"],
            &["files with other lines"],
        ),
        (twice(Mark::Pass), false, &["New checks: 1 check"], &[]),
    ];
    for ((text, worse), wanted, says, silent) in &cases {
        assert_eq!(worse, wanted, "{text}");
        says.iter().for_each(|part| assert!(text.contains(part), "no `{part}` in {text}"));
        silent.iter().for_each(|part| assert!(!text.contains(part), "`{part}` in {text}"));
    }
}

#[test]
fn surveys_tell_columns_and_rows_and_statements_their_judgement() {
    let (text, _) = replaced("snapshots/met.csv", "hertz,2,true,0.2", "hertz,2,false,0.4");
    for part in [
        "snapshots/met.csv: 1 of 2 rows changed\n",
        "hertz × 2, error: 0.2 → 0.4 (doubled)",
        "hertz × 2, met: true → false",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let (text, _) = replaced("snapshots/statements.csv", "reproduced", "not reproduced");
    assert!(text.contains("It holds, judgement: reproduced → not reproduced"), "{text}");
}

#[test]
fn loosened_tolerance_is_told_first() {
    let mut rows = checks();
    rows[3].tolerance = 0.05;
    rows[3].share = rows[3].error / 0.05;
    let (text, worse) = of_checks(record::numbered(rows));
    let second = text.lines().nth(1).expect("a heading");
    assert_eq!(second, "Tolerances LOOSENED: 1 check (1 analytic)", "{text}");
    assert!(text.contains("tolerance 1.0 % → tolerance 5.0 %"), "{text}");
    assert!(!worse && !text.contains("GONE") && !text.contains("Numbers that moved"), "{text}");
}

#[test]
fn failures_against_truths_come_first_and_stale_records_are_one_last_line() {
    let mut rows = checks();
    let own = |case: &str, against: &str| CheckRow {
        kind: ReferenceKind::SelfConsistency,
        against: against.into(),
        ..check(case, "all scenes", "recomputed record", 0.0)
    };
    rows.extend([own("bars", "snapshots/coverage.csv"), own("atlas", "snapshots/met.csv"), own("swapped", "itself")]);
    let before = tree(&record::numbered(rows.clone()));
    let fail = |row: &mut CheckRow, share: f64| {
        (row.error, row.share, row.verdict) = (share * row.tolerance, share, Mark::Fail);
    };
    // Ten fail against Hertz, the last by most; all that is held against itself or a record does by more.
    (0..10).for_each(|k| fail(&mut rows[3 * k], 2.0 + k as f64));
    fail(&mut rows[4], 50.0);
    rows[30..].iter_mut().for_each(|row| fail(row, 1000.0));
    // A record of which another part is recomputed is stale, too, and no new check.
    rows[30].place = "of 92".into();
    // A tolerance that is three bars, and one that somebody loosened.
    (rows[1].tolerance, rows[1].bar) = (2.0 * rows[1].tolerance, rows[1].bar.map(|bar| 2.0 * bar));
    rows[2].tolerance *= 2.0;
    let after = tree(&record::numbered(rows));
    let difference = Difference::of(&before, &after);
    let (text, _) = told(&before, &after);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[1].starts_with("Verdicts that got WORSE against closed forms"), "{text}");
    assert!(lines[2].contains("→ 50 %") && lines[3].contains("10 checks of 2 cases"), "{text}");
    let at = |start: &str| {
        lines.iter().position(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start}: {text}"))
    };
    let order = [
        "Tolerances LOOSENED: 1 check",
        "Verdicts that got WORSE: 1 check",
        "Tolerances wider as the error bars that they follow: 1 check",
    ];
    assert!(order.map(at).is_sorted(), "{text}");
    assert!(!text.contains("New checks that FAIL"), "{text}");
    assert_eq!(lines.last(), Some(&"STALE records: 2 (`snapshots/coverage.csv`, `snapshots/met.csv`)"), "{text}");
    assert!(difference.worse && difference.laxer);
    // Records of other sources alone make no verdict worse.
    let record = |verdict: Mark, error: f64| {
        tree(&[CheckRow {
            verdict,
            error,
            share: f64::INFINITY,
            tolerance: 0.0,
            ..own("faults", "snapshots/fuzz.json")
        }])
    };
    let old = record(Mark::NotRun, 1.0);
    let (text, worse) = told(&record(Mark::Pass, 0.0), &old);
    assert!(!worse && text.contains("no verdict got worse") && text.contains("STALE records: 1"), "{text}");
    let (text, _) = told(&old, &record(Mark::NotRun, 3.0));
    // Of other sources before and after, they are not told among numbers that moved either.
    assert!(text.contains("STALE records: 1") && !text.contains("Numbers that moved"), "{text}");
    // Of another number of runs it is the same check, and of fewer a laxer one; of another case or place it is not.
    let of = |case: &str, place: &str, runs: usize| {
        tree(&[CheckRow { place: place.into(), runs, ..check(case, "all", "share", 1e-3) }])
    };
    let is_laxer = |after: &Tree| Difference::of(&of("faults", "mutant", 404), after).laxer;
    assert!(!is_laxer(&of("faults", "mutant", 421)) && is_laxer(&of("faults", "mutant", 403)));
    assert!(is_laxer(&of("faults", "fault", 421)) && is_laxer(&of("atlas", "mutant", 421)));
    // A bar at round-off has few digits.
    let small = |tolerance: f64, bar: f64| tree(&[CheckRow { tolerance, bar: Some(bar), ..check("a", "b", "c", 0.0) }]);
    assert!(!Difference::of(&small(2.501e-9, 3e-9), &small(3.501e-9, 4e-9)).laxer);
    assert!(Difference::of(&small(2.501e-9, 3e-9), &small(9e-9, 4e-9)).laxer);
    // What follows a bar alone is not laxer; what is gone is.
    let mut rows = checks();
    (rows[1].tolerance, rows[1].bar) = (2.0 * rows[1].tolerance, rows[1].bar.map(|bar| 2.0 * bar));
    assert!(!Difference::of(&tree(&checks()), &tree(&rows)).laxer);
    assert!(Difference::of(&tree(&checks()), &tree(&checks()[1..])).laxer);
}

#[test]
fn work_that_changed_alike_is_one_row() {
    let before = tree(&checks());
    let halved = |run: &str| (format!("snapshots/cylinder@{run}.snap"), SNAPSHOT.replace("tions: 40", "tions: 20"));
    let after = before.with("another", ["line", "layer", "node"].map(halved).into(), &[]);
    let (text, _) = told(&before, &after);
    assert!(text.contains("snapshots of runs: 3 of 3 rows changed"), "{text}");
    assert!(text.contains("3 rows, back-substitutions, halved; most cylinder × layer: 40 → 20 (halved)"), "{text}");
}

#[test]
fn timings_measured_anew_are_apart_and_within_noise_where_spreads_overlap() {
    let path = "snapshots/timings/measured.json";
    let (text, worse) = replaced(path, "\"median\": 2.0", "\"median\": 2.5");
    let within = "snapshots/timings/measured.json: 0 of 3 rows changed, 1 within error bars or spreads\n";
    assert!(text.ends_with(within) && !worse, "{text}");
    let slow = "\"median\": 20.0, \"least\": 10.0, \"most\": 30.0";
    let (text, _) = replaced(path, "\"median\": 2.0, \"least\": 1.0, \"most\": 3.0", slow);
    assert!(
        text.contains("measured.json: 1 of 3 rows changed\n") && text.contains("median: 2.0 → 20.0 (× 10.0)"),
        "{text}"
    );
    let (text, _) = replaced(path, "\"dofs\": 9", "\"dofs\": 10");
    assert!(text.contains("growth › 0, dofs: 9 → 10"), "{text}");
}

#[test]
fn references_that_stay_within_their_bars_are_counted_and_the_others_told() {
    let path = "snapshots/references.csv";
    let table =
        |value: &str, bound: &str| format!("case,quantity,value,bar\npin,peak,{value},{bound}\npin,width,2,0.1\n");
    let before = tree(&checks()).with("before", vec![(path.into(), table("1.0", "0.1"))], &[]);
    let moved = |value: &str, bound: &str| {
        told(&before, &before.with("after", vec![(path.into(), table(value, bound))], &[])).0
    };
    let text = moved("1.15", "0.1");
    assert!(text.ends_with("references.csv: 0 of 2 rows changed, 1 within error bars or spreads\n"), "{text}");
    let text = moved("1.25", "0.1");
    assert!(text.contains("references.csv: 1 of 2 rows changed\n  pin × peak, value: 1.0 → 1.25 (× 1.25)"), "{text}");
    // A wider bar hides nothing: it is told itself.
    assert!(moved("1.25", "0.2").contains("pin × peak, bar: 0.1 → 0.2 (doubled)"));
}

#[test]
fn exchanged_palette_moves_no_data_and_a_recoloured_part_does() {
    let path = "snapshots/charts/one.svg";
    let (text, _) = replaced(path, "#0072B2", "#D55E00");
    assert!(
        text.contains("Charts that look otherwise, no data moved: 1 chart\n  snapshots/charts/one.svg, only fill"),
        "{text}"
    );
    let (text, _) = replaced(path, "M0 0L1 1", "M0 0L1 2");
    assert!(text.contains("Charts whose data moved: 1 chart\n  snapshots/charts/one.svg"), "{text}");
    let looks = |before: &str, after: &str| no_data(before, after).map(|names| names.join(", "));
    assert_eq!(looks(CHART, &CHART.replace("<text>a", "<text>b")).as_deref(), Some("words"));
    let styled = |sheet: &str| CHART.replace("<path", &format!("<style>{sheet}</style><path"));
    assert_eq!(looks(&styled("[fill]{fill:#111111}"), &styled("[fill]{fill:#222222}")).as_deref(), Some("style"));
    assert_eq!(looks(&styled("a"), &styled("b").replace("<text>a", "<text>b")).as_deref(), Some("style, words"));
    // Of two parts of one colour only one has another: in a map that is data.
    let map = "<svg><path d=\"M0\" fill=\"#111111\"/><path d=\"M1\" fill=\"#111111\"/></svg>";
    assert_eq!(looks(map, &map.replacen("#111111", "#222222", 1)), None);
    assert_eq!(looks(map, &map.replace("#111111", "#222222")).as_deref(), Some("fill"));
    // Nor are drawings alike where one cannot be read, or a part has no colour any more.
    assert_eq!(looks(map, &map.replace("</svg>", "<")), None);
    assert_eq!(looks(map, &map.replace(" fill=\"#111111\"", "")), None);
}

#[test]
fn record_that_cannot_be_read_is_said_and_is_laxer() {
    let before = tree(&checks());
    let text = before.text(CHECKS).expect("there").to_owned();
    let spoiled = |text: String| before.with("another", vec![(CHECKS.into(), text)], &[]);
    let marked = spoiled(text.replacen("cases,", "<<<<<<< HEAD\ncases,", 1));
    let empty = spoiled(text.replacen(",near,", ",,", 1));
    let mut gone = before.clone();
    gone.files.remove(CHECKS);
    for after in [&marked, &empty, &gone] {
        let difference = Difference::of(&before, after);
        assert!(difference.laxer, "{}", difference.text(9));
        let text = difference.text(9);
        assert!(
            text.contains("verdicts, tolerances and bars are not compared") && !text.contains("no verdict"),
            "{text}"
        );
    }
    assert!(Difference::of(&marked, &before).laxer && !Difference::of(&gone, &before).laxer);
    // A row that fails beside one of the same key that passes, on either side of it.
    for at in [0, 1] {
        let mut rows = checks();
        rows.insert(at, CheckRow { verdict: Mark::Fail, ..rows[0].clone() });
        assert!(Difference::of(&before, &tree(&rows)).worse, "{at}");
    }
    let own = |kind| tree(&[CheckRow { kind, ..check("a", "b", "c", 1e-3) }]);
    let [truth, itself] = [ReferenceKind::Analytic, ReferenceKind::SelfConsistency].map(own);
    assert!(Difference::of(&truth, &itself).laxer && !Difference::of(&itself, &truth).laxer);
}

#[test]
fn base_without_a_record_is_said_and_the_rest_is_compared() {
    let after = tree(&checks());
    let mut before =
        after.with("an old commit", vec![("snapshots/charts/one.svg".into(), "<svg/>".into())], &[CHECKS.into()]);
    before.files.remove(CHECKS);
    let (text, worse) = told(&before, &after);
    assert!(
        text.contains(
            "an old commit has no snapshots/checks.csv: checks, verdicts, tolerances and bars are not compared"
        ),
        "{text}"
    );
    assert!(!worse && text.contains("Charts whose data moved: 1"), "{text}");
}

#[test]
fn markdown_shows_charts_before_and_after_side_by_side() {
    let before = tree(&checks());
    let moved = CHART.replace("M2 2", "M3 3");
    let after = before.with("another", vec![("snapshots/charts/one.svg".into(), moved)], &[]);
    let text = Difference::of(&before, &after).markdown(40, &["old/".into(), String::new()]);
    let row = "| ![snapshots/charts/one.svg](old/snapshots/charts/one.svg) | \
        ![snapshots/charts/one.svg](snapshots/charts/one.svg) |";
    assert!(text.contains(row), "{text}");
}

#[test]
fn round_off_is_nothing_and_four_digits_are_kept() {
    assert_eq!([3e-17, -2e-12, 4.9e-10].map(floored).map(f64::to_bits), [0.0f64; 3].map(f64::to_bits));
    assert_eq!(floored(4.63e-9).to_bits(), 5e-9f64.to_bits());
    assert_eq!(floored(0.000_559_318_862).to_bits(), 0.000_559_3f64.to_bits());
    assert!(floored(f64::NAN).is_nan());
}

#[test]
fn checks_that_nothing_tells_apart_are_numbered() {
    let rows = record::numbered(vec![check("a", "b", "c", 1e-3), check("a", "b", "c", 2e-3)]);
    assert_eq!(rows.iter().map(|row| row.place.as_str()).collect::<Vec<_>>(), ["", "#2"]);
}
