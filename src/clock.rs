//! Seconds by stage of the chain.

use std::time::Instant;

/// A clock that is read at the end of each stage.
#[derive(Clone, Debug)]
pub struct Clock {
    last: Instant,
    /// Stages with their seconds, in order.
    pub laps: Vec<(&'static str, f64)>,
}

impl Clock {
    /// A clock that runs from now on.
    pub fn start() -> Self {
        Self { last: Instant::now(), laps: Vec::new() }
    }

    /// Ends a stage.
    pub fn lap(&mut self, stage: &'static str) {
        self.laps.push((stage, self.last.elapsed().as_secs_f64()));
        self.last = Instant::now();
    }

    /// Enters stages that were read elsewhere since the last one.
    pub fn take(&mut self, laps: &[(&'static str, f64)]) {
        self.laps.extend_from_slice(laps);
        self.last = Instant::now();
    }
}
