//! What is run: every case under each of its formulations.

use std::sync::Arc;

use crate::case::{Case, library};
use crate::solve::Formulation;
use crate::study::Planned;
use crate::study::cases::run::{Numbers, Shared, run};

/// All cases of the library.
pub fn plan() -> Vec<Planned<Numbers>> {
    library::all().into_iter().flat_map(trials).collect()
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
