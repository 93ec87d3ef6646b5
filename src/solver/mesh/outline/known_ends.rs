//! Positions along a contact whose ends are known.

use std::ops::Range;

use super::points::above;
use crate::mesh::spacing;
use crate::scene::{ContactPair, Scene};

/// Widest cell on an arc that carries a contact \[rad\].
const WIDEST: f64 = 0.8;
/// Size of a cell over that of the one nearer to an end, as of the frames of a rectangle.
const LARGER: f64 = 2.8;
/// Room beyond an end over the half-width, below which columns and rows there are as fine as that is wide; from the
/// first on, since a contact that ends nearer has none.
const NARROW: Range<f64> = 1e-3..0.2;
/// Difference of positions, over the stretch, below which they are one.
const SAME: f64 = 1e-9;

/// Distance of a line from a place of the contact, over its half-width, below which that serves.
const SERVES: f64 = 0.1;

/// A contact whose ends are known, and into how many each interval between them is cut.
pub(crate) struct KnownEnds<'a> {
    pair: &'a ContactPair,
    parts: usize,
    /// Contact coordinates on which lines lie besides: where rectangles are held and pressed from above or below.
    lines: Vec<f64>,
}

impl<'a> KnownEnds<'a> {
    /// None where the mesh knows nothing of the ends.
    pub fn of(scene: &Scene, pair: &'a ContactPair, parts: usize) -> Option<Self> {
        let lines = || pair.bodies().flat_map(|body| above(&scene.bodies[body])).map(|x| x - pair.path.origin()[0]);
        let lines = || if pair.path.is_straight() { lines().collect() } else { vec![] };
        (!pair.ends.places.is_empty()).then(|| Self { pair, parts, lines: lines() })
    }

    /// Half the distance of the two ends that are nearest to one another, of one contact half its width; from a
    /// symmetry line on where the contact begins there.
    pub fn half_width(&self) -> f64 {
        let places = &self.pair.ends.places;
        let on_line = places[..1].iter().copied().filter(|_| self.begins_on_line());
        let between = places.windows(2).map(|two| 0.5 * (two[1] - two[0]));
        let narrowest = on_line.chain(between).fold(f64::INFINITY, f64::min);
        if narrowest.is_finite() { narrowest } else { self.pair.stretch }
    }

    /// Half way from the first end to the last, or from a symmetry line to the last.
    pub fn reach(&self) -> f64 {
        match self.pair.ends.places[..] {
            [.., last] if self.begins_on_line() => last,
            [first, .., last] => 0.5 * (last - first),
            _ => self.pair.stretch,
        }
    }

    /// Whether the contact begins on a symmetry line: all stretches but the first have two ends.
    fn begins_on_line(&self) -> bool {
        !self.pair.path.has_both_sides() && self.pair.ends.places.len() % 2 == 1
    }

    /// Positions of the candidates from 0 on, with ends on either side of it.
    pub fn to_the_right(&self) -> Vec<f64> {
        self.cut(&self.breaks_to_the_right())
    }

    /// Positions of the candidates from `−stretch` on, with a position half way between neighbouring ends.
    pub fn across(&self) -> Vec<f64> {
        self.cut(&self.breaks_across())
    }

    /// Positions across a box on the contact: its ends, and half its width beyond them, or up to the end of the stretch
    /// where that is about as near; none where a kink of the gap lies outside.
    ///
    /// From the left side of the body on where the contact begins there or near it, or on both sides of the path's
    /// origin.
    pub fn of_box(&self, left: f64) -> Option<Vec<f64>> {
        let (path, places) = (&self.pair.path, &self.pair.ends.places);
        let (columns, origin) = match path.has_both_sides() {
            true => (self.near(self.breaks_across(), [places[0], places[places.len() - 1]]), path.origin()[0]),
            false if self.begins_on_line() => (self.of_right_box(), left),
            false => (self.near(self.breaks_to_the_right(), [places[0], places[places.len() - 1]]), left),
        };
        columns.map(|columns| columns.iter().map(|s| origin + s).collect())
    }

    /// The same from 0 on, with ends on either side of it.
    pub fn of_right_box(&self) -> Option<Vec<f64>> {
        let last = self.pair.ends.places.iter().map(|end| end.abs()).fold(0.0, f64::max);
        self.near(self.breaks_to_the_right(), [0.0, last])
    }

    /// Those of ascending breaks that are near the first and the last end, the intervals between them cut.
    fn near(&self, breaks: Vec<f64>, [first, last]: [f64; 2]) -> Option<Vec<f64>> {
        let far = (1.5 + SAME) * self.reach();
        let is_near = |s: &f64| first - far <= *s && *s <= last + far;
        let within: Vec<f64> = breaks.into_iter().filter(is_near).collect();
        let stretch = self.pair.stretch;
        let after = self.beyond(last, stretch, within.last());
        let before = self.beyond(first, -stretch, within.first());
        let columns = [before.into_iter().rev().collect(), within, after].concat();
        let holds_all = columns.len() > 1 && self.pair.profile.kinks().iter().all(is_near);
        holds_all.then(|| self.cut(&columns))
    }

    /// Columns of a box beyond candidates that end close to the contact, as much wider as these are; nothing where the
    /// box ends before them.
    fn beyond(&self, end: f64, candidates: f64, column: Option<&f64>) -> Vec<f64> {
        let (side, half) = (candidates.signum(), self.half_width());
        let room = side * (candidates - end);
        if !self.is_narrow(room) || column.is_none_or(|column| (column - candidates).abs() > SAME * half) {
            return vec![];
        }
        let last = end + half * side;
        towards(candidates, last, LARGER * room).into_iter().chain([last]).collect()
    }

