//! The comparison with other codes bites: spoiled answers, spoiled scenes, changed scripts.

use contact_vv::case::{Judged, Verdict, library};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::cross_code::Code;
use contact_vv::oracle::cross_code::frozen::{Digest, Frozen, script_hash};
use contact_vv::scene::{Load, Path, PlaneHypothesis, Profile, Scene};
use contact_vv::solve::Discretisation;
use contact_vv::study::answers::reproduced;
use contact_vv::study::cross_code::{Twin, assembled_alike, differences};
use contact_vv::study::differences::{changes, largest_change, relative_difference};

fn all_pass(checks: &[Judged]) -> bool {
    !checks.is_empty() && checks.iter().all(|check| check.verdict == Verdict::Pass)
}

fn against(code: Code, ours: &Digest, theirs: &Digest) -> Vec<Judged> {
    differences(ours, theirs).iter().map(|one| assembled_alike(code, one)).collect()
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
fn a_spoiled_scene_is_not_what_the_other_codes_solved() {
    type Spoil = (&'static str, &'static str, fn(&mut Scene));
    let spoils: [Spoil; 13] = [
        ("cylinder", "E by 0.1 %", |s| s.bodies[0].material.young *= 1.001),
        ("cylinder", "ν by 0.01", |s| s.bodies[0].material.poisson += 0.01),
        ("cylinder", "plane stress", |s| s.plane = PlaneHypothesis::Stress),
        ("cylinder", "thickness", |s| s.thickness *= 1.001),
        ("cylinder", "a dropped load", |s| s.bodies[0].loads.clear()),
        ("cylinder", "a flatter gap", |s| s.contacts[0].profile = Profile::Circle { radius: 50.5 }),
        ("cylinder", "a parabola for the circle", |s| s.contacts[0].profile = Profile::Parabola { radius: 50.0 }),
        ("truncated-hertz", "E by 0.1 %", |s| s.bodies[0].material.young *= 1.001),
        ("truncated-hertz", "a dropped side load", |s| s.bodies[0].loads.truncate(1)),
        ("pin-rod", "E of the rod by 0.1 %", |s| s.bodies[1].material.young *= 1.001),
        ("pin-rod", "ν of the pin by 0.01", |s| s.bodies[0].material.poisson += 0.01),
        ("pin-rod", "clearance by 1 %", |s| s.contacts[0].profile = Profile::Hole { radius: 10.0, clearance: 0.0505 }),
        ("pin-rod", "force by 0.1 %", |s| {
            for load in &mut s.bodies[1].loads {
                if let Load::RigidFace { force, .. } = load {
                    *force *= 1.001;
                }
            }
        }),
    ];
    for (name, what, spoil) in spoils {
        let mut scene = library::find(name, None).expect("a scene of the library").scene;
        spoil(&mut scene);
        let elements = if matches!(scene.contact().path, Path::Arc(_)) { 6 } else { 8 };
        let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
        let twin = Discretisation::of(scene, resolution).and_then(Twin::on);
        if what == "a dropped load" {
            assert!(twin.is_err_and(|error| error.to_string().contains("load")), "{name}, {what}");
            continue;
        }
        let twin = twin.unwrap_or_else(|error| panic!("{name}, {what}: {error}"));
        let digest = frozen(&format!("{name}, 8-node"));
        assert!(!all_pass(&against(Code::Dolfinx, &twin.digest(), &digest)), "{name}: {what}");
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
    let judged = |now: &[(String, Vec<f64>)]| reproduced("scikit-fem", now, &kept, &old.changed_versions(&versions));
    assert!(all_pass(&[judged(&kept)]));
    for spoiled in [1.0 + 1e-5, f64::NAN] {
        let mut now = kept.clone();
        now[1].1[0] *= spoiled;
        let check = judged(&now);
        assert!(check.verdict == Verdict::Fail && check.check.because.contains("scipy"), "{}", check.check.because);
    }
    assert_eq!(judged(&kept[1..]).verdict, Verdict::Fail);
}
