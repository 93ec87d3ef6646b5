//! Today's dolfinx, in a process of its own: `oracles/setup.sh` installs it where it finds a Python from 3.12 on, which
//! Debian 12 has not.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use contact_vv::checkout::root;
use contact_vv::error::Error;
use contact_vv::oracle::cross_code::independent::Script;
use contact_vv::oracle::cross_code::process::run_by;
use contact_vv::oracle::cross_code::{DiscreteAnswer, PhysicalAnswer, PhysicalScene, SET_UP, scripts};
use contact_vv::study::cross_code::Twin;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::interpreter::INSTALLED;

/// What a script answers, or what it raises.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Told<T> {
    /// Its answers.
    Answers(T),
    /// What it raised.
    Raised(String),
}

/// Versions by name.
type Versions = BTreeMap<String, String>;

/// Its interpreter, where it is installed.
pub fn python() -> Option<PathBuf> {
    let newest = root().join(INSTALLED).join("newest");
    newest.join("version").is_file().then(|| newest.join("bin/python"))
}

/// What it answers to our discrete problems, in their order, with the versions that do.
pub fn discrete(python: &Path, twins: &[Twin]) -> Result<(Versions, Vec<DiscreteAnswer>), Error> {
    asked(python, twins.iter().map(|twin| json!(twin.problem)).collect())
}

/// What a script of its folder answers to a scene on its coarsest meshes, with the versions that do.
pub fn series(
    python: &Path,
    script: Script,
    scene: &PhysicalScene,
    levels: usize,
) -> Result<(Versions, Vec<PhysicalAnswer>), Error> {
    let (folder, module, method) = (script.folder().path(), script.module(), script.method());
    let request = json!({"folder": folder, "module": module, "method": method, "levels": levels, "scene": scene});
    let (versions, series) = asked::<Vec<PhysicalAnswer>>(python, vec![request])?;
    Ok((versions, series.concat()))
}

/// The versions, and an answer to each request.
fn asked<T: DeserializeOwned>(python: &Path, requests: Vec<Value>) -> Result<(Versions, Vec<T>), Error> {
    let script = scripts().join("apart.py");
    let wrong = |what: String| Error::file(&script, what, SET_UP);
    let request: String = requests.iter().map(|request| format!("{request}\n")).collect();
    let told = run_by(python, &script, &[root().join(INSTALLED).display().to_string()], &request)?;
    let mut lines = told.map_err(|said| wrong(format!("{} ends: {said}", python.display())))?;
    if lines.len() != 1 + requests.len() {
        return Err(wrong(format!("it prints {} lines after {} requests", lines.len(), requests.len())));
    }
    let told = lines.split_off(1).into_iter().map(|line| match serde_json::from_value(line) {
        Ok(Told::Answers(answer)) => Ok(answer),
        Ok(Told::Raised(said)) => Err(wrong(said)),
        Err(error) => Err(wrong(error.to_string())),
    });
    let answers = told.collect::<Result<_, _>>()?;
    Ok((serde_json::from_value(lines.remove(0)).map_err(|error| wrong(error.to_string()))?, answers))
}
