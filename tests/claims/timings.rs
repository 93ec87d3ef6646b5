//! What is said about speed: medians, exponents, targets, and that recorded errors and counts are still the code's.

use approx::assert_relative_eq;
use contact_vv::case::Verdict;
use contact_vv::checkout::root;
use contact_vv::figure::Theme;
use contact_vv::mesh::Order;
use contact_vv::study::Found;
use contact_vv::study::timings::answers::Answers;
use contact_vv::study::timings::code::Code;
use contact_vv::study::timings::compared::{apart, conclusion};
use contact_vv::study::timings::digits::{self, Cells, Reached};
use contact_vv::study::timings::growth::Counts;
use contact_vv::study::timings::judge::moved;
use contact_vv::study::timings::others::{OtherPoint, answered};
use contact_vv::study::timings::precision::{self, Family, LOADS, Point, half_widths};
use contact_vv::study::timings::record::{Absent, Beside, FOLDER, Measured, Record};
use contact_vv::study::timings::run::{Precision, Recounted, Redone};
use contact_vv::study::timings::statistics::{Spread, exponent, upper_quartile};
use contact_vv::study::timings::targets::{Target, targets};
use contact_vv::study::timings::{Numbers, growth, judge, pictures, section};

#[test]
fn spread_is_median_least_and_most_and_a_broken_value_spoils_it() {
    assert_eq!(Spread::of(&[3.0, 1.0, 2.0]), Spread { median: 2.0, least: 1.0, most: 3.0 });
    assert_eq!(Spread::of(&[4.0, 1.0, 2.0, 3.0]), Spread { median: 2.5, least: 1.0, most: 4.0 });
    assert_eq!(Spread::of_ratios(&[2.0, 9.0, 8.0], &[1.0, 3.0, 2.0]), Spread { median: 3.0, least: 2.0, most: 4.0 });
    assert_relative_eq!(upper_quartile(&[3.0, 1.0, 2.0]), 2.5);
    assert_relative_eq!(upper_quartile(&[5.0, 1.0, 4.0, 2.0, 3.0]), 4.0);
    assert!(upper_quartile(&[]).is_nan() && upper_quartile(&[1.0, f64::NAN]).is_nan());
    for broken in [Spread::of(&[]), Spread::of(&[1.0, f64::NAN])] {
        assert!(broken.median.is_nan() && broken.least.is_nan() && broken.most.is_nan());
    }
}

#[test]
fn exponent_of_a_power_law_is_its_power() {
    let points: Vec<[f64; 2]> = [1e3, 2e4, 3e5].iter().map(|n: &f64| [*n, 3.0 * n.powf(1.25)]).collect();
    assert_relative_eq!(exponent(&points), 1.25, max_relative = 1e-12);
}

#[test]
fn loads_move_the_edge_across_one_element_and_no_further() {
    let widths = half_widths(2.5, 5);
    assert_eq!(widths.len(), LOADS);
    assert_relative_eq!(widths[0], 2.5);
    assert!(widths.windows(2).all(|pair| pair[1] > pair[0]));
    assert!(widths[LOADS - 1] < 2.5 + 2.5 / 5.0);
}

#[test]
fn every_recorded_number_but_the_seconds_is_compared() {
    let recorded = Record::read().expect("the committed record").points;
    let fresh = precision::measure(Family::Steep, Order::Linear, 3, &Answers::HERTZ).expect("measured");
    assert_eq!((fresh.len(), moved(&recorded, &fresh)), (3, 0));
    let spoiled = |spoil: &dyn Fn(&mut Point)| {
        let mut points = fresh.clone();
        spoil(&mut points[1]);
        moved(&recorded, &points)
    };
    assert_eq!(spoiled(&|point| point.seconds *= 2.0), 0);
    let spoils: [&dyn Fn(&mut Point); 13] = [
        &|point| point.elements += 1,
        &|point| point.dofs += 1,
        &|point| point.converged -= 1,
        &|point| point.sparse_operations *= 1.01,
        &|point| point.dense_operations *= 1.01,
        &|point| point.iterations += 1.0,
        &|point| point.peak *= 1.01,
        &|point| point.peak_worst *= 1.01,
        &|point| point.half_width *= 1.01,
        &|point| point.half_width_worst *= 1.01,
        &|point| point.l2 *= 1.01,
        &|point| point.l2_worst *= 1.01,
        &|point| point.peak = f64::NAN,
    ];
    for (index, spoil) in spoils.into_iter().enumerate() {
        assert_eq!(spoiled(spoil), 1, "spoil {index}");
    }
}

