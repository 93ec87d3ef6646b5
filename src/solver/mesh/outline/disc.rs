//! A disc or a sector of it: outer blocks between the arc and a polygon, core blocks around the centre. Where the ends
//! of a contact are known that is small against the disc, its lower quarter is made of frames around it.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::frames::{Frames, Rim};
use super::known_ends::KnownEnds;
use super::layout::{Layout, Rays, last_two};
use crate::mesh::block::{Block, Point, Side, between, polar};
use crate::mesh::spacing;
use crate::scene::{ContactPair, Sector};

/// Corner radius of the core over the disc's, on the axes and on the diagonal.
const CORE: [f64; 2] = [0.45, 0.58];

pub(super) fn blocks(layout: &Layout, centre: Point, radius: f64, sector: Sector) -> Vec<Block> {
    let framed = match layout.opposite {
        None => framed(layout, centre, radius, sector),
        Some(pairs) if sector.has_upper_part() => framed_at_both_ends(layout, pairs, (centre, radius), sector),
        Some(_) => None,
    };
    if let Some(blocks) = framed {
        return blocks;
    }
    let right = match sector.has_upper_part() {
        // As fine at the highest point as at the lowest.
        true if layout.opposite.is_some() => joined(centre, both_ends(layout, centre, radius)),
        half => right_blocks(layout, centre, radius, half),
    };
    if !sector.has_both_sides() {
        return right;
    }
    Block::with_images(right.into_iter().map(|block| block.without("axis")).collect(), centre[0])
}

/// Frames around the contacts at the lowest and at the highest point; none where either has no room for them, or other
/// columns.
fn framed_at_both_ends<'a>(
    layout: &Layout<'a>,
    pairs: [&'a ContactPair; 2],
    (centre, radius): (Point, f64),
    sector: Sector,
) -> Option<Vec<Block>> {
    let part = if sector.has_both_sides() { Sector::LowerHalf } else { Sector::Quarter };
    let [lower, upper] = pairs.map(|pair| framed(&layout.alone(pair), centre, radius, part));
    let (lower, upper) = (lower?, upper?);
    (cut(&lower) == cut(&upper)).then(|| joined(centre, [lower, upper]))
}

/// The lower quarter and the upper one, turned over: each with the lines of its own contact alone where they have as
/// many, else alike, with those of both.
fn both_ends(layout: &Layout, centre: Point, radius: f64) -> [Vec<Block>; 2] {
    let quarter = |layout: &Layout| right_blocks(layout, centre, radius, false);
    if let Some(each) = layout.each_of_two() {
        let [lower, upper] = each.map(|alone| quarter(&alone));
        let shared = lower.iter().map(|block| cut(std::slice::from_ref(block)));
        let upper = upper.into_iter().zip(shared);
        let upper = upper.map(|(block, shared)| block.instead_of("cut", |_| Side::named("cut", shared.clone())));
        let upper: Vec<Block> = upper.collect();
        if lower.iter().map(Block::size).eq(upper.iter().map(Block::size)) {
            return [lower, upper];
        }
    }
    let lower = quarter(layout);
    [lower.clone(), lower]
}

/// A lower part and another one, turned over, that meet in the horizontal diameter.
fn joined(centre: Point, parts: [Vec<Block>; 2]) -> Vec<Block> {
    let [lower, upper] = parts.map(Vec::into_iter);
    let lower = lower.map(|block| block.instead_of("cut", |points| Side::line("middle", points)));
    let image = |block: Block| {
        let turned = block.turned_over(centre[1]).without("cut");
        turned.instead_of("contact", |points| Side::named("top", points))
    };
    lower.chain(upper.map(image)).collect()
}

/// The points of a lower part on its upper end.
fn cut(blocks: &[Block]) -> Vec<Point> {
    let sides = blocks.iter().flat_map(Block::sides).filter(|side| side.is_on("cut"));
    sides.flat_map(|side| side.points.clone()).collect()
}

/// Largest half-width of a contact over the radius that frames are laid around.
const SMALL: f64 = 0.25;
/// Farthest that the box around it, and the candidates, may reach from the middle of the disc, over the radius.
const REACH: f64 = 0.8;
/// Depth of the box on the contact over the half-width, and about how much larger a frame is than the one inside it:
/// with order 5 and two layers cylinders on each other and on a block are found to 7e-6, with 0.7 and 3 to 1.6e-5 by
/// more cells.
const DEPTH: f64 = 0.9;
const LARGER: f64 = 3.3;

/// The lower right quarter, or the right half.
fn right_blocks(layout: &Layout, centre: Point, radius: f64, half: bool) -> Vec<Block> {
    let arcs = arcs(layout, Rays::of(centre, radius), half);
    let depth = layout.depth(local_size(&arcs, 0, radius), radius * (1.0 - CORE[0]));
    wheel(layout, centre, radius, &arcs, depth.len() - 1, half)
}

