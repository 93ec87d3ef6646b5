//! What fuzzing has found worth keeping: every input of the corpus is read or refused, and the record of the runs holds.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use contact_vv::checkout::root;
use contact_vv::error::Error;
use serde::Deserialize;

#[path = "../fuzz/read.rs"]
mod read;

/// Executions of every target.
const LEAST: u64 = 1_000_000;

type Reader = fn(&[u8]) -> Result<(), Error>;

const TARGETS: [(&str, Reader); 5] = [
    ("scene", read::scene),
    ("mesh", read::mesh),
    ("answers", read::answers),
    ("curve", read::curve),
    ("handed", read::handed),
];

#[derive(Deserialize)]
struct Fuzzed {
    record: Vec<Target>,
}

#[derive(Deserialize)]
struct Target {
    target: String,
    executions: u64,
    edges_covered: usize,
    corpus: usize,
    broke: usize,
}

fn files(target: &str) -> Vec<PathBuf> {
    let folder = root().join("tests/fuzz/corpus").join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

#[test]
fn every_input_of_the_corpus_is_read_or_refused() {
    let mut kinds: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for (target, reader) in TARGETS {
        for file in files(target) {
            let bytes = fs::read(&file).expect("an input");
            let told = std::panic::catch_unwind(|| reader(&bytes));
            let told = told.unwrap_or_else(|_| panic!("{} breaks the reader", file.display()));
            if let Err(error) = &told {
                assert!(!error.message.trim().is_empty() && !error.remedy.trim().is_empty(), "{}", file.display());
            }
            kinds.entry(target).or_default()[usize::from(told.is_err())] += 1;
        }
    }
    read::clear();
    // Both ways out of every reader are taken.
    assert!(kinds.len() == TARGETS.len() && kinds.values().flatten().all(|count| *count > 0), "{kinds:?}");
}

#[test]
fn every_target_was_executed_a_million_times_and_no_input_broke_it() {
    let text = fs::read_to_string(root().join("snapshots/fuzz.json")).expect("recorded by tests/fuzz/run.py");
    let record = serde_json::from_str::<Fuzzed>(&text).expect("a record").record;
    let names: Vec<&str> = record.iter().map(|one| one.target.as_str()).collect();
    assert_eq!(names, TARGETS.map(|(name, _)| name));
    for Target { target, executions, edges_covered, corpus, broke } in &record {
        assert!(*executions >= LEAST && *edges_covered > 0 && *corpus > 0, "{target}: {executions} executions");
        assert_eq!(*broke, 0, "{target}");
    }
}
