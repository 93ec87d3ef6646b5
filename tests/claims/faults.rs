//! Planted faults: each finds its line, is caught by a truth alone, and says on which sources it was planted.

use std::fs;
use std::path::Path;
use std::process::Command;

use contact_vv::case::Verdict;
use contact_vv::checkout::{digest, root};
use contact_vv::error::Error;
use contact_vv::study::faults::{self, Fault, Numbers, Planted, is_caught};
use contact_vv::study::present::{Entry, MADE, Record};

fn fault(name: &str, red: &[(&str, usize)], sources: Option<&str>) -> Fault {
    let [name, file, was, is] = [name, "src/lib.rs", "sound", "spoiled"].map(String::from);
    Fault {
        planted: Planted { name, file, was, is },
        sources: sources.map(String::from),
        red: red.iter().map(|(kind, number)| (kind.to_string(), *number)).collect(),
        examples: Default::default(),
        ended: None,
    }
}

#[test]
fn every_planted_fault_finds_the_line_it_spoils_exactly_once() {
    let faults = faults::record().expect("recorded").record;
    assert!(faults.len() >= 20);
    for Fault { planted: Planted { name, file, was, is }, .. } in faults {
        let text = fs::read_to_string(root().join(&file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let found = text.matches(&was).count();
        assert_eq!(found, 1, "{name}: found {found} times in {file}");
        assert_ne!(was, is);
    }
}

#[test]
fn a_fault_is_caught_by_a_truth_and_by_nothing_else() {
    for kind in ["analytic", "cross-code", "self-consistency"] {
        assert!(is_caught(&fault("planted", &[(kind, 1)], None)), "{kind}");
        assert!(!is_caught(&fault("planted", &[(kind, 0)], None)), "{kind}");
    }
    assert!(!is_caught(&fault("planted", &[], None)));
    assert!(!is_caught(&fault("planted", &[("broken off", 9)], None)));
    let endless = Fault { ended: Some("no end within 600 s".into()), ..fault("planted", &[], None) };
    assert!(!is_caught(&endless));
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
    assert_eq!(python(folder.path(), &["src", "Cargo.toml"]), digest_of(folder.path()));
    let recorded = faults::record().expect("recorded").sources;
    let names: Vec<&str> = recorded.iter().map(String::as_str).collect();
    assert_eq!(python(&root(), &names), digest(&root(), &names).expect("read"));
}

#[test]
fn a_record_of_other_sources_is_not_run_and_says_how_many_entries_are() {
    let folder = sources();
    let planted_on = digest_of(folder.path());
    let names = vec!["src".into(), "Cargo.toml".into()];
    let of = |entries: &[Option<&str>]| Record {
        sources: names.clone(),
        record: entries.iter().map(|sources| Entry { sources: sources.map(String::from) }).collect(),
    };
    let judged = |entries: &[Option<&str>]| MADE[0].judge(&of(entries), &digest_of(folder.path())).verdict;
    let is_not_run = |verdict: Verdict, told: &str| matches!(verdict, Verdict::NotRun(why) if why.starts_with(told));
    let two = [Some(planted_on.as_str()); 2];
    assert_eq!(judged(&two), Verdict::Pass);
    assert!(is_not_run(judged(&[two[0], None]), "1 of 2 are of other sources"));
    assert!(is_not_run(judged(&[]), "none is recorded"));
    write(folder.path(), "src/deep/one.rs", "changed");
    assert!(is_not_run(judged(&two), "2 of 2 are of other sources"));
    write(folder.path(), "src/deep/one.rs", "src/deep/one.rs");
    assert_eq!(judged(&two), Verdict::Pass);
}

#[test]
fn every_record_of_a_script_covers_the_sources_and_says_what_each_entry_was_made_on() {
    for made in MADE {
        let record = made.read().expect(made.file);
        assert!(record.sources.iter().any(|name| name.starts_with("src")), "{}", made.file);
        assert!(digest(&root(), &record.sources).is_ok(), "{}", made.file);
        let script = made.renew.split('`').nth(1).and_then(|command| command.split(' ').nth(1)).expect("a command");
        assert!(root().join(script).is_file(), "{script}");
    }
}

#[test]
fn a_record_of_another_list_is_refused() {
    let list = "[[fault]]\nname = \"one\"\nfile = \"src/lib.rs\"\nwas = \"sound\"\nis = \"spoiled\"\n";
    let record =
        |faults: &[Fault], sources: &str| serde_json::json!({ "sources": [sources], "record": faults }).to_string();
    let parsed = |list: &str, record: &str| -> Result<Numbers, Error> {
        faults::parse((Path::new("faults.toml"), list), (Path::new("faults.json"), record))
    };
    let one = fault("one", &[("analytic", 1)], None);
    let alone = std::slice::from_ref(&one);
    assert_eq!(parsed(list, &record(alone, "src")).expect("the same").record.len(), 1);
    for (list, record, told) in [
        (list.replace("spoiled", "spoilt"), record(alone, "src"), "another `one`"),
        (list.replace("sound", "whole"), record(alone, "src"), "another `one`"),
        (list.repeat(2), record(alone, "src"), "but 2 are listed"),
        ("fault = []".into(), record(&[], "src"), "0 faults long"),
        (list.into(), record(alone, "tests"), "without `src`"),
        (list.into(), "{}".into(), "sources"),
    ] {
        let error = parsed(&list, &record).expect_err(told).to_string();
        assert!(error.contains(told) && error.contains("plant.py"), "{told}: {error}");
    }
}
