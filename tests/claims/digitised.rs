//! Digitised curves: admitted whole or refused by the name of what is missing; held against ours, what agrees passes
//! and what does not turns red, whatever the quantity and its unit. So are readings of a photograph.

use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use approx::assert_relative_eq;
use contact_vv::case::library::PinRod;
use contact_vv::case::{Judged, Verdict};
use contact_vv::checkout::root;
use contact_vv::error::{Error, Kind};
use contact_vv::mesh::Order;
use contact_vv::oracle::ReferenceKind;
use contact_vv::oracle::analytic::persson::PinInHole;
use contact_vv::oracle::digitised::fringes::{End, Fringe, file, read};
use contact_vv::oracle::digitised::{
    Abscissa, DigitisedCurve, NOT_AT_HAND, Ordinate, OurPoint, compare, load, model_form, worst,
};
use contact_vv::solve::{Formulation, Run};
use contact_vv::study::measured::photograph::{self, Photograph, judge};
use contact_vv::study::measured::{against, judge_curves};
use contact_vv::uncertainty::COVERAGE;

use crate::program::Folder;
use crate::workbench::{meshed, spoiled};

const FILES: [&str; 3] = ["scene.toml", "provenance.toml", "semi-ellipse.csv"];

fn synthetic() -> PathBuf {
    root().join("tests/data/digitised-synthetic")
}

fn text(file: &str) -> String {
    fs::read_to_string(synthetic().join(file)).expect("the synthetic folder is committed")
}

/// The synthetic folder with one file rewritten, or left out.
fn folder_with(file: &str, content: Option<&str>) -> Folder {
    let folder = Folder::made();
    for name in FILES {
        let content = if name == file { content.map(str::to_owned) } else { Some(text(name)) };
        content.map(|content| folder.with(name, content));
    }
    folder
}

fn refusal(file: &str, content: Option<&str>) -> Error {
    let folder = folder_with(file, content);
    let error = load(folder.path()).expect_err("spoiled folders are refused");
    assert!(error.to_string().contains(file), "does not name {file}: {error}");
    error
}

/// The key or column that a message says is missing.
fn missing(error: &Error) -> &str {
    let key = error.message.split_once(" is missing among ").expect("something is missing").0;
    key.trim_matches('`')
}

/// The key, column or entry that a message refuses, and what was found.
fn refused(error: &Error) -> (&str, &str) {
    let (key, found) = error.message.split_once("` is ").expect("something is refused");
    (key.trim_start_matches('`'), found)
}

/// Each `key = value` line of a TOML file: its number, its full key, its value.
fn entries(file: &str) -> Vec<(usize, String, String)> {
    let mut section = String::new();
    let mut entries = Vec::new();
    for (number, line) in text(file).lines().enumerate() {
        if line.starts_with("[[") {
            section = "curves[0].".to_owned();
        } else if line.starts_with('[') {
            section = format!("{}.", line.trim_matches(['[', ']']));
        } else if let Some((key, value)) = line.split_once(" = ") {
            entries.push((number, format!("{section}{key}"), value.to_owned()));
        }
    }
    entries
}

/// The file with one line replaced.
fn with_line(file: &str, number: usize, replacement: &str) -> String {
    let replaced = |(index, line)| {
        if index == number { replacement.to_owned() } else { String::from(line) }
    };
    let lines: Vec<String> = text(file).lines().enumerate().map(replaced).collect();
    lines.join("\n")
}

fn curve_of(folder: &Path) -> DigitisedCurve {
    load(folder).expect("the folder is complete").expect("curves").remove(0)
}

fn admitted() -> DigitisedCurve {
    curve_of(&synthetic())
}

/// The semi-ellipse the synthetic points were made from, moved up by `shift`.
fn semi_ellipse(shift: f64) -> impl Fn(f64) -> OurPoint {
    move |phi| OurPoint { value: shift + 100.0 * (1.0 - (phi / (PI / 3.0)).powi(2)).max(0.0).sqrt(), uncertainty: 0.1 }
}

