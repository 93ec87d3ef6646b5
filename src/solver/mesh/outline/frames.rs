//! Rectangle or disc around a contact whose ends are known: a box on the contact, and frames of ever larger cells
//! around the box.
//!
//! Away from a contact all lengths grow alike, and one cell of high order across a frame is enough (geometric meshes,
//! Babuška & Guo 1988); columns and rows through the whole body would be as thin far away as they are at the contact.
//!
//! ```text
//!   ┌──────────────┐
//!   │ ╲          ╱ │   frame 2
//!   │  ┌────────┐  │
//!   │  │ ╲    ╱ │  │   frame 1
//!   │  │  ┌──┐  │  │   box, as deep as half the width of the contact
//!   └──┴──┴──┴──┴──┘   side that touches; one that begins on a symmetry line has the right half of it
//! ```

use std::cmp::Ordering;

use super::layout::Layout;
use crate::mesh::block::{Block, Point, Side, between};
use crate::mesh::spacing;
use crate::scene::Face;
use crate::scene::contact_pair::CONTACT;

/// About how much larger a frame of a rectangle is than the one inside it.
const LARGER: f64 = 2.8;
/// Least that a body is larger than the box.
const LEAST: f64 = 1.25;
/// Times its width from which on a body is too high for frames, which are thin beside the contact where they are deep
/// below it: half-widths under waves on a block of ten widths were 0.3 % off on cells of any order.
const TALL: f64 = 4.0;
/// The same the other way round: beyond the contact of a thin layer no frame has room to grow. Layers of 2.6 to 2.9 mm
/// by 40 mm, loaded on a part of their top, were up to 40 bars off.
const WIDE: f64 = 4.0;

/// A rectangle whose contact has ends that are known; none where it is too small for a frame, or has more to mesh than
/// one contact, or is held or pressed at a point of its left or right.
pub(super) fn blocks(layout: &Layout, x: [f64; 2], y: [f64; 2], contact: Face) -> Option<Vec<Block>> {
    let is_beside = |point: &[f64; 2]| x.contains(&point[0]) && !y.contains(&point[1]);
    let ends = layout.same_ends().filter(|_| layout.opposite.is_none() && !layout.points.iter().any(is_beside))?;
    let columns = ends.of_box(x[0])?;
    let has_left = layout.path.has_both_sides() || columns[0] > x[0];
    let within = (columns, ends.half_width(), has_left);
    let opposite = if contact == Face::Bottom { y[1] } else { y[0] };
    let far = layout.points.iter().filter(|point| point[1] == opposite).map(|point| point[0]).collect();
    let rows = ends.rows(ends.half_width()).iter().map(|depth| depth / ends.half_width()).collect();
    let frames = Frames { far, rows, ..Frames::around(within, (x, y[1] - y[0]), LARGER)? };
    if frames.breaks(frames.ends.len() - 1).len() > frames.columns.len() {
        return None;
    }
    // The far side to the last bit, as supports and other bodies know it.
    let height = |depth: f64| match (contact, depth < y[1] - y[0]) {
        (Face::Bottom, true) => y[0] + depth,
        (Face::Top, true) => y[1] - depth,
        (Face::Bottom, false) => y[1],
        (Face::Top, false) => y[0],
    };
    let blocks = frames.blocks(layout, &|x, depth| [x, height(depth)], None);
    Some(match contact {
        Face::Bottom => blocks,
        Face::Top => blocks.into_iter().map(Block::upside_down).collect(),
    })
}

/// The box and the frames around it: number k reaches from `begins[k]` to `ends[k]`, and down to `depths[k]`; 0 is the
/// box.
pub(super) struct Frames {
    /// Positions across the box.
    columns: Vec<f64>,
    begins: Vec<f64>,
    ends: Vec<f64>,
    depths: Vec<f64>,
    /// Whether there are cells on the left of the box: it does not begin on a symmetry line.
    has_left: bool,
    /// Fractions of the depth of the box at which its rows begin and end.
    rows: Vec<f64>,
    /// Positions opposite the contact on which corners of cells shall lie.
    far: Vec<f64>,
}

