//! The whole report: the front page, a page a case and a study, charts and benchmark sheets.

use crate::error::Error;
use crate::figure;
use crate::report::links::{CHARTS, PAGES};
use crate::report::{case_page, checks_page, front, record, study_page, symbols};
use crate::study::sheets::sheet;
use crate::study::{Finding, Numbers, Room};

/// The front page and all that is behind it.
#[derive(Clone, Debug)]
pub struct Page {
    /// Text of `VALIDATION.md`.
    pub markdown: String,
    /// File names and texts of the pages behind it.
    pub pages: Vec<(String, String)>,
    /// File names and SVG texts of the charts.
    pub charts: Vec<(String, String)>,
    /// File names and texts of the benchmark sheets.
    pub sheets: Vec<(String, String)>,
    /// Paths and texts of the record.
    pub record: Vec<(String, String)>,
}

/// Makes the report from the findings of the whole suite.
pub fn compose(findings: &[Finding]) -> Result<Page, Error> {
    let mut charts = [
        figure::contact_problem()?.files("contact-problem.svg"),
        figure::contact_elements()?.files("contact-elements.svg"),
    ]
    .concat();
    charts.extend(front::nearness::chart(findings)?.files(front::nearness::CHART[0]));
    for room in Room::ALL {
        charts.extend(room.pictures(findings)?);
    }
    let sheets = findings.iter().filter_map(|finding| match &finding.numbers {
        Numbers::Sheets(numbers) => Some(sheet(numbers)),
        _ => None,
    });
    Ok(Page {
        markdown: front::page(findings),
        pages: pages(findings)?,
        charts,
        sheets: sheets.collect(),
        record: record::files(findings)?,
    })
}

/// The page and the charts of one study: paths and texts.
pub fn of_study(room: Room, findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let page = (format!("{}/{}", PAGES, study_page::file(room)), study_page::page(room, findings)?);
    let charts = room.pictures(findings)?.into_iter().map(|(name, svg)| (format!("{CHARTS}/{name}"), svg));
    Ok(std::iter::once(page).chain(charts).collect())
}

/// The pages behind the front page: a loop over the studies, of which that of the cases has a page a case.
pub fn pages(findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let mut pages = vec![
        (checks_page::FILE.to_string(), checks_page::page(findings)),
        (symbols::FILE.to_string(), symbols::page()),
    ];
    for room in study_page::asked(findings) {
        pages.push((study_page::file(room), study_page::page(room, findings)?));
    }
    let has_sheet = |name: &str| {
        findings.iter().any(|finding| matches!(&finding.numbers, Numbers::Sheets(numbers) if numbers.name == name))
    };
    let cases = case_page::shared(findings);
    pages.extend(cases.iter().map(|one| (case_page::file(&one.name), case_page::page(one, has_sheet(&one.name)))));
    Ok(pages)
}
