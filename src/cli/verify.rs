//! `verify PATH…`: scene files, and those of folders, with their own checks.

use std::path::{Path, PathBuf};

use comfy_table::Table;
use rayon::prelude::*;

use crate::case::{Case, Judged, Scope, Verdict, file, judged};
use crate::cli::exit::Exit;
use crate::cli::json::Line;
use crate::cli::suite;
use crate::cli::terminal::{progress, say, show, table};
use crate::error::Error;
use crate::markdown;
use crate::solve::Run;

/// A file that was solved, with its checks.
type Verified = (Case, Run, Vec<Judged>);

/// Solves scene files in the order of their names, prints the verdicts and tells how they ended.
///
/// A file that cannot be read or solved is wrong input; the others are solved all the same.
pub fn run(paths: &[PathBuf], json: bool) -> Result<Exit, Error> {
    let mut files = Vec::new();
    for path in paths {
        files.extend(if path.is_dir() { file::files_in(path)? } else { vec![path.clone()] });
    }
    // Of files of one name in several folders the path tells which.
    let is_alone = |file: &Path| files.iter().filter(|other| other.file_stem() == file.file_stem()).count() == 1;
    let bar = progress(files.len());
    let verified: Vec<Result<Verified, Error>> = files
        .par_iter()
        .map(|file| {
            bar.set_message(file.display().to_string());
            let name = (!is_alone(file)).then(|| file.display().to_string());
            let verified = verify(file, name);
            bar.inc(1);
            verified
        })
        .collect();
    bar.finish_and_clear();
    if json {
        tell_lines(&files, &verified)
    } else {
        tell_table(&files, &verified)
    }
    let ended = verified
        .iter()
        .flatten()
        .map(|(_, run, checks)| Exit::of(run, Exit::checked(judged::worst(checks) != Some(&Verdict::Fail))))
        .max();
    match verified.into_iter().find_map(Result::err) {
        Some(error) => Err(error),
        None => Ok(ended.unwrap_or(Exit::Well)),
    }
}

/// Every check with its verdict, a line of JSON each; a file that is not solved has one line, which fails.
fn tell_lines(files: &[PathBuf], verified: &[Result<Verified, Error>]) {
    for (file, one) in files.iter().zip(verified) {
        let lines = match one {
            Ok((case, _, judged)) => suite::lines(&case.name, judged),
            Err(error) => vec![Line::broken(&file.display().to_string(), error)],
        };
        suite::tell(lines);
    }
}

/// A row for each file, one for each of its own checks, then what did not pass: its own checks apart from what every
/// run must satisfy.
fn tell_table(files: &[PathBuf], verified: &[Result<Verified, Error>]) {
    let mut table = table(["file", "formulation", "outcome", "iterations", "its own checks", "checks of every run"]);
    for (case, run, judged) in verified.iter().flatten() {
        let outcome = run.solution.outcome.to_string();
        let counted = [Scope::Own, Scope::Universal].map(|scope| counted(judged, scope));
        let iterations = run.solution.work.iterations.to_string();
        let first = vec![case.name.clone(), case.formulation().name(), outcome, iterations];
        table.add_row([first, counted.into()].concat());
    }
    // A head without rows says nothing: no file was solved, or none has checks of its own.
    [table, checks(verified)].into_iter().filter(|table| !table.is_empty()).for_each(say);
    for (case, run, judged) in verified.iter().flatten() {
        let name = &case.name;
        case.notes(run, &[]).iter().for_each(|note| say(format!("{name}: note: {note}")));
        for one in judged.iter().filter(|one| one.verdict != Verdict::Pass) {
            say(match one.check.scope {
                Scope::Own => told(name, one),
                Scope::Universal => {
                    told(&format!("{name}, not by the file's own checks but by those of every run"), one)
                }
            });
        }
    }
    let broken = verified.iter().filter(|one| one.is_err()).count();
    for (file, one) in files.iter().zip(verified) {
        // The last one is told as the error of the command.
        if let (Err(error), true) = (one, broken > 1) {
            show(error);
            say(format!("{}: not solved", file.display()));
        }
    }
    if broken > 0 {
        say(format!("{broken} of {} files not solved", files.len()));
    }
}

/// The files' own checks: what was found with its error bar, and the error beside that bar, in the terms of the check.
fn checks(verified: &[Result<Verified, Error>]) -> Table {
    let mut table = table(["file", "check", "value ± error bar", "reference", "error", "bar", "at most", "verdict"]);
    for (case, _, judged) in verified.iter().flatten() {
        for one in judged.iter().filter(|one| one.check.scope == Scope::Own) {
            let bar = one.bar_as_error().map_or_else(|| "–".into(), error_bar);
            table.add_row([
                case.name.clone(),
                one.check.quantity.to_string(),
                markdown::with_bar(one.value, one.bar),
                markdown::value(one.reference.value),
                markdown::error(one.error),
                bar,
                markdown::error(one.check.tolerance),
                one.verdict.to_string(),
            ]);
        }
    }
    table
}

/// An error bar in the terms of a check's error.
fn error_bar(bar: f64) -> String {
    if bar.is_nan() { "unknown".into() } else { markdown::error(bar) }
}

fn counted(judged: &[Judged], scope: Scope) -> String {
    let own = || judged.iter().filter(|one| one.check.scope == scope);
    let failed = own().filter(|one| one.verdict == Verdict::Fail).count();
    match (own().count(), failed) {
        (0, _) => "none".into(),
        (all, 0) => format!("{all} passed"),
        (all, failed) => format!("{failed} of {all} FAILED"),
    }
}

/// A check with its numbers, behind the name of its file.
pub fn told(name: &str, check: &Judged) -> String {
    format!("{name}: {}", verdict(check))
}

/// A check with its verdict and its numbers.
pub fn verdict(check: &Judged) -> String {
    let limit = if check.check.tolerance > 0.0 {
        format!(", at most {}", markdown::error(check.check.tolerance))
    } else {
        String::new()
    };
    let bar = check.bar_as_error().map_or_else(String::new, |bar| format!(", bar {}", error_bar(bar)));
    format!(
        "{} — {}: {} is {}, reference {}, error {}{bar}{limit}",
        check.verdict,
        check.requirement(),
        check.check.quantity,
        markdown::with_bar(check.value, check.bar),
        markdown::value(check.reference.value),
        markdown::error(check.error),
    )
}

/// Solves a file, under a name of its own where that is given.
fn verify(file: &Path, name: Option<String>) -> Result<Verified, Error> {
    let case = Case::read(file)?;
    let case = match name {
        Some(name) => case.named(name),
        None => case,
    };
    let (meshed, run) = case.solve()?;
    let judged = case.judge(&meshed, &run)?;
    Ok((case, run, judged))
}
