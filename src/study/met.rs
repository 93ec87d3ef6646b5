//! Whether an accuracy called met is met: random scenes whose truth is known, solved to five accuracies, from guesses of the
//! candidate stretch up to ten times too long or three times too short.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::accuracy::{self, Answer, Asked};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::about::About;
use crate::study::random::{Family, GUESS, Sample, Site, unseen};
use crate::study::records::{self, rounded};
use crate::study::{Found, Planned};

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "met";

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Whether an accuracy called met is met",
    asked: "How often an answer that is called accurate is not.",
    limits: "Random scenes whose truth is known, as for error bars.",
};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("what is called met", "all scenes", numbers)]
}

/// Relative errors asked for.
pub const ASKED: [f64; 5] = [3e-2, 1e-2, 3e-3, 1e-3, 3e-4];
/// Families whose mesh is halved or made evenly finer, and scenes of each.
pub const EVENLY: [Family; 2] = [Family::Mesh, Family::Pair];
/// Scenes of each of these.
const EACH: usize = 20;
/// Scenes of each family of drawn gaps: sharp tops take large meshes.
const DRAWN: usize = 30;
/// Scenes of each other family.
const OTHERS: usize = 90;

/// All families but those whose peak has no limit.
pub fn families() -> impl Iterator<Item = Family> {
    let has_limit = |family: &Family| !matches!(family, Family::Punch | Family::Kink);
    unseen::FAMILIES.into_iter().filter(has_limit).chain(EVENLY)
}

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    let each = |family: Family| match family {
        Family::Mesh | Family::Pair => EACH,
        Family::Power | Family::Flat | Family::Skew | Family::Hump | Family::Ripple | Family::Blocks => DRAWN,
        Family::Layer | Family::Row => DRAWN,
        _ => OTHERS,
    };
    families().flat_map(|family| unseen::of(family).take(each(family))).collect()
}

/// One of so many scenes is solved again, to the accuracies that are cheap.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 8;
/// Accuracies to which they are solved again.
const AGAIN: usize = 2;

/// The record, and a part of it solved again.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// All answers recorded.
    pub recorded: Vec<Record>,
    /// Those of the fixed part as they are now.
    pub fresh: Vec<Record>,
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Family of the scene.
    pub family: Family,
    /// Its number in the family.
    pub number: usize,
    /// Relative error asked for.
    pub asked: f64,
    /// Whether it is said to be met.
    pub met: bool,
    /// Estimated relative error, the larger one of peak and half-width; NaN where there is none.
    pub estimate: f64,
    /// Relative error of the peak, with sign; the larger one of several contacts.
    pub peak: f64,
    /// Relative error of the half-width, with sign.
    pub half_width: f64,
    /// Degrees of freedom of the mesh answered.
    pub dofs: usize,
    /// Those of all meshes solved.
    pub dofs_in_all: usize,
}

impl Record {
    /// Of an answer.
    pub fn of(site: &Site, asked: f64, sample: &Sample, answer: &Answer) -> Self {
        let error = |k: usize| {
            let quantity = accuracy::Quantity::ASKED[k];
            let each = answer.run.contacts.iter().enumerate();
            let errors = each.map(|(at, one)| quantity.of(&one.measures) / sample.truth(at, quantity) - 1.0);
            rounded(errors.reduce(|a, b| if a.abs() >= b.abs() || a.is_nan() { a } else { b }).unwrap_or(f64::NAN))
        };
        let [peak, half_width] = [error(0), error(1)];
        Self {
            family: site.family,
            number: site.number,
            asked,
            met: answer.unmet.is_none(),
            estimate: rounded(answer.estimate()),
            peak,
            half_width,
            dofs: answer.run.dofs,
            dofs_in_all: answer.dofs_in_all(),
        }
    }

    /// The larger error of peak and half-width; NaN where either is.
    pub fn error(&self) -> f64 {
        larger(self.peak.abs(), self.half_width.abs())
    }

    /// Said to be met, and not so.
    pub fn is_falsely_met(&self) -> bool {
        let within = self.error() <= self.asked && self.estimate <= self.asked;
        self.met && !within
    }

    /// Said not to be met beside an estimate within what is asked.
    pub fn is_contradictory(&self) -> bool {
        !self.met && self.estimate <= self.asked
    }
}

/// A scene solved to every accuracy.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    let sample = site.sample()?;
    ASKED.into_iter().map(|asked| record(site, asked, &sample)).collect()
}

/// A scene solved to one accuracy.
pub fn record(site: &Site, asked: f64, sample: &Sample) -> Result<Record, Error> {
    let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
    let answer = accuracy::solve(&sample.scene, &formulation, &Asked::new(asked))?;
    Ok(Record::of(site, asked, sample, &answer))
}

/// The record, and a fixed twentieth of its scenes once more.
pub fn numbers() -> Result<Numbers, Error> {
    let recorded = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let again: Vec<Site> = sites().into_iter().skip(FIRST).step_by(OF).collect();
    let solved = |site: &Site| -> Result<Vec<Record>, Error> {
        let sample = site.sample()?;
        ASKED.into_iter().take(AGAIN).map(|asked| record(site, asked, &sample)).collect()
    };
    let fresh = again.par_iter().map(solved).collect::<Result<Vec<_>, Error>>()?.concat();
    Ok(Numbers { recorded, fresh })
}

