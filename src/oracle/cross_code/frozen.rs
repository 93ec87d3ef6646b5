//! What a live run of the other codes left: values, mesh sizes, versions and the hash of the scripts.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::checkout::{root, sha256};
use crate::error::Error;
use crate::oracle::cross_code::{Code, DiscreteAnswer, PhysicalScene, scripts};

/// What renews the frozen results.
pub const REFREEZE: &str = "freeze them again by `cargo run --release -p contact-vv-live`, and review the diff";

/// Results of one code.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Frozen {
    /// SHA-256 of the Python files, one after the other in the order of their names.
    pub scripts: String,
    /// Versions by name.
    pub versions: BTreeMap<String, String>,
    /// The same discrete problems, by name.
    pub discrete: BTreeMap<String, Digest>,
}

/// What the scripts of a folder answered, each by its key, of our scenes by name.
#[derive(Clone, Debug, Deserialize)]
#[serde(bound = "K: Ord + Deserialize<'de>, A: Deserialize<'de>")]
pub struct Answered<K, A> {
    /// SHA-256 of the scripts.
    pub scripts: String,
    /// The scenes.
    pub scenes: BTreeMap<String, Asked<K, A>>,
}

/// A scene, and what every script answers.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(bound(deserialize = "K: Ord + Deserialize<'de>, A: Deserialize<'de>"))]
pub struct Asked<K, A> {
    /// The scene as it was given.
    pub scene: PhysicalScene,
    /// The answers.
    pub answers: BTreeMap<K, A>,
}

/// A discrete answer small enough to be kept: its products with the ten fixed vectors, and all contact pressures.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Digest {
    /// Nodes of the mesh.
    pub nodes: usize,
    /// `v_iᵀ K v_j` [N mm].
    pub forms: Vec<Vec<f64>>,
    /// `v_i · f` [N mm].
    pub work: Vec<f64>,
    /// Contact pressures for each κ \[MPa\].
    pub pressure: Vec<Vec<f64>>,
    /// `v_i · u` for each κ \[mm²\].
    pub moved: Vec<Vec<f64>>,
}

impl Digest {
    /// The digest of an answer; `unknowns` are the fixed vectors in the numbering of its products and load, `vectors`
    /// the same node by node.
    pub fn of(answer: &DiscreteAnswer, unknowns: &[Vec<f64>], vectors: &[Vec<f64>]) -> Self {
        let with_all = |list: &[Vec<f64>], other: &[f64]| list.iter().map(|v| dot(v, other)).collect::<Vec<_>>();
        Self {
            nodes: vectors.first().map_or(0, |v| v.len() / 2),
            forms: answer.products.iter().map(|product| with_all(unknowns, product)).collect(),
            work: with_all(unknowns, &answer.load),
            pressure: answer.pressure.clone(),
            moved: answer.displacement.iter().map(|u| with_all(vectors, u)).collect(),
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl Digest {
    /// All numbers in groups of one unit and scale.
    pub fn numbers(&self) -> Vec<(String, Vec<f64>)> {
        let group = |name: &str, list: &[Vec<f64>]| (name.to_owned(), list.concat());
        let mut groups = vec![group("v K v", &self.forms), ("v f".to_owned(), self.work.clone())];
        groups.extend(self.pressure.iter().map(|p| ("p".to_owned(), p.clone())));
        groups.extend(self.moved.iter().map(|m| ("v u".to_owned(), m.clone())));
        groups
    }
}

impl Frozen {
    /// The frozen results of a code; refused where the scripts have changed since.
    pub fn read(code: Code) -> Result<Self, Error> {
        Self::load(code)?.of_scripts(code, &script_hash()?)
    }

    /// Refuses results of scripts with another hash.
    pub fn of_scripts(self, code: Code, present: &str) -> Result<Self, Error> {
        if self.scripts == present {
            return Ok(self);
        }
        let found = format!("`{}`, but oracles/python now hashes to `{present}`", self.scripts);
        Err(Error::refused(&file(code), "scripts", found, REFREEZE))
    }

    /// The same, whatever the scripts are now.
    pub fn load(code: Code) -> Result<Self, Error> {
        read_json(&file(code), REFREEZE)
    }

    /// The same from a text; the file is only named.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        parsed(file, text, REFREEZE)
    }

    /// All numbers in groups of one unit and scale, by name.
    pub fn numbers(&self) -> BTreeMap<String, Vec<f64>> {
        let mut all = BTreeMap::new();
        for (name, digest) in &self.discrete {
            for (index, (quantity, values)) in digest.numbers().into_iter().enumerate() {
                all.insert(format!("{name}, {quantity} (group {})", index + 1), values);
            }
        }
        all
    }

    /// Writes the results of a code.
    pub fn write(&self, code: Code) -> Result<(), Error> {
        write_json(&file(code), self)
    }
}

/// The versions that differ from those of a live run, as `numpy 1.24.2, now 1.26.0`.
pub fn changed_versions(frozen: &BTreeMap<String, String>, now: &BTreeMap<String, String>) -> String {
    let changed = frozen.iter().filter(|(name, version)| now.get(*name) != Some(version));
    let told = changed
        .map(|(name, version)| format!("{name} {version}, now {}", now.get(name).map_or("absent", String::as_str)));
    let told: Vec<String> = told.collect();
    if told.is_empty() { "no version changed".into() } else { told.join("; ") }
}

/// The frozen file of a code.
pub fn file(code: Code) -> PathBuf {
    named(code.name())
}

/// A frozen file.
pub fn named(name: &str) -> PathBuf {
    root().join("oracles/frozen").join(format!("{name}.json"))
}

/// SHA-256 of all Python files of the oracles with their names, in the order of these.
pub fn script_hash() -> Result<String, Error> {
    hash_of(&scripts())
}

/// What a record holds; `renew` says what renews it.
pub fn read_json<T: DeserializeOwned>(file: &Path, renew: &str) -> Result<T, Error> {
    let text = fs::read_to_string(file).map_err(|_| Error::missing_file(file, renew))?;
    parsed(file, &text, renew)
}

/// The same from a text, such as that of the file when the program was built, for which no checkout is needed.
pub fn parsed<T: DeserializeOwned>(file: &Path, text: &str, renew: &str) -> Result<T, Error> {
    serde_json::from_str(text).map_err(|error| Error::unreadable(file, error, renew))
}

/// Writes a file, and its folder where there is none.
pub fn write_json(file: &Path, content: &impl Serialize) -> Result<(), Error> {
    let text = serde_json::to_string_pretty(content).map_err(|error| Error::unwritable(file, error))?;
    fs::create_dir_all(file.parent().unwrap_or(file)).map_err(|error| Error::unwritable(file, error))?;
    fs::write(file, text + "\n").map_err(|error| Error::unwritable(file, error))
}

/// The same of one folder.
pub fn hash_of(folder: &Path) -> Result<String, Error> {
    let unreadable = |file: &Path, error| Error::unreadable(file, error, "restore the folder `oracles`");
    let entries = fs::read_dir(folder).map_err(|error| unreadable(folder, error))?;
    let entries: Vec<fs::DirEntry> = entries.collect::<Result<_, _>>().map_err(|error| unreadable(folder, error))?;
    let mut files: Vec<PathBuf> = entries.iter().map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "py"));
    files.sort();
    let mut all = Vec::new();
    for file in files {
        let text = fs::read(&file).map_err(|error| unreadable(&file, error))?;
        let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        all.extend(format!("{name}\0{}\0", text.len()).bytes());
        all.extend(text);
    }
    Ok(sha256(&all))
}
