//! Recorded surveys: lines of a CSV file, read whole and written whole; one that was interrupted resumes.

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::checkout::{root, sha256};
use crate::error::Error;

/// The records of a file, whatever they are; `renew` says what renews them.
pub fn read<T: DeserializeOwned>(path: &Path, renew: &str) -> Result<Vec<T>, Error> {
    let text = std::fs::read_to_string(path).map_err(|_| Error::missing_file(path, renew))?;
    csv::Reader::from_reader(text.as_bytes())
        .deserialize()
        .collect::<Result<_, _>>()
        .map_err(|error| Error::unreadable(path, error, renew))
}

/// Writes records to a file, a line each.
pub fn write<T: Serialize>(path: &Path, records: &[T]) -> Result<(), Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        writer.serialize(record).map_err(|error| Error::unwritable(path, error))?;
    }
    let text = writer.into_inner().map_err(|error| Error::unwritable(path, error))?;
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| Error::unwritable(path, error))?;
    }
    // Whoever is broken off leaves the old file or the new one, never half of it.
    let fresh = path.with_extension("csv.new");
    std::fs::write(&fresh, text)
        .and_then(|()| std::fs::rename(&fresh, path))
        .map_err(|error| Error::unwritable(path, error))
}

/// The record of a survey of a name.
pub fn file(name: &str) -> PathBuf {
    root().join("snapshots").join(name).with_extension("csv")
}

/// What renews it.
pub fn renewal(name: &str) -> String {
    format!("run `cargo run --release -- {name}` and review the diff of snapshots/{name}.csv")
}

/// Runs every site, whose records are kept under its key in the folder `unfinished`, and writes them all to `record`; `done` is
/// told when one more is ready.
pub fn survey<S: Sync, T: Serialize + DeserializeOwned + Clone + Send>(
    [unfinished, record]: [&Path; 2],
    sites: &[S],
    key: impl Fn(&S) -> String + Sync,
    run: impl Fn(&S) -> Result<Vec<T>, Error> + Sync,
    done: impl Fn() + Sync,
) -> Result<usize, Error> {
    let of_site = |site: &S| -> Result<Vec<T>, Error> {
        let kept = unfinished.join(key(site) + ".csv");
        let found = read(&kept, "").or_else(|_| {
            let found = run(site)?;
            write(&kept, &found)?;
            Ok(found)
        });
        done();
        found
    };
    let found = sites.par_iter().map(of_site).collect::<Result<Vec<_>, _>>()?.concat();
    write(record, &found)?;
    Ok(found.len())
}

/// Four significant digits: what a reviewer reads.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(f64::NAN)
}

/// Folder of the running program's unfinished survey of a name: another program starts afresh.
pub fn unfinished(name: &str) -> Result<PathBuf, Error> {
    if !root().join("Cargo.toml").is_file() {
        let message = "the checkout this program was built in is no longer there";
        return Err(Error::file(&root(), message, "build it again where the checkout is now"));
    }
    let unreadable = |error: std::io::Error| {
        Error::at("the running program", error.to_string(), "run it from a file that may be read")
    };
    let program = std::env::current_exe().and_then(std::fs::read).map_err(unreadable)?;
    Ok(root().join("target").join(name).join(&sha256(&program)[..16]))
}