#[test]
fn figures_that_are_not_at_hand_say_so() {
    for source in ["gaertner-1977", "ghosh-1982"] {
        let folder = root().join("oracles/digitised").join(source);

        let digitised = load(&folder).expect("a README alone is no error");

        assert_eq!(digitised, Err(NOT_AT_HAND));
    }
}

#[test]
fn what_is_missing_broken_or_of_another_scene_is_refused_by_its_file() {
    for file in FILES {
        assert!(refusal(file, None).kind == Kind::MissingFile, "{file}");
    }
    let error = load(Path::new("no/such/folder")).expect_err("no folder, which is not an absence");
    assert!(error.to_string().contains("no/such/folder"), "{error}");
    for (columns, what) in [
        ("force_n,force_error_n,half_angle_deg,half_angle_error_deg", "HalfAngle over Force"),
        ("angle_deg,angle_error_deg,half_angle_deg,half_angle_error_deg", "HalfAngle over Angle"),
        ("force_n,force_error_n,pressure_mpa,pressure_error_mpa", "Pressure over Force"),
    ] {
        let error = refusal("semi-ellipse.csv", Some(&format!("{columns}\n1,0.1,30,1\n")));
        assert!(error.to_string().contains(what), "{error}");
    }
    let whole = text("provenance.toml");
    let (head, _) = whole.split_once("[[curves]]").expect("the synthetic provenance lists a curve");
    assert_eq!(missing(&refusal("provenance.toml", Some(head))), "curves");
    let header = "angle_deg,angle_error_deg,pressure_mpa,pressure_error_mpa\n";
    for curve in [header, "", &format!("{header}1,2\n")] {
        refusal("semi-ellipse.csv", Some(curve));
    }
    refusal("scene.toml", Some("pin_radius = "));
    refusal("provenance.toml", Some("curves = [\"semi-ellipse.csv\"]"));
    // A file that the provenance does not list.
    let folder = folder_with("", None);
    folder.with("stray.csv", text("semi-ellipse.csv"));
    let error = load(folder.path()).expect_err("an unlisted file is refused");
    assert!(error.to_string().contains("stray.csv"), "{error}");
}

#[test]
fn complete_folder_is_admitted_with_its_scene_and_provenance() {
    let curve = admitted();

    assert!(curve.provenance["figure"].contains("synthetic"));
    assert_eq!(curve.kind(), ReferenceKind::Measured);
    let fem = folder_with("provenance.toml", Some(&text("provenance.toml").replace("\"measured\"", "\"fem\"")));
    assert_eq!(curve_of(fem.path()).kind(), ReferenceKind::CrossCode);
    assert_eq!((curve.abscissa, curve.ordinate), (Abscissa::Angle, Ordinate::Pressure));
    assert_eq!(curve.points.len(), 6);
    assert!(!curve.scene.is_sheet);
    assert_relative_eq!(curve.scene.number("pin_radius"), 10.0);
    assert_relative_eq!(curve.scene.material("rod").young, 70_000.0);
    assert_relative_eq!(curve.points[5].abscissa, 50.0_f64.to_radians(), max_relative = 1e-14);
    assert_relative_eq!(curve.points[5].abscissa_error, 0.5_f64.to_radians(), max_relative = 1e-14);
}

