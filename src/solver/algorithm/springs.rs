//! The springs between two iterations, and what an iteration with them finds.

/// The springs as they stand between two iterations.
#[derive(Clone, Debug)]
pub struct Springs {
    /// Stiffness `k` per area of each point [MPa/mm]; zero is open.
    pub stiffness: Vec<f64>,
    /// Force per area `r` carried by each point beside its spring \[MPa\].
    pub force: Vec<f64>,
}

/// What one iteration finds.
#[derive(Clone, Debug)]
pub struct Iterate {
    /// Displacements of the retained dofs \[mm\].
    pub displacement: Vec<f64>,
    /// Approach of each point \[mm\].
    pub approach: Vec<f64>,
    /// Spring force per area of each point, tension negative \[MPa\].
    pub pressure: Vec<f64>,
    /// Internal force `S u` of the displacements \[N\].
    pub internal: Vec<f64>,
}