impl Frames {
    /// Around a box of some columns and a depth, with cells on its left or without, in a body that reaches from `left`
    /// to `right` and is so deep, each about so much larger than the one inside it; none where the body is too small
    /// for a frame, or too high.
    pub(super) fn around(
        (columns, first, has_left): (Vec<f64>, f64, bool),
        ([left, right], depth): ([f64; 2], f64),
        larger: f64,
    ) -> Option<Self> {
        let [begin, end] = [columns[0], columns[columns.len() - 1]];
        let middle = if has_left { 0.5 * (begin + end) } else { left };
        let [wide, leftwards] = [(right - middle) / (end - middle), (middle - left) / (middle - begin)];
        let deep = depth / first;
        let sides = [wide, deep, if has_left { leftwards } else { deep }];
        let across = if has_left { wide.max(leftwards) } else { wide };
        if !sides.into_iter().all(|larger| larger >= LEAST) || deep > TALL * across || across > WIDE * deep {
            return None;
        }
        let largest = sides.into_iter().fold(1.0, f64::max);
        let count = (largest.ln() / larger.ln()).round().max(1.0) as i32;
        let powers = |larger: f64| (0..=count).map(move |k| larger.powf(f64::from(k) / f64::from(count)));
        let mut ends: Vec<f64> = powers(wide).map(|power| middle + (end - middle) * power).collect();
        let mut begins: Vec<f64> = match has_left {
            true => powers(leftwards).map(|power| middle - (middle - begin) * power).collect(),
            false => vec![left; ends.len()],
        };
        let mut depths: Vec<f64> = powers(deep).map(|power| first * power).collect();
        let last = ends.len() - 1;
        (begins[last], ends[last], depths[last]) = (left, right, depth);
        Some(Self { columns, begins, ends, depths, has_left, rows: vec![0.0, 1.0], far: vec![] })
    }

    /// Columns of the box to the left and to the right of about its middle; all of them to the right of a symmetry
    /// line.
    pub(super) fn columns(&self) -> [usize; 2] {
        let (count, middle) = (self.columns.len() - 1, 0.5 * (self.columns[0] + self.columns[self.columns.len() - 1]));
        let away = |k: &usize| (self.columns[*k] - middle).abs();
        let nearest = (1..count).min_by(|a, b| away(a).total_cmp(&away(b))).filter(|_| self.has_left);
        let left = nearest.unwrap_or(0);
        [left, count - left]
    }

    /// Positions below the box or a frame: those across the box, as much farther apart; opposite the contact with those
    /// that shall be corners.
    fn breaks(&self, k: usize) -> Vec<f64> {
        let (first, width) = (self.columns[0], self.columns[self.columns.len() - 1] - self.columns[0]);
        let (begin, wider) = (self.begins[k], (self.ends[k] - self.begins[k]) / width);
        let breaks: Vec<f64> = self.columns.iter().map(|x| begin + (x - first) * wider).collect();
        if k == self.ends.len() - 1 { spacing::through(&breaks, &self.far) } else { breaks }
    }

    /// From where to where the frames inside the last one reach.
    pub(super) fn inner(&self) -> [f64; 2] {
        let inside = self.ends.len() - 2;
        [self.begins[inside], self.ends[inside]]
    }

    /// The same whose last frame begins where the candidates end, if these go on beyond: a cell that reaches from among
    /// them to the end of the body would make candidates of nodes that may be held there.
    pub(super) fn holding(mut self, candidates: f64) -> Self {
        let inside = self.ends.len() - 2;
        if inside > 0 && self.ends[inside] < candidates {
            self.ends[inside] = candidates;
            if self.has_left {
                self.begins[inside] = self.begins[inside].min(0.0 - candidates);
            }
        }
        self
    }

    /// The blocks, from the point at a place along the side that touches and a depth below it; the last frame ends on a
    /// line of its own where that is given.
    pub(super) fn blocks(&self, layout: &Layout, place: &dyn Fn(f64, f64) -> Point, rim: Option<&Rim>) -> Vec<Block> {
        let draft = Draft { frames: self, layout, place, rim };
        let around = (1..self.ends.len()).flat_map(|k| {
            let left = self.has_left.then(|| draft.beside(k, "left", &self.begins).the_other_way());
            [draft.below(k), draft.beside(k, "right", &self.ends)].into_iter().chain(left)
        });
        [draft.within()].into_iter().chain(around).collect()
    }
}

/// Where the last frame ends.
pub(super) struct Rim {
    /// Opposite the contact, from left to right.
    pub far: Vec<Point>,
    /// On the right, from the side that touches to the end of `far`.
    pub right: Vec<Point>,
    /// On the left, from the side that touches to the begin of `far`; nothing where the frames begin on a symmetry
    /// line.
    pub left: Vec<Point>,
}

