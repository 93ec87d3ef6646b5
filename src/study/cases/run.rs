//! A run of a case, with its judged checks.

use std::sync::{Arc, OnceLock};

use serde::Serialize;

use crate::case::{Case, Judged, Meshed};
use crate::error::Error;
use crate::solve::{Formulation, Run};

/// A case solved by one formulation.
#[derive(Clone, Serialize)]
pub struct Numbers {
    /// The case.
    #[serde(skip)]
    pub case: Arc<Case>,
    /// The run.
    pub run: Run,
    /// Its checks; they need the mesh, which is not kept.
    #[serde(skip)]
    judged: Vec<Judged>,
}

impl std::fmt::Debug for Numbers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Numbers").field("case", &self.case.name).field("run", &self.run).finish_non_exhaustive()
    }
}

/// The mesh of a case, made by whichever formulation comes first.
pub(super) type Shared = Arc<OnceLock<Result<Meshed, Error>>>;

/// Runs and judges a formulation.
pub(super) fn run(case: &Arc<Case>, mesh: &Shared, formulation: &Formulation) -> Result<Numbers, Error> {
    let meshed = mesh.get_or_init(|| case.meshed()).as_ref().map_err(Error::clone)?;
    let run = case.run(meshed, formulation)?;
    let mut judged = case.judge(meshed, &run)?;
    // Once for all formulations: the closed form is that of the scene.
    if formulation.name() == case.formulation().name() {
        judged.extend(case.held_to_closed_forms(meshed, &run)?);
    }
    Ok(Numbers { case: case.clone(), run, judged })
}

/// The checks of the case, and those of every run.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(numbers.judged.clone())
}
