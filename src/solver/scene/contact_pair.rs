//! Who touches whom: the path, the initial gap along it, the candidate stretch, and where the contact is expected to
//! end.

use std::sync::Arc;

use crate::scene::BoundaryName;
use crate::scene::drawn::DrawnGap;
use crate::scene::path::Path;
use crate::scene::spline::MonotoneCubic;

/// Contact of one body with another, or with a rigid profile.
#[derive(Clone, Debug)]
pub struct ContactPair {
    /// Name in messages and results.
    pub name: String,
    /// The secondary body, which carries the contact points: positions, areas and normals are measured on it.
    pub first: usize,
    /// Whether that body is the upper, or inner, one; its outward normal is then the path's direction, else the
    /// opposite.
    pub above: bool,
    /// The primary body, elastic; none where the other side is rigid.
    pub second: Option<usize>,
    /// Boundaries that touch: of the first body, and of the second one.
    pub sides: [BoundaryName; 2],
    /// The curve along which the contact coordinate runs.
    pub path: Path,
    /// Initial gap along the path, without the clearance.
    pub profile: Profile,
    /// Clearance between the bodies beside a profile that begins with none \[mm\].
    pub clearance: f64,
    /// Candidates lie on `0 ≤ s ≤ stretch`, or on `−stretch ≤ s ≤ stretch` where the path has both sides
    /// \[mm, or rad on an arc\].
    pub stretch: f64,
    /// The scene shows one half of a symmetric problem.
    pub symmetric: bool,
    /// Where its closed stretches are expected to end, as far as the mesh shall know.
    pub ends: Ends,
}

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

/// Part of a length by which it may seem to go beyond its end.
pub const ROUNDING: f64 = 1e-9;

/// Initial normal gap as a function of the contact coordinate.
#[derive(Clone, Debug)]
pub enum Profile {
    /// The same gap everywhere \[mm\]; negative is interference.
    Uniform(f64),
    /// As the bodies are drawn: from each node of the first body to the opposite edge; to y = 0, or to the arc, where
    /// the other side is rigid. Between the nodes the gap is interpolated, so [`Profile::gap`] cannot tell it.
    Drawn,
    /// Between the sides that are drawn, exactly, whatever the mesh.
    Bodies(Arc<DrawnGap>),
    /// Flat punch with sharp corners: no gap up to its half-width, no other side beyond it.
    Punch {
        /// Half-width \[mm\].
        half_width: f64,
    },
    /// Circle of radius `R` on a plane: `g = R − √(R² − x²)` \[mm\].
    Circle {
        /// Radius \[mm\].
        radius: f64,
    },
    /// Circles of both sides, `g = f(R₁) + f(R₂)` with `f(R) = R − sgn(R) √(R² − x²)`; the radius of a hollow one is
    /// negative \[mm\].
    Circles {
        /// R₁ and R₂; neither is 0 \[mm\].
        radii: [f64; 2],
    },
    /// Parabola on a plane: `g = x²/2R` \[mm\].
    Parabola {
        /// Radius of curvature at the vertex \[mm\].
        radius: f64,
    },
    /// Even polynomial `g = Σ c_k s^{2k+2}`, k from 0.
    Even {
        /// `c_k` [mm^{−1−2k}].
        coefficients: Arc<[f64]>,
    },
    /// Powers `g = Σ c |s|ⁿ`, n > 1.
    Powers {
        /// `[c, n]` of each term [mm^{1−n}, 1].
        terms: Arc<[[f64; 2]]>,
    },
    /// Wedge, `g = s tan β`.
    Wedge {
        /// `tan β`.
        slope: f64,
    },
    /// Points `[s, g]` by ascending s, straight lines between them; no other side beyond the last \[mm\].
    /// A table that begins at 0 holds for both signs of s, one that begins below 0 as it stands.
    Table(Arc<[[f64; 2]]>),
    /// A monotone cubic through such points.
    Smooth(Arc<MonotoneCubic>),
    /// Waves, `g = Δ (1 − cos 2π s/λ)` \[mm\].
    Cosine {
        /// Δ \[mm\].
        amplitude: f64,
        /// λ \[mm\].
        wavelength: f64,
    },
    /// Pin in a hole that it touches at its lowest point: the distance along the pin's radius,
    /// `g = √((R+c)² − c² sin²θ) − c cos θ − R`, to first order `c (1 − cos θ)` \[mm\].
    Hole {
        /// Radius of the pin \[mm\].
        radius: f64,
        /// Radial clearance \[mm\].
        clearance: f64,
    },
    /// The same measured on the hole: the distance along the hole's radius,
    /// `g = R + c − c cos θ − √(R² − c² sin²θ)`, to first order `c (1 − cos θ)` \[mm\].
    Pin {
        /// Radius of the pin \[mm\].
        radius: f64,
        /// Radial clearance, below that radius \[mm\].
        clearance: f64,
    },
}

