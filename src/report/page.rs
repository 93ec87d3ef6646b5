//! The whole report: the front page, a page a case and a study, charts, benchmark sheets and their values.

use std::path::Path;

use crate::drawing::schematic;
use crate::error::Error;
use crate::report::links::{CHARTS, PAGES};
use crate::report::{case_page, checks_page, front, record, study_page, symbols};
use crate::study::sheet::{self, SHEETS, Sheet};
use crate::study::{Files, Finding, Room, drawn, references};

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
    let problem = schematic("contact problem", include_str!("pictures/contact-problem.svg"), &[]);
    let elements = schematic("contact elements", include_str!("pictures/contact-elements.svg"), &[]);
    let mut charts = drawn::written(&[
        ("contact-problem.svg".into(), problem),
        ("contact-elements.svg".into(), elements),
        (front::nearness::CHART[0].into(), front::nearness::chart(findings)),
    ])?;
    for room in &Room::ALL {
        charts.extend((room.pictures)(findings)?);
    }
    Ok(Page {
        markdown: front::page(findings),
        pages: pages(findings)?,
        charts,
        sheets: sheets(findings).map(sheet::file).collect(),
        record: [record::files(findings)?, values(findings)?].concat(),
    })
}

fn sheets(findings: &[Finding]) -> impl Iterator<Item = &Sheet> {
    findings.iter().filter_map(|finding| match finding.numbers() {
        Some(references::Numbers::Sheet(sheet)) => Some(sheet),
        _ => None,
    })
}

/// The values of all sheets as data: paths and texts.
fn values(findings: &[Finding]) -> Result<Files, Error> {
    let sheets: Vec<Sheet> = sheets(findings).map(Sheet::published).collect();
    let rows = sheets.iter().flat_map(|one| one.values.iter().map(move |value| (one, value)));
    let cells = record::cells(&sheet::columns(), &rows.collect::<Vec<_>>());
    let table = record::text(Path::new(sheet::CSV), &cells)?;
    Ok(vec![(sheet::JSON.into(), sheet::json(&sheets)), (sheet::CSV.into(), table)])
}

/// The page and the charts of one study, and its sheets with their values: paths and texts.
pub fn of_study(room: &Room, findings: &[Finding]) -> Result<Files, Error> {
    let page = (format!("{}/{}", PAGES, study_page::file(room.name)), study_page::page(room, findings)?);
    let charts = (room.pictures)(findings)?.into_iter().map(|(name, svg)| (format!("{CHARTS}/{name}"), svg));
    let sheets = sheets(findings).map(sheet::file).map(|(name, text)| (format!("{SHEETS}/{name}"), text));
    let sheets: Files = sheets.collect();
    let values = if sheets.is_empty() { vec![] } else { values(findings)? };
    Ok(std::iter::once(page).chain(charts).chain(sheets).chain(values).collect())
}

/// The pages behind the front page: a loop over the studies, of which that of the cases has a page a case.
pub fn pages(findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let mut pages = vec![
        (checks_page::FILE.to_string(), checks_page::page(findings)),
        (symbols::FILE.to_string(), symbols::page()),
    ];
    for room in study_page::asked(findings) {
        pages.push((study_page::file(room.name), study_page::page(room, findings)?));
    }
    let has_sheet = |name: &str| sheets(findings).any(|sheet| sheet.name == name);
    let cases = case_page::shared(findings);
    pages.extend(cases.iter().map(|one| (case_page::file(&one.name), case_page::page(one, has_sheet(&one.name)))));
    Ok(pages)
}
