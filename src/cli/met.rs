//! Surveys whether accuracies called met are met, with a progress bar.

use crate::case::met::{sites, survey};
use crate::case::records;
use crate::cli::{progress, say};
use crate::error::Error;

/// Solves every scene that this program has not yet solved, then writes the record.
pub fn run() -> Result<(), Error> {
    let bar = progress(sites().len());
    let unfinished = records::unfinished("met")?;
    let surveyed = survey::survey(&unfinished, &survey::file(), || bar.inc(1));
    bar.finish_and_clear();
    let answers = surveyed?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!("written: {answers} answers to snapshots/met.csv; `git diff snapshots/met.csv` shows what moved"));
    Ok(())
}