/// The boundary that touches, where no other is named.
pub const CONTACT: &str = "contact";

impl ContactPair {
    /// Contact of the first body, the upper or inner one, on the side that it calls `contact`, in half of a symmetric
    /// scene.
    pub fn new(second: Option<usize>, path: Path, profile: Profile, stretch: f64) -> Self {
        let (name, sides) = (CONTACT.into(), Self::SIDES);
        Self {
            name,
            first: 0,
            above: true,
            second,
            sides,
            path,
            profile,
            clearance: 0.0,
            stretch,
            symmetric: true,
            ends: Ends::default(),
        }
    }

    /// The boundaries of a pair whose bodies both call theirs `contact`.
    pub const SIDES: [BoundaryName; 2] = [BoundaryName::Borrowed(CONTACT), BoundaryName::Borrowed(CONTACT)];

    /// The boundary of a body that takes part.
    pub fn side(&self, body: usize) -> &str {
        &self.sides[usize::from(body != self.first)]
    }

    /// Indices of the elastic bodies that take part.
    pub fn bodies(&self) -> impl Iterator<Item = usize> + use<> {
        [Some(self.first), self.second].into_iter().flatten()
    }

    /// Initial gap at the contact coordinate `s`, that of the profile and the clearance \[mm\].
    pub fn gap(&self, s: f64) -> f64 {
        self.profile.gap(s) + self.clearance
    }

    /// Contact coordinate at which the candidates begin: 0, or −stretch where the path has both sides.
    pub fn begin(&self) -> f64 {
        if self.path.has_both_sides() { -self.stretch } else { 0.0 }
    }

    /// Outward unit normal of the first body at a point of the path.
    pub fn normal(&self, point: [f64; 2]) -> [f64; 2] {
        let direction = self.path.direction(point);
        if self.above { direction } else { direction.map(|n| 0.0 - n) }
    }

    /// Whether an edge of a body, which lies to its left, faces the other side of the contact: by the cosine, above a
    /// least one, between its outward normal and the direction in which that side is looked for.
    pub fn faces(&self, body: usize, [from, to]: [[f64; 2]; 2], least: f64) -> bool {
        let normal = self.normal([0, 1].map(|k| 0.5 * (from[k] + to[k])));
        let [dx, dy] = [0, 1].map(|k| to[k] - from[k]);
        let cosine = (dy * normal[0] - dx * normal[1]) / dx.hypot(dy);
        (if body == self.first { cosine } else { -cosine }) > least + ROUNDING
    }

    /// Contact coordinates between the known ends of the contact at which the curvature of the gap leaps, ascending;
    /// none where that is so at many of the points that tell it \[mm, or rad on an arc\].
    pub fn leaps(&self) -> Vec<f64> {
        let places = &self.ends.places;
        let [Some(first), Some(last)] = [places.first(), places.last()] else { return Vec::new() };
        let begin = if self.path.has_both_sides() { *first } else { 0.0 };
        let near = AT_END * (last - begin);
        let mut leaps = self.profile.leaps();
        leaps.retain(|s| begin + near < *s && *s < last - near);
        leaps.retain(|s| places.iter().all(|place| (place - s).abs() > near));
        leaps.sort_by(f64::total_cmp);
        if leaps.len() > MANY { Vec::new() } else { leaps }
    }

