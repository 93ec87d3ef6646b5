//! All nine formulations on one scene: a row for each, whatever becomes of it, and the command that converges where
//! another does not; and one scene under many loads.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use contact_vv::cli;
use contact_vv::solution::Outcome;
use contact_vv::solve::Run;
use contact_vv::solve::curve::CurvePoint;
use serde_json::Value;

use crate::balance::solved_as_it_says;
use crate::outputs::{contact_vv, json, refuses, scene};
use crate::program::Folder;
use crate::scene_file::{scene_alone, text_of};
use crate::workbench::parsed;

/// Whether the command ended well, and its rows.
fn rows(arguments: &[&str]) -> (bool, Vec<Value>) {
    let (well, text, told) = contact_vv(&[&["compare"], arguments, &["--json", "-"]].concat());
    let document: Value = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}{told}"));
    (well, document["formulations"].as_array().expect("rows").clone())
}

/// Words of a command that was told, after the program's name.
fn words(command: &str) -> Vec<&str> {
    command.split_whitespace().skip(1).collect()
}

fn solved(command: &str) -> Value {
    let quiet = [words(command), vec!["--no-error-bar", "--json", "-"]].concat();
    let (_, text, told) = contact_vv(&quiet);
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{command}: {error}: {told}"))
}

#[test]
fn every_row_is_what_its_command_solves_and_the_first_has_the_fewest_operations() {
    let path = scene("rigid-cosine");
    for (case, every) in [("cylinder", 3), (path.as_str(), 1)] {
        let (well, rows) = rows(&[case]);
        assert!(well && rows.len() == 9, "{case}: {} rows", rows.len());
        for row in rows.iter().step_by(every) {
            let run = solved(row["command"].as_str().expect("a command"));
            assert_eq!((&row["outcome"], &row["steps"]), (&run["outcome"], &run["steps"]), "{row}");
            assert!(row["error"].as_f64().is_some_and(|error| error <= 1e-3) && row["reason"].is_null(), "{row}");
        }
        let operations: Vec<f64> = rows.iter().filter_map(|row| row["operations"].as_f64()).collect();
        assert!(operations.len() == 9 && operations.is_sorted(), "{case}: {operations:?}");
    }
}

#[test]
fn command_of_a_row_has_every_digit_of_the_tolerance() {
    let (_, rows) = rows(&["bars", "--formulations", "node.kinematic", "--tolerance", "2.5e-4"]);
    let command = rows[0]["command"].as_str().expect("a command");
    assert!(command.ends_with(" --tolerance 2.5e-4"), "{command}");
}

#[test]
fn formulation_that_cannot_take_the_scene_is_a_row_with_its_reason_behind_the_others() {
    let (well, rows) = rows(&["press-fit"]);
    assert!(well && rows.len() == 9);
    let (answers, refused) = rows.split_at(6);
    assert!(answers.iter().all(|row| row["outcome"] == "converged" && row["reason"].is_null()), "{answers:?}");
    for row in refused {
        let reason = row["reason"].as_str().expect("a reason");
        assert!(row["outcome"] == "refused" && row["steps"].is_null() && reason.contains("interference"), "{row}");
    }
    let (_, text, _) = contact_vv(&["compare", "press-fit"]);
    assert!(text.lines().count() > 1 + 10 + 3 && text.contains("fewest operations"), "{text}");
    let number = |row: &Value, key: &str| row[key].as_f64().expect("a number");
    let told = |row: &Value| (number(row, "operations").round(), number(row, "error"));
    let least = answers.iter().min_by(|a, b| told(a).partial_cmp(&told(b)).expect("numbers")).expect("answers");
    let [first, second] = [&answers[0], &answers[1]].map(told);
    assert!(first.0 == second.0 && first.1 < 1e-3 * second.1, "of equal work the smaller error: {answers:?}");
    assert_eq!(text.lines().last().map(str::trim), least["command"].as_str(), "what takes the fewest: {text}");
}

