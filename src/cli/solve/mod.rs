//! `solve CASE` or `solve SCENE.toml`: one scene by one formulation, with its outputs.
//!
//! * [`options`] — what the user asks for.
//! * `remedy` — what to do where it does not converge.
//! * `stages` — the stage it is in, on a terminal.
//! * `table` — the result in lines.
//! * [`curve`] — the load–approach curve.
//! * [`profile`] — the pressure profile as CSV.

pub mod curve;
pub mod options;
pub mod profile;
mod remedy;
mod stages;
mod table;

use std::path::Path;

use crate::accuracy;
use crate::case::solved::met;
use crate::case::{Case, Verdict};
use crate::cli::ended::Ended;
use crate::cli::found::Found;
use crate::cli::json::{Answer, Solved};
use crate::cli::terminal::say;
use crate::cli::{self, reactions, vtu};
use crate::clock::{Clock, Stage};
use crate::error::Error;
use crate::report::pictures;
use crate::solve::Discretisation;
use crate::solve::Run;

pub use options::Arguments;
use options::STDOUT;
use remedy::{converging, remedy, unbalanced};
use stages::Stages;

/// Solves, prints a table unless JSON goes to standard output, writes what was asked for, and tells how it ended.
///
/// A mistake that shows only now is told with its line in the file.
pub fn run(arguments: &Arguments) -> Result<Ended, Error> {
    let case = arguments.named()?;
    let places = case.places.clone();
    solve(arguments, case).map_err(|error| match &places {
        Some(places) => places.locate(error),
        None => error,
    })
}

fn solve(arguments: &Arguments, mut problem: Case) -> Result<Ended, Error> {
    arguments.refuse_endings()?;
    arguments.refuse_unwritable(&problem)?;
    let own = problem.formulation().clone();
    let formulation = arguments.formulation(own.clone());
    curve::refuse(arguments.curve.as_deref(), formulation.settings.increments)?;
    formulation.validate(&problem.scene)?;
    let fitted = arguments.fitted()?;
    let formulation = match fitted {
        Some(fitted) => arguments.as_exact_as(fitted, formulation),
        None => formulation,
    };
    // A mesh fitted to the contact is asked for in place of what the file asks.
    let asked = arguments.asked(problem.accuracy.clone().filter(|_| fitted.is_none()))?;
    let asked_mesh = fitted.is_none() && asked.is_none();
    let stages = Stages::new();
    let accurate = match asked {
        None if fitted.is_some() => None,
        None => {
            arguments.refine(&mut problem)?;
            None
        }
        Some(asked) => {
            stages.search();
            let answer = accuracy::solve(&problem.scene, &formulation, &asked)?;
            (problem.scene, problem.resolution) = (answer.scene.clone(), answer.resolution);
            Some((asked, answer))
        }
    };
    let (discretisation, run) = match (fitted, &accurate) {
        (Some(fitted), _) => {
            let answer = fitted.solve(&problem.scene, &formulation)?;
            (problem.scene, problem.resolution) =
                (answer.discretisation.scene.clone(), answer.discretisation.resolution);
            (answer.discretisation, answer.run)
        }
        (None, accurate) => {
            let begins = |stage| stages.begin(stage);
            let clock = Clock::telling(&begins);
            let discretisation = Discretisation::timed(problem.scene.clone(), problem.resolution, clock)?;
            stages.begin(Stage::Iteration);
            let run = match accurate {
                None => Run::of(&discretisation, &formulation)?.with_limits(&discretisation)?,
                Some((_, answer)) => answer.run.clone(),
            };
            (discretisation, run)
        }
    };
    let run = run.with_doubts(&discretisation);
    let resolution = problem.resolution;
    stages.write();
    let mut checks = problem.own(&discretisation, &run)?;
    // The checks of a file are written for its own formulation, which may go further.
    if (formulation.element, formulation.algorithm) != (own.element, own.algorithm) {
        let accepted = run.formulation.settings.tolerance;
        checks = checks.into_iter().map(|check| check.as_far_as(accepted)).collect();
    }
    checks.extend(accurate.iter().map(|(asked, answer)| met(asked, answer)));
    let wanted = !arguments.no_error_bar;
    let bars = wanted.then(|| accuracy::bars(&discretisation, &run, &problem.displaced())).transpose()?;
    if let Some(bars) = bars.as_ref().filter(|_| run.solution.converged()) {
        checks = checks.into_iter().map(|check| check.with_bar(&bars.all)).collect();
    }
    let found = Found {
        problem: &problem,
        resolution,
        reactions: reactions::readings(&discretisation, &run)?,
        bars,
        run: &run,
        checks,
    };
    let answer = Solved::of(&found, accurate.as_ref().map(cli::accuracy::Document::of));
    let document = Answer::Solved(answer.into()).document();
    write_files(arguments, &document, &discretisation, &found)?;
    stages.end();
    if arguments.json.as_deref() == Some(Path::new(STDOUT)) {
        say(document);
    } else {
        table::print(&found);
        accurate.iter().for_each(cli::accuracy::print);
    }
    if let Some(remedy) = remedy(&run) {
        // The iteration is not to blame where a support is missing, or where round-off takes the forces.
        let unheld = discretisation.unheld(1.0)?.map(|error| format!("{}: {}", error.message, error.remedy));
        let tried = || asked_mesh.then(|| converging(arguments, &own, &discretisation, &run)).flatten();
        let remedy = unheld.or_else(|| unbalanced(&problem, &run)).or_else(tried).unwrap_or_else(|| remedy.into());
        eprintln!("not converged: these numbers are those of the last iteration; {remedy}");
    }
    let passed = found.checks.iter().all(|check| check.verdict != Verdict::Fail);
    Ok(Ended::of(&run, Ended::checked(passed)))
}

/// Writes the files that were asked for, once all of them are made.
fn write_files(
    arguments: &Arguments,
    document: &str,
    discretisation: &Discretisation,
    found: &Found,
) -> Result<(), Error> {
    let Found { problem, run, .. } = found;
    let mut files = Vec::new();
    if let Some(path) = arguments.json.as_ref().filter(|path| path.as_os_str() != STDOUT) {
        files.push((path, document.to_owned()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path, profile::csv(&problem.scene, run, path)?));
    }
    if let Some(path) = &arguments.curve {
        files.push((path, curve::text(discretisation, run, path)?));
    }
    if let Some(path) = &arguments.vtu {
        files.push((path, vtu::text(discretisation, run)?));
    }
    if let Some(path) = &arguments.plot {
        let sheet = pictures::solve::sheet(problem, discretisation, run)?;
        files.push((path, sheet.drawing()?.svg(crate::figure::Theme::Light)));
    }
    files.into_iter().try_for_each(|(path, text)| write(path, &text))
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    std::fs::write(path, text).map_err(|error| Error::unwritable(path, error))
}
