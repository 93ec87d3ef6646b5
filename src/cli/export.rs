//! `export CASE DIR`: all that is needed to run a case elsewhere, and to hand the answer in.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use serde::Serialize;

use crate::case::Case;
use crate::cli::solve::curve;
use crate::cli::terminal::say;
use crate::cli::writable::{self, Output};
use crate::cli::{choice, vtu};
use crate::error::Error;
use crate::referee::Truth;
use crate::referee::document::{Document, schema};
use crate::referee::export::{condensed, deck, gmsh, own, problem};
use crate::solve::{Formulation, Run};
use crate::study::{references, sheet};

/// Arguments of `export`.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Case of the library (`list` names them), or a scene file.
    pub case: String,
    /// Folder to write into; it is made where it is not there.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Replace files there that hold something else than what is written; files that the scene reads are never
    /// replaced.
    #[arg(long)]
    pub force: bool,
    /// Write condensed.npz too: the condensed matrices, gaps, areas and loads with our solution, for algorithms of
    /// others.
    #[arg(long)]
    pub condensed: bool,
}

/// Writes the files, and names them.
pub fn run(arguments: &Arguments) -> Result<(), Error> {
    let mut case = choice::case("export", &arguments.case, None)?;
    // Other codes read cells of 4 and 8 nodes, which an accuracy is reached with too.
    case.accuracy.iter_mut().for_each(|asked| asked.high_order = false);
    let folder = &arguments.folder;
    writable::folder(folder, "name a folder that may be written")?;
    let written = files(&case, arguments.condensed).map_err(|error| case.located(error))?;
    let paths: Vec<PathBuf> = written.iter().map(|(name, ..)| folder.join(name)).collect();
    // The folders above an export are made with it.
    let there = paths.iter().zip(&written).filter(|_| folder.exists());
    let files = there.map(|(path, (_, text, _))| {
        let is_earlier = Box::new(move |there: &[u8]| there == text);
        Some(Output { option: "file", path, is_earlier })
    });
    writable::refuse("export", files, &case.read_files(), arguments.force)?;
    fs::create_dir_all(folder).map_err(|error| Error::unwritable(folder, error))?;
    for (path, (_, text, what)) in paths.iter().zip(written) {
        fs::write(path, text).map_err(|error| Error::unwritable(path, error))?;
        say(format!("{}: {what}", path.display()));
    }
    Ok(())
}

/// Name, content and what it is of a file.
type Written = (String, Vec<u8>, &'static str);

/// Every file.
pub fn files(case: &Case, condensed: bool) -> Result<Vec<Written>, Error> {
    let discretisation = case.meshed()?.discretisation;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let named = |ending: &str| format!("{}{ending}", plain(&case.name));
    let mut sheet = sheet(case)?;
    if condensed {
        sheet += &format!("\n{}", condensed::TEXT);
    }
    let table = curve::profile(&discretisation.scene, &run, Path::new("ours.csv"))?;
    let scripts =
        problem::scripts(&case.scene).iter().map(|(name, text, what)| (name.to_string(), text.to_string(), *what));
    let files = vec![
        (named(".md"), sheet, "sheet: scene, equations, reference values"),
        (named(".msh"), gmsh::text(&discretisation.scene, &discretisation.mesh), "mesh for Gmsh 4.1"),
        (named(".inp"), deck::text(&discretisation)?, "input deck for CalculiX or Abaqus"),
        (named(".vtu"), vtu::text(&discretisation, &run)?, "mesh with our own fields for ParaView"),
        (
            "problem.json".into(),
            problem::text(&case.name, &discretisation)?,
            "the problem as plain numbers, for scripts",
        ),
        ("answer.json".into(), to_fill_in(&own::template(&case.name, &discretisation)), "to be filled in, and judged"),
        ("answer-schema.json".into(), schema() + "\n", "what it may hold"),
        ("ours.json".into(), document(&own::answer(&case.name, &discretisation, &run)), "our own answer on this mesh"),
        ("ours.csv".into(), table, "the same as a table"),
    ];
    let bytes = |(name, text, what): (String, String, _)| -> Written { (name, text.into_bytes(), what) };
    let matrices = condensed.then(|| {
        (
            condensed::FILE.into(),
            condensed::npz(&discretisation, &run),
            "condensed matrices and our solution, for NumPy",
        )
    });
    Ok(files.into_iter().chain(scripts).map(bytes).chain(matrices).collect())
}

/// The text of its sheet, which is made anew for a scene file.
fn sheet(case: &Case) -> Result<String, Error> {
    let is_built_in = case.places.is_none();
    if let Some(made) = sheet::of_library(&case.name).filter(|_| is_built_in) {
        return Ok(made.into());
    }
    let truth = Truth::of(case.clone())?;
    Ok(sheet::file(&references::sheet(case, &truth.discretisation, &truth.run, &truth.bars, &Default::default())?).1)
}

fn document(content: &impl Serialize) -> String {
    serde_json::to_string_pretty(content).expect("numbers, strings and lists can be written as JSON") + "\n"
}

/// With empty lists of pressures and gaps.
fn to_fill_in(template: &Document) -> String {
    let mut value = serde_json::to_value(template).expect("numbers, strings and lists can be written as JSON");
    for contact in value["contacts"].as_array_mut().into_iter().flatten() {
        ["pressure", "gap"].into_iter().for_each(|list| contact[list] = serde_json::Value::Array(vec![]));
    }
    document(&value)
}

/// A name for files, of letters that every code takes; `case` where it has none of them.
fn plain(name: &str) -> String {
    let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    if !stem.contains(|letter: char| letter.is_ascii_alphanumeric()) {
        return "case".into();
    }
    stem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '-' }).collect()
}
