//! Whether what a script has recorded is of the present sources.
//!
//! A terminal is told, not the page: that shall be the same before and after an edit that changes no number.

use serde::Deserialize;

use crate::case::{Check, Judged, Quantity, Verdict};
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

/// A record: entries with what is told of each beside its sources.
#[derive(Clone, Debug, Deserialize)]
pub struct Record<T> {
    /// Files and folders whose digest an entry carries: all that its verdicts are computed from.
    pub sources: Vec<String>,
    /// Entries.
    pub record: Vec<T>,
}

/// What all entries have in common.
#[derive(Clone, Debug, Deserialize)]
pub struct Entry {
    /// Digest of the sources that it was made on; none where that was not recorded.
    pub sources: Option<String>,
}

/// What claims catch of the mutants of a folder (`tests/mutants/room.py`).
#[derive(Clone, Debug, Deserialize)]
pub struct Room {
    /// The folder.
    pub room: String,
    /// Digest of the sources that its mutants were made of.
    pub sources: String,
    /// All of its mutants.
    pub mutants: usize,
    /// Those that no test can catch.
    pub equivalent: usize,
    /// Those that were tried, by chance.
    pub by_claims: Caught,
}

/// How many of some mutants were caught.
#[derive(Clone, Debug, Deserialize)]
pub struct Caught {
    /// Those that turned a claim red.
    pub caught: usize,
    /// All that count.
    pub of: usize,
    /// The interval of 95 % of their share (Wilson).
    pub interval: [f64; 2],
}

/// The rooms of the record of mutants.
pub fn rooms() -> Result<Vec<Room>, Error> {
    #[derive(Deserialize)]
    struct Rooms {
        rooms: Vec<Room>,
    }
    let [.., Made { file, renew, .. }] = MADE;
    Ok(read_json::<Rooms>(&root().join(file), renew)?.rooms)
}

impl Made {
    /// Reads it.
    pub fn read(&self) -> Result<Record<Entry>, Error> {
        read_json(&root().join(self.file), self.renew)
    }

    /// The check of what is committed against the checkout.
    pub fn check(&self) -> Result<Judged, Error> {
        let record = self.read()?;
        let unreadable =
            |error| Error::unreadable(&root(), error, "restore the checkout that the program was built in");
        let present = digest(&root(), &record.sources).map_err(unreadable)?;
        Ok(self.judge(&record, &present))
    }

    /// Not run where an entry was made on other sources than those of this digest: nothing is known of it on these.
    pub fn judge(&self, record: &Record<Entry>, present: &str) -> Judged {
        let old = record.record.iter().filter(|entry| entry.sources.as_deref() != Some(present)).count();
        let all = record.record.len();
        let quantity =
            Quantity::at(format!("{} of other sources than the present ones", self.entry), format!("of {all}"));
        let judged = Check::none(quantity, "what was found on other sources need not hold on these").judge(old as f64);
        let why = match all {
            0 => format!("none is recorded: {}", self.renew),
            _ => format!("{old} of {all} are of other sources: {}", self.renew),
        };
        if old == 0 && all > 0 { judged } else { Judged { verdict: Verdict::NotRun(why), ..judged } }
    }
}
