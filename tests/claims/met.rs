//! An accuracy called met is met, whatever the profile, the material, the size and the guess of the contact's length.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::{self, Asked};
use contact_vv::case::Verdict;
use contact_vv::measure::peak;
use contact_vv::oracle::analytic::even_gap::EvenGap;
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::solution::EdgeState;
use contact_vv::solve::{Element, Formulation, Iteration};
use contact_vv::study::promised::met::{
    ASKED, Record, consistent, families, is_as_recorded, near, record, right, sites,
};
use contact_vv::study::random::{Family, Sample, Site};
use contact_vv::study::records::Millionths;

/// What the closed forms of cylinders and pins leave out, relative.
const LEFT_OUT: f64 = 1.5e-5;
/// Places on the sides of a block, over the half-width.
const PLACES: [[f64; 2]; 6] = [[4.0, 0.0], [4.0, 0.3], [4.0, 4.0], [0.0, 4.0], [0.7, 5.0], [9.0, 2.0]];

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
fn parabola_is_hertz_inside_the_body_too() {
    let solution = &profiles()[0];
    let hertz = Hertz { load: solution.load(), radius: 50.0, modulus: 2e5 };
    assert_relative_eq!(solution.half_width, hertz.half_width(), max_relative = 1e-12);
    assert_relative_eq!(solution.peak_pressure(), hertz.peak_pressure(), max_relative = 1e-12);
    assert_relative_eq!(solution.second_moment(), hertz.half_width(), max_relative = 1e-12);
    for [x, z] in PLACES.map(|place| place.map(|s| 2.0 * s)) {
        let [found, wanted] = [solution.stress(x, z), hertz.stress(x, z)];
        for (found, wanted) in found.into_iter().zip(wanted) {
            assert_relative_eq!(found, wanted, max_relative = 1e-10, epsilon = 1e-12 * hertz.peak_pressure());
        }
    }
}

