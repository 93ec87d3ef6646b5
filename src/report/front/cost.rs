//! What accuracy costs.

use crate::report::links::to_page as link;
use crate::report::study_page;
use crate::study::drawn::picture;
use crate::study::timings::compared::conclusion;
use crate::study::timings::run::record;
use crate::study::{Finding, Found, Numbers, Room};

/// The chart, and what it shows.
const CHART: [&str; 2] = [
    "work-precision.svg",
    "Truncated Hertz: error of peak and second-moment width against seconds and work, the worst of the loads, other codes beside ours",
];

/// The conclusion of the recorded timings; says so where there are none.
pub fn cost(findings: &[Finding]) -> String {
    let found = findings.iter().filter_map(|Finding { case, name, numbers, judged, .. }| match numbers {
        Numbers::Timings(numbers) => Some(Found { case, name, numbers, judged }),
        _ => None,
    });
    let Ok(record) = record(&found.collect::<Vec<_>>()) else { return "No timings were read.".into() };
    let processor = &record.measured.machine.processor;
    format!(
        "{} Seconds of one machine ({processor}), one thread; {}.\n\n{}",
        conclusion(&record),
        link("growth, stages, memory, 4-node cells", &study_page::file(Room::Timings)),
        picture(CHART[0], CHART[1])
    )
}
