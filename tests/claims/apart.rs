//! The program alone: far from its sources it does all that needs none of them, and says where one is needed.

use std::path::Path;
use std::process::Command;

use contact_vv::case::library::NAMES;
use contact_vv::checkout::{CHECKOUT, root};

use crate::program::{Folder, ended, program};

/// How the program ends in a folder, with its checkout out of reach, and what it says.
fn apart(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let (code, text, error) = ended(program(arguments).current_dir(folder).env(CHECKOUT, folder.join("nowhere")));
    (code, text + &error)
}

#[test]
fn program_without_its_checkout_lists_solves_exports_judges_and_verifies() {
    let folder = Folder::made();
    let well = |arguments: &[&str]| {
        let (code, told) = apart(folder.path(), arguments);
        assert_eq!(code, Some(0), "{arguments:?}: {told}");
        told
    };
    folder.with("mine.toml", well(&["new", "cylinder"]));
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
        assert_eq!(folder.read(&format!("{name}/{name}.md")), committed);
    }
}

#[test]
fn what_needs_the_checkout_says_so() {
    let folder = Folder::made();
    for command in ["report", "verdicts", "atlas", "converged", "met", "coverage", "counted", "timings", "scoreboard"] {
        let (code, told) = apart(folder.path(), &[command]);
        assert!(code == Some(2) && told.contains("checkout"), "{command}: {code:?}, {told}");
    }
}

#[test]
fn what_the_program_is_compiled_from_lies_in_its_package() {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let listed = Command::new(cargo)
        .args(["package", "--list", "--allow-dirty", "--offline", "--package", "contact-vv"])
        .current_dir(root())
        .output()
        .expect("cargo runs");
    let listed = String::from_utf8(listed.stdout).expect("text");
    let packed: Vec<_> = listed.lines().collect();
    assert!(packed.len() > 300, "{listed}");
    let sources = packed.iter().filter(|file| file.ends_with(".rs"));
    let mut included = 0;
    for source in sources {
        let text = std::fs::read_to_string(root().join(source)).expect("readable");
        for part in text.split("include_str!(\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            let file = root().join(source).parent().expect("a folder").join(part).canonicalize().expect("a file");
            let name = file
                .strip_prefix(root().canonicalize().expect("there"))
                .expect("in the checkout")
                .display()
                .to_string();
            assert!(packed.contains(&&*name), "{source} includes {name}");
            included += 1;
        }
    }
    assert!(included > 30, "{included}");
}
