//! A row for each a/R.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::quarter::run::{Change, Numbers};

/// Changes of peak and second-moment width.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let head = ["a/R", "p₀, loaded on the same line", "a, same line", "p₀, loaded on the upper arc", "a, upper arc"];
    let rows: Vec<Vec<String>> = findings.iter().flat_map(|found| &found.numbers.changes).map(row).collect();
    Ok(format!(
        "Change of the contact when the half cylinder is modelled instead of the quarter.\n\n{}\n",
        markdown::table(&head.map(String::from), &rows)
    ))
}

fn row(change: &Change) -> Vec<String> {
    let quarter = &change.quarter;
    let changes = [&change.half, &change.above]
        .into_iter()
        .flat_map(|half| [half.peak / quarter.peak, half.half_width / quarter.half_width])
        .map(|ratio| format!("{:+.3} %", 100.0 * (ratio - 1.0)));
    [change.a_over_r.to_string()].into_iter().chain(changes).collect()
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
