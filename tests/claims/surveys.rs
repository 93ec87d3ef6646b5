//! Records of surveys: judged, resumed and recomputed, and red where they are spoiled.

use std::cell::Cell;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use contact_vv::case::Verdict;
use contact_vv::solve::{Element, Iteration, unbounded};
use contact_vv::study::class::Class;
use contact_vv::study::converged::judge::{is_as_recorded, right};
use contact_vv::study::converged::run::{Record, records as runs_of};
use contact_vv::study::converged::{NAME, sites};
use contact_vv::study::coverage;
use contact_vv::study::met;
use contact_vv::study::pairing::Pairing;
use contact_vv::study::records;

fn record() -> Record {
    Record {
        scene: "cylinder".into(),
        stretch: 2.0,
        load: 1e-2,
        formulation: Pairing { element: Element::Node, algorithm: Iteration::Kinematic },
        tolerance: 1e-3,
        class: Class::Converged,
        iterations: 7,
        error: 1e-4,
    }
}

#[test]
fn converged_run_that_is_wrong_or_not_known_to_be_right_is_red() {
    assert_eq!(right(&[record()]).verdict, Verdict::Pass);
    assert_eq!(right(&[]).verdict, Verdict::Fail, "nothing was looked at");
    for error in [3.1e-3, f64::INFINITY, f64::NAN] {
        let spoiled = Record { error, ..record() };
        assert_eq!(right(&[record(), spoiled.clone()]).verdict, Verdict::Fail, "{error}");
        let stopped = Record { class: Class::Capped, ..spoiled };
        assert_eq!(right(&[record(), stopped]).verdict, Verdict::Pass, "{error} of a run that did not converge");
    }
}

#[test]
fn run_that_moved_is_not_as_recorded() {
    assert!(is_as_recorded(&record(), &record()));
    let unknown = Record { error: f64::NAN, ..record() };
    assert!(is_as_recorded(&unknown, &unknown));
    for moved in [
        unknown.clone(),
        Record { error: 1.1e-4, ..record() },
        Record { iterations: 8, ..record() },
        Record { class: Class::Capped, ..record() },
        Record { load: 1.0, ..record() },
        Record { formulation: Pairing { element: Element::Line, ..record().formulation }, ..record() },
        Record { tolerance: 1e-6, ..record() },
    ] {
        assert!(!is_as_recorded(&record(), &moved) && !is_as_recorded(&moved, &record()), "{moved:?}");
    }
}

#[test]
fn recorded_site_is_what_a_fresh_run_finds() {
    let kept: Vec<Record> = records::read(&records::file(NAME), "").expect("recorded");
    let site = sites().expect("scenes").into_iter().find(|site| site.key() == "cylinder-2").expect("surveyed");
    let fresh = runs_of(&site).expect("run");
    let kept: Vec<&Record> = kept.iter().filter(|kept| kept.scene == "cylinder" && kept.stretch == 2.0).collect();
    assert!(fresh.len() == kept.len() && fresh.len() == 54, "{} of {}", fresh.len(), kept.len());
    assert!(kept.into_iter().zip(&fresh).all(|(kept, fresh)| is_as_recorded(kept, fresh)));
}

#[test]
fn survey_that_was_broken_off_goes_on_where_it_stopped() {
    let folder = tempfile::tempdir().expect("folder");
    let [unfinished, file] = ["unfinished", "record.csv"].map(|name| folder.path().join(name));
    let (made, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let survey = |broken: bool, [unfinished, file]: [&Path; 2]| {
        let run = |iterations: &usize| {
            made.fetch_add(1, Ordering::Relaxed);
            match broken && *iterations == 2 {
                true => records::read(Path::new("broken off"), ""),
                false => Ok(vec![Record { iterations: *iterations, ..record() }]),
            }
        };
        let done = || {
            done.fetch_add(1, Ordering::Relaxed);
        };
        records::survey([unfinished, file], &[0, 1, 2], usize::to_string, run, done)
    };
    let paths = [unfinished.as_path(), file.as_path()];
    assert!(survey(true, paths).is_err() && !file.exists());
    let before = made.swap(0, Ordering::Relaxed);
    assert_eq!(survey(false, paths).expect("surveyed"), 3);
    // What a broken survey finished depends on which thread met the fault; the fault itself is run again.
    assert!((1..=3).contains(&made.load(Ordering::Relaxed)) && before + made.load(Ordering::Relaxed) == 4);
    let iterations: Vec<usize> =
        records::read::<Record>(&file, "").expect("read").into_iter().map(|record| record.iterations).collect();
    assert_eq!(iterations, [0, 1, 2]);
}

#[test]
fn series_without_a_limit_grows_and_one_with_a_limit_does_not() {
    let at = |of: &dyn Fn(f64) -> f64| unbounded::grows([4.0, 2.0, 1.0].map(of), unbounded::STEADY);
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
    let folder = tempfile::tempdir().expect("folder");
    let copy = |name: &str| folder.path().join(name).with_extension("csv");
    records::write(&copy("converged"), &records::read::<Record>(&records::file("converged"), "").expect("read"))
        .expect("written");
    records::write(&copy("met"), &records::read::<met::Record>(&records::file("met"), "").expect("read"))
        .expect("written");
    records::write(
        &copy("coverage"),
        &records::read::<coverage::Record>(&records::file("coverage"), "").expect("read"),
    )
    .expect("written");
    for name in ["converged", "met", "coverage"] {
        let [kept, fresh] = [records::file(name), copy(name)].map(|file| std::fs::read(file).expect("a file"));
        assert!(kept == fresh, "{name}");
    }
}
