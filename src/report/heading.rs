//! What every page behind the front page begins with.

use crate::case::Judged;
use crate::report::{links, symbols, told};

/// Ways back.
const WAYS: &str =
    "[Front page](../../VALIDATION.md) · [all cases](cases.md) · [all checks](checks.md) · [the paper](paper.md)";

/// A page: title, what it asks, what became of its checks, symbols, and the rest.
pub fn page(title: &str, lead: &str, judged: &[&Judged], body: &str) -> String {
    let verdict = if judged.is_empty() { String::new() } else { format!("{}\n\n", told::of(judged)) };
    let body = links::from_pages(body);
    let symbols = symbols::of(&format!("{title}{lead}{verdict}{body}"));
    format!("# {title}\n\n{lead}\n\n{verdict}{WAYS}\n\n{symbols}{}\n", body.trim_end())
}