#[test]
fn counts_of_the_growth_tell_one_mesh_from_another() {
    let recorded = Record::read().expect("the committed record").measured.growth;
    let kept = &recorded[0].counts;
    assert_eq!(growth::counts(kept.elements, kept.refinement).expect("counted"), *kept);
    assert_ne!(growth::counts(kept.elements + 1, kept.refinement).expect("counted"), *kept);
}

#[test]
fn target_that_is_missed_or_not_a_number_is_not_met() {
    let mut record = Record::read().expect("the committed record");
    let met = |record: &Record, start: &str| {
        let found = targets(record).into_iter().find(|target| target.what.starts_with(start));
        found.expect("a row of the table").met
    };
    for (value, wanted) in [(0.9, true), (1.2, false), (f64::NAN, false)] {
        record.measured.growth.iter_mut().for_each(|one| one.ratio.median = value);
        record.measured.nine[0].all[0].median = 2.0 * value;
        assert_eq!(met(&record, "contact solve ÷ plain solve"), Some(wanted), "{value}");
        assert_eq!(met(&record, "all nine"), Some(wanted), "{value}");
    }
    record.measured.others.clear();
    assert_eq!(met(&record, "time to 0.1 %"), None);
}

#[test]
fn record_that_is_not_complete_or_was_not_measured_again_is_not_as_recorded() {
    let Record { measured, points } = Record::read().expect("the committed record");
    let verdict = |numbers: Numbers| judge(&numbers).expect("judged")[0].verdict.clone();
    let of_points = |recorded: &[Point], fresh: &[Point], planned: usize| {
        verdict(Numbers::Precision(Precision { recorded: recorded.into(), fresh: fresh.into(), planned }))
    };
    let all = points.len();
    assert_eq!(of_points(&points, &points, all), Verdict::Pass);
    assert_eq!(of_points(&points[1..], &points, all), Verdict::Fail);
    assert_eq!(of_points(&points, &[], all), Verdict::Fail);
    let counts: Vec<Counts> = Recounted::kept(&measured).cloned().collect();
    let of_counts = |recorded: &Measured, fresh: &[Counts]| {
        verdict(Numbers::Growth(Box::new(Recounted { recorded: recorded.clone(), fresh: fresh.into() })))
    };
    assert_eq!(of_counts(&measured, &counts), Verdict::Pass);
    let mut fewer = measured.clone();
    fewer.growth.pop();
    assert_eq!(of_counts(&fewer, &counts), Verdict::Fail);
    assert_eq!(of_counts(&measured, &[]), Verdict::Fail);
    let mut moved = counts;
    moved[0].iterations += 1;
    assert_eq!(of_counts(&measured, &moved), Verdict::Fail);
}

#[test]
fn record_is_written_as_it_was_read() {
    let folder = root().join(FOLDER);
    let Record { measured, points } = Record::read().expect("the committed record");
    let json = serde_json::to_string_pretty(&measured).expect("written") + "\n";
    assert_eq!(json, std::fs::read_to_string(folder.join("measured.json")).expect("committed"));
    let mut csv = csv::Writer::from_writer(Vec::new());
    points.iter().for_each(|point| csv.serialize(point).expect("written"));
    let csv = csv.into_inner().expect("written");
    assert_eq!(csv, std::fs::read(folder.join("precision.csv")).expect("committed"));
}

