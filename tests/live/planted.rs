//! Faults of the contact part of the independent scripts, planted one at a time and answered anew: each turns a check
//! red.
//!
//! That is recorded script by script in snapshots/oracles.json, bound to the script and to what judges it, and asked
//! again where one of these has changed: two minutes of a processor. `INSTA_UPDATE=always` writes the record.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::Mutex;

use contact_vv::case::Verdict;
use contact_vv::checkout::{digest, root};
use contact_vv::oracle::cross_code::independent::{Asked, Independent, Script};
use contact_vv::oracle::cross_code::{PhysicalAnswer, PhysicalScene, scripts};
use contact_vv::study::Study;
use contact_vv::study::differences::largest_change;
use contact_vv::study::faults::Entry;
use contact_vv::study::independent::run::{Compared, Found, LEVELS, Scene, compare};
use contact_vv_live::interpreter::INSTALLED;
use contact_vv_live::newest::{self, Told};
use libtest_mimic::{Completion, Trial};
use serde::Deserialize;
use serde_json::{Value, json};

/// Largest relative difference of a sound script's copy from what is frozen, as the live answers may have it.
const REPRODUCED: f64 = 1e-6;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Fault {
    name: String,
    script: Script,
    scene: String,
    file: String,
    was: String,
    is: String,
}

#[derive(Deserialize)]
struct Faults {
    fault: Vec<Fault>,
}

/// A trial for each script, all its faults one after the other.
pub fn trials() -> Vec<Trial> {
    let list = root().join("tests/faults/oracles.toml");
    let Faults { fault } = toml::from_str(&fs::read_to_string(list).expect("readable")).expect("a list of faults");
    let mut of: BTreeMap<Script, Vec<Fault>> = BTreeMap::new();
    fault.into_iter().for_each(|one| of.entry(one.script).or_default().push(one));
    let trial = |(script, faults): (Script, Vec<Fault>)| {
        Trial::ignorable_test(format!("every fault planted in the contact of {script} turns a check red"), move || {
            if is_recorded(script) {
                return Ok(Completion::Completed);
            }
            let python = if script.is_set_up() { Some("/usr/bin/python3".into()) } else { newest::python() };
            let Some(python) = python else { return Ok(Completion::ignored_with("there is no dolfinx of today")) };
            all_are_caught(&mut Python::start(&python), &faults);
            if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
                record(script);
            }
            Ok(Completion::Completed)
        })
    };
    of.into_iter().map(trial).collect()
}

/// Trials read and write it at the same time.
static RECORDED: Mutex<()> = Mutex::new(());

/// Where it is written that all faults of a script turned a check red.
fn recorded() -> PathBuf {
    root().join("snapshots/oracles.json")
}

/// The script's folder, what plants its faults, and what they are held against and judged by.
fn bound(script: Script) -> Vec<String> {
    let folder = script.folder().path();
    let own = folder.strip_prefix(root()).expect("in the checkout").display().to_string();
    let others = [
        "oracles/python/apart.py",
        "oracles/frozen/independent.json",
        "src/case/check.rs",
        "src/case/judged.rs",
        "src/oracle/cross_code",
        "src/study/differences.rs",
        "src/study/independent",
        "tests/faults/oracles.toml",
        "tests/live/planted.rs",
    ];
    others.map(str::to_owned).into_iter().chain([own]).collect()
}

/// Whether all its faults were seen red on what they are bound to now.
fn is_recorded(script: Script) -> bool {
    let _reading = RECORDED.lock();
    let Ok(text) = fs::read_to_string(recorded()) else { return false };
    let record: BTreeMap<Script, Entry> = serde_json::from_str(&text).expect("a record");
    record.get(&script).is_some_and(|entry| entry.bound == bound(script) && entry.is_current())
}

/// Writes that they were.
fn record(script: Script) {
    let _writing = RECORDED.lock();
    let text = fs::read_to_string(recorded()).unwrap_or_else(|_| "{}".into());
    let mut record: BTreeMap<Script, Value> = serde_json::from_str(&text).expect("a record");
    let bound = bound(script);
    let sources = digest(&root(), &bound).expect("files of the checkout");
    record.insert(script, json!({"bound": bound, "sources": sources}));
    fs::write(recorded(), serde_json::to_string_pretty(&record).expect("a record") + "\n").expect("written");
}

