//! The page of all checks: by kind of reference and case, and those of every run.

use crate::case::Judged;
use crate::report::front::nearness;
use crate::report::{checks, heading, links, matrix, study_page};
use crate::study::drawn::picture;
use crate::study::{Finding, Study, promised};
use crate::uncertainty::COVERAGE;

/// Name of the file.
pub const FILE: &str = "checks.md";

/// The page.
pub fn page(findings: &[Finding]) -> String {
    let all: Vec<&Judged> = findings.iter().flat_map(|finding| &finding.judged).collect();
    let body = format!(
        "*Verification* holds the code against closed forms and orders of accuracy (kind *analytic*); *benchmarking* holds it against \
         other codes (*cross-code*); *self-consistency* asks it the same in another way; *validation* compares with measurement. ± is the \
         error bar everywhere, {COVERAGE} standard uncertainties of the value from refinement; how many bars hold, {} tells.\n\n{}\n{}## Every run\n\n{}",
        links::to_page("what is promised", &study_page::file(promised::Numbers::NAME)),
        matrix::by_kind(findings),
        picture(nearness::CHART[0], nearness::CHART[1]),
        checks::universal(all.iter().copied()),
    );
    heading::page("All checks", "What everything is held against, by kind and by case.", &all, &body)
}
