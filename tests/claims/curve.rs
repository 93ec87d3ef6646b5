//! The load–approach curve holds every load increment as it was found, the one that failed included.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use contact_vv::solution::Outcome;
use contact_vv::solve::Run;
use contact_vv::solve::curve::CurvePoint;

use crate::balance::solved_as_it_says;
use crate::outputs::{contact_vv, scene};
use crate::program::Folder;
use crate::scene_file::text_of;
use crate::workbench::parsed;

fn curve(text: &str) -> (Run, Vec<CurvePoint>) {
    let (discretisation, run) = solved_as_it_says(&parsed(text));
    let curve = discretisation.curve(&run).expect("recovered");
    (run, curve)
}

#[test]
fn half_width_and_peak_grow_as_the_square_root_of_the_load_and_the_approach_as_its_logarithm_says() {
    let (run, curve) = curve(&text_of("load-approach.toml"));
    assert_eq!(curve.len(), 8);
    let (load, modulus) = (22656.0, 210e3 / 0.91);
    let (a, p) = ((4.0 * load * 50.0 / (PI * modulus)).sqrt(), (load * modulus / (PI * 50.0)).sqrt());
    let approach = |point: &CurvePoint| point.contacts[0].approach.expect("pressed at one side");
    for (k, point) in (1..).zip(&curve) {
        let found = &point.contacts[0];
        assert_relative_eq!(point.share, f64::from(k) / 8.0);
        assert_eq!(point.outcome, Outcome::Converged);
        assert_relative_eq!(found.resultant, point.share * load, max_relative = 1e-8);
        assert_relative_eq!(found.half_width, a * point.share.sqrt(), max_relative = 2e-3);
        assert_relative_eq!(found.peak.expect("a limit"), p * point.share.sqrt(), max_relative = 2e-3);
    }
    // δ/P = C − ln P/(π E*), whatever the body at a distance makes of C.
    for k in [1, 3] {
        let falls = approach(&curve[k]) / curve[k].share - approach(&curve[2 * k + 1]) / curve[2 * k + 1].share;
        assert_relative_eq!(falls, load * 2f64.ln() / (PI * modulus), max_relative = 0.01);
    }
    let last = curve[7].contacts[0];
    assert!((last.half_width - run.measures().half_width()).abs() <= 0.0);
    assert!((last.resultant - run.transmitted()).abs() <= 0.0);
    assert_eq!(curve.iter().map(|point| point.iterations).sum::<usize>(), run.solution.work.iterations);
}

#[test]
fn increment_that_does_not_converge_is_the_last_row_with_its_outcome() {
    let text = text_of("load-approach.toml").replace("increments = 8\n", "increments = 8\nmax-iterations = 17\n");
    let (run, curve) = curve(&text);
    assert!(!run.solution.converged() && (2..8).contains(&curve.len()), "{} rows", curve.len());
    let (last, before) = curve.split_last().expect("rows");
    assert_eq!(last.outcome, Outcome::Capped);
    assert!(before.iter().all(|point| point.outcome == Outcome::Converged));
    assert_eq!(curve.iter().map(|point| point.iterations).sum::<usize>(), 17);
    assert_relative_eq!(last.share, run.share());
}

#[test]
fn curve_is_written_by_the_command_line() {
    let folder = Folder::made();
    let file = folder.at("curve.csv");
    let (well, _, error) = contact_vv(&["solve", &scene("load-approach"), "--no-error-bar", "--curve", &file]);
    assert!(well, "{error}");
    let mut rows = csv::Reader::from_path(&file).expect("written");
    let head = rows.headers().expect("a head").clone();
    let column = |name: &str| head.iter().position(|title| title == name).expect("a column");
    let (share, force) = (column("load_factor"), column("resultant_n"));
    let rows: Vec<csv::StringRecord> = rows.records().collect::<Result<_, _>>().expect("rows");
    assert_eq!(rows.len(), 8);
    for row in &rows {
        let number = |k: usize| row[k].parse::<f64>().expect("a number");
        assert_relative_eq!(number(force), 22656.0 * number(share), max_relative = 1e-8);
        assert_eq!((&row[column("outcome")], &row[column("half_width_deg")]), ("converged", ""));
    }
}
