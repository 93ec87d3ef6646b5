//! Reference answers: their bounds hold the error where a closed form tells it, scripts of `oracles/high` found them
//! too, and sheets publish them.

use std::collections::{BTreeMap, BTreeSet};

use contact_vv::accuracy::reference::{Answer, Known, answer};
use contact_vv::case::Verdict;
use contact_vv::case::library::{Bars, Cylinder, NAMES, PinPlate, TruncatedHertz};
use contact_vv::checkout::root;
use contact_vv::markdown::significant;
use contact_vv::measure::{Quantity, relative_error};
use contact_vv::oracle::cross_code::frozen::hash_of;
use contact_vv::oracle::cross_code::high::{ASK_AGAIN, High, Way};
use contact_vv::oracle::cross_code::independent::Independent;
use contact_vv::study::Study;
use contact_vv::study::fitted::LOADS;
use contact_vv::study::references::{Answered, Numbers, solve};
use contact_vv::study::sheet::{BUILT_IN, FoundBy, Other, Sheet, schema};
use serde_json::Value;

use crate::outputs::contact_vv;
use crate::program::Folder;
use crate::scene_file::text_of;
use crate::workbench::spoiled;

fn of(known: &[Known], quantity: Quantity) -> &Known {
    known.iter().find(|one| one.quantity == quantity).expect("known")
}

#[test]
fn bounds_of_reference_answers_hold_the_error_of_truncated_hertz_and_are_below_1e_5() {
    for factor in LOADS.into_iter().step_by(2) {
        let numbers = TruncatedHertz::default().under(factor);
        let (hertz, known) = (numbers.closed_form(), answer(&numbers.scene()).expect("answered").known);
        let truths = [
            (Quantity::Pressure { at: 0.0 }, hertz.peak_pressure()),
            (Quantity::PeakPressure, hertz.peak_pressure()),
            (Quantity::PeakPlace, 0.0),
            (Quantity::SecondMomentWidth, hertz.half_width()),
            (Quantity::End(0), hertz.half_width()),
            (Quantity::Resultant, hertz.load),
        ];
        for (quantity, truth) in truths {
            let one = of(&known, quantity.clone());
            let error = (one.value - truth).abs();
            assert!(error <= one.bar, "{quantity:?} at {factor}: {error:e} > {:e}", one.bar);
            assert!(one.bar <= 1e-5 * one.scale, "{quantity:?} at {factor}: {:e} of {}", one.bar, one.scale);
        }
    }
}

#[test]
fn a_pin_of_persson_ends_where_his_angle_says_up_to_what_the_rim_of_the_plate_does() {
    let known = answer(&PinPlate::of_half_angle(60.0).scene()).expect("answered").known;
    assert!(relative_error(of(&known, Quantity::End(0)).value.to_degrees(), 60.0) <= 3e-3);
}

#[test]
fn a_contact_that_no_mesh_can_be_fitted_to_has_no_reference_answer() {
    assert!(answer(&Bars::default().scene()).is_err());
}

