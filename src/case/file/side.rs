//! The sides that carry the contact: which way they look, and where they lie.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use crate::case::file::curves;
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Circle, Curve, Face, Path, PlaneHypothesis, Profile, Shape};

/// A straight piece of boundary, from its first point to its last, the body to its left \[mm\].
type Piece = [[f64; 2]; 2];

/// The side of a body that carries the contact.
pub(super) struct Side {
    /// It looks down, or away from the centre of its arc; none where parts of it look one way and parts the other.
    pub outward: Option<bool>,
    /// The curves that it is drawn with.
    pub curves: Vec<Curve>,
    /// Where it runs.
    place: Place,
    /// Whether its body lies on both sides of s = 0, where the shape tells.
    across: Option<bool>,
    /// How far it goes along x, on its shorter side where the path has both \[mm\], or about the centre \[rad\].
    length: f64,
}

enum Place {
    /// Straight, at a height: x of its beginning, and the height.
    Straight { from: f64, height: f64 },
    /// Circle.
    Arc(Circle),
    /// A disc, which takes part in either, or a ring on a straight path; the height at which it touches.
    Disc { circle: Circle, height: f64 },
    /// Pieces given one by one.
    Pieces(Vec<Piece>),
}

impl Side {
    /// The side of a shape that has a name; none where no contact can lie on it.
    pub(super) fn of(shape: &Shape, name: &str, path: &Path, stretch: f64) -> Option<Self> {
        let origin = path.origin()[0];
        Some(match shape {
            Shape::Rectangle { x, y, contact } => {
                let face = face(*contact, name, ["far", "far"])?;
                let height = if face == Face::Bottom { y[0] } else { y[1] };
                let place = Place::Straight { from: x[0], height };
                let length = if path.has_both_sides() { (x[1] - origin).min(origin - x[0]) } else { x[1] - x[0] };
                let curves = vec![Curve::Line(x.map(|x| [x, height]))];
                Self { outward: Some(face == Face::Bottom), curves, place, across: None, length }
            }
            // Beyond 45° the radial candidates of a quarter are hardly pressed.
            Shape::Disc { centre, radius, contact, sector } => {
                let other = if sector.has_upper_part() { "top" } else { CONTACT };
                let down = face(*contact, name, [other, other])? == Face::Bottom;
                let height = if down { centre[1] - radius } else { centre[1] + radius };
                let circle = Circle { centre: *centre, radius: *radius };
                let place = Place::Disc { circle, height };
                let outward = Some(down || !path.is_straight());
                let touching = if down { 0.0 } else { PI };
                let back = if path.has_both_sides() { FRAC_PI_2 } else { 0.0 };
                let [left, right] = if down { [back, FRAC_PI_2] } else { [FRAC_PI_2, back] };
                let mut curves = curves::of_circle(&circle, touching - left, touching);
                curves.extend(curves::of_circle(&circle, touching, touching + right));
                let length = radius * FRAC_1_SQRT_2;
                Self { outward, curves, place, across: Some(sector.has_both_sides()), length }
            }
            Shape::Ring { sweep, contact, both_sides, .. } => {
                let outward = Some(face(*contact, name, ["inner", "outer"])? == Face::Top);
                let (circle, across) = (shape.circle(name)?, Some(*both_sides));
                let Some(reach) = shape.reach(name, path) else {
                    let curves = curves::of_circle(&circle, 0.0, *sweep);
                    return Some(Self { outward, curves, place: Place::Arc(circle), across, length: *sweep });
                };
                let quarter = sweep.min(FRAC_PI_2);
                let mut curves = curves::of_circle(&circle, 0.0, quarter);
                if path.has_both_sides() {
                    curves.extend(curves::of_circle(&circle, -quarter, 0.0));
                }
                let place = Place::Disc { circle, height: circle.centre[1] - circle.radius };
                Self { outward, curves, place, across, length: reach.min(circle.radius * FRAC_1_SQRT_2) }
            }
            Shape::Eye { hole, .. } => {
                let curves = curves::of_circle(hole, 0.0, PI);
                Self { outward: Some(false), curves, place: Place::Arc(*hole), across: Some(false), length: PI }
            }
            Shape::Blocks(blocks) => Self::of_pieces(curves::of_blocks(blocks, name)?, path, stretch),
            Shape::Given(mesh) => Self::of_pieces(mesh.curves(name)?, path, stretch),
        })
    }

