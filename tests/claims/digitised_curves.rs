//! Curves of digitised sources against ours: what agrees passes, what does not turns red, whatever the quantity and its unit.

use std::fmt::Write;
use std::fs;

use contact_vv::case::Verdict;
use contact_vv::case::library::PinRod;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::persson::PinInHole;
use contact_vv::solve::{Discretisation, Formulation, Run};
use contact_vv::study::measured::{against, judge_curves};

const ROD: &str = "pin_radius = 10.0\nclearance = 0.05\neye_outer_radius = 20.0\nshank_width = 20.0\nshank_end = 60.0\n\
    thickness = 1.0\nforce = 2000.0\nfriction = 0.0\n[pin]\nyoung = 210e3\npoisson = 0.3\n[rod]\nyoung = 210e3\npoisson = 0.3\n";
const SHEET: &str = "pin_radius = 10.0\nclearance = 0.01\nrim_radius = 5000.0\nthickness = 1.0\nfriction = 0.0\n\
    [pin]\nyoung = 210e3\npoisson = 0.3\n[sheet]\nyoung = 210e3\npoisson = 0.3\n";
const PROVENANCE: &str = "citation = \"synthetic\"\ndigitised_by = \"nobody\"\nmethod = \"computed\"\n[[curves]]\nfile = \"curve.csv\"\n\
    figure = \"none\"\naxis_calibration = \"none\"\nkind = \"measured\"\nhand = \"first hand\"\n";

/// The verdict on a curve of two quantities: columns, relative errors of both, points.
fn verdict(scene: &str, [across, up]: [&str; 2], error: f64, points: impl IntoIterator<Item = [f64; 2]>) -> Verdict {
    let named = |column: &str| column.rsplit_once('_').map(|(name, unit)| format!("{name}_{unit},{name}_error_{unit}"));
    let mut csv = format!("{},{}\n", named(across).expect("a unit"), named(up).expect("a unit"));
    for [x, y] in points {
        let _ = writeln!(csv, "{x},{},{y},{}", 1e-6 * (x.abs() + 1.0), error * (y.abs() + 1e-3));
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in [("scene.toml", scene), ("provenance.toml", PROVENANCE), ("curve.csv", &csv)] {
        fs::write(folder.path().join(name), text).expect("the temporary folder is writable");
    }
    let found = against(folder.path()).expect("a complete folder");
    assert!(found.as_ref().is_ok_and(|curves| curves.len() == 1));
    judge_curves("synthetic", &found)[0].verdict.clone()
}

/// Half-angles of Persson's closed form over the force on a thickness of 1 mm.
fn persson(times: f64, angles: &[f64]) -> Vec<[f64; 2]> {
    let force = |degrees: f64| PinInHole::load_for(degrees.to_radians(), 0.01, 210e3);
    angles.iter().map(|degrees| [force(*degrees), times * degrees]).collect()
}

#[test]
fn loads_over_the_angle_of_contact_agree_with_the_closed_form_and_a_wrong_angle_turns_red() {
    let columns = ["force_n", "half_angle_deg"];
    assert_eq!(verdict(SHEET, columns, 5e-3, persson(1.0, &[30.0, 60.0, 75.0])), Verdict::Pass);
    assert_eq!(verdict(SHEET, columns, 5e-3, persson(1.03, &[60.0])), Verdict::Fail);
    assert_eq!(verdict(SHEET, columns, 5e-3, persson(0.97, &[30.0])), Verdict::Fail);
}

#[test]
fn pressures_and_hoop_stresses_agree_over_degrees_and_over_millimetres() {
    let resolution = Resolution { elements: 36, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(PinRod::default().scene(), resolution).expect("a mesh");
    let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
    let fields = discretisation.recover(&run.solution).expect("fields");
    let inside = |[at, value]: [f64; 2]| ((0.2..0.8).contains(&at)).then_some([at, value]);
    let edges = run.solution.edges.iter().map(|edge| [edge.position(), edge.pressure]);
    let pressures: Vec<[f64; 2]> = edges.filter_map(inside).collect();
    let hoops = discretisation.hoop_stresses(&fields, 0).expect("stresses");
    let hoops: Vec<[f64; 2]> = hoops.into_iter().filter_map(inside).collect();

    for (column, points, radius) in [("pressure_mpa", &pressures, 10.0), ("hoop_stress_mpa", &hoops, 10.05)] {
        let angles = |times: f64| points.iter().map(move |&[at, value]| [at.to_degrees(), times * value]);
        let lengths = |times: f64| points.iter().map(move |&[at, value]| [times * radius * at.sin(), value]);
        assert_eq!(verdict(ROD, ["angle_deg", column], 1e-2, angles(1.0)), Verdict::Pass, "{column}");
        assert_eq!(verdict(ROD, ["angle_deg", column], 1e-2, angles(1.1)), Verdict::Fail, "{column}");
        assert_eq!(verdict(ROD, ["x_mm", column], 1e-2, lengths(1.0)), Verdict::Pass, "{column}");
        assert_eq!(verdict(ROD, ["x_mm", column], 1e-2, lengths(0.7)), Verdict::Fail, "{column}");
    }
}
