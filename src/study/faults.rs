//! Fault injection: what turned red when a fault was put into a copy of the tree.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::case::{Check, Judged, Quantity};
use crate::checkout::root;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::present::{FAULTS, Record, Room, rooms};

/// The faults to plant.
const LIST: &str = "tests/faults/faults.toml";

/// A fault as the list has it: in `file`, the only `was` becomes `is`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Planted {
    /// What is planted.
    pub name: String,
    /// Where.
    pub file: String,
    /// The sound code.
    pub was: String,
    /// The fault.
    pub is: String,
}

/// One planted fault and what it did.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Fault {
    /// What was planted.
    #[serde(flatten)]
    pub planted: Planted,
    /// Digest of the sources that it was planted on; none where that was not recorded.
    pub sources: Option<String>,
    /// Checks that turned red, by the kind of their reference; trials that broke off with an error.
    pub red: BTreeMap<String, usize>,
    /// One of each kind.
    pub examples: BTreeMap<String, String>,
    /// How the run ended, if it gave no verdicts.
    pub ended: Option<String>,
}

/// Every planted fault with what it did, in the order of the list.
pub type Numbers = Record<Fault>;

impl Study for Numbers {
    const NAME: &'static str = "faults";
    const ABOUT: About = About {
        title: "Fault injection",
        asked: "Which checks turn red when something is broken on purpose.",
        limits: "Faults that somebody thought of, one at a time.",
    };

    fn plan() -> Vec<Planned<Self>> {
        vec![Planned::new("planted faults", "the record", record)]
    }

    /// The check.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let missed = self.record.iter().filter(|fault| !is_caught(fault)).count();
        let quantity =
            Quantity::at("planted fault that turns no check against a truth red", format!("of {}", self.record.len()));
        Ok(vec![Check::none(quantity, "snapshots alone verify nothing").judge(missed as f64)])
    }

    /// A row for each fault: what turned red.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let columns: [Column<&Fault>; 8] = [
            ("planted fault", |fault| fault.planted.name.clone()),
            ("in", |fault| format!("`{}`", fault.planted.file)),
            ("sources", |fault| shown(fault)),
            ("closed forms", |fault| count(fault, "analytic")),
            ("other codes", |fault| count(fault, "cross-code")),
            ("self-consistency", |fault| count(fault, "self-consistency")),
            ("broken off", |fault| count(fault, "broken off")),
            ("for instance", |fault| example(fault)),
        ];
        let faults: Vec<&Fault> = findings.iter().flat_map(|found| &found.numbers.record).collect();
        Ok(format!(
            "Faults planted one at a time on a copy of the tree (`tests/faults`), and how many checks of each kind turned red, of the suite \
             and of the worked scene files. *Sources* is the digest (SHA-256) of what a fault was planted on: {}. The terminal says at every report \
             how many are not of the present sources.\n\n{}\n\n\
             Operators and values that a program changes one at a time (`tests/mutants/room.py`), of a sample by chance, and how many turn a claim red; \
             those that give the same answers are not counted.\n\n{}\n",
            planted_on(&faults),
            markdown::columns(&columns, &faults),
            markdown::columns(&ROOMS, &rooms()?)
        ))
    }
}

/// The table of mutants.
const ROOMS: [Column<Room>; 7] = [
    ("folder", |room| format!("`{}`", room.room)),
    ("sources", |room| digits(&room.sources)),
    ("mutants", |room| room.mutants.to_string()),
    ("equivalent", |room| room.equivalent.to_string()),
    ("tried", |room| room.by_claims.of.to_string()),
    ("caught", |room| room.by_claims.caught.to_string()),
    ("share caught, interval of 95 %", |room| {
        let [low, high] = room.by_claims.interval.map(|part| 100.0 * part);
        format!("{low:.0} to {high:.0} %")
    }),
];

#[derive(Deserialize)]
struct List {
    fault: Vec<Planted>,
}

/// The recorded faults; refused where one of them is no longer the one that the list has.
pub fn record() -> Result<Numbers, Error> {
    let [list, record] = [LIST, FAULTS.file].map(|name| root().join(name));
    let read = |file: &PathBuf| fs::read_to_string(file).map_err(|_| Error::missing_file(file, FAULTS.renew));
    parse((&list, &read(&list)?), (&record, &read(&record)?))
}

/// The same from the texts of both files.
pub fn parse((list, listed): (&Path, &str), (file, text): (&Path, &str)) -> Result<Numbers, Error> {
    let planted: List = toml::from_str(listed).map_err(|error| Error::unreadable(list, error, "restore it"))?;
    let numbers: Numbers = serde_json::from_str(text).map_err(|error| Error::unreadable(file, error, FAULTS.renew))?;
    let Record { sources, record: faults } = &numbers;
    let refused = |key: &str, found: String| Err(Error::refused(file, key, found, FAULTS.renew));
    if !sources.iter().any(|name| name == "src") {
        return refused("sources", format!("{sources:?}, without `src`"));
    }
    if faults.len() != planted.fault.len() || faults.is_empty() {
        return refused("record", format!("{} faults long, but {} are listed", faults.len(), planted.fault.len()));
    }
    let mut pairs = faults.iter().zip(&planted.fault);
    if let Some((fault, listed)) = pairs.find(|(fault, listed)| fault.planted != **listed) {
        return refused("record", format!("of `{}`, but the list has another `{}`", fault.planted.name, listed.name));
    }
    Ok(numbers)
}

/// Kinds of the references of truth locks; a trial that broke off with an error is counted beside them.
const TRUTHS: [&str; 3] = ["analytic", "cross-code", "self-consistency"];

/// Whether a check against a truth turned red; a run that broke off shows none.
pub fn is_caught(fault: &Fault) -> bool {
    TRUTHS.iter().any(|kind| fault.red.get(*kind).is_some_and(|&number| number > 0))
}

/// Columns of the record: kinds of references, and runs that broke off.
const KINDS: [&str; 4] = ["analytic", "cross-code", "self-consistency", "broken off"];
/// Characters of an example that are shown.
const SHOWN: usize = 160;
/// Digits of a digest that are shown.
const DIGITS: usize = 12;

/// How many faults were planted on which sources.
fn planted_on(faults: &[&Fault]) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for fault in faults {
        *counts.entry(shown(fault)).or_default() += 1;
    }
    let told: Vec<String> = counts.iter().map(|(sources, count)| format!("{count} on {sources}")).collect();
    told.join(", ")
}

/// The first digits of the digest of its sources.
fn shown(fault: &Fault) -> String {
    fault.sources.as_ref().map_or("sources not recorded".into(), |sources| digits(sources))
}

fn digits(sources: &str) -> String {
    format!("`{}`", sources.chars().take(DIGITS).collect::<String>())
}

/// How many checks of a kind turned red.
fn count(fault: &Fault, kind: &str) -> String {
    fault.red.get(kind).map_or("–".into(), usize::to_string)
}

/// One check that turned red, or how the run ended.
fn example(fault: &Fault) -> String {
    let example = KINDS.iter().find_map(|kind| fault.examples.get(*kind)).or(fault.ended.as_ref());
    example.map_or("**nothing**", String::as_str).chars().take(SHOWN).collect()
}
