//! Forces of halves: at the middles of edges, without the node on the symmetry line or on the axis, and of a model of
//! both halves or of a sector.

use std::f64::consts::{PI, TAU};

use contact_vv::cli::vtu;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::{Asked, Truth, verdicts};

use crate::foreign::vtk;
use crate::handed::{PRESSURES, failed, judged_as, judged_rows, moved, read, table};
use crate::workbench::{block_text, parsed, refused, truth};

/// Half-width of the truncated cases \[mm\].
const A: f64 = 2.5;
/// Columns of a table of forces.
const FORCES: &str = "position [mm],force [N]";
/// Edges from the middle to where the last candidate lies, and their length \[mm\].
const EDGES: i32 = 80;
const STEP: f64 = 0.05;

/// Force of `p₀ √(1 − s²/a²)` between two places, `p₀/2 [s √(1 − s²/a²) + a asin(s/a)]` \[N\].
fn of_strip([from, to]: [f64; 2]) -> f64 {
    let peak = 2.0 * 210e3 / 0.91 * A / (4.0 * 50.0);
    let up_to = |s: f64| {
        let x = (s / A).min(1.0);
        0.5 * peak * A * (x * (1.0 - x * x).sqrt() + x.asin())
    };
    up_to(to) - up_to(from)
}

/// Force of `p₀ √(1 − r²/a²)` on a ring, `2πp₀a²/3 [(1 − r²/a²)^{3/2}]` between its radii \[N\].
fn of_ring([from, to]: [f64; 2]) -> f64 {
    let peak = 2.0 * 210e3 / 0.91 * A / (PI * 50.0);
    let beyond = |r: f64| (1.0 - (r / A).powi(2)).max(0.0).powf(1.5);
    TAU * peak * A * A / 3.0 * (beyond(from) - beyond(to))
}

/// A row an edge: its middle and its force.
fn by_edges(force: impl Fn([f64; 2]) -> f64, times: f64) -> Vec<[f64; 2]> {
    let row = |k: i32| {
        let ends = [STEP * f64::from(k), STEP * f64::from(k + 1)];
        [0.5 * (ends[0] + ends[1]), times * force(ends)]
    };
    (0..EDGES).map(row).collect()
}

/// A row a node: what of the two edges beside it lies nearer to it.
fn by_nodes() -> Vec<[f64; 2]> {
    let row = |k: i32| {
        let s = STEP * f64::from(k);
        [s, of_strip([(s - 0.5 * STEP).max(0.0), s + 0.5 * STEP])]
    };
    (0..=EDGES).map(row).collect()
}

fn says(truth: &Truth, columns: &str, rows: Vec<[f64; 2]>) -> Vec<String> {
    let found = judged_rows(truth, columns, rows);
    assert_eq!(found.met(), found.mistakes.is_empty(), "{:?}", failed(&found));
    found.mistakes
}

#[test]
fn forces_at_the_middles_of_edges_are_of_all_the_area_up_to_the_line_or_axis() {
    for (name, rows) in [("truncated-hertz", by_edges(of_strip, 1.0)), ("truncated-sphere", by_edges(of_ring, 1.0))] {
        let found = judged_rows(truth(name), FORCES, rows);
        assert_eq!(failed(&found), [""; 0], "{name}");
    }
    assert_eq!(says(truth("truncated-hertz"), FORCES, by_nodes()), [""; 0]);
}

#[test]
fn forces_without_the_node_on_the_line_are_not_judged() {
    let rows = by_nodes().into_iter().skip(1);
    let answer = read(&truth("truncated-hertz").case, "theirs.csv", table(FORCES, rows), &Asked::default());
    let judged = answer.and_then(|answer| verdicts(truth("truncated-hertz"), answer, ENGINEERING));
    refused(judged, &["theirs.csv", "stop at 0.05000 mm", "hand in every point"]);
}

