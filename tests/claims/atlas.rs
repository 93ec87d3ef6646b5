//! The stability atlas: what is recorded, frozen, resumed and refused.

use contact_vv::case::Verdict;
use contact_vv::error::{Error, Kind};
use contact_vv::solve::Ended;
use contact_vv::solve::{Discretisation, Element, Iteration};
use contact_vv::stability::halving::SOFT;
use contact_vv::study::Study;
use contact_vv::study::atlas::{self, Chart, Numbers, Plane, Record, Site, plane, run};
use contact_vv::study::method::Method;
use contact_vv::study::records;
use rayon::prelude::*;

use crate::workbench::spoiled;

fn point(method: Method, ordinate: f64, stiffness: f64, class: Ended, iterations: usize) -> Record {
    Record {
        method,
        ordinate,
        stiffness,
        class,
        iterations,
        error: 0.01,
        penalty: Some(0.02),
        predicted_iterations: Some(f64::INFINITY),
    }
}

/// A plane of converged points.
fn flat(plane: Plane) -> Vec<Record> {
    let points = plane.rows().into_iter().flat_map(|row| Plane::stiffnesses().into_iter().map(move |k| (row, k)));
    points.map(|((site, method), k)| point(method, site.ordinate, k, Ended::Converged, 17)).collect()
}

#[test]
fn an_incomplete_or_foreign_record_is_refused_with_the_command_that_renews_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let (plane, file) = (Plane::Mesh, folder.path().join("mesh.csv"));
    let refused = || Chart::read_from(&file, plane).expect_err("refused").to_string();
    let write = |records: &[Record]| {
        records::write(&file, &plane::head(), &plane::lines(records)).expect("written");
        std::fs::read_to_string(&file).expect("written")
    };
    let (whole, starts) = (flat(plane), Plane::stiffnesses().len());
    let is_refused = || assert!(refused().contains("mesh.csv") && refused().contains("-- atlas"), "{}", refused());
    let elsewhere = spoiled(&whole, |all| all[..starts].iter_mut().for_each(|one| one.ordinate *= 2.0));
    for records in [&whole[starts..], &elsewhere] {
        write(records);
        is_refused();
    }
    let text = write(&whole);
    assert_eq!(Chart::read_from(&file, plane).expect("complete").rows.concat().len(), whole.len());
    // Starts of another stiffness.
    std::fs::write(&file, text.replacen("class 1e0", "class 2e0", 1)).expect("written");
    is_refused();
    for foreign in ["layer.varying.penalty", "layer.varying", "line"] {
        std::fs::write(&file, text.replacen("layer.varying.secant", foreign, 1)).expect("written");
        let parts = ["mesh.csv", "-- atlas", &format!("`{foreign}`")];
        assert!(parts.iter().all(|part| refused().contains(part)), "{foreign}: {}", refused());
    }
    let missing = Chart::read_from(&folder.path().join("stretch.csv"), Plane::Stretch).expect_err("missing");
    assert!(missing.kind == Kind::MissingFile, "{missing}");
}

