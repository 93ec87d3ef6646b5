//! Writing the front page, the pages behind it, charts and sheets, and comparing them with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::report::Page;
use crate::report::diff::{Difference, tree::Tree};
use crate::report::links::{CHARTS, PAGES};
use crate::study::sheet::SHEETS;

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";

/// A folder, the extension of what is in it, and the files that a page has there.
type Folder<'a> = (&'static str, &'static str, &'a [(String, String)]);

fn folders(page: &Page) -> [Folder<'_>; 3] {
    [(PAGES, "md", &page.pages), (CHARTS, "svg", &page.charts), (SHEETS, "md", &page.sheets)]
}

/// Everything that a page is made of: paths below the root, and texts.
fn files(page: &Page) -> Vec<(String, String)> {
    let mut all = vec![(PAGE.to_owned(), page.markdown.clone())];
    all.extend(page.record.iter().cloned());
    for (folder, _, files) in folders(page) {
        all.extend(files.iter().map(|(name, text)| (format!("{folder}/{name}"), text.clone())));
    }
    all
}

/// Committed files that the page no longer has.
fn stale(page: &Page, root: &Path) -> Vec<String> {
    let of_folder = |(folder, extension, files): Folder| {
        let entries = fs::read_dir(root.join(folder)).into_iter().flatten().flatten();
        let there = entries.map(|entry| PathBuf::from(entry.file_name()));
        let own = there.filter(|name| name.extension().is_some_and(|own| own == extension));
        let stale = own.filter(|name| !files.iter().any(|(file, _)| name.as_os_str() == file.as_str()));
        stale.map(|name| format!("{folder}/{}", name.display())).collect::<Vec<_>>()
    };
    folders(page).into_iter().flat_map(of_folder).collect()
}

/// Writes the front page, pages, charts and sheets under a root; those that the page no longer has are removed.
pub fn write(page: &Page, root: &Path) -> Result<(), Error> {
    for (folder, ..) in folders(page) {
        let folder = root.join(folder);
        fs::create_dir_all(&folder).map_err(|error| Error::unwritable(&folder, error))?;
    }
    for path in stale(page, root) {
        let path = root.join(path);
        fs::remove_file(&path).map_err(|error| Error::unwritable(&path, error))?;
    }
    write_all(&files(page), root)
}

/// Writes files below a root.
pub fn write_all(files: &[(String, String)], root: &Path) -> Result<(), Error> {
    files.iter().try_for_each(|(path, text)| {
        let path = root.join(path);
        fs::write(&path, text).map_err(|error| Error::unwritable(&path, error))
    })
}

/// What differs between what is committed under a root and the page, files that it no longer has included; none where nothing does.
pub fn difference(page: &Page, root: &Path) -> Result<Option<Difference>, Error> {
    let committed = Tree::on_disk(root)?;
    let written = committed.with("what the code writes now", files(page), &stale(page, root));
    Ok((committed.files != written.files).then(|| Difference::of(&committed, &written)))
}
