//! The scene files of a folder.

use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::error::nearest;

/// The file of a folder whose name is most like that of one that is not there; links that lead nowhere are none.
pub fn nearest_to(missing: &Path) -> Option<PathBuf> {
    let folder = missing.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let files = files_in(folder).ok()?;
    let files = files.iter().filter(|file| file.exists());
    let names: Vec<String> = files.filter_map(|file| Some(file.file_name()?.to_str()?.to_owned())).collect();
    let meant = nearest(missing.file_name()?.to_str()?, names.iter().map(String::as_str))?;
    Some(missing.with_file_name(meant))
}

/// All of them, in the order of their names; a folder without one is refused.
pub fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let remedy = "give a scene file, or a folder with some, *.toml";
    let failed = |error: std::io::Error| Error::unreadable(folder, error, remedy);
    let entries = std::fs::read_dir(folder).map_err(failed)?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>();
    let mut files = paths.map_err(failed)?;
    files.retain(|path| path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml")));
    files.sort();
    if files.is_empty() { Err(Error::file(folder, "no scene file is in it", remedy)) } else { Ok(files) }
}