#[test]
fn forces_of_both_halves_on_the_line_and_those_of_sectors_are_named() {
    let mut rows = by_nodes();
    rows[0][1] *= 2.0;
    let wanted = "the force on the symmetry line is that of both halves: halve it";
    assert_eq!(says(truth("truncated-hertz"), FORCES, rows), [wanted]);
    for angle in [1, 2, 5, 10, 90] {
        let by = 360 / angle;
        let rows = by_edges(of_ring, 1.0 / f64::from(by));
        let wanted = format!("nodal forces are those of a sector of {angle}°: they are to be multiplied by {by}");
        assert_eq!(says(truth("truncated-sphere"), FORCES, rows), [wanted]);
    }
}

#[test]
fn angles_from_another_line_than_the_load_line_are_named_with_it() {
    let pin = truth("pin-rod");
    let at = |angle: f64| pin.pressure(0, angle.to_radians());
    for (turned, line) in
        [(|s| s - 90.0) as fn(f64) -> f64, |s| s + 270.0, |s| 180.0 - s].into_iter().zip([90, 270, 180])
    {
        let rows = (0..=75).map(f64::from).map(|angle| [turned(angle), at(angle)]);
        let text = table(&PRESSURES.replace("mm", "deg"), rows);
        let answer = read(&pin.case, "theirs.csv", text, &Asked::default()).expect("read");
        // What ends under pressure is refused, with what explains it.
        let named = match verdicts(pin, answer, ENGINEERING) {
            Ok(found) => found.mistakes.join("; "),
            Err(error) => error.to_string(),
        };
        assert!(named.ends_with(&format!("angles are counted from a line {line}° off the load line")), "{named}");
    }
}

#[test]
fn positions_of_a_contact_that_is_not_symmetric_with_the_other_sign_are_named() {
    // N/A + 6 M/(t b²) x/b of a block under a force and a moment: 100 + 4 x, from x = -10 to 10.
    let truth = truth("moment");
    let rows = |sign: f64| (-10..=10).map(f64::from).map(|x| [x, 100.0 + 4.0 * sign * x]).collect::<Vec<_>>();
    assert_eq!(says(truth, PRESSURES, rows(1.0)), [""; 0]);
    assert_eq!(says(truth, PRESSURES, rows(-1.0)), ["positions run the other way: change their sign"]);
}

/// The right half of a beam on two rounded supports, of which one is left: its contact has both sides, the scene one
/// half.
#[test]
fn contact_off_the_symmetry_line_carries_what_both_halves_do() {
    let load = "traction = { at = \"far\", value = [0, -10] }";
    let contact = "origin = [60, 0]\nboth-sides = true\nsymmetric = true\ngap = { parabola = 25 }\nstretch = \
        2\n[mesh]\nelements = 8\nper = 0.8";
    let truth = Truth::of(parsed(&block_text([0.0, 90.0], 30.0, load, contact))).expect("solved");
    let (meshed, run) = truth.case.solve().expect("solved");
    let points = run.solution.points_of(0);
    for (times, met) in [(1.0, true), (2.0, false)] {
        let rows = points.iter().map(|point| [point.position, times * point.weight * point.pressure]);
        let found = judged_rows(&truth, FORCES, rows);
        assert_eq!(failed(&found).is_empty(), met, "{times}: {:?}", failed(&found));
    }
    let text = vtu::text(&meshed.discretisation, &run).expect("written");
    assert_eq!(failed(&judged_as(&truth, "ours.vtu", &text, &moved())), [""; 0]);
    // What of a whole model is not the half that the scene is: beside the contact, or elsewhere alone.
    for (grid, said) in [
        (vtk::points(&|x, y| [60.0 - 10.0 * x, y]), "beyond its candidate stretch"),
        (vtk::points(&|x, y| [0.0 - 60.0 - x, y]), "no edge of its cells lies on the side"),
    ] {
        let told = read(&truth.case, "theirs.vtk", grid, &moved());
        refused(told, &[said, "of a symmetric whole hand in the half that the scene is"]);
    }
}
