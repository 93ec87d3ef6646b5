//! What is run: every case under each of its formulations.

use std::path::PathBuf;
use std::sync::Arc;

use crate::case::{Case, file, library};
use crate::checkout::root;
use crate::error::Error;
use crate::solve::Formulation;
use crate::study::Planned;
use crate::study::cases::run::{Numbers, Shared, run};

/// All cases of the library, then the scene files of the checkout.
pub fn plan() -> Vec<Planned<Numbers>> {
    let built_in = library::all().into_iter().flat_map(trials);
    built_in.chain(files().unwrap_or_else(|error| vec![broken("scene files", error)])).collect()
}

fn files() -> Result<Vec<Planned<Numbers>>, Error> {
    let files = file::files_in(&root().join("tests/cases"))?;
    let of = |path: PathBuf| {
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        match Case::read(&path) {
            Ok(case) => trials(case.named(name)),
            Err(error) => vec![broken(&name, error)],
        }
    };
    Ok(files.into_iter().flat_map(of).collect())
}

/// A trial that ends in an error: what could not be read is not left out.
fn broken(case: &str, error: Error) -> Planned<Numbers> {
    Planned::new(case, "reading", move || Err(error.clone()))
}

/// The trials of one case.
fn trials(case: Case) -> Vec<Planned<Numbers>> {
    let (case, mesh) = (Arc::new(case), Shared::default());
    let trial = |formulation: &Formulation| {
        let (case, mesh, formulation) = (case.clone(), mesh.clone(), formulation.clone());
        Planned::new(case.name.clone(), title(&formulation), move || run(&case, &mesh, &formulation))
    };
    case.formulations.iter().map(trial).collect()
}

/// Name of a trial: the formulation, and its increments where there are several.
fn title(formulation: &Formulation) -> String {
    match formulation.settings.increments {
        0 | 1 => formulation.name(),
        several => format!("{}, {several} increments", formulation.name()),
    }
}
