//! `judge CASE ANSWER…`: answers of other codes, on their own meshes, held against the truth of a case.
//!
//! * `options` — what the user asks for.
//! * `told` — the verdicts in a table, and as test cases.

mod options;
mod told;

use std::fs;

use crate::case::Verdict;
use crate::cli::choice;
use crate::cli::exit::Exit;
use crate::cli::json::{Answer, Line, Refereed};
use crate::cli::terminal::{WIDTH, say, show};
use crate::error::Error;
use crate::referee::series::{self, Series};
use crate::referee::{Truth, Verdicts, picture, read, verdicts};
use crate::study::drawn;

pub use options::Arguments;

/// Judges every answer, prints the verdicts and tells how they ended.
///
/// An answer that cannot be read or judged is wrong input; the others are judged all the same, but make no series.
pub fn run(arguments: &Arguments) -> Result<Exit, Error> {
    arguments.refuse()?;
    let case = choice::case("judge", &arguments.case, None)?;
    arguments.refuse_unwritable(&case)?;
    let (asked, tolerance) = (arguments.asked()?, arguments.tolerance()?);
    let (mut answers, mut judged, mut wrong) = (Vec::new(), Vec::new(), Vec::new());
    for file in &arguments.answers {
        match read::read(file, &case, &asked) {
            Ok(answer) => answers.push(answer),
            Err(error) => wrong.push((file.clone(), error)),
        }
    }
    // Nothing is solved where no answer is read.
    let truth = (!answers.is_empty()).then(|| Truth::of(case.clone())).transpose();
    let truth = truth.map_err(|error| case.located(error))?;
    for answer in answers {
        let Some(truth) = &truth else { break };
        let file = answer.file.clone();
        match verdicts(truth, answer, tolerance) {
            // Where one contact is asked for, no other is wanted.
            Ok(verdicts) if asked.contact.is_some() => judged.push(Verdicts { absent: vec![], ..verdicts }),
            Ok(verdicts) => judged.push(verdicts),
            Err(error) => wrong.push((file, error)),
        }
    }
    let found = match &truth {
        Some(truth) => told(arguments, truth, &judged, wrong.is_empty())?,
        None => Vec::new(),
    };
    if let Some(path) = &arguments.junit {
        let report = told::report(&case, &judged, &wrong, &found);
        fs::write(path, report).map_err(|error| Error::unwritable(path, error))?;
    }
    if let Some((_, last)) = wrong.pop() {
        wrong.iter().for_each(|(_, error)| show(error));
        return Err(last);
    }
    if !arguments.series {
        return Ok(Exit::checked(judged.iter().all(Verdicts::met)));
    }
    // Coarse meshes of a series need not meet the tolerance: the finest and the limits do.
    let goes_there = found.iter().flat_map(|one| &one.along).all(|one| one.judged.verdict != Verdict::Fail);
    Ok(Exit::checked(judged.last().is_some_and(Verdicts::met) && goes_there && !found.is_empty()))
}

/// Prints the verdicts, draws the answer, and prints the series that they are where they are all there.
fn told(arguments: &Arguments, truth: &Truth, judged: &[Verdicts], are_all: bool) -> Result<Vec<Series>, Error> {
    let in_series = arguments.series && are_all;
    for one in judged.iter().filter(|_| !in_series || arguments.json) {
        match (arguments.json, arguments.markdown) {
            (true, _) => {
                let table = told::verdicts(truth, one, WIDTH);
                say(Answer::Refereed(Refereed::of(truth, one, table).into()).line());
            }
            (false, true) => say(told::markdown(truth, one)),
            (false, false) => told::print(truth, one),
        }
    }
    if let (Some(path), [one]) = (&arguments.plot, judged) {
        let svg = drawn::svg(&picture::sheet(truth, &one.answer).drawing())?;
        fs::write(path, svg).map_err(|error| Error::unwritable(path, error))?;
    }
    let found = if in_series { series::all(truth, judged) } else { Vec::new() };
    for series in &found {
        let lines = series.along.iter().map(|one| Answer::Line(Line::of("series", &one.judged).into()).line());
        match arguments.json {
            true => lines.for_each(say),
            false => told::series(truth, series),
        }
    }
    Ok(found)
}
