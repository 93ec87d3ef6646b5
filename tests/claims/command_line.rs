//! What the user types, and what a terminal, a shell and another program are shown; also without a checkout.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use contact_vv::case::library::NAMES;
use contact_vv::case::{Check, Reference};
use contact_vv::checkout::{CHECKOUT, root};
use contact_vv::cli::{self, suite, writable};
use contact_vv::error::nearest;
use contact_vv::oracle::ReferenceKind;
use contact_vv::study::{Finding, Study, faults};

use crate::outputs::{contact_vv, refuses, scene};
use crate::program::{Folder, ended, program};

/// What the program prints on a terminal of so many columns.
fn on_columns(columns: usize, arguments: &[&str]) -> String {
    ended(program(arguments).env("COLUMNS", columns.to_string())).1
}

fn widest(text: &str) -> usize {
    text.lines().map(|line| line.trim_end().chars().count()).max().unwrap_or(0)
}

#[test]
fn every_command_shows_examples_that_are_understood() {
    let mut examples = 0;
    // Surveys take no arguments that an example could show.
    let surveys = ["atlas", "converged", "met", "coverage", "counted", "timings", "freeze"];
    for (name, command) in commands() {
        let shown = command.get_after_help().map(ToString::to_string).unwrap_or_default();
        assert!(surveys.contains(&name.as_str()) || shown.contains("Examples:\n  contact-vv"), "{name}: {shown}");
        for line in shown.lines().filter_map(|line| line.strip_prefix("  ")) {
            for one in line.split(" && ") {
                let typed = one.split(" > ").next().expect("a command");
                let words = words(typed);
                let parsed = cli::command().try_get_matches_from(&words);
                assert!(parsed.is_ok(), "{name}: {line}: {}", parsed.expect_err("a mistake"));
                let case = words.iter().skip_while(|word| *word != "solve").nth(1);
                let known = |case: &String| NAMES.iter().any(|(name, _)| name == case) || case == "mine.toml";
                assert!(case.is_none_or(|case| known(case) || root().join(case).is_file()), "{line}");
                examples += 1;
            }
        }
    }
    assert!(examples > 20, "{examples}");
}

/// The program and its commands.
fn commands() -> Vec<(String, clap::Command)> {
    let all = cli::command();
    let own = all.get_subcommands().map(|one| (one.get_name().to_string(), one.clone()));
    own.chain([("contact-vv".to_string(), all.clone())]).collect()
}

/// Words of a command, of which those in quotes are one.
fn words(typed: &str) -> Vec<String> {
    let parts = typed.split('"').enumerate();
    parts
        .flat_map(|(k, part)| match k % 2 {
            0 => part.split_whitespace().map(String::from).collect(),
            _ => vec![part.to_string()],
        })
        .collect()
}

#[test]
fn misspelt_names_are_answered_with_the_one_that_was_meant() {
    let (sound, _, error) = contact_vv(&["solve", "cylnder"]);
    assert!(!sound && error.contains("there is no case `cylnder`"), "{error}");
    assert!(error.contains("did you mean `cylinder`?") && error.contains("choose one of"), "{error}");
    for (command, rest) in [("solve", None), ("compare", None), ("export", Some("x")), ("judge", Some("x.csv"))] {
        let (sound, _, error) = contact_vv(&[&[command, "cylnder"], rest.as_slice()].concat());
        assert!(!sound && error.starts_with(&format!("error: {command}: there is no case `cylnder`")), "{error}");
    }
    let (sound, _, error) = contact_vv(&["solve", "zzz"]);
    assert!(!sound && !error.contains("did you mean") && error.contains("choose one of"), "{error}");
    refuses(&["solve", &scene("pres-fit")], &["did you mean", "press-fit.toml`?"]);
    // A link that leads nowhere is not meant, neither by itself nor by its neighbours.
    #[cfg(unix)]
    {
        let folder = Folder::made();
        std::os::unix::fs::symlink("/nowhere/gone.toml", folder.at("scene.toml")).expect("a link");
        refuses(
            &["solve", &folder.at("scene.toml")],
            &["is missing", "it is a link to `/nowhere/gone.toml`: correct it"],
        );
        let (_, _, error) = contact_vv(&["solve", &folder.at("scenes.toml")]);
        assert!(error.contains("is missing") && !error.contains("did you mean"), "{error}");
    }
    for (typed, meant) in [("lst", "list"), ("solv", "solve")] {
        refuses(&[typed], &[&format!("'{meant}'")]);
    }
    let (_, _, error) = contact_vv(&["new", "cilinder"]);
    assert!(error.contains("'cylinder'"), "{error}");
    assert_eq!(nearest("Press-Fitt", ["press-fit", "patch"]), Some("press-fit"));
    assert_eq!(nearest("", ["press-fit"]), None);
}

