//! An accuracy called met is met, whatever the profile, the material, the size and the guess of the contact's length.

use contact_vv::accuracy::{self, Asked};
use contact_vv::case::Verdict;
use contact_vv::measure::Quantity;
use contact_vv::scene::Shape;
use contact_vv::solve::Formulation;
use contact_vv::study::promised::met::{self, Record, consistent, near, record, right};
use contact_vv::study::random::round::OF_SPHERES;
use contact_vv::study::random::{Family, Site, family};
use contact_vv::study::records::Millionths;

use crate::again::MET;
use crate::workbench::spoiled;

/// What the closed forms of cylinders and pins leave out, relative.
const LEFT_OUT: f64 = 1.5e-5;

fn site(family: Family, number: usize) -> Site {
    Site { family, number }
}

#[test]
fn closed_form_of_two_spheres_leaves_out_a_fifth_of_the_half_width_over_the_radius() {
    for number in [9, 24, 28] {
        let number = family::FIRST + number;
        let sample = site(Family::Spheres, number).sample().expect("a scene");
        let found = record(&site(Family::Spheres, number), 2e-5, &sample).expect("solved");
        let radii = sample.scene.bodies.iter().map(|body| match body.shape {
            Shape::Disc { radius, .. } => radius,
            ref other => panic!("{other:?}"),
        });
        let wide = sample.truth(0, &Quantity::HalfWidth) / radii.fold(f64::INFINITY, f64::min);
        assert!(found.error() <= OF_SPHERES * wide && found.error() > 2e-4, "{wide}: {found:?}");
    }
}

#[test]
fn closed_forms_of_cylinder_and_pin_leave_out_little() {
    for (family, number) in [(Family::Cylinder, 38), (Family::Cylinder, 50), (Family::Pin, 2), (Family::Pin, 3)] {
        let sample = site(family, number).sample().expect("a scene");
        let found = record(&site(family, number), 2e-5, &sample).expect("solved");
        assert!(found.error() <= LEFT_OUT, "{}, {number}: {found:?}", family.name());
    }
}

#[test]
fn slow_algorithms_are_run_on_the_mesh_that_kinematic_load_chose() {
    let sample = site(Family::Polynomial, 0).sample().expect("a scene");
    let mut met = 0;
    for formulation in Formulation::nine() {
        let asked = Asked::new(1e-2);
        let answer = accuracy::solve(&sample.scene, &formulation, &asked).expect("solved");
        let name = formulation.name();
        assert_eq!(answer.run.formulation.name(), name);
        assert_eq!(answer.unmet.is_none(), answer.estimate() <= asked.relative, "{name}: {:?}", answer.unmet);
        let found = Record::of(&site(Family::Polynomial, 0), asked.relative, &sample, &answer);
        assert!(!found.is_falsely_met(), "{name}: {found:?}");
        // The estimate is over the value found, the error over the truth.
        assert!(found.error() <= found.estimate.0 / (1.0 - found.estimate.0), "{name}: {found:?}");
        assert!(found.met || answer.unmet.is_some_and(|why| why.contains(&name)), "{name}");
        met += usize::from(found.met);
    }
    // Line and layer elements leave pressures beyond the end by the other two algorithms, which ends are read from.
    assert!(met >= 5, "{met}");
}

fn sound() -> Vec<Record> {
    let one = |number: usize| Record {
        site: site(Family::Wedge, number),
        asked: 1e-3,
        met: true,
        estimate: Millionths(8e-4),
        peak: Millionths(5e-4),
        half_width: Millionths(-2e-4),
        dofs: 1000,
        most_dofs: 3500,
        dofs_in_all: 9000,
    };
    (0..3).map(one).collect()
}

#[test]
fn judges_fail_on_one_answer_falsely_met_far_off_or_not_a_number() {
    // One of three is more than one of a hundred.
    let verdicts = |records: &[Record]| [right(records), consistent(records), near(records)].map(|check| check.verdict);
    let (pass, fail) = (&Verdict::Pass, &Verdict::Fail);
    assert_eq!(verdicts(&sound()), [pass, pass, pass].map(Verdict::clone));
    assert_eq!(verdicts(&[]), [fail, fail, fail].map(Verdict::clone));
    type Spoil<'a> = (fn(&mut Record), [&'a Verdict; 3]);
    let spoils: [Spoil; 9] = [
        (|one| one.half_width = Millionths(-1.1e-3), [fail, pass, pass]),
        (|one| one.peak = Millionths(1.4e-3), [fail, pass, pass]),
        (|one| one.peak = Millionths(-2e-3), [fail, pass, fail]),
        (|one| one.peak = Millionths(f64::NAN), [fail, pass, fail]),
        (|one| (one.met, one.peak) = (false, Millionths(2e-3)), [pass, fail, pass]),
        (|one| one.estimate = Millionths(f64::NAN), [fail, pass, pass]),
        (|one| one.estimate = Millionths(2e-3), [fail, pass, pass]),
        (|one| one.met = false, [pass, fail, pass]),
        (|one| (one.met, one.estimate) = (false, Millionths(2e-3)), [pass, pass, pass]),
    ];
    for (k, (spoil, wanted)) in spoils.into_iter().enumerate() {
        assert_eq!(verdicts(&spoiled(&sound(), |all| spoil(&mut all[1]))), wanted.map(Verdict::clone), "spoil {k}");
    }
}

#[test]
fn what_is_solved_on_the_way_costs_a_few_times_the_largest_mesh() {
    let recorded = met::SURVEY.read().expect("recorded");
    let mut ratios: Vec<f64> = recorded.iter().map(|one| one.dofs_in_all as f64 / one.most_dofs as f64).collect();
    ratios.sort_by(f64::total_cmp);
    // The last mesh is solved to judge the one answered; whatever comes before it only finds the contact.
    assert!(ratios[ratios.len() / 2] <= 3.0, "{}", ratios[ratios.len() / 2]);
    assert!(ratios[ratios.len() - 1] <= 10.0, "{}", ratios[ratios.len() - 1]);
}

#[test]
fn record_that_moved_is_noticed() {
    let kept = &sound()[0];
    let moved = |spoil: fn(&mut Record)| !(MET.is_as_recorded)(kept, &spoiled(kept, spoil));
    assert!(!moved(|_| ()));
    assert!(!moved(|one| one.peak.0 *= 1.0005));
    assert!(moved(|one| one.peak.0 *= 1.1) && moved(|one| one.peak = Millionths(f64::NAN)));
    assert!(moved(|one| one.estimate.0 *= 0.9) && moved(|one| one.dofs += 2) && moved(|one| one.met = false));
}
