//! The section: a row for each limit, then the tables behind the rows.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::limits::plan::Numbers;
use crate::study::limits::row::HEAD;

/// The table of limits, and a folded table of the values tried for each.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let rows: Vec<Vec<String>> = findings.iter().map(|found| found.numbers.limit().cells()).collect();
    let mut text = String::from(
        "Each row pushes one thing until it fails. What the user sees is what the program said in that run.\n\n",
    );
    text += &markdown::table(&HEAD.map(String::from), &rows);
    for detail in findings.iter().filter_map(|found| found.numbers.detail()) {
        text += "\n";
        text += &markdown::folded(detail.title, &markdown::table(&detail.head, &detail.rows), false);
    }
    Ok(text)
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