#[test]
fn closed_forms_are_those_of_their_own_pressure_integrated() {
    for solution in profiles() {
        let [load, moment] = [integral(&solution, |_| 1.0), integral(&solution, |s| s * s)];
        assert_relative_eq!(load, solution.load(), max_relative = 1e-6);
        assert_relative_eq!(2.0 * (moment / load).sqrt(), solution.second_moment(), max_relative = 1e-6);
        for [x, z] in PLACES.map(|place| place.map(|s| 2.0 * s)) {
            // Flamant.
            let of = |powers: [i32; 2]| {
                let kernel =
                    |s: f64| z * z.powi(powers[1]) * (x - s).powi(powers[0]) / ((x - s).powi(2) + z * z).powi(2);
                -2.0 / PI * integral(&solution, kernel)
            };
            let wanted = [of([2, 0]), of([0, 2]), of([1, 1])];
            for (found, wanted) in solution.stress(x, z).into_iter().zip(wanted) {
                assert_relative_eq!(found, wanted, max_relative = 1e-6, epsilon = 1e-9 * solution.peak_pressure());
            }
            // The slope of the surface is that of its displacement under the pressure.
            let lowered = 2.0 / (PI * solution.modulus) * integral(&solution, |s| 1.0 / (x - s));
            if x > solution.half_width {
                assert_relative_eq!(solution.opening(x, 0.0), -lowered, max_relative = 1e-6);
            }
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
fn peak_of_a_hollow_profile_converges_with_the_mesh() {
    let solution = EvenGap::polynomial(2e5, 2.0, [1e-3, 2e-3, 1e-4]);
    assert!(solution.peak_pressure() > 1.01 * solution.pressure(0.5 * PI));
    // Force between two places, exactly: ∫ sin nφ sin φ dφ.
    let force = |x: f64| {
        let phi = (x / 2.0).clamp(-1.0, 1.0).acos();
        let one = |n: f64| if n > 1.0 { ((n - 1.0) * phi).sin() / (n - 1.0) } else { phi };
        let sum: f64 = (solution.slopes.iter().enumerate())
            .map(|(k, b)| b * 0.5 * (one((2 * k + 1) as f64) - ((2 * k + 2) as f64 * phi).sin() / (2 * k + 2) as f64))
            .sum();
        -0.5 * solution.modulus * solution.half_width * sum
    };
    let error_on = |elements: usize| {
        let ends = |k: usize| [k, k + 1].map(|k| 2.0 * k as f64 / elements as f64);
        let edge = |k: usize| {
            let [from, to] = ends(k);
            EdgeState { ends: [from, to], weight: to - from, pressure: (force(to) - force(from)) / (to - from) }
        };
        let found = peak::of(&(0..elements).map(edge).collect::<Vec<_>>(), 0.0);
        (found.pressure / solution.peak_pressure() - 1.0).abs()
    };
    let errors = [8, 16, 32, 64, 128].map(error_on);
    let allowed = [1e-2, 1e-3, 1e-4, 2e-5, 2e-5];
    assert!(errors.iter().zip(allowed).all(|(error, allowed)| *error <= allowed), "{errors:?}");
}

#[test]
fn scenes_are_the_same_each_time_and_as_many_as_promised() {
    assert!(sites().count() >= 5 * 1200);
    for family in families() {
        let [first, again, other] = [3, 3, 4].map(|number| site(family, number).sample().expect("a scene"));
        let numbers = |sample: &Sample| sample.truths.iter().map(|truth| truth.value.to_bits()).collect::<Vec<_>>();
        assert_eq!(numbers(&first), numbers(&again));
        assert_ne!(numbers(&first), numbers(&other));
    }
}

#[test]
fn scenes_of_each_family_meet_each_accuracy() {
    let (mut answers, mut outside) = (0, 0);
    for family in families() {
        for number in [0, 1, 2] {
            let sample = site(family, number).sample().expect("a scene");
            // The recorded survey has the finer accuracies of hundreds of scenes of each family.
            let finest = if number == 0 { 0.0 } else { 3e-3 };
            for asked in ASKED.into_iter().filter(|asked| *asked >= finest) {
                let found = record(&site(family, number), asked, &sample).expect("solved");
                let place = format!("{}, {number}, {asked}: {found:?}", family.name());
                // Halving a mesh made elsewhere tells the end no better than 8-node cells do: a thousandth takes more than is solved.
                let may_be_unmet = family == Family::Mesh && asked <= 1e-3;
                assert!(found.met || may_be_unmet, "{place}");
                assert!(!found.is_falsely_met() && !found.is_contradictory(), "{place}");
                answers += 1;
                outside += usize::from(found.error() > found.estimate.0 + LEFT_OUT);
            }
        }
    }
    // What bars promise: nineteen of twenty.
    assert!(20 * outside <= answers, "{outside} of {answers} beyond their bars");
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

#[test]
fn iteration_that_stops_early_is_the_reason_why_an_accuracy_is_not_met() {
    let sample = site(Family::Polynomial, 0).sample().expect("a scene");
    let mut formulation = Formulation::new(Element::Line, Iteration::Constant);
    formulation.settings.max_iterations = 2;
    let answer = accuracy::solve(&sample.scene, &formulation, &Asked::new(3e-3)).expect("solved");
    assert!(answer.unmet.as_ref().is_some_and(|why| why.contains("line.constant")), "{:?}", answer.unmet);
    assert!(answer.estimate() > 3e-3, "{:e}", answer.estimate());
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
fn judge_fails_on_one_answer_falsely_met_and_on_what_is_not_a_number() {
    // One of three is more than one of a hundred.
    let verdicts = |records: &[Record]| [right(records), consistent(records)].map(|check| check.verdict);
    let spoiled = |spoil: fn(&mut Record)| {
        let mut records = sound();
        spoil(&mut records[1]);
        verdicts(&records)
    };
    let (pass, fail) = (Verdict::Pass, Verdict::Fail);
    assert_eq!(verdicts(&sound()), [pass.clone(), pass.clone()]);
    assert_eq!(verdicts(&[]), [fail.clone(), fail.clone()]);
    let wrong = [fail.clone(), pass.clone()];
    assert_eq!(spoiled(|one| one.half_width = Millionths(-1.1e-3)), wrong);
    assert_eq!(spoiled(|one| one.peak = Millionths(f64::NAN)), wrong);
    assert_eq!(spoiled(|one| one.estimate = Millionths(f64::NAN)), wrong);
    assert_eq!(spoiled(|one| one.estimate = Millionths(2e-3)), wrong);
    assert_eq!(spoiled(|one| one.met = false), [pass.clone(), fail]);
    assert_eq!(spoiled(|one| (one.met, one.estimate) = (false, Millionths(2e-3))), [pass.clone(), pass]);
}

#[test]
fn one_answer_called_met_and_off_by_twice_what_was_asked_fails_and_none_at_all_does() {
    let spoiled = |peak: f64, met: bool| {
        let mut records = sound();
        (records[1].peak, records[1].met) = (Millionths(peak), met);
        near(&records).verdict
    };
    assert_eq!(near(&[]).verdict, Verdict::Fail);
    assert_eq!(
        [1.4e-3, -2e-3, f64::NAN].map(|peak| spoiled(peak, true)),
        [Verdict::Pass, Verdict::Fail, Verdict::Fail]
    );
    assert_eq!(spoiled(2e-3, false), Verdict::Pass);
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