#[test]
fn every_key_that_is_missing_or_out_of_range_is_named_and_shown() {
    for (file, wrong) in [("scene.toml", &["nan", "-1.5", "inf", "\"ten\""][..]), ("provenance.toml", &["\" \"", "7"])]
    {
        let entries = entries(file);
        assert!(entries.len() >= 8, "{file} has lost entries");
        for (number, path, _) in entries {
            let error = refusal(file, Some(&with_line(file, number, "")));
            assert_eq!(missing(&error), path, "{file} without {path}: {error}");
            assert!(error.remedy.starts_with("add it: "), "{path}: {error}");
            let key = path.rsplit_once('.').map_or(path.as_str(), |(_, key)| key);
            for value in wrong {
                let line = format!("{key} = {value}");
                let error = refusal(file, Some(&with_line(file, number, &line)));
                let (key, found) = refused(&error);
                assert_eq!((key, &found.to_lowercase()[..]), (&path[..], *value), "{file} with {line}: {error}");
            }
        }
    }
}

#[test]
fn what_is_unknown_or_contradicts_itself_is_refused_by_key_or_by_line_and_column() {
    let (csv, row) = ("semi-ellipse.csv", "10,0.5,98.6,1.0");
    for (file, was, is, named) in [
        ("scene.toml", "thickness", "radius = 3.0\nthickness", "radius"),
        ("scene.toml", "[rod]", "[rod]\nshear = 3.0", "rod.shear"),
        ("scene.toml", "eye_outer_radius = 20.0", "eye_outer_radius = 10.0", "eye_outer_radius"),
        ("scene.toml", "shank_end = 60.0", "shank_end = 15.0", "shank_end"),
        ("provenance.toml", "\"measured\"", "\"guessed\"", "curves[0].kind"),
        ("provenance.toml", "\"first hand\"", "\"hearsay\"", "curves[0].hand"),
        (csv, row, "nan,0.5,98.6,1.0", "angle_deg in line 3"),
        (csv, row, "10,0,98.6,1.0", "angle_error_deg in line 3"),
        (csv, row, "10,0.5,,1.0", "pressure_mpa in line 3"),
        (csv, row, "10,0.5,98.6,-1.0", "pressure_error_mpa in line 3"),
        (csv, row, "10,0.5,98.6,inf", "pressure_error_mpa in line 3"),
    ] {
        let error = refusal(file, Some(&text(file).replace(was, is)));
        assert_eq!(refused(&error).0, named, "{is}: {error}");
    }
    let remarked = text(csv).replace("pressure_error_mpa", "pressure_error_mpa,remark").replace(",1.0\n", ",1.0,x\n");
    assert_eq!(refused(&refusal(csv, Some(&remarked))).0, "remark");
}

#[test]
fn every_missing_column_is_named() {
    let csv = text("semi-ellipse.csv");
    let names: Vec<&str> = csv.lines().next().expect("a header").split(',').collect();
    for (dropped, name) in names.iter().enumerate() {
        let rows: Vec<String> = csv
            .lines()
            .map(|line| {
                let kept = line.split(',').enumerate().filter(|(place, _)| *place != dropped);
                kept.map(|(_, entry)| entry).collect::<Vec<_>>().join(",")
            })
            .collect();
        let error = refusal("semi-ellipse.csv", Some(&rows.join("\n")));
        assert!(missing(&error).contains(name), "without {name}: {error}");
    }
}

#[test]
fn curve_the_points_were_made_from_is_accepted_and_one_shifted_by_three_uncertainties_is_not() {
    let curve = admitted();
    let sound = compare(&curve, &semi_ellipse(0.0));
    assert!(worst(&sound) <= COVERAGE, "{sound:?}");
    for point in sound {
        for shift in [-3.0, 3.0].map(|times| times * point.uncertainty) {
            assert!(worst(&compare(&curve, &semi_ellipse(shift))) > COVERAGE, "shifted by {shift}");
        }
    }
    assert!(worst(&[]).is_nan(), "without points");
}

#[test]
fn nan_or_unbounded_uncertainty_at_one_point_is_not_accepted() {
    let curve = admitted();
    let last = curve.points[5].abscissa;
    for (value, uncertainty) in [(f64::NAN, 0.1), (55.3, f64::NAN), (55.3, f64::INFINITY), (f64::INFINITY, 0.1)] {
        let ours = |phi: f64| {
            let spoiled = OurPoint { value, uncertainty };
            if (phi - last).abs() < 1e-9 { spoiled } else { semi_ellipse(0.0)(phi) }
        };

        let worst = worst(&compare(&curve, &ours));

        assert!(worst.is_nan() || worst > COVERAGE, "{value} ± {uncertainty}: {worst}");
    }
}