#[test]
fn atlas_turns_red_where_a_prediction_failed() {
    let plane = Plane::Stretch;
    let mut records = flat(plane);
    for record in &mut records {
        (record.predicted_iterations, record.iterations, record.error) = (Some(record.iterations as f64), 20, 1e-3);
    }
    let verdicts = |records: &[Record]| {
        let numbers = Numbers::Surveyed(Chart::of(plane, records));
        numbers.judge().expect("judged").iter().map(|one| one.verdict == Verdict::Pass).collect::<Vec<_>>()
    };
    // Nothing is predicted to fail: a prediction that is compared with nothing is red.
    assert_eq!(verdicts(&records), [false, true, true, false, true]);
    let of_node = |r: &Record, algorithm| r.method == Method::usual(Element::Node, algorithm);
    let node =
        |algorithm| records.iter().position(|r| of_node(r, algorithm) && r.stiffness >= SOFT).expect("a hard start");
    let [constant, kinematic] = [Iteration::Constant, Iteration::Kinematic].map(node);
    for record in records.iter_mut().filter(|record| record.method.algorithm == Iteration::Kinematic) {
        record.predicted_iterations = Some(record.iterations as f64);
    }
    (records[constant].predicted_iterations, records[constant].class) = (Some(f64::INFINITY), Ended::Capped);
    assert_eq!(verdicts(&records), [true; 5]);
    let spoiled = |place: usize, change: &dyn Fn(&mut Record)| {
        verdicts(&spoiled(&records, |all| change(&mut all[place]))).iter().position(|passed| !passed)
    };
    assert_eq!(spoiled(constant, &|r| r.class = Ended::Converged), Some(0));
    assert_eq!(spoiled(constant + 1, &|r| r.class = Ended::Capped), Some(1));
    assert_eq!(spoiled(constant + 1, &|r| r.iterations *= 3), Some(2));
    assert_eq!(spoiled(kinematic, &|r| r.iterations += 2), Some(3));
    for class in [Ended::Diverged, Ended::Cycling] {
        assert_eq!(spoiled(constant, &|r| r.class = class), Some(4));
    }
    // The start next below is soft, and this plane is the one that the threshold was taken from.
    assert_eq!(spoiled(kinematic - 1, &|r| r.iterations += 2), None);
}

/// Of the meshes of the full planes every third is entered again, and on it three of twenty points; of the others every
/// mesh, and one of twenty points.
const FULL: [usize; 2] = [3, 3];
const OTHERS: [usize; 2] = [1, 1];
const OF: usize = 20;
/// A recomputed error or prediction may differ by this share: the records hold four digits.
const DIGITS: f64 = 2e-3;
/// The points of a plane that are run again: how many these are, and how many of them are not as recorded.
fn recomputed(plane: Plane) -> Result<[usize; 2], Error> {
    let chart = Chart::read(plane)?;
    let methods = Method::all().len();
    let [every, share] = if plane.is_full() { FULL } else { OTHERS };
    let entered: Vec<(usize, Site)> = plane.sites().into_iter().enumerate().step_by(every).collect();
    let again = |(k, site): &(usize, Site)| -> Result<Vec<bool>, Error> {
        let chosen = |row: usize, column: usize| (7 * (k * methods + row) + 3 * column) % OF < share;
        let fresh = run::points(site, chosen)?;
        Ok(fresh
            .iter()
            .map(|([row, column], fresh)| is_as_recorded(&chart, k * methods + row, *column, fresh))
            .collect())
    };
    let as_recorded = entered.par_iter().map(again).collect::<Result<Vec<_>, _>>()?.concat();
    Ok([as_recorded.len(), as_recorded.iter().filter(|same| !**same).count()])
}

/// Whether a fresh point is the recorded one: class and prediction always, what was measured where no boundary is near.
fn is_as_recorded(chart: &Chart, row: usize, column: usize, fresh: &Record) -> bool {
    let kept = &chart.rows[row][column];
    let near = |a: f64, b: f64| a.is_finite() && b.is_finite() && (a - b).abs() <= DIGITS * a.abs().max(b.abs());
    let alike = |a: f64, b: f64| (a.is_nan() && b.is_nan()) || a == b || near(a, b);
    let both =
        |a: Option<f64>, b: Option<f64>| a.is_none() && b.is_none() || a.zip(b).is_some_and(|(a, b)| alike(a, b));
    let measured =
        kept.iterations == fresh.iterations && alike(kept.error, fresh.error) && both(kept.penalty, fresh.penalty);
    let exact = kept.class == Ended::Converged && !is_near_a_boundary(chart, row, column);
    let predicted = both(kept.predicted_iterations, fresh.predicted_iterations);
    kept.class == fresh.class && predicted && (!exact || measured)
}

