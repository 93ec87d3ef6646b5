//! The committed results at one commit, on disk, or as they would be written: texts by path.
//!
//! Git is asked as a process: a library that reads its objects would be a hundred crates for three questions.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use rayon::prelude::*;

use crate::checkout;
use crate::error::Error;
use crate::study::grouped::joined;

/// What is compared: the page, and the folder of everything that is recorded.
const COMPARED: [&str; 2] = ["VALIDATION.md", "snapshots"];

/// Texts by path, with `/` between folders.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// What it is called.
    pub name: String,
    /// The texts.
    pub files: BTreeMap<String, String>,
}

impl Tree {
    /// What is on disk below the project folder.
    pub fn on_disk(root: &Path) -> Result<Self, Error> {
        let remedy = "restore it from git, or make it readable";
        let there: Vec<&str> = COMPARED.into_iter().filter(|name| root.join(name).exists()).collect();
        let paths = checkout::files(root, &there).map_err(|error| Error::unreadable(root, error, remedy))?;
        let read = |path: String| {
            let text =
                fs::read(root.join(&path)).map_err(|error| Error::unreadable(&root.join(&path), error, remedy))?;
            Ok((path, String::from_utf8_lossy(&text).into_owned()))
        };
        Ok(Self { name: "the working tree".into(), files: paths.into_iter().map(read).collect::<Result<_, Error>>()? })
    }

    /// The same with files as they would be written, and without those that would be removed.
    pub fn with(&self, name: &str, made: Vec<(String, String)>, removed: &[String]) -> Self {
        let mut files = self.files.clone();
        files.retain(|path, _| !removed.contains(path));
        files.extend(made);
        Self { name: name.into(), files }
    }

    /// A text by its path.
    pub fn text(&self, path: &str) -> Option<&str> {
        self.files.get(path).map(String::as_str)
    }
}

/// A file that differs: its path, and the text before and after.
pub type Moved<'a> = (&'a str, [Option<&'a str>; 2]);

/// The files that differ between two trees, in the order of their paths.
pub fn moved<'a>(trees: [&'a Tree; 2]) -> Vec<Moved<'a>> {
    let files = joined(trees.map(|tree| tree.files.iter().map(|(path, text)| (path.as_str(), text.as_str()))));
    files.into_iter().filter(|(_, [old, new])| old != new).collect()
}

/// Branches that the working branch may have left, the first that exists counts.
const TRUNKS: [&str; 2] = ["main", "origin/main"];

/// Where the working branch left `main`.
pub fn merge_base(root: &Path) -> Result<String, Error> {
    let known = |trunk: &&str| commit(root, trunk).is_ok();
    commit(root, "HEAD")?;
    let Some(trunk) = TRUNKS.into_iter().find(known) else {
        let message = format!("there is no branch {}", TRUNKS.join(" nor "));
        return Err(Error::at("git", message, "name the commit to compare with: `report diff BASE`"));
    };
    let remedy = "fetch the whole history (`git fetch --unshallow`), or name the commit: `report diff BASE`";
    let apart = |_| Error::at("git", format!("HEAD and `{trunk}` have no common commit here"), remedy);
    Ok(asked(root, &["merge-base", "HEAD", trunk]).map_err(apart)?.trim().into())
}

/// The full name of a commit.
pub fn commit(root: &Path, name: &str) -> Result<String, Error> {
    let full = asked(root, &["rev-parse", "--verify", "--quiet", "--end-of-options", &format!("{name}^{{commit}}")]);
    let unknown =
        || Error::at("git", format!("`{name}` is no commit here"), "name a commit, branch or tag, or fetch it first");
    let why = |error| if asked(root, &["rev-parse", "--git-dir"]).is_ok() { unknown() } else { error };
    full.map(|text| text.trim().into()).map_err(why)
}

/// What a commit holds of what is compared.
pub fn of_commit(root: &Path, name: &str) -> Result<Tree, Error> {
    let full = commit(root, name)?;
    let listed = asked(root, &[&["ls-tree", "-r", "-z", "--name-only", &full, "--"], &COMPARED[..]].concat())?;
    let paths: Vec<&str> = listed.split_terminator('\0').collect();
    let text = |path: &&str| -> Result<(String, String), Error> {
        Ok(((*path).into(), asked(root, &["cat-file", "blob", &format!("{full}:{path}")])?))
    };
    let files = paths.par_iter().map(text).collect::<Result<_, Error>>()?;
    let short = asked(root, &["rev-parse", "--short", &full])?;
    let short = short.trim();
    let name = if full.starts_with(name) { short.into() } else { format!("{name} ({short})") };
    Ok(Tree { name, files })
}

/// What git prints to a question.
fn asked(root: &Path, question: &[&str]) -> Result<String, Error> {
    let remedy = "install git: the results of other commits are read through it";
    let output = Command::new("git").arg("-C").arg(root).args(question).output();
    let output = output.map_err(|error| Error::at("git", format!("cannot be started: {error}"), remedy))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let message = if said.trim().is_empty() { "refused the question" } else { said.trim() };
    Err(Error::at("git", message, "run inside a git checkout of the project that has the commit"))
}
