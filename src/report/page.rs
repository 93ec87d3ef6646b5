//! The whole report: the front page, a page a case and a study, charts, benchmark sheets and their values; or one page
//! of it; written, and compared with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::case::library::NAMES;
use crate::drawing::schematic;
use crate::error::{Error, meant};
use crate::report::diff::Difference;
use crate::report::diff::tree::Tree;
use crate::report::front::{self, NEARNESS, nearness};
use crate::report::links::{self, CHARTS, PAGES};
use crate::report::{case_page, checks, matrix, record, statements, study_page, symbols, told};
use crate::study::sheet::{self, SHEETS, Sheet};
use crate::study::{self, Files, Finding, Room, Study, Trial, cases, drawn, on_page, paper, promised, references};
use crate::uncertainty::COVERAGE;

/// The report, made from the findings of the whole suite: paths and texts of the front page, the pages behind it, the
/// charts, the benchmark sheets and the record.
pub fn compose(findings: &[Finding]) -> Result<Files, Error> {
    let problem = schematic("contact problem", include_str!("pictures/contact-problem.svg"), &[]);
    let elements = schematic("contact elements", include_str!("pictures/contact-elements.svg"), &[]);
    let mut charts = drawn::written(&[
        ("contact-problem.svg".into(), problem),
        ("contact-elements.svg".into(), elements),
        (NEARNESS[0].into(), nearness(findings)),
    ])?;
    for room in &Room::ALL {
        charts.extend((room.pictures)(findings)?);
    }
    let sheets = sheets(findings).map(sheet::file).collect();
    let behind = [(PAGES, pages(findings)?), (CHARTS, charts), (SHEETS, sheets)];
    let behind = behind.into_iter().flat_map(|(folder, files)| within(folder, files));
    let record = [record::files(findings)?, values(findings)?].concat();
    Ok(std::iter::once((PAGE.to_owned(), front::page(findings))).chain(behind).chain(record).collect())
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

/// The pages behind the front page: a loop over the studies, of which that of the cases has a page a case.
fn pages(findings: &[Finding]) -> Result<Files, Error> {
    let mut pages =
        vec![(links::CHECKS.to_string(), of_checks(findings)), (symbols::FILE.to_string(), symbols::page(findings))];
    for room in study_page::asked(findings) {
        pages.push((study_page::file(room.name), study_page::page(room, findings)?));
    }
    pages.extend(case_pages(findings, |name| sheets(findings).any(|sheet| sheet.name == name)));
    Ok(pages)
}

/// The page of all checks: by kind of reference and case, and those of every run.
fn of_checks(findings: &[Finding]) -> String {
    let judged = told::each(findings);
    let body = format!(
        "*Verification* holds the code against closed forms and orders of accuracy (kind *analytic*); *benchmarking* \
        holds it against other codes (*cross-code*); *self-consistency* asks it the same in another way; *validation* \
        compares with measurement. The checks are {} propositions, each of a quantity, how it shall stand to a \
        reference, and the kind of that, judged in {} rows: one for each case and reference, by the worst of the runs \
        that are held to it. The tables below count these runs. ± is the error bar, {COVERAGE} standard uncertainties \
        of the value from refinement; how many bars hold, {} tells.\n\n{}\n{}## Truths\n\n\
        Every truth that is not this code, but for those of the scoreboard, with the numbers held against it, and the \
        relative errors above round-off:\n\n{}\n## Every run\n\n{}",
        told::propositions(judged.iter().copied()),
        judged.len(),
        links::to_page("what is promised", &study_page::file(promised::Numbers::NAME)),
        matrix::by_kind(findings),
        drawn::picture(NEARNESS[0], NEARNESS[1]),
        front::table_of(&front::truths(findings)),
        checks::of_every_run(findings.iter().flat_map(|finding| &finding.judged), true),
    );
    links::page("All checks", "What everything is held against, by kind and by case.", &judged, &body)
}

/// The pages of cases; of which of them there is a benchmark sheet is told.
fn case_pages(findings: &[Finding], has_sheet: impl Fn(&str) -> bool) -> Files {
    let page = |one: &case_page::Shared| (case_page::file(&one.0), case_page::page(one, has_sheet(&one.0)));
    case_page::shared(findings).iter().map(page).collect()
}

/// What one page of the report is of.
pub enum Only {
    /// A study.
    Study(&'static Room),
    /// A page of cases, by its name.
    Case(String),
}

impl Only {
    /// The study or the page of this name; a case by its own name, or that of its file, is on a page.
    pub fn named(name: &str) -> Result<Self, Error> {
        let of_page = name.replace('-', "_");
        if let Some(room) = Room::ALL.iter().find(|room| room.name == of_page) {
            return Ok(Self::Study(room));
        }
        let known = cases::names()?;
        if let Some([_, page]) = known.iter().find(|[known, _]| known == name) {
            return Ok(Self::Case(page.clone()));
        }
        let names = || known.iter().map(|[name, _]| name.as_str()).chain(Room::ALL.iter().map(|room| room.name));
        let studies = Room::ALL.map(|room| room.name).join(", ");
        let remedy = format!("{}`contact-vv list` names the cases; studies are {studies}", meant(name, names()));
        Err(Error::value("report", "--only", name, "there is no case and no study of this name", remedy))
    }

    /// Whether it shows the error bars beside checks, of which those of cases have some.
    pub fn shows_bars(&self) -> bool {
        matches!(self, Self::Study(room) if room.name == promised::Numbers::NAME)
    }

    /// What is to be solved for it.
    pub fn trials(&self) -> Vec<Trial> {
        match self {
            // The paper's statements rest on others too.
            Self::Study(room) if room.name == paper::Numbers::NAME => {
                let others = study::trials().into_iter().filter(|trial| statements::CASES.contains(&&*trial.case));
                (room.plan)().into_iter().chain(others).collect()
            }
            Self::Study(Room { name, .. }) if self.shows_bars() => {
                let asked = Room::ALL.iter().filter(|one| [*name, cases::Numbers::NAME].contains(&one.name));
                asked.flat_map(|one| (one.plan)()).collect()
            }
            Self::Study(room) => (room.plan)(),
            Self::Case(page) => on_page(page),
        }
    }

    /// The page first, then its charts and its sheets: paths and texts. Charts of cases are those of their study.
    pub fn files(&self, findings: &[Finding]) -> Result<Files, Error> {
        match self {
            Self::Study(room) => {
                let page = (format!("{}/{}", PAGES, study_page::file(room.name)), study_page::page(room, findings)?);
                let own: Vec<Finding> = study_page::of(room.name, findings).cloned().collect();
                let sheets: Files = sheets(&own).map(sheet::file).collect();
                let values = if sheets.is_empty() { vec![] } else { values(&own)? };
                let charts = within(CHARTS, (room.pictures)(findings)?);
                Ok(std::iter::once(page).chain(charts).chain(within(SHEETS, sheets)).chain(values).collect())
            }
            Self::Case(_) => {
                let has_sheet = |name: &str| NAMES.iter().any(|(known, _)| *known == name);
                Ok(within(PAGES, case_pages(findings, has_sheet)).collect())
            }
        }
    }
}

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";

/// Folders that hold nothing but what a report is made of, and the extension of that.
const FOLDERS: [(&str, &str); 3] = [(PAGES, "md"), (CHARTS, "svg"), (SHEETS, "md")];

/// Committed files that a report no longer has.
fn stale(report: &[(String, String)], root: &Path) -> Vec<String> {
    let of_folder = |(folder, extension): (&str, &str)| {
        let entries = fs::read_dir(root.join(folder)).into_iter().flatten().flatten();
        let there = entries.map(|entry| PathBuf::from(entry.file_name()));
        let own = there.filter(|name| name.extension().is_some_and(|own| own == extension));
        let paths = own.map(|name| format!("{folder}/{}", name.display()));
        paths.filter(|path| !report.iter().any(|(made, _)| made == path)).collect::<Vec<_>>()
    };
    FOLDERS.into_iter().flat_map(of_folder).collect()
}

/// Writes a report, paths and texts, under a root; what its folders hold and it no longer has is removed.
pub fn write(report: &[(String, String)], root: &Path) -> Result<(), Error> {
    for (folder, _) in FOLDERS {
        let folder = root.join(folder);
        fs::create_dir_all(&folder).map_err(|error| Error::unwritable(&folder, error))?;
    }
    for path in stale(report, root) {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|error| Error::unwritable(&path, error))?;
    }
    write_all(report, root)
}

/// Writes files below a root.
pub fn write_all(files: &[(String, String)], root: &Path) -> Result<(), Error> {
    files.iter().try_for_each(|(path, text)| {
        let path = root.join(path);
        fs::write(&path, text).map_err(|error| Error::unwritable(&path, error))
    })
}

/// What differs between what is committed under a root and a report, files that it no longer has included; none where
/// nothing does.
pub fn difference(report: &[(String, String)], root: &Path) -> Result<Option<Difference>, Error> {
    let committed = Tree::on_disk(root)?;
    let written = committed.with("what the code writes now", report.to_vec(), &stale(report, root));
    Ok((committed.files != written.files).then(|| Difference::of(&committed, &written)))
}
