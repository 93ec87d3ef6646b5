//! Where the other codes' answers come from: frozen files, or the codes themselves.

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, Series, file};
#[cfg(feature = "python")]
use crate::oracle::cross_code::live;
use crate::oracle::cross_code::{Code, DiscreteAnswer, PhysicalScene};
use crate::study::cross_code::discrete::Twin;
#[cfg(feature = "python")]
use crate::study::cross_code::renewal;

/// Frozen or live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answers {
    /// Read from `oracles/frozen`; Rust alone suffices.
    Frozen,
    /// Asked now, and held against the frozen ones as well.
    #[cfg(feature = "python")]
    Live,
}

impl Answers {
    /// What tells the trials apart: nothing for frozen answers, which the page shows.
    pub fn suffix(self) -> &'static str {
        match self {
            Self::Frozen => "",
            #[cfg(feature = "python")]
            Self::Live => ", live",
        }
    }

    /// A code's answer to our discrete problem, whole where it is live, and whether it is what was frozen.
    pub fn discrete(self, code: Code, twin: &Twin) -> Result<(Digest, Option<DiscreteAnswer>, Vec<Judged>), Error> {
        let name = &twin.problem.name;
        let frozen = Frozen::read(code)?;
        let kept = frozen.discrete.get(name).cloned().ok_or_else(|| absent(code, name))?;
        let nodes = twin.problem.points.len();
        if kept.nodes != nodes {
            let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
            return Err(Error::refused(&file(code), name, found, REFREEZE));
        }
        match self {
            Self::Frozen => Ok((kept, None, Vec::new())),
            #[cfg(feature = "python")]
            Self::Live => {
                let answer = live::discrete(code, &twin.problem)?;
                let digest = twin.digest_of_other(&answer);
                let changed = frozen.changed_versions(&live::versions()?);
                let check = reproduced(code, &digest.numbers(), &kept.numbers(), changed);
                Ok((digest, Some(answer), vec![check]))
            }
        }
    }

    /// A code's refinement series of a scene, and whether it is what was frozen.
    pub fn physical(self, code: Code, name: &str, scene: &PhysicalScene) -> Result<(Series, Vec<Judged>), Error> {
        let frozen = Frozen::read(code)?;
        let kept = frozen.physical.get(name).cloned().ok_or_else(|| absent(code, name))?;
        if let Some((key, ours, theirs)) = other_scene(scene, &kept.scene) {
            let found = format!("{theirs} in the frozen scene, but {ours} in ours");
            return Err(Error::refused(&file(code), &format!("{name}: {key}"), found, REFREEZE));
        }
        let answers = kept.penalty.iter().chain(&kept.active_set);
        if let Some(short) = answers.map(|answer| answer.pressure.len()).find(|&n| n != scene.stations.len()) {
            let found = format!("{short} pressures at {} stations", scene.stations.len());
            return Err(Error::refused(&file(code), name, found, REFREEZE));
        }
        match self {
            Self::Frozen => Ok((kept, Vec::new())),
            #[cfg(feature = "python")]
            Self::Live => {
                let series = renewal::ask(code, scene)?;
                let changed = frozen.changed_versions(&live::versions()?);
                let check = reproduced(code, &series.numbers(), &kept.numbers(), changed);
                Ok((series, vec![check]))
            }
        }
    }
}

fn absent(code: Code, name: &str) -> Error {
    Error::missing_key(&file(code), name, "the frozen results", REFREEZE)
}

/// The first number in which two scenes differ; NaN where one has none.
fn other_scene(ours: &PhysicalScene, theirs: &PhysicalScene) -> Option<(String, f64, f64)> {
    let pairs = |(key, &value): (&String, &f64)| (key.clone(), value, theirs.numbers.get(key).copied());
    let mut all: Vec<(String, f64, Option<f64>)> = ours.numbers.iter().map(pairs).collect();
    let surplus = theirs.numbers.iter().filter(|(key, _)| !ours.numbers.contains_key(*key));
    all.extend(surplus.map(|(key, &value)| (key.clone(), f64::NAN, Some(value))));
    all.push(("stations".into(), ours.stations.len() as f64, Some(theirs.stations.len() as f64)));
    let stations = ours.stations.iter().zip(&theirs.stations);
    all.extend(stations.map(|(&a, &b)| ("a station".to_string(), a, Some(b))));
    all.push(("case".into(), 0.0, Some(if ours.case == theirs.case { 0.0 } else { 1.0 })));
    let told = all.into_iter().map(|(key, a, b)| (key, a, b.unwrap_or(f64::NAN)));
    // Acceptance is stated, so that a missing number is a difference.
    told.into_iter().find(|(_, a, b)| {
        let same = (a - b).abs() <= 1e-12 * b.abs();
        !same
    })
}

/// A live answer is what was frozen; the versions that changed since are named.
pub fn reproduced(code: Code, now: &Groups, kept: &Groups, changed: String) -> Judged {
    Judged::norm(
        format!("{code}, run live, shall find what was frozen"),
        "largest relative change",
        largest_change(now, kept),
        Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0 },
        REPRODUCED,
        format!("solvers and libraries differ in round-off; {changed}"),
    )
}

/// Relative difference from the frozen answer that a live one may have.
const REPRODUCED: f64 = 1e-6;

/// Numbers in groups of one unit and scale.
pub type Groups = [(String, Vec<f64>)];

/// Largest change of any number over the largest number of its group; NaN where the groups do not match.
pub fn largest_change(now: &Groups, kept: &Groups) -> f64 {
    let values = |groups: &Groups| groups.iter().map(|(_, values)| values.clone()).collect::<Vec<_>>();
    worst_difference(&values(now), &values(kept))
}

/// The largest [`relative_difference`] of lists of numbers; NaN where there are none or their numbers differ.
pub fn worst_difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::NAN;
    }
    largest(a.iter().zip(b).map(|(a, b)| relative_difference(a, b)))
}

/// `max |a − b| / max |b|`; NaN where there is nothing to compare, the lengths differ or a number is none.
pub fn relative_difference(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::NAN;
    }
    let scale = largest(b.iter().map(|x| x.abs()));
    let difference = largest(a.iter().zip(b).map(|(x, y)| (x - y).abs()));
    if scale > 0.0 { difference / scale } else { difference }
}

/// The largest of numbers not below zero; NaN if any is.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, value| if value > largest || value.is_nan() { value } else { largest })
}

/// What differs between two sets of frozen results: a line per version and per group of numbers.
pub fn changes(code: Code, old: &Frozen, new: &Frozen) -> Vec<String> {
    let (before, after) = (old.numbers(), new.numbers());
    let mut lines = vec![format!("{code}: {}", old.changed_versions(&new.versions))];
    for (name, values) in &after {
        match before.get(name) {
            None => lines.push(format!("{code}, {name}: new")),
            Some(earlier) => {
                let change = relative_difference(values, earlier);
                if change.is_nan() || change > 0.0 {
                    lines.push(format!("{code}, {name}: largest relative change {change:.2e}"));
                }
            }
        }
    }
    lines.extend(before.keys().filter(|name| !after.contains_key(*name)).map(|name| format!("{code}, {name}: gone")));
    lines
}
