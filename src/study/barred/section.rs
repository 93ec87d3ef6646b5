//! The checks beyond their bars.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::barred::run::{Numbers, Outside};

/// Columns.
const HEAD: [&str; 7] = ["trial", "quantity", "closed form", "error", "bar", "model error stated", "because"];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let outside: Vec<&Outside> = findings.iter().flat_map(|found| &found.numbers.outside).collect();
    let all: usize = findings.iter().map(|found| found.numbers.all).sum();
    let rows: Vec<Vec<String>> = outside.iter().map(|one| row(one)).collect();
    let table = if rows.is_empty() { String::new() } else { markdown::table(&HEAD.map(String::from), &rows) };
    Ok(format!(
        "Every check of a case that holds a number with an error bar against a closed form shows that bar in its table. {} of {all} \
         have a true error beyond the sum of the bar and the model error that the case states of its closed form, or a bar that is not known{}\n\n{table}\n",
        outside.len(),
        if rows.is_empty() { "." } else { ":" }
    ))
}

/// No chart.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}

fn row(one: &Outside) -> Vec<String> {
    let bar = if one.bar.is_nan() { "unknown".into() } else { markdown::error(one.bar) };
    let model = if one.model > 0.0 { markdown::error(one.model) } else { "–".into() };
    let Outside { trial, quantity, reference, error, because, .. } = one;
    vec![trial.clone(), quantity.clone(), reference.clone(), markdown::error(*error), bar, model, because.clone()]
}
