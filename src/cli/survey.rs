//! Surveys that are recorded as one file under `snapshots`, with a progress bar.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::{converged, coverage, met, random, records};

/// What is called converged.
pub fn converged() -> Result<(), Error> {
    run(converged::NAME, &converged::sites()?, converged::Site::key, converged::run::records)
}

/// What is called met.
pub fn met() -> Result<(), Error> {
    run(met::NAME, &met::sites(), random::Site::key, met::records)
}

/// Whether error bars hold.
pub fn coverage() -> Result<(), Error> {
    run(coverage::NAME, &coverage::sites(), random::Site::key, coverage::run::records)
}

/// Runs every site that this program has not yet run, then writes the record.
fn run<S: Sync, T: Serialize + DeserializeOwned + Clone + Send>(
    name: &str,
    sites: &[S],
    key: fn(&S) -> String,
    run: fn(&S) -> Result<Vec<T>, Error>,
) -> Result<(), Error> {
    let unfinished = records::unfinished(name)?;
    writable::file(&records::file(name), writable::CHECKOUT)?;
    writable::folder(&unfinished, writable::CHECKOUT)?;
    let bar = progress(sites.len());
    let surveyed = records::survey([&unfinished, &records::file(name)], sites, key, run, || bar.inc(1));
    bar.finish_and_clear();
    let number = surveyed?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!("written: {number} records to snapshots/{name}.csv; `git diff snapshots/{name}.csv` shows what moved"));
    Ok(())
}
