//! Writing the front page, the pages behind it, charts and sheets, and comparing them with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::report::Page;
use crate::report::diff::{Difference, tree::Tree};
use crate::report::links::{CHARTS, PAGES};
use crate::study::references::SHEETS;

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";

/// A folder of files that the page has.
struct Folder<'a> {
    path: PathBuf,
    extension: &'static str,
    files: &'a [(String, String)],
}

fn folders<'a>(page: &'a Page, root: &Path) -> [Folder<'a>; 3] {
    [
        Folder { path: root.join(PAGES), extension: "md", files: &page.pages },
        Folder { path: root.join(CHARTS), extension: "svg", files: &page.charts },
        Folder { path: root.join(SHEETS), extension: "md", files: &page.sheets },
    ]
}

impl Folder<'_> {
    /// Committed files that the page no longer has.
    fn stale(&self) -> Vec<PathBuf> {
        let Ok(entries) = fs::read_dir(&self.path) else { return Vec::new() };
        let paths = entries.flatten().map(|entry| entry.path());
        let own = paths.filter(|path| path.extension().is_some_and(|extension| extension == self.extension));
        own.filter(|path| !self.files.iter().any(|(name, _)| path.ends_with(name))).collect()
    }
}

/// Writes the front page, pages, charts and sheets under a root; those that the page no longer has are removed.
pub fn write(page: &Page, root: &Path) -> Result<(), Error> {
    for folder in folders(page, root) {
        fs::create_dir_all(&folder.path).map_err(|error| unwritable(&folder.path, &error))?;
        for path in folder.stale() {
            fs::remove_file(&path).map_err(|error| unwritable(&path, &error))?;
        }
    }
    for (path, text) in files(page, root) {
        fs::write(&path, text).map_err(|error| unwritable(&path, &error))?;
    }
    Ok(())
}

/// Writes files below a root.
pub fn write_all(files: &[(String, String)], root: &Path) -> Result<(), Error> {
    files.iter().try_for_each(|(path, text)| {
        let path = root.join(path);
        fs::write(&path, text).map_err(|error| unwritable(&path, &error))
    })
}

/// What differs between what is committed under a root and the page, files that it no longer has included; none where nothing does.
pub fn difference(page: &Page, root: &Path) -> Result<Option<Difference>, Error> {
    let below = |path: &Path| path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
    let made = files(page, root).into_iter().map(|(path, text)| (below(&path), text.to_owned())).collect();
    let stale: Vec<String> = folders(page, root).iter().flat_map(Folder::stale).map(|path| below(&path)).collect();
    let committed = Tree::on_disk(root)?;
    let written = committed.with("what the code writes now", made, &stale);
    Ok((committed.files != written.files).then(|| Difference::of(&committed, &written)))
}

fn files<'a>(page: &'a Page, root: &Path) -> Vec<(PathBuf, &'a str)> {
    let mut all = vec![(root.join(PAGE), page.markdown.as_str())];
    all.extend(page.record.iter().map(|(path, text)| (root.join(path), text.as_str())));
    for folder in folders(page, root) {
        all.extend(folder.files.iter().map(|(name, text)| (folder.path.join(name), text.as_str())));
    }
    all
}

fn unwritable(path: &Path, error: &std::io::Error) -> Error {
    Error::unwritable(path, error)
}
