//! Kinematic load started with every candidate closed: the contact shrinks from L to a by halving `L² − a²` at each iteration.

/// Below this κ₀ springs are softer than the bodies, and the first iteration halves nothing: the median of where the iteration more
/// ceases on meshes of truncated Hertz with candidates beyond the contact.
pub const SOFT: f64 = 0.5;
/// The last iteration confirms what the one before it found.
const FEWEST: f64 = 2.0;

/// Iterations `1 + ⌈log₂ max(2, N)⌉`, `N = (L² − a²)/(2 a h)`, until `L` is within a node spacing `h` of `a`; one more where the start
/// is soft (`κ₀ <` [`SOFT`]) and there is anything to halve, `N > 1`.
///
/// Where a is known, as in Hertz's contact, it is a prediction before the run.
pub fn iterations(stretch: f64, half_width: f64, spacing: f64, stiffness: f64) -> usize {
    let excess = (stretch * stretch - half_width * half_width) / (2.0 * half_width * spacing);
    let soft = usize::from(stiffness < SOFT && excess > 1.0);
    1 + excess.max(FEWEST).log2().ceil() as usize + soft
}
