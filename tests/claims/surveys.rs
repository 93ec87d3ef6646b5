//! Records of surveys: judged, resumed and recomputed, and red where they are spoiled.

use std::cell::Cell;
use std::f64::consts::PI;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use contact_vv::case::library::TruncatedHertz;
use contact_vv::solve::Ended;
use contact_vv::solve::unbounded;
use contact_vv::study::promised::converged::{Record, SURVEY, Site};
use contact_vv::study::promised::{bars, met};
use contact_vv::study::records::{self, Millionths, Survey};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::again::{self, Again};

/// A record of two formulations, one of which does not converge.
fn record() -> Record {
    let (mut classes, mut iterations, mut errors) = ([None; 9], [None; 9], [None; 9]);
    for (k, class, count, error) in [(0, Ended::Converged, 7, 1e-4), (8, Ended::Capped, 2000, f64::NAN)] {
        (classes[k], iterations[k], errors[k]) = (Some(class), Some(count), Some(Millionths(error)));
    }
    let site = Site { scene: "cylinder".into(), stretch: 2.0 };
    Record { site, load: 1e-2, tolerance: 1e-3, classes, iterations, errors }
}

/// The record with another error, class and number of iterations of its first formulation.
fn with(error: f64, class: Ended, iterations: usize) -> Record {
    let mut record = record();
    (record.errors[0], record.classes[0], record.iterations[0]) =
        (Some(Millionths(error)), Some(class), Some(iterations));
    record
}

#[test]
fn run_that_moved_is_not_as_recorded() {
    let is_as_recorded = again::CONVERGED.is_as_recorded;
    assert!(is_as_recorded(&record(), &record()));
    let mut other = record();
    (other.classes, other.iterations, other.errors) = ([None; 9], [None; 9], [None; 9]);
    let moved = [
        with(f64::NAN, Ended::Converged, 7),
        with(1.1e-4, Ended::Converged, 7),
        with(1e-4, Ended::Converged, 8),
        with(1e-4, Ended::Capped, 7),
        Record { load: 1.0, ..record() },
        Record { tolerance: 1e-6, ..record() },
        other,
    ];
    for moved in moved {
        assert!(!is_as_recorded(&record(), &moved) && !is_as_recorded(&moved, &record()), "{moved:?}");
    }
}

#[test]
fn every_survey_runs_a_part_of_its_sites_again() {
    fn chosen<S, R>(Again { survey, is_chosen, .. }: &Again<S, R>) -> [usize; 2] {
        let sites = (survey.sites)().expect("sites");
        [sites.iter().filter(|site| is_chosen(site)).count(), sites.len()]
    }
    assert_eq!(chosen(&again::CONVERGED)[0], 22, "none that is named is missing");
    assert_eq!(chosen(&again::BARS), [11 * 6 + 13 * 2, 24 * 200]);
    assert_eq!(chosen(&again::MET)[0], 10 * 2 + 14);
}

#[test]
fn what_every_survey_runs_again_is_as_recorded() {
    fn told<S: Send + Sync, R: Serialize + DeserializeOwned + Clone + Send + Sync>(
        all: &Again<S, R>,
    ) -> Option<String> {
        let ([again, moved], name) = (all.recomputed().expect("run again"), all.survey.name);
        (again == 0 || moved > 0).then(|| format!("{name}: {moved} of {again}, `{name}` renews the record"))
    }
    let all = [told(&again::CONVERGED), told(&again::BARS), told(&again::MET), told(&again::COUNTED)];
    let moved: Vec<String> = all.into_iter().flatten().collect();
    assert!(moved.is_empty(), "{}", moved.join("; "));
}

#[test]
fn survey_that_was_broken_off_goes_on_where_it_stopped() {
    static MADE: AtomicUsize = AtomicUsize::new(0);
    static BROKEN: AtomicBool = AtomicBool::new(true);
    let survey: Survey<usize, Record> = Survey {
        name: "broken off",
        head: SURVEY.head,
        sites: || Ok(vec![0, 1, 2]),
        key: usize::to_string,
        of: |_| String::new(),
        run: |iterations| {
            MADE.fetch_add(1, Ordering::Relaxed);
            match BROKEN.load(Ordering::Relaxed) && *iterations == 2 {
                true => records::read(Path::new("broken off"), &[], ""),
                false => Ok(vec![with(1e-4, Ended::Converged, *iterations)]),
            }
        },
    };
    let folder = tempfile::tempdir().expect("folder");
    let [unfinished, file] = ["unfinished", "record.csv"].map(|name| folder.path().join(name));
    assert!(survey.renew(&unfinished, &file, || ()).is_err() && !file.exists());
    let before = MADE.swap(0, Ordering::Relaxed);
    BROKEN.store(false, Ordering::Relaxed);
    let done = AtomicUsize::new(0);
    let count = || {
        done.fetch_add(1, Ordering::Relaxed);
    };
    assert_eq!(survey.renew(&unfinished, &file, count).expect("surveyed"), 3);
    // What a broken survey finished depends on which thread met the fault; the fault itself is run again.
    let made = MADE.load(Ordering::Relaxed);
    assert!((1..=3).contains(&made) && before + made == 4 && done.into_inner() == 3);
    let kept: Vec<Record> = records::read(&file, &(survey.head)(), "").expect("read");
    assert_eq!(kept.iter().map(|record| record.iterations[0]).collect::<Vec<_>>(), [Some(0), Some(1), Some(2)]);
    let refused = records::read::<Record>(&file, &["scene".to_string()], "renew it").expect_err("other columns");
    assert!(refused.to_string().contains("renew it"), "{refused}");
}

