//! How many sentences hold under the readings: rules of varying stiffness against tolerances and caps.

use crate::algorithm::Criterion;
use crate::error::Error;
use crate::figure::palette;
use crate::figure::{Cell, ClassMap, MapPanel};
use crate::study::Found;
use crate::study::readings::axes::{CAPS, Candidates, Rule, Stop, TOLERANCES};
use crate::study::readings::courses::Courses;
use crate::study::readings::map::{self, Judged};
use crate::study::readings::run::Numbers;
use crate::study::readings::sentence::Sentence;

/// Classes of the map: from the most sentences that can hold down, one a class, and what is below the last.
const CLASSES: usize = 6;

/// The map.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    let picture = |found: &Found<Numbers>| Ok(("readings.svg".to_string(), chart(found.numbers)?));
    findings.iter().map(picture).collect()
}

fn chart(numbers: &Numbers) -> Result<String, Error> {
    let all = map::all(&Courses::of(&numbers.recorded));
    let most = all.iter().map(Judged::count).max().unwrap_or(0);
    let criteria = [Criterion::Conditions, Criterion::Residuals, Criterion::Displacement];
    let pairs = criteria.into_iter().flat_map(|criterion| Candidates::ALL.map(|candidates| (candidates, criterion)));
    let panels = pairs.map(|(candidates, criterion)| panel(&all, most, candidates, criterion)).collect();
    let class = |k: usize| match most.checked_sub(k as u32) {
        Some(number) if k + 1 < CLASSES => format!("{number} of {}", Sentence::ALL.len()),
        _ => "fewer".into(),
    };
    let ticks = TOLERANCES.iter().enumerate().map(|(k, tolerance)| (k * CAPS.len(), format!("{tolerance:.0e}")));
    ClassMap {
        title: "Sentences of the paper that hold in both examples, by rule of varying stiffness and tolerance".into(),
        panels,
        columns: Candidates::ALL.len(),
        ticks: ticks.collect(),
        legend: (0..CLASSES).map(|k| (class(k), palette::ENDS[k])).collect(),
        notes: vec![format!(
            "In each tolerance from left to right: given up after {} iterations. The most that hold under any rule of constant stiffness \
             and thickness of layers.",
            CAPS.map(|cap| cap.to_string()).join(", ")
        )],
    }
    .svg()
}

fn panel(all: &[Judged], most: u32, candidates: Candidates, criterion: Criterion) -> MapPanel {
    let is_own = |judged: &&Judged| judged.reading.candidates == candidates && judged.reading.stop.criterion == criterion;
    let own: Vec<&Judged> = all.iter().filter(is_own).collect();
    let row = |varying: Rule| {
        let of_rule: Vec<&&Judged> = own.iter().filter(|judged| judged.reading.varying == varying).collect();
        let places = TOLERANCES.into_iter().flat_map(|tolerance| CAPS.map(|cap| (Stop { criterion, tolerance }, cap)));
        let cell = |(stop, cap): (Stop, usize)| {
            let here = of_rule.iter().filter(|judged| judged.reading.stop == stop && judged.reading.cap == cap);
            let held = here.map(|judged| judged.count()).max().unwrap_or(0);
            Cell { colour: palette::ENDS[((most - held) as usize).min(CLASSES - 1)], predicted: None }
        };
        (varying.name(), places.map(cell).collect())
    };
    let rows = Rule::varying().into_iter().map(row).collect();
    MapPanel { title: format!("{} · candidates {}", criterion.name(), candidates.name()), rows }
}