fn all_are_caught(python: &mut Python, faults: &[Fault]) {
    let frozen = Independent::read().expect("frozen answers");
    let mut sound: BTreeMap<&str, Compared> = BTreeMap::new();
    for Fault { name, script, scene, file, was, is } in faults {
        let asked = &frozen.scenes[scene];
        let compared = sound.entry(scene).or_insert_with(|| {
            // Without a fault a copy answers what was frozen: the coarser meshes tell, the finest takes nine tenths of
            // the time.
            let answers = python
                .asked(copy(*script).path(), *script, &asked.scene, LEVELS - 1)
                .expect("an answer without a fault");
            let kept = &asked.answers[script][..LEVELS - 1];
            let change = largest_change(&Asked::numbers(&answers), &Asked::numbers(kept));
            assert!(change <= REPRODUCED, "{script}, {scene}: a copy answers otherwise by {change:e}");
            let known = Scene::ALL.into_iter().find(|known| known.name() == scene).expect("a scene of the benchmark");
            let compared = compare(&known.benchmark(), None).expect("compared");
            assert!(all_pass(&compared), "{script}, {scene}: what was frozen is not green");
            compared
        });
        let copy = copy(*script);
        let path = copy.path().join(file);
        let text = fs::read_to_string(&path).expect("a file of the script");
        assert_eq!(text.matches(was.as_str()).count(), 1, "{name}: `{was}` in {file}");
        fs::write(&path, text.replace(was.as_str(), is)).expect("written");
        match python.asked(copy.path(), *script, &asked.scene, LEVELS) {
            Ok(series) => assert!(!all_pass(&with(compared, *script, &series)), "NOT CAUGHT: {name}"),
            // What raises is no answer, and the trial breaks off: but for its own words, nothing but a mistake of the
            // list.
            Err(said) => assert!(said.starts_with("RuntimeError"), "{name}: {said}"),
        }
    }
}

/// A copy of the files of a script.
fn copy(script: Script) -> tempfile::TempDir {
    let copy = tempfile::tempdir().expect("a folder");
    let files = fs::read_dir(script.folder().path()).expect("a folder").map(|entry| entry.expect("readable").path());
    for file in files.filter(|file: &PathBuf| file.extension().is_some_and(|extension| extension == "py")) {
        fs::copy(&file, copy.path().join(file.file_name().expect("named"))).expect("copied");
    }
    copy
}

/// Whether there is a check, and all pass.
fn all_pass(compared: &Compared) -> bool {
    let checks = compared.judge().expect("judged");
    !checks.is_empty() && checks.iter().all(|check| check.verdict == Verdict::Pass)
}

/// The same with the refinement series of a script replaced.
fn with(compared: &Compared, script: Script, series: &[PhysicalAnswer]) -> Compared {
    let mut other = compared.clone();
    for one in other.others.iter_mut().filter(|one| one.script == script) {
        one.found = Found::of(script.title(), series).expect("three meshes");
    }
    other
}

/// A process that imports what it is told to, and answers a line for each line.
struct Python {
    process: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Python {
    fn start(python: &Path) -> Self {
        let mut process = Command::new(python)
            .arg("-EsB")
            .arg(scripts().join("apart.py"))
            .arg(root().join(INSTALLED))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Python is there");
        let requests = process.stdin.take().expect("piped");
        let mut answers = BufReader::new(process.stdout.take().expect("piped"));
        answers.read_line(&mut String::new()).expect("its versions");
        Self { process, requests, answers }
    }

    /// The answers of a folder's modules to a scene on so many meshes; what Python said where it raises.
    fn asked(
        &mut self,
        folder: &Path,
        script: Script,
        scene: &PhysicalScene,
        levels: usize,
    ) -> Result<Vec<PhysicalAnswer>, String> {
        let (module, method) = (script.module(), script.method());
        let asked = json!({"folder": folder, "module": module, "method": method, "scene": scene, "levels": levels});
        writeln!(self.requests, "{asked}").expect("it reads on");
        let mut line = String::new();
        self.answers.read_line(&mut line).expect("it answers");
        let told = serde_json::from_str(&line);
        match told.unwrap_or_else(|error| panic!("`bash oracles/setup.sh` installs what answers: {error}: {line}")) {
            Told::Answers(series) => Ok(series),
            Told::Raised(said) => Err(said),
        }
    }
}

impl Drop for Python {
    fn drop(&mut self) {
        // It ends of itself when nothing more is asked; after a failed assertion nobody waits for an answer.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
