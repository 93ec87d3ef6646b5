//! Where the other codes' answers come from: frozen files, or the codes themselves.

use serde::Serialize;

use crate::error::Error;
use crate::oracle::cross_code::frozen::{Digest, Frozen, REFREEZE, Series, file};
#[cfg(feature = "python")]
use crate::oracle::cross_code::live;
use crate::oracle::cross_code::{Code, DiscreteAnswer, PhysicalScene};
use crate::study::cross_code::differences::{Groups, largest_change};
#[cfg(feature = "python")]
use crate::study::cross_code::renewal;
use crate::study::cross_code::twin::Twin;

/// Frozen or live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answers {
    /// Read from `oracles/frozen`; Rust alone suffices.
    Frozen,
    /// Asked now, and held against the frozen ones as well.
    #[cfg(feature = "python")]
    Live,
}

/// A code's answer to our discrete problem.
pub struct Answered {
    /// In short.
    pub digest: Digest,
    /// In full; none where it was not asked.
    pub whole: Option<DiscreteAnswer>,
    /// Whether it is what was frozen; none where it was not asked.
    pub reproduced: Option<Reproduced>,
}

/// A live answer beside the frozen one.
#[derive(Clone, Debug, Serialize)]
pub struct Reproduced {
    /// Largest relative change of a number.
    pub change: f64,
    /// Versions that changed since.
    pub versions: String,
}

impl Reproduced {
    /// What changed, and the versions that changed since.
    pub fn of(now: &Groups, kept: &Groups, versions: String) -> Self {
        Self { change: largest_change(now, kept), versions }
    }
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

    /// A code's answer to our discrete problem.
    pub fn discrete(self, code: Code, twin: &Twin) -> Result<Answered, Error> {
        let name = &twin.problem.name;
        let frozen = Frozen::read(code)?;
        let kept = frozen.discrete.get(name).cloned().ok_or_else(|| absent(code, name))?;
        let nodes = twin.problem.points.len();
        if kept.nodes != nodes {
            let found = format!("of a mesh with {} nodes, but ours has {nodes}", kept.nodes);
            return Err(Error::refused(&file(code), name, found, REFREEZE));
        }
        match self {
            Self::Frozen => Ok(Answered { digest: kept, whole: None, reproduced: None }),
            #[cfg(feature = "python")]
            Self::Live => {
                let answer = live::discrete(code, &twin.problem)?;
                let digest = twin.digest_of_other(&answer);
                let changed = frozen.changed_versions(&live::versions()?);
                let reproduced = Some(Reproduced::of(&digest.numbers(), &kept.numbers(), changed));
                Ok(Answered { digest, whole: Some(answer), reproduced })
            }
        }
    }

    /// A code's refinement series of a scene, and whether it is what was frozen.
    pub fn physical(
        self,
        code: Code,
        name: &str,
        scene: &PhysicalScene,
    ) -> Result<(Series, Option<Reproduced>), Error> {
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
            Self::Frozen => Ok((kept, None)),
            #[cfg(feature = "python")]
            Self::Live => {
                let series = renewal::ask(code, scene)?;
                let changed = frozen.changed_versions(&live::versions()?);
                let reproduced = Reproduced::of(&series.numbers(), &kept.numbers(), changed);
                Ok((series, Some(reproduced)))
            }
        }
    }
}

fn absent(code: Code, name: &str) -> Error {
    Error::missing_key(&file(code), name, "the frozen results", REFREEZE)
}

/// The first number in which two scenes differ; NaN where one has none.
pub fn other_scene(ours: &PhysicalScene, theirs: &PhysicalScene) -> Option<(String, f64, f64)> {
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