    /// Of the pieces within the stretch; where some look one way and some the other, as those of a closed boundary, of
    /// those that look like the one that lies nearest to the path, as far as they go on from one another.
    fn of_pieces(curves: Vec<Curve>, path: &Path, stretch: f64) -> Self {
        let within = stretch * (1.0 - 1e-9);
        let reaches_in = |piece: &Piece| {
            let ends = piece.map(|point| path.coordinate(point));
            ends.iter().any(|s| *s < within) && ends.iter().any(|s| *s > -within)
        };
        let looks = |[from, to]: Piece| {
            let direction = path.direction(middle([from, to]));
            let [dx, dy] = [0, 1].map(|k| to[k] - from[k]);
            let across = dy * direction[0] - dx * direction[1];
            (across.abs() > 1e-9 * dx.hypot(dy)).then_some(across > 0.0)
        };
        let from_path = |piece: &Piece| (path.depth(middle(*piece)) - path.own_depth()).abs();
        let all: Vec<Piece> = curves.iter().flat_map(chords).filter(reaches_in).collect();
        let nearest = all.iter().min_by(|a, b| from_path(a).total_cmp(&from_path(b)));
        let outward = nearest.and_then(|piece| looks(*piece));
        let is_mixed = all.iter().any(|piece| looks(*piece) != outward);
        let is_kept = |curve: &Curve| !is_mixed || looks([curve.point(0.0), curve.point(1.0)]) == outward;
        let curves: Vec<Curve> = curves.into_iter().filter(is_kept).collect();
        let kept: Vec<Piece> = curves.iter().flat_map(chords).collect();
        let farthest = |sign: f64| kept.iter().flatten().map(|p| sign * path.coordinate(*p)).fold(0.0, f64::max);
        let length = if path.has_both_sides() { farthest(1.0).min(farthest(-1.0)) } else { farthest(1.0) };
        let pieces: Vec<Piece> = kept.into_iter().filter(reaches_in).collect();
        let outward = outward.filter(|_| {
            !is_mixed || pieces.iter().all(|piece| looks(*piece) == outward) && goes_on(&pieces, path, 1e-6 * length)
        });
        Self { outward, curves, place: Place::Pieces(pieces), across: None, length }
    }

    /// How far along the path's direction the side begins \[mm\].
    pub(super) fn depth(&self, path: &Path) -> f64 {
        match (&self.place, path) {
            (Place::Straight { height, .. } | Place::Disc { height, .. }, Path::Straight { origin, .. }) => {
                origin[1] - height
            }
            (Place::Disc { circle, .. } | Place::Arc(circle), _) => circle.radius,
            (Place::Straight { .. }, _) => f64::NAN,
            (Place::Pieces(pieces), _) => {
                let points = pieces.iter().flatten();
                let from_0 = |point: &[f64; 2]| path.coordinate(*point).abs();
                let first = points.min_by(|a, b| from_0(a).total_cmp(&from_0(b)));
                first.map_or(f64::NAN, |point| path.depth(*point))
            }
        }
    }

    /// Refuses a side that does not begin on the symmetry line, or cross it on paths with both sides, or does not lie
    /// on the path; a gap or clearance may be drawn or not.
    pub(super) fn refuse_misfit(
        &self,
        name: Value,
        (path, profile, apart): (&Path, &Profile, f64),
        (is_first, plane): (bool, PlaneHypothesis),
    ) -> Result<(), Error> {
        let [line, level] =
            [("x", 0), ("y", 1)].map(|(axis, k)| format!("{axis} = {}", path.origin()[k] / name.units.length));
        let clearance = match profile {
            Profile::Hole { clearance, .. } | Profile::Pin { clearance, .. } => *clearance,
            Profile::Drawn | Profile::Bodies(_) => f64::INFINITY,
            other => other.gap(0.0).abs() + apart,
        };
        let wanted = Wanted { path, line, level, clearance, is_first, plane };
        match self.on_other_sides(&wanted).or_else(|| self.misplaced(&wanted)) {
            None => Ok(()),
            Some([what, remedy]) => Err(name.refused(format!("the contact side of `{}` {what}", name.text()), remedy)),
        }
    }

    /// A side that lies on other sides of s = 0 than the contact.
    fn on_other_sides(&self, wanted: &Wanted) -> Option<Misfit> {
        let both = wanted.path.has_both_sides();
        match self.across {
            Some(true) if !both => misfit(
                "lies on both sides of s = 0, the contact on one",
                wanted.remedy(
                    "the body is meshed for another contact, which has both sides: give this one `both-sides = true` \
                    too",
                ),
            ),
            Some(false) if both && matches!(self.place, Place::Disc { .. }) => misfit(
                "lies on one side of s = 0, the contact on both",
                "leave `half` out, or give all contacts of the body the same sides of s = 0",
            ),
            _ if both && !matches!(self.place, Place::Arc(_)) && self.length <= 0.0 => {
                let line = &wanted.line;
                let remedy = format!(
                    "with `both-sides` the candidates lie left and right of {line}: move the bodies there, or give \
                    `origin`"
                );
                misfit(format!("does not lie on both sides of {line}"), remedy)
            }
            _ => None,
        }
    }

