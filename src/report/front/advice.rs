//! Where methods fail, and what to use.

use crate::report::links::to_page as link;
use crate::report::matrix::Column;
use crate::report::study_page;
use crate::study::atlas::plane::{Digest, digests};
use crate::study::atlas::{self, Chart};
use crate::study::drawn::picture;
use crate::study::{Finding, Study, limits, promised};

/// The map, and what it shows.
const CHART: [&str; 2] = [
    "atlas-stretch.svg",
    "How every run ends over initial stiffness and candidate surface, with the predicted boundary",
];

/// What the surveyed planes say of each method; none where nothing was surveyed.
fn surveyed(findings: &[Finding]) -> Option<Vec<Digest>> {
    let charts: Vec<&Chart> = findings
        .iter()
        .filter_map(|finding| match finding.numbers() {
            Some(atlas::Numbers::Surveyed { chart, .. }) => Some(chart),
            _ => None,
        })
        .collect();
    (!charts.is_empty()).then(|| digests(&charts))
}

/// Element and algorithm of the method to use.
pub fn recommended(findings: &[Finding]) -> Option<Column> {
    atlas::recommended(&surveyed(findings)?).map(|method| (method.element, method.algorithm))
}

/// The recommendation and the map.
pub fn advice(findings: &[Finding]) -> String {
    let Some(digests) = surveyed(findings) else { return "Nothing was surveyed.".into() };
    let page = |text: &str, study: &str| link(text, &study_page::file(study));
    format!(
        "{}\n{}, {}, {}.\n\n{}",
        atlas::recommendation(&digests),
        page("Why", atlas::Numbers::NAME),
        page("where everything else ends", limits::Numbers::NAME),
        page("what is called converged", promised::Numbers::NAME),
        picture(CHART[0], CHART[1])
    )
}
