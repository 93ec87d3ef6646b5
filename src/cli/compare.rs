//! `compare CASE`: all nine formulations on one scene, a line each, the one with the fewest operations first.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::case::Case;
use crate::cli::exit::Exit;
use crate::cli::json::{Answer, Compared, Compares};
use crate::cli::terminal::{say, table};
use crate::cli::writable::{self, Output, STDOUT};
use crate::cli::{choice, json};
use crate::clock::Stage;
use crate::drawing;
use crate::error::{Error, meant};
use crate::markdown;
use crate::report::pictures;
use crate::solution::Outcome;
use crate::solve::{Element, Formulation, Iteration, Run};
use crate::study::drawn;

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Case of the library (`list` names them), or a scene file.
    case: String,
    /// Only these, such as line.constant+newton, or line.constant as it stands in the paper; by default all nine as
    /// `solve` takes them.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    formulations: Vec<String>,
    /// Largest error accepted of peak, profile, width and approach against the solution of the same discrete problem,
    /// for all of them.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Write the table as JSON to a file, or to standard output with `-`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Draw the iteration error of each against its iterations as SVG.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Replace files that are not earlier outputs of the same option; files that are read are never replaced.
    #[arg(long)]
    force: bool,
}

/// Solves the scene by each formulation; one that fails is a row with its reason. Well where one of them converges.
pub fn run(arguments: &Arguments) -> Result<Exit, Error> {
    let case = choice::case("compare", &arguments.case, None)?;
    let formulations = arguments.chosen(&case)?;
    arguments.refuse_unwritable(&case)?;
    let discretisation = case.meshed()?.discretisation;
    let (mut rows, mut runs) = (Vec::new(), Vec::new());
    for formulation in &formulations {
        let run = Run::of(&discretisation, formulation);
        rows.push(arguments.row(formulation, &run));
        runs.extend(run);
    }
    // Of equal work, what leaves the smaller error.
    let told = |row: &Compares| [row.operations.map(f64::round), row.error].map(|number| number.unwrap_or(f64::NAN));
    let by_work = |a: &Compares, b: &Compares| {
        let [[work, error], [other, larger]] = [told(a), told(b)];
        work.total_cmp(&other).then(error.total_cmp(&larger))
    };
    rows.sort_by(|a, b| a.rank().cmp(&b.rank()).then_with(|| by_work(a, b)));
    let ended = if rows.iter().any(Compares::converged) { Exit::Well } else { Exit::NotConverged };
    let [dofs, retained] = [discretisation.system.dofs(), discretisation.condensed.retained()];
    let compared = Compared { case: case.name.clone(), dofs, retained, formulations: rows };
    let to_stdout = arguments.json.as_deref() == Some(Path::new(STDOUT));
    if !to_stdout {
        print(&compared);
    }
    let drawn = arguments.plot.as_ref().filter(|_| !runs.is_empty());
    let drawing = drawn.map(|_| pictures::compared(&compared.case, &runs));
    let document = Answer::Compared(Box::new(compared)).document();
    match &arguments.json {
        Some(_) if to_stdout => say(document),
        Some(path) => std::fs::write(path, document).map_err(|error| Error::unwritable(path, error))?,
        None => {}
    }
    if let (Some(path), Some(drawing)) = (&arguments.plot, drawing) {
        std::fs::write(path, drawn::svg(&drawing)?).map_err(|error| Error::unwritable(path, error))?;
    }
    Ok(ended)
}

impl Arguments {
    /// The formulations that are asked for, as `solve` takes them.
    fn chosen(&self, case: &Case) -> Result<Vec<Formulation>, Error> {
        let base = match &case.places {
            Some(_) => case.formulation().clone(),
            None => Formulation::accelerated(Element::Node, Iteration::Kinematic),
        };
        let as_typed = |other: Formulation| {
            let is_own = (other.element, other.algorithm) == (base.element, base.algorithm);
            if is_own { base.clone() } else { other.in_place_of(&base) }
        };
        let all: Vec<Formulation> = Formulation::compared().into_iter().map(as_typed).collect();
        let plain = || Formulation::nine().into_iter().map(|paper| paper.in_place_of(&base));
        let known: Vec<Formulation> = all.iter().cloned().chain(plain()).collect();
        let named = |name: &String| {
            known.iter().find(|one| one.name() == *name).cloned().ok_or_else(|| {
                let names: Vec<String> = known.iter().map(Formulation::name).collect();
                let remedy = meant(name, names.iter().map(String::as_str)) + "choose of " + &names.join(", ");
                Error::value("compare", "--formulations", name, "no formulation has this name", remedy)
            })
        };
        let chosen = if self.formulations.is_empty() {
            all
        } else {
            self.formulations.iter().map(named).collect::<Result<_, _>>()?
        };
        let tolerance = |one: Formulation| match self.tolerance {
            Some(tolerance) => one.tolerance(tolerance),
            None => one,
        };
        Ok(chosen.into_iter().map(tolerance).collect())
    }