    /// A side that does not lie on the path.
    fn misplaced(&self, wanted: &Wanted) -> Option<Misfit> {
        let Wanted { path, line, level, .. } = wanted;
        let [x0, y0] = path.origin();
        let on_axis = |x: f64, size: f64| (x - x0).abs() <= 1e-9 * size;
        let one_side = path.is_straight() && !path.has_both_sides();
        match (&self.place, path) {
            (Place::Straight { from, .. }, _) if one_side && !on_axis(*from, self.length) => misfit(
                format!("does not begin at {line}"),
                wanted.remedy(
                    "the contact begins on the symmetry line: move the bodies there, or give `both-sides = true`",
                ),
            ),
            (Place::Straight { height, .. }, Path::Straight { .. }) if !wanted.near(*height, y0) => misfit(
                format!("does not lie at {level}"),
                "the contact runs along that line: move the bodies there, give its `origin`, or `gap = \"drawn\"`",
            ),
            (Place::Disc { circle, .. }, Path::Straight { .. }) if !on_axis(circle.centre[0], circle.radius) => misfit(
                format!("does not touch at {line}"),
                wanted.remedy(format!(
                    "give the body a centre at {line}, where its mesh is finest, or the contact another `origin`"
                )),
            ),
            (Place::Disc { height, circle }, Path::Straight { .. })
                if !wanted.near(*height, y0) && wanted.near(2.0 * circle.centre[1] - height, y0) =>
            {
                misfit(
                    format!("does not touch {level}: the line touches its other end"),
                    "give a disc the other `contact`, \"top\" or \"bottom\"; a ring has none, it touches at its lowest \
                    point: turn the whole scene upside down, with loads and supports, or give the ring as a `mesh`",
                )
            }
            (Place::Disc { height, .. }, Path::Straight { .. }) if !wanted.near(*height, y0) => misfit(
                format!("does not touch {level}"),
                "the contact runs along that line: give the body a centre one radius above or below (above, of a ring: \
                it touches at its lowest point), or the contact its `origin`",
            ),
            (Place::Arc(circle) | Place::Disc { circle, .. }, Path::Arc(arc)) => wanted.circle(circle, arc),
            (Place::Straight { .. }, Path::Arc(_)) => misfit("is straight, the path is an arc", "leave `arc` out"),
            (Place::Pieces(pieces), _) => self.pieces(pieces, wanted),
            _ => None,
        }
    }

    /// A chain of pieces that begins elsewhere, turns away from the other body or leaves the path.
    fn pieces(&self, pieces: &[Piece], wanted: &Wanted) -> Option<Misfit> {
        let Wanted { path, line, level, is_first, .. } = wanted;
        let begin = pieces.iter().flatten().map(|point| path.coordinate(*point)).fold(f64::INFINITY, f64::min);
        let left = pieces.iter().flatten().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        let off = begin > 1e-6 * self.length || left < path.origin()[0] - 1e-6 * self.length * path.metric();
        if off && !path.has_both_sides() {
            return misfit(
                format!("does not begin on the symmetry line {line}"),
                wanted.remedy(
                    "the contact begins there at s = 0: move the bodies there, model one half, or give `both-sides = \
                    true`",
                ),
            );
        }
        if self.outward.is_none() {
            let remedy = "name the boundary that faces the other body, and end the stretch where it turns away";
            return misfit("does not look one way", remedy);
        }
        if let Some(slope) = steep(pieces, path) {
            let remedy = "contact forces act along y, or along the radius of `arc`: end the `stretch` where it is \
                flatter, turn the scene, or give a rigid profile its gap";
            return misfit(format!("slopes by {slope:.2} against the path"), remedy);
        }
        let off = (self.depth(path) - path.own_depth()).abs() > 1e-9 * self.length * path.metric();
        if off && !wanted.near(self.depth(path), path.own_depth()) {
            let remedy = "move the body there, give its `origin`, or `gap = \"drawn\"` where it is drawn as it stands";
            return misfit(format!("does not begin at {level}, or on `arc`"), remedy);
        }
        let on_arc = |point: &[f64; 2]| (path.depth(*point) / path.own_depth() - 1.0).abs() <= 1e-3;
        if *is_first && matches!(path, Path::Arc(_)) && !pieces.iter().flatten().all(on_arc) {
            return misfit("does not lie on `arc`", "`arc` is the circle of the first body's side");
        }
        None
    }

    /// Refuses a candidate stretch that goes on where the side has ended.
    pub(super) fn refuse_short(&self, name: Value, path: &Path, (stretch, given): (f64, Value)) -> Result<(), Error> {
        let (length, shown) = match (path, &self.place) {
            (Path::Straight { .. }, _) => (self.length, self.length / name.units.length),
            (Path::Arc(_), Place::Arc(_) | Place::Pieces(_)) => (self.length, self.length.to_degrees()),
            (Path::Arc(_), _) => return Ok(()),
        };
        if stretch <= length * (1.0 + 1e-9) {
            return Ok(());
        }
        let shown = (1e6 * shown).round() / 1e6;
        let ends = if path.has_both_sides() { "ends at |s| =" } else { "ends at" };
        let message = format!("the candidates reach beyond `{}`, whose contact side {ends} {shown}", name.text());
        Err(given.refused(message, format!("give at most {shown}")))
    }
}