/// A sector with frames around the contact, the last of which fills its lower part; the upper one as coarse as they
/// are.
fn framed(layout: &Layout, centre: Point, radius: f64, sector: Sector) -> Option<Vec<Block>> {
    let is_small = |ends: &&KnownEnds| layout.path.is_straight() && ends.reach() <= SMALL * radius;
    let ends = layout.same_ends().filter(is_small)?;
    let has_left = sector.has_both_sides();
    // Along x and into the depth in radii: bodies in contact have their nodes at the same x.
    let columns = if has_left { ends.of_box(0.0)? } else { ends.of_right_box()? };
    let middle = if has_left { centre[0] } else { 0.0 };
    let columns: Vec<f64> = columns.iter().map(|x| (x - middle) / radius).collect();
    if columns.iter().any(|x| x.abs() > REACH) {
        return None;
    }
    let within = (columns, DEPTH * ends.reach() / radius, has_left);
    let begin = if has_left { -1.0 } else { 0.0 };
    let frames = Frames::around(within, ([begin, 1.0], 1.0), LARGER)?;
    let candidates = layout.stretch / radius;
    let frames = if candidates <= REACH { frames.holding(candidates) } else { frames };

    let [left, right] = frames.columns().map(|columns| coarse(layout, centre, radius, columns));
    let mirrored = |point: &Point| [2.0 * centre[0] - point[0], point[1]];
    let diameter = |half: &[Block]| half[4].top.points.clone();
    let to_left = diameter(&left).iter().skip(1).rev().map(mirrored).collect::<Vec<_>>();
    let rim = Rim {
        far: to_left.into_iter().filter(|_| has_left).chain(diameter(&right)).collect(),
        right: right[1].right.points.clone(),
        left: left[1].right.points.iter().map(mirrored).collect(),
    };
    let inner = frames.inner();
    let place = |x: f64, depth: f64| polar(centre, radius * (1.0 - depth), angle(x, inner));
    let across = |points| match sector.has_upper_part() {
        true => Side::line("middle", points),
        false => Side::named("cut", points),
    };
    let axis = |points| if has_left { across(points) } else { Side::named("axis", points) };
    let lower = frames.blocks(layout, &place, Some(&rim)).into_iter();
    let lower = lower.map(|block| block.instead_of("far", across).instead_of("right", across).instead_of("left", axis));
    let upper = |half: &[Block]| [2, 3, 5].map(|k| half[k].clone());
    let all = match (sector.has_upper_part(), has_left) {
        (false, _) => lower.collect(),
        (true, false) => lower.chain(upper(&right)).collect(),
        (true, true) => {
            let left = upper(&left).map(|block| block.seen_in_mirror(centre[0]));
            lower.chain(upper(&right).into_iter().chain(left).map(|block| block.without("axis"))).collect()
        }
    };
    Some(all)
}

/// Angle of the point of the unit circle at x; beyond the inner frames, where x would crowd towards the horizontal
/// diameter, evenly up to that.
fn angle(x: f64, inner: [f64; 2]) -> f64 {
    let beyond = |end: f64| {
        let (from, side) = (end.asin(), end.signum());
        from + (side * FRAC_PI_2 - from) * (x - end) / (side - end)
    };
    match inner {
        [begin, _] if x < begin => beyond(begin),
        [_, end] if x > end => beyond(end),
        _ => x.asin(),
    }
}

/// The right half with so many columns at the highest and the lowest point, and no more elements than it must have.
fn coarse(layout: &Layout, centre: Point, radius: f64, columns: usize) -> Vec<Block> {
    let parts = layout.parts();
    let arc = |k: usize| {
        let [from, to] = [k, k + 1].map(|k| k as f64 * FRAC_PI_4);
        spacing::uniform(from, to, if k.is_multiple_of(3) { columns.max(1) } else { parts })
    };
    wheel(layout, centre, radius, &[0, 1, 2, 3].map(arc), parts, true)
}

/// Blocks of so many rows between the pieces of an arc and a polygon, then those of the core.
fn wheel(layout: &Layout, centre: Point, radius: f64, arcs: &[Vec<f64>], rows: usize, half: bool) -> Vec<Block> {
    let corner = |k: usize| {
        let angle = if half || k != 1 { k as f64 * FRAC_PI_4 } else { last(&arcs[0]) };
        polar(centre, radius * CORE[k % 2], angle)
    };
    let spokes: Vec<Vec<Point>> = (0..=arcs.len())
        .map(|k| {
            let angle = if k == 0 { 0.0 } else { last(&arcs[k - 1]) };
            spoke(layout, polar(centre, radius, angle), corner(k), rows, local_size(arcs, k, radius))
        })
        .collect();
    let at = |angle: f64| polar(centre, radius, angle);
    let arc = |k: usize| match k {
        0 if layout.ends.is_some() => layout.along_contact(Rays::of(centre, radius), &arcs[0], at),
        _ => layout.along(&arcs[k], at),
    };
    let polygon: Vec<Vec<Point>> = (0..arcs.len()).map(|k| chord(layout, &arcs[k], corner(k), corner(k + 1))).collect();
    let mut blocks: Vec<Block> = (0..arcs.len())
        .map(|k| Block {
            bottom: Side::named(if k < 2 { "contact" } else { "top" }, arc(k)),
            right: last_side(&spokes[k + 1], k + 1, half),
            top: Side::inner(polygon[k].clone()),
            left: if k == 0 { Side::named("axis", spokes[0].clone()) } else { Side::inner(spokes[k].clone()) },
        })
        .collect();
    blocks.extend(core(layout, arcs, &polygon, centre, half));
    blocks
}

