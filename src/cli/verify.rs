//! `verify DIR`: every scene file of a folder, with its own checks.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::case::{Finding, SceneFile};
use crate::cli::{progress, say, show, suite};
use crate::error::Error;

/// Solves the scene files of a folder in the order of their names, prints the verdicts and tells whether none failed.
///
/// A file that cannot be read or solved fails; the others are solved all the same.
pub fn run(folder: &Path, json: bool) -> Result<bool, Error> {
    let files = scene_files(folder)?;
    let bar = progress(files.len());
    let judged: Vec<Result<Finding, Error>> = files
        .par_iter()
        .map(|file| {
            bar.set_message(file.display().to_string());
            let finding = judge(file);
            bar.inc(1);
            finding
        })
        .collect();
    bar.finish_and_clear();
    Ok(if json { tell_lines(&files, &judged) } else { tell_table(&files, judged) })
}

/// Every check with its verdict, a line of JSON each; a file that is not solved has one line, which fails.
fn tell_lines(files: &[PathBuf], judged: &[Result<Finding, Error>]) -> bool {
    let of_file = |(file, finding): (&PathBuf, &Result<Finding, Error>)| match finding {
        Ok(finding) => suite::lines(&finding.case, &finding.checks),
        Err(error) => vec![suite::broken(&file.display().to_string(), error)],
    };
    suite::tell(&files.iter().zip(judged).flat_map(of_file).collect::<Vec<_>>())
}

fn tell_table(files: &[PathBuf], judged: Vec<Result<Finding, Error>>) -> bool {
    let (mut findings, mut broken) = (Vec::new(), 0);
    for (file, finding) in files.iter().zip(judged) {
        match finding {
            Ok(finding) => findings.push(finding),
            Err(error) => {
                broken += 1;
                show(&error);
                say(format!("{}: not solved", file.display()));
            }
        }
    }
    suite::print(&findings);
    if broken > 0 {
        say(format!("{broken} of {} files not solved", files.len()));
    }
    broken == 0 && suite::all_pass(&findings)
}

fn judge(file: &Path) -> Result<Finding, Error> {
    let scene_file = SceneFile::read(file)?;
    let problem = &scene_file.problem;
    let (discretisation, run, answer) = scene_file.solve()?;
    let mut checks = scene_file.checks(&discretisation, &run)?;
    checks.extend(scene_file.accuracy.iter().zip(&answer).map(|(asked, answer)| answer.check(asked)));
    let name = scene_file.formulation.name();
    Ok(Finding { case: problem.name.clone(), name, run: Some(run), checks, ..Default::default() })
}

fn scene_files(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let failed = |reason: String| Error::File {
        path: folder.into(),
        reason,
        remedy: "give a folder with scene files, *.toml".into(),
    };
    let entries = std::fs::read_dir(folder).map_err(|error| failed(error.to_string()))?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>();
    let mut files = paths.map_err(|error| failed(error.to_string()))?;
    files.retain(|path| path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml")));
    files.sort();
    if files.is_empty() { Err(failed("no scene file is in it".into())) } else { Ok(files) }
}
