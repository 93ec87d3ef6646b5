//! Surveys the stability atlas with a progress bar.

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::atlas::{Plane, record, survey};
use crate::study::records;

/// Surveys every point that is not yet recorded by this program, then writes the records.
pub fn run() -> Result<(), Error> {
    let unfinished = records::unfinished("atlas")?;
    writable::folder(&record::folder(), writable::CHECKOUT)?;
    writable::folder(&unfinished, writable::CHECKOUT)?;
    let bar = progress(survey::size());
    let surveyed = survey::survey(&Plane::ALL, &unfinished, &record::folder(), |points| bar.inc(points as u64));
    bar.finish_and_clear();
    surveyed?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    let folder = record::FOLDER;
    say(format!("written: {} points under {folder}; `git diff {folder}` shows what moved", survey::size()));
    Ok(())
}
