//! Whether results can be written, asked before what takes long; and whether nothing is lost by it: no file that a
//! command writes takes the place of an input, of another output, or of what the command did not write.

use std::fs::{self, File, OpenOptions};
use std::path::{Path, PathBuf};
use std::{env, io};

use crate::checkout::{CHECKOUT as VARIABLE, chosen, is_checkout};
use crate::error::{Error, Kind};

/// What to do where the records of the checkout cannot be written.
pub const CHECKOUT: &str = "give the right to write to the checkout";

/// Refuses to begin what is written below the checkout, where there is none, or its folder cannot be written.
pub fn in_checkout(name: &str) -> Result<(), Error> {
    checkout().and_then(|root| folder(&root.join(name), CHECKOUT))
}

/// The checkout that is read and written: the one that the working directory lies in, or that is named in the
/// environment.
pub fn checkout() -> Result<PathBuf, Error> {
    let named = chosen();
    if let Some(root) = named.as_ref().filter(|root| is_checkout(root)) {
        return Ok(root.clone());
    }
    let message = match &named {
        Some(_) => format!("{VARIABLE} names this folder, which is no checkout of the project"),
        None => "neither this folder nor one above is a checkout of the project".into(),
    };
    let remedy = format!(
        "run inside a checkout, or name it by {VARIABLE} in the environment; all but the report and the surveys runs \
        anywhere, see `contact-vv help`"
    );
    Err(Error::file(&named.unwrap_or_else(|| env::current_dir().unwrap_or(".".into())), message, remedy))
}

/// Refuses a folder in which no file can be made; of one that is not there yet, the nearest above it that is.
pub fn folder(path: &Path, remedy: &str) -> Result<(), Error> {
    let present = path.ancestors().map(or_here).find(|above| above.exists()).unwrap_or(path);
    let probe = present.join(format!(".contact-vv-{}", std::process::id()));
    let made = File::create_new(&probe).and_then(|_| fs::remove_file(&probe));
    made.map_err(|error| refused(path, &error, remedy))
}

/// Refuses a file that cannot be written, or made.
pub fn file(path: &Path, remedy: &str) -> Result<(), Error> {
    if path.exists() {
        return OpenOptions::new().append(true).open(path).map(drop).map_err(|error| refused(path, &error, remedy));
    }
    match path.parent().map(or_here).filter(|above| !above.is_dir()) {
        Some(above) => Err(Error { kind: Kind::MissingFile, ..Error::file(above, missing(above), remedy) }),
        None => folder(path, remedy),
    }
}

/// What is wrong with a folder in which a file shall be made.
fn missing(folder: &Path) -> &'static str {
    if folder.exists() { "this is no folder, so that no file can be made in it" } else { "the folder is missing" }
}

/// The parent of a bare name is the folder that the program runs in.
fn or_here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

fn refused(path: &Path, error: &io::Error, remedy: &str) -> Error {
    Error::file(path, format!("cannot be written: {error}"), remedy)
}

/// What to do about a file that would be lost.
const FORCE: &str = "name another file, or add --force to replace it";

/// What stands for standard output in place of a file.
pub const STDOUT: &str = "-";

/// Tells whether bytes are an earlier output.
pub type IsEarlier<'a> = dyn Fn(&[u8]) -> bool + 'a;

/// A file that a command is to write.
pub struct Output<'a> {
    /// What asks for it.
    pub option: &'static str,
    /// Where.
    pub path: &'a Path,
    /// Whether what is there is an earlier output of this kind, which may be replaced.
    pub is_earlier: Box<IsEarlier<'a>>,
}

/// Refuses a drawing whose name would not tell its format.
pub fn refuse_plot(command: &str, plot: &Option<PathBuf>) -> Result<(), Error> {
    refuse_ending(command, "--plot", plot, ["svg", "plots are SVG", ""])
}

/// Refuses a file whose name does not end as its format does, and says which that is, and what more there is to say.
pub fn refuse_ending(
    command: &str,
    option: &str,
    path: &Option<PathBuf>,
    [ending, format, more]: [&str; 3],
) -> Result<(), Error> {
    match path.as_ref().filter(|path| path.extension().is_none_or(|end| end != ending)) {
        Some(path) => {
            Err(Error::value(command, option, path.display(), format, format!("end the file name in .{ending}{more}")))
        }
        None => Ok(()),
    }
}

