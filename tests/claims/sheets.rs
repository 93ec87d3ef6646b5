//! Benchmark sheets bite: values that another code does not meet, and values without a bound, turn red. Their values are data, without a checkout.

use contact_vv::case::Verdict;
use contact_vv::case::library::NAMES;
use contact_vv::checkout::root;
use contact_vv::markdown::significant;
use contact_vv::study::Study;
use contact_vv::study::references::{Numbers, solve};
use contact_vv::study::sheet::{BUILT_IN, FoundBy, Sheet, schema};
use serde_json::Value;

use crate::outputs::contact_vv;

fn green(sheet: &Sheet) -> bool {
    Numbers::Sheet(sheet.clone()).judge().expect("judged").iter().all(|one| one.verdict == Verdict::Pass)
}

#[test]
fn a_value_that_another_code_does_not_meet_turns_red() {
    let sound = solve("pin-rod").expect("solved");
    assert!(green(&sound));
    let asked: Vec<usize> = (0..sound.values.len()).filter(|&k| !sound.values[k].others.is_empty()).collect();
    assert_eq!(asked.len(), 7, "peak, its place, second-moment width, end, p(0), force across, approach");
    for k in asked {
        for times in [0.996, 1.004, f64::NAN] {
            let mut spoiled = sound.clone();
            spoiled.values[k].value *= times;
            assert!(!green(&spoiled), "{} times {times}", sound.values[k].quantity);
            let mut spoiled = sound.clone();
            spoiled.values[k].others[0].value *= times;
            assert!(!green(&spoiled), "theirs of {} times {times}", sound.values[k].quantity);
        }
    }
    let mut unknown = sound.clone();
    unknown.values.iter_mut().for_each(|value| value.bound = f64::NAN);
    assert!(!green(&unknown));
}

#[test]
fn values_as_data_are_those_of_the_sheets_confirmed_only_by_codes_that_meet_them() {
    let sound = solve("truncated-hertz").expect("solved");
    let published = sound.published();
    let peak = |sheet: &Sheet| sheet.values.iter().find(|one| one.quantity == "peak-pressure").expect("a peak").clone();
    let (ours, one) = (peak(&sound), peak(&published));
    // The closed form is of the very scene, and our own cells are among those that found it.
    assert_eq!((one.found, one.bound), (FoundBy::ClosedForm, 0.0));
    assert_eq!(one.confirmed_by.len(), 1 + ours.others.len());
    // To no better than springs and meshes of the codes with a penalty leave.
    for by in &one.confirmed_by {
        assert!((by.value - one.value).abs() + by.bound <= 1.06 * by.to * one.value && by.to <= 2.2e-3, "{by:?}");
    }
    let mut spoiled = sound.clone();
    let place = spoiled.values.iter().position(|one| one.quantity == "peak-pressure").expect("a peak");
    spoiled.values[place].others[1].value *= 1.01;
    assert_eq!(peak(&spoiled.published()).confirmed_by.len(), ours.others.len());
    // One number that leaves the closed form makes it one of an idealised scene.
    spoiled.values[place].value *= 1.001;
    assert!(spoiled.published().values.iter().all(|one| one.found != FoundBy::ClosedForm));
    let committed: Vec<Value> = serde_json::from_str(BUILT_IN).expect("JSON");
    let own = committed.iter().find(|sheet| sheet["case"] == "truncated-hertz").expect("a case");
    assert_eq!(*own, serde_json::to_value(&published).expect("JSON"));
}

#[test]
fn program_prints_the_reference_values_of_every_case_and_their_schema() {
    let (sound, printed, error) = contact_vv(&["list", "--references"]);
    assert!(sound && printed == BUILT_IN, "{error}");
    let cases: Vec<Value> = serde_json::from_str(&printed).expect("JSON");
    assert_eq!(cases.iter().map(|one| &one["case"]).collect::<Vec<_>>(), NAMES.map(|(name, _)| name));
    // A half-plane is not the block below the punch, and a point force makes a stress without a limit.
    let of = |case: &str| {
        let own = cases.iter().find(|one| one["case"] == case).expect("a case")["values"].as_array().expect("values");
        own.iter().map(|value| [&value["of"], &value["quantity"], &value["found"]]).collect::<Vec<_>>()
    };
    assert!(of("flat-punch").iter().all(|[_, _, found]| *found != "closed-form"), "{:?}", of("flat-punch"));
    assert!(of("pin-plate").iter().all(|[of, what, _]| *of != "pin" || *what != "largest shear"));
    let citation = std::fs::read_to_string(root().join("CITATION.cff")).expect("a citation");
    assert!(citation.contains(concat!("\nversion: ", env!("CARGO_PKG_VERSION"), "\n")), "{citation}");
    let schema: Value = serde_json::from_str(&schema()).expect("JSON");
    assert!(schema["$id"].as_str().is_some_and(|id| id.starts_with("https://") && !id.contains('#')));
    let half = |case: &Value| case["half_of_symmetric"].as_bool().expect("said");
    let conventions = |case: &Value| [&case["plane"], &case["thickness"]].map(Value::to_string).join(", thickness ");
    for (case, (name, _)) in cases.iter().zip(NAMES) {
        let sheet = std::fs::read_to_string(root().join(format!("snapshots/sheets/{name}.md"))).expect("a sheet");
        let told = match case["plane"] == "axisymmetric" {
            true => "Bodies of revolution about x = 0".into(),
            false => format!("Plane {}.", conventions(case).replace('"', "").replace(".0", "")),
        };
        assert!(sheet.contains(&told), "{name}: {told}");
        assert_eq!(sheet.contains("one half of a symmetric one"), half(case), "{name}");
        // One bar, whether it is read from the sheet or from the values.
        let confirmed = case["values"]
            .as_array()
            .expect("values")
            .iter()
            .flat_map(|value| value["confirmed_by"].as_array())
            .flatten();
        for by in confirmed.filter(|by| !by["by"].as_str().is_some_and(|by| by.starts_with("our"))) {
            let told = format!("± {} (", significant(by["bound"].as_f64().expect("a number"), 2));
            let named = format!("{}: ", by["by"].as_str().expect("a name"));
            let mut cells = sheet.split(['|', ';']).filter(|cell| cell.trim().starts_with(&named));
            assert!(cells.any(|cell| cell.contains(&told)), "{name}: {named}{told}");
        }
        let mut defined = case["values"].as_array().expect("values").iter().map(|value| (half(case), value));
        assert!(defined.all(|(half, value)| value["quantity"] != "resultant"
            || value["definition"].as_str().expect("defined").contains("both halves") == half));
    }
    for value in cases.iter().flat_map(|one| one["values"].as_array().expect("values")) {
        let names = |object: &Value| object.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(value), names(&schema["definitions"]["Value"]["properties"]), "{value}");
        let bound = value["bound"].as_f64().filter(|_| value["value"].is_number());
        assert!(bound.is_none_or(|bound| bound >= 0.0), "{value}");
    }
}
