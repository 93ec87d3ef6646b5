//! What `solve` writes is what was solved, and asking for it changes nothing.

use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::case::library::{PinPlate, TruncatedHertz};
use contact_vv::checkout::root;
use contact_vv::cli::vtu;
use contact_vv::elasticity::shape_functions;
use contact_vv::elasticity::stress::{across, von_mises};
use contact_vv::markdown;
use contact_vv::measure::relative_error;
use contact_vv::mesh::Order;
use contact_vv::scene::{Material, PlaneHypothesis, Scene};
use contact_vv::solve::{Discretisation, Fitted, Formulation, Run};
use vtkio::model::{Attribute, CellType, DataSet, IOBuffer, Piece, UnstructuredGridPiece, VertexNumbers, Vtk};

use crate::balance::solved_as_it_says;
use crate::program::{Folder, ended, program};
use crate::scene_file::{self, text_of};
use crate::workbench::block_text;

pub fn scene(name: &str) -> String {
    format!("{}/tests/cases/{name}.toml", root().display())
}

pub fn contact_vv(arguments: &[&str]) -> (bool, String, String) {
    let (code, text, error) = ended(&mut program(arguments));
    (code == Some(0), text, error)
}

/// Options that name the units of fields.
pub const UNITS: [&str; 8] =
    ["--unit", "position=mm", "--unit", "pressure=MPa", "--unit", "gap=mm", "--unit", "displacement=mm"];

/// That a command does not end well, and says some parts.
pub fn refuses(arguments: &[&str], parts: &[impl AsRef<str>]) {
    let (sound, _, error) = contact_vv(arguments);
    assert!(!sound && parts.iter().all(|part| error.contains(part.as_ref())), "{arguments:?}: {error}");
}

/// What the program prints as JSON.
pub fn json(arguments: &[&str]) -> serde_json::Value {
    let (_, text, error) = contact_vv(&[arguments, &["--json", "-"]].concat());
    serde_json::from_str(&text).unwrap_or_else(|_| panic!("{error}"))
}

/// The one piece of a file of fields.
pub fn piece(text: &str) -> UnstructuredGridPiece {
    let grid = Vtk::parse_xml(text.as_bytes()).expect("read");
    let DataSet::UnstructuredGrid { pieces, .. } = grid.data else { panic!("no grid") };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else { panic!("one piece") };
    *piece
}

/// A field at the points of a piece.
pub fn numbers(piece: &UnstructuredGridPiece, name: &str) -> Vec<f64> {
    let found = piece.data.point.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => array.data.clone().cast_into(),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no `{name}`"))
}