    fn breaks_to_the_right(&self) -> Vec<f64> {
        let places = &self.pair.ends.places;
        if self.pair.path.has_both_sides() {
            let last = places.iter().map(|end| end.abs()).fold(0.0, f64::max);
            let crowded = self.crowded(last, self.pair.stretch);
            return self.breaks(places.iter().map(|end| end.abs()).chain(crowded).collect(), 0.0);
        }
        let line = places[..1].iter().filter(|_| !self.begins_on_line());
        let before = line.flat_map(|begin| towards(*begin, 0.0, self.half_width()));
        let crowded = self.crowded(places[places.len() - 1], self.pair.stretch);
        self.breaks(places.iter().copied().chain(self.between()).chain(before).chain(crowded).collect(), 0.0)
    }

    fn breaks_across(&self) -> Vec<f64> {
        let (places, stretch) = (&self.pair.ends.places, self.pair.stretch);
        let before = towards(places[0], -stretch, self.half_width());
        let crowded =
            [(places[0], -stretch), (places[places.len() - 1], stretch)].map(|(end, beyond)| self.crowded(end, beyond));
        let all = places.iter().copied().chain(self.between()).chain(before).chain(crowded.into_iter().flatten());
        self.breaks(all.collect(), -stretch)
    }

    /// The least that is between an outermost end and that of the stretch, which may be that of the body.
    pub fn room(&self) -> f64 {
        let (places, stretch) = (&self.pair.ends.places, self.pair.stretch);
        let [first, last] = [places[0], places[places.len() - 1]];
        if self.pair.path.has_both_sides() { (stretch - last).min(stretch + first) } else { stretch - last }
    }

    fn is_narrow(&self, room: f64) -> bool {
        NARROW.contains(&(room / self.half_width()))
    }

    /// Depths of the rows of a box that is so deep: one, but where there is little room beyond an end ever deeper ones,
    /// the first as deep as that is wide.
    pub fn rows(&self, depth: f64) -> Vec<f64> {
        let room = self.room();
        let within = if self.is_narrow(room) { towards(0.0, depth, room) } else { vec![] };
        [0.0].into_iter().chain(within).chain([depth]).collect()
    }

    /// Places from an outermost end inwards, the first as near to it as the end of the stretch is on its other side;
    /// nothing where that is far.
    fn crowded(&self, end: f64, beyond: f64) -> Vec<f64> {
        let room = (beyond - end) * beyond.signum();
        if self.is_narrow(room) { towards(end, 0.0, room) } else { vec![] }
    }

    /// Half way between neighbouring ends, and between there and both of them; nothing where the gap has a line of its
    /// own.
    fn between(&self) -> impl Iterator<Item = f64> {
        let (size, leaps) = (self.half_width(), self.pair.leaps());
        let is_whole = move |two: &&[f64]| !leaps.iter().any(|s| two[0] < *s && *s < two[1]);
        self.pair.ends.places.windows(2).filter(is_whole).flat_map(move |two| {
            let middle = 0.5 * (two[0] + two[1]);
            let from_both = two.iter().flat_map(move |end| towards(*end, middle, size));
            from_both.chain([middle])
        })
    }

    /// Positions from a place on: those given, kinks and leaps of the curvature of the gap, others beyond the last, the
    /// end of the stretch, and lines among them.
    fn breaks(&self, mut breaks: Vec<f64>, from: f64) -> Vec<f64> {
        let stretch = self.pair.stretch;
        breaks.extend(self.pair.profile.kinks());
        breaks.extend(self.pair.leaps());
        breaks.extend(self.pair.power_at_cusp().map(|_| 0.0));
        breaks.retain(|s| *s > from);
        breaks.sort_by(f64::total_cmp);
        let near = SAME * stretch;
        breaks.retain(|s| *s < stretch - near);
        breaks.dedup_by(|next, before| *next - *before <= near);
        let last = breaks.last().copied().unwrap_or(from);
        let beyond = towards(last, stretch, self.half_width());
        let mut all: Vec<f64> = [from].into_iter().chain(breaks).chain(beyond).chain([stretch]).collect();
        let own = all.clone();
        let is_free = |s: &f64| own.iter().all(|other| (other - s).abs() > SERVES * self.half_width());
        let lines = self.lines.iter().map(|s| if from < 0.0 { *s } else { s.abs() });
        all.extend(lines.filter(|s| from < *s && *s < stretch && is_free(s)));
        all.sort_by(f64::total_cmp);
        all.dedup_by(|next, before| *next - *before <= near);
        all
    }

    /// Each interval cut as often as is asked, on an arc so that none is wide.
    fn cut(&self, breaks: &[f64]) -> Vec<f64> {
        let widest = if self.pair.path.is_straight() { f64::INFINITY } else { WIDEST };
        let pieces = breaks.windows(2).map(|two| {
            let fewest = ((two[1] - two[0]) / widest - SAME).ceil();
            spacing::uniform(two[0], two[1], self.parts.max(fewest as usize))
        });
        spacing::joined(&pieces.collect::<Vec<_>>())
    }
}

/// Places from an end towards another place, ever farther apart: the first of them by a size.
fn towards(end: f64, place: f64, size: f64) -> Vec<f64> {
    let (mut at, away) = (end, (place - end).signum());
    let sizes = std::iter::successors(Some(size), |size| Some(LARGER * size));
    let places = sizes.map_while(|size| {
        let has_room = (place - at).abs() > 1.5 * size;
        at += away * size;
        has_room.then_some(at)
    });
    places.collect()
}
