//! What accuracy costs.

use crate::report::links::to_page as link;
use crate::report::study_page;
use crate::study::Study;
use crate::study::drawn::picture;
use crate::study::timings::record::Record;
use crate::study::timings::{Numbers, conclusion};

/// The chart, and what it shows.
const CHART: [&str; 2] = [
    "work-precision.svg",
    "Truncated Hertz: error of peak and second-moment width against seconds and work, the worst of the loads, other codes beside ours",
];

/// The conclusion of the recorded timings; says so where there are none.
pub fn cost() -> String {
    let Ok(record) = Record::read() else { return "No timings were read.".into() };
    let processor = &record.measured.machine.processor;
    format!(
        "{} Seconds of one machine ({processor}), one thread; {}.\n\n{}",
        conclusion(&record),
        link("growth, stages, memory, targets", &study_page::file(Numbers::NAME)),
        picture(CHART[0], CHART[1])
    )
}
