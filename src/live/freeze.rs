//! Asks every code for everything, and writes the frozen files.

use std::collections::BTreeMap;

use contact_vv::error::{Error, Kind};
use contact_vv::oracle::cross_code::frozen::{Frozen, script_hash};
use contact_vv::oracle::cross_code::independent::{Asked, Folder, Independent, Script, hashes};
use contact_vv::oracle::cross_code::process::run;
use contact_vv::oracle::cross_code::revolution::Series;
use contact_vv::oracle::cross_code::{Code, PhysicalAnswer, PhysicalScene};
use contact_vv::study::cross_code::{Twin, problems};
use contact_vv::study::differences::{changes, largest_change};
use contact_vv::study::independent::run::{LEVELS, Scene, series};

use super::{LIVE, asked, newest};

/// Asks both codes for all discrete problems, dolfinx as it is today where that is installed, writes their files once
/// both have answered, and tells what changed.
pub fn discrete() -> Result<Vec<String>, Error> {
    let answers: Vec<(Code, Frozen)> =
        Code::TWINS.into_iter().map(|code| Ok((code, ask_all(code)?))).collect::<Result<_, Error>>()?;
    let mut lines = Vec::new();
    for (code, new) in answers {
        match Frozen::load(code) {
            Ok(old) => lines.extend(changes(code, &old, &new)),
            Err(Error { kind: Kind::MissingFile, .. }) => {
                lines.push(format!("{}: frozen for the first time", code.name()))
            }
            Err(unreadable) => lines.push(format!("{}: frozen again, as {unreadable}", code.name())),
        }
        new.write(code)?;
    }
    Ok(lines)
}

fn ask_all(code: Code) -> Result<Frozen, Error> {
    let twins: Vec<Twin> =
        problems().into_iter().map(|(name, order)| Twin::of(name, order)).collect::<Result<_, _>>()?;
    let (versions, answers) = match newest::python().filter(|_| code == Code::Dolfinx) {
        Some(python) => newest::discrete(&python, &twins)?,
        None => {
            let answers = twins.iter().map(|twin| asked::discrete(code, &twin.problem));
            (asked::versions()?, answers.collect::<Result<_, _>>()?)
        }
    };
    let digests = twins.iter().zip(&answers);
    let discrete = digests.map(|(twin, answer)| (twin.problem.name.clone(), twin.digest_of_other(answer))).collect();
    Ok(Frozen { scripts: script_hash()?, versions, discrete })
}

/// The series of a script from a code in a process of its own; refused where it is not installed.
fn ask_apart(script: Script, scene: &PhysicalScene) -> Result<Series<PhysicalAnswer>, Error> {
    let folder = script.folder().path();
    let arguments = [folder.display().to_string(), script.module().into(), script.method().into(), LEVELS.to_string()];
    let request = serde_json::to_string(scene).map_err(|error| Error::at(script.title(), error.to_string(), PEERS))?;
    let wrong = |what: String| Error::file(&folder, what, PEERS);
    match run(ASK, &arguments, &request)? {
        Err(why) => Err(wrong(why)),
        Ok(lines) => {
            let last = lines.into_iter().next_back().unwrap_or_default();
            serde_json::from_value(last).map_err(|error| wrong(error.to_string()))
        }
    }
}

/// What asks a code in a process of its own.
const ASK: &str = "ask.py";
/// What installs today's dolfinx.
const NEWER: &str = "run `NEWER_PYTHON=/path/to/python3.12 bash oracles/setup.sh`";
/// What installs these codes.
const PEERS: &str = "run `bash oracles/peers/setup.sh`";
/// A relative change that is no news.
const ROUND_OFF: f64 = 1e-9;

/// Asks every script for every scene that it serves, and writes the frozen file once all have answered. Answers of a
/// code in a process of its own are kept where neither its script nor the scene has changed.
pub fn independent() -> Result<Vec<String>, Error> {
    let (mut scenes, mut lines) = (BTreeMap::new(), Vec::new());
    let (old, scripts) = (Independent::load().ok(), hashes()?);
    let (mut versions, mut apart) = (asked::versions()?, BTreeMap::new());
    for scene in Scene::ALL {
        let (name, physical) = (scene.name(), scene.benchmark().physical);
        let known = old.as_ref().and_then(|old| old.scenes.get(name));
        let mut by_script = BTreeMap::new();
        for script in Script::ALL.into_iter().filter(|script| script.serves(&physical)) {
            let kept = known.and_then(|asked| asked.answers.get(&script));
            let folder = script.folder();
            let unchanged = old.as_ref().filter(|old| old.scripts.get(&folder) == scripts.get(&folder));
            let version = unchanged.and_then(|old| old.apart.get(&folder));
            let same_scene = known.is_some_and(|asked| asked.scene == physical);
            let now = match (kept, version, newest::python().filter(|_| folder == Folder::Dolfinx)) {
                (.., Some(python)) => {
                    let (now, series) = newest::series(&python, script, &physical, LEVELS)?;
                    versions.remove("dolfinx");
                    apart.extend(now.get("dolfinx").map(|version| (folder, version.clone())));
                    series
                }
                _ if script.is_set_up() => series(&LIVE, script, &physical)?,
                (Some(kept), Some(version), _) if same_scene => {
                    apart.insert(folder, version.clone());
                    kept.clone()
                }
                _ if folder == Folder::Dolfinx => {
                    let missing = format!("{script} needs dolfinx 0.11, which is not installed");
                    return Err(Error::file(&folder.path(), missing, NEWER));
                }
                _ => {
                    let told = ask_apart(script, &physical)?;
                    apart.insert(folder, told.version);
                    told.series
                }
            };
            let change = kept.map_or(f64::NAN, |kept| largest_change(&Asked::numbers(&now), &Asked::numbers(kept)));
            // NaN where nothing was kept.
            let same = change <= ROUND_OFF;
            lines.extend((!same).then(|| format!("{script}, {name}: changed by {change:.1e}")));
            by_script.insert(script, now);
        }
        scenes.insert(name.to_string(), Asked { scene: physical, answers: by_script });
    }
    Independent { scripts, versions, apart, scenes }.write()?;
    Ok(lines)
}
