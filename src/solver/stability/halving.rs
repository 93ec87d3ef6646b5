//! Kinematic load started with every candidate closed: the contact shrinks from L to a by halving `L² − a²` at each
//! iteration, and on bodies of revolution to what presses of contact that is kept up to L.

/// Below this κ₀ springs are softer than the bodies, and the first iteration halves nothing: the median of where the
/// iteration more ceases on meshes of truncated Hertz with candidates beyond the contact.
pub const SOFT: f64 = 0.5;
/// The last iteration confirms what the one before it found.
const FEWEST: f64 = 2.0;

/// Iterations `1 + ⌈log₂ max(2, N)⌉`, `N = (L² − a²)/(2 a h)`, until `L` is within a node spacing `h` of `a`; one more
/// where the start is soft (`κ₀ <` [`SOFT`]) and there is anything to halve, `N > 1`.
///
/// Where a is known, as in Hertz's contact, it is a prediction before the run.
pub fn iterations(stretch: f64, half_width: f64, spacing: f64, stiffness: f64) -> usize {
    let excess = excess(stretch, half_width, spacing);
    1 + excess.max(FEWEST).log2().ceil() as usize + one_more(excess, stiffness)
}

/// The same under a paraboloid of revolution: contact kept up to L is its own less a flat punch of that radius, and
/// presses up to `√((2L³ + a³)/3L)`. Next to the contact that halves `L² − a²`, from far it leaves two thirds of `L²`.
pub fn of_revolution(stretch: f64, radius: f64, spacing: f64, stiffness: f64) -> usize {
    let pressing = |reach: &f64| Some(((2.0 * reach.powi(3) + radius.powi(3)) / (3.0 * reach)).sqrt());
    let reaches = std::iter::successors(pressing(&stretch), pressing);
    let shrinking = reaches.take_while(|reach| excess(*reach, radius, spacing) > 1.0);
    2 + shrinking.count() + one_more(excess(stretch, radius, spacing), stiffness)
}

/// `(L² − a²)/(2 a h)`: node spacings by which a contact up to L reaches too far.
fn excess(reach: f64, half_width: f64, spacing: f64) -> f64 {
    (reach * reach - half_width * half_width) / (2.0 * half_width * spacing)
}

/// The iteration more of a soft start.
fn one_more(excess: f64, stiffness: f64) -> usize {
    usize::from(stiffness < SOFT && excess > 1.0)
}
