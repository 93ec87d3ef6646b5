//! Seconds by stage of the chain, and who is told as each begins.

use std::time::Instant;

use crate::named::named_enum;

named_enum! {
    /// A stage of the chain.
    pub enum Stage {
        /// The bodies are meshed.
        Mesh = "mesh",
        /// Unknowns are numbered in the order of elimination.
        Ordering = "ordering",
        /// Cells are integrated and assembled.
        Assembly = "assembly",
        /// Where the sparse factor has entries is found.
        Analysis = "analysis",
        /// The bodies are factorised.
        Factorisation = "factorisation",
        /// Their loads are eliminated forwards.
        ForwardElimination = "forward elimination",
        /// Condensed stiffness and load are gathered.
        SchurComplement = "Schur complement",
        /// Candidates are paired.
        Interface = "interface",
        /// The contact problem is iterated.
        Iteration = "iteration",
        /// Displacements are recovered.
        Recovery = "recovery",
    }
}

/// Seconds by stage, in the order in which they first began.
pub type Seconds = Vec<(Stage, f64)>;

/// What times the stages of a chain that knows nothing of it.
pub struct Clock<'a> {
    /// Told as a stage begins; of several bodies, for each of them.
    begins: &'a dyn Fn(Stage),
    /// What the stages took so far, all bodies together.
    pub seconds: Seconds,
}

impl<'a> Clock<'a> {
    /// A clock that tells nobody.
    pub fn silent() -> Self {
        Self::telling(&|_| ())
    }

    /// A clock that tells of every stage as it begins.
    pub fn telling(begins: &'a dyn Fn(Stage)) -> Self {
        Self { begins, seconds: Vec::new() }
    }

    /// The same with what other stages took before.
    pub fn after(self, seconds: &[(Stage, f64)]) -> Self {
        Self { seconds: seconds.to_vec(), ..self }
    }

    /// What a stage returns.
    pub fn time<T>(&mut self, stage: Stage, work: impl FnOnce() -> T) -> T {
        (self.begins)(stage);
        let begun = Instant::now();
        let done = work();
        let taken = begun.elapsed().as_secs_f64();
        match self.seconds.iter_mut().find(|(known, _)| *known == stage) {
            Some((_, seconds)) => *seconds += taken,
            None => self.seconds.push((stage, taken)),
        }
        done
    }
}
