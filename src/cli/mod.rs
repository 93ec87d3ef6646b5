//! What the user types.
//!
//! * [`accuracy`] — what `solve` says of an accuracy that was asked for.
//! * [`survey`] — surveys what is called converged and met, and whether error bars hold, with a progress bar.
//! * [`ended`] — how a command ended, as its exit code tells.
//! * [`atlas`] — surveys the stability atlas with a progress bar.
//! * [`timings`] — measures speed against accuracy.
//! * [`suite`] — runs all trials with a progress bar.
//! * [`solve`] — one case, with its outputs.
//! * [`verify`] — scene files with their checks.
//! * `found` — what it found.
//! * `bars` — how far each number may be from the truth.
//! * [`reactions`] — what its supports exert.
//! * [`json`] — the result of a solve as JSON.
//! * `terminal` — lines, errors and a bar of progress.
//! * [`vtu`] — its fields for ParaView.

pub mod accuracy;
pub mod atlas;
mod bars;
pub mod ended;
mod found;
pub mod json;
pub mod reactions;
pub mod solve;
pub mod suite;
pub mod survey;
mod terminal;
pub mod timings;
pub mod verify;
pub mod vtu;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::case::library::NAMES;
use crate::cli::ended::Ended;
use crate::cli::terminal::{say, show};
use crate::error::Error;
use crate::report;
use crate::study::timings::growth;

/// Contact elements and iterations for frictionless elastic contact in 2D, verified.
///
/// Without a command: solves every case of the suite, prints the verdicts and writes VALIDATION.md with its pages and charts.
#[derive(Debug, Parser)]
#[command(name = "contact-vv", version)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Solve the suite and write VALIDATION.md, snapshots/pages and snapshots/charts (the default).
    Report {
        /// Write nothing; show what differs and fail when the page or a chart is stale.
        #[arg(long)]
        check: bool,
    },
    /// Solve one case of the library, or a scene file of your own.
    Solve(Box<solve::Arguments>),
    /// Solve scene files and judge them by their own checks; fails where one fails.
    Verify {
        /// Scene files (*.toml), or folders with some.
        #[arg(required = true, value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// Print every check with its verdict, a line of JSON each, instead of the table.
        #[arg(long)]
        json: bool,
    },
    /// Solve the suite and print every check with its verdict, a line of JSON each; trials that break off fail too.
    Verdicts,
    /// Survey the stability atlas and write snapshots/atlas; interrupted, it resumes.
    Atlas,
    /// Survey what is called converged and write snapshots/converged.csv; interrupted, it resumes.
    Converged,
    /// Survey whether accuracies called met are met and write snapshots/met.csv; interrupted, it resumes.
    Met,
    /// Survey the readings of the paper and write snapshots/readings.csv; interrupted, it resumes.
    Readings,
    /// Survey whether error bars hold and write snapshots/coverage.csv; interrupted, it resumes.
    Coverage,
    /// Measure speed against accuracy on one thread and write snapshots/timings; other codes are asked where installed.
    Timings {
        /// Solve one mesh, elements per half-width and refinement, and print the largest memory of the process in bytes.
        #[arg(long, hide = true, num_args = 2)]
        memory: Option<Vec<u32>>,
        /// Measure only what error bars cost, on one thread and on all.
        #[arg(long)]
        bars: bool,
    },
    /// Name the cases of the library.
    List,
    /// Ask the other codes for everything again, write oracles/frozen and show what changed.
    #[cfg(feature = "python")]
    Freeze,
}

/// Runs the command line. Exit codes: 0 all is well, 1 a check failed or the page is stale, 2 the input is wrong, 3 a run did
/// not converge or holds no contact.
pub fn main() -> ExitCode {
    let outcome = match Cli::parse().command.unwrap_or(Command::Report { check: false }) {
        Command::Report { check } => report_command(check).map(Ended::checked),
        Command::Verdicts => Ok(Ended::checked(suite::verdicts())),
        Command::Atlas => atlas::run().map(|()| Ended::Well),
        Command::Converged => survey::converged().map(|()| Ended::Well),
        Command::Met => survey::met().map(|()| Ended::Well),
        Command::Readings => survey::readings().map(|()| Ended::Well),
        Command::Coverage => survey::coverage().map(|()| Ended::Well),
        Command::Timings { memory: Some(mesh), .. } => {
            growth::memory_of_one_solve(mesh[0] as usize, mesh[1]).map(say).map(|()| Ended::Well)
        }
        Command::Timings { memory: None, bars: true } => timings::bars().map(|()| Ended::Well),
        Command::Timings { memory: None, bars: false } => timings::run().map(|()| Ended::Well),
        Command::Verify { paths, json } => verify::run(&paths, json),
        Command::Solve(arguments) => solve::run(&arguments),
        Command::List => {
            NAMES.iter().for_each(|(name, title)| say(format!("{name:18} {title}")));
            Ok(Ended::Well)
        }
        #[cfg(feature = "python")]
        Command::Freeze => freeze().map(|()| Ended::Well),
    };
    match outcome {
        Ok(ended) => ended.into(),
        Err(error) => {
            show(&error);
            ExitCode::from(ended::WRONG_INPUT)
        }
    }
}

/// Whether all checks pass and, with `check`, the committed page is up to date.
fn report_command(check: bool) -> Result<bool, Error> {
    let root = root()?;
    let findings = suite::run()?;
    suite::print(&findings);
    let sound = suite::all_pass(&findings);
    let page = report::compose(&findings)?;
    if !check {
        report::write(&page, &root)?;
        let [pages, charts] = [page.pages.len(), page.charts.len()];
        say(format!("written: {}, {pages} pages and {charts} charts", report::files::PAGE));
        return Ok(sound);
    }
    let differences = report::differences(&page, &root);
    differences.iter().for_each(say);
    say(if differences.is_empty() { "the page is up to date" } else { "the page is stale: run `cargo run --release`" });
    Ok(sound && differences.is_empty())
}

/// The project folder: where the page is, upwards from the working directory.
fn root() -> Result<PathBuf, Error> {
    let here = std::env::current_dir()
        .map_err(|error| Error::unreadable(Path::new("."), error, "run in a folder that exists"))?;
    let is_root = |folder: &&Path| folder.join("Cargo.toml").is_file() && folder.join("snapshots").is_dir();
    here.ancestors().find(is_root).map(Path::to_path_buf).ok_or_else(|| {
        let message = "neither this folder nor one above holds Cargo.toml and snapshots/";
        Error::file(&here, message, "run inside a checkout of the project")
    })
}

/// Renews the frozen results of both codes.
#[cfg(feature = "python")]
fn freeze() -> Result<(), Error> {
    crate::study::cross_code::renewal::freeze()?.into_iter().for_each(say);
    crate::study::independent::renewal::freeze()?.into_iter().for_each(say);
    Ok(())
}
