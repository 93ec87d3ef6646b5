//! Asking the codes now: live answers, whether they are what was frozen, and the frozen files made anew.

use crate::case::check::{Check, Reference};
use crate::case::cross_code::answers::{Groups, changes, largest_change};
use crate::case::cross_code::discrete::{Twin, problems};
use crate::case::cross_code::{benchmark, physical};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::frozen::{Frozen, Series, script_hash};
use crate::oracle::cross_code::{Code, Method, PhysicalScene, live};

/// Relative difference from the frozen answer that a live one may have: solvers and libraries differ in round-off.
const REPRODUCED: f64 = 1e-6;

/// The series of a scene, asked now.
pub fn ask(code: Code, scene: &PhysicalScene) -> Result<Series, Error> {
    let levels = |method| (0..physical::LEVELS).map(move |level| live::physical(code, scene, level, method));
    let penalty = levels(Method::Penalty).collect::<Result<_, _>>()?;
    let active_set = match code {
        Code::ScikitFem => levels(Method::ActiveSet).collect::<Result<_, _>>()?,
        Code::Dolfinx => Vec::new(),
    };
    Ok(Series { scene: scene.clone(), penalty, active_set })
}

/// A live run finds what was frozen; otherwise the versions that changed are named.
pub fn reproduced(code: Code, now: &Groups, kept: &Groups) -> Result<Check, Error> {
    let changed = Frozen::read(code)?.changed_versions(&live::versions()?);
    let reference = Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0 };
    Ok(Check::norm(
        format!("{code}, run live, shall find what was frozen"),
        "largest relative change",
        largest_change(now, kept),
        reference,
        REPRODUCED,
        changed,
    ))
}

/// Asks both codes for everything, writes the frozen files once both have answered, and tells what changed.
pub fn freeze() -> Result<Vec<String>, Error> {
    let answers: Vec<(Code, Frozen)> =
        Code::ALL.into_iter().map(|code| Ok((code, ask_all(code)?))).collect::<Result<_, Error>>()?;
    let mut lines = Vec::new();
    for (code, new) in answers {
        match Frozen::load(code) {
            Ok(old) => lines.extend(changes(code, &old, &new)),
            Err(Error::MissingFile { .. }) => lines.push(format!("{code}: frozen for the first time")),
            Err(unreadable) => lines.push(format!("{code}: frozen anew, as {unreadable}")),
        }
        new.write(code)?;
    }
    Ok(lines)
}

fn ask_all(code: Code) -> Result<Frozen, Error> {
    let mut all = Frozen {
        scripts: script_hash()?,
        versions: live::versions()?,
        discrete: Default::default(),
        physical: Default::default(),
    };
    for (name, order) in problems() {
        let twin = Twin::of(name, order)?;
        let answer = live::discrete(code, &twin.problem)?;
        all.discrete.insert(twin.problem.name.clone(), twin.digest_of_other(&answer));
    }
    for benchmark in benchmark::benchmarks()? {
        all.physical.insert(benchmark.name.into(), ask(code, &benchmark.physical)?);
    }
    Ok(all)
}
