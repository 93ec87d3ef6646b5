//! Bodies from blocks given one by one.

use crate::case::file::form::Form::{Count, List, Table, Text};
use crate::case::file::form::{Form, PAIR, may, must};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::{BlockShape, Shape};

/// Most blocks of a body.
const MOST: usize = 64;
/// Points closer than this fraction of the body's size are one.
const SAME: f64 = 1e-7;
/// Largest element of a side over its smallest.
const MOST_GROWTH: f64 = 1e6;
/// The four sides by name.
const SIDES: [&str; 4] = ["bottom", "right", "top", "left"];

/// `{ corners = […], elements = [n, m], growth = [p, q], bottom = "contact", …, arcs = { bottom = [x, y], … } }` has
/// corners counter-clockwise, elements and their growth from left to right and from bottom to top, names of the sides
/// that are boundaries, and centres of those that are arcs.
pub(super) const BLOCK: Form = Table(&[
    must("corners", List(&PAIR)),
    must("elements", List(&Count)),
    may("growth", PAIR),
    may("bottom", Text),
    may("right", Text),
    may("top", Text),
    may("left", Text),
    may("arcs", Table(&[may("bottom", PAIR), may("right", PAIR), may("top", PAIR), may("left", PAIR)])),
]);

/// The blocks, each convex, meeting along whole sides with the same elements.
pub fn shape(given: Value, blocks: Value) -> Result<Shape, Error> {
    let tables = blocks.entries();
    let is_other = !(1..=MOST).contains(&tables.len());
    given.refuse_if(is_other, format!("there are {} blocks", tables.len()), format!("give 1 to {MOST}"))?;
    let blocks = tables.iter().map(|table| block(*table)).collect::<Result<Vec<_>, Error>>()?;
    refuse_unequal(&tables, &blocks)?;
    Ok(Shape::Blocks(blocks))
}

fn block(table: Value) -> Result<BlockShape, Error> {
    let [a, b, c, d] = table.at("corners").exactly()?.map(Value::point);
    let corners = [a?, b?, c?, d?];
    // Along the bottom and the right side.
    let [n, m] = table.at("elements").exactly()?.map(|given: Value| given.count(2000, " along each side"));
    let elements = [n?, m?];
    let growth = growth(table, elements)?;
    let arcs = arcs(table, &corners)?;
    let turns = |k: usize| {
        let [a, b, c] = [0, 1, 2].map(|i| corners[(k + i) % 4]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    if !(0..4).all(|k| turns(k) > 0.0) {
        let remedy =
            "give the four corners of a convex block counter-clockwise: bottom from corner 1 to 2, right from 2 to 3";
        return Err(table.refused("the corners do not go round counter-clockwise", remedy));
    }
    let names = SIDES.map(|side| table.get(side).map(|name| name.text().to_owned().into()));
    Ok(BlockShape { corners, arcs, names, elements, growth })
}

/// Growth of the elements along both, from one to the next.
fn growth(table: Value, elements: [usize; 2]) -> Result<[f64; 2], Error> {
    let mut growth = [1.0; 2];
    let Some(list) = table.get("growth") else { return Ok(growth) };
    for ((ratio, given), count) in growth.iter_mut().zip(list.exactly::<2>()?).zip(elements) {
        *ratio = given.within("a ratio between 0.2 and 5", |x| (0.2..=5.0).contains(&x))?;
        if (ratio.ln() * (count as f64 - 1.0)).abs() > MOST_GROWTH.ln() {
            let message = format!("{count} elements growing by {ratio} differ by more than {MOST_GROWTH:e}");
            return Err(given.refused(message, "give fewer elements or gentler growth"));
        }
    }
    Ok(growth)
}

/// Centres of the sides that are arcs \[mm\].
fn arcs(table: Value, corners: &[[f64; 2]; 4]) -> Result<[Option<[f64; 2]>; 4], Error> {
    let mut arcs = [None; 4];
    let given = SIDES.map(|side| table.get("arcs").and_then(|arcs| arcs.get(side)));
    for (k, (arc, pair)) in arcs.iter_mut().zip(given).enumerate() {
        let Some(pair) = pair else { continue };
        let centre = pair.called("arcs").point()?;
        let ends = [corners[k], corners[(k + 1) % 4]];
        let [a, b] = ends.map(|p| [p[0] - centre[0], p[1] - centre[1]]);
        let [r, q] = [a, b].map(|p| p[0].hypot(p[1]));
        let half_turn = a[0] * b[0] + a[1] * b[1] <= -0.999 * r * q;
        if r <= 0.0 || (r / q - 1.0).abs() > 1e-6 || half_turn {
            let [r, q] = [r, q].map(|radius| radius / table.units.length);
            let message = format!("the ends of `{}` lie {r} and {q} from the arc's centre", SIDES[k]);
            let remedy = "give the centre of a circle through both corners, less than half a turn apart";
            return Err(pair.refused(message, remedy));
        }
        *arc = Some(centre);
    }
    Ok(arcs)
}

/// Refuses blocks that meet along a part of a side, or with other elements: their nodes would not be common.
fn refuse_unequal(tables: &[Value], blocks: &[BlockShape]) -> Result<(), Error> {
    let size = blocks.iter().flat_map(|b| b.corners).flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let same = |a, b| apart(a, b) <= SAME * size;
    // Ends of a side, and its elements with their growth in that direction.
    let side = |block: &BlockShape, k: usize| {
        let ratio = block.growth[k % 2];
        let along = if k < 2 { ratio } else { 1.0 / ratio };
        ([block.corners[k], block.corners[(k + 1) % 4]], block.elements[k % 2], along)
    };
    for (i, one) in blocks.iter().enumerate() {
        for (j, other) in blocks.iter().enumerate().filter(|(j, _)| *j != i) {
            for (k, l) in (0..4).flat_map(|k| (0..4).map(move |l| (k, l))) {
                let (([a, b], n, ratio), ([c, d], m, back)) = (side(one, k), side(other, l));
                if same(a, d) && same(b, c) && (n != m || n > 1 && (ratio * back - 1.0).abs() > 1e-9) {
                    let message =
                        format!("block {} has other elements along the side it shares with block {}", j + 1, i + 1);
                    return Err(tables[j].refused(message, "give both the same number and growth there"));
                }
                let inside = |p| !same(p, a) && !same(p, b) && apart(a, p) + apart(p, b) <= (1.0 + SAME) * apart(a, b);
                if one.arcs[k].is_none() && inside(c) {
                    let message = format!("a corner of block {} lies inside a side of block {}", j + 1, i + 1);
                    return Err(tables[j].refused(message, "blocks meet along whole sides: divide the longer one"));
                }
            }
        }
    }
    Ok(())
}
