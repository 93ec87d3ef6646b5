//! The program alone: far from its sources it does all that needs none of them, and says where one is needed.

use std::path::Path;
use std::process::Command;

use contact_vv::case::library::NAMES;
use contact_vv::checkout::{CHECKOUT, root};

/// How the program ends in a folder, with its checkout out of reach, and what it says.
fn apart(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_contact-vv-tested"));
    let command = command.args(arguments).current_dir(folder).env(CHECKOUT, folder.join("nowhere"));
    let output = command.output().expect("started");
    let told = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (output.status.code(), told)
}

#[test]
fn program_without_its_checkout_lists_solves_exports_judges_and_verifies() {
    let folder = tempfile::tempdir().expect("a folder");
    let well = |arguments: &[&str]| {
        let (code, told) = apart(folder.path(), arguments);
        assert_eq!(code, Some(0), "{arguments:?}: {told}");
        told
    };
    std::fs::write(folder.path().join("mine.toml"), well(&["new", "cylinder"])).expect("written");
    for arguments in [
        &["list"][..],
        &["list", "--references"],
        &["schema"],
        &["schema", "references"],
        &["verify", "mine.toml"],
        &["solve", "mine.toml", "--json", "mine.json", "--csv", "mine.csv", "--vtu", "mine.vtu", "--plot", "mine.svg"],
        &["compare", "cylinder"],
        &["export", "mine.toml", "to-mine", "--condensed"],
        &["judge", "mine.toml", "to-mine/ours.csv"],
    ] {
        well(arguments);
    }
    well(&["export", "bars", "bars"]);
    well(&["judge", "bars", "bars/ours.csv"]);
    for (name, _) in NAMES {
        // Into a folder of its own name, which does not hide the case.
        well(&["export", name, name]);
        let committed = std::fs::read_to_string(root().join(format!("snapshots/sheets/{name}.md"))).expect("a sheet");
        assert_eq!(
            std::fs::read_to_string(folder.path().join(name).join(format!("{name}.md"))).expect("written"),
            committed
        );
    }
}

#[test]
fn what_needs_the_checkout_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    for command in ["report", "verdicts", "atlas", "converged", "met", "coverage", "counted", "timings", "scoreboard"] {
        let (code, told) = apart(folder.path(), &[command]);
        assert!(code == Some(2) && told.contains("checkout"), "{command}: {code:?}, {told}");
    }
}
