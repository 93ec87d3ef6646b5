//! The recorded faults.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::checkout::{root, sha256};

/// What renews the record.
const REPLANT: &str = "run `python3 tests/faults/plant.py`";
/// One planted fault and what it did.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Fault {
    /// What was planted.
    pub name: String,
    /// Where.
    pub file: String,
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
    /// In the order of the list.
    pub faults: Vec<Fault>,
}

/// One entry of the list.
#[derive(Deserialize)]
struct Planted {
    name: String,
    file: String,
}

#[derive(Deserialize)]
struct List {
    fault: Vec<Planted>,
}

#[derive(Deserialize)]
struct Record {
    faults_toml: String,
    record: Vec<Fault>,
}

/// The recorded faults; refused where the list has changed since.
pub fn record() -> Result<Numbers, Error> {
    let (list, file) = (root().join("tests/faults/faults.toml"), root().join("snapshots/faults.json"));
    let read = |file: &PathBuf| fs::read_to_string(file).map_err(|_| Error::missing_file(file, REPLANT));
    let text = read(&list)?;
    let listed = sha256(text.as_bytes());
    let record: Record =
        serde_json::from_str(&read(&file)?).map_err(|error| Error::unreadable(&file, error, REPLANT))?;
    if record.faults_toml != listed {
        let found = format!("`{}`, but the list now hashes to `{listed}`", record.faults_toml);
        return Err(Error::refused(&file, "faults_toml", found, REPLANT));
    }
    let planted: List = toml::from_str(&text).map_err(|error| Error::unreadable(&list, error, "restore it"))?;
    let same = |(fault, planted): (&Fault, &Planted)| fault.name == planted.name && fault.file == planted.file;
    let complete = record.record.len() == planted.fault.len() && record.record.iter().zip(&planted.fault).all(same);
    if !complete || planted.fault.is_empty() {
        let found = format!("{} faults recorded, {} listed", record.record.len(), planted.fault.len());
        return Err(Error::refused(&file, "record", found, REPLANT));
    }
    Ok(Numbers { faults: record.record })
}
