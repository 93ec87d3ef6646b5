//! The whole report: the front page, a page a case and a study, charts, benchmark sheets and their values.

use std::path::Path;

use crate::drawing::schematic;
use crate::error::Error;
use crate::report::links::{CHARTS, PAGES};
use crate::report::{case_page, checks_page, files, front, record, study_page, symbols};
use crate::study::sheet::{self, SHEETS, Sheet};
use crate::study::{Files, Finding, Room, drawn, references};

/// The report, made from the findings of the whole suite: paths and texts of the front page, the pages behind it, the charts, the
/// benchmark sheets and the record.
pub fn compose(findings: &[Finding]) -> Result<Files, Error> {
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
    let sheets = sheets(findings).map(sheet::file).collect();
    let behind = [(PAGES, pages(findings)?), (CHARTS, charts), (SHEETS, sheets)];
    let behind = behind.into_iter().flat_map(|(folder, files)| within(folder, files));
    let record = [record::files(findings)?, values(findings)?].concat();
    Ok(std::iter::once((files::PAGE.to_owned(), front::page(findings))).chain(behind).chain(record).collect())
}

/// Files of a folder by their paths.
fn within(folder: &'static str, files: Files) -> impl Iterator<Item = (String, String)> {
    files.into_iter().map(move |(name, text)| (format!("{folder}/{name}"), text))
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
    let sheets: Files = sheets(findings).map(sheet::file).collect();
    let values = if sheets.is_empty() { vec![] } else { values(findings)? };
    let charts = within(CHARTS, (room.pictures)(findings)?);
    Ok(std::iter::once(page).chain(charts).chain(within(SHEETS, sheets)).chain(values).collect())
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
