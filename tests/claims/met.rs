//! An accuracy called met is met, whatever the profile, the material, the size and the guess of the contact's length.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::{self, Asked};
use contact_vv::case::Verdict;
use contact_vv::oracle::analytic::even_gap::EvenGap;
use contact_vv::solve::Formulation;
use contact_vv::study::promised::met::{Record, consistent, is_as_recorded, near, record, right};
use contact_vv::study::random::{Family, Site};
use contact_vv::study::records::Millionths;

/// What the closed forms of cylinders and pins leave out, relative.
const LEFT_OUT: f64 = 1.5e-5;
fn site(family: Family, number: usize) -> Site {
    Site { family, number }
}

/// One of each closed form of an even gap.
fn profiles() -> [EvenGap; 3] {
    let polynomial = |parts| EvenGap::polynomial(2e5, 2.0, parts);
    [polynomial([0.01, 0.0, 0.0]), polynomial([1e-3, 2e-3, -1e-4]), EvenGap::rounded_wedge(2e5, 2.0, 50.0, 0.5, 4000)]
}

/// `∫ p f(s) ds` by the midpoint rule in φ, `s = a cos φ`.
fn integral(solution: &EvenGap, of: impl Fn(f64) -> f64) -> f64 {
    const PARTS: usize = 2000;
    let a = solution.half_width;
    let at = |part: usize| PI * (part as f64 + 0.5) / PARTS as f64;
    let one = |phi: f64| solution.pressure(phi) * of(a * phi.cos()) * a * phi.sin();
    (0..PARTS).map(|part| one(at(part))).sum::<f64>() * PI / PARTS as f64
}

#[test]
fn load_and_opening_of_a_closed_form_are_those_of_its_own_pressure_integrated() {
    for solution in profiles() {
        assert_relative_eq!(integral(&solution, |_| 1.0), solution.load(), max_relative = 1e-6);
        for x in [8.0, 18.0] {
            // The slope of the surface is that of its displacement under the pressure.
            let lowered = 2.0 / (PI * solution.modulus) * integral(&solution, |s| 1.0 / (x - s));
            assert_relative_eq!(solution.opening(x, 0.0), -lowered, max_relative = 1e-6);
        }
    }
}

#[test]
fn largest_pressure_of_an_even_gap_lies_where_it_neither_rises_nor_falls() {
    let polynomial = |parts| EvenGap::polynomial(2e5, 2.0, parts);
    let hollow = [[1e-3, 2e-3, 1e-4], [0.0, 1e-3, 0.0], [0.0, 0.0, 1e-4], [-1e-3, 2e-3, 1e-4]].map(polynomial);
    for solution in profiles().iter().chain(&hollow) {
        let phi = solution.peak_place();
        let term = |(k, b): (usize, &f64)| (2 * k + 1) as f64 * b * ((2 * k + 1) as f64 * phi).cos();
        let slope: f64 = solution.slopes.iter().enumerate().map(term).sum();
        // A maximum is known to the root of what rounding leaves of it.
        assert_abs_diff_eq!(slope / solution.slopes[0], 0.0, epsilon = 1e-6);
        let highest = (0..=1000).map(|k| solution.pressure(0.0005 * PI * f64::from(k))).fold(0.0, f64::max);
        assert!(solution.peak_pressure() >= highest * (1.0 - 1e-12), "{highest}");
    }
    assert!(hollow.iter().all(|solution| solution.peak_place() < 1.3));
}

#[test]
fn slope_of_a_wedge_is_the_sum_of_its_series() {
    let [_, _, wedge] = profiles();
    for theta in [0.1, 0.8, 1.2, 1.4, 1.5] {
        let sum: f64 = wedge.slopes.iter().enumerate().map(|(k, b)| b * ((2 * k + 1) as f64 * theta).cos()).sum();
        assert_relative_eq!(sum, (2.0 * theta.cos()).min(0.5) / 50.0, max_relative = 1e-3);
    }
}

#[test]
fn closed_forms_of_cylinder_and_pin_leave_out_little() {
    for (family, number) in [(Family::Cylinder, 38), (Family::Cylinder, 50), (Family::Pin, 2), (Family::Pin, 3)] {
        let sample = site(family, number).sample().expect("a scene");
        let found = record(&site(family, number), 5e-5, &sample).expect("solved");
        assert!(found.error() <= LEFT_OUT, "{}, {number}: {found:?}", family.name());
    }
}

#[test]
fn waves_that_three_coarse_meshes_agree_on_by_accident_are_not_called_met() {
    let sample = site(Family::Cosine, 41).sample().expect("a scene");
    let found = record(&site(Family::Cosine, 41), 1e-3, &sample).expect("solved");
    assert!(found.met && !found.is_falsely_met(), "{found:?}");
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
        family: Family::Wedge,
        number,
        asked: 1e-3,
        met: true,
        estimate: Millionths(8e-4),
        peak: Millionths(5e-4),
        half_width: Millionths(-2e-4),
        dofs: 1000,
        dofs_in_all: 9000,
    };
    (0..3).map(one).collect()
}

#[test]
fn judges_fail_on_one_answer_falsely_met_far_off_or_not_a_number() {
    // One of three is more than one of a hundred.
    let verdicts = |records: &[Record]| [right(records), consistent(records), near(records)].map(|check| check.verdict);
    let spoiled = |spoil: fn(&mut Record)| {
        let mut records = sound();
        spoil(&mut records[1]);
        verdicts(&records)
    };
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
        assert_eq!(spoiled(spoil), wanted.map(Verdict::clone), "spoil {k}");
    }
}

#[test]
fn record_that_moved_is_noticed() {
    let kept = &sound()[0];
    let moved = |spoil: fn(&mut Record)| {
        let mut fresh = kept.clone();
        spoil(&mut fresh);
        !is_as_recorded(kept, &fresh)
    };
    assert!(!moved(|_| ()));
    assert!(!moved(|one| one.peak.0 *= 1.0005));
    assert!(moved(|one| one.peak.0 *= 1.1) && moved(|one| one.peak = Millionths(f64::NAN)));
    assert!(moved(|one| one.estimate.0 *= 0.9) && moved(|one| one.dofs += 2) && moved(|one| one.met = false));
}
