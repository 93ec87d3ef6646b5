//! Writing the front page, the pages behind it, charts and sheets, and comparing them with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::report::diff::{Difference, tree::Tree};
use crate::report::links::{CHARTS, PAGES};
use crate::study::sheet::SHEETS;

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";

/// Folders that hold nothing but what a report is made of, and the extension of that.
const FOLDERS: [(&str, &str); 3] = [(PAGES, "md"), (CHARTS, "svg"), (SHEETS, "md")];

/// Committed files that a report no longer has.
fn stale(report: &[(String, String)], root: &Path) -> Vec<String> {
    let of_folder = |(folder, extension): (&str, &str)| {
        let entries = fs::read_dir(root.join(folder)).into_iter().flatten().flatten();
        let there = entries.map(|entry| PathBuf::from(entry.file_name()));
        let own = there.filter(|name| name.extension().is_some_and(|own| own == extension));
        let paths = own.map(|name| format!("{folder}/{}", name.display()));
        paths.filter(|path| !report.iter().any(|(made, _)| made == path)).collect::<Vec<_>>()
    };
    FOLDERS.into_iter().flat_map(of_folder).collect()
}

/// Writes a report, paths and texts, under a root; what its folders hold and it no longer has is removed.
pub fn write(report: &[(String, String)], root: &Path) -> Result<(), Error> {
    for (folder, _) in FOLDERS {
        let folder = root.join(folder);
        fs::create_dir_all(&folder).map_err(|error| Error::unwritable(&folder, error))?;
    }
    for path in stale(report, root) {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|error| Error::unwritable(&path, error))?;
    }
    write_all(report, root)
}

/// Writes files below a root.
pub fn write_all(files: &[(String, String)], root: &Path) -> Result<(), Error> {
    files.iter().try_for_each(|(path, text)| {
        let path = root.join(path);
        fs::write(&path, text).map_err(|error| Error::unwritable(&path, error))
    })
}

/// What differs between what is committed under a root and a report, files that it no longer has included; none where nothing does.
pub fn difference(report: &[(String, String)], root: &Path) -> Result<Option<Difference>, Error> {
    let committed = Tree::on_disk(root)?;
    let written = committed.with("what the code writes now", report.to_vec(), &stale(report, root));
    Ok((committed.files != written.files).then(|| Difference::of(&committed, &written)))
}
