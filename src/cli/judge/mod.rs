//! `judge CASE ANSWER…`: answers of other codes, on their own meshes, held against the truth of a case.
//!
//! * `options` — what the user asks for.
//! * `told` — the verdicts in a table; `junit` — as test cases.

mod junit;
mod options;
mod told;

use std::fs;

use crate::case::Verdict;
use crate::cli::choice;
use crate::cli::exit::Exit;
use crate::cli::json::{Answer, Line, Refereed};
use crate::cli::terminal::{WIDTH, say};
use crate::error::Error;
use crate::referee::{Truth, Verdicts, picture, read, series, verdicts};
use crate::study::drawn;

pub use options::Arguments;

/// Judges every answer, prints the verdicts and tells how they ended.
pub fn run(arguments: &Arguments) -> Result<Exit, Error> {
    arguments.refuse()?;
    let case = choice::case(&arguments.case, None)?;
    arguments.refuse_unwritable(&case)?;
    let (asked, tolerance) = (arguments.asked()?, arguments.tolerance()?);
    let answers = arguments.answers.iter().map(|file| read::read(file, &case, &asked));
    let answers = answers.collect::<Result<Vec<_>, Error>>()?;
    let truth = Truth::of(case.clone()).map_err(|error| case.located(error))?;
    let judged = answers.into_iter().map(|answer| verdicts(&truth, answer, tolerance));
    let judged = judged.collect::<Result<Vec<Verdicts>, Error>>()?;
    for one in judged.iter().filter(|_| !arguments.series || arguments.json) {
        match (arguments.json, arguments.markdown) {
            (true, _) => {
                let table = told::verdicts(&truth, one, WIDTH);
                say(Answer::Refereed(Refereed::of(&truth, one, table).into()).line());
            }
            (false, true) => say(told::markdown(&truth, one)),
            (false, false) => told::print(&truth, one),
        }
    }
    if let (Some(path), [one]) = (&arguments.plot, judged.as_slice()) {
        let svg = drawn::svg(&picture::sheet(&truth, &one.answer).drawing())?;
        fs::write(path, svg).map_err(|error| Error::unwritable(path, error))?;
    }
    let mut met = judged.iter().all(Verdicts::met);
    let found = if arguments.series { series::all(&truth, &judged) } else { Vec::new() };
    if let Some(path) = &arguments.junit {
        fs::write(path, junit::report(&truth, &judged, &found)).map_err(|error| Error::unwritable(path, error))?;
    }
    if arguments.series {
        // Coarse meshes of a series need not meet the tolerance: the finest and the limits do.
        let goes_there = found.iter().flat_map(|one| &one.along).all(|one| one.judged.verdict != Verdict::Fail);
        met = judged.last().is_some_and(Verdicts::met) && goes_there && !found.is_empty();
        for series in &found {
            let lines = series.along.iter().map(|one| Answer::Line(Line::of("series", &one.judged).into()).line());
            match arguments.json {
                true => lines.for_each(say),
                false => told::series(&truth, series),
            }
        }
    }
    Ok(Exit::checked(met))
}
