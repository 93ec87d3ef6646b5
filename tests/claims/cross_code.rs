//! The comparison with other codes bites: spoiled answers, spoiled scenes, changed scripts.

use contact_vv::case::{Judged, Verdict};
use contact_vv::mesh::Order;
use contact_vv::oracle::cross_code::Code;
use contact_vv::oracle::cross_code::frozen::{Digest, Frozen, changed_versions, script_hash};
use contact_vv::study::cross_code::{Twin, differences};
use contact_vv::study::differences::{changes, largest_change, relative_difference, reproduced};

use crate::workbench::all_pass;

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
        let mut spoiled = sound.clone();
        spoil(&mut spoiled);
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
    let mut versions = old.versions.clone();
    versions.insert("scipy".into(), "9.9".into());
    let judged =
        |now: &[(String, Vec<f64>)]| reproduced("scikit-fem", now, &kept, &changed_versions(&old.versions, &versions));
    assert!(all_pass(&[judged(&kept)]));
    for spoiled in [1.0 + 1e-5, f64::NAN] {
        let mut now = kept.clone();
        now[1].1[0] *= spoiled;
        let check = judged(&now);
        assert!(check.verdict == Verdict::Fail && check.check.because.contains("scipy"), "{}", check.check.because);
    }
    assert_eq!(judged(&kept[1..]).verdict, Verdict::Fail);
}