/// What NGSolve prints of a mesh, with errors so large.
fn of_ngsolve(mesh: [usize; 2], seconds: f64, error: f64) -> OtherPoint {
    let line = serde_json::json!({
        "version": "6.2", "mesh": mesh, "freedoms": 905, "seconds": [seconds, seconds, 3.0 * seconds],
        "stiffness": vec![0.1 * seconds; 3], "linear": vec![0.5 * seconds; 3],
        "peak_error": [0.1 * error, error, 0.2 * error], "half_width_error": vec![0.5 * error; 3], "l2_error": [0.1, 0.1, 0.1],
    });
    answered(Code::Ngsolve, &line)
}

/// The row of the table whose words begin so and go on so.
fn row(record: &Record, start: &str, holds: &str) -> Target {
    let mut found = targets(record).into_iter().filter(|one| one.what.starts_with(start) && one.what.contains(holds));
    found.next().expect("a row of the table")
}

/// The committed record without NGSolve and without digits, as it was before they were timed, all codes in one run.
fn old() -> Record {
    let mut record = Record::read().expect("the committed record");
    record.measured.others.retain(|point| point.code != Code::Ngsolve);
    record.measured.beside.retain(|beside| beside.code != Code::Ngsolve);
    record.measured.absent.retain(|one| one.code != Code::Ngsolve.name());
    record.measured.digits.clear();
    record.measured.beside.iter_mut().for_each(|beside| beside.apart = None);
    record
}

#[test]
fn record_without_a_code_is_read_and_says_so_and_a_code_asked_later_is_marked() {
    let Record { measured, points } = old();
    let text = serde_json::to_string(&measured).expect("written");
    assert!(["NGSolve", "\"digits\"", "\"apart\""].iter().all(|new| !text.contains(new)));
    let mut record = Record { measured: serde_json::from_str(&text).expect("an old record"), points };
    let asked = "NGSolve was not asked when this was recorded";
    assert_eq!(record.measured.skipped(), [asked]);
    assert!(conclusion(&record).contains(asked));
    assert_eq!(row(&record, "time to 0.1 %", "NGSolve").measured, asked);
    // A reason that is recorded is told instead, once.
    record.measured.absent.push(Absent { code: Code::Ngsolve.name().into(), why: "netgen is missing".into() });
    assert_eq!(record.measured.skipped(), ["NGSolve: netgen is missing"]);
    let seconds = Spread { median: 2e-3, least: 1e-3, most: 3e-3 };
    let beside = Beside { code: Code::Ngsolve, seconds, stages: record.measured.beside[0].stages, apart: None };
    for _ in 0..2 {
        record.measured.renew(vec![of_ngsolve([4, 9], 8e-3, 5e-4)], beside.clone());
        let kept = |code: Code| record.measured.beside.iter().filter(|beside| beside.code == code).count();
        assert_eq!((record.measured.of(Code::Ngsolve).count(), Code::ALL.map(kept)), (1, [1; 3]));
        assert!(record.measured.skipped().is_empty());
    }
    // Its seconds over ours in the same run, and the run that is not that of the record is named.
    assert!(row(&record, "time to 0.1 %", "NGSolve").measured.starts_with("4.0 (8.0 ms with 905 dofs against 2.00 ms"));
    let told = apart(&record);
    assert!(told.len() == 1 && told[0].starts_with("NGSolve was asked in a run of its own"), "{told:?}");
    record.measured.beside.iter_mut().for_each(|beside| beside.apart = None);
    assert!(apart(&record).is_empty());
}

/// The section of a record, and its chart of truncated Hertz.
fn shown(record: &Record) -> [String; 2] {
    let Record { measured, points } = record.clone();
    let numbers = [
        Numbers::Growth(Box::new(Recounted { recorded: measured, fresh: vec![] })),
        Numbers::Precision(Precision { recorded: points, fresh: vec![], planned: 0 }),
    ];
    let found = numbers.each_ref().map(|numbers| Found { case: "", name: "", numbers, judged: &[] });
    let pictures = pictures(&found).expect("drawn");
    let (name, drawing) = &pictures[0];
    assert_eq!(name, "work-precision.svg");
    [section(&found).expect("written"), drawing.svg(Theme::Light)]
}