    /// The least power n < 2 of a gap whose pressure has a cusp at s = 0, where that lies within the known ends of the
    /// contact.
    pub fn power_at_cusp(&self) -> Option<f64> {
        let places = &self.ends.places;
        let is_within = match self.path.has_both_sides() {
            true => places.first().zip(places.last()).is_some_and(|(first, last)| *first < 0.0 && 0.0 < *last),
            false => places.len() % 2 == 1,
        };
        self.profile.least_power().filter(|power| is_within && *power < 2.0)
    }

    /// Gap between a point of the first body and one of the second, as drawn \[mm\]; negative is interference.
    pub fn drawn(&self, first: f64, second: f64) -> f64 {
        if self.above { second - first } else { first - second }
    }
}

impl Profile {
    /// Contact coordinate at which it ends \[mm\]; none where it goes on.
    pub fn reach(&self) -> Option<f64> {
        match *self {
            Self::Punch { half_width } => Some(half_width),
            Self::Circle { radius } => Some(radius),
            Self::Circles { radii: [a, b] } => Some(a.abs().min(b.abs())),
            _ => None,
        }
    }

    /// Whether it presses by itself: the bodies overlap everywhere alike.
    pub fn interferes(&self) -> bool {
        matches!(*self, Self::Uniform(gap) if gap < 0.0)
    }

    /// Initial gap at the contact coordinate `s` \[mm\]; infinite where there is no other side, NaN where only the
    /// bodies' meshes tell it. All but tables that begin below 0 and drawn bodies are even in `s`.
    pub fn gap(&self, s: f64) -> f64 {
        match *self {
            Self::Table(ref points) if is_even(points) => between(points, s.abs()),
            Self::Table(ref points) => between(points, s),
            Self::Smooth(ref cubic) => cubic.gap(if is_even(&cubic.points) { s.abs() } else { s }),
            Self::Bodies(ref drawn) => drawn.gap(s),
            Self::Uniform(gap) => gap,
            Self::Drawn => f64::NAN,
            Self::Punch { half_width } if s.abs() <= half_width * (1.0 + 1e-9) => 0.0,
            Self::Punch { .. } => f64::INFINITY,
            Self::Circle { radius } => s * s / (radius + (radius * radius - s * s).sqrt()),
            Self::Circles { radii } => gap_of_circles(radii, s),
            Self::Parabola { radius } => s * s / (2.0 * radius),
            Self::Even { ref coefficients } => coefficients.iter().rev().fold(0.0, |sum, c| c + sum * s * s) * s * s,
            Self::Powers { ref terms } => terms.iter().map(|[c, n]| c * s.abs().powf(*n)).sum(),
            Self::Wedge { slope } => slope * s.abs(),
            // 1 − cos x = 2 sin² x/2, without lost digits.
            Self::Cosine { amplitude, wavelength } => {
                2.0 * amplitude * (std::f64::consts::PI * s / wavelength).sin().powi(2)
            }
            Self::Hole { radius, clearance } => hole_gap(radius, clearance, s),
            Self::Pin { radius, clearance } => pin_gap(radius, clearance, s),
        }
    }

    /// Contact coordinates of the points that it is given by, on either side of s = 0; none of a formula \[mm, or rad
    /// on an arc\].
    pub fn places(&self) -> Vec<f64> {
        let points: &[[f64; 2]] = match self {
            Self::Table(points) => points,
            Self::Smooth(cubic) => &cubic.points,
            _ => return Vec::new(),
        };
        on_both_sides(points, points.iter().map(|point| point[0]))
    }

    /// Contact coordinates at which its curvature leaps, on either side of s = 0; none of a formula \[mm, or rad on an
    /// arc\].
    pub fn leaps(&self) -> Vec<f64> {
        let Self::Smooth(cubic) = self else { return Vec::new() };
        on_both_sides(&cubic.points, cubic.leaps().into_iter())
    }

