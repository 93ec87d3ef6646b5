//! Which state of an analysis a block of results is of, and which one is judged: the last, unless another is asked for.

use std::fmt;
use std::path::Path;

use crate::error::Error;
use crate::referee::asked::Asked;
use crate::referee::source::Source;

/// A state: the end of an increment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Step, from 1, and increment within it; none where the file does not say them.
    pub step: Option<[usize; 2]>,
    /// Time of the analysis.
    pub time: f64,
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some([step, increment]) = self.step {
            write!(f, "step {step}, increment {increment}, ")?;
        }
        write!(f, "time {}", self.time)
    }
}

/// Difference of times, over the time, that the digits of a file leave.
const SAME: f64 = 1e-5;
/// Most states that a message names.
const SHOWN: usize = 12;

impl State {
    /// Whether it is of the same time.
    pub fn is_at(&self, time: f64) -> bool {
        (self.time - time).abs() <= SAME * time.abs().max(self.time.abs())
    }

    /// Refuses to choose in a file of one state.
    pub fn only(file: &Path) -> Error {
        let remedy = "leave them out: they choose among those of a .frd or .dat of CalculiX, of a .pvd, or of a \
            table's column `time`, `step` or `frame`";
        Error::file(file, "--time and --step are asked for, and it has one state", remedy)
    }

    /// The place of the state that is asked for among those of the results that are read; the last one where none is.
    pub fn chosen(source: &Source, of: &[Self], asked: &Asked) -> Result<usize, Error> {
        let is_it = |state: &Self| {
            asked.time.is_none_or(|time| state.is_at(time))
                && asked.step.is_none_or(|step| state.step.is_some_and(|[own, _]| own == step))
        };
        let refused = || {
            let first = of.len().saturating_sub(SHOWN);
            let known: Vec<String> = of[first..].iter().map(Self::to_string).collect();
            let cut = if first > 0 { "…; " } else { "" };
            let [what, by] = match asked.step.is_some() && of.iter().all(|state| state.step.is_none()) {
                true => ["it tells the times of its states, and not the steps that --step asks for", "--time"],
                false => ["it has no results of the time or step that is asked for", "--time or --step"],
            };
            source.refused(what, format!("name one of those it has by {by}: {cut}{}", known.join("; ")))
        };
        of.iter().rposition(is_it).ok_or_else(refused)
    }

    /// What is to be said where it is not that of the end of the last step: a later one is there, or its time lies
    /// within a step of the usual length 1.
    pub fn notes(&self, all: &[Self]) -> Vec<String> {
        let last = all.iter().map(|state| state.time).fold(self.time, f64::max);
        let later = !self.is_at(last);
        let within = !self.is_at(self.time.round()) || self.is_at(0.0);
        let later = later.then(|| format!("the answer is of {self}, and its file goes on to time {last}"));
        let within = within.then(|| {
            format!(
                "the answer is of {self}, which is not the end of a step of length 1: if its steps have that \
                length, it has not the whole load of the scene"
            )
        });
        later.into_iter().chain(within).collect()
    }
}
