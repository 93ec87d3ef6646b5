//! Where the closed stretches of a contact are expected to end.

/// Places on which mesh lines shall lie, with layers of ever smaller cells towards them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ends {
    /// Contact coordinates, ascending; none where the mesh knows nothing of the contact \[mm, or rad on an arc\].
    pub places: Vec<f64>,
    /// Layers of cells towards each, every one [`LAYER`] times as wide as the one before.
    pub layers: usize,
    /// How far they may lie from where the contact ends, over its half-width.
    pub off: f64,
}

/// Width of a layer of cells over that of the one around it.
///
/// Towards a square root the best factor of cells of high order is about 0.15 to 0.4, and flat (Babuška & Guo 1988).
pub const LAYER: f64 = 0.35;