/// Whether a neighbour in stiffness or in the other number ended in another class.
fn is_near_a_boundary(chart: &Chart, row: usize, column: usize) -> bool {
    let across = Method::all().len();
    let beside = [column.checked_sub(1), Some(column + 1)].map(|column| Some((row, column?)));
    let above = [row.checked_sub(across), Some(row + across)].map(|row| Some((row?, column)));
    let places = beside.into_iter().chain(above).flatten();
    let mut neighbours = places.filter_map(|(row, column)| chart.rows.get(row)?.get(column));
    neighbours.any(|other| other.class != chart.rows[row][column].class)
}

#[test]
fn points_of_every_plane_that_are_run_again_are_as_recorded() {
    for plane in Plane::ALL {
        let [again, moved] = recomputed(plane).expect("run again");
        assert!(again > 0 && moved == 0, "{}: {moved} of {again}, `atlas` renews the record", plane.name());
    }
}

#[test]
fn what_ends_otherwise_than_its_neighbours_is_near_a_boundary() {
    let plane = Plane::Mesh;
    let mut records = flat(plane);
    records[5].class = Ended::Diverged;
    let chart = Chart::of(plane, &records);
    assert_eq!([3, 4, 5, 6, 7].map(|column| is_near_a_boundary(&chart, 0, column)), [false, true, true, true, false]);
    // The same formulation at the next ordinate feels the boundary, at the one after it no more.
    let rows_an_ordinate = Method::all().len();
    assert!(is_near_a_boundary(&chart, rows_an_ordinate, 5) && !is_near_a_boundary(&chart, 2 * rows_an_ordinate, 5));
    assert!(!is_near_a_boundary(&chart, 1, 5));
}

#[test]
fn records_of_a_plane_are_those_of_its_sites_in_their_order() {
    let folder = tempfile::tempdir().expect("a folder");
    let (plane, file) = (Plane::Mesh, folder.path().join("mesh.csv"));
    // Sites that were finished before, with a mark that no run could leave, are not surveyed again.
    for site in plane.sites() {
        let own = flat(plane).into_iter().filter(|one| one.ordinate == site.ordinate);
        let marked: Vec<Record> =
            own.map(|record| Record { class: Ended::Cycling, iterations: 123_456, ..record }).collect();
        let kept = folder.path().join(site.key() + ".csv");
        records::write(&kept, &plane::head(), &plane::lines(&marked)).expect("written");
    }
    let surveyed = run::renew(plane, folder.path(), &file, || ()).expect("surveyed");
    let chart = Chart::read_from(&file, plane).expect("complete");
    assert_eq!(surveyed, chart.rows.len());
    assert!(chart.rows.iter().flatten().all(|record| record.iterations == 123_456));
}

#[test]
fn a_point_is_as_recorded_only_if_class_counts_measures_and_predictions_are() {
    let plane = Plane::Mesh;
    let mut records = flat(plane);
    records[5].class = Ended::Diverged;
    let chart = Chart::of(plane, &records);
    let spoiled = |change: &dyn Fn(&mut Record), column: usize| {
        is_as_recorded(&chart, 0, column, &spoiled(&records[column], change))
    };
    assert!(spoiled(&|_| (), 0) && spoiled(&|_| (), 4) && spoiled(&|_| (), 5));
    let changes: [&dyn Fn(&mut Record); 8] = [
        &|r| r.class = Ended::Capped,
        &|r| r.iterations += 1,
        &|r| r.error *= 1.01,
        &|r| r.error = f64::NAN,
        &|r| r.penalty = Some(0.0202),
        &|r| r.penalty = None,
        &|r| r.predicted_iterations = Some(5000.0),
        &|r| r.predicted_iterations = None,
    ];
    for (k, change) in changes.iter().enumerate() {
        assert!(!spoiled(change, 0), "change {k} far from a boundary");
        // Beside a boundary what was measured may move, the class and the predictions may not.
        assert_eq!(spoiled(change, 4), (1..6).contains(&k), "change {k} beside a boundary");
    }
}

