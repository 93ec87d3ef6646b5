//! Which stage a solve is in, shown on a terminal.

use std::borrow::Cow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressFinish};

use crate::accuracy::{Next, in_percent};
use crate::cli::terminal::styled;
use crate::clock::Stage;
use crate::markdown::significant;

/// A bar on standard error that goes when the solve ends or breaks off; nothing where that is no terminal.
pub struct Stages {
    bar: ProgressBar,
    /// Dofs of the largest mesh that was announced.
    announced: AtomicUsize,
}

impl Stages {
    /// A bar over all stages.
    pub fn new() -> Self {
        let bar = ProgressBar::new(Stage::ALL.len() as u64).with_finish(ProgressFinish::AndClear);
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { bar: styled(bar, "{spinner} {bar:20} {msg} {elapsed}"), announced: AtomicUsize::new(0) }
    }

    /// Moves on to a stage.
    pub fn begin(&self, stage: Stage) {
        self.show(stage, stage.name());
    }

    /// Shows the search for a mesh that meets an accuracy, before all stages.
    pub fn search(&self) {
        self.show(Stage::Mesh, "meshes for the accuracy");
    }

    /// Shows the next mesh of that search; one that takes long is announced, also where there is no terminal.
    pub fn next(&self, next: &Next) {
        self.show(Stage::Mesh, format!("mesh of {} dofs", next.dofs));
        // Smaller ones after it are those of its error bars.
        if next.is_long() && next.dofs > self.announced.fetch_max(next.dofs, Ordering::Relaxed) {
            self.bar.suspend(|| eprintln!("{}", announced(next)));
        }
    }

    /// Shows that everything is being recovered and written, after the iteration.
    pub fn write(&self) {
        self.show(Stage::Recovery, "outputs");
    }

    fn show(&self, stage: Stage, message: impl Into<Cow<'static, str>>) {
        self.bar.set_position(stage as u64);
        self.bar.set_message(message);
    }

    /// Removes the bar, so that lines can be printed.
    pub fn end(self) {
        self.bar.finish_and_clear();
    }
}

/// What is solved next, how long that may take, and why.
fn announced(Next { dofs, seconds, estimate, asked }: &Next) -> String {
    let takes = if seconds.is_nan() { String::new() } else { format!(", some {} s", seconds.ceil()) };
    let why = match estimate {
        unknown if unknown.is_nan() => "no error bar is known yet".to_owned(),
        known => format!("the error bar of the mesh before is {} %", significant(100.0 * known, 2)),
    };
    let asked = in_percent(*asked);
    format!("solves a mesh of {dofs} dofs next{takes}: {why}, and {asked} % is asked; --max-dofs bounds what is solved")
}
