//! The comparison with other codes bites: spoiled answers turn red, other scenes and scripts are refused, and the
//! scripts share nothing.

use std::fs;
use std::path::PathBuf;

use contact_vv::case::{Judged, Verdict};
use contact_vv::mesh::Order;
use contact_vv::oracle::cross_code::frozen::{Digest, Frozen, changed_versions, script_hash};
use contact_vv::oracle::cross_code::independent::{Folder, Independent, Script};
use contact_vv::oracle::cross_code::{Code, PhysicalAnswer, PhysicalScene};
use contact_vv::study::Study;
use contact_vv::study::cross_code::{Twin, differences};
use contact_vv::study::differences::{changes, largest_change, relative_difference, reproduced};
use contact_vv::study::independent::run::{Compared, Found, STATIONS, Scene, asked, compare};

use crate::workbench::{all_pass, spoiled};

fn judged(compared: &Compared) -> Vec<Judged> {
    compared.judge().expect("judged")
}

/// The same with the refinement series of a script replaced.
fn with(compared: &Compared, script: Script, series: &[PhysicalAnswer]) -> Compared {
    spoiled(compared, |other| {
        for one in other.others.iter_mut().filter(|one| one.script == script) {
            one.found = Found::of(script.title(), series).expect("three meshes");
        }
    })
}

