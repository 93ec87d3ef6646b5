//! The live run: every case is exported, and every code is asked for it by each of its settings.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use flate2::{Compression, write::GzEncoder};
use serde_json::Value;

use crate::case::Case;
use crate::checkout::root;
use crate::condensation::Plain;
use crate::error::Error;
use crate::referee::Truth;
use crate::referee::export::{deck, problem};
use crate::solve::Discretisation;
use crate::study::scoreboard::board::{self, Asked, Ended, Told};
use crate::study::scoreboard::run::scored;
use crate::study::scoreboard::setting::Setting;

/// The interpreter that the codes are installed for.
const PYTHON: &str = "/usr/bin/python3";
/// What the scripts end with where their code is not installed.
const MISSING: i32 = 3;
/// Times that the sparse Cholesky solve is measured, of which the shortest counts.
const REPEATS: usize = 5;
/// Endings of files that are kept compressed.
const LARGE: [&str; 2] = ["frd", "vtu"];

/// A case by every setting; the answers are written beside the record. The second list names what is not installed.
pub fn ask(name: &str, case: &Case, told: impl Fn(&Setting)) -> Result<(Asked, Vec<String>), Error> {
    refuse_other_scripts()?;
    let discretisation = case.meshed()?.discretisation;
    let truth = Truth::of(case.clone())?;
    let place = root().join("target/scoreboard").join(name);
    fs::create_dir_all(&place).map_err(|error| Error::unwritable(&place, error))?;
    let files =
        [("problem.json", problem::text(&case.name, &discretisation)?), ("case.inp", deck::text(&discretisation)?)];
    for (file, text) in files {
        let file = place.join(file);
        fs::write(&file, text).map_err(|error| Error::unwritable(&file, error))?;
    }
    let (mut runs, mut absent) = (Vec::new(), Vec::new());
    for setting in Setting::ALL {
        told(&setting);
        let cholesky = cholesky(&discretisation)?;
        let (seconds, answer) = match run(&setting, &place) {
            Ok(ran) => ran,
            Err(why) => {
                absent.push(why);
                continue;
            }
        };
        let (version, ended) = match answer {
            Ok(value) => {
                let version = value["version"].as_str().map(str::to_owned);
                (version, kept(name, &truth, &discretisation, &place, &value)?)
            }
            Err(why) => (None, Ended::Failed(why)),
        };
        let Setting { code, method, .. } = setting;
        runs.push(Told { code, method: method.into(), version, seconds, cholesky, ended });
    }
    Ok((Asked { dofs: discretisation.system.dofs(), runs }, absent))
}

/// Refuses scripts that are not those this program was built with, whose digests it writes.
fn refuse_other_scripts() -> Result<(), Error> {
    for (name, text, _) in problem::SCRIPTS {
        let file = root().join("oracles/peers").join(name);
        if fs::read_to_string(&file).ok().as_deref() != Some(text) {
            return Err(Error::file(
                &file,
                "it has changed since this program was built",
                "build it again: `cargo build --release`",
            ));
        }
    }
    Ok(())
}

/// Seconds of one sparse Cholesky solve of all bodies, the shortest of some.
fn cholesky(discretisation: &Discretisation) -> Result<f64, Error> {
    let systems = discretisation.system.bodies.iter().map(Plain::of).collect::<Result<Vec<Plain>, Error>>()?;
    let once = |_| {
        let clock = Instant::now();
        systems.iter().try_for_each(|system| system.solve().map(|found| drop(std::hint::black_box(found))))?;
        Ok(clock.elapsed().as_secs_f64())
    };
    let all = (0..REPEATS).map(once).collect::<Result<Vec<f64>, Error>>()?;
    Ok(all.into_iter().fold(f64::INFINITY, f64::min))
}

/// Seconds of a script, and what it told or why it failed; refused with the reason where its code is not installed.
fn run(setting: &Setting, place: &Path) -> Result<(f64, Result<Value, String>), String> {
    let script = root().join("oracles/peers").join(setting.code.script());
    let clock = Instant::now();
    let started = Command::new(PYTHON).arg("-EsB").arg(&script).arg(place).arg(setting.method).output();
    let output = started.map_err(|_| format!("{PYTHON} is missing"))?;
    let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    let last = said.lines().last().unwrap_or("it failed without a word").to_owned();
    if output.status.code() == Some(MISSING) {
        return Err(last);
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let value = text.lines().last().and_then(|line| serde_json::from_str::<Value>(line).ok());
    Ok(match value.filter(|_| output.status.success()) {
        Some(value) => (value["seconds"].as_f64().unwrap_or(f64::NAN), Ok(value)),
        None => (clock.elapsed().as_secs_f64(), Err(last)),
    })
}

/// Keeps the file that a code wrote beside the record, and judges it.
fn kept(
    name: &str,
    truth: &Truth,
    discretisation: &Discretisation,
    place: &Path,
    value: &Value,
) -> Result<Ended, Error> {
    let file = value["file"].as_str().unwrap_or_default();
    let written = place.join(file);
    let mut bytes = fs::read(&written).map_err(|error| Error::unreadable(&written, error, "run the script by hand"))?;
    let mut named = format!("{name}-{file}");
    if LARGE.iter().any(|ending| file.ends_with(ending)) {
        named += ".gz";
        let mut compressed = GzEncoder::new(Vec::new(), Compression::best());
        bytes = compressed
            .write_all(&bytes)
            .and_then(|()| compressed.finish())
            .map_err(|error| Error::unwritable(&written, error))?;
    }
    let kept = board::folder().join(&named);
    let scored = scored(truth, discretisation, &kept, &bytes);
    let found = scored.map_or([f64::NAN; 2], |scored| scored.scores.map(|score| score.value));
    if found.iter().any(|value| !value.is_finite()) {
        return Ok(Ended::Failed(format!("what it wrote holds no profile that can be judged: {file}")));
    }
    fs::write(&kept, bytes).map_err(|error| Error::unwritable(&kept, error))?;
    let iterations = value["iterations"].as_u64().unwrap_or(0) as usize;
    Ok(Ended::Answered { file: named, iterations, found })
}