/// The arc in pieces of about 45°; each piece is a list of angles.
fn arcs(layout: &Layout, on: Rays, half: bool) -> Vec<Vec<f64>> {
    let mut quarter = layout.arc(on, &[FRAC_PI_4, FRAC_PI_2]);
    if quarter.len() < 3 {
        quarter.insert(1, FRAC_PI_4);
    }
    // Both pieces have an element, however coarse.
    let split = nearest(&quarter, FRAC_PI_4).clamp(1, quarter.len() - 2);
    let mut arcs = vec![quarter[..=split].to_vec(), quarter[split..].to_vec()];
    if half {
        let [before, last] = last_two(&arcs[1]);
        arcs.push(spacing::fitted(last, 3.0 * FRAC_PI_4, arcs[1].len().min(9) - 1, last - before));
        arcs.push(spacing::uniform(3.0 * FRAC_PI_4, PI, arcs[0].len() - 1));
    }
    arcs
}

fn last<T: Copy>(list: &[T]) -> T {
    list[list.len() - 1]
}

fn nearest(positions: &[f64], target: f64) -> usize {
    let distance = |i: &usize| (positions[*i] - target).abs();
    (1..positions.len() - 1).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// Size of the surface elements where spoke `k` meets the arc.
fn local_size(arcs: &[Vec<f64>], k: usize, radius: f64) -> f64 {
    match k {
        0 => radius * (arcs[0][1] - arcs[0][0]),
        _ => {
            let [before, last] = last_two(&arcs[k - 1]);
            radius * (last - before)
        }
    }
}

/// From the arc to a corner of the core, in so many intervals, starting with the local surface size.
fn spoke(layout: &Layout, from: Point, to: Point, n: usize, size: f64) -> Vec<Point> {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let first = (size * layout.grading.first).min(length / n as f64);
    let positions = spacing::fitted(0.0, length, n, first);
    layout.along(&positions, |d| between(from, to, d / length))
}

/// Side of the core opposite to an arc: half way between the arc's spacing and an even one.
fn chord(layout: &Layout, arc: &[f64], from: Point, to: Point) -> Vec<Point> {
    let n = arc.len() - 1;
    let sweep = arc[n] - arc[0];
    let positions: Vec<f64> =
        arc.iter().enumerate().map(|(k, a)| 0.4 * (a - arc[0]) / sweep + 0.6 * k as f64 / n as f64).collect();
    layout.along(&positions, |t| between(from, to, t))
}

/// The second spoke lies on the cut, or on the line `middle` inside a half disc; the last one on the axis.
fn last_side(points: &[Point], k: usize, half: bool) -> Side {
    match (k, half) {
        (2, false) => Side::named("cut", points.to_vec()),
        (2, true) => Side::line("middle", points.to_vec()),
        (4, _) => Side::named("axis", points.to_vec()),
        _ => Side::inner(points.to_vec()),
    }
}

fn core(layout: &Layout, arcs: &[Vec<f64>], polygon: &[Vec<Point>], centre: Point, half: bool) -> Vec<Block> {
    let count = |k: usize| arcs[k].len() - 1;
    let straight =
        |from: Point, to: Point, n: usize| layout.along(&spacing::uniform(0.0, 1.0, n), |t| between(from, to, t));
    let (low, cut) = (polygon[0][0], last(&polygon[1]));
    let diameter = straight(centre, cut, count(0));
    let lower = Block {
        bottom: Side::inner(polygon[0].clone()),
        right: Side::inner(polygon[1].clone()),
        top: if half { Side::line("middle", diameter.clone()) } else { Side::named("cut", diameter.clone()) },
        left: Side::named("axis", straight(low, centre, count(1))),
    };
    if !half {
        return vec![lower];
    }
    let high = last(&polygon[3]);
    let upper = Block {
        bottom: Side::inner(diameter),
        right: Side::inner(polygon[2].clone()),
        top: Side::inner(polygon[3].iter().rev().copied().collect()),
        left: Side::named("axis", straight(centre, high, count(2))),
    };
    vec![lower, upper]
}
