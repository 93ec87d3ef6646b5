//! Recorded surveys: sites that are run one by one, and the lines that each leaves in a CSV file.

use std::fmt;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::checkout::{root, sha256};
use crate::error::Error;
use crate::study::grouped::sorted;

/// A recorded survey: what is run, and what is kept of it.
pub struct Survey<S, R> {
    /// Name of its command, and of its record under `snapshots`.
    pub name: &'static str,
    /// Columns of its record.
    pub head: fn() -> Vec<String>,
    /// All sites, in the order of the record.
    pub sites: fn() -> Result<Vec<S>, Error>,
    /// Name of a site of its own.
    pub key: fn(&S) -> String,
    /// Name of the site that a line of the record is of.
    pub of: fn(&R) -> String,
    /// Runs a site.
    pub run: fn(&S) -> Result<Vec<R>, Error>,
}

impl<S: Sync + Send, R: Serialize + DeserializeOwned + Clone + Sync + Send> Survey<S, R> {
    /// Its record.
    pub fn file(&self) -> PathBuf {
        file(self.name)
    }

    /// What it has recorded.
    pub fn read(&self) -> Result<Vec<R>, Error> {
        let name = self.name;
        let renew = format!("run `cargo run --release -- {name}` and review the diff of snapshots/{name}.csv");
        read(&self.file(), &(self.head)(), &renew)
    }

    /// The sentence that says how a record is renewed, and what is done that it stays so.
    pub fn told(&self, recorded: &[R]) -> String {
        let (name, all) = (self.name, recorded.len());
        format!(
            "`cargo run --release -- {name}` renews the record of {all} lines; the tests run a chosen part of it again."
        )
    }

    /// Puts the lines of the record into the folder of unfinished sites, which are then not run.
    pub fn keep(&self, unfinished: &Path) -> Result<(), Error> {
        let of_site = sorted(self.read()?.into_iter().map(|line| ((self.of)(&line), line)));
        let head = (self.head)();
        of_site.iter().try_for_each(|(site, lines)| write(&unfinished.join(format!("{site}.csv")), &head, lines))
    }

    /// Runs every site, whose lines are kept under its name in the folder `unfinished` until all are written to
    /// `record`; `done` is told when one more is ready.
    pub fn renew(&self, unfinished: &Path, record: &Path, done: impl Fn() + Sync) -> Result<usize, Error> {
        survey([unfinished, record], &(self.head)(), &(self.sites)()?, self.key, self.run, done)
    }
}

/// Runs every site of a survey whose record has such columns; see [`Survey::renew`].
pub fn survey<S: Sync, R: Serialize + DeserializeOwned + Clone + Send>(
    [unfinished, record]: [&Path; 2],
    head: &[String],
    sites: &[S],
    key: fn(&S) -> String,
    run: fn(&S) -> Result<Vec<R>, Error>,
    done: impl Fn() + Sync,
) -> Result<usize, Error> {
    let of_site = |site: &S| -> Result<Vec<R>, Error> {
        let kept = unfinished.join(key(site) + ".csv");
        let found = read(&kept, head, "").or_else(|_| {
            let found = run(site)?;
            write(&kept, head, &found)?;
            Ok(found)
        });
        done();
        found
    };
    let found = sites.par_iter().map(of_site).collect::<Result<Vec<_>, Error>>()?.concat();
    write(record, head, &found)?;
    Ok(found.len())
}

/// The lines of a file, whatever they are; `renew` says what renews them. Refused where its columns are others.
pub fn read<T: DeserializeOwned>(path: &Path, head: &[String], renew: &str) -> Result<Vec<T>, Error> {
    let text = std::fs::read_to_string(path).map_err(|_| Error::missing_file(path, renew))?;
    let unreadable = |error: csv::Error| Error::unreadable(path, error, renew);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let columns = reader.headers().map_err(unreadable)?;
    if columns.iter().ne(head) {
        return Err(Error::unreadable(path, format!("its columns are not {}", head.join(", ")), renew));
    }
    let line = |line: csv::Result<csv::StringRecord>| line?.deserialize(None);
    reader.records().map(line).collect::<csv::Result<_>>().map_err(unreadable)
}

/// Writes lines to a file below the names of their columns.
pub fn write<T: Serialize>(path: &Path, head: &[String], lines: &[T]) -> Result<(), Error> {
    let unwritable = |error: csv::Error| Error::unwritable(path, error);
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(head).map_err(unwritable)?;
    lines.iter().try_for_each(|line| writer.serialize(line)).map_err(unwritable)?;
    let text = writer.into_inner().map_err(|error| Error::unwritable(path, error))?;
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| Error::unwritable(path, error))?;
    }
    // Whoever is broken off leaves the old file or the new one, never half of it.
    let fresh = path.with_extension("csv.new");
    std::fs::write(&fresh, text)
        .and_then(|()| std::fs::rename(&fresh, path))
        .map_err(|error| Error::unwritable(path, error))
}

/// The record of a name.
pub fn file(name: &str) -> PathBuf {
    root().join("snapshots").join(name).with_extension("csv")
}

/// Names of columns.
pub fn named<const N: usize>(names: [&str; N]) -> Vec<String> {
    names.map(String::from).into()
}

/// Four significant digits: what a reviewer reads.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(f64::NAN)
}

/// A relative number as records keep it: in millionths, to three significant digits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Millionths(pub f64);

/// A number that is recomputed may differ from what three digits are kept of by this share.
const DIGITS: f64 = 6e-3;

impl Millionths {
    /// Whether two are the same but for the digits that are not kept, and for what is round-off; what is unknown is
    /// like itself.
    pub fn is_like(self, other: Self, round_off: f64) -> bool {
        let (Self(a), Self(b)) = (self, other);
        let is_same = a.total_cmp(&b).is_eq() || (a.is_nan() && b.is_nan());
        is_same || (a - b).abs() <= DIGITS * a.abs().max(b.abs()).min(f64::MAX) + round_off
    }
}

/// Whether the numbers of two records are alike, one by one; what is absent is like itself.
pub fn are_like(kept: &[Option<Millionths>], fresh: &[Option<Millionths>], round_off: f64) -> bool {
    let alike = |both: (&Option<Millionths>, &Option<Millionths>)| match both {
        (Some(kept), Some(fresh)) => kept.is_like(*fresh, round_off),
        (kept, fresh) => kept.is_none() && fresh.is_none(),
    };
    kept.len() == fresh.len() && kept.iter().zip(fresh).all(alike)
}

impl fmt::Display for Millionths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = format!("{:.2e}", 1e6 * self.0).parse::<f64>().unwrap_or(f64::NAN);
        let [plain, short] = [digits.to_string(), format!("{digits:e}")];
        f.write_str(if plain.len() > short.len() { &short } else { &plain })
    }
}

impl From<Millionths> for String {
    fn from(number: Millionths) -> Self {
        number.to_string()
    }
}

impl TryFrom<String> for Millionths {
    type Error = std::num::ParseFloatError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse::<f64>().map(|number| Self(1e-6 * number))
    }
}

/// Folder of the running program's unfinished survey of a name: another program starts afresh.
pub fn unfinished(name: &str) -> Result<PathBuf, Error> {
    let unreadable = |error: std::io::Error| {
        Error::at("the running program", error.to_string(), "run it from a file that may be read")
    };
    let program = std::env::current_exe().and_then(std::fs::read).map_err(unreadable)?;
    Ok(root().join("target").join(name).join(&sha256(&program)[..16]))
}