#[test]
fn page_and_chart_show_ngsolve_by_its_orders_or_say_that_it_is_absent() {
    let mut record = old();
    let (named, row) = ("NGSolve, orders 3 to 6, contact edge unknown to its mesh", "| NGSolve, orders 3 to 6");
    let [page, chart] = shown(&record);
    assert!(page.contains("Skipped: NGSolve was not asked") && !page.contains(row));
    assert!(!chart.contains(named) && !chart.contains("fitted to the contact"));
    record.measured.others.push(of_ngsolve([4, 9], 8e-3, 5e-4));
    record.measured.digits.push(reached(Cells::Fitted(4), 1e-2, 1e-4));
    let [page, chart] = shown(&record);
    assert!(!page.contains("Skipped") && page.contains(row) && page.contains("905, 8.0 ms"));
    assert!(page.contains("which leaves 4e-5 of Hertz's ellipse"));
    assert!(chart.contains(named) && chart.contains("fitted to the contact"));
}

#[test]
fn what_ngsolve_prints_is_held_against_the_accuracy() {
    let point = of_ngsolve([6, 27], 1e-2, 1e-5);
    assert_eq!((point.mesh.as_str(), point.dofs, point.version.as_str()), ("[6,27]", 905, "6.2"));
    assert_relative_eq!(point.peak, 2e-6, max_relative = 1e-12);
    assert_relative_eq!(point.worst(), 1e-5, max_relative = 1e-12);
    assert_relative_eq!(point.stages.rest, 4e-3, max_relative = 1e-12);
    let mut record = old();
    let stages = record.measured.beside[0].stages;
    let seconds = Spread { median: 2e-3, least: 1e-3, most: 3e-3 };
    record.measured.beside.push(Beside { code: Code::Ngsolve, seconds, stages, apart: None });
    let met = |seconds: f64, error: f64, record: &mut Record| {
        record.measured.others.retain(|point| point.code != Code::Ngsolve);
        record.measured.others.push(of_ngsolve([4, 9], seconds, error));
        row(record, "time to 0.1 %", "NGSolve").met
    };
    assert_eq!(met(3e-3, 1e-3, &mut record), Some(true));
    assert_eq!(met(1e-3, 1e-3, &mut record), Some(false));
    // None of its meshes is so good: not absent, and not met.
    assert_eq!([met(3e-3, 1e-1, &mut record), met(3e-3, f64::NAN, &mut record)], [Some(false); 2]);
    assert!(conclusion(&record).contains("NGSolve on none of its meshes"));
}

fn reached(cells: Cells, seconds: f64, error: f64) -> Reached {
    let seconds = Spread { median: seconds, least: seconds, most: seconds };
    let [peak, half_width] = [0.5 * error; 2];
    Reached { cells, dofs: 1000, seconds, peak, peak_worst: error, half_width, half_width_worst: 0.5 * error }
}

#[test]
fn digits_that_cost_too_much_or_are_not_reached_are_not_met() {
    let mut record = old();
    let rows = |record: &Record| {
        let starts = ["time to 1e-4", "time to 1e-5", "time to 1e-6"];
        starts.map(|start| row(record, start, "fitted").met)
    };
    assert_eq!(rows(&record), [None; 3], "a record without digits");
    let plain = record.measured.growth.iter().find(|one| one.counts.dofs == 10_001).expect("measured").plain.median;
    // Errors of 8-node cells fall with the time: 1e-4 is reached at 10 ms, 1e-5 at 100 ms.
    let eight = [(8, 5e-3, 2e-4), (16, 2e-2, 5e-5), (104, 2e-1, 5e-6)];
    let eight = eight.map(|(elements, seconds, error)| reached(Cells::Quadratic(elements), seconds, error));
    let mut with = |fitted: [(f64, f64); 3]| {
        let fitted = [4, 5, 6].into_iter().zip(fitted).map(|(n, (t, error))| reached(Cells::Fitted(n), t, error));
        record.measured.digits = fitted.chain(eight.clone()).collect();
        rows(&record)
    };
    let sixth = 30.0 * plain;
    let sound = [(0.99e-2, 1e-4), (0.99 * 0.25e-1, 1e-5), (0.99 * sixth, 1e-6)];
    assert_eq!(with(sound), [Some(true); 3]);
    let spoiled = |k: usize, by: [f64; 2]| {
        let mut spoiled = sound;
        spoiled[k] = (by[0] * sound[k].0, by[1] * sound[k].1);
        spoiled
    };
    for k in 0..3 {
        let only = std::array::from_fn(|at| Some(at != k));
        assert_eq!(with(spoiled(k, [1.02, 1.0])), only, "slower");
    }
    assert_eq!(with(spoiled(2, [1.0, 1.01])), [Some(true), Some(true), Some(false)], "a worse error");
    assert_eq!(with(spoiled(2, [1.0, f64::NAN])), [Some(true), Some(true), Some(false)], "no number");
    assert!(digits::quadratic(&eight, 1e-4).is_some_and(|seconds| (seconds / 1e-2 - 1.0).abs() < 1e-9));
    assert!(digits::quadratic(&eight, 1e-6).is_none() && digits::quadratic(&eight, 1e-3).is_none());
}