#[test]
fn cases_are_listed_for_people_and_for_programs_alike() {
    let (sound, told, _) = contact_vv(&["list"]);
    let (also, document, _) = contact_vv(&["list", "--json"]);
    let listed: Vec<serde_json::Value> = serde_json::from_str(&document).expect("JSON");
    assert!(sound && also && listed.len() == NAMES.len() && told.lines().count() == NAMES.len());
    for ((name, title), one) in NAMES.iter().zip(listed) {
        assert_eq!((one["name"].as_str(), one["title"].as_str()), (Some(*name), Some(*title)));
    }
}

#[test]
fn completions_and_manual_pages_name_every_command() {
    let names: Vec<String> = commands().into_iter().map(|(name, _)| name).collect();
    let (sound, script, _) = contact_vv(&["completions", "bash"]);
    assert!(sound && names.iter().all(|name| script.contains(name.as_str())), "{script}");
    let folder = Folder::made();
    let (sound, _, error) = contact_vv(&["man", &folder.at("made/man1")]);
    assert!(sound, "{error}");
    for (name, _) in commands() {
        let file = if name == "contact-vv" { "contact-vv.1".into() } else { format!("contact-vv-{name}.1") };
        assert!(folder.read(&format!("made/man1/{file}")).contains(".SH SYNOPSIS"), "{file}");
    }
}

#[test]
fn what_cannot_be_written_is_refused_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    assert!(writable::file(&at("new.txt"), "").is_ok() && !at("new.txt").exists());
    assert!(writable::folder(&at("not/yet/there"), "").is_ok() && !at("not").exists());
    std::fs::write(at("old.txt"), "kept").expect("written");
    assert!(writable::file(&at("old.txt"), "").is_ok());
    assert_eq!(std::fs::read_to_string(at("old.txt")).expect("read"), "kept");
    for file in [folder.path().to_path_buf(), at("missing/new.txt"), at("old.txt").join("below")] {
        let error = writable::file(&file, "do this").expect_err("it cannot be written");
        assert!(error.to_string().ends_with("; do this"), "{error}");
    }
    let error = writable::folder(&at("old.txt"), "do this").expect_err("it is no folder");
    assert!(
        error.to_string().contains("old.txt` cannot") || error.to_string().contains("cannot be written"),
        "{error}"
    );
    // A file system that nobody writes to, not even root.
    #[cfg(target_os = "linux")]
    assert!(writable::folder(Path::new("/proc"), "").is_err());
}

