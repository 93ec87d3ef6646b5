//! A solve as one HTML file that needs nothing else: numbers with bars, pictures, checks, notes and input; light and
//! dark.

use crate::case::Judged;
use crate::cli::bars;
use crate::cli::solve::brief;
use crate::cli::solve::found::Found;
use crate::error::Error;
use crate::markdown;
use crate::report::pictures;
use crate::study::{described, drawn};

/// What every such page begins with.
const BEGINS: &str = "<!DOCTYPE html>\n<!-- written by contact-vv solve -->";

/// The text of the file.
pub fn text(found: &Found) -> Result<String, Error> {
    let Found { problem, discretisation, run, checks, .. } = found;
    let input = match &problem.places {
        Some(places) => preformatted(places.text()),
        // As words: the marks of Markdown say nothing here.
        None => {
            let plain = |one: &String| preformatted(&one.replace("## ", "").replace("**", "").replace('`', ""));
            described::scene(&problem.scene).iter().map(plain).collect()
        }
    };
    let [rows, notes]: [Vec<_>; 2] = {
        let (notes, rows) = brief::rows(found).into_iter().partition(|[name, _]| name == brief::NOTE);
        [rows, notes]
    };
    let numbers = rows.iter().skip(1).map(|[name, told]| row("th", &[name]) + &row("td", &[told]));
    let bars = bars::rows(found);
    Ok(format!(
        include_str!("run.html"),
        name = escaped(&problem.name),
        title = escaped(&problem.title),
        numbers = numbers.map(|cells| format!("<tr>{cells}</tr>\n")).collect::<String>(),
        notes = section("Notes", notes.iter().map(|[_, note]| format!("<p>{}</p>\n", escaped(note))).collect()),
        picture = drawn::svg(&pictures::solve::sheet(problem, discretisation, run)?.drawing())?,
        bars = section("Numbers and their error bars", table(&bars::HEAD, &bars)),
        checks = section("Checks", table(&CHECKED, &checks.iter().map(checked).collect::<Vec<_>>())),
        input = input,
        version = escaped(env!("CARGO_PKG_VERSION")),
    ))
}

/// Whether a text is such a page.
pub fn is_ours(text: &str) -> bool {
    text.starts_with(BEGINS)
}

/// Heads of the columns of checks.
const CHECKED: [&str; 5] = ["verdict", "requirement", "value ± error bar", "reference", "error"];

fn checked(check: &Judged) -> [String; 5] {
    let (value, reference) = (markdown::with_bar(check.value, check.bar), markdown::value(check.reference.value));
    [check.verdict.to_string(), check.requirement(), value, reference, markdown::error(check.error)]
}

/// A part with its heading; nothing where it is empty.
fn section(heading: &str, text: String) -> String {
    if text.is_empty() { text } else { format!("<h2>{heading}</h2>\n{text}") }
}

fn table<const N: usize>(head: &[&str; N], rows: &[[String; N]]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let rows: String = rows.iter().map(|cells| format!("<tr>{}</tr>\n", row("td", cells))).collect();
    format!("<table>\n<tr>{}</tr>\n{rows}</table>\n", row("th", head))
}

fn row(tag: &str, cells: &[impl AsRef<str>]) -> String {
    cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell.as_ref()))).collect()
}

fn preformatted(text: &str) -> String {
    format!("<pre>{}</pre>\n", escaped(text))
}

/// A text in which nothing is markup; control characters, which no markup may hold, are left out.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.chars().filter(|c| !c.is_control() || matches!(c, '\n' | '\t')).collect()
}
