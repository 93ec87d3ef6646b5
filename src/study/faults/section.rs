//! The section on planted faults.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::faults::run::{Fault, Numbers};

/// Columns of the record: kinds of references, and runs that broke off.
const KINDS: [&str; 4] = ["analytic", "cross-code", "self-consistency", "broken off"];
/// Characters of an example that are shown.
const SHOWN: usize = 160;

/// A row for each fault: what turned red.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let head = ["planted fault", "in", "closed forms", "other codes", "self-consistency", "broken off", "for instance"];
    let rows: Vec<Vec<String>> = findings.iter().flat_map(|found| &found.numbers.faults).map(row).collect();
    Ok(format!(
        "## Fault injection\n\nFaults planted one at a time on a copy of the tree (`tests/faults`), and how many checks of each kind turned red, of the suite \
         and of the worked scene files.\n\n{}\n",
        markdown::table(&head.map(String::from), &rows)
    ))
}

fn row(fault: &Fault) -> Vec<String> {
    let count = |kind: &str| fault.red.get(kind).map_or("–".into(), usize::to_string);
    let example = KINDS.iter().find_map(|kind| fault.examples.get(*kind)).or(fault.ended.as_ref());
    let example = example.map_or("**nothing**", String::as_str).chars().take(SHOWN).collect();
    let first = [fault.name.clone(), format!("`{}`", fault.file)];
    first.into_iter().chain(KINDS.map(count)).chain([example]).collect()
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    Ok(Vec::new())
}
