//! One page of the report: that of a study, or of a case.

use crate::case::library::NAMES;
use crate::error::Error;
use crate::error::nearest::meant;
use crate::report::case_page;
use crate::report::links::PAGES;
use crate::report::page::of_study;
use crate::study::{Files, Finding, Room, Trial, cases, on_page};

/// What a page is of.
pub enum Only {
    /// A study.
    Study(&'static Room),
    /// A page of cases, by its name.
    Case(String),
}

impl Only {
    /// The study or the page of this name; a case by its own name, or that of its file, is on a page.
    pub fn named(name: &str) -> Result<Self, Error> {
        if let Some(room) = Room::ALL.iter().find(|room| room.name == name) {
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

    /// What is to be solved for it.
    pub fn trials(&self) -> Vec<Trial> {
        match self {
            Self::Study(room) => (room.plan)(),
            Self::Case(page) => on_page(page),
        }
    }

    /// The page first, then its charts and its sheets: paths and texts. Charts of cases are those of their study.
    pub fn files(&self, findings: &[Finding]) -> Result<Files, Error> {
        match self {
            Self::Study(room) => of_study(room, findings),
            Self::Case(_) => {
                let has_sheet = |name: &str| NAMES.iter().any(|(known, _)| *known == name);
                let shared = case_page::shared(findings);
                let page = |one: &case_page::Shared| {
                    (format!("{PAGES}/{}", case_page::file(&one.name)), case_page::page(one, has_sheet(&one.name)))
                };
                Ok(shared.iter().map(page).collect())
            }
        }
    }
}
