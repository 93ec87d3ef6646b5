//! What is named on the command line: a case, and values of an option that are the members of an enum.

use std::path::Path;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::case::{Case, library};
use crate::error::{Error, Place};

/// The case that a command is given: of the library, for a/R where that is given, or of a scene file, which has none; a
/// folder of the name of a case, which `export` may have made, does not hide it.
pub fn case(command: &str, name: &str, a_over_r: Option<f64>) -> Result<Case, Error> {
    let path = Path::new(name);
    let is_case = library::NAMES.iter().any(|(known, _)| *known == name);
    let is_there = path.exists() && !(path.is_dir() && is_case);
    let is_file = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml")) || is_there;
    match (is_file, a_over_r) {
        (false, _) => library::find(name, a_over_r).map_err(|error| match error.place {
            Place::Nowhere => Error { place: command.into(), ..error },
            _ => error,
        }),
        (true, None) => Case::read(path),
        (true, Some(_)) => {
            Err(Error::at("--a-over-r", "a scene file has no a/R", "leave it out, and set the load in the file"))
        }
    }
}

/// The command that solves a case with some options, as one would type it.
pub fn typed<'a>(case: &str, options: impl IntoIterator<Item = (&'a str, Option<String>)>) -> String {
    let case = if case.contains(' ') { format!("\"{case}\"") } else { case.to_owned() };
    let given = options.into_iter().filter_map(|(name, value)| Some(format!(" --{name} {}", value?)));
    format!("contact-vv solve {case}{}", given.collect::<String>())
}

/// The parser of an option, from all members with their names and the first lines of their documentation as help; other
/// words are refused by clap, which names the members.
pub fn choice<T: Copy + Send + Sync>(
    told: &'static [(T, &'static str, &'static str)],
) -> impl TypedValueParser<Value = T> {
    let value = |(_, name, help): &(T, &'static str, &'static str)| {
        PossibleValue::new(*name).help(help.trim().trim_end_matches('.'))
    };
    PossibleValuesParser::new(told.iter().map(value)).try_map(|given| {
        let found = told.iter().find(|(_, name, _)| *name == given);
        found.map(|(member, ..)| *member).ok_or("no such value")
    })
}
