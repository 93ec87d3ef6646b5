//! Asking the scripts now, and renewing the frozen file.

use crate::error::Error;
use crate::oracle::cross_code::independent::{Asked, Independent, Script, hashes};
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene, live};
use crate::study::cross_code::benchmark::{LEVELS, Scene};
use crate::study::cross_code::differences::largest_change;

/// The series of a scene, asked now.
pub fn ask(script: Script, scene: &PhysicalScene) -> Result<Vec<PhysicalAnswer>, Error> {
    (0..LEVELS).map(|level| live::independent(script, scene, level)).collect()
}

/// A relative change that is no news.
const ROUND_OFF: f64 = 1e-9;

/// Asks every script for every scene that it serves, and writes the frozen file once all have answered.
pub fn freeze() -> Result<Vec<String>, Error> {
    let (mut scenes, mut lines) = (std::collections::BTreeMap::new(), Vec::new());
    let old = Independent::load().ok();
    for scene in Scene::ALL {
        let (name, physical) = (scene.name(), scene.benchmark().physical);
        let mut series = std::collections::BTreeMap::new();
        for script in Script::ALL.into_iter().filter(|script| script.serves(&physical)) {
            let now = ask(script, &physical)?;
            let kept = old.as_ref().and_then(|old| old.scenes.get(name)).and_then(|asked| asked.series.get(&script));
            let change = kept.map_or(f64::NAN, |kept| largest_change(&Asked::numbers(&now), &Asked::numbers(kept)));
            // NaN where nothing was kept.
            let same = change <= ROUND_OFF;
            lines.extend((!same).then(|| format!("{script}, {name}: changed by {change:.1e}")));
            series.insert(script, now);
        }
        scenes.insert(name.to_string(), Asked { scene: physical, series });
    }
    Independent { scripts: hashes()?, versions: live::versions()?, scenes }.write()?;
    Ok(lines)
}
