//! A script in a process of its own: those under `oracles/peers`, for codes that no test needs, and today's dolfinx.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;

use serde_json::Value;

use crate::checkout::root;
use crate::error::Error;

/// The interpreter the codes are installed for.
const PYTHON: &str = "/usr/bin/python3";
/// What the scripts end with where their code is not installed.
const MISSING: i32 = 3;

/// The objects that a script printed, one a line; why there are none where its code is not installed.
pub type Told = Result<Vec<Value>, String>;

/// Runs a script under `oracles/peers`.
pub fn run(script: &str, arguments: &[String], request: &str) -> Result<Told, Error> {
    let python = Path::new(PYTHON);
    if !python.is_file() {
        return Ok(Err(format!("{PYTHON} is missing")));
    }
    run_by(python, &root().join("oracles/peers").join(script), arguments, request)
}

/// Runs a script by an interpreter that is there.
pub fn run_by(python: &Path, script: &Path, arguments: &[String], request: &str) -> Result<Told, Error> {
    let failed = |reason: String| Error::file(script, reason, "run it by hand, or leave this code uninstalled");
    let started = Command::new(python)
        .arg("-EsB")
        .arg(script)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut child = started.map_err(|error| failed(format!("{} does not start: {error}", python.display())))?;
    let input = child.stdin.take();
    // Written beside what is read: a script that answers line by line would wait for its answers to be read. One that
    // has ended already says why itself.
    let output = thread::scope(|scope| {
        scope.spawn(move || input.is_some_and(|mut input| input.write_all(request.as_bytes()).is_ok()));
        child.wait_with_output()
    });
    let output = output.map_err(|error| failed(error.to_string()))?;
    let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    if output.status.code() == Some(MISSING) {
        return Ok(Err(said));
    }
    if !output.status.success() {
        return Err(failed(said.lines().last().unwrap_or("it failed without a word").to_owned()));
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines = text.lines().map(serde_json::from_str).collect::<Result<Vec<Value>, _>>();
    lines.map(Ok).map_err(|error| failed(error.to_string()))
}