#[test]
fn fields_written_for_paraview_are_those_of_the_solution() {
    for name in ["blocks", "cylinder-on-block", "press-fit", "roller-between-plates"] {
        let (discretisation, run) = solved_as_it_says(&scene_file::case(name));
        let piece = &piece(&vtu::text(&discretisation, &run).expect("written"));

        let mesh = &discretisation.mesh;
        let kind = if mesh.order.nodes_per_cell() == 4 { CellType::Quad } else { CellType::QuadraticQuad };
        assert!(piece.cells.types.iter().all(|cell| *cell == kind) && piece.cells.types.len() == mesh.cells());
        let fields = discretisation.recover(&run.solution).expect("fields");
        let (u, p) = (numbers(piece, "displacement"), numbers(piece, "contact_pressure"));
        let IOBuffer::F64(points) = &piece.points else { panic!("no points") };
        for (node, at) in mesh.points.iter().enumerate() {
            for k in 0..2 {
                assert_eq!(points[3 * node + k].to_bits(), at[k].to_bits());
                assert_eq!(u[3 * node + k].to_bits(), fields.displacement[node][k].to_bits());
            }
        }
        // By the component, and the invariants that do not depend on axes.
        let component = |name: &str| numbers(piece, name);
        let in_plane = ["stress_xx", "stress_yy", "stress_xy"].map(component);
        let [across, equivalent] = ["stress_zz", "von_mises"].map(component);
        let principal = ["principal_1", "principal_2", "principal_3"].map(component);
        for (node, stress) in fields.stress.iter().enumerate() {
            assert!((0..3).all(|k| in_plane[k][node].to_bits() == stress[k].to_bits()));
            let [first, second, third] = [0, 1, 2].map(|k| principal[k][node]);
            assert!(first >= second && second >= third, "{name}: {first}, {second}, {third}");
            let scale = first.abs().max(third.abs());
            let trace = stress[0] + stress[1] + across[node];
            assert_relative_eq!(first + second + third, trace, epsilon = 1e-12 * scale);
            let sum_of_squares = (first - second).powi(2) + (second - third).powi(2) + (third - first).powi(2);
            assert_relative_eq!((0.5 * sum_of_squares).sqrt(), equivalent[node], epsilon = 1e-9 * scale);
        }
        let (gaps, of_contact) = (component("contact_gap"), component("contact"));
        assert!(gaps.iter().zip(&of_contact).all(|(gap, contact)| gap.is_nan() == (*contact < 0.0)), "{name}");
        // With node elements every candidate is a contact point.
        let nodes = run.formulation.name().starts_with("node");
        for (contact, pair) in discretisation.scene.contacts.iter().enumerate().filter(|_| nodes) {
            let part = &mesh.bodies[pair.first];
            let candidates = &part.candidates[part.candidates_of(contact)];
            for point in run.solution.points_of(contact) {
                let near = |node: usize| (pair.path.coordinate(mesh.points[node]) - point.position).abs() < 1e-9;
                let node = candidates.iter().map(|candidate| candidate.node).find(|&node| near(node)).expect("a node");
                assert_relative_eq!(p[node], point.pressure, max_relative = 1e-6, epsilon = 1e-9);
                assert_relative_eq!(
                    numbers(piece, "contact_gap")[node],
                    point.gap,
                    max_relative = 1e-6,
                    epsilon = 1e-9
                );
            }
        }
    }
}

