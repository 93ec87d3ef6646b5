//! What accuracy costs.

use crate::report::links::to_page as link;
use crate::report::study_page;
use crate::study::Study;
use crate::study::drawn::picture;
use crate::study::timings::record::Record;
use crate::study::timings::{FRONTS, Numbers, conclusion};

/// The conclusion of the recorded timings; says so where there are none.
pub fn cost() -> String {
    let Ok(record) = Record::read() else { return "No timings were read.".into() };
    let processor = &record.measured.machine.processor;
    format!(
        "{}\nSeconds of one machine ({processor}), one thread; {}.\n\n{}",
        conclusion(&record),
        link("all our runs, growth, stages, memory, targets", &study_page::file(Numbers::NAME)),
        picture(FRONTS[0], FRONTS[1])
    )
}
