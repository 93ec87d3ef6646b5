//! What is wrong over a few points fails, where the pressure of the truth is straight and where points are many; what
//! is right there passes.

use std::ops::Range;

use contact_vv::referee::{Asked, Profile};

use crate::handed::{PRESSURES, failed, judged_rows, read, table};
use crate::workbench::truth;

/// Places, so far apart, up to a last one.
fn places(step: f64, last: f64) -> impl Iterator<Item = f64> {
    (0..=(last / step).round() as i32).map(move |k| step * f64::from(k))
}

/// The pressures of a case at some places, those of some points times a factor; what is not met.
fn off(case: &str, head: &str, places: impl Iterator<Item = f64>, points: Range<usize>, by: f64) -> Vec<String> {
    let truth = truth(case);
    let along = if head.contains("deg") { f64::to_radians } else { |s: f64| s };
    let row = |(k, s)| [s, truth.pressure(0, along(s)) * if points.contains(&k) { by } else { 1.0 }];
    failed(&judged_rows(truth, head, places.enumerate().map(row)))
}

#[test]
fn what_is_wrong_over_a_few_points_fails_where_the_pressure_of_the_truth_is_straight() {
    const ANGLES: &str = "position [deg],pressure [MPa]";
    for (case, head, from, step, last) in [
        ("patch", PRESSURES, 0.0, 0.125, 10.0),
        ("patch", PRESSURES, 0.0, 0.05, 10.0),
        ("press-fit", ANGLES, 0.0, 1.125, 90.0),
        ("eccentric-load", PRESSURES, -10.0, 0.25, 20.0),
    ] {
        let points = || places(step, last).map(|s| from + s);
        let wrong = |range: Range<usize>, by: f64| off(case, head, points(), range, by);
        let count = points().count();
        assert_eq!(wrong(0..0, 1.0), [""; 0], "{case}");
        assert_eq!(wrong(20..22, 0.97), [""; 0], "{case}");
        let of_norm = |named: &[String]| named.iter().any(|one| one.starts_with("error of the mean pressures"));
        for range in [0..3, 16..19, 20..26, count - 3..count, count - 1..count] {
            let named = wrong(range.clone(), 0.6);
            assert!(of_norm(&named), "{case}, {range:?}: {named:?}");
        }
    }
    // Three points whose force the others have: the resultant is right, and so is the width.
    let row = |(k, s)| [s, 100.0 * if (16..19).contains(&k) { 0.62 } else { 1.009 }];
    let found = judged_rows(truth("patch"), PRESSURES, places(0.125, 10.0).enumerate().map(row));
    assert!(failed(&found).iter().any(|one| one.starts_with("error of the mean pressures")), "{:?}", failed(&found));
    // Few points are as right.
    for count in [2, 4, 7] {
        let of_patch = places(10.0 / f64::from(count), 10.0);
        assert_eq!(off("patch", PRESSURES, of_patch, 0..0, 1.0), [""; 0], "{count}");
    }
    // A contact that ends too early by more than the points are apart.
    let early =
        judged_rows(truth("patch"), PRESSURES, places(0.125, 10.0).map(|s| [s, if s < 9.5 { 105.0 } else { 0.0 }]));
    assert!(failed(&early).iter().any(|one| one.starts_with("end of the contact")), "{:?}", failed(&early));
}

#[test]
fn up_to_four_points_in_a_row_that_depart_from_those_beside_them_are_named() {
    let among = |count: usize, by: f64| off("truncated-hertz", PRESSURES, places(0.005, 4.0), 200..200 + count, by);
    // a = 2.5 mm, at 1 mm p₀ √0.84 = 0.9165 p₀.
    for (count, said) in
        [(1, "one point alone"), (2, "2 points in a row, most"), (3, "3 points in a row"), (4, "4 points in a row")]
    {
        for by in [0.8, 1.2] {
            let named = among(count, by);
            assert!(named.iter().any(|one| one.contains(said)), "{count}, {by}: {named:?}");
        }
        assert_eq!(among(count, 0.95), [""; 0], "{count}");
    }
    // Of so many points the norm does not show two.
    let named = off("truncated-hertz", PRESSURES, places(0.0025, 4.0), 400..402, 0.8);
    assert!(matches!(&named[..], [one] if one.contains("2 points in a row, most, at 1.00")), "{named:?}");
    // On both sides of the middle, of which one half is handed in.
    for range in [0..2, 0..4, 1..4, 2..4] {
        let named = off("truncated-hertz", PRESSURES, places(0.005, 4.0), range.clone(), 0.8);
        assert!(named.iter().any(|one| one.contains("in a row")), "{range:?}: {named:?}");
    }
}

#[test]
fn of_a_great_many_points_no_more_are_drawn_between_them() {
    let truth = truth("truncated-hertz");
    let drawn = |count: i32| {
        let step = 4.0 / f64::from(count);
        let rows = places(step, 4.0).map(|s| [s, truth.pressure(0, s)]);
        let answer = read(&truth.case, "many.csv", table(PRESSURES, rows), &Asked::default()).expect("read");
        let profile = Profile::of(&truth.case.scene, &answer.contacts[0]);
        profile.between.len() as f64 / f64::from(count)
    };
    assert!(drawn(40) > 10.0, "{}", drawn(40));
    assert!(drawn(100_000) < 1.1, "{}", drawn(100_000));
}
