//! What every page behind the front page begins with.

use crate::case::Judged;
use crate::report::{links, told};

/// Ways back.
const WAYS: &str = "[Front page](../../VALIDATION.md) · [all cases](cases.md) · [all checks](checks.md) · [the paper](paper.md) · [symbols](symbols.md)";

/// A page: title, what it asks, what became of its checks, ways back, and the rest.
pub fn page(title: &str, lead: &str, judged: &[&Judged], body: &str) -> String {
    let verdict = if judged.is_empty() { String::new() } else { format!("{}\n\n", told::of(judged)) };
    let body = links::from_pages(body);
    format!("# {title}\n\n{lead}\n\n{verdict}{WAYS}\n\n{}\n", body.trim_end())
}
