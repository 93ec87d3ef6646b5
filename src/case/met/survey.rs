//! All scenes, recorded under `snapshots`; a survey that was broken off resumes.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::case::met::plan::{Site, sites};
use crate::case::met::run::{self, Record};
use crate::case::records;
use crate::error::Error;
use crate::oracle::cross_code::root;

/// What renews the record.
pub const RENEW: &str = "run `cargo run --release -- met` and review the diff of snapshots/met.csv";

/// The record.
pub fn file() -> PathBuf {
    root().join("snapshots/met.csv")
}

/// Solves every scene and writes the record; `done` is called when one more is ready. Finished scenes are kept in the folder
/// `unfinished`.
pub fn survey(unfinished: &Path, record: &Path, done: impl Fn() + Sync) -> Result<usize, Error> {
    let of_site = |site: &Site| -> Result<Vec<Record>, Error> {
        let kept = unfinished.join(format!("{}-{}.csv", site.family.name(), site.number));
        let found = match records::read(&kept, RENEW) {
            Ok(found) => found,
            Err(_) => {
                let found = run::records(site)?;
                records::write(&kept, &found)?;
                found
            }
        };
        done();
        Ok(found)
    };
    let found: Vec<Record> = sites().par_iter().map(of_site).collect::<Result<Vec<_>, _>>()?.concat();
    records::write(record, &found)?;
    Ok(found.len())
}
