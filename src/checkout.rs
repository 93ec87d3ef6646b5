//! The checkout that is read and written, and what tells whether a file of it has changed.

use std::env;
use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};

/// Names the checkout to a program that does not run inside it.
pub const CHECKOUT: &str = "CONTACT_VV_CHECKOUT";

/// The checkout that is read: the one that commands write to, else where the program was built.
pub fn root() -> PathBuf {
    chosen().unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into())
}

/// The checkout that commands write to, wherever the program was built: what [`CHECKOUT`] names in the environment,
/// else the one that the working directory lies in; none outside of any.
pub fn chosen() -> Option<PathBuf> {
    if let Some(named) = env::var_os(CHECKOUT).filter(|named| !named.is_empty()) {
        return Some(named.into());
    }
    let here = env::current_dir().ok()?;
    here.ancestors().find(|folder| is_checkout(folder)).map(Path::to_path_buf)
}

/// Whether a folder is a checkout of the project.
pub fn is_checkout(folder: &Path) -> bool {
    ["Cargo.toml", "snapshots/checks.csv"].iter().all(|file| folder.join(file).is_file())
}

/// SHA-256 in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Digits of a digest that are kept: what changes by chance to the same 64 bits need not be told apart.
const KEPT: usize = 16;

/// The first digits of the SHA-256 of files, of all files below folders and of functions, as `tests/digest.py` has it:
/// of the lines `hash  name` of each, in the order of the names, which begin below `root`. `path: line` is the text of
/// the functions of a file that begin with this line.
///
/// Hidden files do not count, nor what Python and cargo leave behind: every checkout of a commit has the same digest.
/// Nor do lines of Rust that are comments: what is said of a formula changes nothing that was found with it.
pub fn digest<S: AsRef<str>>(root: &Path, names: &[S]) -> Result<String> {
    let mut lines = String::new();
    for name in files(root, names)? {
        let content = match name.split_once(": ") {
            Some((file, head)) => functions(&String::from_utf8_lossy(&counted(root, file)?), head).into_bytes(),
            None => counted(root, &name)?,
        };
        lines += &format!("{}  {name}\n", sha256(&content));
    }
    Ok(sha256(lines.as_bytes())[..KEPT].into())
}

/// What counts of a file: all of it, of Rust the lines that are no comments.
fn counted(root: &Path, file: &str) -> Result<Vec<u8>> {
    let whole = fs::read(root.join(file))?;
    if !file.ends_with(".rs") {
        return Ok(whole);
    }
    let lines = whole.split(|byte| *byte == b'\n').filter(|line| !line.trim_ascii_start().starts_with(b"//"));
    Ok(lines.collect::<Vec<_>>().join(&b'\n'))
}

/// The functions that begin with a line, each up to the brace that closes it.
fn functions(text: &str, head: &str) -> String {
    let lines: Vec<&str> = text.split('\n').collect();
    let begins = (0..lines.len()).filter(|&at| lines[at].trim() == head);
    let of = |at: usize| {
        let closing = format!("{}}}", &lines[at][..lines[at].len() - lines[at].trim_start().len()]);
        let length = lines[at..].iter().position(|line| **line == closing).unwrap_or(0);
        &lines[at..=at + length]
    };
    begins.flat_map(of).copied().collect::<Vec<_>>().join("\n")
}

/// Paths of files and of all files below folders, sorted, without hidden ones and those that Python and cargo leave
/// behind.
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
    if path.contains(": ") || !fs::metadata(root.join(path))?.is_dir() {
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