#[test]
fn bodies_whose_names_differ_in_other_characters_alone_have_a_field_each() {
    let mut case = scene_file::case("blocks");
    for (body, name) in case.scene.bodies.iter_mut().zip(["a b", "a-b"]) {
        body.name = name.into();
    }
    let (discretisation, run) = solved_as_it_says(&case);
    let cells = piece(&vtu::text(&discretisation, &run).expect("written")).data.cell;
    let name = |attribute: &Attribute| match attribute {
        Attribute::DataArray(array) => array.name.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(cells.iter().map(name).collect::<Vec<_>>(), ["body", "body_a_b", "body_a_b_1"]);
}

#[test]
fn von_mises_stress_of_plain_states() {
    let steel = Material::STEEL;
    let of = |stress, plane, material: &Material| von_mises(stress, across(stress, plane, material, 0.0));
    let (stress, strain) = (PlaneHypothesis::Stress, PlaneHypothesis::Strain);
    assert_relative_eq!(of([-7.0, 0.0, 0.0], stress, &steel), 7.0);
    assert_relative_eq!(of([0.0, 0.0, 2.0], strain, &steel), 2.0 * 3f64.sqrt());
    assert_relative_eq!(of([5.0, 5.0, 0.0], stress, &steel), 5.0);
    // All sides alike in the plane, σ_z = 2νσ: what is left is (1 − 2ν) σ.
    assert_relative_eq!(of([5.0, 5.0, 0.0], strain, &steel), 5.0 * 0.4, max_relative = 1e-14);
    let loose = Material { poisson: 0.0, ..steel };
    assert_relative_eq!(of([1.0, -3.0, 0.5], strain, &loose), of([1.0, -3.0, 0.5], stress, &loose));
    // A uniform pressure on all sides of a body of revolution: ε_θ = (1 − 2ν) σ/E.
    let hoop = across([-5.0, -5.0, 0.0], PlaneHypothesis::Axisymmetric, &steel, -5.0 * 0.4 / steel.young);
    assert_relative_eq!(hoop, -5.0, max_relative = 1e-14);
    assert!(von_mises([-5.0, -5.0, 0.0], hoop) <= 1e-14 * 5.0);
}

#[test]
fn asking_for_outputs_does_not_change_the_run() {
    let folder = Folder::made();
    let file = scene("cylinder-in-metres");
    let plain = contact_vv(&["solve", &file, "--json", "-"]);
    let [csv, vtu, svg] = ["p.csv", "f.vtu", "p.svg"].map(|name| folder.at(name));
    let all = contact_vv(&["solve", &file, "--json", "-", "--csv", &csv, "--vtu", &vtu, "--plot", &svg]);
    assert!(plain.0 && all.0, "{}", all.2);
    let without_seconds = |text: &str| {
        let mut document: serde_json::Value = serde_json::from_str(text).expect("JSON");
        document["seconds"] = serde_json::Value::Null;
        document
    };
    let document = without_seconds(&plain.1);
    assert_eq!(document, without_seconds(&all.1));
    let mut rows = csv::Reader::from_path(&csv).expect("a table");
    let profile = document["contacts"][0]["profile"].as_array().expect("a profile");
    assert_eq!(rows.headers().expect("a head").get(0), Some("position [mm]"));
    for (row, point) in rows.deserialize::<(f64, f64, f64, f64, String)>().zip(profile) {
        let (position, pressure, gap, area, contact) = row.expect("numbers and a name");
        let same = |key: &str, value: f64| point[key].as_f64().is_some_and(|own| own.to_bits() == value.to_bits());
        assert!(same("position", position) && same("pressure", pressure) && same("gap", gap) && same("area", area));
        assert_eq!(Some(contact.as_str()), document["contacts"][0]["name"].as_str());
    }
    assert_eq!(csv::Reader::from_path(&csv).expect("a table").records().count(), profile.len());
}

#[test]
fn options_change_what_the_file_says_and_only_that() {
    let file = scene("cylinder-in-metres");
    // What the file checks may fail on a mesh that it was not written for.
    let solve = |options: &[&str]| json(&[&["solve", &file], options].concat());
    let own = solve(&[]);
    assert_eq!((own["element"].as_str(), own["algorithm"].as_str()), (Some("node"), Some("constant")));
    let other = solve(&["--element", "layer", "--algorithm", "kinematic", "--resolution", "6", "--order", "1"]);
    assert_eq!((other["element"].as_str(), other["algorithm"].as_str()), (Some("layer"), Some("kinematic")));
    assert_eq!((other["resolution"].as_u64(), other["order"].as_u64()), (Some(6), Some(1)));
}

#[test]
fn a_folder_is_verified_file_by_file_and_fails_with_its_worst() {
    let folder = Folder::made();
    let verify = || contact_vv(&["verify", &folder.at("")]);
    let (sound, _, error) = verify();
    assert!(!sound && error.contains("no scene file is in it"), "{error}");
    let text = text_of("blocks.toml");
    folder.with("a.toml", &text);
    let (sound, table, error) = verify();
    assert!(sound && table.contains("2 passed") && !table.contains("FAILED"), "{table}{error}");
    folder.with("b.toml", text.replace("value = 4000", "value = 4100"));
    let (sound, table, _) = verify();
    assert!(!sound && table.contains("1 of 2 FAILED"), "{table}");
    assert!(table.contains("contact resultant [N] is 4000"), "{table}");
    let (sound, lines, error) = contact_vv(&["verify", &folder.at(""), "--json"]);
    let lines: Vec<serde_json::Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let failed: Vec<_> = lines.iter().filter(|line| line["verdict"] == "fail").collect();
    assert!(!sound && failed.len() == 1 && failed[0]["quantity"] == "contact resultant [N]", "{lines:?}{error}");
    folder.with("b.toml", text.replace("young = 70e3", "young = 0"));
    let (sound, table, error) = verify();
    assert!(!sound && table.contains("1 of 2 files not solved") && !table.contains("FAILED"), "{table}");
    assert!(error.contains("b.toml:16") && error.contains("above 0"), "{error}");
    let (sound, lines, _) = contact_vv(&["verify", &folder.at(""), "--json"]);
    let last = lines.lines().last().expect("a line");
    assert!(!sound && last.contains("b.toml") && last.contains("\"fail\"") && last.contains("above 0"), "{lines}");
    // A table without rows is not printed: of files that are not solved, and of one that has no checks of its own.
    std::fs::remove_file(folder.path().join("a.toml")).expect("removed");
    let (_, table, _) = verify();
    assert_eq!(table.trim(), "1 of 1 files not solved");
    folder.with("b.toml", text.split("[[check]]").next().expect("a part"));
    let (sound, table, error) = verify();
    assert!(sound && table.contains("none") && !table.contains("error bar"), "{table}{error}");
}

#[test]
fn table_of_checks_has_the_reference_beside_the_value() {
    let file = scene("flat-punch");
    let (_, table, _) = contact_vv(&["verify", &file]);
    let lines = contact_vv(&["verify", &file, "--json"]).1;
    let own = lines.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).expect("JSON"));
    for check in own.filter(|check| check["scope"] == "own") {
        let [value, reference] =
            ["value", "reference"].map(|key| markdown::value(check[key].as_f64().expect("a number")));
        assert!(value != reference && table.contains(&reference), "{reference}: {table}");
    }
}

