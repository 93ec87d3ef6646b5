//! Runs a recorded survey with a progress bar.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::records::{self, Survey};

/// Runs every site that this program has not yet run, then writes the record.
pub fn run<S: Send + Sync, R: Serialize + DeserializeOwned + Clone + Send + Sync>(
    survey: &Survey<S, R>,
) -> Result<(), Error> {
    let (name, record, unfinished) = (survey.name, survey.file(), records::unfinished(survey.name)?);
    writable::file(&record, writable::CHECKOUT)?;
    writable::folder(&unfinished, writable::CHECKOUT)?;
    let bar = progress((survey.sites)()?.len());
    let renewed = survey.renew(&unfinished, &record, || bar.inc(1));
    bar.finish_and_clear();
    let number = renewed?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!("written: {number} records to snapshots/{name}.csv; `git diff snapshots/{name}.csv` shows what moved"));
    Ok(())
}