    /// Contact coordinates at which the slope of the gap leaps upwards, and by how much, so that a tip is pressed: the
    /// pressure has no limit there. None where only the bodies' meshes tell the gap \[mm, or rad on an arc; 1, or
    /// mm/rad\].
    pub fn tips(&self) -> Option<Vec<[f64; 2]>> {
        Some(match self {
            Self::Drawn => return None,
            Self::Wedge { slope } => vec![[0.0, 2.0 * slope]],
            Self::Table(points) => {
                let even = is_even(points);
                let images = points.iter().rev().filter(|point| even && point[0] > 0.0).map(|[s, gap]| [-s, *gap]);
                let all: Vec<[f64; 2]> = images.chain(points.iter().copied()).collect();
                corners(&all).filter(|[_, leap]| *leap > 0.0).collect()
            }
            Self::Bodies(drawn) => drawn.tips(),
            _ => Vec::new(),
        })
    }

    /// The least power of a gap that is a sum of powers.
    fn least_power(&self) -> Option<f64> {
        let Self::Powers { terms } = self else { return None };
        terms.iter().map(|[_, n]| *n).min_by(f64::total_cmp)
    }

    /// By how much the pressure falls from s = 0 over a spacing of nodes, over E\*: `c n (2 − n)/(n − 1) hⁿ⁻¹` of a
    /// power below 2, whose pressure has a cusp there; at least what the closed form of a body of revolution says.
    pub fn cusp(&self, spacing: f64) -> f64 {
        let Self::Powers { terms } = self else { return 0.0 };
        let of = |[c, n]: &[f64; 2]| c.abs() * n * (2.0 - n) / (n - 1.0) * spacing.powf(n - 1.0);
        terms.iter().filter(|[_, n]| *n < 2.0).map(of).sum()
    }

    /// Whether points tell the gap, between which its curvature, or its slope, may leap.
    pub fn is_by_points(&self) -> bool {
        matches!(self, Self::Table(_) | Self::Smooth(_))
    }

    /// Whether the gap is analytic and mostly a parabola, `|c₂| a² ≥ Σ |cₙ| aⁿ` over its other even powers, so that the
    /// pressure has a smooth top: not where points tell it \[a of the half-width, mm\].
    pub fn is_smooth(&self, half_width: f64) -> bool {
        let is_mostly_parabola = |terms: &[[f64; 2]]| {
            let size = |[c, n]: &[f64; 2]| c.abs() * half_width.powf(*n);
            let (parabola, others): (Vec<_>, Vec<_>) = terms.iter().partition(|[_, n]| (n - 2.0).abs() <= 0.0);
            parabola.into_iter().map(size).sum::<f64>() >= others.into_iter().map(size).sum()
        };
        match self {
            Self::Even { coefficients } => {
                let powers = coefficients.iter().enumerate().map(|(k, c)| [*c, 2.0 * (k + 1) as f64]);
                is_mostly_parabola(&powers.collect::<Vec<_>>())
            }
            Self::Powers { terms } => self.is_analytic() && is_mostly_parabola(terms),
            _ => !self.is_by_points(),
        }
    }

    /// Whether the gap is analytic: not where points tell it, at a tip or a corner, or of powers that are not even.
    pub fn is_analytic(&self) -> bool {
        match self {
            Self::Powers { terms } => terms.iter().all(|[_, n]| (n / 2.0).fract().abs() <= 0.0),
            Self::Drawn | Self::Punch { .. } | Self::Wedge { .. } => false,
            _ => !self.is_by_points(),
        }
    }

    /// Distances from s = 0, ascending, at which the slope of the gap leaps on either side of it.
    pub fn kinks(&self) -> Vec<f64> {
        let Self::Table(points) = self else { return Vec::new() };
        let mut places: Vec<f64> = corners(points).map(|[s, _]| s.abs()).filter(|s| *s > 0.0).collect();
        places.sort_by(f64::total_cmp);
        places
    }
}

