//! `solve CASE` or `solve SCENE.toml`: one scene by one formulation, with its outputs.
//!
//! * [`options`] — what the user asks for.
//! * `stages` — the stage it is in, on a terminal.
//! * `table` — the result in lines.
//! * `profile` — the pressure profile as CSV.

pub mod options;
mod profile;
mod stages;
mod table;

use std::path::Path;

use crate::case::Run;
use crate::case::accuracy;
use crate::cli::{self, json, reactions, say, vtu};
use crate::error::Error;
use crate::formulation::Discretisation;
use crate::report::pictures;

pub use options::Arguments;
use options::Task;
use stages::Stages;

/// Solves, prints a table unless JSON goes to standard output, and writes what was asked for; tells whether it converged.
///
/// A mistake that shows only now is told with its line in the file.
pub fn run(arguments: &Arguments) -> Result<bool, Error> {
    let task = arguments.task()?;
    let places = task.places.clone();
    solve(arguments, task).map_err(|error| match &places {
        Some(places) => places.locate(error),
        None => error,
    })
}

fn solve(arguments: &Arguments, task: Task) -> Result<bool, Error> {
    let Task { mut problem, formulation: base, accuracy: asked, .. } = task;
    arguments.refuse_endings()?;
    let formulation = arguments.formulation(base);
    formulation.validate(&problem.scene)?;
    let asked = arguments.asked(asked)?;
    let stages = Stages::new();
    let accurate = match asked {
        None => {
            problem.resolution = arguments.resolution(&problem)?;
            None
        }
        Some(asked) => {
            stages.begin(stages::ACCURACY);
            let answer = accuracy::solve(&problem.scene, &formulation, &asked)?;
            (problem.scene, problem.resolution) = (answer.scene.clone(), answer.resolution);
            Some((asked, answer))
        }
    };
    let resolution = problem.resolution;
    let discretisation = Discretisation::announced(problem.scene.clone(), resolution, &|stage| stages.begin(stage))?;
    stages.begin(stages::ITERATION);
    let run = match &accurate {
        None => Run::of(&discretisation, &formulation)?,
        Some((_, answer)) => answer.run.clone(),
    };
    stages.begin(stages::OUTPUTS);
    let reactions = reactions::readings(&discretisation, &run)?;
    let document = arguments.json.is_some().then(|| {
        let accuracy = accurate.as_ref().map(cli::accuracy::Document::of);
        json::text(&problem, resolution, &run, &reactions, accuracy)
    });
    let to_stdout = arguments.json.as_deref() == Some(Path::new("-"));
    if let (Some(path), Some(text), false) = (&arguments.json, &document, to_stdout) {
        write(path, text)?;
    }
    if let Some(path) = &arguments.csv {
        write(path, &profile::csv(&problem.scene, &run, path)?)?;
    }
    if let Some(path) = &arguments.vtu {
        write(path, &vtu::text(&discretisation, &run)?)?;
    }
    if let Some(path) = &arguments.plot {
        write(path, &pictures::solve::sheet(&problem, &discretisation, &run)?.svg()?)?;
    }
    stages.end();

    match document.filter(|_| to_stdout) {
        Some(text) => say(text),
        None => {
            table::print(&problem, resolution, &run, &reactions);
            accurate.iter().for_each(|accurate| cli::accuracy::print(accurate, &problem.scene.contact().path));
        }
    }
    if !run.solution.converged() {
        eprintln!(
            "not converged: these numbers are those of the last step; allow more steps, or choose another algorithm or start"
        );
    }
    Ok(run.solution.converged() && accurate.is_none_or(|(_, answer)| answer.unmet.is_none()))
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    std::fs::write(path, text).map_err(|error| Error::File {
        path: path.into(),
        reason: error.to_string(),
        remedy: "check that the folder exists and may be written".into(),
    })
}
