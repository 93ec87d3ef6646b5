//! The numbers one quotes: one formula for all contact elements.
//!
//! * [`quantity`] — which they are, with names and units.
//! * [`profile`] — second-moment width, resultant and norms of a pressure profile.
//! * [`mod@peak`] — its largest pressure, wherever that lies; `fit` — polynomials through pressures.
//! * [`nodal`] — the same where an edge holds many contact points.
//! * [`stretch`] — where its closed stretches begin and end.
//! * [`order`] — observed orders of accuracy, Richardson's extrapolation with its error bar.
//!
//! ```
//! use signorini::scene::{Material, Scene};
//! use signorini::measure::{Measures, relative_error};
//! use signorini::mesh::{Order, Resolution};
//! use signorini::solve::{Discretisation, Formulation};
//!
//! let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
//! let resolution = Resolution { elements: 8, refinement: 0, order: Order::Quadratic };
//! let discretisation = Discretisation::of(scene, resolution)?;
//! let solution = discretisation.solve(&Formulation::verification())?;
//! let measures = Measures::of(&discretisation.scene, 0, solution.part(0));
//! assert!(relative_error(measures.half_width(), 2.5) <= 0.02);
//! # Ok::<(), signorini::error::Error>(())
//! ```

mod fit;
pub mod nodal;
pub mod order;
pub mod peak;
pub mod profile;
pub mod quantity;
pub mod stretch;

use std::f64::consts::PI;

use crate::scene::{ContactPair, Path, Scene};
use crate::solution::Part;

pub use crate::solution::{larger, largest};
pub use fit::Peak;
pub use peak::Drawn;
pub use quantity::Quantity;
pub use stretch::Stretch;

/// Measures of the pressures of one contact.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Measures {
    /// Second-moment width about the centre, `2 √(∫p (s − c)² / ∫p)` \[mm\]: that of a semi-ellipse is its half-width;
    /// on arcs the same functional of the angle \[rad\]. Around an axis of revolution `√(5/2 ∫p r² dA / ∫p dA)`, the
    /// radius of a semi-ellipsoid.
    pub second_moment_width: f64,
    /// Centre of pressure `∫p s / ∫p` of a contact on both sides of s = 0; 0 where it begins there \[mm\].
    pub centre: f64,
    /// Half-width by counting active points: `Σ A / thickness` over them, half of it on both sides \[mm, or rad\];
    /// around an axis of revolution the radius of the circle of that area.
    pub half_width_nodes: f64,
    /// Active points: with a pressure above [`ACTIVE`] times the largest.
    pub active: usize,
    /// Pressed edges, by the same bound.
    pub pressed_edges: usize,
    /// Closed stretches, in the order of the contact coordinate.
    pub stretches: Vec<Stretch>,
    /// How far apart two readings of their ends are, where mesh lines tell them; 0 elsewhere \[mm, or rad\].
    #[serde(skip)]
    pub ends_apart: f64,
    /// How far points go on to press beyond the ends of the stretches, each by less than [`ACTIVE`] \[mm, or rad\].
    #[serde(skip)]
    pub faint: f64,
    /// The largest pressure of the profile, wherever it lies.
    pub peak: Peak,
    /// The same read by a parabola through the highest means, or by a quartic through the five highest points \[MPa\].
    #[serde(skip)]
    pub peak_by_parabola: f64,
    /// How well the elements draw the top.
    #[serde(skip)]
    pub drawn: Drawn,
    /// Pressure at s = 0 \[MPa\].
    pub pressure_at_origin: f64,
    /// The largest pressure of a contact point.
    pub largest: Peak,
    /// Force on the whole contact along the load line, both halves \[N\].
    pub resultant: f64,
    /// Whether the contact lies on both sides of s = 0.
    pub(crate) across: bool,
}

/// Radius of a semi-ellipsoid of pressures over twice its `√(∫p r² dA / ∫p dA)`, `½ √(5/2)`.
const OF_ELLIPSOID: f64 = 0.790_569_415_042_094_8;

/// Pressure over the largest of its contact from which on a point, or an edge, counts as pressed.
pub const ACTIVE: f64 = 1e-3;

/// The same below which it is round-off.
const NOTHING: f64 = 1e-9;

impl Measures {
    /// Measures of one contact.
    pub fn of(scene: &Scene, contact: usize, part: Part) -> Self {
        let Part { points, edges, .. } = part;
        let pair = &scene.contacts[contact];
        let (across, is_circle) = (pair.path.has_both_sides(), scene.is_around_axis(contact));
        let centre = if across { profile::centre(points) } else { 0.0 };
        let largest = points.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure));
        let largest = largest.map_or(f64::NAN, |point| point.pressure);
        let at = points.iter().find(|point| point.pressure >= largest).map_or(f64::NAN, |point| point.position);
        let floor = ACTIVE * largest;
        let active = || points.iter().filter(|p| p.pressure > floor);
        let sides = if across { 2.0 } else { 1.0 };
        let in_pairs = || {
            let peak = peak::of(edges, centre);
            (peak, [peak::by_parabola(edges, peak.pressure), peak::pressure_at(edges, 0.0)])
        };
        let stretches = stretch::closed(pair, part, floor);
        let (peak, [through_points, at_origin]) = nodal::read(part, centre).unwrap_or_else(in_pairs);
        Self {
            second_moment_width: profile::second_moment_width(points, centre)
                * if is_circle { OF_ELLIPSOID } else { 1.0 },
            centre,
            half_width_nodes: match active().map(|p| p.weight).sum::<f64>() {
                area if is_circle => (area / PI).sqrt() / pair.path.metric(),
                _ if scene.is_of_revolution() => {
                    let lengths = active().map(|p| p.weight / scene.depth(pair.path.point(p.position)));
                    lengths.sum::<f64>() / (sides * pair.path.metric())
                }
                area => area / (sides * scene.thickness * pair.path.metric()),
            },
            active: active().count(),
            pressed_edges: edges.iter().filter(|edge| edge.pressure > floor).count(),
            faint: stretch::faint(points, &stretches, NOTHING * largest),
            stretches,
            ends_apart: 0.0,
            peak: if across { peak } else { Peak { position: peak.position.abs(), ..peak } },
            peak_by_parabola: through_points,
            drawn: peak::drawn(edges, floor),
            pressure_at_origin: at_origin,
            largest: Peak { position: at, pressure: largest },
            resultant: whole(pair) * profile::resultant(points, &pair.path),
            across,
        }
    }

    /// Where the first closed stretch begins; as far to the left as the last one ends to the right of a symmetry line.
    pub fn begin(&self) -> f64 {
        match self.stretches.first() {
            Some(first) if self.across || first.begin > 0.0 => first.begin,
            Some(_) => -self.edge(),
            None => 0.0,
        }
    }

    /// Half-width: half of what lies between where the contact begins and where it ends \[mm, or rad\].
    pub fn half_width(&self) -> f64 {
        0.5 * (self.edge() - self.begin())
    }

    /// Where the last closed stretch ends \[mm, or rad\].
    pub fn edge(&self) -> f64 {
        self.stretches.last().map_or(0.0, |last| last.end)
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
        Path::Straight { .. } => 1.0,
        Path::Arc(_) => 180.0 / PI,
    }
}
