//! What was measured, as it is kept under `snapshots/timings`.

use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::study::pairing::Pairing;
use crate::study::timings::code::Code;
use crate::study::timings::digits::Reached;
use crate::study::timings::growth::{Growth, Nine};
use crate::study::timings::machine::Machine;
use crate::study::timings::others::{OtherPoint, PeerPoint, Stages};
use crate::study::timings::precision::{Family, Laps, Point};
use crate::study::timings::statistics::Spread;

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- timings` and review the diff of snapshots/timings";
/// Where they are.
pub const FOLDER: &str = "snapshots/timings";

/// Everything but the points of the work–precision charts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// On what.
    pub machine: Machine,
    /// Mesh by mesh.
    pub growth: Vec<Growth>,
    /// All nine formulations over one, mesh by mesh.
    pub nine: Vec<Nine>,
    /// Seconds of the whole report.
    pub report: f64,
    /// What the converged p₀ and a of the cylinder are uncertain by.
    pub floor: [f64; 2],
    /// Other codes on truncated Hertz.
    pub others: Vec<OtherPoint>,
    /// Our cheapest solve of truncated Hertz within 0.1 %, measured before and after each of them.
    pub beside: Vec<Beside>,
    /// Other codes on the cylinder.
    pub peers: Vec<PeerPoint>,
    /// What was not installed.
    pub absent: Vec<Absent>,
    /// Ours to more digits; none in records from before they were timed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub digits: Vec<Reached>,
}

impl Measured {
    /// Why some codes have no numbers: they were not installed, or are not part of this record.
    pub fn skipped(&self) -> Vec<String> {
        let told = |code: &Code| self.absent.iter().any(|one| one.code == code.name());
        let unknown = Code::ALL.into_iter().filter(|code| self.of(*code).next().is_none() && !told(code));
        self.absent.iter().map(Absent::to_string).chain(unknown.map(|code| self.why_not(code))).collect()
    }

    /// Why a code has no numbers.
    pub fn why_not(&self, code: Code) -> String {
        let told = self.absent.iter().find(|one| one.code == code.name());
        told.map_or_else(|| format!("{code} was not asked when this was recorded"), Absent::to_string)
    }

    /// What a code reached on its own meshes.
    pub fn of(&self, code: Code) -> impl Iterator<Item = &OtherPoint> {
        self.others.iter().filter(move |point| point.code == code)
    }

    /// Takes in what a code answered in a run of its own, with our own solve beside it.
    pub fn renew(&mut self, points: Vec<OtherPoint>, beside: Beside) {
        self.absent.retain(|one| one.code != beside.code.name());
        self.others.retain(|point| point.code != beside.code);
        self.beside.retain(|kept| kept.code != beside.code);
        self.others.extend(points);
        self.beside.push(Beside { apart: Some(Machine::here()), ..beside });
    }
}

/// A code that was not installed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Absent {
    /// Its name.
    pub code: String,
    /// What was missing.
    pub why: String,
}

impl fmt::Display for Absent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.code, self.why)
    }
}

/// Our own solve as it was beside another code's.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Beside {
    /// The other code.
    pub code: Code,
    /// Our seconds.
    pub seconds: Spread,
    /// What of them went where.
    pub stages: Stages,
    /// On what, where the code was asked in a run of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub apart: Option<Machine>,
}

impl Beside {
    /// From our stages, load by load.
    pub fn of(code: Code, laps: &[Laps]) -> Self {
        let whole = |laps: &Laps| laps.iter().map(|(_, seconds)| seconds).sum();
        let seconds = Spread::of(&laps.iter().map(whole).collect::<Vec<f64>>());
        Self { code, seconds, stages: Stages::of(laps), apart: None }
    }
}

/// The whole record.
#[derive(Clone, Debug)]
pub struct Record {
    /// Growth, other codes, machine.
    pub measured: Measured,
    /// Points of the work–precision charts.
    pub points: Vec<Point>,
}

impl Record {
    /// Reads what is committed.
    pub fn read() -> Result<Self, Error> {
        let text = |path: &PathBuf| std::fs::read_to_string(path).map_err(|_| Error::missing_file(path, RENEW));
        let [one, two] = files();
        let measured = serde_json::from_str(&text(&one)?).map_err(|error| Error::unreadable(&one, error, RENEW))?;
        let points = csv::Reader::from_reader(text(&two)?.as_bytes())
            .deserialize()
            .collect::<Result<_, _>>()
            .map_err(|error| Error::unreadable(&two, error, RENEW))?;
        Ok(Self { measured, points })
    }

    /// Points of one formulation on the meshes of a family, coarse to fine.
    pub fn of_meshes(&self, family: Family, cell_nodes: usize, formulation: Pairing) -> Vec<&Point> {
        let is_own = |point: &&Point| {
            point.family == family && point.cell_nodes == cell_nodes && point.formulation == formulation
        };
        self.points.iter().filter(is_own).collect()
    }

    /// Writes both files.
    pub fn write(&self) -> Result<(), Error> {
        let [one, two] = files();
        let text = serde_json::to_string_pretty(&self.measured).map_err(|error| Error::unwritable(&one, error))?;
        let mut writer = csv::Writer::from_writer(Vec::new());
        for point in &self.points {
            writer.serialize(point).map_err(|error| Error::unwritable(&two, error))?;
        }
        let table = writer.into_inner().map_err(|error| Error::unwritable(&two, error))?;
        let save = |path: &PathBuf, text: &[u8]| {
            let folder = path.parent().unwrap_or(path);
            let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(path, text));
            written.map_err(|error| Error::unwritable(path, error))
        };
        save(&one, (text + "\n").as_bytes())?;
        save(&two, &table)
    }
}

/// The two files.
fn files() -> [PathBuf; 2] {
    ["measured.json", "precision.csv"].map(|name| root().join(FOLDER).join(name))
}
