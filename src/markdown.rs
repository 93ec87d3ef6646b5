//! How numbers, sentences and tables are written: the same digits on every machine.

/// Below this fraction of its scale a number is round-off and is not shown.
const ROUND_OFF: f64 = 1e-9;

/// An error: two significant digits, `< 1e-9` where it is round-off.
pub fn error(error: f64) -> String {
    match error {
        e if e.is_nan() => "not a number".into(),
        e if e.is_infinite() => "infinite".into(),
        e if e <= 0.0 => "0".into(),
        e if e < ROUND_OFF => "< 1e-9".into(),
        e if e < 1e-4 => format!("{e:.1e}"),
        e if e < 1.0 => format!("{} %", significant(100.0 * e, 2)),
        e => significant(e, 6),
    }
}

/// A value with six significant digits.
pub fn value(value: f64) -> String {
    match value {
        v if v.is_nan() => "–".into(),
        v if v.abs() < 1e-99 => "0".into(),
        v => significant(v, 6),
    }
}

/// A value, and how far it may be off where there is such a bar; NaN is an unknown one.
pub fn with_bar(number: f64, bar: Option<f64>) -> String {
    let told = value(number);
    match bar {
        None => told,
        Some(bar) if bar.is_nan() => format!("{told} ± unknown"),
        Some(bar) => format!("{told} ± {}", significant(bar, 2)),
    }
}

/// A tolerance, which may be smaller than what an error is shown as.
pub fn tolerance(tolerance: f64) -> String {
    match tolerance {
        small if small > 0.0 && small < 1e-8 => format!("{small:.0e}"),
        large if large >= 1.0 => bound(large),
        usual => error(usual),
    }
}

/// A bound: six significant digits, without the zeros at their end.
pub fn bound(bound: f64) -> String {
    let rounded: f64 = format!("{bound:.5e}").parse().unwrap_or(bound);
    if (1e-4..1e7).contains(&rounded.abs()) || rounded.abs() <= 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// A value to the second digit of its bound.
pub fn to_bound(value: f64, bound: f64) -> String {
    let places = (1.0 - bound.abs().max(1e-12).log10().floor()).min(10.0);
    if places >= 0.0 {
        return format!("{value:.*}", places as usize);
    }
    let step = 10_f64.powf(0.0 - places);
    format!("{:.0}", (value / step).round() * step)
}

/// Bar over the value below which it is round-off.
pub const EXACT: f64 = 1e-8;

/// A number as it is; one that rounds to nothing as 0.
pub fn unsigned(text: String) -> String {
    if text.bytes().any(|digit| digit.is_ascii_digit() && digit != b'0') { text } else { "0".into() }
}

/// `1 check`, `2 checks`.
pub fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// `digits` significant digits without an exponent where that is short.
pub fn significant(x: f64, digits: usize) -> String {
    if x.abs() < 1e-99 || !x.is_finite() {
        return if x.is_finite() { "0".into() } else { x.to_string() };
    }
    let magnitude = format!("{:.*e}", digits - 1, x.abs());
    let exponent: i32 = magnitude.split('e').nth(1).and_then(|e| e.parse().ok()).unwrap_or(0);
    if !(-4..=7).contains(&exponent) {
        return format!("{:.*e}", digits - 1, x);
    }
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    format!("{x:.decimals$}")
}

/// The same with its sign; what rounds to nothing has none.
pub fn signed(x: f64, digits: usize) -> String {
    let size = significant(x.abs(), digits);
    match x {
        x if x > 0.0 => format!("+{size}"),
        x if x < 0.0 => format!("-{size}"),
        _ => size,
    }
}

/// A sentence with a capital letter at its beginning.
pub fn capitalised(sentence: &str) -> String {
    let mut letters = sentence.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}

/// A Markdown table, its cells not padded: what changes in one row changes no other.
pub fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let line =
        |cells: &[String]| format!("| {} |\n", cells.iter().map(|cell| escape(cell)).collect::<Vec<_>>().join(" | "));
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    let rows: String = rows.iter().map(|row| line(row)).collect();
    line(head) + &rule + &rows
}

/// A column of a table of `T`: its head, and the cell of a row.
pub type Column<T> = (&'static str, fn(&T) -> String);

/// The table of such columns, a row each.
pub fn columns<'a, T: 'a>(columns: &[Column<T>], rows: impl IntoIterator<Item = &'a T>) -> String {
    let head: Vec<String> = columns.iter().map(|(head, _)| (*head).to_owned()).collect();
    let rows: Vec<Vec<String>> =
        rows.into_iter().map(|row| columns.iter().map(|(_, cell)| cell(row)).collect()).collect();
    table(&head, &rows)
}

/// A text behind a line that opens it; open from the start where that is asked for.
pub fn folded(summary: &str, text: &str, open: bool) -> String {
    let open = if open { " open" } else { "" };
    format!("<details{open}><summary>{summary}</summary>\n\n{text}\n</details>\n\n")
}

fn escape(cell: &str) -> String {
    cell.replace('|', "\\|").replace('\n', " ")
}
