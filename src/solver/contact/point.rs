//! Points at which contact conditions are enforced, and the edges that they belong to.

/// A point at which contact conditions are enforced: a spring with the stiffness `k_n A b bᵀ`, which is the paper's
/// characteristic block (2.2) without friction, `k_t = 0`.
#[derive(Clone, Debug)]
pub struct ContactPoint {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Sparse row `b` on the retained dofs: the approach is `w = b·u`.
    pub row: Vec<(usize, f64)>,
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    pub position: f64,
    /// Tributary area `A` of the modelled part \[mm²\].
    pub weight: f64,
    /// Initial normal gap `g` \[mm\]; negative is interference.
    pub gap: f64,
    /// Initial stiffness over the nominal one, `k_i / k_n`.
    pub relative_stiffness: f64,
    /// Parts of the area that belong to each edge of its contact: (edge index, area \[mm²\]).
    pub shares: Vec<(usize, f64)>,
}

impl ContactPoint {
    /// Approach `w = b·u` \[mm\], positive closing.
    pub fn approach(&self, u: &[f64]) -> f64 {
        self.row.iter().map(|&(dof, value)| value * u[dof]).sum()
    }

    /// `|b|·|u|`: the size of the displacements whose difference the approach is \[mm\].
    pub fn size_of_approach(&self, u: &[f64]) -> f64 {
        self.row.iter().map(|&(dof, value)| (value * u[dof]).abs()).sum()
    }

    /// Adds `factor · b` to a vector on the retained dofs.
    pub fn add_row(&self, factor: f64, out: &mut [f64]) {
        self.row.iter().for_each(|&(dof, value)| out[dof] += factor * value);
    }
}

/// An edge of the first body in the candidate stretch of a contact.
#[derive(Clone, Copy, Debug)]
pub struct ContactEdge {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Contact coordinates where it begins and ends \[mm, or rad on an arc\].
    pub ends: [f64; 2],
    /// Its nodes, 2 to 9.
    pub nodes: usize,
    /// Contact coordinate of the axis of revolution, by the line of its radii; none in the plane, and along the axis.
    pub axis: Option<f64>,
}
