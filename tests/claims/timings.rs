//! What is said about speed: medians, exponents, targets, and that recorded errors and counts are still the code's.

use approx::assert_relative_eq;
use contact_vv::case::library;
use contact_vv::case::{Case, Verdict};
use contact_vv::checkout::root;
use contact_vv::mesh::Order;
use contact_vv::study::timings::answers::Answers;
use contact_vv::study::timings::bar_cost::BarCosts;
use contact_vv::study::timings::growth::Counts;
use contact_vv::study::timings::judge::moved;
use contact_vv::study::timings::precision::{self, Family, LOADS, Point, half_widths};
use contact_vv::study::timings::record::{FOLDER, Measured, Record};
use contact_vv::study::timings::run::{Precision, Recosted, Recounted};
use contact_vv::study::timings::statistics::{Spread, exponent};
use contact_vv::study::timings::targets::targets;
use contact_vv::study::timings::{Numbers, default_mesh, growth, judge};

#[test]
fn spread_is_median_least_and_most_and_a_broken_value_spoils_it() {
    assert_eq!(Spread::of(&[3.0, 1.0, 2.0]), Spread { median: 2.0, least: 1.0, most: 3.0 });
    assert_eq!(Spread::of(&[4.0, 1.0, 2.0, 3.0]), Spread { median: 2.5, least: 1.0, most: 4.0 });
    assert_eq!(Spread::of_ratios(&[2.0, 9.0, 8.0], &[1.0, 3.0, 2.0]), Spread { median: 3.0, least: 2.0, most: 4.0 });
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
fn default_mesh_that_is_too_coarse_or_gives_no_number_is_not_accepted() {
    let mut problem = library::find("truncated-hertz", None).expect("known");
    let verdict = |problem: &Case| {
        let mesh = Numbers::DefaultMesh(default_mesh::measure(problem).expect("solved"));
        judge(&mesh).expect("judged")[0].verdict.clone()
    };
    assert_eq!(verdict(&problem), Verdict::Pass);
    problem.resolution.elements = 3;
    assert_eq!(verdict(&problem), Verdict::Fail);
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
        verdict(Numbers::Growth(Recounted { recorded: recorded.clone(), fresh: fresh.into() }))
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

#[test]
fn cost_of_bars_is_believed_only_with_the_meshes_it_was_measured_on() {
    let recorded = BarCosts::read().expect("recorded");
    let dofs: Vec<usize> = recorded.costs.iter().map(|one| one.dofs).collect();
    let verdict = |recorded: &BarCosts, fresh: &[usize]| {
        let numbers = Numbers::BarCost(Recosted { recorded: recorded.clone(), fresh: fresh.into() });
        judge(&numbers).expect("judged")[0].verdict.clone()
    };
    assert_eq!(verdict(&recorded, &dofs), Verdict::Pass);
    let other: Vec<usize> = dofs.iter().map(|dofs| dofs + 1).collect();
    assert_eq!(verdict(&recorded, &other), Verdict::Fail);
    assert_eq!(verdict(&recorded, &dofs[1..]), Verdict::Fail, "a mesh less");
    let fewer = BarCosts { costs: recorded.costs[1..].to_vec(), ..recorded };
    assert_eq!(verdict(&fewer, &dofs[1..]), Verdict::Fail, "a mesh less in the record");
}
