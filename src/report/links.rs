//! Links to pages, and those of a text that is read elsewhere than it was written for: what every page behind the front
//! page begins with.

use crate::case::Judged;
use crate::report::told;

/// The folder of the pages, from the root.
pub const PAGES: &str = "snapshots/pages";
/// The folder of the charts.
pub const CHARTS: &str = "snapshots/charts";

/// The page of all checks, in the folder of pages.
pub const CHECKS: &str = "checks.md";

/// How a link to a generated file begins: in Markdown, and in HTML.
const BEGINNINGS: [&str; 3] = ["](", "=\"", "=\'"];

/// A link from the root to a page by its file.
pub fn to_page(text: &str, file: &str) -> String {
    format!("[{text}]({PAGES}/{file})")
}

/// Ways back.
const WAYS: &str = "[Front page](../../VALIDATION.md) · [all cases](cases.md) · [all checks](checks.md) · [the \
    paper](paper.md) · [symbols](symbols.md)";

/// A page behind the front page: title, what it asks, what became of its checks, ways back, and the rest.
pub fn page(title: &str, lead: &str, judged: &[&Judged], body: &str) -> String {
    let verdict = if judged.is_empty() { String::new() } else { format!("{}\n\n", told::of(judged)) };
    // Links of a study's text start at the root.
    let from_here = |text: String, begin: &&str| text.replace(&format!("{begin}snapshots/"), &format!("{begin}../"));
    let body = BEGINNINGS.iter().fold(body.to_owned(), from_here);
    format!("# {title}\n\n{lead}\n\n{verdict}{WAYS}\n\n{}\n", body.trim_end())
}
