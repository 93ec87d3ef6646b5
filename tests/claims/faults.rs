//! Planted faults: each finds its line, is caught by a truth alone, and says on which sources it was planted.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use contact_vv::case::Verdict;
use contact_vv::checkout::{digest, root};
use contact_vv::error::Error;
use contact_vv::study::faults::{self, Asked, Caught, Fault, Numbers, Planted, is_caught};
use contact_vv::study::faults::{Entry, MADE, Room, Share, together};

fn fault(name: &str, kinds: &[&str]) -> Fault {
    let [name, file, was, is] = [name, "src/lib.rs", "sound", "spoiled"].map(String::from);
    let by = |kind: &&str| Caught { test: "a × b".into(), kind: kind.to_string(), told: String::new(), asked: None };
    Fault {
        planted: Planted { name, file, was, is, within: None },
        entry: Entry { bound: vec![], sources: None, date: None, by: kinds.iter().map(by).collect() },
    }
}

#[test]
fn every_planted_fault_finds_the_line_it_spoils_exactly_once() {
    let faults = faults::record().expect("recorded").record;
    assert!(faults.len() >= 20);
    for Fault { planted: Planted { name, file, was, is, .. }, .. } in faults {
        let text = fs::read_to_string(root().join(&file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let found = text.matches(&was).count();
        assert_eq!(found, 1, "{name}: found {found} times in {file}");
        assert_ne!(was, is);
    }
}

#[test]
fn what_is_listed_as_held_against_a_truth_is_a_claim() {
    let text = fs::read_to_string(root().join("tests/truths.toml")).expect("read");
    let listed: BTreeMap<String, Vec<String>> = toml::from_str(&text).expect("lists of claims by kind");
    for name in listed.values().flatten() {
        let (module, of) = name.split_once("::").expect("a module and a claim");
        let claims = fs::read_to_string(root().join(format!("tests/claims/{module}.rs"))).expect("read");
        assert!(claims.contains(&format!("\nfn {of}(")), "{name}");
    }
}

#[test]
fn folders_count_by_their_mutants_and_those_of_which_none_was_tried_do_not() {
    let room = |mutants, caught, of, interval| {
        let share = || Share { caught, of, interval };
        let [unviable, equivalent] = [0; 2];
        let (room, tried, missed) = ("src/one".into(), Vec::new(), Vec::new());
        Room { room, mutants, tried, unviable, equivalent, by_claims: share(), by_truths: share(), missed }
    };
    let rooms = [room(3000, 1, 2, Some([0.1, 0.8])), room(2000, 10, 10, Some([0.7, 1.0])), room(900, 0, 0, None)];
    // 0.6/2 + 0.4, less √((0.6·0.4)² + (0.4·0.3)²), and 0.6·0.3 more.
    assert_eq!(
        together(&rooms, "src", |room| &room.by_claims),
        "70 % (43 to 88 %; 11 of 12 tried; 1 of 3 folders not tried)"
    );
    // Of a folder within, its own alone.
    let [one, other, _] = rooms;
    let rooms = [one, Room { room: "src/solver/two".into(), ..other }];
    assert_eq!(together(&rooms, "src/solver", |room| &room.by_truths), "100 % (70 to 100 %; 10 of 10 tried)");
}

#[test]
fn a_fault_is_caught_by_a_truth_or_a_claim_and_by_nothing_else() {
    for kind in ["analytic", "cross-code", "self-consistency", "claim"] {
        assert!(is_caught(&fault("planted", &[kind])), "{kind}");
    }
    for kinds in [&[][..], &["broken off"], &["snapshot"]] {
        assert!(!is_caught(&fault("planted", kinds)), "{kinds:?}");
    }
}

/// A folder of sources, some of which are none.
fn sources() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["src/deep/one.rs", "src/deep.rs", "src/é.rs", "src/two.rs", "Cargo.toml"] {
        write(folder.path(), name, name);
    }
    folder
}

fn write(root: &Path, name: &str, text: &str) {
    let path = root.join(name);
    fs::create_dir_all(path.parent().expect("it has a folder")).expect("a folder");
    fs::write(path, text).expect("written");
}

fn digest_of(root: &Path) -> String {
    digest(root, &["src", "Cargo.toml"]).expect("read")
}

#[test]
fn digest_of_sources_changes_with_their_names_and_texts_and_with_nothing_else() {
    let folder = sources();
    let first = digest_of(folder.path());
    assert_eq!(first, digest(folder.path(), &["Cargo.toml", "src/two.rs", "src"]).expect("read"), "whatever the order");
    assert_eq!(first, digest_of(sources().path()), "whatever the folder and the time");
    for left in ["src/.two.rs.swp", "src/__pycache__/two.pyc", "src/deep/target/debug/one", "elsewhere.rs"] {
        write(folder.path(), left, "left behind");
        assert_eq!(first, digest_of(folder.path()), "{left}");
    }
    write(folder.path(), "src/two.rs", "src/two.rs ");
    let edited = digest_of(folder.path());
    write(folder.path(), "src/two.rs", "src/two.rs");
    assert_eq!(first, digest_of(folder.path()));
    fs::rename(folder.path().join("src/two.rs"), folder.path().join("src/three.rs")).expect("renamed");
    let renamed = digest_of(folder.path());
    write(folder.path(), "src/three.rs", "    /// Said of it.\nsrc/two.rs\n// Said of it as well.");
    assert_eq!(renamed, digest_of(folder.path()), "comments of Rust");
    write(folder.path(), "src/three.rs", "let two = 1; // Said beside it.\nsrc/two.rs");
    assert_ne!(renamed, digest_of(folder.path()));
    assert!(first != edited && first != renamed && edited != renamed);
    assert!(digest(folder.path(), &["src", "absent"]).is_err());
}

#[test]
fn digest_is_the_same_in_python() {
    let python = |root: &Path, names: &[&str]| {
        let script = self::root().join("tests/digest.py");
        let run = Command::new("python3").arg(script).args(names).current_dir(root).output().expect("python3 runs");
        String::from_utf8(run.stdout).expect("text").trim().to_owned()
    };
    let folder = sources();
    write(folder.path(), "src/__pycache__/two.pyc", "left behind");
    write(folder.path(), "src/deep/four.rs", "\t//! Said of it.\nfour\r\n   // As well.\n/ no comment\n");
    assert_eq!(python(folder.path(), &["src", "Cargo.toml"]), digest_of(folder.path()));
    let recorded = MADE.iter().flat_map(|made| made.read().expect(made.file).record);
    let names: Vec<String> = recorded.flat_map(|entry| entry.bound).collect();
    let words: Vec<&str> = names.iter().map(String::as_str).collect();
    assert!(names.iter().any(|name| name.contains(": ")));
    assert_eq!(python(&root(), &words), digest(&root(), &names).expect("read"));
}

#[test]
fn digest_of_a_function_changes_with_its_own_text_alone() {
    let folder = sources();
    let of = |text: &str| {
        write(folder.path(), "src/two.rs", text);
        digest(folder.path(), &["src/two.rs: fn own() {"]).expect("read")
    };
    let first = of("fn other() {\n    1;\n}\n\nfn own() {\n    2;\n}\n");
    assert_eq!(first, of("fn own() {\n    2;\n}\nfn other() {\n    3;\n}\n"));
    for changed in ["fn own() {\n    3;\n}\n", "fn own() {\n    2;\n", "fn owned() {\n    2;\n}\n", ""] {
        assert_ne!(first, of(changed), "{changed}");
    }
}

#[test]
fn an_entry_of_other_sources_is_told_with_their_number() {
    let bound = |names: &[&str]| names.iter().map(|name| name.to_string()).collect::<Vec<_>>();
    let of =
        |names: &[&str]| Entry { bound: bound(names), sources: digest(&root(), names).ok(), date: None, by: vec![] };
    let sound = [of(&["Cargo.toml"]), of(&["src/checkout.rs: pub fn root() -> PathBuf {", "tests/cases"])];
    assert_eq!(MADE[0].judge(&sound).verdict, Verdict::Pass);
    let old = Entry { bound: bound(&["Cargo.toml"]), sources: Some("another".into()), date: None, by: vec![] };
    let unbound = Entry { bound: vec![], sources: digest(&root(), &[""; 0]).ok(), date: None, by: vec![] };
    let gone = Entry { bound: bound(&["src/absent.rs"]), sources: None, date: None, by: vec![] };
    let is_not_run = |entries: &[Entry], told: &str| {
        let verdict = MADE[0].judge(entries).verdict;
        matches!(verdict, Verdict::NotRun(why) if why.starts_with(told))
    };
    assert!(is_not_run(&[sound[0].clone(), old], "1 of 2 planted faults are of other sources or tests"));
    assert!(is_not_run(&[unbound, gone], "2 of 2 planted faults are of other sources or tests"));
    assert!(is_not_run(&[], "none is recorded"));
    let on = |day: &str, entry: &Entry| Entry { date: Some(day.into()), ..entry.clone() };
    let both = [on("2026-02-03", &sound[0]), on("2026-01-31", &sound[1])];
    assert_eq!([faults::sources(&[]), faults::sources(&both)], ["–", "✓ oldest 2026-01-31"]);
    let stale = Entry { sources: Some("another".into()), ..sound[0].clone() };
    assert_eq!(faults::sources(&[both[0].clone(), on("2026-01-30", &stale)]), "○ 1 of 2, oldest 2026-01-30");
    assert_eq!(faults::sources(&[both[0].clone(), stale]), "○ 1 of 2, oldest earlier");
}

#[test]
fn every_mutant_that_was_tried_is_told_in_its_folder() {
    let tried: usize = faults::rooms().expect("recorded").iter().map(|room| room.tried.len()).sum();
    assert_eq!(tried, MADE[2].read().expect("recorded").record.len());
}

#[test]
fn an_entry_whose_test_is_no_more_or_is_of_another_kind_is_not_current() {
    let by = |test: &str, kind: &str, asked: Option<[&str; 2]>| {
        let [test, kind, told] = [test, kind, ""].map(String::from);
        let asked = asked.map(|asked| asked.map(String::from)).map(|[case, quantity]| Asked { case, quantity });
        let (bound, by) = (vec!["Cargo.toml".into()], vec![Caught { test, kind, told, asked }]);
        Entry { sources: digest(&root(), &bound).ok(), bound, date: None, by }.is_current()
    };
    let (claim, truth) = ("faults::digest_is_the_same_in_python", "cells::square_rules_integrate_what_they_promise");
    let (trial, case) = ("three-rings.toml × node.kinematic", "three-rings.toml");
    for (test, kind, asked) in [
        (claim, "claim", None),
        (truth, "analytic", None),
        (trial, "analytic", Some([case, "contact pressure"])),
        (trial, "broken off", None),
    ] {
        assert!(by(test, kind, asked), "{test}, {kind}");
    }
    for (test, kind, asked) in [
        ("faults::a_claim_that_was_here", "claim", None),
        ("absent::digest_is_the_same_in_python", "claim", None),
        (claim, "analytic", None),
        (truth, "claim", None),
        (trial, "analytic", None),
        (trial, "self-consistency", Some([case, "recomputed record that is not the recorded one"])),
        (trial, "analytic", Some([case, "moment"])),
        (trial, "analytic", Some([case, "contact"])),
        ("four-rings.toml × node.kinematic", "analytic", Some(["four-rings.toml", "centre of pressure"])),
    ] {
        assert!(!by(test, kind, asked), "{test}, {kind}, {asked:?}");
    }
}

#[test]
fn every_record_of_a_script_says_what_each_entry_is_bound_to() {
    for made in MADE {
        let record = made.read().expect(made.file).record;
        assert!(record.iter().all(|entry| entry.bound.iter().any(|name| name.starts_with("src"))), "{}", made.file);
        let script = made.renew.split('`').nth(1).and_then(|command| command.split(' ').nth(1)).expect("a command");
        assert!(root().join(script).is_file(), "{script}");
    }
}

#[test]
fn a_record_of_another_list_is_refused() {
    let list = "[[fault]]\nname = \"one\"\nfile = \"src/lib.rs\"\nwas = \"sound\"\nis = \"spoiled\"\n";
    let one = serde_json::json!({ "name": "one", "file": "src/lib.rs", "was": "sound", "is": "spoiled", "by": [] });
    let record = |faults: &[&serde_json::Value]| serde_json::json!({ "record": faults }).to_string();
    let parsed = |list: &str, record: &str| -> Result<Numbers, Error> {
        faults::parse((Path::new("faults.toml"), list), (Path::new("faults.json"), record))
    };
    assert_eq!(parsed(list, &record(&[&one])).expect("the same").record.len(), 1);
    for (list, record, told) in [
        (list.replace("spoiled", "spoilt"), record(&[&one]), "another `one`"),
        (list.replace("sound", "whole"), record(&[&one]), "another `one`"),
        (list.repeat(2), record(&[&one]), "but 2 are listed"),
        ("fault = []".into(), record(&[]), "0 faults long"),
        (list.into(), "{}".into(), "record"),
    ] {
        let error = parsed(&list, &record).expect_err(told).to_string();
        assert!(error.contains(told) && error.contains("plant.py"), "{told}: {error}");
    }
}
