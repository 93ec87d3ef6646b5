//! Outlines as SVG writes them, to a tenth of a pixel: finer digits differ between machines.

use super::frame::Point;

/// A number to one decimal, in as few characters as can be: `.5`, `-3`, `12.4`.
pub(super) fn tenths(value: f64) -> String {
    written(rounded(value))
}

/// Lines one after another, each with the command at its end: the first point as it is, the others from point to point.
pub(super) fn outlines(lines: &[Vec<Point>], end: &str) -> String {
    lines.iter().map(|line| outline(line) + end).collect()
}

fn outline(line: &[Point]) -> String {
    let mut text = String::new();
    let mut last = (0, 0);
    for (n, place) in line.iter().map(|&(x, y)| (rounded(x), rounded(y))).enumerate() {
        if n == 1 {
            text.push('l');
        }
        let (dx, dy) = (place.0 - last.0, place.1 - last.1);
        let numbers = [written(dx), written(dy)];
        if n == 0 {
            text.push('M');
        }
        for (k, number) in numbers.iter().enumerate() {
            let apart = number.starts_with('-') || (k == 0 && n < 2);
            text.push_str(if apart { "" } else { " " });
            text.push_str(number);
        }
        last = place;
    }
    text
}

fn rounded(value: f64) -> i64 {
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
