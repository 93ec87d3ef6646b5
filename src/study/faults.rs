//! Fault injection: what turned red when a fault was put into a copy of the tree; and whether what a script has
//! recorded is of the present sources: each entry is bound to what it tests, and to nothing else; what caught a fault
//! must still be asked.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::case::judged::EVERY_RUN;
use crate::case::{Check, Judged, Quantity, Reference, Verdict};
use crate::checkout::{digest, root};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::oracle::cross_code::frozen::read_json;
use crate::study::about::{About, Found, Planned, Study};

/// The faults to plant.
const LIST: &str = "tests/faults/faults.toml";
/// Claims that hold a number against a truth, by kind.
const LIST_OF_TRUTHS: &str = "tests/truths.toml";

/// A fault as the list has it: in `file`, the only `was` becomes `is`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Planted {
    /// What is planted.
    pub name: String,
    /// Where.
    pub file: String,
    /// The sound code.
    pub was: String,
    /// The fault.
    pub is: String,
    /// The kind of node around it that is there twice, sound and with the fault; without, the body of its function.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<String>,
}

/// One planted fault and what it did.
#[derive(Clone, Debug, Deserialize)]
pub struct Fault {
    /// What was planted.
    #[serde(flatten)]
    pub planted: Planted,
    /// On what, and what it turned red: a test of each kind that was found.
    #[serde(flatten)]
    pub entry: Entry,
}

/// A test that a fault turned red.
#[derive(Clone, Debug, Deserialize)]
pub struct Caught {
    /// A claim, or a trial of the suite.
    pub test: String,
    /// Kind of the reference that it holds the code against.
    pub kind: String,
    /// What it asks.
    pub told: String,
    /// The check of a trial; none of a claim, and of what broke off.
    #[serde(flatten)]
    pub asked: Option<Asked>,
}

/// The record of checks, of which whose and what is asked; it is that of the last report.
const ASKED: &str = "snapshots/checks.csv";

/// Whose and what a check asks.
#[derive(Clone, Debug, Deserialize)]
pub struct Asked {
    /// Name of the case.
    pub case: String,
    /// Name of the quantity.
    pub quantity: String,
}

impl Caught {
    /// Whether a claim of this name is among the claims, of this kind by the list of truths; of a trial, whether a
    /// check of its case, or of every run, asks for its quantity. Of what shows nothing, such as what broke off,
    /// nothing is asked.
    pub fn is_there(&self) -> bool {
        if !TELLING.contains(&self.kind.as_str()) {
            return true;
        }
        let read = |file: &str| fs::read_to_string(root().join(file)).unwrap_or_default();
        if let Some(Asked { case, quantity }) = &self.asked {
            let is_it = |one: Asked| (one.case == EVERY_RUN || one.case == *case) && one.quantity == *quantity;
            return csv::Reader::from_reader(read(ASKED).as_bytes()).deserialize().any(|row| row.is_ok_and(is_it));
        }
        self.test.split_once("::").is_some_and(|(module, name)| {
            let truths = toml::from_str::<BTreeMap<String, Vec<String>>>(&read(LIST_OF_TRUTHS)).unwrap_or_default();
            let kind = truths.iter().find(|(_, claims)| claims.contains(&self.test)).map_or("claim", |(kind, _)| kind);
            kind == self.kind && read(&format!("tests/claims/{module}.rs")).contains(&format!("\nfn {name}("))
        })
    }
}

/// Every planted fault with what it did, in the order of the list.
pub type Numbers = Record<Fault>;

impl Study for Numbers {
    const NAME: &'static str = "faults";
    const ABOUT: About = About {
        title: "Fault injection",
        asked: "Which checks turn red when something is broken on purpose.",
        limits: "Faults that somebody thought of, one at a time.",
    };

    fn plan() -> Vec<Planned<Self>> {
        vec![Planned::new("planted faults", "the record", record)]
    }

