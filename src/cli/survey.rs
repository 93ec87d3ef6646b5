//! Surveys that are recorded under `snapshots`, with a progress bar.

use std::path::PathBuf;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::{atlas, converged, coverage, met, random, records};

/// Where methods fail: a record a plane.
pub fn atlas() -> Result<(), Error> {
    let planes = atlas::Plane::ALL.map(|plane| (atlas::record::file(plane), plane.sites()));
    run("atlas", "snapshots/atlas", &planes, atlas::Site::key, atlas::run::records)
}

/// What is called converged.
pub fn converged() -> Result<(), Error> {
    in_one(converged::NAME, converged::sites()?, converged::Site::key, converged::run::records)
}

/// What is called met.
pub fn met() -> Result<(), Error> {
    in_one(met::NAME, met::sites(), random::Site::key, met::records)
}

/// Whether error bars hold.
pub fn coverage() -> Result<(), Error> {
    in_one(coverage::NAME, coverage::sites(), random::Site::key, coverage::run::records)
}

/// A survey that is recorded as one file.
fn in_one<S: Sync, T: Serialize + DeserializeOwned + Clone + Send>(
    name: &str,
    sites: Vec<S>,
    key: fn(&S) -> String,
    run_site: fn(&S) -> Result<Vec<T>, Error>,
) -> Result<(), Error> {
    run(name, &format!("snapshots/{name}.csv"), &[(records::file(name), sites)], key, run_site)
}

/// Runs every site that this program has not yet run, then writes the records, which are at `place`.
fn run<S: Sync, T: Serialize + DeserializeOwned + Clone + Send>(
    name: &str,
    place: &str,
    parts: &[(PathBuf, Vec<S>)],
    key: fn(&S) -> String,
    run_site: fn(&S) -> Result<Vec<T>, Error>,
) -> Result<(), Error> {
    let unfinished = records::unfinished(name)?;
    parts.iter().try_for_each(|(record, _)| writable::file(record, writable::CHECKOUT))?;
    writable::folder(&unfinished, writable::CHECKOUT)?;
    let bar = progress(parts.iter().map(|(_, sites)| sites.len()).sum());
    let survey = |(record, sites): &(PathBuf, Vec<S>)| {
        records::survey([&unfinished, record], sites, key, run_site, || bar.inc(1))
    };
    let surveyed: Result<Vec<usize>, Error> = parts.iter().map(survey).collect();
    bar.finish_and_clear();
    let number: usize = surveyed?.iter().sum();
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!("written: {number} records to {place}; `git diff {place}` shows what moved"));
    Ok(())
}
