//! What other programs read of our outputs: meshio, pyvista and a validator of JSON Schema, each in a process of its
//! own, since they bring a numpy that the oracles cannot use.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use contact_vv::checkout::root;
use libtest_mimic::{Failed, Trial};
use serde_json::Value;

/// The trials.
pub fn trials() -> Vec<Trial> {
    vec![
        Trial::test("fields are read by meshio and pyvista under names that a calculator takes", fields),
        Trial::test("all that is printed as JSON is of the published schema", documents),
        Trial::test("reference values are of their schema", references),
        Trial::test("condensed matrices are read by numpy, with a solution of their problem", condensed),
    ]
}

/// A scene file.
fn scene(name: &str) -> String {
    format!("{}/tests/cases/{name}.toml", root().display())
}

/// Whether the program ends well, what it prints and what it complains of; a test of the workspace finds it beside its
/// own.
fn contact_vv(arguments: &[&str]) -> (bool, String, String) {
    let program = Path::new(env!("CARGO_BIN_EXE_freeze")).with_file_name("contact-vv");
    let output = Command::new(program).args(arguments).output().expect("`cargo build --release` makes the program");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.success(), text(&output.stdout), text(&output.stderr))
}

/// What a script of `oracles/readers` prints, and whether it ended well.
fn asked(script: &str, file: &Path, input: &str) -> (bool, String, String) {
    let folder = root().join("oracles");
    let mut command = Command::new("/usr/bin/python3");
    command
        .env("PYTHONPATH", folder.join(".python/readers"))
        .arg("-sB")
        .arg(folder.join("readers").join(script))
        .arg(file);
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().expect("Python is there");
    // A script that refuses the first line reads no more of it.
    let _ = child.stdin.take().expect("piped").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("it ends");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.success(), text(&output.stdout), text(&output.stderr))
}

fn written(folder: &Path) -> (PathBuf, Value) {
    let file = folder.join("fields.vtu");
    let path = file.display().to_string();
    let arguments = ["solve", &scene("roller-between-plates"), "--no-error-bar", "--json", "-", "--vtu", &path];
    let (sound, document, error) = contact_vv(&arguments);
    assert!(sound, "{error}");
    (file, serde_json::from_str(&document).expect("JSON"))
}

fn fields() -> Result<(), Failed> {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, solved) = written(folder.path());
    let (sound, text, error) = asked("fields.py", &file, "");
    assert!(sound, "{error}: `bash oracles/setup.sh` installs what reads them");
    let read: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(read["meshio"], read["pyvista"]);
    let profile = solved["contacts"].as_array().expect("contacts").iter().flat_map(|one| one["profile"].as_array());
    let largest = profile.flatten().filter_map(|point| point["pressure"].as_f64()).fold(0.0, f64::max);
    let fields = &read["pyvista"];
    let reached = fields["point"]["contact_pressure"][1].as_f64().expect("a number");
    assert!((reached - largest).abs() <= 1e-6 * largest, "{reached} instead of {largest}");
    // Three bodies, of which each has cells and none has all; two contacts, and nodes of neither.
    for body in ["body_upper", "body_roller", "body_lower"] {
        assert_eq!(fields["cell"][body], serde_json::json!([0.0, 1.0]), "{body}");
    }
    assert_eq!(fields["point"]["contact"], serde_json::json!([-1.0, 1.0]));
    let equivalent = fields["point"]["von_mises"][1].as_f64().expect("a number");
    let off = read["calculated"].as_f64().expect("a number");
    assert!(off <= 1e-9 * equivalent, "{off}");
    Ok(())
}

fn documents() -> Result<(), Failed> {
    let schema = root().join("snapshots/schema.json");
    let printed = |arguments: &[&str]| contact_vv(arguments).1;
    let one_line = |text: String| text.lines().collect::<String>() + "\n";
    let solved = ["cylinder-to-accuracy", "flat-punch", "three-rings", "rings-from-gmsh"];
    let mut documents: String =
        solved.iter().map(|name| one_line(printed(&["solve", &scene(name), "--json", "-"]))).collect();
    let few = ["solve", "cylinder", "--max-iterations", "2", "--json", "-"];
    documents += &one_line(printed(&few));
    documents += &one_line(printed(&["list", "--json"]));
    documents += &printed(&["verify", &scene("press-fit"), &scene("no-such-file"), "--json"]);
    let (sound, number, error) = asked("valid.py", &schema, &documents);
    assert!(sound && number.trim() == documents.lines().count().to_string(), "{number}{error}");
    for wrong in [r#"{"case": "cylinder"}"#, r#"{"trial": 3}"#, "[{}]", &documents.replacen("\"MPa\"", "3", 1)] {
        assert!(!asked("valid.py", &schema, wrong).0, "{}", &wrong[..20.min(wrong.len())]);
    }
    Ok(())
}

fn references() -> Result<(), Failed> {
    let folder = tempfile::tempdir().expect("a folder");
    let schema = folder.path().join("schema.json");
    std::fs::write(&schema, contact_vv(&["schema", "references"]).1)?;
    let values = contact_vv(&["list", "--references"]).1.lines().collect::<String>() + "\n";
    let (sound, _, error) = asked("valid.py", &schema, &values);
    assert!(sound, "{error}");
    assert!(!asked("valid.py", &schema, &values.replacen("\"MPa\"", "3", 1)).0);
    Ok(())
}

fn condensed() -> Result<(), Failed> {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["cylinder", "pin-rod"] {
        let to = folder.path().join(name);
        let (sound, _, error) = contact_vv(&["export", name, &to.display().to_string(), "--condensed"]);
        assert!(sound, "{error}");
        let (sound, violated, error) = asked("condensed.py", &to.join("condensed.npz"), "");
        let violated: f64 = violated.trim().parse().map_err(|_| error)?;
        assert!(sound && violated <= 1e-9, "{name}: {violated}");
    }
    Ok(())
}