#[test]
fn error_of_the_abscissa_counts_through_the_slope_of_our_curve() {
    let curve = admitted();
    let slope = 400.0;
    let ours = |phi: f64| OurPoint { value: slope * phi, uncertainty: 2.0 };

    let comparison = compare(&curve, &ours);

    let across = slope * 0.5_f64.to_radians();
    let expected = (across.powi(2) + 1.0 + 4.0).sqrt();
    for (deviation, point) in comparison.iter().zip(&curve.points) {
        assert_relative_eq!(deviation.uncertainty, expected, max_relative = 1e-10);
        let ratio = (slope * point.abscissa - point.ordinate).abs() / expected;
        assert_relative_eq!(deviation.ratio(), ratio, max_relative = 1e-10);
    }
}

#[test]
fn friction_of_the_source_is_stated_as_a_difference_of_model() {
    let mut curve = admitted();

    assert!(model_form(&curve).is_some_and(|statement| statement.contains("0.15")));
    curve.scene.numbers.insert("friction", 0.0);
    assert_eq!(model_form(&curve), None);
}

const ROD: &str = "pin_radius = 10.0\nclearance = 0.05\neye_outer_radius = 20.0\nshank_width = 20.0\nshank_end = 60.0\n\
    thickness = 1.0\nforce = 2000.0\nfriction = 0.0\n[pin]\nyoung = 210e3\npoisson = 0.3\n[rod]\nyoung = \
    210e3\npoisson = 0.3\n";
const SHEET: &str = "pin_radius = 10.0\nclearance = 0.01\nrim_radius = 5000.0\nthickness = 1.0\nfriction = 0.0\n\
    [pin]\nyoung = 210e3\npoisson = 0.3\n[sheet]\nyoung = 210e3\npoisson = 0.3\n";
const PROVENANCE: &str = "citation = \"synthetic\"\ndigitised_by = \"nobody\"\nmethod = \"computed\"\n[[curves]]\nfile \
    = \"curve.csv\"\n\
    figure = \"none\"\naxis_calibration = \"none\"\nkind = \"measured\"\nhand = \"first hand\"\n";

/// The verdict on a curve of two quantities: columns, relative errors of both, points.
fn verdict(scene: &str, columns: [&str; 2], error: f64, points: impl IntoIterator<Item = [f64; 2]>) -> Verdict {
    judged(scene, columns, error, points).verdict
}

/// The same with the difference, over what both may be off.
fn judged(scene: &str, [across, up]: [&str; 2], error: f64, points: impl IntoIterator<Item = [f64; 2]>) -> Judged {
    let named = |column: &str| column.rsplit_once('_').map(|(name, unit)| format!("{name}_{unit},{name}_error_{unit}"));
    let mut csv = format!("{},{}\n", named(across).expect("a unit"), named(up).expect("a unit"));
    for [x, y] in points {
        let _ = writeln!(csv, "{x},{},{y},{}", 1e-6 * (x.abs() + 1.0), error * (y.abs() + 1e-3));
    }
    let folder = Folder::made();
    for (name, text) in [("scene.toml", scene), ("provenance.toml", PROVENANCE), ("curve.csv", &csv)] {
        folder.with(name, text);
    }
    let found = against(folder.path()).expect("a complete folder");
    assert!(found.as_ref().is_ok_and(|curves| curves.len() == 1));
    judge_curves("synthetic", &found).remove(0)
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
    // Ours are those of the fine mesh, which leaves a third of what it differs from the coarse one.
    for at in [60.0, 75.0] {
        let apart = judged(SHEET, columns, 1e-6, persson(1.0, &[at])).value;
        assert!(apart <= 0.4, "{at}°: {apart}");
    }
}

