//! The numbers one quotes: one formula for all contact elements.
//!
//! * [`profile`] — half-width, peak, edge and norms of a pressure profile.
//! * [`order`] — observed order of accuracy, Richardson's uncertainty.

pub mod order;
pub mod profile;

use crate::scene::{ContactPair, Path, Scene};
use crate::solution::Solution;

pub use profile::Peak;

/// Measures of one contact of a converged solution.
#[derive(Clone, Copy, Debug)]
pub struct Measures {
    /// Half-width by second moment about the centre, `2 √(∫p (s − c)² / ∫p)` \[mm\]; on arcs the same functional of the
    /// angle \[rad\].
    pub half_width: f64,
    /// Centre of pressure `∫p s / ∫p` of a contact on both sides of s = 0; 0 where it begins there \[mm\].
    pub centre: f64,
    /// Half-width by counting active points: `Σ A / thickness` over them, half of it on both sides \[mm, or rad\].
    pub half_width_nodes: f64,
    /// Active points.
    pub active: usize,
    /// Contact coordinate of the first active point; −`edge` where the contact begins at 0 \[mm, or rad\].
    pub begin: f64,
    /// Contact coordinate of the last active point \[mm, or rad\].
    pub edge: f64,
    /// Peak pressure and where it lies.
    pub peak: Peak,
    /// Force on the whole contact along the load line, both halves \[N\].
    pub resultant: f64,
}

impl Measures {
    /// Measures of one contact of a solution; `floor` is the pressure from which a point counts as active \[MPa\].
    pub fn of(scene: &Scene, solution: &Solution, contact: usize, floor: f64) -> Self {
        let (pair, points) = (&scene.contacts[contact], solution.points_of(contact));
        let across = pair.path.has_both_sides();
        let centre = if across { profile::centre(points) } else { 0.0 };
        let centred = profile::about(points, centre);
        let half_width = profile::second_moment_half_width(&centred);
        let peak = if across { profile::peak_across(&centred, half_width) } else { profile::peak(points, half_width) };
        let active = || points.iter().filter(|p| p.pressure > floor);
        let ends = active().map(|p| p.position).fold(None, |ends: Option<[f64; 2]>, s| {
            Some(ends.map_or([s, s], |[first, last]| [first.min(s), last.max(s)]))
        });
        let [begin, edge] = ends.unwrap_or([0.0, 0.0]);
        let sides = if across { 2.0 } else { 1.0 };
        let length = sides * scene.thickness * pair.path.metric();
        Self {
            half_width,
            centre,
            half_width_nodes: active().map(|p| p.weight).sum::<f64>() / length,
            active: active().count(),
            begin: if across { begin } else { -edge },
            edge,
            peak: Peak { position: centre + peak.position, ..peak },
            resultant: whole(pair) * profile::resultant(points, &pair.path),
        }
    }
}

/// Number of modelled halves in the whole: 2 where the scene is one half of a symmetric one.
pub fn whole(pair: &ContactPair) -> f64 {
    if pair.symmetric { 2.0 } else { 1.0 }
}

/// `|value − reference| / |reference|`.
pub fn relative_error(value: f64, reference: f64) -> f64 {
    (value - reference).abs() / reference.abs()
}

/// What turns the contact coordinate into what people read: 1 on planes (mm), degrees per radian on arcs.
pub fn display_factor(path: &Path) -> f64 {
    match path {
        Path::Straight(_) => 1.0,
        Path::Arc(_) => 180.0 / std::f64::consts::PI,
    }
}
