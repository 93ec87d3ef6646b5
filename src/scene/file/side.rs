//! The sides that carry the contact: which way they look, and where they lie.

use std::f64::consts::FRAC_1_SQRT_2;

use toml::Spanned;

use crate::error::Error;
use crate::scene::file::Source;
use crate::scene::file::units::Units;
use crate::scene::{Circle, Face, Path, Profile, Shape};

/// The side of a body that carries the contact.
pub(super) struct Side {
    /// It looks down, or away from the centre of its arc: the side of a `first` body.
    outward: bool,
    /// Where it runs: at a height from the symmetry line on, or along a circle.
    place: SidePlace,
    /// How far it goes along x \[mm\], or about the centre \[rad\].
    length: f64,
}

enum SidePlace {
    /// Straight, or touching such a line: x of its beginning, and height.
    Straight { from: f64, height: f64 },
    /// Circle.
    Arc(Circle),
    /// A disc, which takes part in either.
    Disc(Circle),
}

impl Side {
    pub(super) fn of(shape: &Shape) -> Self {
        match *shape {
            Shape::Rectangle { x, y, contact } => {
                let height = if contact == Face::Bottom { y[0] } else { y[1] };
                let place = SidePlace::Straight { from: x[0], height };
                Self { outward: contact == Face::Bottom, place, length: x[1] - x[0] }
            }
            // Beyond 45° the radial candidates of a quarter are hardly pressed.
            Shape::Disc { centre, radius, .. } => Self {
                outward: true,
                place: SidePlace::Disc(Circle { centre, radius }),
                length: radius * FRAC_1_SQRT_2,
            },
            Shape::Ring { inner, outer, sweep, contact, .. } => {
                let outward = contact == Face::Top;
                Self { outward, place: SidePlace::Arc(if outward { outer } else { inner }), length: sweep }
            }
            Shape::Eye { hole, .. } => {
                Self { outward: false, place: SidePlace::Arc(hole), length: std::f64::consts::PI }
            }
        }
    }

    /// Refuses a side that does not look at the other one, or does not lie on the path; a gap or clearance may be drawn or not.
    pub(super) fn refuse_misfit(
        &self,
        source: Source,
        name: &Spanned<String>,
        path: &Path,
        profile: &Profile,
        is_first: bool,
    ) -> Result<(), Error> {
        let refused = |what: &str, remedy: &str| {
            let message = format!("the contact side of `{}` {what}", name.get_ref());
            Err(source.refused(name.span(), message, remedy))
        };
        if self.outward != is_first {
            let wanted = if is_first { "looks up, or inwards" } else { "looks down, or outwards" };
            return refused(
                wanted,
                "`first` is the upper or inner body, `second` the lower or outer one: exchange them, or the side",
            );
        }
        let clearance = match profile {
            Profile::Hole { clearance, .. } => *clearance,
            other => other.gap(0.0).abs(),
        };
        let near = |a: f64, b: f64| (a - b).abs() <= clearance * (1.0 + 1e-6) + 1e-6 * a.abs().max(b.abs());
        let on_axis = |x: f64, size: f64| x.abs() <= 1e-9 * size;
        match (&self.place, path) {
            (SidePlace::Straight { from, .. }, Path::Horizontal) if !on_axis(*from, self.length) => refused(
                "does not begin at x = 0",
                "the contact begins on the symmetry line x = 0: move the bodies there",
            ),
            (SidePlace::Straight { height, .. }, Path::Horizontal) if !near(*height, 0.0) => {
                refused("does not lie at y = 0", "the contact runs along y = 0: move the bodies there")
            }
            (SidePlace::Disc(circle), Path::Horizontal) if !on_axis(circle.centre[0], circle.radius) => refused(
                "does not begin at x = 0",
                "the contact begins on the symmetry line: give the disc a centre at x = 0",
            ),
            (SidePlace::Disc(circle), Path::Horizontal) if !near(circle.centre[1], circle.radius) => {
                refused("does not touch y = 0", "the contact runs along y = 0: give the disc a centre one radius above")
            }
            (SidePlace::Arc(circle) | SidePlace::Disc(circle), Path::Arc(arc)) => {
                let aligned = (0..2).all(|k| near(circle.centre[k], arc.centre[k]));
                let fits = if is_first {
                    (circle.radius / arc.radius - 1.0).abs() <= 1e-9
                } else {
                    near(circle.radius, arc.radius)
                };
                if aligned && fits {
                    return Ok(());
                }
                refused(
                    "does not lie on `arc`",
                    "`arc` is the circle of the first body's side; the other lies there too, a gap apart at most",
                )
            }
            (SidePlace::Straight { .. }, Path::Arc(_)) => refused("is straight, the path is an arc", "leave `arc` out"),
            (SidePlace::Arc(_), Path::Horizontal) => {
                refused("is an arc, the path is straight", "name the circle the contact runs along, as `arc`")
            }
            _ => Ok(()),
        }
    }

    /// Refuses a candidate stretch that goes on where the side has ended.
    pub(super) fn refuse_short(
        &self,
        source: Source,
        units: &Units,
        name: &Spanned<String>,
        path: &Path,
        (stretch, given): (f64, &Spanned<f64>),
    ) -> Result<(), Error> {
        let (length, shown) = match (path, &self.place) {
            (Path::Horizontal, _) => (self.length, self.length / units.length),
            (Path::Arc(_), SidePlace::Arc(_)) => (self.length, self.length.to_degrees()),
            (Path::Arc(_), _) => return Ok(()),
        };
        if stretch <= length * (1.0 + 1e-9) {
            return Ok(());
        }
        let shown = (1e6 * shown).round() / 1e6;
        let message = format!("the candidates reach beyond `{}`, whose contact side ends at {shown}", name.get_ref());
        Err(source.refused(given.span(), message, format!("give at most {shown}")))
    }
}
