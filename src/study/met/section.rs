//! Whether an accuracy called met is met: answers by family and accuracy.

use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::study::Found;
use crate::study::met::run::{Numbers, Record};
use crate::study::met::sites::{ASKED, families};
use crate::study::random::{Family, GUESS};

/// Columns.
const HEAD: [&str; 7] = [
    "scenes",
    "asked",
    "answers",
    "called met",
    "falsely met",
    "largest error called met, over asked",
    "largest error over its estimate",
];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let [shortest, longest] = GUESS;
    let rows: Vec<Vec<String>> = findings.iter().flat_map(|found| by_family(&found.numbers.recorded)).collect();
    Ok(format!(
        "The random scenes of *Whether error bars hold*, but for flat punches and polygons, whose peak has no limit; such scenes with a coarse mesh \
         given for the body, its inner nodes shaken, and two of them in one, whatever their sizes. Size, material, load and the guess of the candidate stretch, {shortest} to {longest} times the contact, are drawn. The error is \
         the larger one of peak pressure and half-width against the truth, over both contacts. `cargo run --release -- met` renews the record; the \
         report recomputes a part of it.\n\n{}\n",
        markdown::table(&HEAD.map(String::from), &rows)
    ))
}

fn by_family(recorded: &[Record]) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for family in families() {
        for asked in ASKED {
            let is_own = |record: &&Record| record.family == family && record.asked.to_bits() == asked.to_bits();
            rows.push(row(family, asked, &recorded.iter().filter(is_own).collect::<Vec<_>>()));
        }
    }
    rows
}

fn row(family: Family, asked: f64, own: &[&Record]) -> Vec<String> {
    let met = || own.iter().filter(|record| record.met);
    let falsely = own.iter().filter(|record| record.is_falsely_met()).count();
    let largest = |ratio: fn(&Record) -> f64| {
        met().map(|record| ratio(record)).reduce(larger).map_or("–".into(), |worst| format!("{worst:.2}"))
    };
    vec![
        family.title().into(),
        format!("{} %", 100.0 * asked),
        own.len().to_string(),
        format!("{:.0} %", 100.0 * met().count() as f64 / own.len() as f64),
        falsely.to_string(),
        largest(|record| record.error() / record.asked),
        largest(|record| record.error() / record.estimate),
    ]
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
