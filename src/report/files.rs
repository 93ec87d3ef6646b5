//! Writing the page and its charts, and comparing them with what is committed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::report::Page;

/// The page's file.
pub const PAGE: &str = "VALIDATION.md";
/// The charts' folder.
pub const CHARTS: &str = "snapshots/charts";

/// Writes the page and its charts under a root; charts that the page no longer has are removed.
pub fn write(page: &Page, root: &Path) -> Result<(), Error> {
    let charts = root.join(CHARTS);
    fs::create_dir_all(&charts).map_err(|error| unwritable(&charts, &error))?;
    for stale in committed_charts(&charts).into_iter().filter(|name| !page.charts.iter().any(|(n, _)| n == name)) {
        let path = charts.join(stale);
        fs::remove_file(&path).map_err(|error| unwritable(&path, &error))?;
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
    let stale =
        committed_charts(&root.join(CHARTS)).into_iter().filter(|name| !page.charts.iter().any(|(n, _)| n == name));
    differences.extend(stale.map(|name| format!("{CHARTS}/{name}: the page no longer has this chart")));
    differences
}

fn files<'a>(page: &'a Page, root: &Path) -> Vec<(PathBuf, &'a str)> {
    let charts = page.charts.iter().map(|(name, svg)| (root.join(CHARTS).join(name), svg.as_str()));
    std::iter::once((root.join(PAGE), page.markdown.as_str())).chain(charts).collect()
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

fn committed_charts(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    names.filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "svg")).collect()
}

fn unwritable(path: &Path, error: &std::io::Error) -> Error {
    Error::unwritable(path, error)
}