/// Refuses outputs that cannot be written, that are a file which the command reads or another output, and, unless it is
/// forced, those in whose place there is something else than an earlier output of the same kind.
pub fn refuse<'a>(
    command: &str,
    outputs: impl IntoIterator<Item = Option<Output<'a>>>,
    inputs: &[PathBuf],
    force: bool,
) -> Result<(), Error> {
    let outputs: Vec<Output> = outputs.into_iter().flatten().collect();
    let refused = |output: &Output, message: &str, remedy: &str| {
        Err(Error::value(command, output.option, output.path.display(), message, remedy))
    };
    for (k, output) in outputs.iter().enumerate().filter(|(_, output)| holds_text(output.path)) {
        if let Some(input) = inputs.iter().find(|input| is_same(input, output.path)) {
            let message = format!("`{}` is read by this command: an output never replaces an input", input.display());
            return refused(output, &message, "name another file");
        }
        if let Some(other) = outputs[..k].iter().find(|other| is_same(other.path, output.path)) {
            let message = format!("`{}` is the same file: an output never replaces another", other.option);
            return refused(output, &message, "name another file for one of them");
        }
        file(output.path, "name a file in a folder that exists and may be written")?;
    }
    let lost: Vec<&Output> = outputs.iter().filter(|output| !force && !output.may_be_replaced()).collect();
    match lost[..] {
        [] => Ok(()),
        [output] => refused(output, "that file is there, and is not an earlier output as it was written", FORCE),
        _ => {
            let names: Vec<String> = lost.iter().map(|output| format!("`{}`", output.path.display())).collect();
            let message = format!("these files are there and hold something else: {}", names.join(", "));
            Err(Error::at(command, message, "name another place, or add --force to replace them all"))
        }
    }
}

impl<'a> Output<'a> {
    /// The file that an option asks for; none without it, or where it goes to standard output.
    pub fn of(option: &'static str, path: &'a Option<PathBuf>, is_earlier: fn(&str) -> bool) -> Option<Self> {
        let path = path.as_deref().filter(|path| path.as_os_str() != STDOUT)?;
        let is_earlier = Box::new(move |there: &[u8]| std::str::from_utf8(there).is_ok_and(is_earlier));
        Some(Self { option, path, is_earlier })
    }

    /// Whether nothing is lost: no file is there, an empty one, or an earlier output.
    fn may_be_replaced(&self) -> bool {
        if !self.path.exists() || !holds_text(self.path) {
            return true;
        }
        fs::read(self.path).is_ok_and(|bytes| bytes.is_empty() || (self.is_earlier)(&bytes))
    }
}

/// Whether a path is that of a file, there or not: a device or a pipe holds nothing that could be lost.
fn holds_text(path: &Path) -> bool {
    fs::metadata(path).map_or(true, |found| found.is_file() || found.is_dir())
}

/// Whether two paths lead to one file.
fn is_same(a: &Path, b: &Path) -> bool {
    resolved(a) == resolved(b) || is_linked(a, b)
}

/// The path without links; of a file that is not there yet, that of its folder, and of a link to one where it leads.
fn resolved(path: &Path) -> PathBuf {
    if let Ok(found) = fs::canonicalize(path) {
        return found;
    }
    let path = fs::read_link(path).map_or(path.to_path_buf(), |to| path.parent().unwrap_or(path).join(to));
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = fs::canonicalize(folder).unwrap_or(folder.to_path_buf());
    path.file_name().map_or(folder.clone(), |name| folder.join(name))
}

/// Whether two names are of one file on the disk.
#[cfg(unix)]
fn is_linked(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let number = |path| fs::metadata(path).map(|found| (found.dev(), found.ino()));
    number(a).is_ok_and(|own| number(b).is_ok_and(|other| own == other))
}

/// Whether two names are of one file on the disk, where that cannot be asked.
#[cfg(not(unix))]
fn is_linked(_: &Path, _: &Path) -> bool {
    false
}