#[test]
fn points_that_overlap_have_gaps_below_zero_in_the_table() {
    let folder = Folder::made();
    let csv = folder.at("p.csv");
    let penalty = ["--rule", "penalty", "--stiffness", "100", "--no-error-bar", "--csv", &csv];
    assert!(contact_vv(&[&["solve", "truncated-hertz"][..], &penalty].concat()).0);
    let rows = csv::Reader::from_path(&csv).expect("a table").into_deserialize::<(f64, f64, f64, f64, String)>();
    for (position, pressure, gap, ..) in rows.map(|row| row.expect("numbers and a name")) {
        assert!((gap < 0.0) == (pressure > 0.0), "{position}: {gap}, {pressure}");
    }
}

#[test]
fn growth_of_an_accuracy_is_along_the_contact_then_into_the_depth() {
    let grading = scene_file::case("rings-to-accuracy").scene.grading;
    let document = json(&["solve", &scene("rings-to-accuracy"), "--no-error-bar"]);
    assert!(grading.along > grading.depth, "{grading:?}");
    assert_eq!(document["accuracy"]["growth"], serde_json::json!([grading.along, grading.depth]));
}

#[test]
fn largest_point_is_told_where_its_pressure_is() {
    let arguments = ["solve", "cylinder", "--element", "line", "--no-error-bar"];
    let contact = &json(&arguments)["contacts"][0];
    let profile = contact["profile"].as_array().expect("points");
    let number = |of: &serde_json::Value, key: &str| of[key].as_f64().expect("a number");
    let top = profile.iter().max_by(|a, b| number(a, "pressure").total_cmp(&number(b, "pressure"))).expect("points");
    let [place, pressure] = ["position", "pressure"].map(|key| number(top, key));
    assert!(place > 0.0 && (place - number(contact, "largest_point_position")).abs() <= 0.0, "{place}");
    let (_, table, _) = contact_vv(&["solve", "cylinder", "--element", "line", "--all"]);
    let told =
        format!("largest pressure of a point {} MPa at {} mm", markdown::value(pressure), markdown::value(place));
    assert!(table.contains(&told), "{told}: {table}");
}

#[test]
fn reaction_that_is_small_beside_the_load_is_told() {
    let folder = Folder::made();
    let load = "traction = { at = \"far\", value = [0.01, -100] }";
    let contact = "gap = { uniform = 0 }\nstretch = 20\n[mesh]\nelements = 4\nper = 20";
    let text = block_text([0.0, 20.0], 20.0, load, contact);
    let (_, table, error) = contact_vv(&["solve", &folder.with("s.toml", text), "--all"]);
    let told = table.lines().find(|line| line.starts_with("reaction on `block` at left: x "));
    assert!(told.is_some_and(|line| line.ends_with(" -0.200000 N")), "{table}{error}");
}

