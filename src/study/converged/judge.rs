//! What the record must hold: a twentieth recomputed is what was recorded, and what is called converged is right.

use rayon::prelude::*;

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::solve::{Formulation, Settings};
use crate::study::atlas::Class;
use crate::study::converged::NAME;
use crate::study::converged::plan::{LOADS, STRETCHES, Site, TOLERANCES, sites};
use crate::study::converged::run::{self, ROUND_OFF, Record};
use crate::study::records;
use crate::study::unsorted::{Finding, Series, Table, Trial};

/// Error of a peak or a half-width that an iteration within its tolerance may have, in tolerances.
const SLACK: f64 = 3.0;

/// Name of the study.
pub const STUDY: &str = "what is called converged";
/// One of so many sites is run again.
const OF: usize = 20;
/// The first of them.
const FIRST: usize = 8;
/// A recomputed error may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;

/// The trial.
pub fn trials() -> Vec<Trial> {
    vec![Trial::new(STUDY, "all scenes", judge)]
}

fn judge() -> Result<Finding, Error> {
    let recorded: Vec<Record> = records::read(&records::file(NAME), &records::renewal(NAME))?;
    let checks = vec![recomputed(&recorded)?, right(&recorded)];
    let tables = vec![by_stretch(&recorded), by_load(&recorded)];
    Ok(Finding { checks, tables, series: series(&recorded), ..Default::default() })
}

/// The fixed twentieth of the sites once more.
fn recomputed(recorded: &[Record]) -> Result<Judged, Error> {
    let again: Vec<Site> = sites()?.into_iter().skip(FIRST).step_by(OF).collect();
    let moved = again.par_iter().map(|site| -> Result<[usize; 2], Error> {
        let fresh = run::records(site)?;
        let kept: Vec<&Record> = of_site(recorded, site).collect();
        let differ = fresh.iter().zip(&kept).filter(|(fresh, kept)| !is_as_recorded(kept, fresh)).count();
        Ok([fresh.len().max(kept.len()), differ + fresh.len().abs_diff(kept.len())])
    });
    let counts: Vec<[usize; 2]> = moved.collect::<Result<_, _>>()?;
    let [runs, moved] = [0, 1].map(|k| counts.iter().map(|count| count[k]).sum::<usize>());
    Ok(Judged::at_most(
        "A recomputed twentieth of the survey of what is called converged shall be what was recorded",
        format!("runs that moved, of {runs}"),
        if runs == 0 { f64::NAN } else { moved as f64 },
        Reference::own("snapshots/converged.csv", 0.0),
        "outcome, steps and error; `converged` renews the record",
    ))
}

fn of_site<'a>(recorded: &'a [Record], site: &'a Site) -> impl Iterator<Item = &'a Record> {
    let scene = site.scene();
    recorded.iter().filter(move |record| record.scene == scene && record.stretch.to_bits() == site.stretch.to_bits())
}

/// Whether a fresh run is the recorded one: outcome and steps always, the error where it is above round-off.
pub fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let key = |record: &Record| (record.formulation.clone(), record.load.to_bits(), record.tolerance.to_bits());
    let [a, b] = [kept.error, fresh.error];
    let alike =
        (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + ROUND_OFF * kept.tolerance;
    key(kept) == key(fresh) && kept.class == fresh.class && kept.steps == fresh.steps && alike
}

/// Nothing is called converged that is not.
pub fn right(recorded: &[Record]) -> Judged {
    let converged: Vec<&Record> = recorded.iter().filter(|record| record.class == Class::Converged).collect();
    let right = converged.iter().filter(|record| record.error <= SLACK * record.tolerance).count();
    let wrong = converged.len() - right;
    Judged::at_most(
        format!(
            "No run shall be called converged with a peak or a half-width off its discrete solution by {SLACK} tolerances"
        ),
        format!("wrong, of {} converged runs of {}", converged.len(), recorded.len()),
        if converged.is_empty() { f64::NAN } else { wrong as f64 },
        Reference::own("active set", 0.0),
        "relative to that solution, contact by contact",
    )
}

/// Share of some runs that converge; – without one.
fn share<'a>(runs: impl Iterator<Item = &'a Record>) -> String {
    let runs: Vec<&Record> = runs.collect();
    let converged = runs.iter().filter(|record| record.class == Class::Converged).count();
    if runs.is_empty() { "–".into() } else { format!("{:.0} %", 100.0 * converged as f64 / runs.len() as f64) }
}

fn names() -> Vec<String> {
    Formulation::nine().iter().map(Formulation::name).collect()
}

/// Shares that converge, by formulation and stretch.
fn by_stretch(recorded: &[Record]) -> Table {
    let mut rows = Vec::new();
    for tolerance in TOLERANCES {
        for name in names() {
            let own = |record: &&Record| record.formulation == name && record.tolerance == tolerance;
            let cells = STRETCHES.map(|stretch| share(recorded.iter().filter(own).filter(|r| r.stretch == stretch)));
            rows.push([vec![name.clone(), format!("{tolerance:e}")], cells.into()].concat());
        }
    }
    let stretches = STRETCHES.map(|stretch| if stretch > 0.0 { format!("{stretch} a") } else { "own".into() });
    let head = [vec!["formulation".into(), "tolerance".into()], stretches.into()].concat();
    Table {
        title: format!(
            "Share of the runs that converge within {} steps, by candidate stretch, all loads",
            Settings::default().max_steps
        ),
        head,
        rows,
    }
}

/// Shares that converge, by formulation and load.
fn by_load(recorded: &[Record]) -> Table {
    let mut rows = Vec::new();
    for name in names() {
        let of = |tolerance: f64, load: f64| {
            let own = move |record: &&Record| record.tolerance == tolerance && record.load == load;
            share(recorded.iter().filter(|record| record.formulation == name).filter(own))
        };
        let cells = TOLERANCES.into_iter().flat_map(|tolerance| LOADS.map(|load| of(tolerance, load)));
        rows.push(std::iter::once(name.clone()).chain(cells).collect());
    }
    let columns =
        TOLERANCES.into_iter().flat_map(|tolerance| LOADS.map(|load| format!("{tolerance:e}, load × {load:e}")));
    let head = std::iter::once("formulation".to_string()).chain(columns).collect();
    Table { title: "The same by load, all stretches".into(), head, rows }
}

/// Picture of the shares.
pub const PICTURE: &str = "converged";

/// Share that converges at the default tolerance against the stretch, a curve a formulation.
fn series(recorded: &[Record]) -> Vec<Series> {
    let of = |name: String| {
        let at = |stretch: f64| {
            let own: Vec<&Record> = recorded
                .iter()
                .filter(|r| r.formulation == name && r.tolerance == TOLERANCES[0] && r.stretch == stretch)
                .collect();
            let converged = own.iter().filter(|record| record.class == Class::Converged).count();
            [stretch, 100.0 * converged as f64 / own.len() as f64]
        };
        let points = STRETCHES.into_iter().filter(|stretch| *stretch > 0.0).map(at).collect();
        Series { picture: PICTURE.into(), label: name.clone(), points, failed: Vec::new() }
    };
    names().into_iter().map(of).collect()
}