    /// What one came to.
    fn row(&self, formulation: &Formulation, run: &Result<Run, Error>) -> Compares {
        let (formulation, command) = (formulation.name(), self.command(formulation));
        let run = match run {
            Ok(run) => run,
            Err(error) => {
                let reason = Some(format!("{}: {}", error.message, error.remedy));
                let outcome = "refused".into();
                return Compares { formulation, outcome, reason, command, ..Compares::default() };
            }
        };
        let (solution, work) = (&run.solution, &run.solution.work);
        let reason = match solution.outcome {
            Outcome::Converged if run.is_open() => Some("every candidate is open: nothing presses".into()),
            Outcome::Converged => None,
            outcome => Some(format!("{outcome} after {} iterations", work.iterations)),
        };
        let seconds = run.seconds.iter().find(|(stage, _)| *stage == Stage::Iteration).map(|(_, seconds)| *seconds);
        Compares {
            formulation,
            outcome: if run.is_open() { "no contact".into() } else { solution.outcome.to_string() },
            iterations: Some(work.iterations),
            factorisations: Some(work.factorisations),
            operations: work.operations.into(),
            error: solution.error().largest().into(),
            seconds,
            reason,
            command,
        }
    }

    /// The command that solves the scene by one of them.
    fn command(&self, formulation: &Formulation) -> String {
        let (element, algorithm) = (formulation.element, formulation.algorithm);
        let by_default = Formulation::accelerated(element, algorithm).acceleration;
        let acceleration = Some(formulation.acceleration).filter(|own| *own != by_default);
        let options = [
            ("element", Some(element.name().into())),
            ("algorithm", Some(algorithm.name().into())),
            ("acceleration", acceleration.map(|own| own.name().into())),
            ("tolerance", self.tolerance.map(|tolerance| format!("{tolerance:e}"))),
        ];
        choice::typed(&self.case, options)
    }

    /// Refuses outputs that cannot be written, or by which something would be lost, before anything is solved.
    fn refuse_unwritable(&self, case: &Case) -> Result<(), Error> {
        writable::refuse_plot("compare", &self.plot)?;
        let files = [
            Output::of("--json", &self.json, json::is_comparison),
            Output::of("--plot", &self.plot, drawing::is_drawing),
        ];
        writable::refuse("compare", files, &case.read_files(), self.force)
    }
}

impl Compares {
    /// Whether it gives an answer.
    fn converged(&self) -> bool {
        self.reason.is_none()
    }

    /// Answers first, what is refused last.
    fn rank(&self) -> u8 {
        match (self.converged(), self.iterations) {
            (true, _) => 0,
            (false, Some(_)) => 1,
            (false, None) => 2,
        }
    }
}

/// A line each, and the command of the first.
fn print(compared: &Compared) {
    say(format!("{}: {} dofs, {} retained", compared.case, compared.dofs, compared.retained));
    let head = ["formulation", "outcome", "iterations", "factorisations", "operations", "error", "seconds"];
    let mut table = table(head);
    let count = |number: Option<usize>| number.map_or_else(|| "–".into(), |number| number.to_string());
    for row in &compared.formulations {
        let [error, seconds] = [row.error, row.seconds].map(|number| number.unwrap_or(f64::NAN));
        table.add_row([
            row.formulation.clone(),
            row.outcome.clone(),
            count(row.iterations),
            count(row.factorisations),
            row.operations.map_or_else(|| "–".into(), |operations| format!("{operations:.2e}")),
            if error.is_finite() { markdown::error(error) } else { "–".into() },
            if seconds.is_finite() { markdown::significant(seconds, 2) } else { "–".into() },
        ]);
    }
    say(table);
    for row in &compared.formulations {
        row.reason.iter().for_each(|reason| say(format!("{}: {reason}", row.formulation)));
    }
    match compared.formulations.iter().find(|row| row.converged()) {
        Some(first) => say(format!("with the fewest operations of those that converge:\n  {}", first.command)),
        None => say("none of them converges to a contact"),
    }
}
