//! `solve CASE` or `solve SCENE.toml`: one scene by one formulation, with its outputs: what is asked, what is found,
//! how it is shown.
//!
//! * [`options`] — what the user asks for.
//! * [`found`] — what that asks, and what comes of it.
//! * [`html`] — the same as one file to send.
//! * `remedy` — what to do where it does not converge.
//! * `stages` — the stage it is in, on a terminal.
//! * `brief` — the result in some eight lines; `table` — all of it.
//! * [`curve`] — the load–approach curve, and the pressure profile as CSV.

mod brief;
pub mod curve;
pub mod found;
pub mod html;
pub mod options;
mod remedy;
mod stages;
mod table;

use std::path::{Path, PathBuf};

use crate::case::{Case, Verdict};
use crate::cli::exit::Exit;
use crate::cli::json::{Answer, Solved};
use crate::cli::terminal::say;
use crate::cli::writable::STDOUT;
use crate::cli::{self, vtu};
use crate::error::Error;
use crate::report::pictures;
use crate::solve::Formulation;
use crate::study::drawn;

pub use options::Arguments;

use found::{Found, Mesh};
use remedy::{converging, remedy, unbalanced};
use stages::Stages;

/// Solves, prints a table unless JSON goes to standard output, writes what was asked for, and tells how it ended.
///
/// A mistake that shows only now is told with its line in the file.
pub fn run(arguments: &Arguments) -> Result<Exit, Error> {
    let case = arguments.named()?;
    solve(arguments, case.clone()).map_err(|error| case.located(error))
}

fn solve(arguments: &Arguments, case: Case) -> Result<Exit, Error> {
    let asked = asked(arguments, case)?;
    let stages = Stages::new();
    let found = Found::of(asked, !arguments.no_error_bar, &stages)?;
    let document = Answer::Solved(Solved::of(&found).into()).document();
    write_files(arguments, &document, &found)?;
    stages.end();
    shown(arguments, document, &found)
}

/// What the options make of a case, by what it is solved, and what chooses the mesh; refused where that cannot be
/// solved or written.
fn asked(arguments: &Arguments, mut problem: Case) -> Result<(Case, Formulation, Mesh), Error> {
    arguments.refuse_endings()?;
    arguments.refuse_unwritable(&problem)?;
    let formulation = arguments.formulation(problem.formulation().clone());
    curve::refuse(arguments.curve.as_deref(), formulation.settings.increments)?;
    formulation.validate(&problem.scene)?;
    // A mesh fitted to the contact is asked for in place of what the file asks.
    if let Some(fitted) = arguments.fitted()? {
        let formulation = arguments.as_exact_as(fitted, formulation);
        return Ok((problem, formulation, Mesh::Fitted(fitted)));
    }
    let mesh = match arguments.asked(problem.accuracy.clone())? {
        Some(asked) => Mesh::Accurate(asked),
        None => {
            arguments.refine(&mut problem)?;
            Mesh::Given
        }
    };
    Ok((problem, formulation, mesh))
}

/// Prints what was found and tells how that ended.
fn shown(arguments: &Arguments, document: String, found: &Found) -> Result<Exit, Error> {
    if arguments.json.as_deref() == Some(Path::new(STDOUT)) {
        say(document);
    } else if arguments.all {
        table::print(found);
        found.accurate.iter().for_each(cli::accuracy::print);
    } else {
        brief::print(found);
    }
    let Found { problem, discretisation, run, .. } = found;
    if let Some(remedy) = remedy(run) {
        // The iteration is not to blame where a support is missing, or where round-off takes the forces.
        let unheld = discretisation.unheld(1.0)?.map(|error| format!("{}: {}", error.message, error.remedy));
        let tried = || found.is_mesh_given.then(|| converging(arguments, found)).flatten();
        let remedy = unheld.or_else(|| unbalanced(problem, run)).or_else(tried).unwrap_or_else(|| remedy.into());
        eprintln!("not converged: these numbers are those of the last iteration; {remedy}");
    }
    let passed = found.checks.iter().all(|check| check.verdict != Verdict::Fail);
    Ok(Exit::of(run, Exit::checked(passed)))
}

/// Writes the files that were asked for, once all of them are made.
fn write_files(arguments: &Arguments, document: &str, found: &Found) -> Result<(), Error> {
    let Found { problem, discretisation, run, .. } = found;
    let made = |path: &Option<PathBuf>, text: &dyn Fn(&Path) -> Result<String, Error>| {
        let path = path.clone().filter(|path| path.as_os_str() != STDOUT);
        path.map(|path| Ok::<_, Error>((text(&path)?, path))).transpose()
    };
    let files = [
        made(&arguments.json, &|_| Ok(document.into()))?,
        made(&arguments.csv, &|path| curve::profile(&problem.scene, run, path))?,
        made(&arguments.curve, &|path| curve::text(discretisation, run, path))?,
        made(&arguments.vtu, &|_| vtu::text(discretisation, run))?,
        made(&arguments.html, &|_| html::text(found))?,
        made(&arguments.plot, &|_| drawn::svg(&pictures::solve::sheet(problem, discretisation, run)?.drawing()))?,
    ];
    let mut files = files.into_iter().flatten();
    files.try_for_each(|(text, path)| std::fs::write(&path, text).map_err(|error| Error::unwritable(&path, error)))
}
