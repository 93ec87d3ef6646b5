//! Surveys what is called converged, with a progress bar.

use crate::case::converged::{sites, survey};
use crate::case::records;
use crate::cli::{progress, say};
use crate::error::Error;

/// Runs every site that this program has not yet run, then writes the record.
pub fn run() -> Result<(), Error> {
    let bar = progress(sites()?.len());
    let unfinished = records::unfinished("converged")?;
    let surveyed = survey::survey(&unfinished, &survey::file(), || bar.inc(1));
    bar.finish_and_clear();
    let runs = surveyed?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!(
        "written: {runs} runs to snapshots/converged.csv; `git diff snapshots/converged.csv` shows what moved"
    ));
    Ok(())
}