/// Distance from an end of the contact, over its width, up to which a leap of the curvature lies at that.
const AT_END: f64 = 0.005;
/// Leaps within a contact beyond which they are the points' and not the gap's.
const MANY: usize = 4;

/// Difference of slopes, over their sum, up to which three points lie in line.
const STRAIGHT: f64 = 1e-9;

/// Points between others at which the line through them turns, and by how much its slope leaps there.
fn corners(points: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    points.windows(3).filter_map(|three| {
        let [before, after] = [0, 1].map(|k| (three[k + 1][1] - three[k][1]) / (three[k + 1][0] - three[k][0]));
        let leap = after - before;
        (leap.abs() > STRAIGHT * (after.abs() + before.abs())).then_some([three[1][0], leap])
    })
}

/// Whether a table tells one side of an even gap.
fn is_even(points: &[[f64; 2]]) -> bool {
    points.first().is_none_or(|[s, _]| *s >= 0.0)
}

/// Contact coordinates on the side that points tell, and their images where these tell one side of an even gap.
fn on_both_sides(points: &[[f64; 2]], places: impl Iterator<Item = f64> + Clone) -> Vec<f64> {
    places.clone().filter(|_| is_even(points)).map(|s| -s).chain(places).collect()
}

/// Gap of a table at `s`; no other side before its first point and beyond its last.
fn between(points: &[[f64; 2]], s: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < s * (1.0 - 1e-12));
    match (after.checked_sub(1).map(|k| points[k]), points.get(after)) {
        (None, Some(&[first, gap])) if s >= first => gap,
        (Some([a, g]), Some(&[b, h])) => g + (h - g) * ((s - a) / (b - a)).min(1.0),
        _ => f64::INFINITY,
    }
}

/// `g = √((R+c)² − c² sin²θ) − c cos θ − R`, rearranged so that no digits cancel:
/// `g = 2cR(1−cos θ) / (√((R+c)² − c² sin²θ) + R + c cos θ)`.
fn hole_gap(radius: f64, clearance: f64, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let hole = radius + clearance;
    let root = (hole * hole - (clearance * sin).powi(2)).sqrt();
    let versine = 2.0 * (angle / 2.0).sin().powi(2);
    2.0 * clearance * radius * versine / (root + radius + clearance * cos)
}

/// `g = R + c − c cos θ − √(R² − c² sin²θ)`, rearranged so that no digits cancel:
/// `g = 2c sin²(θ/2) + c² sin²θ / (R + √(R² − c² sin²θ))`.
fn pin_gap(radius: f64, clearance: f64, angle: f64) -> f64 {
    let offset = clearance * angle.sin();
    let root = (radius * radius - offset * offset).sqrt();
    2.0 * clearance * (angle / 2.0).sin().powi(2) + offset * offset / (radius + root)
}

/// Sum of the depths of two circles at `s`, each `R − sgn(R) √(R² − s²) = s²/(R + sgn(R) q)`, `q = √(R² − s²)`.
///
/// With `d = |R| + q` of each, the sum is `s² (1/d₁ + 1/d₂)`; of a hollow circle around the other one it is
/// `s² (|R₂| − R₁) (1 + (R₁ + |R₂|)/(q₁ + q₂))/(d₁ d₂)`, so that no digits cancel.
fn gap_of_circles(radii: [f64; 2], s: f64) -> f64 {
    let [a, b] = radii.map(f64::abs);
    let [p, q] = [a, b].map(|radius| (radius * radius - s * s).sqrt());
    let over = s * s / ((a + p) * (b + q));
    match radii.map(f64::is_sign_negative) {
        [false, false] => over * (a + p + b + q),
        [true, true] => 0.0 - over * (a + p + b + q),
        [false, true] => over * (b - a) * (1.0 + (a + b) / (p + q)),
        [true, false] => over * (a - b) * (1.0 + (a + b) / (p + q)),
    }
}
