//! Runs recorded surveys with a progress bar; and asks other codes for the exported cases, and keeps what they write.

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::atlas::{self, Plane, plane};
use crate::study::records::{self, Survey};
use crate::study::scoreboard::board::{self, Board, Setting, TIMES, hashes};
use crate::study::scoreboard::{CASES, SMALLEST, named};
use crate::study::seconds::Machine;

/// What of a survey is run.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// Run only sites that the record lacks, and keep its lines of the others.
    #[arg(long)]
    lacking: bool,
}

/// Runs every site that this program has not yet run, then writes the record.
pub fn run<S: Send + Sync, R: Serialize + DeserializeOwned + Clone + Send + Sync>(
    survey: &Survey<S, R>,
    Arguments { lacking }: Arguments,
) -> Result<(), Error> {
    let (name, record) = (survey.name, survey.file());
    let renew = |unfinished: &Path, done: &(dyn Fn() + Sync)| {
        if lacking {
            survey.keep(unfinished)?;
        }
        survey.renew(unfinished, &record, done)
    };
    renewed(name, &format!("snapshots/{name}.csv"), &[survey.file()], || Ok((survey.sites)()?.len()), renew)
}

/// The same of where methods fail, a record a plane.
pub fn atlas() -> Result<(), Error> {
    let sites = || Ok(Plane::ALL.iter().map(|plane| plane.sites().len()).sum());
    let renew = |unfinished: &Path, done: &(dyn Fn() + Sync)| {
        Plane::ALL.into_iter().map(|plane| atlas::run::renew(plane, unfinished, &plane::file(plane), done)).sum()
    };
    renewed("atlas", "snapshots/atlas", &Plane::ALL.map(plane::file), sites, renew)
}

/// Renews the files of a survey of so many sites, which are at `place`.
fn renewed(
    name: &str,
    place: &str,
    files: &[PathBuf],
    sites: impl FnOnce() -> Result<usize, Error>,
    renew: impl FnOnce(&Path, &(dyn Fn() + Sync)) -> Result<usize, Error>,
) -> Result<(), Error> {
    writable::in_checkout("snapshots")?;
    let unfinished = records::unfinished(name)?;
    files.iter().try_for_each(|file| writable::file(file, writable::CHECKOUT))?;
    writable::folder(&unfinished, writable::CHECKOUT)?;
    let bar = progress(sites()?);
    let number = renew(&unfinished, &|| bar.inc(1));
    bar.finish_and_clear();
    let number = number?;
    // What is left behind is in the build's own folder: nothing is lost if it cannot be removed.
    let _ = std::fs::remove_dir_all(&unfinished);
    say(format!("written: {number} records to {place}; `git diff {place}` shows what moved"));
    Ok(())
}

/// `scoreboard`: asks every code for every case, and writes the record; nothing is written before all have answered.
pub fn scoreboard() -> Result<(), Error> {
    writable::in_checkout(board::FOLDER)?;
    board::refuse_absent(SMALLEST, &named(SMALLEST)?)?;
    let bar = progress(CASES.len() * Setting::ALL.len());
    let mut fresh = Board { scripts: hashes(), processor: Machine::here().processor, ..Board::default() };
    let mut files = Vec::new();
    for name in CASES {
        let (asked, written) = board::ask(name, &named(name)?, |setting, times| {
            bar.inc(u64::from(times.total_cmp(&TIMES[0]).is_eq()));
            bar.set_message(format!("{name}, {}, {}, {times} times", setting.code.name(), setting.method));
        })?;
        fresh.cases.insert(name.into(), asked);
        files.extend(written);
    }
    bar.finish_and_clear();
    fresh.write(&files)?;
    say(format!("written: {}; `cargo run --release` draws it", board::FOLDER));
    Ok(())
}
