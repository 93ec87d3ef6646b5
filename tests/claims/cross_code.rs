//! The comparison with other codes bites: spoiled answers, spoiled scenes, changed scripts.

use contact_vv::case::library;
use contact_vv::case::{Judged, Verdict};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::cross_code::frozen::{Digest, Frozen, Series, script_hash};
use contact_vv::oracle::cross_code::{Code, Method, PhysicalAnswer};
use contact_vv::scene::{Load, Path, PlaneHypothesis, Profile, Scene};
use contact_vv::solve::Discretisation;
use contact_vv::study::cross_code::Answers;
use contact_vv::study::cross_code::answers::Reproduced;
use contact_vv::study::cross_code::benchmark::Scene as Shared;
use contact_vv::study::cross_code::differences::{changes, largest_change, relative_difference};
use contact_vv::study::cross_code::discrete::differences;
use contact_vv::study::cross_code::judge::{agreement, assembled_alike, reproduced, tight};
use contact_vv::study::cross_code::physical::{Compared, Finder, Found, Measured, Other};
use contact_vv::study::cross_code::twin::{Twin, problems};
use contact_vv::study::cross_code::validation::{self, Number};

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
fn the_sound_scenes_are_what_both_codes_solved() {
    for (name, order) in problems() {
        let twin = Twin::of(name, order).expect("a solvable scene");
        for code in Code::ALL {
            let frozen = Frozen::read(code).expect("frozen results");
            assert!(all_pass(&against(code, &twin.digest(), &frozen.discrete[&twin.problem.name])), "{name}, {code}");
        }
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
fn a_scene_with_other_numbers_than_the_frozen_one_is_refused_by_key() {
    for shared in Shared::ALL {
        let (name, given) = (shared.name(), shared.benchmark());
        let mut scene = given.physical.clone();
        assert!(Answers::Frozen.physical(Code::Dolfinx, name, &scene).is_ok());
        let key = scene.numbers.keys().next().expect("a scene has numbers").clone();
        scene.numbers.entry(key.clone()).and_modify(|number| *number *= 1.0 + 1e-9);
        let refused = Answers::Frozen.physical(Code::Dolfinx, name, &scene).expect_err("another scene");
        assert!(refused.to_string().contains(&key), "{refused}");
        let mut fewer = given.physical.clone();
        fewer.stations.pop();
        assert!(Answers::Frozen.physical(Code::Dolfinx, name, &fewer).is_err());
        let mut unknown = given.physical.clone();
        unknown.numbers.remove(&key);
        assert!(Answers::Frozen.physical(Code::Dolfinx, name, &unknown).is_err());
    }
}

#[test]
fn changed_versions_and_numbers_are_named() {
    let old = Frozen::load(Code::Dolfinx).expect("frozen results");
    let mut new = old.clone();
    assert_eq!(changes(Code::Dolfinx, &old, &new).len(), 1);
    new.versions.insert("numpy".into(), "9.9".into());
    let series = new.physical.get_mut("pin-rod").expect("the pin–rod is frozen");
    series.penalty[2].peak *= 1.01;
    let told = changes(Code::Dolfinx, &old, &new);
    assert!(told[0].contains("numpy") && told[0].contains("9.9"), "{told:?}");
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[1].contains("pin-rod") && told[1].contains("peak"), "{told:?}");
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
fn a_code_that_differs_by_more_than_demanded_turns_red() {
    type Spoil = (&'static str, fn(&mut PhysicalAnswer));
    let spoils: [Spoil; 8] = [
        ("peak", |a| a.peak *= 1.006),
        ("width", |a| a.half_width *= 0.994),
        ("resultant", |a| a.resultant *= 1.0 + 1e-5),
        ("profile", |a| a.pressure.iter_mut().for_each(|p| *p *= 1.02)),
        ("a shifted profile", |a| a.pressure.rotate_right(1)),
        ("NaN peak", |a| a.peak = f64::NAN),
        ("NaN in the profile", |a| a.pressure[3] = f64::NAN),
        ("a missing station", |a| a.pressure.truncate(39)),
    ];
    for shared in Shared::ALL {
        let series = &Frozen::read(Code::ScikitFem).expect("frozen results").physical[shared.name()];
        let sound = physical(shared, &series.penalty, series);
        for found in &sound.others[0].found[..1] {
            assert!(all_pass(&agreement(&sound, found)), "{}", shared.name());
        }
        for (what, spoil) in spoils {
            let mut levels = series.penalty.clone();
            spoil(&mut levels[2]);
            let ours = physical(shared, &levels, series);
            assert!(!all_pass(&agreement(&ours, &ours.others[0].found[0])), "{}: {what} in ours", shared.name());
            let theirs = physical(shared, &series.penalty, &Series { penalty: levels, ..series.clone() });
            assert!(!all_pass(&agreement(&theirs, &theirs.others[0].found[0])), "{}: {what} in theirs", shared.name());
        }
    }
    assert!(Found::of(Finder::Ours, &[]).is_err());
}

/// A scene with given answers for ours, and both methods of a code.
fn physical(scene: Shared, ours: &[PhysicalAnswer], series: &Series) -> Compared {
    let found = |by, levels: &[PhysicalAnswer]| Found::of(by, levels).expect("three meshes");
    let theirs = |method| Finder::Theirs(Code::ScikitFem, method);
    let both =
        vec![found(theirs(Method::Penalty), &series.penalty), found(theirs(Method::ActiveSet), &series.active_set)];
    let ours = found(Finder::Ours, ours);
    Compared {
        scene,
        stations: series.scene.stations.clone(),
        reference: [1.0, 1.0],
        closed_form: None,
        peak_as_theirs: ours.peak.value,
        ours,
        others: vec![Other { code: Code::ScikitFem, reproduced: None, found: both }],
    }
}

#[test]
fn a_difference_that_its_uncertainties_do_not_cover_turns_red_within_the_tolerance() {
    let series = &Frozen::read(Code::ScikitFem).expect("frozen results").physical["truncated Hertz"];
    let compared = physical(Shared::TruncatedHertz, &series.active_set, series);
    let exact = &compared.others[0].found[1];
    for (number, at) in [(Number::Peak, 1), (Number::Width, 3)] {
        let (comparison, _) = validation::against(&compared, exact, number);
        assert!(comparison.uncertainty > 0.0);
        let judged = |by: f64| {
            let mut moved = compared.clone();
            let peak = |measured: &mut Measured| {
                measured.value = number.of(compared.scene, exact).value + by * comparison.uncertainty
            };
            match number {
                Number::Peak => {
                    peak(&mut moved.ours.peak);
                    moved.peak_as_theirs = moved.ours.peak.value;
                }
                Number::Width => peak(&mut moved.ours.half_width),
            }
            agreement(&moved, exact).map(|one| one.verdict)
        };
        assert_eq!(judged(1.9)[at], Verdict::Pass, "{number:?}");
        for by in [2.1, -2.1, f64::NAN] {
            assert_eq!(judged(by)[at], Verdict::Fail, "{number:?}, {by} u");
        }
    }
    // Uncertainties that are not known, or without end, cover nothing.
    for spoiled in [f64::NAN, f64::INFINITY] {
        let mut unknown = compared.clone();
        unknown.ours.peak.uncertainty = spoiled;
        assert_eq!(agreement(&unknown, exact)[1].verdict, Verdict::Fail);
        unknown = compared.clone();
        unknown.peak_as_theirs = spoiled;
        assert_eq!(agreement(&unknown, exact)[1].verdict, Verdict::Fail);
    }
}

#[test]
fn what_the_penalty_costs_is_a_source_of_its_own_and_must_be_known() {
    let series = &Frozen::read(Code::ScikitFem).expect("frozen results").physical["pin-rod"];
    let compared = physical(Shared::PinRod, &series.active_set, series);
    let [soft, exact] = [&compared.others[0].found[0], &compared.others[0].found[1]];
    let (with, sources) = validation::against(&compared, soft, Number::Peak);
    assert!((sources.penalty - (soft.peak.limit - exact.peak.limit).abs()).abs() <= 1e-12);
    assert!(sources.penalty > 0.0 && with.uncertainty > sources.penalty);
    assert!(validation::against(&compared, exact, Number::Peak).1.penalty <= 0.0);
    // Without the code that solves it both ways, the row cannot pass.
    let mut alone = compared.clone();
    alone.others[0].found.truncate(1);
    assert_eq!(agreement(&alone, soft)[1].verdict, Verdict::Fail);
}

#[test]
fn a_tolerance_of_more_than_three_times_what_is_found_turns_red() {
    let series = &Frozen::read(Code::ScikitFem).expect("frozen results").physical["truncated Hertz"];
    let verdicts =
        |ours: &[PhysicalAnswer]| tight(&physical(Shared::TruncatedHertz, ours, series)).map(|one| one.verdict);
    // Nothing differs from the penalty by less than the active set does.
    let red = [Verdict::Fail, Verdict::Fail, Verdict::Fail];
    let nearer: Vec<PhysicalAnswer> =
        series.penalty.iter().zip(&series.active_set).map(|(a, b)| middle(a, b)).collect();
    assert_eq!(verdicts(&nearer), red);
    let mut none = series.penalty.clone();
    none[2].peak = f64::NAN;
    assert_eq!(verdicts(&none)[0], Verdict::Fail);
}

/// The middle of two answers, which differs from either by half as much as they from each other.
fn middle(a: &PhysicalAnswer, b: &PhysicalAnswer) -> PhysicalAnswer {
    let pressure = a.pressure.iter().zip(&b.pressure).map(|(p, q)| 0.5 * (p + q)).collect();
    PhysicalAnswer {
        peak: 0.5 * (a.peak + b.peak),
        half_width: 0.5 * (a.half_width + b.half_width),
        pressure,
        ..a.clone()
    }
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
    let kept = old.physical["truncated Hertz"].numbers();
    let mut versions = old.versions.clone();
    versions.insert("scipy".into(), "9.9".into());
    let judged = |now: &[(String, Vec<f64>)]| {
        reproduced("scikit-fem", &Reproduced::of(now, &kept, old.changed_versions(&versions)))
    };
    assert!(all_pass(&[judged(&kept)]));
    for spoiled in [1.0 + 1e-5, f64::NAN] {
        let mut now = kept.clone();
        now[1].1[0] *= spoiled;
        let check = judged(&now);
        assert!(check.verdict == Verdict::Fail && check.check.because.contains("scipy"), "{}", check.check.because);
    }
    assert_eq!(judged(&kept[1..]).verdict, Verdict::Fail);
}
