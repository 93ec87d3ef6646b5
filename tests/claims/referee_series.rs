//! A refinement series of answers shows its order, and whether it goes to the truth.

use contact_vv::case::Verdict;
use contact_vv::case::library::TruncatedHertz;
use contact_vv::measure::Quantity;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::referee::export::own;
use contact_vv::referee::series::{self, Series};
use contact_vv::referee::{Asked, Truth, Verdicts, picture};
use contact_vv::solve::Formulation;

use crate::balance::solved_on;
use crate::handed::{judged_as, read};
use crate::outputs::contact_vv;
use crate::program::Folder;
use crate::workbench::truth;

/// Meshes that are halved, growth and all.
const HALVED: [(usize, u32); 3] = [(8, 0), (8, 1), (8, 2)];

/// Answers on meshes with so many elements, halved so often, their pressures times a factor.
fn answers(truth: &Truth, meshes: &[(usize, u32)], factor: f64) -> Vec<Verdicts> {
    let answer = |&(elements, refinement): &(usize, u32)| {
        let resolution = Resolution { elements, refinement, order: Order::Linear };
        let (discretisation, run) = solved_on(truth.case.scene.clone(), resolution, &Formulation::verification());
        let mut document = own::answer("truncated-hertz", &discretisation, &run);
        for contact in &mut document.contacts {
            contact.pressure.iter_mut().for_each(|p| *p *= factor);
            contact.edges.clear();
        }
        let text = serde_json::to_string(&document).expect("JSON");
        judged_as(truth, "series.json", &text, &Asked::default())
    };
    meshes.iter().map(answer).collect()
}

fn verdicts_of(series: &Series) -> Vec<&Verdict> {
    series.along.iter().map(|one| &one.judged.verdict).collect()
}

#[test]
fn series_that_goes_elsewhere_is_found_and_one_that_is_not_halved_is_not_extrapolated() {
    let closed = TruncatedHertz::default();
    let truth = truth("truncated-hertz");
    let all = answers(truth, &HALVED, 1.0);
    // Two meshes are a series without a limit, one is none.
    assert_eq!([1, 2].map(|count| series::all(truth, &all[..count]).len()), [0, 1]);
    let right = series::all(truth, &all).pop().expect("a series");
    for (along, value) in right.along.iter().zip([closed.half_width(), closed.case().reference_pressure(0, 0.0)]) {
        for (own, error) in along.values.iter().zip(&along.errors) {
            assert!((own / value - 1.0 - error).abs() <= 1e-9, "{}: {own}, {error}", along.name);
        }
    }
    assert!(verdicts_of(&right).iter().all(|verdict| **verdict == Verdict::Pass), "{right:?}");
    assert!(right.sizes.windows(2).all(|two| (two[0] / two[1] - 2.0).abs() < 0.1), "{:?}", right.sizes);
    let elsewhere = series::all(truth, &answers(truth, &HALVED, 1.05)).pop().expect("a series");
    let peak = elsewhere.along.iter().find(|one| one.name == "peak pressure").expect("a peak");
    assert_eq!(peak.judged.verdict, Verdict::Fail, "{peak:?}");
    // Of the three neither step is halved, or one alone.
    for meshes in [[(8, 0), (12, 0), (18, 0)], [(8, 0), (8, 1), (12, 1)], [(8, 0), (12, 0), (12, 1)]] {
        let uneven = series::all(truth, &answers(truth, &meshes, 1.0)).pop().expect("a series");
        assert!(verdicts_of(&uneven).iter().all(|verdict| matches!(verdict, Verdict::NotRun(_))), "{uneven:?}");
    }
}

/// A table of Hertz's pressure at so many even steps on the half-width, and at few points beyond.
fn table(steps: usize) -> String {
    let inside = (0..=steps).map(|k| {
        let share = k as f64 / steps as f64;
        [2.5 * share, 5_769.230_769 * (1.0 - share * share).sqrt()]
    });
    let rows = inside.chain([[3.75, 0.0], [5.0, 0.0]]).map(|[s, p]| format!("{s},{p}\n"));
    "position [mm],pressure [MPa]\n".to_owned() + &rows.collect::<String>()
}

#[test]
fn a_mesh_of_a_series_is_as_fine_as_its_edges_within_the_contact_and_its_limit_as_far_off_as_both_bars_say() {
    let truth = truth("truncated-hertz");
    let answers = [8, 16, 32].map(|steps| judged_as(truth, "series.csv", &table(steps), &Asked::default()));
    let series = series::all(truth, &answers).pop().expect("a series");
    for (size, steps) in series.sizes.iter().zip([8.0, 16.0, 32.0]) {
        assert!((size * steps - 1.0).abs() <= 0.06, "{size} of {steps}");
    }
    for (along, quantity) in series.along.iter().zip([Quantity::SecondMomentWidth, Quantity::PeakPressure]) {
        let (limit, known) = (along.limit.expect("a limit"), truth.known(0, &quantity));
        let bars = along.judged.value * (limit.bar + known.bar);
        assert!((bars - (limit.limit - known.reference.value).abs()).abs() <= 1e-9 * limit.limit, "{along:?}");
    }
}

