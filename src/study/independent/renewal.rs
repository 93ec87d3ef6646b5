//! Asking the scripts now, and renewing the frozen file.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::error::Error;
use crate::oracle::cross_code::independent::{Asked, Independent, Script, hashes};
use crate::oracle::cross_code::process::{Told, run};
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene, live};
use crate::study::differences::largest_change;
use crate::study::independent::benchmark::{LEVELS, Scene};

/// The series of a scene, asked now of a script whose code the set-up of the tests installs.
pub fn ask(script: Script, scene: &PhysicalScene) -> Result<Vec<PhysicalAnswer>, Error> {
    (0..LEVELS).map(|level| live::independent(script, scene, level)).collect()
}

/// What a script in a process of its own prints.
#[derive(Deserialize)]
struct Apart {
    version: String,
    series: Vec<PhysicalAnswer>,
}

/// The same from a code in a process of its own; refused where it is not installed.
fn ask_apart(script: Script, scene: &PhysicalScene) -> Result<Apart, Error> {
    let folder = script.folder().path();
    let arguments = [folder.display().to_string(), script.module().into(), script.method().into(), LEVELS.to_string()];
    let request = serde_json::to_string(scene).map_err(|error| Error::at(script.name(), error.to_string(), PEERS))?;
    let wrong = |what: String| Error::file(&folder, what, PEERS);
    match run(ASK, &arguments, &request)? {
        Told::Absent(why) => Err(wrong(why)),
        Told::Lines(lines) => {
            let last = lines.into_iter().next_back().unwrap_or_default();
            serde_json::from_value(last).map_err(|error| wrong(error.to_string()))
        }
    }
}

/// What asks a code in a process of its own.
const ASK: &str = "ask.py";
/// What installs these codes.
const PEERS: &str = "run `bash oracles/peers/setup.sh`";
/// A relative change that is no news.
const ROUND_OFF: f64 = 1e-9;

/// Asks every script for every scene that it serves, and writes the frozen file once all have answered. Answers of a code in a process
/// of its own are kept where neither its script nor the scene has changed.
pub fn freeze() -> Result<Vec<String>, Error> {
    let (mut scenes, mut lines) = (BTreeMap::new(), Vec::new());
    let (old, scripts) = (Independent::load().ok(), hashes()?);
    let mut apart = BTreeMap::new();
    for scene in Scene::ALL {
        let (name, physical) = (scene.name(), scene.benchmark().physical);
        let known = old.as_ref().and_then(|old| old.scenes.get(name));
        let mut series = BTreeMap::new();
        for script in Script::ALL.into_iter().filter(|script| script.serves(&physical)) {
            let kept = known.and_then(|asked| asked.series.get(&script));
            let folder = script.folder();
            let unchanged = old.as_ref().filter(|old| old.scripts.get(&folder) == scripts.get(&folder));
            let version = unchanged.and_then(|old| old.apart.get(&folder));
            let same_scene = known.is_some_and(|asked| asked.scene == physical);
            let now = match (kept, version) {
                _ if folder.is_set_up() => ask(script, &physical)?,
                (Some(kept), Some(version)) if same_scene => {
                    apart.insert(folder, version.clone());
                    kept.clone()
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
            series.insert(script, now);
        }
        scenes.insert(name.to_string(), Asked { scene: physical, series });
    }
    Independent { scripts, versions: live::versions()?, apart, scenes }.write()?;
    Ok(lines)
}