#[test]
fn table_tells_the_reactions_the_error_bars_and_the_notes_of_the_document() {
    let folder = Folder::made();
    let doubtful = folder.with("doubtful.toml", crate::scene_oracle::BLOCKS.replace("young = 200000", "young = 200"));
    for (file, noted) in [(scene("blocks"), false), (scene("two-cylinders"), false), (doubtful, true)] {
        let (_, table, _) = contact_vv(&["solve", &file, "--all"]);
        let document = json(&["solve", &file]);
        let list = |of: &serde_json::Value| of.as_array().expect("a list").clone();
        let text =
            |of: &serde_json::Value, key: &str| of[key].as_str().unwrap_or_else(|| panic!("{key}: {of}")).to_string();
        let number = |of: &serde_json::Value, key: &str| of[key].as_f64().unwrap_or_else(|| panic!("{key}: {of}"));
        let begin = |with: &str| table.lines().filter(|line| line.trim_start().starts_with(with)).count();
        let reactions = list(&document["reactions"]);
        assert!(!reactions.is_empty() && begin("reaction on") == reactions.len(), "{table}");
        for one in reactions {
            let [body, at, component] = ["body", "at", "component"].map(|key| text(&one, key));
            let with = format!("reaction on `{body}` at {at}: {component} ");
            let told: Vec<&str> =
                table.lines().filter_map(|line| line.strip_prefix(&with)?.strip_suffix(" N")).collect();
            assert_eq!(told.len(), 1, "{one}: {table}");
            // Six digits; what is round-off beside the forces of the run is told as 0.
            let told: f64 = told[0].parse().expect("a number");
            assert_relative_eq!(told, number(&one, "force"), max_relative = 1e-5, epsilon = 1e-6);
        }
        let bars = list(&document["error_bars"]);
        let peak = bars.iter().find(|bar| bar["quantity"] == "peak-pressure").expect("a peak");
        assert!(number(peak, "bar") > 0.0 && number(peak, "mesh") > 0.0);
        assert_relative_eq!(
            number(peak, "bar"),
            ["mesh", "iteration", "penalty"].map(|part| number(peak, part)).iter().sum()
        );
        // Of the doubtful scene it has no limit, and no value.
        assert_eq!(peak["value"].is_null(), noted, "{peak}");
        assert_eq!(peak["value"], document["contacts"][0]["peak_pressure"]);
        let told = table.lines().filter(|line| line.starts_with(' ') && line.contains(" ± ")).count();
        // A head, and a line each; what has no limit has no bar either.
        let limited = bars.iter().filter(|bar| !bar["value"].is_null()).count();
        assert_eq!(told, 1 + limited, "{table}");
        // Where there is none the document has no such key.
        let notes = document["contacts"][0]["notes"].as_array().cloned().unwrap_or_default();
        assert_eq!(notes.is_empty(), !noted, "{notes:?}");
        let words = table.split_whitespace().collect::<Vec<_>>().join(" ");
        let once =
            |note: &serde_json::Value| words.matches(&format!("note: {}", note.as_str().expect("a text"))).count() == 1;
        assert!(notes.iter().all(once), "{table}");
        assert!(!contact_vv(&["solve", &file, "--all", "--no-error-bar"]).1.contains('±'));
        assert!(json(&["solve", &file, "--no-error-bar"])["error_bars"].is_null());
    }
}

