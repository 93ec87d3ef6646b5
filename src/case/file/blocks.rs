//! Bodies from blocks given one by one.

use std::ops::Range;

use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::{BlockTable, Keyed};
use crate::case::file::units::Units;
use crate::error::Error;
use crate::scene::{BlockShape, Shape};

/// Most blocks of a body.
const MOST: usize = 64;
/// Points closer than this fraction of the body's size are one.
const SAME: f64 = 1e-7;
/// The four sides by name.
const SIDES: [&str; 4] = ["bottom", "right", "top", "left"];

/// The blocks, each convex, meeting along whole sides with the same elements.
pub fn shape(
    source: Source,
    units: &Units,
    place: Range<usize>,
    tables: &[Spanned<Keyed<BlockTable>>],
) -> Result<Shape, Error> {
    if tables.is_empty() || tables.len() > MOST {
        return Err(source.refused(place, format!("there are {} blocks", tables.len()), format!("give 1 to {MOST}")));
    }
    let blocks = tables.iter().map(|table| block(source, units, table)).collect::<Result<Vec<_>, Error>>()?;
    refuse_unequal(source, tables, &blocks)?;
    Ok(Shape::Blocks(blocks))
}

fn block(source: Source, units: &Units, spanned: &Spanned<Keyed<BlockTable>>) -> Result<BlockShape, Error> {
    let table = spanned.get_ref();
    let mut corners = [[0.0; 2]; 4];
    for (corner, pair) in corners.iter_mut().zip(source.entries::<_, 4>("corners", &table.corners)?) {
        *corner = source.pair("corners", pair)?.map(|x| units.length * x);
    }
    let elements = elements(source, table)?;
    let growth = growth(source, table, elements)?;
    let arcs = arcs(source, units, table, &corners)?;
    let turns = |k: usize| {
        let [a, b, c] = [0, 1, 2].map(|i| corners[(k + i) % 4]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    if !(0..4).all(|k| turns(k) > 0.0) {
        let remedy =
            "give the four corners of a convex block counter-clockwise: bottom from corner 1 to 2, right from 2 to 3";
        return Err(source.refused(spanned.span(), "the corners do not go round counter-clockwise", remedy));
    }
    let name = |name: &Option<Spanned<String>>| name.as_ref().map(|name| name.get_ref().clone().into());
    let names = [name(&table.bottom), name(&table.right), name(&table.top), name(&table.left)];
    Ok(BlockShape { corners, arcs, names, elements, growth })
}

/// Numbers of elements along the bottom and the right side.
fn elements(source: Source, table: &BlockTable) -> Result<[usize; 2], Error> {
    let mut elements = [0; 2];
    for (count, given) in elements.iter_mut().zip(source.entries::<_, 2>("elements", &table.elements)?) {
        *count = *given.get_ref();
        if !(1..=2000).contains(count) {
            return Err(source.refused(
                given.span(),
                format!("`elements` is {count}"),
                "give 1 to 2000 along each side",
            ));
        }
    }
    Ok(elements)
}

/// Growth of the elements along both, from one to the next.
fn growth(source: Source, table: &BlockTable, elements: [usize; 2]) -> Result<[f64; 2], Error> {
    let mut growth = [1.0; 2];
    if let Some(pair) = &table.growth {
        for ((ratio, given), count) in growth.iter_mut().zip(source.entries::<_, 2>("growth", pair)?).zip(elements) {
            *ratio = source.number("growth", given, "a ratio between 0.2 and 5", |x| (0.2..=5.0).contains(&x))?;
            if (ratio.ln() * (count as f64 - 1.0)).abs() > MOST_GROWTH.ln() {
                let message = format!("{count} elements growing by {ratio} differ by more than {MOST_GROWTH:e}");
                return Err(source.refused(given.span(), message, "give fewer elements or gentler growth"));
            }
        }
    }
    Ok(growth)
}

/// Centres of the sides that are arcs \[mm\].
fn arcs(
    source: Source,
    units: &Units,
    table: &BlockTable,
    corners: &[[f64; 2]; 4],
) -> Result<[Option<[f64; 2]>; 4], Error> {
    let given = [&table.arcs.bottom, &table.arcs.right, &table.arcs.top, &table.arcs.left];
    let mut arcs = [None; 4];
    for (k, (arc, pair)) in arcs.iter_mut().zip(given).enumerate() {
        let Some(pair) = pair else { continue };
        let centre = source.pair("arcs", pair)?.map(|x| units.length * x);
        let ends = [corners[k], corners[(k + 1) % 4]];
        let [a, b] = ends.map(|p| [p[0] - centre[0], p[1] - centre[1]]);
        let [r, q] = [a, b].map(|p| p[0].hypot(p[1]));
        let half_turn = a[0] * b[0] + a[1] * b[1] <= -0.999 * r * q;
        if r <= 0.0 || (r / q - 1.0).abs() > 1e-6 || half_turn {
            let message = format!(
                "the ends of `{}` lie {} and {} from the arc's centre",
                SIDES[k],
                r / units.length,
                q / units.length
            );
            let remedy = "give the centre of a circle through both corners, less than half a turn apart";
            return Err(source.refused(pair.span(), message, remedy));
        }
        *arc = Some(centre);
    }
    Ok(arcs)
}

/// Largest element of a side over its smallest.
const MOST_GROWTH: f64 = 1e6;

/// Refuses blocks that meet along a part of a side, or with other elements: their nodes would not be common.
fn refuse_unequal(source: Source, tables: &[Spanned<Keyed<BlockTable>>], blocks: &[BlockShape]) -> Result<(), Error> {
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
                let refused = |message: String, remedy: &str| Err(source.refused(tables[j].span(), message, remedy));
                if same(a, d) && same(b, c) && (n != m || n > 1 && (ratio * back - 1.0).abs() > 1e-9) {
                    let message =
                        format!("block {} has other elements along the side it shares with block {}", j + 1, i + 1);
                    return refused(message, "give both the same number and growth there");
                }
                let inside = |p| !same(p, a) && !same(p, b) && apart(a, p) + apart(p, b) <= (1.0 + SAME) * apart(a, b);
                if one.arcs[k].is_none() && inside(c) {
                    let message = format!("a corner of block {} lies inside a side of block {}", j + 1, i + 1);
                    return refused(message, "blocks meet along whole sides: divide the longer one");
                }
            }
        }
    }
    Ok(())
}