#[test]
fn a_digest_takes_what_converges_everywhere_and_the_best_of_the_worst() {
    let mut charts = Plane::ALL.map(|plane| Chart::read(plane).expect("records"));
    let method = Method::usual(Element::Node, Iteration::Constant);
    let of = |charts: &[Chart]| {
        let digests = plane::digests(&charts.iter().collect::<Vec<_>>());
        digests.into_iter().find(|d| d.method == method).and_then(|digest| digest.safe)
    };
    let before = of(&charts);
    let plane::Safe { from, to, best, best_iterations, iterations } = before.expect("a range");
    assert!(best_iterations <= iterations);
    assert!(from <= best && best <= to && from < to);
    let row = charts[0].rows.iter_mut().find(|row| row[0].method == method).expect("a row");
    let point = row.iter_mut().find(|r| plane::same(r.stiffness, best)).expect("the best start");
    point.iterations = 10 * best_iterations;
    let after = of(&charts);
    assert!(after.is_some_and(|now| !plane::same(now.best, best)
        && now.best_iterations >= best_iterations
        && now.iterations >= 10 * best_iterations));
    let row = charts[0].rows.iter_mut().find(|row| row[0].method == method).expect("a row");
    row.iter_mut().filter(|r| r.stiffness >= best).for_each(|r| r.class = Ended::Capped);
    assert!(of(&charts).is_none_or(|now| now.to < best));
}

#[test]
fn what_is_told_of_bodies_of_revolution_is_what_their_own_record_says() {
    let told = |spoil: &dyn Fn(&mut Record)| {
        let mut charts = Plane::ALL.map(|plane| Chart::read(plane).expect("records"));
        let own = charts.iter_mut().filter(|chart| chart.plane == Plane::Sphere);
        own.flat_map(|chart| chart.rows.iter_mut().flatten()).for_each(spoil);
        atlas::revolution(&charts.iter().collect::<Vec<_>>())
    };
    let says = |text: &str, parts: [&str; 3]| assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    let [law, map] = ["the halving law holds", "the averaged map holds"];
    says(&told(&|_| ()), ["have the recommendation of plane scenes", law, map]);
    let is = |record: &Record, algorithm| record.method.algorithm == algorithm;
    let kinematic = told(&|record| {
        if is(record, Iteration::Kinematic) {
            record.class = Ended::Capped;
        }
    });
    says(&kinematic, ["have another recommendation", "the halving law does not hold", map]);
    says(&kinematic, ["ends right for no κ₀", "those of plane scenes do for κ₀ from", map]);
    let constant = told(&|record| {
        if is(record, Iteration::Constant) {
            record.class = Ended::Cycling;
        }
    });
    says(&constant, ["have the recommendation of plane scenes", law, "the averaged map does not hold"]);
}

#[test]
fn atlas_records_springs_too_soft_as_unsupported() {
    let (site, method) = Plane::Cylinder.rows()[0];
    let case = site.case();
    let discretisation = Discretisation::of(case.scene, case.resolution).expect("meshed");
    let record = run::Ground::of(&discretisation, site.ordinate, method).record(method, 1e-12).expect("a record");
    assert_eq!((record.class, record.iterations), (Ended::Unsupported, 0));
}

#[test]
fn starts_cease_to_be_soft_where_the_halving_law_has_it() {
    // The first start of each mesh that takes no more iterations than a hard one, and the one before it.
    let charts = [Plane::Stretch, Plane::Mesh].map(|plane| Chart::read(plane).expect("a record"));
    let law = Method::usual(Element::Node, Iteration::Kinematic);
    let mut from: Vec<[f64; 2]> = Vec::new();
    for row in charts.iter().flat_map(|chart| chart.of_method(law)) {
        let hard = row.iter().position(|one| one.iterations == row[row.len() - 1].iterations).expect("itself");
        from.extend(hard.checked_sub(1).map(|soft| [row[soft].stiffness, row[hard].stiffness]));
    }
    from.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(from.len() > 8, "{from:?}");
    let [soft, hard] = from[from.len() / 2];
    assert!(soft < SOFT && SOFT <= hard, "{from:?}");
}