#[test]
fn a_number_of_what_has_no_limit_is_as_far_off_as_can_be() {
    let found = [bars::error(5.0, 4.0), bars::error(f64::NAN, f64::INFINITY), bars::error(5.0, f64::INFINITY)];
    assert_eq!(found, [1.0, 0.0, f64::INFINITY]);
}

#[test]
fn series_without_a_limit_grows_and_one_with_a_limit_does_not() {
    let at = |of: &dyn Fn(f64) -> f64| unbounded::grows([4.0, 2.0, 1.0].map(of));
    assert!(at(&|h| 100.0 - 10.0 * h.ln()).is_some(), "a logarithm");
    assert!(at(&|h| 100.0 * h.powf(-0.3)).is_some(), "a corner");
    // What it has grown by with the last halving, over the peak: h^−α by 1 − 2^−α.
    let growth = at(&|h| 100.0 * h.powf(-0.3)).expect("it grows");
    assert!((growth - (1.0 - 0.5_f64.powf(0.3))).abs() < 1e-12, "{growth}");
    // As good as at its limit, below one part in a hundred, though it has none.
    for (part, grows) in [(0.0095, false), (0.0105, true)] {
        assert_eq!(at(&|h| 100.0 * (1.0 - part * h.log2())).is_some(), grows, "{part} of the peak");
    }
    assert!(at(&|h| 100.0 - h * h).is_none() && at(&|h| 100.0 - 3.0 * h).is_none(), "first and second order");
    for lost in 0..3 {
        let nan = Cell::new(0);
        let spoiled = at(&|h| {
            nan.set(nan.get() + 1);
            if nan.get() == lost + 1 { f64::NAN } else { 100.0 * h.powf(-0.3) }
        });
        assert!(spoiled.is_none(), "NaN tells of no growth");
    }
}

#[test]
fn records_are_written_as_they_were_read() {
    fn is_same<S: Send + Sync, R: Serialize + DeserializeOwned + Clone + Send + Sync>(survey: &Survey<S, R>) {
        let folder = tempfile::tempdir().expect("folder");
        let copy = folder.path().join("copy.csv");
        records::write(&copy, &(survey.head)(), &survey.read().expect("read")).expect("written");
        let [kept, fresh] = [survey.file(), copy].map(|file| std::fs::read(file).expect("a file"));
        assert!(kept == fresh, "{}", survey.name);
    }
    is_same(&SURVEY);
    is_same(&bars::SURVEY);
    is_same(&met::SURVEY);
}

#[test]
fn numbers_keep_three_digits_in_millionths() {
    let shown = [
        (0.00342449, "3420"),
        (-6.243e-6, "-6.24"),
        (1.16e-12, "1.16e-6"),
        (1.0049e-9, "1e-3"),
        (5.3e3, "5.3e9"),
        (0.0, "0"),
        (f64::NAN, "NaN"),
        (f64::INFINITY, "inf"),
    ];
    for (number, text) in shown {
        assert_eq!(Millionths(number).to_string(), text);
        let read = Millionths::try_from(text.to_string()).expect("a number");
        assert!(read.is_like(Millionths(number), 0.0), "{text}");
        assert!(!number.is_normal() || !read.is_like(Millionths(1.02 * number), 0.0), "{text}");
    }
    assert!(Millionths::try_from("three".to_string()).is_err());
}

/// A peak of truncated Hertz over `√(PE*/πR)` is 1 to the digits that records keep, and over that of a load 3 % larger
/// it is not.
#[test]
fn a_number_that_is_solved_again_is_like_hertz_and_not_like_that_of_another_load() {
    let numbers = TruncatedHertz::default();
    let case = numbers.case();
    let peak = case.solve().expect("solved").1.measures().peak.pressure;
    let modulus = numbers.young / (1.0 - numbers.poisson * numbers.poisson);
    let half_width = numbers.a_over_r * numbers.radius;
    let load = PI * modulus * half_width * half_width / (4.0 * numbers.radius);
    let hertz = |load: f64| (load * modulus / (PI * numbers.radius)).sqrt();
    let is_like = |load: f64| Millionths(peak / hertz(load)).is_like(Millionths(1.0), 0.0);
    assert!(is_like(load) && !is_like(1.03 * load) && !is_like(0.97 * load), "{peak}");
}