#[test]
fn open_contact_and_a_run_that_does_not_converge_are_rows_and_no_command_is_told() {
    let folder = Folder::made();
    let open = scene_alone(&text_of("press-fit.toml")).replace("uniform = -0.02", "uniform = 0.02");
    let (well, open) = rows(&[&folder.with("open.toml", open)]);
    assert!(!well && open.len() == 9 && open.iter().all(|row| row["outcome"] == "no contact"), "{open:?}");
    let (well, slow) = rows(&["cylinder", "--formulations", "line.varying,line.varying+newton"]);
    assert!(well && slow[0]["formulation"] == "line.varying+newton" && slow[0]["reason"].is_null(), "{slow:?}");
    assert!(slow[1]["outcome"] == "not converged" && slow[1]["reason"].as_str().is_some(), "{slow:?}");
    let (well, text, _) = contact_vv(&["compare", "cylinder", "--formulations", "line.varying"]);
    assert!(!well && text.contains("none of them") && !text.contains("fewest operations"), "{text}");
}

#[test]
fn outputs_of_a_comparison_are_its_own_and_a_name_that_is_none_is_refused_with_those_that_are() {
    let folder = Folder::made();
    let [json, plot] = ["all.json", "all.svg"].map(|name| folder.at(name));
    for _ in 0..2 {
        let (well, text, told) = contact_vv(&["compare", "bars", "--json", &json, "--plot", &plot]);
        assert!(well && text.contains("fewest operations"), "{told}");
    }
    let [json, drawn] = ["all.json", "all.svg"].map(|name| folder.read(name));
    assert!(cli::json::is_comparison(&json) && !cli::json::is_result(&json));
    assert!(drawn.contains("<svg") && drawn.contains("iteration error"), "a chart");
    refuses(&["compare", "bars", "--formulations", "line.vary"], &["did you mean `line.varying`", "node.kinematic"]);
    folder.with("all.svg", "mine");
    refuses(&["compare", "bars", "--plot", &plot], &["--force"]);
}

#[test]
fn where_a_run_does_not_converge_the_command_that_is_told_does() {
    let path = scene("cylinder-between-blocks");
    for asked in [
        "cylinder --element line --algorithm varying --acceleration none",
        "cylinder --element line --algorithm constant --acceleration none --stiffness 1e5 --tolerance 1e-6",
        "cylinder --a-over-r 0.1 --resolution 8 --element node --algorithm constant --acceleration none --stiffness \
        1e4",
        &format!("{path} --element line --algorithm varying --acceleration none"),
    ] {
        let (well, _, told) = contact_vv(&[vec!["solve", "--no-error-bar"], asked.split(' ').collect()].concat());
        let command = told.trim().rsplit_once("as was tried: ").map(|(_, command)| command);
        let command = command.unwrap_or_else(|| panic!("{asked}: {told}"));
        assert!(!well && command.starts_with("contact-vv solve"), "{told}");
        let run = solved(command);
        assert_eq!(run["outcome"], "converged", "{command}");
        for kept in ["--a-over-r", "--resolution", "--tolerance"] {
            assert_eq!(asked.contains(kept), command.contains(kept), "{asked}: {command}");
        }
    }
}

fn curve(text: &str) -> (Run, Vec<CurvePoint>) {
    let (discretisation, run) = solved_as_it_says(&parsed(text));
    let curve = discretisation.curve(&run).expect("recovered");
    (run, curve)
}

