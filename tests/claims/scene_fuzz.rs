//! Whatever stands in a file, it is read or refused: no panic, no hang, no mesh beyond the stated size; so is all that
//! fuzzing found worth keeping.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use contact_vv::accuracy::{self, Asked};
use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::error::Error;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::size::MOST;
use contact_vv::solve::{Discretisation, Run};
use serde::Deserialize;

use crate::scene_file::files;
use crate::workbench::noise;

/// Pieces that a careless or hostile hand may put anywhere, between bars.
const PIECES: &str =
    "|0|-1|1e308|1e-308|nan|inf|-inf|9999999999999999999|\"|[|]|{|}|=|\n|#|[[body]]|[contact]|true|x|\u{e9}|\0|1e9";

/// A file with a few places cut out, doubled, exchanged or overwritten.
pub fn mutated(text: &str, number: &mut impl FnMut() -> f64) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let mut below = |n: usize| (((number() + 1.0) / 2.0 * n as f64) as usize).min(n.saturating_sub(1));
    for _ in 0..=below(3) {
        if bytes.is_empty() {
            break;
        }
        let at = below(bytes.len());
        let length = below(1 + (bytes.len() - at).min(24));
        let piece = PIECES.split('|').nth(below(24)).expect("a piece");
        match below(6) {
            0 => drop(bytes.drain(at..at + length)),
            1 => drop(bytes.splice(at..at + length, piece.bytes())),
            2 => bytes.truncate(at),
            3 => {
                let copy = bytes[at..at + length].to_vec();
                let to = below(bytes.len());
                drop(bytes.splice(to..to, copy));
            }
            // A digit becomes another: most such files can still be read.
            _ => {
                let digits: Vec<usize> = (0..bytes.len()).filter(|&k| bytes[k].is_ascii_digit()).collect();
                if !digits.is_empty() {
                    let k = digits[below(digits.len())];
                    let other = ["0", "9", "-1", "1e5", "e-9", ".", "7"][below(7)];
                    drop(bytes.splice(k..=k, other.bytes()));
                }
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Reads, validates and meshes so many mutated files, and solves the small ones up to a number: how many were read,
/// solved.
fn fuzz(seed: u64, files_to_try: usize, solves: usize) -> (usize, usize) {
    let (sound, mut number) = (files(), noise(seed));
    let (mut read, mut solved) = (0, 0);
    for k in 0..files_to_try {
        let (path, text) = &sound[k % sound.len()];
        let spoiled = mutated(text, &mut number);
        let tried = std::panic::catch_unwind(|| {
            let Ok(file) = Case::parse(path, &spoiled) else { return (false, false) };
            let Ok(mesh) = Mesh::of(&file.scene, file.resolution) else { return (true, false) };
            assert!((mesh.cells() as f64) < 4.0 * MOST[0], "{} cells", mesh.cells());
            if solved >= solves || mesh.cells() > 3000 {
                return (true, false);
            }
            let mut formulation = file.formulation().clone();
            formulation.settings.max_iterations = formulation.settings.max_iterations.min(200);
            if let Some(asked) = &file.accuracy {
                let bounded = Asked { most_cells: 3000.0, ..asked.clone() };
                match accuracy::solve(&file.scene, &formulation, &bounded) {
                    Ok(answer) => assert!(answer.unmet.is_some() || answer.estimate() <= asked.relative),
                    Err(error) => assert!(!error.to_string().is_empty()),
                }
                return (true, true);
            }
            let discretisation = Discretisation::of(file.scene.clone(), file.resolution);
            let run = discretisation.and_then(|discretisation| Run::of(&discretisation, &formulation));
            assert!(run.map_or_else(|error| !error.to_string().is_empty(), |_| true));
            (true, true)
        });
        let Ok((was_read, was_solved)) = tried else { panic!("file {k} of seed {seed}:\n{spoiled}") };
        read += usize::from(was_read);
        solved += usize::from(was_solved);
    }
    (read, solved)
}

#[test]
fn two_thousand_mutated_files_are_read_or_refused_and_eighty_solved() {
    let (read, solved) = fuzz(17, 2000, 80);
    assert!(read > 200 && read < 1800, "{read} of 2000 were read");
    assert_eq!(solved, 80);
}

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

fn inputs(target: &str) -> Vec<PathBuf> {
    let folder = root().join("tests/fuzz/corpus").join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

#[test]
fn every_input_of_the_corpus_is_read_or_refused() {
    let mut kinds: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for (target, reader) in TARGETS {
        for file in inputs(target) {
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
