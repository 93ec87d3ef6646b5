//! The checkout that the program was built in, and what tells whether a file of it has changed.

use std::env;
use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};

/// Names the project's folder to a program that has been moved away from where it was built.
pub const CHECKOUT: &str = "CONTACT_VV_CHECKOUT";

/// The project's folder: what [`CHECKOUT`] names in the environment, else where the program was built.
pub fn root() -> PathBuf {
    env::var_os(CHECKOUT)
        .filter(|named| !named.is_empty())
        .map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from)
}

/// SHA-256 in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// SHA-256 of files and of all files below folders, as `tests/digest.py` has it: of the lines `hash  path` of each, in the
/// order of the paths, which begin below `root`.
///
/// Hidden files do not count, nor what Python and cargo leave behind: every checkout of a commit has the same digest.
pub fn digest<S: AsRef<str>>(root: &Path, names: &[S]) -> Result<String> {
    let mut lines = String::new();
    for file in files(root, names)? {
        lines += &format!("{}  {file}\n", sha256(&fs::read(root.join(&file))?));
    }
    Ok(sha256(lines.as_bytes()))
}

/// Paths of files and of all files below folders, sorted, without hidden ones and those that Python and cargo leave behind.
pub fn files<S: AsRef<str>>(root: &Path, names: &[S]) -> Result<Vec<String>> {
    let mut files = Vec::new();
    for name in names {
        collect(root, name.as_ref(), &mut files)?;
    }
    files.sort();
    files.dedup();
    Ok(files)
}

/// Paths of the files at or below a path, with `/` between folders on every machine.
fn collect(root: &Path, path: &str, files: &mut Vec<String>) -> Result<()> {
    if !fs::metadata(root.join(path))?.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    for entry in fs::read_dir(root.join(path))? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if !(name.starts_with('.') || LEFT_BEHIND.contains(&name.as_str())) {
            collect(root, &format!("{path}/{name}"), files)?;
        }
    }
    Ok(())
}

/// Folders that hold no sources.
const LEFT_BEHIND: [&str; 2] = ["__pycache__", "target"];