#[test]
fn pin_of_a_sheet_has_a_material_of_its_own() {
    let soft = SHEET.replacen("210e3", "70e3", 1);
    assert_eq!(verdict(&soft, ["force_n", "half_angle_deg"], 5e-3, persson(1.0, &[60.0])), Verdict::Fail);
}

#[test]
fn pressures_and_hoop_stresses_agree_over_degrees_and_over_millimetres() {
    let discretisation = meshed(PinRod::default().scene(), 36, Order::Quadratic);
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

/// Which of the checks do not pass.
fn red(photograph: &Photograph) -> Vec<usize> {
    let judged = judge(photograph);
    (0..judged.len()).filter(|&k| judged[k].verdict != Verdict::Pass).collect()
}

#[test]
fn the_photograph_agrees_and_every_spoiled_number_turns_red() {
    let sound = photograph::compare(&read(&file()).expect("fringes")).expect("compared");
    assert_eq!(red(&sound), Vec::<usize>::new());
    // At no width do any constants leave less than those that are fitted there; beside the best width its own leave
    // hardly more.
    let over = sound.widths.iter().map(|[_, own, fitted]| own / fitted);
    let least = over.reduce(f64::min).expect("widths");
    assert!((1.0..1.05).contains(&least), "{least}");
    type Spoil = (usize, fn(&mut Photograph));
    let spoils: [Spoil; 7] = [
        (0, |n| n.ends[0].2 = 0.036),
        (1, |n| n.ends[1].2 = 0.036),
        (1, |n| n.ends[1].2 = f64::NAN),
        (2, |n| n.widths.iter_mut().for_each(|width| width[2] = 0.029)),
        (3, |n| n.widths.retain(|width| width[0] < 0.053)),
        (4, |n| n.mesh[0] = 0.011),
        (4, |n| n.mesh[0] = f64::NAN),
    ];
    for (check, spoil) in spoils {
        let spoiled = spoiled(&sound, spoil);
        assert!(red(&spoiled).contains(&check), "check {check}: {:?}", red(&spoiled));
    }
}

#[test]
fn readings_that_are_moved_turn_red() {
    let fringes = read(&file()).expect("fringes");
    // Each end has a check of its own, the bottom first.
    let moved = |fringe: &mut Fringe| match fringe.end {
        End::Top => fringe.half_spacing *= 1.08,
        End::Bottom => fringe.order = 2.0,
    };
    let moved = spoiled(&fringes, |all: &mut Vec<Fringe>| all.iter_mut().for_each(moved));
    let red = red(&photograph::compare(&moved).expect("compared"));
    assert!(red.contains(&0) && red.contains(&1), "{red:?}");
}

#[test]
fn bad_rows_of_the_file_are_refused_with_their_line() {
    let text = fs::read_to_string(file()).expect("readable");
    let folder = Folder::made();
    let refused = |text: &str| read(folder.with("fringes.csv", text).as_ref()).expect_err("refused").to_string();
    let second = |replace: &[(usize, &str)]| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let mut fields: Vec<&str> = lines[1].split(',').collect();
        replace.iter().for_each(|&(k, to)| fields[k] = to);
        lines[1] = fields.join(",");
        lines.join("\n")
    };
    for bad in [(1, "1.5"), (1, "nan"), (3, "0"), (4, "-0.1")] {
        assert!(refused(&second(&[bad])).contains("line 2"), "{bad:?}");
    }
    for bad in [(0, "left"), (2, "X"), (3, "one")] {
        assert!(refused(&second(&[bad])).contains("fringes.csv"), "{bad:?}");
    }
    assert!(refused(text.lines().next().expect("a header")).contains("no fringe"));
    assert!(read(&folder.path().join("none.csv")).is_err());
}
