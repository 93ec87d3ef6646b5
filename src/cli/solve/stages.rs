//! Which stage a solve is in, shown on a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};

use crate::clock::Stage;

/// A bar on standard error that goes when the solve ends or breaks off; nothing where that is no terminal.
pub struct Stages(ProgressBar);

impl Stages {
    /// A bar over all stages.
    pub fn new() -> Self {
        let bar = ProgressBar::new(Stage::ALL.len() as u64).with_finish(ProgressFinish::AndClear);
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(match ProgressStyle::with_template("{spinner} {bar:20} {msg} {elapsed}") {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        })
    }

    /// Moves on to a stage.
    pub fn begin(&self, stage: Stage) {
        self.show(stage, stage.name());
    }

    /// Shows the search for a mesh that meets an accuracy, before all stages.
    pub fn search(&self) {
        self.show(Stage::Mesh, "meshes for the accuracy");
    }

    /// Shows that everything is being recovered and written, after the iteration.
    pub fn write(&self) {
        self.show(Stage::Recovery, "outputs");
    }

    fn show(&self, stage: Stage, message: &'static str) {
        self.0.set_position(stage as u64);
        self.0.set_message(message);
    }

    /// Removes the bar, so that lines can be printed.
    pub fn end(self) {
        self.0.finish_and_clear();
    }
}