    /// The checks: what no truth sees, and whether this and the other records are of the present sources.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let missed = self.record.iter().filter(|fault| !is_caught(fault)).count();
        let what = "planted fault that turns no closed form, no other code and no claim red";
        let caught = Check::none(what, "snapshots alone verify nothing").asked_of(self.record.len());
        let caught = caught.judge(missed as f64);
        std::iter::once(Ok(caught)).chain(MADE.iter().map(|made| Ok(made.judge(&made.read()?.record)))).collect()
    }

    /// A row for each fault: what turned red.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let columns: [Column<&Fault>; 7] = [
            ("planted fault", |fault| fault.planted.name.clone()),
            ("in", |fault| format!("`{}`", fault.planted.file)),
            ("sources", |fault| fault.entry.shown()),
            ("closed form", |fault| test(fault, &["analytic", "measured"])),
            ("other code", |fault| test(fault, &["cross-code"])),
            ("the code against itself", |fault| test(fault, &["self-consistency", "claim"])),
            ("other", |fault| test(fault, &["broken off", "snapshot"])),
        ];
        let faults: Vec<&Fault> = findings.iter().flat_map(|found| &found.numbers.record).collect();
        let seen = TRUTHS.map(|(kind, told)| (faults.iter().filter(|fault| is_seen_by(fault, &[kind])).count(), told));
        let seen =
            seen.iter().filter(|(count, _)| *count > 0).map(|(count, told)| format!("{count} are seen by {told}"));
        let rooms = rooms()?;
        let missed: Vec<_> = rooms.iter().flat_map(|room| &room.missed).collect();
        let untried = rooms.iter().filter(|room| room.by_claims.of == 0);
        let untried: Vec<String> = untried.map(|room| format!("`{}`", room.room)).collect();
        Ok(format!(
            include_str!("faults.md"),
            seen = seen.collect::<Vec<_>>().join(", "),
            all = faults.len(),
            faults = markdown::columns(&columns, &faults),
            rooms = markdown::columns(&ROOMS, &rooms),
            caught = together(&rooms, "src", |room| &room.by_claims),
            truths_alone = by_truths_alone(&rooms),
            of_solver = together(&rooms, SOLVER, |room| &room.by_claims),
            of_solver_by_truths = together(&rooms, SOLVER, |room| &room.by_truths),
            untried = if untried.is_empty() { "no folder".into() } else { untried.join(", ") },
            unviable = rooms.iter().map(|room| room.unviable).sum::<usize>(),
            missed = markdown::columns(&MISSED, missed),
            fuzzed = markdown::columns(&FUZZED, &fuzzed()?)
        ))
    }
}

/// The table of mutants.
const ROOMS: [Column<Room>; 6] = [
    ("folder", |room| format!("`{}`", room.room)),
    ("mutants", |room| room.mutants.to_string()),
    ("equivalent", |room| room.equivalent.to_string()),
    ("caught by any test", |room| room.by_claims.shown()),
    ("by truths alone", |room| room.by_truths.shown()),
    ("sources", |room| sources(&room.tried)),
];

/// The table of mutants that no test caught.
const MISSED: [Column<[String; 2]>; 2] =
    [("in", |[file, _]| format!("`{file}`")), ("what no test noticed", |[_, change]| format!("`{change}`"))];

/// The table of fuzz targets.
const FUZZED: [Column<Fuzzed>; 5] = [
    ("fuzz target", |one| format!("`{}`", one.target)),
    ("executions", |one| one.executions.to_string()),
    ("edges of code reached", |one| one.edges_covered.to_string()),
    ("inputs that broke it", |one| one.broke.to_string()),
    ("sources", |one| one.entry.shown()),
];

/// The recorded faults; refused where one of them is no longer the one that the list has.
pub fn record() -> Result<Numbers, Error> {
    let [list, record] = [LIST, FAULTS.file].map(|name| root().join(name));
    let read = |file: &PathBuf| fs::read_to_string(file).map_err(|_| Error::missing_file(file, FAULTS.renew));
    parse((&list, &read(&list)?), (&record, &read(&record)?))
}

/// The same from the texts of both files.
pub fn parse((list, listed): (&Path, &str), (file, text): (&Path, &str)) -> Result<Numbers, Error> {
    let planted: BTreeMap<String, Vec<Planted>> =
        toml::from_str(listed).map_err(|error| Error::unreadable(list, error, "restore it"))?;
    let planted = planted.get("fault").map_or(&[][..], Vec::as_slice);
    let numbers: Numbers = serde_json::from_str(text).map_err(|error| Error::unreadable(file, error, FAULTS.renew))?;
    let faults = &numbers.record;
    let refused = |key: &str, found: String| Err(Error::refused(file, key, found, FAULTS.renew));
    if faults.len() != planted.len() || faults.is_empty() {
        return refused("record", format!("{} faults long, but {} are listed", faults.len(), planted.len()));
    }
    let mut pairs = faults.iter().zip(planted);
    if let Some((fault, listed)) = pairs.find(|(fault, listed)| fault.planted != **listed) {
        return refused("record", format!("of `{}`, but the list has another `{}`", fault.planted.name, listed.name));
    }
    Ok(numbers)
}

/// Kinds of references that are not the code's own, and how they are told.
const TRUTHS: [(&str, &str); 3] =
    [("analytic", "a closed form"), ("cross-code", "another code"), ("measured", "a measurement")];
/// Kinds of what says more than that something has changed, or broken off.
const TELLING: [&str; 5] = ["analytic", "cross-code", "measured", "self-consistency", "claim"];
/// Characters of a test that are shown.
const SHOWN: usize = 160;

