//! Writing the front page, the pages behind it, charts and sheets, and comparing them with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::report::Page;
use crate::report::links::PAGES;
use crate::study::sheets::SHEETS;

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";
/// The charts' folder.
pub const CHARTS: &str = "snapshots/charts";

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

/// What differs between the page and what is committed under a root: one line per file, with the first differing lines.
pub fn differences(page: &Page, root: &Path) -> Vec<String> {
    let mut differences: Vec<String> =
        files(page, root).iter().filter_map(|(path, text)| difference(path, text)).collect();
    let stale = folders(page, root).into_iter().flat_map(|folder| folder.stale());
    let told = |path: PathBuf| {
        format!("{}: the page no longer has this file", path.strip_prefix(root).unwrap_or(&path).display())
    };
    differences.extend(stale.map(told));
    differences
}

fn files<'a>(page: &'a Page, root: &Path) -> Vec<(PathBuf, &'a str)> {
    let mut all = vec![(root.join(PAGE), page.markdown.as_str())];
    for folder in folders(page, root) {
        all.extend(folder.files.iter().map(|(name, text)| (folder.path.join(name), text.as_str())));
    }
    all
}

fn difference(path: &Path, expected: &str) -> Option<String> {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let Ok(found) = fs::read_to_string(path) else { return Some(format!("{name}: missing")) };
    if found == expected {
        return None;
    }
    let mut lines = found.lines().zip(expected.lines()).enumerate().filter(|(_, (old, new))| old != new);
    let first = lines.next().map_or("  the lengths differ".to_string(), |(index, (old, new))| {
        format!("  line {}\n  - {}\n  + {}", index + 1, shortened(old), shortened(new))
    });
    Some(format!("{name}: stale\n{first}"))
}

fn shortened(line: &str) -> String {
    line.chars().take(240).collect()
}

fn unwritable(path: &Path, error: &std::io::Error) -> Error {
    Error::unwritable(path, error)
}