#[test]
fn a_number_that_another_mesh_or_8_node_cells_contradict_turns_its_check_red() {
    let Answer { known, .. } = answer(&Cylinder::default().scene()).expect("answered");
    let sound: Vec<_> = known
        .into_iter()
        .map(|known| Answered { known, unit: "", eight: None, others: vec![], digits: 1e-6 })
        .collect();
    let failed = |known: &[Answered]| {
        let judged = Numbers::Answer { dofs: [0; 5], known: known.into() }.judge().expect("judged").into_iter();
        judged.filter(|one| one.verdict != Verdict::Pass).map(|one| one.check.quantity.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(failed(&sound), Vec::<String>::new());
    let with = |spoil: &dyn Fn(&mut Answered)| {
        let own = |one: &&mut Answered| one.known.quantity == Quantity::SecondMomentWidth;
        failed(&spoiled(&sound, |all| spoil(all.iter_mut().find(own).expect("measured"))))
    };
    let wide = "relative error bar of a reference answer, second-moment-width";
    assert_eq!(with(&|one| one.known.bar = 2e-5 * one.known.scale), [wide]);
    assert_eq!(with(&|one| one.known.bar = f64::NAN), [wide]);
    let off = "difference of 8-node cells over what both may be off, second-moment-width";
    assert_eq!(with(&|one| one.eight = Some([1.01 * one.known.value, 1e-3 * one.known.value])), [off]);
    assert_eq!(with(&|one| one.eight = Some([f64::NAN; 2])), [off]);
    let (differs, rough) = (
        "difference over what both may be off, second-moment-width",
        "difference and error bar of theirs, relative, second-moment-width",
    );
    // What another found beside it: sound, out of both bounds, within its own wide bar, and no number.
    let other = |off: f64, bar: f64| {
        with(&|own| {
            let value = (1.0 + off) * own.known.value;
            own.others = vec![Other { by: "another", value, bar, of_high_order: false }];
        })
    };
    assert_eq!(other(1e-9, 1e-9), Vec::<String>::new());
    assert_eq!(other(5e-7, 1e-9), [differs]);
    assert_eq!(other(5e-6, 1e-9), [differs, rough]);
    assert_eq!(other(0.0, 1e-4), [rough]);
    assert_eq!(other(f64::NAN, 1e-9), [differs, rough]);
    assert_eq!(other(0.0, f64::NAN), [differs, rough]);
}

fn green(sheet: &Sheet) -> bool {
    Numbers::Sheet(sheet.clone()).judge().expect("judged").iter().all(|one| one.verdict == Verdict::Pass)
}

#[test]
fn a_value_that_another_code_does_not_meet_turns_red() {
    // Those of reference answers are judged there.
    let sound = solve("cylinder-between-plates").expect("solved");
    assert!(green(&sound));
    let asked: Vec<usize> = (0..sound.values.len()).filter(|&k| !sound.values[k].others.is_empty()).collect();
    assert_eq!(asked.len(), 5, "peak, second-moment width, end, p(0), approach");
    for k in asked {
        for times in [0.996, 1.004, f64::NAN] {
            let ours = spoiled(&sound, |sheet| sheet.values[k].value *= times);
            let theirs = spoiled(&sound, |sheet| sheet.values[k].others[0].value *= times);
            assert!(!green(&ours) && !green(&theirs), "{} times {times}", sound.values[k].quantity);
        }
    }
    let unbounded = |sheet: &mut Sheet| sheet.values.iter_mut().for_each(|value| value.bar = f64::NAN);
    assert!(!green(&spoiled(&sound, unbounded)));
}

#[test]
fn other_codes_have_answered_cases_of_the_library_and_no_file_of_the_same_name() {
    let sheet = solve("sphere").expect("solved");
    assert!(green(&sheet));
    let peak = sheet.values.iter().find(|one| one.quantity == "peak-pressure").expect("a peak");
    assert_eq!(peak.others.len(), 3, "{peak:?}");
    let folder = Folder::made();
    let file = folder.with("cylinder.toml", text_of("blocks.toml"));
    assert!(contact_vv(&["export", &file, &folder.at("exported")]).0);
    let sheet = folder.read("exported/cylinder.md");
    assert!(sheet.contains("peak-pressure") && !sheet.contains("NGSolve"), "{sheet}");
}

#[test]
fn values_as_data_are_those_of_the_sheets_confirmed_only_by_codes_that_meet_them() {
    let sound = solve("truncated-hertz").expect("solved");
    let published = sound.published();
    let peak = |sheet: &Sheet| sheet.values.iter().find(|one| one.quantity == "peak-pressure").expect("a peak").clone();
    let (ours, one) = (peak(&sound), peak(&published));
    // The closed form is of the very scene, and our own cells are among those that found it.
    assert_eq!((one.found, one.bar), (FoundBy::ClosedForm, 0.0));
    assert_eq!(one.confirmed_by.len(), 1 + ours.others.len());
    // To no better than springs and meshes of the codes with a penalty leave.
    for by in &one.confirmed_by {
        assert!((by.value - one.value).abs() + by.bar <= 1.06 * by.to * one.value && by.to <= 2.2e-3, "{by:?}");
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
            let told = format!("± {} (", significant(by["bar"].as_f64().expect("a number"), 2));
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
        let bar = value["bar"].as_f64().filter(|_| value["value"].is_number());
        assert!(bar.is_none_or(|bar| bar >= 0.0), "{value}");
    }
}

/// Trials of the study `references`, and the scene of the independent scripts of which the numbers are.
const SCENES: [(&str, &str); 5] = [
    ("cylinder", "cylinder, a/R = 0.05"),
    ("cylinder, a/R = 0.1", "cylinder, a/R = 0.1"),
    ("cylinder-between-plates", "cylinder, a/R = 0.05"),
    ("pin-plate", "pin in plate"),
    ("pin-rod", "pin-rod"),
];

fn frozen() -> High {
    High::built_in().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn frozen_answers_of_high_order_are_those_of_the_scripts() {
    let scripts = hash_of(&root().join("oracles/high")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(frozen().scripts, scripts, "{ASK_AGAIN}");
}

#[test]
fn scenes_of_high_order_are_ours() {
    let (frozen, ours) = (frozen(), Independent::built_in().unwrap_or_else(|error| panic!("{error}")));
    assert_eq!(frozen.scenes.keys().map(String::as_str).collect::<Vec<_>>(), SCENES.map(|(name, _)| name));
    for (name, of) in SCENES {
        assert_eq!(frozen.scenes[name].scene.numbers, ours.scenes[of].scene.numbers, "{name}");
        assert!(name.starts_with(&frozen.scenes[name].scene.case), "{name}");
    }
}

#[test]
fn both_ways_of_high_order_tell_the_same_numbers_within_what_they_may_be_off() {
    for (name, asked) in frozen().scenes {
        let [boundary, elements] =
            Way::ALL.map(|way| asked.answers.get(&way).unwrap_or_else(|| panic!("{name}: {way:?}")));
        let told = |numbers: &BTreeMap<String, [f64; 2]>| numbers.keys().cloned().collect::<BTreeSet<_>>();
        assert_eq!(told(&boundary.numbers), told(&elements.numbers), "{name}");
        assert!(told(&boundary.numbers).len() >= 5, "{name}: {:?}", told(&boundary.numbers));
        for (key, [value, bar]) in &boundary.numbers {
            let [other, off] = elements.numbers[key];
            assert!((value - other).abs() <= bar + off, "{name}, {key}: {value} ± {bar:e}, {other} ± {off:e}");
            let scale = if key == "peak-place" { boundary.numbers["end"][0] } else { value.abs() };
            assert!(bar + off <= 1e-6 * scale, "six digits of {name}, {key}: ± {bar:e}, ± {off:e}");
        }
    }
}
