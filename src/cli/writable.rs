//! Whether results can be written, asked before what takes long.

use std::env;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use crate::checkout::{CHECKOUT as VARIABLE, chosen, is_checkout};
use crate::error::{Error, Kind};

/// What to do where the records of the checkout cannot be written.
pub const CHECKOUT: &str = "give the right to write to the checkout";

/// Refuses to begin what is written below the checkout, where there is none, or its folder cannot be written.
pub fn in_checkout(name: &str) -> Result<(), Error> {
    checkout().and_then(|root| folder(&root.join(name), CHECKOUT))
}

/// The checkout that is read and written: the one that the working directory lies in, or that is named in the environment.
pub fn checkout() -> Result<PathBuf, Error> {
    let named = chosen();
    if let Some(root) = named.as_ref().filter(|root| is_checkout(root)) {
        return Ok(root.clone());
    }
    let message = match &named {
        Some(_) => format!("{VARIABLE} names this folder, which is no checkout of the project"),
        None => "neither this folder nor one above is a checkout of the project".into(),
    };
    let remedy = format!(
        "run inside a checkout, or name it by {VARIABLE} in the environment; all but the report and the surveys runs anywhere, see `contact-vv help`"
    );
    Err(Error::file(&named.unwrap_or_else(|| env::current_dir().unwrap_or(".".into())), message, remedy))
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