#[test]
fn half_width_and_peak_grow_as_the_square_root_of_the_load_and_the_approach_as_its_logarithm_says() {
    let (run, curve) = curve(&text_of("load-approach.toml"));
    assert_eq!(curve.len(), 8);
    let (load, modulus) = (22656.0, 210e3 / 0.91);
    let (a, p) = ((4.0 * load * 50.0 / (PI * modulus)).sqrt(), (load * modulus / (PI * 50.0)).sqrt());
    let approach = |point: &CurvePoint| point.contacts[0].approach.expect("pressed at one side");
    for (k, point) in (1..).zip(&curve) {
        let found = &point.contacts[0];
        assert_relative_eq!(point.share, f64::from(k) / 8.0);
        assert_eq!(point.outcome, Outcome::Converged);
        assert_relative_eq!(found.resultant, point.share * load, max_relative = 1e-8);
        assert_relative_eq!(found.half_width, a * point.share.sqrt(), max_relative = 2e-3);
        assert_relative_eq!(found.peak.expect("a limit"), p * point.share.sqrt(), max_relative = 2e-3);
    }
    // δ/P = C − ln P/(π E*), whatever the body at a distance makes of C.
    for k in [1, 3] {
        let falls = approach(&curve[k]) / curve[k].share - approach(&curve[2 * k + 1]) / curve[2 * k + 1].share;
        assert_relative_eq!(falls, load * 2f64.ln() / (PI * modulus), max_relative = 0.01);
    }
    let last = curve[7].contacts[0];
    assert!((last.half_width - run.measures().half_width()).abs() <= 0.0);
    assert!((last.resultant - run.transmitted()).abs() <= 0.0);
    assert_eq!(curve.iter().map(|point| point.iterations).sum::<usize>(), run.solution.work.iterations);
}

#[test]
fn increment_that_does_not_converge_is_the_last_row_with_its_outcome() {
    let text = text_of("load-approach.toml").replace("increments = 8\n", "increments = 8\nmax-iterations = 17\n");
    let (run, curve) = curve(&text);
    assert!(!run.solution.converged() && (2..8).contains(&curve.len()), "{} rows", curve.len());
    let (last, before) = curve.split_last().expect("rows");
    assert_eq!(last.outcome, Outcome::Capped);
    assert!(before.iter().all(|point| point.outcome == Outcome::Converged));
    assert_eq!(curve.iter().map(|point| point.iterations).sum::<usize>(), 17);
    assert_relative_eq!(last.share, run.share());
}

#[test]
fn curve_is_written_by_the_command_line() {
    let folder = Folder::made();
    let file = folder.at("curve.csv");
    let (well, _, error) = contact_vv(&["solve", &scene("load-approach"), "--no-error-bar", "--curve", &file]);
    assert!(well, "{error}");
    let mut rows = csv::Reader::from_path(&file).expect("written");
    let head = rows.headers().expect("a head").clone();
    let column = |name: &str| head.iter().position(|title| title == name).expect("a column");
    let (share, force) = (column("load_factor"), column("resultant_n"));
    let rows: Vec<csv::StringRecord> = rows.records().collect::<Result<_, _>>().expect("rows");
    assert_eq!(rows.len(), 8);
    for row in &rows {
        let number = |k: usize| row[k].parse::<f64>().expect("a number");
        assert_relative_eq!(number(force), 22656.0 * number(share), max_relative = 1e-8);
        assert_eq!((&row[column("outcome")], &row[column("half_width_deg")]), ("converged", ""));
    }
    let steps: u64 = rows.iter().map(|row| row[column("iterations")].parse::<u64>().expect("a count")).sum();
    assert_eq!(json(&["solve", &scene("load-approach"), "--no-error-bar"])["steps"], steps);
    // On an arc half-widths are angles in degrees.
    let file = folder.at("arc.csv");
    let solved = json(&["solve", "pin-rod", "--no-error-bar", "--increments", "2", "--curve", &file]);
    let rows = csv::Reader::from_path(&file).expect("written").into_records().collect::<Result<Vec<_>, _>>();
    let rows = rows.expect("rows");
    let last = rows.last().expect("a row");
    let half_angle = solved["contacts"][0]["half_width"].as_f64().expect("an angle").to_degrees();
    assert_relative_eq!(
        last[column("half_width_deg")].parse::<f64>().expect("a number"),
        half_angle,
        max_relative = 1e-9
    );
    assert_eq!(&last[column("half_width_mm")], "");
}
