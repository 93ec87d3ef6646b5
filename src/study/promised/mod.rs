//! What is promised: what is called converged, whether error bars hold, whether an accuracy called met is met and what
//! it costs, and whether the bars beside the suite's own checks hold. In files, since four are surveys of their own:
//!
//! * [`converged`] — every scene under all nine formulations (recorded).
//! * [`counted`] — the random scenes from which the constants of the bars are derived (recorded).
//! * [`bars`] — true errors of other random scenes against their bars (recorded).
//! * [`met`] — random scenes solved to five accuracies (recorded).
//!
//! The bars of all checks are judged below, after all other trials.

pub mod bars;
pub mod converged;
pub mod counted;
pub mod met;

use crate::case::{Check, Judged, Reference};
use crate::drawing::Drawing;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::solution::EnergyError;
use crate::study::about::{About, Found, Planned, Study};

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// What is called converged, and errors in the energy norm with their bounds; none where they are not known.
    Converged(Vec<converged::Record>, Vec<Option<EnergyError>>),
    /// Errors and bars of random scenes.
    Bars(Vec<bars::Record>),
    /// Answers called met or not, and some beside 8-node cells.
    Met(Vec<met::Record>, Vec<met::Beside>),
    /// How many checks have a bar beside a closed form; and those of them whose true error is beyond the bar and what
    /// the closed form itself may be off, or whose bar is not known, each with the title of its trial.
    Checks(usize, Vec<(String, Judged)>),
}

impl Study for Numbers {
    const NAME: &'static str = "promised";
    const ABOUT: About = About {
        title: "What is promised",
        asked: "What is called converged and how often that is reached, how often the true error is \
                within the error bar that was printed, how often an answer that is called accurate is not, and what an \
                accuracy costs.",
        limits: "What is called converged says nothing of the mesh: that is what error bars are for. Bars and \
            accuracies are held against random scenes whose truth is a closed form, or that of a boundary method: \
            what has neither is not among them. Of the checks only those against closed forms have a true error to \
            look at.",
    };

    /// The trials; the one of the checks is made after those of all studies.
    fn plan() -> Vec<Planned<Self>> {
        let of = |case: &str, run: fn() -> Result<Numbers, Error>| Planned::new(case, "all scenes", run);
        vec![
            of("what is called converged", || {
                Ok(Numbers::Converged(converged::SURVEY.read()?, converged::energies()?))
            }),
            of("coverage of error bars", || bars::SURVEY.read().map(Numbers::Bars)),
            of("what is called met", || Ok(Numbers::Met(met::SURVEY.read()?, met::beside()?))),
        ]
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Converged(..) => vec![],
            Numbers::Bars(recorded) => bars::judge(recorded),
            Numbers::Met(recorded, _) => met::judge(recorded),
            Numbers::Checks(all, outside) => judge_checks(*all, outside),
        })
    }

    /// A subsection for each promise.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let mut text = String::new();
        let mut checked =
            String::from("## Error bars beside checks\n\nThey are judged where all studies are solved.\n");
        for found in findings {
            match found.numbers {
                Numbers::Converged(recorded, energies) => text += &converged::section(recorded, energies),
                Numbers::Bars(recorded) => text += &bars::section(recorded),
                Numbers::Met(recorded, beside) => text += &met::section(recorded, beside),
                Numbers::Checks(all, outside) => checked = section_on_checks(*all, outside),
            }
        }
        Ok(text + &checked)
    }

    /// Runs that converge by the candidate stretch, and true errors against bars.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let picture = |found: &Found<Self>| match found.numbers {
            Numbers::Converged(recorded, _) => Some(converged::picture(recorded)),
            Numbers::Bars(recorded) => Some(bars::picture(recorded)),
            _ => None,
        };
        Ok(findings.iter().filter_map(picture).collect())
    }
}

impl Numbers {
    /// Of some checks, each with the title of its trial.
    pub fn of_checks<'a>(checks: impl IntoIterator<Item = (String, &'a Judged)>) -> Self {
        let barred = checks.into_iter().filter(|(_, one)| one.is_within_bar().is_some());
        let mut barred: Vec<(String, Judged)> = barred.map(|(trial, one)| (trial, one.clone())).collect();
        let all = barred.len();
        barred.retain(|(_, one)| one.is_within_bar() == Some(false));
        Self::Checks(all, barred)
    }
}

/// Share of the checks whose error may be beyond its bar.
const SHARE: f64 = 0.05;

/// The check; it fails where there is nothing to judge.
fn judge_checks(all: usize, outside: &[(String, Judged)]) -> Vec<Judged> {
    let share = outside.len() as f64 / all as f64;
    let quantity = "share of checks against closed forms whose true error is beyond its bar, or whose bar is not known";
    let because = "a bar holds for 95 of 100 numbers; those beyond are listed";
    let check = Check::at_most(quantity, Reference::analytic("closed forms", SHARE), because);
    vec![check.asked_of(all).judge(share)]
}

/// The table of checks beyond their bars.
const COLUMNS: [Column<(String, Judged)>; 7] = [
    ("trial", |(trial, _)| trial.clone()),
    ("quantity", |(_, one)| one.check.quantity.to_string()),
    ("closed form", |(_, one)| one.reference.name.clone()),
    ("error", |(_, one)| markdown::error(one.error)),
    ("bar", |(_, one)| one.bar_as_error().filter(|bar| !bar.is_nan()).map_or("unknown".into(), markdown::error)),
    ("model error stated", |(_, one)| match one.check.model {
        model if model > 0.0 => markdown::error(model),
        _ => "–".into(),
    }),
    ("because", |(_, one)| one.check.because.to_string()),
];

/// The section: the checks beyond their bars.
fn section_on_checks(all: usize, outside: &[(String, Judged)]) -> String {
    let table = if outside.is_empty() { String::new() } else { markdown::columns(&COLUMNS, outside) };
    let unknown = outside.iter().filter(|(_, one)| !one.has_known_bar()).count();
    format!(
        include_str!("checks.md"),
        all = all,
        beyond = outside.len() - unknown,
        unknown = unknown,
        end = if outside.is_empty() { "." } else { ":" },
        table = table
    )
}
