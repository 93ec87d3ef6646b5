//! Independent codes bite: spoiled answers turn red, other scenes are refused, and the scripts share nothing.

use std::fs;
use std::path::PathBuf;

use contact_vv::case::Judged;
use contact_vv::oracle::cross_code::independent::{Folder, Independent, Script};
use contact_vv::oracle::cross_code::{PhysicalAnswer, PhysicalScene};
use contact_vv::study::Study;
use contact_vv::study::differences::Answers;
use contact_vv::study::independent::run::{Compared, Found, STATIONS, Scene, asked, compare};

use crate::workbench::all_pass;

fn judged(compared: &Compared) -> Vec<Judged> {
    compared.judge().expect("judged")
}

/// The same with the refinement series of a script replaced.
fn with(compared: &Compared, script: Script, series: &[PhysicalAnswer]) -> Compared {
    let mut other = compared.clone();
    for one in &mut other.others {
        if one.script == script {
            one.found = Found::of(script.title(), series).expect("three meshes");
        }
    }
    other
}

#[test]
fn an_answer_that_is_spoiled_anywhere_turns_red() {
    type Spoil = (&'static str, fn(&mut PhysicalAnswer));
    let spoils: [Spoil; 9] = [
        ("peak", |a| a.peak *= 1.002),
        ("width", |a| a.half_width *= 0.999),
        ("resultant", |a| a.resultant *= 1.0 + 2e-5),
        ("profile", |a| a.pressure.iter_mut().for_each(|p| *p *= 1.03)),
        ("a shifted profile", |a| a.pressure.rotate_right(1)),
        ("NaN peak", |a| a.peak = f64::NAN),
        ("NaN width", |a| a.half_width = f64::NAN),
        ("NaN in the profile", |a| a.pressure[3] = f64::NAN),
        ("a missing station", |a| a.pressure.truncate(39)),
    ];
    let frozen = Independent::read().expect("frozen answers");
    for scene in Scene::ALL {
        let sound = compare(&scene.benchmark(), Answers::Frozen).expect("compared");
        assert!(all_pass(&judged(&sound)), "{}", scene.name());
        for (script, series) in &frozen.scenes[scene.name()].series {
            for (what, spoil) in spoils {
                let mut spoiled = series.clone();
                spoil(&mut spoiled[2]);
                assert!(!all_pass(&judged(&with(&sound, *script, &spoiled))), "{}, {script}: {what}", scene.name());
            }
        }
    }
}

#[test]
fn a_scene_with_other_numbers_than_the_frozen_one_is_refused_by_key() {
    for scene in Scene::ALL {
        let given = scene.benchmark();
        assert!(asked(&given, Answers::Frozen).is_ok(), "{}", scene.name());
        let key = given.physical.numbers.keys().next().expect("a scene has numbers").clone();
        type Spoil<'a> = (&'a str, Box<dyn Fn(&mut PhysicalScene) + 'a>);
        let spoils: [Spoil; 3] = [
            (&key, Box::new(|s| s.numbers.values_mut().take(1).for_each(|number| *number *= 1.0 + 1e-9))),
            (&key, Box::new(|s| s.numbers.retain(|name, _| *name != key))),
            ("stations", Box::new(|s| s.stations.truncate(STATIONS - 1))),
        ];
        for (named, spoil) in spoils {
            let mut other = scene.benchmark();
            spoil(&mut other.physical);
            let refused = asked(&other, Answers::Frozen).expect_err("another scene").to_string();
            assert!(refused.contains(named), "{}: {refused}", scene.name());
        }
    }
}

fn scripts(folder: Folder) -> Vec<(PathBuf, String)> {
    let files = fs::read_dir(folder.path()).expect("a folder").map(|entry| entry.expect("readable").path());
    let python = files.filter(|file| file.extension().is_some_and(|extension| extension == "py"));
    python.map(|file| (file.clone(), fs::read_to_string(file).expect("readable"))).collect()
}

fn modules(folder: Folder) -> Vec<String> {
    let name = |(file, _): (PathBuf, String)| file.file_stem().expect("named").to_string_lossy().into_owned();
    scripts(folder).into_iter().map(name).collect()
}

/// Modules that a script imports, wherever the statement stands.
fn imported(text: &str) -> Vec<&str> {
    let words = text.lines().map(str::split_whitespace);
    let first = words.filter_map(|mut words| match words.next() {
        Some("import" | "from") => words.next(),
        _ => None,
    });
    first.map(|module| module.split('.').next().unwrap_or(module).trim_end_matches(',')).collect()
}

#[test]
fn scripts_of_one_code_import_nothing_of_another_and_are_short() {
    let twin: Vec<String> = fs::read_dir(contact_vv::oracle::cross_code::scripts())
        .expect("a folder")
        .map(|entry| entry.expect("readable").path().file_stem().expect("named").to_string_lossy().into_owned())
        .collect();
    for folder in Folder::ALL {
        let others = Folder::ALL.into_iter().filter(|other| *other != folder).flat_map(modules);
        let foreign: Vec<String> = others.chain(twin.clone()).collect();
        let own = modules(folder);
        assert!(!own.is_empty(), "{folder:?}: no script");
        assert!(own.iter().all(|module| !foreign.contains(module)), "{folder:?}: a module of the same name elsewhere");
        for (file, text) in scripts(folder) {
            assert!(text.lines().count() <= 200, "{} is longer than 200 lines", file.display());
            let strange: Vec<&str> =
                imported(&text).into_iter().filter(|module| foreign.iter().any(|other| other == module)).collect();
            assert!(strange.is_empty(), "{} imports {strange:?}", file.display());
            for reflected in ["importlib", "__import__", "sys.path", "exec(", "eval("] {
                assert!(!text.contains(reflected), "{} uses {reflected}", file.display());
            }
        }
    }
}

#[test]
fn imports_are_seen_wherever_they_stand() {
    let text = "import numpy as np\n    from fan import x\nimport models, fan\nfrom skfem.helpers import dot\n";
    assert_eq!(imported(text), ["numpy", "fan", "models", "skfem"]);
}