#[test]
fn lines_of_a_solve_are_as_exact_as_the_bars() {
    let said = |name: &str| {
        let (well, text, error) = contact_vv(&["solve", name]);
        assert!(well, "{text}{error}");
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    // A closed form is told to the digits of the bar, and what is within that is not off.
    let disc = said(&scene("whole-disc"));
    assert!(disc.contains("half-width: 1.0000 mm, within the bar"), "{disc}");
    let cylinder = said("cylinder");
    assert!(cylinder.contains("half-width: 2.500 mm, within the bar"), "{cylinder}");
    assert!(cylinder.contains("peak pressure: 5769.2 MPa, 0.056 % off"), "{cylinder}");
    // Small numbers have one exponent for value and bar.
    let pin = said(&scene("rigid-pin"));
    let approach = pin.split("approach ").nth(1).expect("told");
    assert!(approach.starts_with("(1.4041") && approach.contains(")e-5 mm"), "{pin}");
    // Places end with their last digit that is not 0.
    assert!(said("flat-punch").contains("pressed at s = 1 mm:"));
}

#[test]
fn bar_of_a_mesh_made_elsewhere_is_unknown() {
    let (_, table, _) = contact_vv(&["solve", &scene("rings-from-gmsh"), "--all"]);
    assert!(table.contains("± unknown") && table.contains("`--accuracy`"), "{table}");
}

/// A small scene, quickly solved.
fn small() -> String {
    let contact = "gap = { uniform = 0 }\nstretch = 10\n[mesh]\nelements = 2\nper = 10\n[solve]\nincrements = 2";
    block_text([0.0, 10.0], 10.0, "traction = { at = \"far\", value = [0, -1] }", contact)
}

/// The program in a folder: its exit code, and what it says of what is wrong.
fn within(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let (code, _, error) = ended(program(arguments).current_dir(folder));
    (code, error)
}

/// What a folder holds, by name.
fn kept(folder: &Path) -> std::collections::BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let files = entries.filter(|entry| entry.path().is_file());
    files
        .map(|entry| (entry.file_name().to_string_lossy().into_owned(), std::fs::read(entry.path()).expect("read")))
        .collect()
}

