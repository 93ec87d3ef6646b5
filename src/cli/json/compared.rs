//! Formulations of one scene side by side, as JSON and as lines.

use schemars::JsonSchema;
use serde::Serialize;

/// Formulations of one scene, the one with the fewest operations first: the result of `compare`.
#[derive(Serialize, JsonSchema)]
pub struct Compared {
    /// Name of the case, or of the scene file.
    pub case: String,
    /// Degrees of freedom.
    #[serde(rename = "freedoms")]
    pub dofs: usize,
    /// Normal degrees of freedom that the condensation retains.
    pub retained: usize,
    /// Each formulation: those that converge by their operations, of equal ones by their error, then those that do
    /// not, then those that are refused.
    pub formulations: Vec<Compares>,
}

/// What one formulation came to.
#[derive(Default, Serialize, JsonSchema)]
pub struct Compares {
    /// Its name.
    pub formulation: String,
    /// How its iteration ended; `no contact` where nothing presses, `refused` where it does not begin or cannot go on.
    pub outcome: String,
    /// Iterations; null where it was refused.
    #[serde(rename = "steps")]
    pub iterations: Option<usize>,
    /// Factorisations of the condensed stiffness.
    pub factorisations: Option<usize>,
    /// Operations of its factorisations and back-substitutions.
    pub operations: Option<f64>,
    /// Largest error of peak, force, width and approach against the discrete solution.
    pub error: Option<f64>,
    /// Seconds of its iteration.
    pub seconds: Option<f64>,
    /// Why it gives no answer; null where it does.
    pub reason: Option<String>,
    /// The command that solves the scene by it.
    pub command: String,
}
