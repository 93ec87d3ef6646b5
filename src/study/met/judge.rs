//! What the record must hold: a fixed part recomputed is what was recorded, and nothing is called met that is not.

use rayon::prelude::*;

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::study::met::NAME;
use crate::study::met::plan::{ASKED, Family, Site, sites};
use crate::study::met::run::{self, Record};
use crate::study::records;
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the study.
pub const STUDY: &str = "what is called met";
/// One of so many scenes is solved again, to the accuracies that are cheap.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 8;
/// Accuracies to which they are solved again.
const AGAIN: usize = 3;
/// A recomputed error may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;
/// Errors below this part of the one asked for may differ: they hang on the iteration.
const ITERATED: f64 = 0.01;

/// The trial.
pub fn trials() -> Vec<Trial> {
    vec![Trial::new(STUDY, "all scenes", judge)]
}

fn judge() -> Result<Finding, Error> {
    let recorded: Vec<Record> = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let checks = vec![recomputed(&recorded)?, right(&recorded), consistent(&recorded)];
    Ok(Finding { checks, tables: vec![by_family(&recorded)], ..Default::default() })
}

/// A fixed twentieth of the scenes once more.
fn recomputed(recorded: &[Record]) -> Result<Judged, Error> {
    let again: Vec<Site> = sites().into_iter().skip(FIRST).step_by(OF).collect();
    let moved = again.par_iter().map(|site| -> Result<[usize; 2], Error> {
        let sample = site.sample();
        let mut counts = [0; 2];
        for asked in ASKED.into_iter().take(AGAIN) {
            let fresh = run::record(site, asked, &sample)?;
            counts[0] += 1;
            counts[1] += usize::from(!recorded.iter().any(|kept| is_as_recorded(kept, &fresh)));
        }
        Ok(counts)
    });
    let counts: Vec<[usize; 2]> = moved.collect::<Result<_, _>>()?;
    let [answers, moved] = [0, 1].map(|k| counts.iter().map(|count| count[k]).sum::<usize>());
    Ok(Judged::at_most(
        "A recomputed part of the survey of what is called met shall be what was recorded",
        format!("answers that moved, of {answers}"),
        if answers == 0 { f64::NAN } else { moved as f64 },
        Reference::own("snapshots/met.csv", 0.0),
        "mesh, estimate and errors; `met` renews the record",
    ))
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

/// Nothing is called met that is not.
pub fn right(recorded: &[Record]) -> Judged {
    let met = recorded.iter().filter(|record| record.met).count();
    let wrong = recorded.iter().filter(|record| record.is_falsely_met()).count();
    Judged::at_most(
        "No accuracy shall be called met with a peak or a half-width off the closed form by more than was asked",
        format!("falsely met, of {met} answers called met of {}", recorded.len()),
        if met == 0 { f64::NAN } else { wrong as f64 },
        Reference::analytic("closed forms", 0.0),
        "what the closed forms leave out is below 1.5e-5",
    )
}

/// Nothing is called not met whose estimates are all within what was asked.
pub fn consistent(recorded: &[Record]) -> Judged {
    let wrong = recorded.iter().filter(|record| record.is_contradictory()).count();
    Judged::at_most(
        "No accuracy shall be called not met beside estimates that are all within it",
        format!("contradictory, of {} answers", recorded.len()),
        if recorded.is_empty() { f64::NAN } else { wrong as f64 },
        Reference::own("the estimate", 0.0),
        "an estimate beyond what was asked is the reason why it is not met",
    )
}

/// Answers by family and accuracy.
fn by_family(recorded: &[Record]) -> Table {
    let mut rows = Vec::new();
    for family in Family::ALL {
        for asked in ASKED {
            let own: Vec<&Record> = recorded
                .iter()
                .filter(|record| record.family == family && record.asked.to_bits() == asked.to_bits())
                .collect();
            rows.push(row(family, asked, &own));
        }
    }
    let head = [
        "scenes",
        "asked",
        "answers",
        "called met",
        "falsely met",
        "largest error called met, over asked",
        "largest error over its estimate",
    ];
    Table { title: "Answers to random scenes of closed form".into(), head: head.map(String::from).into(), rows }
}

fn row(family: Family, asked: f64, own: &[&Record]) -> Vec<String> {
    let met = || own.iter().filter(|record| record.met);
    let falsely = own.iter().filter(|record| record.is_falsely_met()).count();
    let largest = |ratio: fn(&Record) -> f64| {
        let worst = met().map(|record| ratio(record)).fold(f64::NAN, f64::max);
        if worst.is_finite() { format!("{worst:.2}") } else { "–".into() }
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