/// Draws the blocks of the frames.
struct Draft<'a> {
    frames: &'a Frames,
    layout: &'a Layout<'a>,
    /// The point at a place along the side that touches and a depth below it.
    place: &'a dyn Fn(f64, f64) -> Point,
    rim: Option<&'a Rim>,
}

impl Draft<'_> {
    /// The box.
    fn within(&self) -> Block {
        let frames = self.frames;
        let bottom = self.layout.along(&frames.columns, |x| (self.place)(x, 0.0));
        let left = self.downwards(0, frames.begins[0]);
        Block {
            bottom: Side::named(CONTACT, bottom),
            right: Side::inner(self.downwards(0, frames.ends[0])),
            top: Side::inner(self.across(0)),
            left: if frames.has_left { Side::inner(left) } else { Side::named("left", left) },
        }
    }

    /// The part of a frame that lies below the one inside it, as deep as it is thick.
    fn below(&self, k: usize) -> Block {
        let frames = self.frames;
        let left = self.diagonal(k, &frames.begins);
        Block {
            bottom: Side::inner(self.across(k - 1)),
            right: Side::inner(self.diagonal(k, &frames.ends)),
            top: self.outer(k, "far", self.across(k)),
            left: if frames.has_left { Side::inner(left) } else { Side::named("left", left) },
        }
    }

    /// The part of a frame beside the one inside it, as on its right: on the side of a name, where the frames reach so
    /// far.
    fn beside(&self, k: usize, name: &'static str, x: &[f64]) -> Block {
        Block {
            bottom: Side::named(CONTACT, self.outwards(k, x, &vec![0.0; x.len()])),
            right: self.outer(k, name, self.downwards(k, x[k])),
            top: Side::inner(self.diagonal(k, x)),
            left: Side::inner(self.downwards(k - 1, x[k - 1])),
        }
    }

    /// A side of the body where a frame is the last one.
    fn outer(&self, k: usize, name: &'static str, points: Vec<Point>) -> Side {
        if k == self.last() { Side::named(name, points) } else { Side::inner(points) }
    }

    /// Number of the last frame.
    fn last(&self) -> usize {
        self.frames.ends.len() - 1
    }

    /// What the last frame ends on.
    fn rim(&self, k: usize) -> Option<&Rim> {
        self.rim.filter(|_| k == self.last())
    }

    /// Below the box or a frame, from its left end to its right end, in its columns.
    fn across(&self, k: usize) -> Vec<Point> {
        if let Some(rim) = self.rim(k) {
            return rim.far.clone();
        }
        self.layout.along(&self.frames.breaks(k), |x| (self.place)(x, self.frames.depths[k]))
    }

    /// Beside the box or a frame, from the side that touches to its depth.
    fn downwards(&self, k: usize, x: f64) -> Vec<Point> {
        if let Some(rim) = self.rim(k) {
            return if x < self.frames.ends[k] { rim.left.clone() } else { rim.right.clone() };
        }
        let depth = self.frames.depths[k];
        let rows = self.frames.rows.windows(2).map(|row| spacing::uniform(row[0], row[1], self.layout.parts()));
        let rows = spacing::joined(&rows.collect::<Vec<_>>());
        self.layout.along(&rows, |t| (self.place)(x, if t < 1.0 { t * depth } else { depth }))
    }

    /// From a lower corner of the frame inside to that of a frame.
    fn diagonal(&self, k: usize, x: &[f64]) -> Vec<Point> {
        let depths = &self.frames.depths;
        let to = self.rim(k).and_then(|rim| match x[k].total_cmp(&x[k - 1]) {
            Ordering::Less => rim.far.first(),
            Ordering::Equal => None,
            Ordering::Greater => rim.far.last(),
        });
        let Some(to) = to else { return self.outwards(k, x, depths) };
        let from = (self.place)(x[k - 1], depths[k - 1]);
        self.layout.along(&self.parts(), |t| between(from, *to, t))
    }

    /// From a corner of the frame inside to that of a frame.
    fn outwards(&self, k: usize, x: &[f64], depth: &[f64]) -> Vec<Point> {
        let between = |of: &[f64], t: f64| if t < 1.0 { of[k - 1] + (of[k] - of[k - 1]) * t } else { of[k] };
        self.layout.along(&self.parts(), |t| (self.place)(between(x, t), between(depth, t)))
    }

    /// The parts in which a cell's side is cut where the mesh is finer.
    fn parts(&self) -> Vec<f64> {
        spacing::uniform(0.0, 1.0, self.layout.parts())
    }
}
