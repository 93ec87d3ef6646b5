//! A reading: one choice on every axis; and how a run from one start ends under it.

use serde::Serialize;

use crate::algorithm::{Criterion, Leeway};
use crate::measure::larger;
use crate::named::named_enum;
use crate::solve::{Iteration, Settings};
use crate::study::readings::axes::{CAPS, Candidates, Rule, Stop, THICKNESSES};

named_enum! {
    /// What is open.
    pub enum Axis {
        /// How varying stiffness changes its springs.
        Varying = "varying",
        /// How constant stiffness does.
        Constant = "constant",
        /// How thick layers are.
        Thickness = "thickness",
        /// How far the candidates reach.
        Candidates = "candidates",
        /// When to stop.
        Stop = "stop",
        /// When to give up.
        Cap = "cap",
    }
}

/// One choice on every axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reading {
    /// How varying stiffness changes its springs.
    pub varying: Rule,
    /// How constant stiffness does.
    pub constant: Rule,
    /// Thickness of the layer element over the length of its edge.
    pub thickness: f64,
    /// How far the candidates reach.
    pub candidates: Candidates,
    /// When to stop.
    pub stop: Stop,
    /// When to give up.
    pub cap: usize,
}

impl Reading {
    /// The one nearest to the text and to what it cites: gap elements whose strain drives them (its reference 8), a potential
    /// contact area, contact conditions whose fulfilment is checked; what it does not say as this program has it.
    pub fn nearest() -> Self {
        let Leeway { bound, spring } = Leeway::default();
        let of = |algorithm: Iteration| Rule { algorithm, rule: algorithm.rules()[0], bound, spring };
        let Settings { tolerance, max_iterations, .. } = Settings::default();
        Self {
            varying: of(Iteration::Varying),
            constant: of(Iteration::Constant),
            thickness: THICKNESSES[0],
            candidates: Candidates::Wide,
            stop: Stop { criterion: Criterion::Conditions, tolerance },
            cap: max_iterations,
        }
    }

    /// The rule of an algorithm.
    pub fn rule(&self, algorithm: Iteration) -> Rule {
        match algorithm {
            Iteration::Varying => self.varying,
            Iteration::Constant => self.constant,
            Iteration::Kinematic => Rule::kinematic(),
        }
    }

    /// All.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for varying in Rule::varying() {
            for constant in Rule::constant() {
                for thickness in THICKNESSES {
                    for candidates in Candidates::ALL {
                        for stop in Stop::all() {
                            all.extend(CAPS.map(|cap| Self { varying, constant, thickness, candidates, stop, cap }));
                        }
                    }
                }
            }
        }
        all
    }

    /// Axes on which another reading differs, with what it has there.
    pub fn differences(&self, other: &Self) -> Vec<(Axis, String)> {
        let own = self.choices();
        let others = other.choices().into_iter().zip(Axis::ALL);
        others.zip(own).filter(|((text, _), own)| text != own).map(|((text, axis), _)| (axis, text)).collect()
    }

    /// What it has on every axis, in their order.
    fn choices(&self) -> [String; 6] {
        let candidates = match self.candidates {
            Candidates::Wide => "candidates beyond the contact",
            Candidates::AtEdge => "candidates that end where the contact does",
        };
        [
            format!("varying stiffness by {}", self.varying.name()),
            format!("constant stiffness by {}", self.constant.name()),
            format!("layers of {} edge lengths", self.thickness),
            candidates.to_string(),
            format!("stopped by {}", self.stop.name()),
            format!("given up after {} iterations", self.cap),
        ]
    }

    /// All choices in words.
    pub fn name(&self) -> String {
        self.choices().join(", ")
    }
}

/// A run from one start under a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Iterations until the criterion was met; none where the cap came first.
    pub iterations: Option<usize>,
    /// Error of the peak against the discrete solution then.
    pub error: f64,
    /// Dofs of the condensed system.
    pub retained: usize,
}

impl End {
    /// Operations of `factorisations` dense Cholesky factorisations and a pair of substitutions an iteration.
    pub fn operations(&self, factorises: bool) -> Option<f64> {
        let [n, iterations] = [self.retained as f64, self.iterations? as f64];
        let factorisations = if factorises { iterations } else { 1.0 };
        Some(factorisations * n.powi(3) / 3.0 + 2.0 * iterations * n * n)
    }
}

/// Fewest and most iterations of the starts that ended; none where none did.
pub fn extremes(ends: &[End]) -> Option<[usize; 2]> {
    let iterations = || ends.iter().filter_map(|end| end.iterations);
    Some([iterations().min()?, iterations().max()?])
}

/// Starts that ended.
pub fn ended(ends: &[End]) -> usize {
    ends.iter().filter(|end| end.iterations.is_some()).count()
}

/// Largest error of those.
pub fn error(ends: &[End]) -> f64 {
    ends.iter().filter(|end| end.iterations.is_some()).map(|end| end.error).fold(0.0, larger)
}