/// Slopes against the path from which on normals along it are wrong: where the side begins, where a symmetric body has
/// none, and anywhere on the stretch.
const STEEP: [f64; 2] = [0.1, 0.5];

/// Whether pieces follow one another along a path, none of them over another \[mm, or rad\].
fn goes_on(pieces: &[Piece], path: &Path, near: f64) -> bool {
    let ends = |piece: &Piece| {
        let [a, b] = piece.map(|point| [path.coordinate(point), path.depth(point) / path.metric()]);
        if a[0] <= b[0] { [a, b] } else { [b, a] }
    };
    let mut all: Vec<_> = pieces.iter().map(ends).collect();
    all.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]));
    all.windows(2).all(|two| (0..2).all(|k| (two[0][1][k] - two[1][0][k]).abs() <= near))
}

/// Middle of a piece \[mm\].
fn middle([from, to]: Piece) -> [f64; 2] {
    [0, 1].map(|k| 0.5 * (from[k] + to[k]))
}

/// The slope of a piece that is too steep.
fn steep(pieces: &[Piece], path: &Path) -> Option<f64> {
    let begin = |[a, b]: &Piece| path.coordinate(*a).min(path.coordinate(*b));
    let first = pieces.iter().map(begin).fold(f64::INFINITY, f64::min);
    let [at_first, anywhere] = STEEP;
    let slopes = pieces.iter().map(|piece| {
        let [a, b] = piece;
        let along = (path.coordinate(*b) - path.coordinate(*a)).abs() * path.metric();
        ((path.depth(*b) - path.depth(*a)).abs() / along, !path.has_both_sides() && begin(piece) <= first)
    });
    let mut steep = slopes.filter(|(slope, is_first)| *slope > if *is_first { at_first } else { anywhere });
    steep.next().map(|(slope, _)| slope)
}

/// The face that has a name: the one called `contact`, or the opposite one by its own name, as the lower and as the
/// upper.
fn face(contact: Face, name: &str, [lower, upper]: [&str; 2]) -> Option<Face> {
    match contact {
        _ if name == CONTACT => Some(contact),
        Face::Bottom if name == upper => Some(Face::Top),
        Face::Top if name == lower => Some(Face::Bottom),
        _ => None,
    }
}

/// Chords that stand for an arc.
const CHORDS: usize = 32;

/// A curve as straight pieces.
fn chords(curve: &Curve) -> Vec<Piece> {
    let count = if matches!(curve, Curve::Arc { .. }) { CHORDS } else { 1 };
    let at = |k: usize| curve.point(k as f64 / count as f64);
    (0..count).map(|k| [at(k), at(k + 1)]).collect()
}

/// Where a side shall lie.
struct Wanted<'a> {
    path: &'a Path,
    /// The symmetry line, and the level of the path, as the file would write them.
    line: String,
    level: String,
    /// What may lie between the side and the path \[mm\].
    clearance: f64,
    is_first: bool,
    plane: PlaneHypothesis,
}

impl Wanted<'_> {
    /// What mends a side that lies elsewhere along the path: around the axis of revolution only one place is right.
    fn remedy(&self, in_the_plane: impl Into<String>) -> String {
        match self.plane.radial() == Some(0) && !self.path.has_both_sides() {
            true => {
                "model what lies at radii x ≥ 0: a contact begins on the axis x = 0, or is a ring with `both-sides \
                = true` and an `origin`"
                    .into()
            }
            false => in_the_plane.into(),
        }
    }

    fn near(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.clearance * (1.0 + 1e-6) + 1e-6 * a.abs().max(b.abs())
    }

    fn circle(&self, circle: &Circle, arc: &Circle) -> Option<Misfit> {
        let aligned = (0..2).all(|k| self.near(circle.centre[k], arc.centre[k]));
        let fits = if self.is_first {
            (circle.radius / arc.radius - 1.0).abs() <= 1e-9
        } else {
            self.near(circle.radius, arc.radius)
        };
        if aligned && fits {
            return None;
        }
        misfit(
            "does not lie on `arc`",
            "`arc` is the circle of the first body's side; the other lies there too, a gap apart at most",
        )
    }
}

/// What is wrong with a side, and what to do.
type Misfit = [String; 2];

fn misfit(what: impl Into<String>, remedy: impl Into<String>) -> Option<Misfit> {
    Some([what.into(), remedy.into()])
}
