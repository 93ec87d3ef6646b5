//! The list of the sheets.

use std::fmt::Write;

use crate::error::Error;
use crate::study::Found;
use crate::study::sheets::run::Numbers;

/// The folder of the sheets.
pub const SHEETS: &str = "snapshots/sheets";

/// The list.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::from(
        "A page a case of the library: geometry, material, loads, supports, equations, reference values with what they may be \
         off, sources, and which codes agree. Everything somebody with another code needs to run it.\n\n",
    );
    for found in findings {
        let Numbers { name, title, .. } = found.numbers;
        let _ = writeln!(text, "* [{name}]({SHEETS}/{name}.md): {title}");
    }
    text.push('\n');
    Ok(text)
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
