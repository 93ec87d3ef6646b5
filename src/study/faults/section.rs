//! The section on planted faults.

use std::collections::BTreeMap;

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::faults::run::{Fault, Numbers};

/// Columns of the record: kinds of references, and runs that broke off.
const KINDS: [&str; 4] = ["analytic", "cross-code", "self-consistency", "broken off"];
/// Characters of an example that are shown.
const SHOWN: usize = 160;
/// Digits of a digest that are shown.
const DIGITS: usize = 12;

/// A row for each fault: what turned red.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let head = [
        "planted fault",
        "in",
        "sources",
        "closed forms",
        "other codes",
        "self-consistency",
        "broken off",
        "for instance",
    ];
    let faults: Vec<&Fault> = findings.iter().flat_map(|found| &found.numbers.faults).collect();
    let rows: Vec<Vec<String>> = faults.iter().map(|fault| row(fault)).collect();
    Ok(format!(
        "Faults planted one at a time on a copy of the tree (`tests/faults`), and how many checks of each kind turned red, of the suite \
         and of the worked scene files. *Sources* is the digest (SHA-256) of what a fault was planted on: {}. The terminal says at every report \
         how many are not of the present sources.\n\n{}\n",
        planted_on(&faults),
        markdown::table(&head.map(String::from), &rows)
    ))
}

/// How many faults were planted on which sources.
fn planted_on(faults: &[&Fault]) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for fault in faults {
        *counts.entry(shown(fault)).or_default() += 1;
    }
    let told: Vec<String> = counts.iter().map(|(sources, count)| format!("{count} on {sources}")).collect();
    told.join(", ")
}

/// The first digits of the digest of its sources.
fn shown(fault: &Fault) -> String {
    let digits = |sources: &String| format!("`{}`", sources.chars().take(DIGITS).collect::<String>());
    fault.sources.as_ref().map_or("sources not recorded".into(), digits)
}

fn row(fault: &Fault) -> Vec<String> {
    let count = |kind: &str| fault.red.get(kind).map_or("–".into(), usize::to_string);
    let example = KINDS.iter().find_map(|kind| fault.examples.get(*kind)).or(fault.ended.as_ref());
    let example = example.map_or("**nothing**", String::as_str).chars().take(SHOWN).collect();
    let first = [fault.planted.name.clone(), format!("`{}`", fault.planted.file), shown(fault)];
    first.into_iter().chain(KINDS.map(count)).chain([example]).collect()
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