/// Share of what is called met that may not be so.
const WRONG: f64 = 0.01;
/// Error over what was asked, of what is called met.
const FARTHEST: f64 = 1.5;
/// A recomputed error may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;
/// Errors below this part of the one asked for may differ: they hang on the iteration.
const ITERATED: f64 = 0.01;

/// The checks.
pub fn judge(Numbers { recorded, fresh }: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![as_recorded(recorded, fresh), right(recorded), near(recorded), consistent(recorded)])
}

/// Whether fresh answers are the recorded ones.
fn as_recorded(recorded: &[Record], fresh: &[Record]) -> Judged {
    let moved = fresh.iter().filter(|fresh| !recorded.iter().any(|kept| is_as_recorded(kept, fresh))).count();
    let quantity = Quantity::at("recomputed answer that is not the recorded one", format!("of {}", fresh.len()));
    let record = Reference::own("snapshots/met.csv", 0.0);
    Check::at_most(quantity, record, "mesh, estimate and errors; `met` renews the record").judge(if fresh.is_empty() {
        f64::NAN
    } else {
        moved as f64
    })
}

/// Whether a fresh answer is the recorded one: mesh and verdict always, errors but for the iteration.
pub fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let key = |record: &Record| (record.family, record.number, record.asked.to_bits());
    let found = |record: &Record| (record.met, record.dofs, record.dofs_in_all);
    let alike = |a: f64, b: f64| {
        (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + ITERATED * kept.asked
    };
    key(kept) == key(fresh)
        && found(kept) == found(fresh)
        && alike(kept.estimate, fresh.estimate)
        && alike(kept.peak, fresh.peak)
        && alike(kept.half_width, fresh.half_width)
}

/// What is called met is so, but for a small share.
pub fn right(recorded: &[Record]) -> Judged {
    let met = recorded.iter().filter(|record| record.met).count();
    let wrong = recorded.iter().filter(|record| record.is_falsely_met()).count();
    let quantity = Quantity::at(
        "share of the accuracies called met with a peak or a half-width off by more than was asked",
        format!("{wrong} of {met} called met, {} answers in all", recorded.len()),
    );
    let because = "bars are held by nineteen of twenty and more, and an answer seldom uses all of its own";
    Check::error(quantity, Reference::analytic("closed forms", 0.0), WRONG, because).judge(wrong as f64 / met as f64)
}

/// Nothing that is called met is far from it.
pub fn near(recorded: &[Record]) -> Judged {
    let over = recorded.iter().filter(|record| record.met).map(|record| record.error() / record.asked);
    let quantity = Quantity::at("largest error over what was asked, of what is called met", "peak or half-width");
    let because = "who asks for 1 % may be given 1.5 %, and never twice as much";
    Check::at_most(quantity, Reference::analytic("closed forms", FARTHEST), because)
        .judge(over.reduce(larger).unwrap_or(f64::NAN))
}

/// Nothing is called not met whose estimates are all within what was asked.
pub fn consistent(recorded: &[Record]) -> Judged {
    let wrong = recorded.iter().filter(|record| record.is_contradictory()).count();
    let quantity = Quantity::at(
        "accuracy called not met beside estimates that are all within it",
        format!("of {} answers", recorded.len()),
    );
    let because = "an estimate beyond what was asked is the reason why it is not met";
    Check::at_most(quantity, Reference::own("the estimate", 0.0), because).judge(if recorded.is_empty() {
        f64::NAN
    } else {
        wrong as f64
    })
}

/// Columns.
const HEAD: [&str; 7] = [
    "scenes",
    "asked",
    "answers",
    "called met",
    "falsely met",
    "largest error called met, over asked",
    "largest error over its estimate",
];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let [shortest, longest] = GUESS;
    let rows: Vec<Vec<String>> = findings.iter().flat_map(|found| by_family(&found.numbers.recorded)).collect();
    Ok(format!(
        "The random scenes of *Whether error bars hold*, but for flat punches and polygons, whose peak has no limit; such scenes with a coarse mesh \
         given for the body, its inner nodes shaken, and two of them in one, whatever their sizes. Size, material, load and the guess of the candidate stretch, {shortest} to {longest} times the contact, are drawn. The error is \
         the larger one of peak pressure and half-width against the truth, over both contacts. `cargo run --release -- met` renews the record; the \
         report recomputes a part of it.\n\n{}\n",
        markdown::table(&HEAD.map(String::from), &rows)
    ))
}

fn by_family(recorded: &[Record]) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for family in families() {
        for asked in ASKED {
            let is_own = |record: &&Record| record.family == family && record.asked.to_bits() == asked.to_bits();
            rows.push(row(family, asked, &recorded.iter().filter(is_own).collect::<Vec<_>>()));
        }
    }
    rows
}

fn row(family: Family, asked: f64, own: &[&Record]) -> Vec<String> {
    let met = || own.iter().filter(|record| record.met);
    let falsely = own.iter().filter(|record| record.is_falsely_met()).count();
    let largest = |ratio: fn(&Record) -> f64| {
        met().map(|record| ratio(record)).reduce(larger).map_or("–".into(), |worst| format!("{worst:.2}"))
    };
    vec![
        family.title().into(),
        format!("{} %", 100.0 * asked),
        own.len().to_string(),
        format!("{:.0} %", 100.0 * met().count() as f64 / own.len() as f64),
        falsely.to_string(),
        largest(|record| record.error() / record.asked),
        largest(|record| record.error() / record.estimate),
    ]
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
