//! Which stage a solve is in, shown on a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};

use crate::solve::STAGES;

/// The search for a mesh that meets an accuracy.
pub const ACCURACY: &str = "meshes for the accuracy";
/// The stage of the contact iteration.
pub const ITERATION: &str = "iteration";
/// The stage of everything that is written.
pub const OUTPUTS: &str = "outputs";

/// A bar on standard error that goes when the solve ends or breaks off; nothing where that is no terminal.
pub struct Stages(ProgressBar);

impl Stages {
    /// A bar over all stages.
    pub fn new() -> Self {
        let bar = ProgressBar::new(STAGES.len() as u64 + 2).with_finish(ProgressFinish::AndClear);
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(match ProgressStyle::with_template("{spinner} {bar:20} {msg} {elapsed}") {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        })
    }

    /// Moves on to a stage.
    pub fn begin(&self, stage: &'static str) {
        let after = match stage {
            ACCURACY => 0,
            ITERATION => STAGES.len(),
            OUTPUTS => STAGES.len() + 1,
            of_mesh => STAGES.iter().position(|known| *known == of_mesh).unwrap_or(0),
        };
        self.0.set_position(after as u64);
        self.0.set_message(stage);
    }

    /// Removes the bar, so that lines can be printed.
    pub fn end(self) {
        self.0.finish_and_clear();
    }
}
