//! A script under `oracles/peers` in a process of its own, for codes that no test needs.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::checkout::root;
use crate::error::Error;

/// The interpreter the codes are installed for.
const PYTHON: &str = "/usr/bin/python3";
/// What the scripts end with where their code is not installed.
const MISSING: i32 = 3;
/// What a script printed; nothing where its code is not installed, with the reason.
pub enum Told {
    /// The objects, one a line.
    Lines(Vec<Value>),
    /// Why there are none.
    Absent(String),
}

/// Runs a script under `oracles/peers`.
pub fn run(script: &str, arguments: &[String], request: &str) -> Result<Told, Error> {
    let path = root().join("oracles/peers").join(script);
    let failed = |reason: String| Error::file(&path, reason, "run it by hand, or leave this code uninstalled");
    let started = Command::new(PYTHON)
        .arg("-EsB")
        .arg(&path)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let Ok(mut child) = started else { return Ok(Told::Absent(format!("{PYTHON} is missing"))) };
    if let Some(mut input) = child.stdin.take() {
        // A script that has ended already says why itself.
        let _ = input.write_all(request.as_bytes());
    }
    let output = child.wait_with_output().map_err(|error| failed(error.to_string()))?;
    let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    if output.status.code() == Some(MISSING) {
        return Ok(Told::Absent(said));
    }
    if !output.status.success() {
        return Err(failed(said.lines().last().unwrap_or("it failed without a word").to_owned()));
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines = text.lines().map(serde_json::from_str).collect::<Result<Vec<Value>, _>>();
    lines.map(Told::Lines).map_err(|error| failed(error.to_string()))
}
