//! What is promised: what is called converged, whether error bars hold, whether an accuracy called met is met and what it costs,
//! and whether the bars beside the suite's own checks hold. In five files, since three are surveys of their own:
//!
//! * [`converged`] — every scene under all nine formulations (recorded).
//! * [`bars`] — true errors of random scenes against their bars (recorded).
//! * [`met`] — random scenes solved to five accuracies (recorded).
//! * [`asked`] — what an accuracy costs beside a mesh made by hand.
//! * `checks` — the bars of all checks, made after all other trials.

pub mod asked;
pub mod bars;
mod checks;
pub mod converged;
pub mod met;

use crate::case::Judged;
use crate::drawing::Drawing;
use crate::error::Error;
use crate::solution::EnergyError;
use crate::study::about::About;
use crate::study::records::Surveyed;
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "What is promised",
    asked: "Whether a run that is called converged has the peak and the width of its discrete problem, how often the true error is \
            within the error bar that was printed, how often an answer that is called accurate is not, and what an accuracy costs \
            beside a mesh made by hand.",
    limits: "What is called converged says nothing of the mesh: that is what error bars are for. Bars and accuracies are held \
             against random scenes whose truth is a closed form, or that of a boundary method: what has neither is not among them. \
             Of the checks only those against closed forms have a true error to look at.",
};

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// What is called converged, and errors in the energy norm with their bounds; none where they are not known.
    Converged(Surveyed<converged::Record>, Vec<Option<EnergyError>>),
    /// Errors and bars of random scenes.
    Bars(Surveyed<bars::Record>),
    /// Answers called met or not.
    Met(Surveyed<met::Record>),
    /// An answer beside a mesh made by hand.
    Asked(asked::Answered),
    /// How many checks have bars, and those whose error is beyond, each with the title of its trial.
    Checks(usize, Vec<(String, Judged)>),
}

impl Numbers {
    /// Of some checks, each with the title of its trial.
    pub fn of_checks<'a>(checks: impl IntoIterator<Item = (String, &'a Judged)>) -> Self {
        let (all, outside) = checks::barred(checks);
        Self::Checks(all, outside)
    }
}

/// The trials; the one of the checks is made after those of all studies.
pub fn plan() -> Vec<Planned<Numbers>> {
    let of = |case: &str, run: fn() -> Result<Numbers, Error>| Planned::new(case, "all scenes", run);
    let surveys = [
        of("what is called converged", || {
            Ok(Numbers::Converged(converged::SURVEY.surveyed()?, converged::energies()?))
        }),
        of("coverage of error bars", || bars::SURVEY.surveyed().map(Numbers::Bars)),
        of("what is called met", || met::SURVEY.surveyed().map(Numbers::Met)),
    ];
    let asked = asked::plan().into_iter().map(|one| {
        let (case, name) = (one.case.clone(), one.name.clone());
        Planned::new(case, name, move || one.run().map(Numbers::Asked))
    });
    surveys.into_iter().chain(asked).collect()
}

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Converged(surveyed, _) => converged::judge(surveyed),
        Numbers::Bars(surveyed) => bars::judge(surveyed),
        Numbers::Met(surveyed) => met::judge(surveyed),
        Numbers::Asked(answered) => asked::judge(answered),
        Numbers::Checks(all, outside) => checks::judge(*all, outside),
    })
}

/// A subsection for each promise.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::new();
    let mut answered = Vec::new();
    let mut checked = String::from("## Error bars beside checks\n\nThey are judged where all studies are solved.\n");
    for found in findings {
        match found.numbers {
            Numbers::Converged(surveyed, energies) => text += &converged::section(surveyed, energies),
            Numbers::Bars(surveyed) => text += &bars::section(surveyed),
            Numbers::Met(surveyed) => text += &met::section(surveyed),
            Numbers::Asked(one) => answered.push((found.name.to_owned(), *one)),
            Numbers::Checks(all, outside) => checked = checks::section(*all, outside),
        }
    }
    Ok(format!("{text}{}\n{checked}", asked::section(&answered)))
}

/// Runs that converge by the candidate stretch, and true errors against bars.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let picture = |found: &Found<Numbers>| match found.numbers {
        Numbers::Converged(surveyed, _) => Some(converged::picture(&surveyed.recorded)),
        Numbers::Bars(surveyed) => Some(bars::picture(&surveyed.recorded)),
        _ => None,
    };
    Ok(findings.iter().filter_map(picture).collect())
}