#[test]
fn no_output_takes_the_place_of_what_is_read_or_of_another_output() {
    let folder = Folder::made();
    folder.with("s.toml", small());
    let folder = folder.path();
    std::fs::write(folder.join("ours.csv"), "position [mm],pressure [MPa]\n0,1\n5,1\n10,1\n").expect("written");
    std::fs::hard_link(folder.join("s.toml"), folder.join("linked.vtu")).expect("linked");
    #[cfg(unix)]
    std::os::unix::fs::symlink("s.toml", folder.join("same.svg")).expect("linked");
    let before = kept(folder);
    let here = folder.join("a").display().to_string();
    let mut all: Vec<Vec<&str>> = vec![
        vec!["solve", "s.toml", "--csv", "s.toml"],
        vec!["solve", "s.toml", "--json", "./s.toml", "--force"],
        vec!["solve", "./s.toml", "--vtu", "linked.vtu", "--force"],
        vec!["solve", "s.toml", "--csv", "a", "--json", "./a"],
        vec!["solve", "s.toml", "--csv", "a", "--json", &here, "--force"],
        vec!["solve", "s.toml", "--csv", "a.csv", "--curve", "a.csv", "--force"],
    ];
    #[cfg(unix)]
    all.push(vec!["solve", "s.toml", "--plot", "same.svg", "--force"]);
    #[cfg(unix)]
    all.push(vec!["judge", "s.toml", "ours.csv", "--plot", "same.svg", "--force"]);
    for arguments in all {
        let (code, error) = within(folder, &arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {error}");
        assert!(error.contains("an output never replaces"), "{arguments:?}: {error}");
        assert_eq!(kept(folder), before, "{arguments:?}");
    }
}

#[test]
fn outputs_replace_earlier_ones_of_their_kind_and_others_by_force_only() {
    let folder = Folder::made();
    folder.with("s.toml", small());
    let folder = folder.path();
    let all = [
        ("--csv", "p.csv"),
        ("--json", "r.json"),
        ("--curve", "c.csv"),
        ("--curve", "c.json"),
        ("--vtu", "f.vtu"),
        ("--plot", "d.svg"),
    ];
    for (option, name) in all {
        let solve =
            |more: &[&str]| within(folder, &[&["solve", "s.toml", "--no-error-bar", option, name], more].concat());
        // A file that nobody wrote yet, an empty one, and what was written there before.
        std::fs::write(folder.join(name), "").expect("written");
        for _ in 0..2 {
            assert_eq!(solve(&[]).0, Some(0), "{option}");
        }
        let written = kept(folder);
        for other in [
            b"my own notes\n".to_vec(),
            small().into(),
            vec![0xff, 0x00],
            br#"[{"load_factor": 1}, {"mine": 2}]"#.to_vec(),
            [&written[name][..], b"\nmine, and more\n"].concat(),
        ] {
            // Words behind a drawing or fields are no part of them; those behind a table are a row.
            if other.len() > written[name].len() && ["--vtu"].contains(&option) {
                continue;
            }
            std::fs::write(folder.join(name), &other).expect("written");
            let (code, error) = solve(&[]);
            assert_eq!(code, Some(2), "{option}: {error}");
            assert!(error.contains(name) && error.contains("--force"), "{error}");
            assert_eq!(kept(folder)[name], other, "{option}");
            assert_eq!(solve(&["--force"]).0, Some(0), "{option}");
            assert_ne!(kept(folder)[name], other, "{option}");
        }
    }
    #[cfg(unix)]
    assert_eq!(within(folder, &["solve", "s.toml", "--csv", "/dev/null", "--json", "/dev/null"]).0, Some(0));
}

#[test]
fn an_export_replaces_no_mesh_that_the_scene_reads_and_no_answer_that_was_filled_in() {
    let folder = Folder::made();
    folder.with("s.toml", small());
    let folder = folder.path();
    // The same files once more are no loss; none of them stays behind where one of them would be.
    for _ in 0..2 {
        assert_eq!(within(folder, &["export", "s.toml", "e"]).0, Some(0));
    }
    let exported = kept(&folder.join("e"));
    std::fs::copy(folder.join("e/ours.json"), folder.join("e/answer.json")).expect("filled in");
    std::fs::remove_file(folder.join("e/s.md")).expect("removed");
    let filled_in = kept(&folder.join("e"));
    let (code, error) = within(folder, &["export", "s.toml", "e"]);
    assert_eq!(code, Some(2), "{error}");
    assert!(error.contains("answer.json") && error.contains("--force") && !error.contains("ours.json"), "{error}");
    assert_eq!(kept(&folder.join("e")), filled_in);
    assert_eq!(within(folder, &["export", "s.toml", "e", "--force"]).0, Some(0));
    assert_eq!(kept(&folder.join("e")), exported);
    // A scene beside its mesh, which has the name that the exported one would have.
    let mesh = std::fs::read_to_string(folder.join("e/s.msh")).expect("read");
    let given = small().replace("elements = 2\nper = 10\n", "").replace("at = \"left\"", "at = \"block left\"");
    let given = given.replace("at = \"far\"", "at = \"block far\"").replace(
        "rectangle = { x = [0, 10], y = [0, 10], contact = \"bottom\" }",
        "gmsh = { file = \"s.msh\", group = \"block\", contact = \"block contact\" }",
    );
    std::fs::create_dir(folder.join("g")).expect("made");
    std::fs::write(folder.join("g/s.toml"), given).expect("written");
    std::fs::write(folder.join("g/s.msh"), &mesh).expect("written");
    for force in [&[][..], &["--force"]] {
        let (code, error) = within(folder, &[&["export", "g/s.toml", "g"], force].concat());
        assert_eq!(code, Some(2), "{error}");
        assert!(error.contains("s.msh") && error.contains("never replaces an input"), "{error}");
        assert_eq!(kept(&folder.join("g")).len(), 2);
        assert_eq!(kept(&folder.join("g"))["s.msh"], mesh.as_bytes());
    }
}

/// Lattice places of the nodes of VTK's Lagrange quadrilateral: corners around, then the sides, each along its axis,
/// then the inside row by row (vtkHigherOrderQuadrilateral::PointIndexFromIJK).
fn place(m: usize, [i, j]: [usize; 2]) -> usize {
    let inner = m - 1;
    match ([i, j].map(|k| k == 0 || k == m), [i, j]) {
        ([true, true], _) => [[0, 3], [1, 2]][usize::from(i == m)][usize::from(j == m)],
        ([false, true], _) => 4 + (i - 1) + if j == m { 2 * inner } else { 0 },
        ([true, false], _) => 4 + (j - 1) + if i == m { inner } else { 3 * inner },
        ([false, false], _) => 4 + 4 * inner + (i - 1) + inner * (j - 1),
    }
}

/// Polynomials through even positions from −1 to 1.
fn even(m: usize, x: f64) -> Vec<f64> {
    let at = |k: usize| 2.0 * k as f64 / m as f64 - 1.0;
    let others = |a: usize| (0..=m).filter(move |&k| k != a);
    (0..=m).map(|a| others(a).map(|k| (x - at(k)) / (at(a) - at(k))).product()).collect()
}

/// The value that VTK interpolates in a cell of the file.
fn read(nodes: &[u64], m: usize, values: &[f64], stride: usize, [x, y]: [f64; 2]) -> f64 {
    let (along, up) = (even(m, x), even(m, y));
    let all = (0..=m).flat_map(|j| (0..=m).map(move |i| [i, j]));
    all.map(|[i, j]| along[i] * up[j] * values[stride * nodes[place(m, [i, j])] as usize]).sum()
}

fn scenes() -> Vec<(Scene, Fitted)> {
    let block = |order| (TruncatedHertz::default().scene(), Fitted { order, layers: 1 });
    let pin = |order| (PinPlate::of_half_angle(60.0).scene(), Fitted { order, layers: 1 });
    vec![block(Order::Quartic), block(Order::Octic), pin(Order::Quintic), pin(Order::Septic)]
}

#[test]
fn fields_of_high_order_are_read_as_the_polynomials_that_were_solved() {
    for (scene, fitted) in scenes() {
        let answer = fitted.solve(&scene, &Formulation::verification()).expect("answer");
        let (discretisation, run): (Discretisation, Run) = (answer.discretisation, answer.run);
        let piece = piece(&vtu::text(&discretisation, &run).expect("written"));
        let (mesh, case) = (&discretisation.mesh, format!("{} {:?}", scene.name, fitted.order));
        let m = mesh.order.intervals();
        assert!(piece.cells.types.iter().all(|kind| *kind == CellType::LagrangeQuadrilateral), "{case}");
        let VertexNumbers::XML { connectivity, .. } = &piece.cells.cell_verts else { panic!("cells") };
        let IOBuffer::F64(points) = &piece.points else { panic!("points") };
        let fields = discretisation.recover(&run.solution).expect("fields");
        let (moved, stress) = (numbers(&piece, "displacement"), numbers(&piece, "stress_yy"));
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let scales = [largest(points), largest(&moved), largest(&stress)];
        for (cell, nodes) in connectivity.chunks((m + 1) * (m + 1)).enumerate() {
            for at in [[0.3, -0.7], [-0.95, 0.1], [1.0, 0.4]] {
                let shapes = shape_functions::cell(nodes.len(), at);
                let own = |of: &dyn Fn(usize) -> f64| -> f64 {
                    mesh.cell(cell).iter().zip(&shapes).map(|(&node, (shape, _))| shape * of(node)).sum()
                };
                // Nodes that two cells share have the mean of both stresses in ours as in the file.
                let pairs = [
                    (own(&|node| mesh.points[node][0]), read(nodes, m, points, 3, at)),
                    (own(&|node| fields.displacement[node][0]), read(nodes, m, &moved, 3, at)),
                    (own(&|node| fields.stress[node][1]), read(nodes, m, &stress, 1, at)),
                ];
                for ((ours, theirs), scale) in pairs.into_iter().zip(scales) {
                    assert!((ours - theirs).abs() <= 1e-9 * scale, "{case}, cell {cell}: {ours} is read as {theirs}");
                }
            }
        }
        let pressed = largest(&numbers(&piece, "contact_pressure"));
        let peak = run.solution.points.iter().fold(0.0_f64, |most, point| most.max(point.pressure));
        assert!(relative_error(pressed, peak) <= 2e-2, "{case}: {pressed} of {peak}");
    }
}
