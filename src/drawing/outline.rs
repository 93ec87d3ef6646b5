//! Outlines as SVG writes them, to a tenth of a pixel: finer digits differ between machines; and those of tiles joined
//! to the regions that they cover: what a picture of thousands of cells weighs is their common sides.

use std::collections::BTreeMap;

use super::frame::Point;

/// A number to one decimal, in as few characters as can be: `.5`, `-3`, `12.4`.
pub(super) fn tenths(value: f64) -> String {
    written(rounded(value))
}

/// Lines one after another, each with the command at its end: the very first point as it is, all others from point to
/// point.
pub(super) fn outlines(lines: &[Vec<Point>], end: &str) -> String {
    let mut text = String::new();
    let mut last = (0, 0);
    for line in lines {
        let places: Vec<(i64, i64)> = line.iter().map(|&(x, y)| (rounded(x), rounded(y))).collect();
        let mut command = ' ';
        for (n, place) in places.iter().enumerate() {
            let (dx, dy) = (place.0 - last.0, place.1 - last.1);
            let (next, numbers) = match (dx, dy) {
                _ if n == 0 => (if text.is_empty() { 'M' } else { 'm' }, vec![dx, dy]),
                (_, 0) => ('h', vec![dx]),
                (0, _) => ('v', vec![dy]),
                _ => ('l', vec![dx, dy]),
            };
            if next != command {
                text.push(next);
            }
            numbers.into_iter().for_each(|number| append(&mut text, &written(number)));
            (command, last) = (next, *place);
        }
        text.push_str(end);
        // A closed line leaves the pen where it began.
        last = if end.is_empty() { last } else { places.first().copied().unwrap_or(last) };
    }
    text
}

/// Appends a number, apart from the one before it where nothing else parts them: a sign does, and a second decimal
/// point.
fn append(text: &mut String, number: &str) {
    let before = text.rsplit(|sign: char| sign.is_ascii_alphabetic() || [' ', '-'].contains(&sign)).next();
    let before = before.unwrap_or_default();
    let parted = before.is_empty() || number.starts_with('-') || number.starts_with('.') && before.contains('.');
    text.push_str(if parted { "" } else { " " });
    text.push_str(number);
}

/// Tenths of a display pixel.
pub(super) fn rounded(value: f64) -> i64 {
    (10.0 * value).round() as i64
}

fn written(tenths: i64) -> String {
    let sign = if tenths < 0 { "-" } else { "" };
    match (tenths.unsigned_abs() / 10, tenths.unsigned_abs() % 10) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, rest) => format!("{sign}.{rest}"),
        (whole, rest) => format!("{sign}{whole}.{rest}"),
    }
}

/// A corner [tenths of a display pixel].
type Corner = (i64, i64);

/// The outlines of what polygons cover together, to a tenth of a pixel.
///
/// A side that two polygons run along in opposite directions is none of the outline, whatever else meets there. How
/// often a place is encircled is the same before and after, so that filling by the rule `nonzero` shows the same, holes
/// included.
pub(super) fn joined(polygons: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut sides: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
    for polygon in polygons {
        let corners: Vec<Corner> = polygon.iter().map(|&(x, y)| (rounded(x), rounded(y))).collect();
        for (n, &from) in corners.iter().enumerate() {
            let to = corners[(n + 1) % corners.len()];
            if from != to && !removed(&mut sides, to, from) {
                sides.entry(from).or_default().push(to);
            }
        }
    }
    let mut outlines = Vec::new();
    while let Some(start) = sides.keys().next().copied() {
        let mut outline = vec![start];
        // As many sides begin at a corner as end there: the walk comes back to its start.
        while let Some(next) = sides.get(outline.last().unwrap_or(&start)).and_then(|ends| ends.last().copied()) {
            removed(&mut sides, outline[outline.len() - 1], next);
            if next == start {
                break;
            }
            outline.push(next);
        }
        outlines.push(bends(&outline));
    }
    outlines
}

/// Takes a side away, and says whether it was there.
fn removed(sides: &mut BTreeMap<Corner, Vec<Corner>>, from: Corner, to: Corner) -> bool {
    let Some(ends) = sides.get_mut(&from) else { return false };
    let Some(place) = ends.iter().position(|end| *end == to) else { return false };
    ends.swap_remove(place);
    if ends.is_empty() {
        sides.remove(&from);
    }
    true
}

/// The corners at which an outline turns.
fn bends(outline: &[Corner]) -> Vec<Point> {
    let count = outline.len();
    let turns = |n: &usize| {
        let [before, here, after] = [n + count - 1, *n, n + 1].map(|k| outline[k % count]);
        let (came, goes) = ([here.0 - before.0, here.1 - before.1], [after.0 - here.0, after.1 - here.1]);
        came[0] * goes[1] != came[1] * goes[0] || came[0] * goes[0] + came[1] * goes[1] < 0
    };
    (0..count).filter(turns).map(|n| (outline[n].0 as f64 / 10.0, outline[n].1 as f64 / 10.0)).collect()
}
