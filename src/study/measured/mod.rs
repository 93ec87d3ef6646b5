//! Against measurements: digitised curves of pins, and a photograph of a disc between two plates. Two comparisons of
//! one page, which share nothing but that nothing of theirs is ours:
//!
//! * [`curves`] — digitised curves against the same pins of ours; not run while the figures are not at hand.
//! * [`photograph`] — isochromatics of a disc, shape only; `field` — the fringe orders of our disc, and what is fitted
//!   to them.

pub mod curves;
mod field;
pub mod photograph;

use crate::case::Judged;
use crate::drawing::Drawing;
use crate::error::Error;
use crate::oracle::digitised::fringes;
use crate::study::about::About;
use crate::study::{Found, Planned};

use curves::Curve;
use photograph::Photograph;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against measurements",
    asked: "Whether stresses and loads along real pins are those that were measured, and the stress field between two \
        plates that of a photographed disc.",
    limits: "Digitised curves: nothing is compared until somebody brings the figures. The photograph is uncalibrated: \
        shapes only. It tells neither load, nor material, nor pressure.",
};

/// The source of the paper's Figures 14 and 15.
pub const GAERTNER: &str = "gaertner 1977";

/// Sources of curves, and their folders under `oracles/digitised`.
const SOURCES: [(&str, &str); 2] = [(GAERTNER, "gaertner-1977"), ("ghosh 1982", "ghosh-1982")];

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// The curves of a source.
    Curves {
        /// Its name.
        source: String,
        /// Every curve, or why the figures are not at hand.
        found: Result<Vec<Curve>, String>,
    },
    /// What the photograph says of our disc.
    Photograph(Photograph),
}

/// A trial a source of curves, and the one photograph.
pub fn plan() -> Vec<Planned<Numbers>> {
    let curves = SOURCES.map(|(source, folder)| {
        Planned::new(source, "digitised curves", move || {
            Ok(Numbers::Curves { source: source.into(), found: curves::against(&curves::folder(folder))? })
        })
    });
    let photograph = Planned::new("photoelastic disc between plates", "isochromatics of a photograph", || {
        photograph::compare(&fringes::read(&fringes::file())?).map(Numbers::Photograph)
    });
    curves.into_iter().chain([photograph]).collect()
}

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Curves { source, found } => curves::judge(source, found),
        Numbers::Photograph(photograph) => photograph::judge(photograph),
    })
}

/// What is compared; of curves the table of checks says the rest.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let photographs = photographs(findings).map(photograph::section);
    Ok(format!(
        "## Digitised curves\n\n\
         Stresses along the pin of a rod (Gaertner 1977), and load against the angle of contact of a pin in a \
         large sheet (Ghosh, Dattaguru and Rao 1982), each held against the same pin of ours. The folders under `oracles/digitised` say what to \
         bring.\n\n## A photograph\n\n{}",
        photographs.collect::<String>()
    ))
}

/// Of the photograph.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(photographs(findings).flat_map(photograph::pictures).collect())
}

fn photographs<'a>(findings: &'a [Found<Numbers>]) -> impl Iterator<Item = &'a Photograph> {
    findings.iter().filter_map(|found| match found.numbers {
        Numbers::Photograph(photograph) => Some(photograph),
        Numbers::Curves { .. } => None,
    })
}
