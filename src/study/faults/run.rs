//! The recorded faults.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;

/// What renews the record.
const REPLANT: &str = "run `python3 tests/faults/plant.py`";
/// The faults to plant.
const LIST: &str = "tests/faults/faults.toml";
/// What planting them showed.
const RECORD: &str = "snapshots/faults.json";

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

/// Every planted fault with what it did.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Files and folders whose digest a fault carries: all that the verdicts are computed from.
    pub sources: Vec<String>,
    /// In the order of the list.
    pub faults: Vec<Fault>,
}

#[derive(Deserialize)]
struct List {
    fault: Vec<Planted>,
}

#[derive(Deserialize)]
struct Record {
    sources: Vec<String>,
    record: Vec<Fault>,
}

/// The recorded faults; refused where one of them is no longer the one that the list has.
pub fn record() -> Result<Numbers, Error> {
    let [list, record] = [LIST, RECORD].map(|name| root().join(name));
    let read = |file: &PathBuf| fs::read_to_string(file).map_err(|_| Error::missing_file(file, REPLANT));
    parse((&list, &read(&list)?), (&record, &read(&record)?))
}

/// The same from the texts of both files.
pub fn parse((list, faults): (&Path, &str), (file, text): (&Path, &str)) -> Result<Numbers, Error> {
    let planted: List = toml::from_str(faults).map_err(|error| Error::unreadable(list, error, "restore it"))?;
    let Record { sources, record } =
        serde_json::from_str(text).map_err(|error| Error::unreadable(file, error, REPLANT))?;
    let refused = |key: &str, found: String| Err(Error::refused(file, key, found, REPLANT));
    if !sources.iter().any(|name| name == "src") {
        return refused("sources", format!("{sources:?}, without `src`"));
    }
    if record.len() != planted.fault.len() || record.is_empty() {
        return refused("record", format!("{} faults long, but {} are listed", record.len(), planted.fault.len()));
    }
    let mut pairs = record.iter().zip(&planted.fault);
    if let Some((fault, listed)) = pairs.find(|(fault, listed)| fault.planted != **listed) {
        return refused("record", format!("of `{}`, but the list has another `{}`", fault.planted.name, listed.name));
    }
    Ok(Numbers { sources, faults: record })
}