/// Whether a truth or a claim turned red; a run that broke off, or a snapshot, shows none.
pub fn is_caught(fault: &Fault) -> bool {
    is_seen_by(fault, &TELLING)
}

fn is_seen_by(fault: &Fault, kinds: &[&str]) -> bool {
    fault.entry.by.iter().any(|one| kinds.contains(&one.kind.as_str()))
}

/// A test of some kinds that turned red.
fn test(fault: &Fault, kinds: &[&str]) -> String {
    let found = fault.entry.by.iter().find(|one| kinds.contains(&one.kind.as_str()));
    let told = |one: &Caught| [one.test.as_str(), one.told.as_str()].join(": ").trim_end_matches(": ").to_owned();
    found.map_or("–".into(), |one| told(one).chars().take(SHOWN).collect())
}

/// A record that a script makes and that carries digests of its sources.
#[derive(Clone, Copy, Debug)]
pub struct Made {
    /// What an entry is, as a trial is named.
    pub entry: &'static str,
    /// The record.
    pub file: &'static str,
    /// What renews it.
    pub renew: &'static str,
}

/// The record of planted faults.
pub const FAULTS: Made =
    Made { entry: "planted fault", file: "snapshots/faults.json", renew: "run `python3 tests/faults/plant.py --old`" };

/// All of them.
pub const MADE: [Made; 3] = [
    FAULTS,
    Made { entry: "fuzz target", file: "snapshots/fuzz.json", renew: "run `python3 tests/fuzz/run.py --old`" },
    Made { entry: "mutant", file: "snapshots/mutants.json", renew: "run `python3 tests/mutants/room.py --old`" },
];

/// A record: entries with what is told of each.
#[derive(Clone, Debug, Deserialize)]
pub struct Record<T> {
    /// Entries.
    pub record: Vec<T>,
}

/// What all entries have in common.
#[derive(Clone, Debug, Deserialize)]
pub struct Entry {
    /// Files, folders and functions that what it says depends on: of a fault its file and those of the claims that
    /// caught it, of a fuzz target the reader that it calls, of a mutant its function.
    #[serde(default)]
    pub bound: Vec<String>,
    /// Their digest when it was made; none where that was not recorded.
    pub sources: Option<String>,
    /// Day of the commit that it was made on.
    pub date: Option<String>,
    /// Of a fault, what caught it.
    #[serde(default)]
    pub by: Vec<Caught>,
}

impl Entry {
    /// Whether what it is bound to is as it was, and what caught it is still there.
    pub fn is_current(&self) -> bool {
        let is_bound = !self.bound.is_empty() && self.sources.is_some();
        is_bound && digest(&root(), &self.bound).ok() == self.sources && self.by.iter().all(Caught::is_there)
    }

    /// What a table shows of that.
    pub fn shown(&self) -> String {
        let sign = if self.is_current() { "✓" } else { "○" };
        format!("{sign} {}", self.date.as_deref().unwrap_or("earlier"))
    }
}

/// What tests catch of the mutants of a folder (`tests/mutants/room.py`).
#[derive(Clone, Debug, Deserialize)]
pub struct Room {
    /// The folder.
    pub room: String,
    /// All of its mutants.
    pub mutants: usize,
    /// What is recorded of those that were tried.
    #[serde(skip)]
    pub tried: Vec<Entry>,
    /// Those that the compiler refused.
    pub unviable: usize,
    /// Those that no test can catch.
    pub equivalent: usize,
    /// Those that were tried, by chance, by anything.
    pub by_claims: Share,
    /// Those of them that were tried by closed forms and other codes alone.
    pub by_truths: Share,
    /// Those that no test caught: file and change.
    pub missed: Vec<[String; 2]>,
}

/// How many of some mutants were caught.
#[derive(Clone, Debug, Deserialize)]
pub struct Share {
    /// Those that turned something red.
    pub caught: usize,
    /// All that count.
    pub of: usize,
    /// The interval of 95 % of their share (Wilson); none where none was tried.
    pub interval: Option<[f64; 2]>,
}

impl Share {
    /// How many of how many, and the interval of their share.
    pub fn shown(&self) -> String {
        let Self { caught, of, interval } = self;
        let share = |[low, high]: [f64; 2]| format!("{caught} of {of}: {:.0} to {:.0} %", 100.0 * low, 100.0 * high);
        interval.map_or("–".into(), share)
    }
}

/// Folder of what computes, beside what reads and tells.
const SOLVER: &str = "src/solver";

