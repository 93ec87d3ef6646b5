//! The committed results at one commit, on disk, or as they would be written: texts by path.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::checkout;
use crate::error::Error;
use crate::report::grouped::joined;

/// What is compared: the page, and the folder of everything that is recorded.
pub const COMPARED: [&str; 2] = ["VALIDATION.md", "snapshots"];

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
