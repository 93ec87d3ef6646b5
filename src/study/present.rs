//! Whether what a script has recorded is of the present sources: each entry is bound to what it tests, and to nothing else.

use serde::Deserialize;

use crate::case::{Check, Judged, Quantity, Reference, Verdict};
use crate::checkout::{digest, root};
use crate::error::Error;
use crate::oracle::cross_code::frozen::read_json;

/// A record that a script makes and that carries digests of its sources.
#[derive(Clone, Copy, Debug)]
pub struct Made {
    /// What an entry is, as a trial is named.
    pub entry: &'static str,
    /// The record.
    pub file: &'static str,
    /// What renews it.
    pub renew: &'static str,
}

/// The record of planted faults.
pub const FAULTS: Made =
    Made { entry: "planted fault", file: "snapshots/faults.json", renew: "run `python3 tests/faults/plant.py`" };

/// All of them.
pub const MADE: [Made; 3] = [
    FAULTS,
    Made { entry: "fuzz target", file: "snapshots/fuzz.json", renew: "run `python3 tests/fuzz/run.py`" },
    Made { entry: "mutant", file: "snapshots/mutants.json", renew: "run `python3 tests/mutants/run.py`" },
];

/// A record: entries with what is told of each.
#[derive(Clone, Debug, Deserialize)]
pub struct Record<T> {
    /// Entries.
    pub record: Vec<T>,
}

/// What all entries have in common.
#[derive(Clone, Debug, Deserialize)]
pub struct Entry {
    /// Files, folders and functions that what it says depends on: of a fault its file and those of the claims that caught it, of a fuzz
    /// target the reader that it calls, of a mutant its function.
    #[serde(default)]
    pub bound: Vec<String>,
    /// Their digest when it was made; none where that was not recorded.
    pub sources: Option<String>,
    /// Day of the commit that it was made on.
    pub date: Option<String>,
}

impl Entry {
    /// Whether what it is bound to is as it was.
    pub fn is_current(&self) -> bool {
        !self.bound.is_empty() && self.sources.is_some() && digest(&root(), &self.bound).ok() == self.sources
    }

    /// What a table shows of that.
    pub fn shown(&self) -> String {
        let sign = if self.is_current() { "✓" } else { "○" };
        format!("{sign} {}", self.date.as_deref().unwrap_or("earlier"))
    }
}

/// What tests catch of the mutants of a folder (`tests/mutants/room.py`).
#[derive(Clone, Debug, Deserialize)]
pub struct Room {
    /// The folder.
    pub room: String,
    /// All of its mutants.
    pub mutants: usize,
    /// Those that no test can catch.
    pub equivalent: usize,
    /// Those that were tried, by chance, by anything.
    pub by_claims: Caught,
    /// Those of them that were tried by closed forms and other codes alone.
    pub by_truths: Caught,
}

/// How many of some mutants were caught.
#[derive(Clone, Debug, Deserialize)]
pub struct Caught {
    /// Those that turned something red.
    pub caught: usize,
    /// All that count.
    pub of: usize,
    /// The interval of 95 % of their share (Wilson); none where none was tried.
    pub interval: Option<[f64; 2]>,
}

impl Caught {
    /// How many of how many, and the interval of their share.
    pub fn shown(&self) -> String {
        let Self { caught, of, interval } = self;
        let share = |[low, high]: [f64; 2]| format!("{caught} of {of}: {:.0} to {:.0} %", 100.0 * low, 100.0 * high);
        interval.map_or("–".into(), share)
    }
}

/// The rooms of the record of mutants, and all of them together.
pub fn rooms() -> Result<Vec<Room>, Error> {
    let [.., Made { file, renew, .. }] = MADE;
    let file = root().join(file);
    let mut record: serde_json::Value = read_json(&file, renew)?;
    serde_json::from_value(record["rooms"].take()).map_err(|error| Error::unreadable(&file, error, renew))
}

impl Made {
    /// Reads it.
    pub fn read(&self) -> Result<Record<Entry>, Error> {
        read_json(&root().join(self.file), self.renew)
    }

    /// The check of what is committed against the checkout.
    pub fn check(&self) -> Result<Judged, Error> {
        Ok(self.judge(&self.read()?.record))
    }

    /// Not run where an entry was made on other sources than those that it is bound to now: nothing is known of it on these.
    pub fn judge(&self, record: &[Entry]) -> Judged {
        let old = record.iter().filter(|entry| !entry.is_current()).count();
        let all = record.len();
        let quantity =
            Quantity::at(format!("{} of other sources than the present ones", self.entry), format!("of {all}"));
        let judged = Check::at_most(
            quantity,
            Reference::own(self.file, 0.0),
            "what was found on other sources need not hold on these",
        )
        .judge(old as f64);
        let why = match all {
            0 => format!("none is recorded: {}", self.renew),
            _ => format!("{old} of {all} are of other sources: {}", self.renew),
        };
        if old == 0 && all > 0 { judged } else { Judged { verdict: Verdict::NotRun(why), ..judged } }
    }
}