#[test]
fn contact_solve_that_grows_faster_than_the_plain_one_is_not_met() {
    let mut record = old();
    let mut with = |power: f64| {
        for one in &mut record.measured.growth {
            let n = one.counts.dofs as f64;
            (one.contact.median, one.plain.median) = (1e-6 * n.powf(power), 1e-6 * n.powf(1.3));
        }
        row(&record, "exponent of the contact solve", "")
    };
    assert_eq!([with(1.29).met, with(1.31).met, with(f64::NAN).met], [Some(true), Some(false), Some(false)]);
    assert!(with(1.2).asked.starts_with("≤ 1.300"));
    record.measured.growth.iter_mut().for_each(|one| one.ratio_quartile = None);
    assert!(row(&record, "contact solve ÷ plain solve", "").measured.contains("upper quartile not recorded"));
    record.measured.growth.iter_mut().for_each(|one| one.ratio_quartile = Some(1.25));
    assert!(row(&record, "contact solve ÷ plain solve", "").measured.contains("upper quartile 1.250"));
}

#[test]
fn digits_are_believed_only_with_the_errors_recorded_beside_their_seconds() {
    let fresh = digits::measure(Cells::Fitted(4), 1).expect("solved");
    assert!(fresh.worst() <= 1e-4 && fresh.seconds.least > 0.0, "{fresh:?}");
    let coarse = digits::measure(Cells::Quadratic(8), 1).expect("solved");
    assert!(coarse.worst() > 1e-4 && coarse.dofs > fresh.dofs, "{coarse:?}");
    let all: Vec<Reached> =
        digits::MESHES.iter().map(|(cells, _)| Reached { cells: *cells, ..fresh.clone() }).collect();
    let verdict = |recorded: &[Reached], fresh: &[Reached]| {
        let numbers = Numbers::Digits(Redone { recorded: recorded.into(), fresh: fresh.into() });
        judge(&numbers).expect("judged")[0].verdict.clone()
    };
    assert_eq!(verdict(&all, &all), Verdict::Pass);
    assert!(matches!(verdict(&[], &[]), Verdict::NotRun(_)), "an old record");
    assert_eq!(verdict(&all[1..], &all[1..]), Verdict::Fail, "a mesh less in the record");
    assert_eq!(verdict(&all, &all[1..]), Verdict::Fail, "a mesh less");
    let spoils: [&dyn Fn(&mut Reached); 6] = [
        &|one| one.dofs += 1,
        &|one| one.peak *= 1.01,
        &|one| one.peak_worst *= 1.01,
        &|one| one.half_width *= 1.01,
        &|one| one.half_width_worst = f64::NAN,
        &|one| one.cells = Cells::Fitted(9),
    ];
    for (index, spoil) in spoils.into_iter().enumerate() {
        let mut other = all.clone();
        spoil(&mut other[1]);
        assert_eq!(verdict(&all, &other), Verdict::Fail, "spoil {index}");
    }
    let mut slower = all.clone();
    slower[1].seconds.median *= 2.0;
    assert_eq!(verdict(&all, &slower), Verdict::Pass, "seconds are not compared");
}
