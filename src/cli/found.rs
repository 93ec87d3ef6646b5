//! What `solve` found.

use crate::accuracy::{Barred, Bars};
use crate::case::{Case, Judged};
use crate::cli::reactions::ReactionReading;
use crate::mesh::Resolution;
use crate::solve::Run;

/// What a solve found, as it is told.
pub struct Found<'a> {
    /// Scene and oracle.
    pub problem: &'a Case,
    /// How fine the mesh is.
    pub resolution: Resolution,
    /// The run.
    pub run: &'a Run,
    /// What its supports exert.
    pub reactions: Vec<ReactionReading>,
    /// How far each number may be from the truth; none where that was not asked for.
    pub bars: Option<Bars>,
    /// The file's own checks, and that of the accuracy asked for.
    pub checks: Vec<Judged>,
}

impl Found<'_> {
    /// What closed forms say that the run contradicts.
    pub fn notes(&self) -> Vec<String> {
        let bars: &[Barred] = self.bars.as_ref().map_or(&[], |bars| &bars.all);
        self.problem.notes(self.run, bars)
    }
}