/// Where the contact ends within its edge jumps from mesh to mesh, and with it what straight lines leave of the width;
/// changes below what the truth is known to tell nothing.
#[test]
fn exact_pressures_pass_wherever_the_contact_ends_within_an_edge_and_whatever_the_last_changes_are() {
    let truth = truth("truncated-hertz");
    let at = |count: usize, size: f64| -> String {
        let row = |k: usize| {
            let s = size * k as f64;
            format!("{s},{}\n", 5_769.230_769 * (1.0 - (s / 2.5).powi(2)).max(0.0).sqrt())
        };
        "position [mm],pressure [MPa]\n".to_owned() + &(0..count).map(row).collect::<String>()
    };
    for per in [10.1, 10.5, 10.84, 13.3, 14.7, 20.3] {
        let answers = [1.0, 2.0, 4.0].map(|finer| {
            let size = 2.5 / per / finer;
            judged_as(truth, "series.csv", &at((3.2 / size) as usize + 2, size), &Asked::default())
        });
        let series = series::all(truth, &answers).pop().expect("a series");
        assert!(verdicts_of(&series).iter().all(|verdict| **verdict == Verdict::Pass), "{per}: {series:?}");
    }
    let moved = |factors: [f64; 3]| {
        let answers = factors.into_iter().zip([8, 16, 32]).map(|(factor, steps)| {
            let right = table(steps);
            let scaled = right.lines().skip(1).map(|row| {
                let (s, p) = row.split_once(',').expect("two cells");
                format!("{s},{}\n", factor * p.parse::<f64>().expect("a number"))
            });
            let text = "position [mm],pressure [MPa]\n".to_owned() + &scaled.collect::<String>();
            judged_as(truth, "series.csv", &text, &Asked::default())
        });
        let series = series::all(truth, &answers.collect::<Vec<_>>()).pop().expect("a series");
        series.along.into_iter().find(|one| one.name == "peak pressure").expect("a peak").judged
    };
    let bar = truth.known(0, &Quantity::PeakPressure).bar / truth.known(0, &Quantity::PeakPressure).reference.value;
    // Changes that grow: right where the last value is the truth as far as that is known, wrong where it is not.
    assert_eq!(moved([1.0 + 3.5 * bar, 1.0 + 2.0 * bar, 1.0]).verdict, Verdict::Pass);
    assert_eq!(moved([1.001, 1.003, 1.008]).verdict, Verdict::Fail);
}

#[test]
fn the_table_of_a_series_tells_errors_in_per_cent() {
    let folder = Folder::made();
    let file = |(elements, refinement): (usize, u32)| {
        let resolution = Resolution { elements, refinement, order: Order::Linear };
        let scene = TruncatedHertz::default().case().scene;
        let (discretisation, run) = solved_on(scene, resolution, &Formulation::verification());
        let text = serde_json::to_string(&own::answer("truncated-hertz", &discretisation, &run)).expect("JSON");
        folder.with(&format!("{elements}-{refinement}.json"), text)
    };
    let [coarse, medium, fine] = HALVED.map(file);
    let (_, told, error) = contact_vv(&["judge", "truncated-hertz", &coarse, &medium, &fine, "--series"]);
    let rows = told.lines().filter(|line| line.contains("second-moment width") && line.contains(" %"));
    let numbers = |line: &str| line.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).collect::<Vec<_>>();
    let rows: Vec<Vec<f64>> = rows.map(numbers).filter(|row| row.len() >= 3).collect();
    assert!(rows.len() >= HALVED.len(), "{told}{error}");
    for row in &rows[rows.len() - HALVED.len()..] {
        let wanted = 100.0 * (row[1] / TruncatedHertz::default().half_width() - 1.0);
        assert!((row[2] - wanted).abs() <= 0.01 * wanted.abs() + 1e-3, "{row:?}: {wanted}");
    }
}

#[test]
fn picture_shows_what_was_handed_in_on_the_truth() {
    let truth = truth("truncated-hertz");
    let one = &answers(truth, &[(8, 0)], 1.0)[0];
    let sheet = picture::sheet(truth, &one.answer);
    let [pressures, differences] = &sheet.charts[0][..] else { panic!("two charts") };
    assert_eq!(pressures.series[0].points.len(), one.answer.contacts[0].points.len());
    let peak = TruncatedHertz::default().case().reference_pressure(0, 0.0);
    assert!((pressures.series[1].points[0].1 - peak).abs() <= 1e-9 * peak);
    let apart = pressures.series[0].points[0].1 - peak;
    assert!((differences.series[0].points[0].1 - apart).abs() <= 1e-9 * peak);
    assert!(sheet.drawing().expect("drawn").contains("Difference from the truth"));
}

#[test]
fn picture_spans_what_was_handed_in_and_its_axis_what_is_drawn() {
    let truth = truth("truncated-hertz");
    let text = "position [mm],pressure [MPa]\n-4,-1000\n0,20000\n8,0\n";
    let answer = read(&truth.case, "a.csv", text, &Asked::default()).expect("read");
    let sheet = picture::sheet(truth, &answer);
    let [pressures, differences] = &sheet.charts[0][..] else { panic!("two charts") };
    let places: Vec<f64> = [0, 100, 400].map(|k| pressures.series[1].points[k].0).into();
    assert_eq!(places, [-4.0, -1.0, 8.0]);
    assert!(pressures.x.label.contains("mm") && differences.x.range == Some((-4.0, 8.0)));
    let (low, high) = pressures.y.range.expect("a range");
    assert!((low + 1.15 * 1000.0).abs() <= 1e-9 && (high - 1.15 * 20_000.0).abs() <= 1e-9, "{low} to {high}");
}