#[test]
fn an_answer_that_is_spoiled_anywhere_turns_red() {
    type Spoil = (&'static str, fn(&mut PhysicalAnswer));
    let spoils: [Spoil; 9] = [
        ("peak", |a| a.peak *= 1.002),
        ("width", |a| a.half_width *= 0.997),
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
        let sound = compare(&scene.benchmark(), None).expect("compared");
        assert!(all_pass(&judged(&sound)), "{}", scene.name());
        for (script, series) in &frozen.scenes[scene.name()].answers {
            for (what, spoil) in spoils {
                // On every mesh: a number that jumps on the finest one alone makes its own uncertainty wide.
                let spoiled = spoiled(series, |series| series.iter_mut().for_each(spoil));
                assert!(!all_pass(&judged(&with(&sound, *script, &spoiled))), "{}, {script}: {what}", scene.name());
            }
        }
    }
}

#[test]
fn a_scene_with_other_numbers_than_the_frozen_one_is_refused_by_key() {
    for scene in Scene::ALL {
        let given = scene.benchmark();
        assert!(asked(&given, None).is_ok(), "{}", scene.name());
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
            let refused = asked(&other, None).expect_err("another scene").to_string();
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

fn against(code: Code, ours: &Digest, theirs: &Digest) -> Vec<Judged> {
    differences(code, ours, theirs)
}

fn frozen(name: &str) -> Digest {
    Frozen::read(Code::Dolfinx).expect("frozen results").discrete[name].clone()
}

#[test]
fn a_spoiled_number_anywhere_in_an_answer_turns_red() {
    let sound = frozen("pin-rod, 8-node");
    assert!(all_pass(&against(Code::Dolfinx, &sound, &sound)));
    type Spoil = (&'static str, fn(&mut Digest));
    let spoils: [Spoil; 9] = [
        ("a form", |d| d.forms[3][7] += 1e-9 * d.forms[3][3]),
        ("work", |d| d.work[2] *= 1.0 + 1e-9),
        ("a pressure", |d| d.pressure[0][1] *= 1.0 + 1e-6),
        ("a pressure at the second κ", |d| d.pressure[1][0] *= 1.0 + 1e-6),
        ("a displacement", |d| d.moved[1][4] *= 1.0 + 1e-6),
        ("NaN", |d| d.forms[0][0] = f64::NAN),
        ("NaN pressure", |d| d.pressure[0][0] = f64::NAN),
        ("a missing point", |d| d.pressure[1].truncate(1)),
        ("a missing κ", |d| d.moved.truncate(1)),
    ];
    for (name, spoil) in spoils {
        let spoiled = spoiled(&sound, spoil);
        assert!(!all_pass(&against(Code::Dolfinx, &spoiled, &sound)), "{name} in ours");
        assert!(!all_pass(&against(Code::Dolfinx, &sound, &spoiled)), "{name} in theirs");
    }
}

#[test]
fn frozen_results_of_other_scripts_are_refused_with_the_remedy() {
    let frozen = Frozen::load(Code::ScikitFem).expect("frozen results");
    assert!(frozen.clone().of_scripts(Code::ScikitFem, &script_hash().expect("scripts")).is_ok());
    let refused = frozen.of_scripts(Code::ScikitFem, "0123").expect_err("another hash").to_string();
    assert!(refused.contains("scikit-fem.json") && refused.contains("freeze"), "{refused}");
}

#[test]
fn changed_versions_and_numbers_are_named() {
    let old = Frozen::load(Code::Dolfinx).expect("frozen results");
    let mut new = old.clone();
    assert_eq!(changes(Code::Dolfinx, &old, &new).len(), 1);
    new.versions.insert("numpy".into(), "9.9".into());
    let digest = new.discrete.get_mut("pin-rod, 8-node").expect("the pin–rod is frozen");
    digest.pressure[1][0] *= 1.01;
    let told = changes(Code::Dolfinx, &old, &new);
    assert!(told[0].contains("numpy") && told[0].contains("9.9"), "{told:?}");
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[1].contains("pin-rod, 8-node, p (group 4)"), "{told:?}");
    // A library that is not there any more has changed, too.
    new.versions.remove("numpy");
    let told = changes(Code::Dolfinx, &old, &new);
    assert!(told[0].contains(&format!("numpy {}, now absent", old.versions["numpy"])), "{told:?}");
}

#[test]
fn differences_are_not_a_number_where_nothing_can_be_compared() {
    let group = |values: &[f64]| vec![("p".to_string(), values.to_vec())];
    assert!(relative_difference(&[1.0], &[1.0, 2.0]).is_nan());
    assert!(relative_difference(&[], &[]).is_nan());
    assert!(largest_change(&[], &[]).is_nan());
    assert!(relative_difference(&[f64::NAN, 1.0], &[1.0, 1.0]).is_nan());
    assert!(relative_difference(&[1.0, f64::NAN], &[1.0, 1.0]).is_nan());
    assert!(largest_change(&group(&[1.0]), &[]).is_nan());
    assert!(largest_change(&group(&[1.0, 2.0]), &group(&[1.0])).is_nan());
    approx::assert_relative_eq!(largest_change(&group(&[1.0, 2.2]), &group(&[1.0, 2.0])), 0.1, epsilon = 1e-12);
}

#[test]
fn the_fixed_vectors_are_independent() {
    let twin = Twin::of("truncated-hertz", Order::Linear).expect("a solvable scene");
    let vectors = &twin.unknowns;
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let gram = nalgebra::DMatrix::from_fn(vectors.len(), vectors.len(), |i, j| {
        dot(&vectors[i], &vectors[j]) / (dot(&vectors[i], &vectors[i]) * dot(&vectors[j], &vectors[j])).sqrt()
    });
    let smallest = gram.symmetric_eigenvalues().min();
    assert!(vectors.len() == 10 && smallest > 0.5, "{smallest}");
}

#[test]
fn a_live_answer_that_is_not_what_was_frozen_turns_red_and_names_the_version() {
    let old = Frozen::read(Code::ScikitFem).expect("frozen results");
    let kept = old.discrete["truncated-hertz, 8-node"].numbers();
    let versions = spoiled(&old.versions, |versions| drop(versions.insert("scipy".into(), "9.9".into())));
    let judged =
        |now: &[(String, Vec<f64>)]| reproduced("scikit-fem", now, &kept, &changed_versions(&old.versions, &versions));
    assert!(all_pass(&[judged(&kept)]));
    for factor in [1.0 + 1e-5, f64::NAN] {
        let check = judged(&spoiled(&kept, |now| now[1].1[0] *= factor));
        assert!(check.verdict == Verdict::Fail && check.check.because.contains("scipy"), "{}", check.check.because);
    }
    assert_eq!(judged(&kept[1..]).verdict, Verdict::Fail);
}
