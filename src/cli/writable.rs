//! Whether results can be written, asked before what takes long.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::Path;

use crate::checkout::{CHECKOUT as VARIABLE, root};
use crate::error::{Error, Kind};

/// What to do where the records of the checkout cannot be written.
pub const CHECKOUT: &str = "give the right to write to the checkout that the program was built in";

/// Refuses to begin what is written below the checkout, where that is no longer there, or its folder cannot be written.
pub fn in_checkout(name: &str) -> Result<(), Error> {
    checkout().and_then(|()| folder(&root().join(name), CHECKOUT))
}

/// Refuses to begin what reads the checkout, where that is no longer there.
pub fn checkout() -> Result<(), Error> {
    if root().join("snapshots/checks.csv").is_file() {
        return Ok(());
    }
    let message = "the checkout this program was built in is no longer there";
    let remedy = format!("build it again where the checkout is now, or name that by {VARIABLE} in the environment");
    Err(Error::file(&root(), message, remedy))
}

/// Refuses a folder in which no file can be made; of one that is not there yet, the nearest above it that is.
pub fn folder(path: &Path, remedy: &str) -> Result<(), Error> {
    let present = path.ancestors().map(or_here).find(|above| above.exists()).unwrap_or(path);
    let probe = present.join(format!(".contact-vv-{}", std::process::id()));
    let made = File::create_new(&probe).and_then(|_| fs::remove_file(&probe));
    made.map_err(|error| refused(path, &error, remedy))
}

/// Refuses a file that cannot be written, or made.
pub fn file(path: &Path, remedy: &str) -> Result<(), Error> {
    if path.exists() {
        return OpenOptions::new().append(true).open(path).map(drop).map_err(|error| refused(path, &error, remedy));
    }
    match path.parent().map(or_here).filter(|above| !above.is_dir()) {
        Some(above) => Err(Error { kind: Kind::MissingFile, ..Error::file(above, missing(above), remedy) }),
        None => folder(path, remedy),
    }
}

/// What is wrong with a folder in which a file shall be made.
fn missing(folder: &Path) -> &'static str {
    if folder.exists() { "this is no folder, so that no file can be made in it" } else { "the folder is missing" }
}

/// The parent of a bare name is the folder that the program runs in.
fn or_here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

fn refused(path: &Path, error: &io::Error, remedy: &str) -> Error {
    Error::file(path, format!("cannot be written: {error}"), remedy)
}