/// What is caught of all mutants of a folder: the shares of its rooms, each by the number of its mutants, those of
/// which none was tried left out.
///
/// The interval of `Σ w p` reaches `√Σ w²(p − l)²` below it, and above it likewise (Zou & Donner 2008).
pub fn together(rooms: &[Room], folder: &str, of: fn(&Room) -> &Share) -> String {
    let within = || rooms.iter().filter(|room| Path::new(&room.room).starts_with(folder));
    let tried: Vec<(f64, &Share, [f64; 2])> = within()
        .filter_map(|room| of(room).interval.map(|interval| (room.mutants as f64, of(room), interval)))
        .collect();
    let mutants: f64 = tried.iter().map(|(mutants, ..)| mutants).sum();
    let [mut share, mut below, mut above] = [0.0; 3];
    let [mut caught, mut all] = [0; 2];
    for (own, counts, [low, high]) in &tried {
        let (weight, part) = (own / mutants, counts.caught as f64 / counts.of as f64);
        share += weight * part;
        below += (weight * (part - low)).powi(2);
        above += (weight * (high - part)).powi(2);
        (caught, all) = (caught + counts.caught, all + counts.of);
    }
    let [share, low, high] = [share, share - below.sqrt(), share + above.sqrt()].map(|part| 100.0 * part);
    let untried = within().filter(|room| of(room).interval.is_none()).count();
    let but =
        if untried == 0 { String::new() } else { format!("; {untried} of {} folders not tried", within().count()) };
    format!("{share:.0} % ({low:.0} to {high:.0} %; {caught} of {all} tried{but})")
}

/// The record of mutants: the scores of rooms, and entries.
#[derive(Deserialize)]
struct Mutants {
    rooms: Vec<Room>,
    record: Vec<Mutant>,
}

/// An entry of it.
#[derive(Deserialize)]
struct Mutant {
    file: PathBuf,
    #[serde(flatten)]
    entry: Entry,
}

/// The rooms of the record of mutants, each with the entries of the mutants in it.
pub fn rooms() -> Result<Vec<Room>, Error> {
    let [.., Made { file, renew, .. }] = MADE;
    let Mutants { mut rooms, record } = read_json(&root().join(file), renew)?;
    for Mutant { file, entry } in record {
        let around = rooms.iter_mut().filter(|room| file.starts_with(&room.room));
        around.max_by_key(|room| room.room.len()).into_iter().for_each(|room| room.tried.push(entry.clone()));
    }
    Ok(rooms)
}

/// Whether some entries are of the present sources, how many are not, and the oldest day of any.
pub fn sources(entries: &[Entry]) -> String {
    // What has no day is older than what has one.
    let oldest = entries.iter().map(|entry| entry.date.as_deref().unwrap_or_default()).min();
    let Some(day) = oldest.map(|day| if day.is_empty() { "earlier" } else { day }) else { return "–".into() };
    let old = entries.iter().filter(|entry| !entry.is_current()).count();
    let sign = if old == 0 { "✓".into() } else { format!("○ {old} of {},", entries.len()) };
    format!("{sign} oldest {day}")
}

/// The part of all mutants that a truth alone catches.
pub fn by_truths_alone(rooms: &[Room]) -> String {
    together(rooms, "src", |room| &room.by_truths)
}

/// What libFuzzer found of a reader (`tests/fuzz/run.py`).
#[derive(Clone, Debug, Deserialize)]
pub struct Fuzzed {
    target: String,
    executions: usize,
    edges_covered: usize,
    broke: usize,
    #[serde(flatten)]
    entry: Entry,
}

/// The record of fuzz targets.
fn fuzzed() -> Result<Vec<Fuzzed>, Error> {
    let [_, Made { file, renew, .. }, _] = MADE;
    Ok(read_json::<Record<Fuzzed>>(&root().join(file), renew)?.record)
}

impl Made {
    /// Reads it.
    pub fn read(&self) -> Result<Record<Entry>, Error> {
        read_json(&root().join(self.file), self.renew)
    }

    /// The check of what is committed against the checkout: not run where an entry was made on other sources than those
    /// that it is bound to now: nothing is known of it on these.
    pub fn judge(&self, record: &[Entry]) -> Judged {
        let old = record.iter().filter(|entry| !entry.is_current()).count();
        let all = record.len();
        let judged = Check::at_most(
            Quantity::at(format!("{} of other sources or tests than the present ones", self.entry), ""),
            Reference::own(self.file, 0.0),
            "what was found on other sources, or by a test that is no more, need not hold on these",
        )
        .asked_of(all)
        .judge(old as f64);
        let why = match all {
            0 => format!("none is recorded: {}", self.renew),
            _ => format!("{old} of {all} {}s are of other sources or tests: {}", self.entry, self.renew),
        };
        if old == 0 && all > 0 { judged } else { Judged { verdict: Verdict::NotRun(why), ..judged } }
    }
}
