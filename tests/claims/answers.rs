//! All that is printed as JSON is of one type, whose schema is published; angles are told in degrees.

use contact_vv::checkout::root;
use contact_vv::cli;
use serde_json::Value;

use crate::outputs::{contact_vv, json, scene};
use crate::program::Folder;
use crate::scene_file::text_of;

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
    assert_eq!((text("unit"), text("kind"), text("because")), ("N", "analytic", "equilibrium"));
    assert!(text("reason").contains("2.4 %") && text("reason").contains("tolerance"), "{off}");
    // The check of `solve` is the same one, under the keys that it had.
    let solved = json(&["solve", &path]);
    let same = &solved["checks"][1];
    for key in ["quantity", "value", "reference", "source", "error", "tolerance", "passed", "verdict", "reason"] {
        assert_eq!(same[key], off[key], "{key}");
    }
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
    assert!(sound && table.contains("contact pressure at s = 45° [MPa]") && !table.contains("0.785"), "{table}");
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
