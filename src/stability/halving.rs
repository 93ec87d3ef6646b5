//! Kinematic load started with every candidate closed: the contact shrinks from L to a by halving `L² − a²` at each iteration.

/// Below this κ₀ springs are softer than the bodies, and the first iteration halves nothing.
const SOFT: f64 = 0.4;

/// Iterations `1 + ⌈log₂ max(1, (L² − a²)/(2 a h))⌉` until `L` is within a node spacing `h` of `a`, and one more where the start is
/// soft (`κ₀ < 0.4`).
///
/// Where softness begins is read off truncated Hertz: at κ₀ = 0.32 the iteration more is needed (L/a = 1.9), at 0.5 it is one too
/// many (L/a = 3.1).
pub fn iterations(stretch: f64, half_width: f64, spacing: f64, stiffness: f64) -> usize {
    let excess = (stretch * stretch - half_width * half_width) / (2.0 * half_width * spacing);
    let soft = usize::from(stiffness < SOFT);
    1 + excess.max(1.0).log2().ceil() as usize + soft
}