#[test]
fn output_that_a_full_disk_cuts_is_an_error() {
    // A device that is always full.
    #[cfg(target_os = "linux")]
    for arguments in [&["schema"][..], &["new", "cylinder"], &["list"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
        let (code, _, error) = ended(program(arguments).stdout(full));
        assert!(code == Some(2) && error.contains("standard output"), "{arguments:?}: {error}");
    }
}

/// A checkout with nothing in it but what tells that it is one.
fn bare_checkout() -> Folder {
    let folder = Folder::made();
    std::fs::create_dir_all(folder.path().join("snapshots/charts")).expect("made");
    folder.with("Cargo.toml", "");
    folder.with("snapshots/checks.csv", "");
    folder
}

/// How the program ends in a folder, and what it says there.
fn run_in(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let (code, _, error) = ended(program(arguments).env_remove(CHECKOUT).current_dir(folder));
    (code, error)
}

#[test]
fn reports_and_surveys_outside_of_a_checkout_are_refused_wherever_the_program_was_built() {
    let folder = tempfile::tempdir().expect("a folder");
    for arguments in [
        &["report"][..],
        &["report", "--check"],
        &["report", "--only", "patch"],
        &["report", "diff"],
        &["verdicts"],
        &["atlas"],
        &["converged"],
        &["met", "--lacking"],
        &["coverage"],
        &["counted"],
        &["timings", "--points"],
        &["scoreboard"],
    ] {
        let (code, error) = run_in(folder.path(), arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {error}");
        assert!(error.contains("is a checkout of the project") && error.contains(CHECKOUT), "{arguments:?}: {error}");
        let (code, told) = apart(folder.path(), arguments);
        assert!(code == Some(2) && told.contains("checkout"), "{arguments:?}: {code:?}, {told}");
    }
    let (_, _, named) = ended(program(&["verdicts"]).env(CHECKOUT, folder.path()));
    assert!(named.contains("names this folder"), "{named}");
}

/// Codes that are no package of the system are absent in a checkout that has not installed them; others may be there.
#[test]
fn scoreboard_asks_in_the_checkout_it_runs_in_and_writes_nothing_where_a_code_is_absent() {
    let folder = bare_checkout();
    folder.copied("oracles/peers", "py");
    let frozen = folder.path().join("oracles/frozen/scoreboard");
    std::fs::create_dir_all(&frozen).expect("made");
    let (code, error) = run_in(&folder.path().join("oracles"), &["scoreboard"]);
    assert!(code == Some(2) && error.contains("not all of CalculiX") && error.contains("NGSolve"), "{error}");
    assert_eq!(std::fs::read_dir(&frozen).expect("read").count(), 0);
    assert!(folder.path().join("target/scoreboard").is_dir(), "it is asked where it runs");
}

/// By a Python without any package but its own, and by one as it is installed; no answer is frozen where the scripts
/// are copied to.
#[test]
fn scripts_of_the_oracles_show_how_to_start_them_and_what_they_lack_instead_of_a_traceback() {
    let folder = Folder::made();
    let rooms = std::fs::read_dir(root().join("oracles")).expect("folders").map(|room| room.expect("a folder"));
    let rooms = rooms.filter(|room| room.path().is_dir() && !room.file_name().to_string_lossy().starts_with('.'));
    let copied = rooms.flat_map(|room| folder.copied(&format!("oracles/{}", room.file_name().display()), "py"));
    let scripts: Vec<PathBuf> = copied.collect();
    assert!(scripts.len() > 50, "{scripts:?}");
    let (alone, installed) = ("-EsSB", "-B");
    for script in &scripts {
        for (python, arguments) in [(alone, &[][..]), (installed, &[]), (installed, &["absent", "absent"])] {
            let mut command = Command::new("python3");
            command.arg(python).arg(script).args(arguments).current_dir(folder.path()).stdin(Stdio::null());
            let output = command.output().expect("python3 runs");
            let said = String::from_utf8_lossy(&output.stderr);
            let told = !output.status.success() && ["usage: ", "missing"].iter().any(|word| said.contains(word));
            // `exported.py` ends well and without a word where it has all it needs.
            let silent = python == installed && output.status.success() && said.is_empty();
            assert!((told || silent) && !said.contains("Traceback"), "{python} {script:?} {arguments:?}: {said}");
            // Which is said before anything is imported or read.
            if said.contains("imports this module") {
                break;
            }
        }
    }
}

/// A checkout whose page cannot be written; root may write to any file, but not to a folder of that name.
#[test]
fn read_only_checkout_is_refused_before_the_suite_runs() {
    let folder = bare_checkout();
    std::fs::create_dir_all(folder.path().join("VALIDATION.md")).expect("made");
    let clock = std::time::Instant::now();
    let (code, text, error) = ended(program(&[]).current_dir(folder.path()));
    assert_eq!((code, text.as_str()), (Some(2), ""), "{error}");
    assert!(error.contains("VALIDATION.md") && error.contains("cannot be written"), "{error}");
    assert!(error.contains("report --check") && clock.elapsed().as_secs() < 5, "{error}");
}

#[test]
fn what_did_not_pass_is_told_first_and_passes_are_summed_up() {
    let faults = || faults::Numbers::plan()[0].run().expect("the record of planted faults is read");
    let found = || Finding::of("planted faults", "the record", faults()).expect("judged");
    let judged = |name: &'static str, value: f64| {
        Check::error(name, Reference::own("none", 0.0), 1e-3, "for this test").judge(value)
    };
    let why = "nothing to hold it against, which takes many words to say, so that a line of it would be longer than \
        any terminal";
    let absent = Check::error("a third number", Reference::own("none", 0.0), 1e-3, "for this test");
    let absent = absent.not_run(ReferenceKind::Measured, "none", why.into());
    let mut findings = vec![found(), found()];
    findings[0].judged = vec![judged("a first number", 1e-4), absent];
    findings[1].judged = vec![judged("a second number", 2e-3), judged("a fourth number", f64::NAN)];
    for columns in [72, 120] {
        let text = suite::text(&findings, columns);
        assert!(widest(&text) <= usize::from(columns), "{text}");
        let verdicts: Vec<&str> =
            text.lines().map(str::trim).filter(|line| line.starts_with(['✗', '○', '✓'])).collect();
        let signs: String = verdicts.iter().filter_map(|line| line.chars().next()).collect();
        // Two failures, what was not run, and the one study they all belong to.
        assert_eq!(signs, "✗✗○✗", "{text}");
        assert!(text.ends_with("checks: 1 passed, 2 failed, 1 not run"), "{text}");
        assert!(text.contains("report diff"), "a failure says where to go from it: {text}");
        let whole = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(!whole.contains("first number"), "{text}");
        assert!(whole.contains("Mutants caught by a truth alone: "), "{text}");
    }
    let text = suite::text(&findings[..1], 120);
    let study = text.lines().rfind(|line| line.contains("faults")).expect("a row of the study");
    assert!(study.trim_start().starts_with("○ not run"), "what was not run is no pass: {text}");
}

#[test]
fn tables_are_no_wider_than_the_terminal() {
    let file = scene("press-fit");
    for columns in [72, 100] {
        let table = on_columns(columns, &["verify", &file]);
        assert!(table.contains("passed") && widest(&table) <= columns, "{table}");
    }
}

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
