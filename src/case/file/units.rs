//! Names of units, and numbers in them.

/// Factors to mm, N and MPa.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// Millimetres in one unit of length.
    pub length: f64,
    /// Newtons in one unit of force.
    pub force: f64,
    /// Megapascals in one unit of stress.
    pub stress: f64,
}

/// Units of length \[mm\].
pub const LENGTHS: [(&str, f64); 5] = [("m", 1e3), ("cm", 10.0), ("mm", 1.0), ("um", 1e-3), ("in", 25.4)];
/// Units of force \[N\].
pub const FORCES: [(&str, f64); 3] = [("N", 1.0), ("kN", 1e3), ("MN", 1e6)];
/// Units of stress \[MPa\].
pub const STRESSES: [(&str, f64); 4] = [("Pa", 1e-6), ("kPa", 1e-3), ("MPa", 1.0), ("GPa", 1e3)];

impl Units {
    /// Those of the scene: mm, N and MPa.
    pub const SCENE: Self = Self { length: 1.0, force: 1.0, stress: 1.0 };

    /// N/mm³ in one unit of force per volume.
    pub fn specific_weight(&self) -> f64 {
        self.force / self.length.powi(3)
    }
}
