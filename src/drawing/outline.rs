//! Outlines as SVG writes them, to a tenth of a pixel: finer digits differ between machines.

use super::frame::Point;

/// A number to one decimal, in as few characters as can be: `.5`, `-3`, `12.4`.
pub(super) fn tenths(value: f64) -> String {
    written(rounded(value))
}

/// Lines one after another, each with the command at its end: the very first point as it is, all others from point to point.
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

/// Appends a number, apart from the one before it where nothing else parts them: a sign does, and a second decimal point.
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
