//! What `solve` writes is what was solved, and asking for it changes nothing.

use approx::assert_relative_eq;
use contact_vv::case::Case;
use contact_vv::cli::vtu;
use contact_vv::elasticity::stress::von_mises;
use contact_vv::scene::PlaneHypothesis;
use contact_vv::solve::{Discretisation, Run};
use std::path::Path;
use std::process::Command;
use vtkio::model::{Attribute, CellType, DataSet, IOBuffer, Piece, UnstructuredGridPiece, Vtk};

use crate::workbench::block_text;

pub fn scene(name: &str) -> String {
    format!("{}/tests/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

pub fn contact_vv(arguments: &[&str]) -> (bool, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_contact-vv")).args(arguments).output().expect("started");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.success(), text(&output.stdout), text(&output.stderr))
}

/// What the program prints as JSON.
pub fn json(arguments: &[&str]) -> serde_json::Value {
    let (_, text, error) = contact_vv(&[arguments, &["--json", "-"]].concat());
    serde_json::from_str(&text).unwrap_or_else(|_| panic!("{error}"))
}

fn numbers(piece: &UnstructuredGridPiece, name: &str) -> Vec<f64> {
    let found = piece.data.point.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => array.data.clone().cast_into(),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no `{name}`"))
}

#[test]
fn fields_written_for_paraview_are_those_of_the_solution() {
    for name in ["blocks", "cylinder-on-block", "press-fit", "roller-between-plates"] {
        let file = Case::read(Path::new(&scene(name))).expect("sound");
        let discretisation = Discretisation::of(file.scene.clone(), file.resolution).expect("meshed");
        let run = Run::of(&discretisation, file.formulation()).expect("solved");
        let text = vtu::text(&discretisation, &run).expect("written");
        let grid = Vtk::parse_xml(text.as_bytes()).expect("read");
        let DataSet::UnstructuredGrid { pieces, .. } = grid.data else { panic!("no grid") };
        let [Piece::Inline(piece)] = pieces.as_slice() else { panic!("one piece") };

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
fn von_mises_stress_of_plain_states() {
    let (stress, strain) = (PlaneHypothesis::Stress, PlaneHypothesis::Strain);
    assert_relative_eq!(von_mises([-7.0, 0.0, 0.0], stress, 0.3), 7.0);
    assert_relative_eq!(von_mises([0.0, 0.0, 2.0], strain, 0.3), 2.0 * 3f64.sqrt());
    assert_relative_eq!(von_mises([5.0, 5.0, 0.0], stress, 0.3), 5.0);
    // All sides alike in the plane, σ_z = 2νσ: what is left is (1 − 2ν) σ.
    assert_relative_eq!(von_mises([5.0, 5.0, 0.0], strain, 0.3), 5.0 * 0.4, max_relative = 1e-14);
    assert_relative_eq!(von_mises([1.0, -3.0, 0.5], strain, 0.0), von_mises([1.0, -3.0, 0.5], stress, 0.0));
}

#[test]
fn asking_for_outputs_does_not_change_the_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let file = scene("cylinder-in-metres");
    let plain = contact_vv(&["solve", &file, "--json", "-"]);
    let (csv, vtu, svg) = (path("p.csv"), path("f.vtu"), path("p.svg"));
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
fn reactions_are_told_in_the_table_and_in_the_document() {
    let file = scene("blocks");
    let (_, table, _) = contact_vv(&["solve", &file]);
    let document = json(&["solve", &file]);
    let reactions = document["reactions"].as_array().expect("a list");
    let said: Vec<String> = reactions
        .iter()
        .map(|reaction| {
            let text = |key: &str| reaction[key].as_str().expect("a text").to_string();
            let force = reaction["force"].as_f64().expect("a force");
            format!("reaction on `{}` at {}: {} {force:.3}", text("body"), text("at"), text("component"))
        })
        .collect();
    let lines: Vec<&str> = table.lines().filter(|line| line.starts_with("reaction on")).collect();
    assert_eq!((lines.len(), said.len()), (5, 5), "{table}");
    for (line, said) in lines.iter().zip(&said) {
        assert!(line.starts_with(&said[..said.len() - 1]) && line.ends_with(" N"), "{line}: {said}");
    }
    assert!(said[4].starts_with("reaction on `lower` at far: y 2000.000"), "{said:?}");
}

#[test]
fn options_change_what_the_file_says_and_only_that() {
    let file = scene("cylinder-in-metres");
    let solve = |options: &[&str]| -> serde_json::Value {
        // What the file checks may fail on a mesh that it was not written for.
        let (_, text, error) = contact_vv(&[&["solve", &file, "--json", "-"], options].concat());
        serde_json::from_str(&text).unwrap_or_else(|_| panic!("{error}"))
    };
    let own = solve(&[]);
    assert_eq!((own["element"].as_str(), own["algorithm"].as_str()), (Some("node"), Some("constant")));
    let other = solve(&["--element", "layer", "--algorithm", "kinematic", "--resolution", "6", "--order", "1"]);
    assert_eq!((other["element"].as_str(), other["algorithm"].as_str()), (Some("layer"), Some("kinematic")));
    assert_eq!((other["resolution"].as_u64(), other["order"].as_u64()), (Some(6), Some(1)));
    let (sound, _, error) = contact_vv(&["solve", &file, "--a-over-r", "0.1"]);
    assert!(!sound && error.contains("a scene file has no a/R") && error.contains("help: leave it out"), "{error}");
    for option in ["--csv", "--plot", "--vtu"] {
        let (sound, _, error) = contact_vv(&["solve", &file, option, "-"]);
        assert!(!sound && error.contains("this output goes to a file"), "{error}");
    }
    for option in ["--plot", "--vtu"] {
        let (sound, _, error) = contact_vv(&["solve", &file, option, "out.txt"]);
        assert!(!sound && error.contains("end the file name in"), "{error}");
    }
}

#[test]
fn a_folder_is_verified_file_by_file_and_fails_with_its_worst() {
    let folder = tempfile::tempdir().expect("a folder");
    let add = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("written");
    let verify = || contact_vv(&["verify", &folder.path().display().to_string()]);
    let (sound, _, error) = verify();
    assert!(!sound && error.contains("no scene file is in it"), "{error}");
    let text = std::fs::read_to_string(scene("blocks")).expect("text");
    add("a.toml", &text);
    let (sound, table, error) = verify();
    assert!(sound && table.contains("2 passed") && !table.contains("FAILED"), "{table}{error}");
    add("b.toml", &text.replace("value = 4000", "value = 4100"));
    let (sound, table, _) = verify();
    assert!(!sound && table.contains("1 of 2 FAILED"), "{table}");
    assert!(table.contains("contact resultant [N] is 4000"), "{table}");
    let (sound, lines, error) = contact_vv(&["verify", &folder.path().display().to_string(), "--json"]);
    let lines: Vec<serde_json::Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let failed: Vec<_> = lines.iter().filter(|line| line["verdict"] == "fail").collect();
    assert!(!sound && failed.len() == 1 && failed[0]["quantity"] == "contact resultant [N]", "{lines:?}{error}");
    add("b.toml", &text.replace("young = 70e3", "young = 0"));
    let (sound, table, error) = verify();
    assert!(!sound && table.contains("1 of 2 files not solved") && !table.contains("FAILED"), "{table}");
    assert!(error.contains("b.toml:16") && error.contains("above 0"), "{error}");
    let (sound, lines, _) = contact_vv(&["verify", &folder.path().display().to_string(), "--json"]);
    let last = lines.lines().last().expect("a line");
    assert!(!sound && last.contains("b.toml") && last.contains("\"fail\"") && last.contains("above 0"), "{lines}");
}

#[test]
fn run_that_does_not_converge_and_mesh_that_is_too_large_fail() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("few.TOML");
    let text = std::fs::read_to_string(scene("cylinder-in-metres")).expect("text");
    std::fs::write(&path, text.replace("[solve]", "[solve]\nmax-iterations = 2")).expect("written");
    let file = path.display().to_string();
    let (sound, table, error) = contact_vv(&["solve", &file]);
    assert!(!sound && table.contains("not converged") && error.contains("not converged"), "{table}{error}");
    let (sound, _, error) = contact_vv(&["solve", &scene("cylinder-in-metres"), "--resolution", "4096"]);
    assert!(!sound && error.contains("8192 candidate elements"), "{error}");
    let (sound, _, error) = contact_vv(&["solve", &folder.path().display().to_string()]);
    assert!(!sound && error.contains("this is no file"), "{error}");
}

#[test]
fn error_bars_are_told_in_the_table_and_in_the_document_unless_they_are_not_wanted() {
    let file = scene("two-cylinders");
    let (sound, table, error) = contact_vv(&["solve", &file]);
    assert!(sound, "{error}");
    let document = json(&["solve", &file]);
    let bars = document["error_bars"].as_array().expect("a list");
    let peak = bars.iter().find(|bar| bar["quantity"] == "peak-pressure").expect("a peak");
    let number = |key: &str| peak[key].as_f64().expect("a number");
    assert!(number("bound") > 0.0 && number("mesh") > 0.0);
    assert_relative_eq!(number("bound"), number("mesh") + number("iteration") + number("penalty"));
    assert_relative_eq!(number("value"), document["contacts"][0]["peak_pressure"].as_f64().expect("a number"));
    let lines: Vec<&str> = table.lines().filter(|line| line.contains(" ± ") && !line.starts_with("check:")).collect();
    // A head, and a line each.
    assert_eq!(lines.len(), 1 + bars.len(), "{table}");

    let (_, table, _) = contact_vv(&["solve", &file, "--no-error-bar"]);
    assert!(!table.contains('±'), "{table}");
    let document = json(&["solve", &file, "--no-error-bar"]);
    assert!(document["error_bars"].is_null());
}

#[test]
fn bar_of_a_mesh_made_elsewhere_is_unknown() {
    let (_, table, _) = contact_vv(&["solve", &scene("rings-from-gmsh")]);
    assert!(table.contains("± unknown") && table.contains("`--accuracy`"), "{table}");
}

/// A small scene, quickly solved.
fn small() -> String {
    let contact = "gap = { uniform = 0 }\nstretch = 10\n[mesh]\nelements = 2\nper = 10\n[solve]\nincrements = 2";
    block_text([0.0, 10.0], 10.0, "traction = { at = \"far\", value = [0, -1] }", contact)
}

/// The program in a folder: its exit code, and what it says of what is wrong.
fn within(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_contact-vv")).args(arguments).current_dir(folder).output();
    let output = output.expect("started");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
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
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    std::fs::write(folder.join("s.toml"), small()).expect("written");
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
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    std::fs::write(folder.join("s.toml"), small()).expect("written");
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
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    std::fs::write(folder.join("s.toml"), small()).expect("written");
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

#[test]
fn bytes_of_a_solve_bound_a_scene_and_not_the_number_of_its_contacts() {
    let scene = |blocks: usize, elements: usize| {
        let block = |k: usize| {
            let [from, to] = [20 * k, 20 * k + 10];
            format!(
                "[[body]]\nname = \"b{k}\"\nyoung = 1e5\npoisson = 0.3\nshape = {{ rectangle = {{ x = [{from}, {to}], y = [0, 10], contact = \"bottom\" }} }}\nsupports = [{{ at = \"left\", component = \"x\" }}]\nloads = [{{ traction = {{ at = \"far\", value = [0, -1] }} }}]\n[[contact]]\nname = \"c{k}\"\nfirst = \"b{k}\"\norigin = [{from}, 0]\ngap = {{ parabola = 500 }}\nstretch = 5\n"
            )
        };
        let blocks: String = (0..blocks).map(block).collect();
        format!("plane = \"strain\"\nthickness = 1\n{blocks}[mesh]\nelements = {elements}\nper = 1\n")
    };
    let read = |blocks, elements| Case::parse(Path::new("many.toml"), &scene(blocks, elements)).map(|_| ());
    assert!([50, 51, 400].into_iter().all(|blocks| read(blocks, 8).is_ok()));
    // One dense matrix of all dofs, and that of one body.
    for (blocks, elements, told) in
        [(3, 160, "2400 candidate elements in all 3 contacts"), (400, 24, "48000 candidate")]
    {
        let error = read(blocks, elements).expect_err("too many").to_string();
        assert!(
            error.contains(told) && error.contains("bytes") && error.contains("scenes of fewer contacts"),
            "{error}"
        );
    }
}
