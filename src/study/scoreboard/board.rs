//! Codes of the scoreboard and the contact that each is run with; the live run, in which every case is exported and
//! every code is asked for it by each of its settings; and what it leaves: what each code told of its runs, beside the
//! files that it wrote.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use flate2::Compression;
use flate2::write::GzEncoder;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::case::{Case, Judged, Verdict};
use crate::checkout::{root, sha256};
use crate::condensation::Plain;
use crate::error::Error;
use crate::measure::Quantity as Number;
use crate::oracle::cross_code::Code;
use crate::oracle::cross_code::frozen::{read_json, write_json};
use crate::referee::export::deck;
use crate::referee::export::own;
use crate::referee::export::problem::{self, SCRIPTS};
use crate::referee::judge::{self, ENGINEERING};
use crate::referee::units::Role;
use crate::referee::{self, Answer, Truth, calculix, contact_laws, read, verdicts};
use crate::solve::{Discretisation, Formulation, Run};

impl Code {
    /// Its script under `oracles/peers`.
    pub fn script(self) -> String {
        format!("run_{}.py", self.name().to_lowercase().replace('-', "_"))
    }

    /// Whether its contact has edges with 2 nodes alone, so that it is given each 8-node cell cut into four.
    pub fn cuts_cells(self) -> bool {
        matches!(self, Self::Sfepy | Self::Kratos | Self::Akantu)
    }
}

/// A contact that a code is run with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The code.
    pub code: Code,
    /// What its script calls the contact.
    pub method: &'static str,
    /// The same in words.
    pub says: &'static str,
    /// Of the code's own contact the parameter that is searched over, and what the code's documentation says of it;
    /// none where the code only solves our contact rows: its answer is ours again, whatever its contact is worth.
    pub searched: Option<[&'static str; 2]>,
}

/// The first choice of its parameter and the multiples by which each code is asked after it, until one ends the search.
pub const TIMES: [f64; 4] = [1.0, 10.0, 100.0, 1000.0];
/// Those by which it is asked where the first of these multiples leaves no smaller error.
pub const LESS: [f64; 2] = [0.1, 0.01];
/// The search goes on where a multiple leaves less than this part of the error before.
pub const FALLS: f64 = 0.9;
/// Relative error that rounding explains.
pub const ROUND_OFF: f64 = 1e-9;

impl Setting {
    /// All, the own contact of each code before our rows.
    pub const ALL: [Self; 14] = [
        Self::own(Code::Calculix, "pair", "contact pair, surface to surface", ["K = 50 E per mm", "5 to 50 E per mm"]),
        Self::rows(Code::Calculix, "gaps", "gap elements of the exported deck"),
        Self::own(Code::Getfem, "integral", "augmented Lagrangian", ["r = E", "in a range of acceptable values"]),
        Self::rows(Code::Getfem, "basic", "basic contact brick on the exported rows"),
        Self::own(Code::Ngsolve, "contact", "energy of overlap", ["K = 50 E per mm", "no number: CalculiX's"]),
        Self::rows(Code::Ngsolve, "active-set", "active sets on the exported rows"),
        Self::own(Code::Sfepy, "contact", "contact term on both sides", ["K = 10 E per mm", "that of its example"]),
        Self::own(Code::Kratos, "contact", "mortar, augmented Lagrangian", ["1 load step", "no number of steps"]),
        Self::own(Code::Akantu, "contact", "penalty at nodes", ["ε = 400 E per mm", "that of its example"]),
        Self::own(
            Code::Felupe,
            "contact",
            "rigid planes, penalty",
            ["k = mean nodal stiffness", "that as best practice"],
        ),
        Self::rows(Code::ScikitFem, "penalty", "springs on the exported rows, k = 10 E/h"),
        Self::rows(Code::ScikitFem, "active-set", "active sets on the exported rows"),
        Self::rows(Code::Dolfinx, "penalty", "springs on the exported rows, k = 10 E/h"),
        Self::rows(Code::Dolfinx, "active-set", "active sets on the exported rows"),
    ];

    const fn own(code: Code, method: &'static str, says: &'static str, searched: [&'static str; 2]) -> Self {
        Self { code, method, says, searched: Some(searched) }
    }

    const fn rows(code: Code, method: &'static str, says: &'static str) -> Self {
        Self { code, method, says, searched: None }
    }

    /// The multiples of its first choice, upwards and downwards; there is no part of a load step.
    pub fn multiples(self) -> [&'static [f64]; 2] {
        match (self.searched, self.code) {
            (None, _) => [&[], &[]],
            (Some(_), Code::Kratos) => [&TIMES[1..], &[]],
            (Some(_), _) => [&TIMES[1..], &LESS],
        }
    }

    /// The setting of a code by the name of its method.
    pub fn named(code: Code, method: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|one| one.code == code && one.method == method)
    }
}

/// Where it is.
pub const FOLDER: &str = "oracles/frozen/scoreboard";
/// What renews it.
pub const RENEW: &str = "run `bash oracles/peers/setup.sh && cargo run --release -- scoreboard`, and review the diff \
    of oracles/frozen/scoreboard";

/// All runs.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Board {
    /// SHA-256 of the scripts, in hexadecimal digits.
    pub scripts: BTreeMap<String, String>,
    /// Processor that the seconds are of.
    pub processor: String,
    /// By case.
    pub cases: BTreeMap<String, Asked>,
}

/// A case as it was asked.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Asked {
    /// Displacement components of the exported mesh.
    pub dofs: usize,
    /// Runs, in the order of the settings.
    pub runs: Vec<Told>,
}

/// What was told of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Told {
    /// The code.
    pub code: Code,
    /// Its contact, by the name in its script.
    pub method: String,
    /// Its parameter over the first choice.
    pub times: f64,
    /// Version of the code; none of a run that failed.
    pub version: Option<String>,
    /// Seconds: of the solution by the script's own account; of the whole process where it failed.
    pub seconds: f64,
    /// Seconds of one sparse Cholesky solve of the exported mesh, just before.
    pub cholesky: f64,
    /// How it ended.
    pub ended: Ended,
}

/// How a run ended.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Ended {
    /// With an answer.
    Answered {
        /// The file it wrote, in the folder of the board: of a code's own contact kept of the first choice and of the
        /// least error.
        file: Option<String>,
        /// Iterations.
        iterations: usize,
        /// Peak pressure \[MPa\] and half-width \[mm, or rad\] as they were judged then.
        found: [f64; 2],
    },
    /// Without one: what it said.
    Failed(String),
}

impl Board {
    /// Reads it.
    pub fn load() -> Result<Self, Error> {
        read_json(&file(), RENEW)
    }

    /// Writes it, and beside it the files that codes wrote, by their names.
    pub fn write(&self, files: &[(String, Vec<u8>)]) -> Result<(), Error> {
        let folder = folder();
        fs::create_dir_all(&folder).map_err(|error| Error::unwritable(&folder, error))?;
        for (name, bytes) in files {
            let kept = folder.join(name);
            fs::write(&kept, bytes).map_err(|error| Error::unwritable(&kept, error))?;
        }
        write_json(&file(), self)
    }

    /// The case; refused where it was not asked.
    pub fn of(&self, case: &str) -> Result<&Asked, Error> {
        self.cases.get(case).ok_or_else(|| Error::missing_key(&file(), case, "the cases that were asked", RENEW))
    }
}

/// The file.
pub fn file() -> PathBuf {
    folder().join("record.json")
}

/// Its folder.
pub fn folder() -> PathBuf {
    root().join(FOLDER)
}

/// SHA-256 of the scripts as they are now.
pub fn hashes() -> BTreeMap<String, String> {
    SCRIPTS.into_iter().map(|(name, text, _)| (name.to_owned(), sha256(text.as_bytes()))).collect()
}

/// The interpreter that the codes are installed for.
const PYTHON: &str = "/usr/bin/python3";
/// What the scripts end with where their code is not installed.
const MISSING: i32 = 3;
/// Times that the sparse Cholesky solve is measured, of which the shortest counts.
const REPEATS: usize = 5;
/// Endings of files that are kept compressed.
const LARGE: [&str; 2] = ["frd", "vtu"];

/// Refuses where not every code can run, as its first setting tells on a small case.
pub fn refuse_absent(name: &str, case: &Case) -> Result<(), Error> {
    refuse_other_scripts()?;
    let place = posed(name, case, &case.meshed()?.discretisation)?;
    let first = Code::ALL.map(|code| Setting::ALL.into_iter().find(|setting| setting.code == code));
    let absent: Vec<String> =
        first.iter().flatten().filter_map(|setting| run(setting, TIMES[0], &place).err()).collect();
    if absent.is_empty() { Ok(()) } else { Err(not_installed(&absent.join("; "))) }
}

/// Why the record is kept as it was.
fn not_installed(which: &str) -> Error {
    let message = format!("not all of {} are installed: {which}", Code::ALL.map(Code::name).join(", "));
    let remedy =
        "install them by `bash oracles/peers/setup.sh` and `bash oracles/setup.sh`; the record is kept as it was";
    Error::at("scoreboard", message, remedy)
}

/// The folder in which a case waits for the scripts.
fn posed(name: &str, case: &Case, discretisation: &Discretisation) -> Result<PathBuf, Error> {
    let place = root().join("target/scoreboard").join(name);
    fs::create_dir_all(&place).map_err(|error| Error::unwritable(&place, error))?;
    let files =
        [("problem.json", problem::text(&case.name, discretisation)?), ("case.inp", deck::text(discretisation)?)];
    for (file, text) in files {
        let file = place.join(file);
        fs::write(&file, text).map_err(|error| Error::unwritable(&file, error))?;
    }
    Ok(place)
}

/// Files that the codes wrote, by the names under which they are kept.
pub type Written = Vec<(String, Vec<u8>)>;

/// A case by every setting, its parameter searched over, and the files that the codes wrote.
pub fn ask(name: &str, case: &Case, told: impl Fn(&Setting, f64)) -> Result<(Asked, Written), Error> {
    let discretisation = case.meshed()?.discretisation;
    let truth = Truth::of(case.clone())?;
    let place = posed(name, case, &discretisation)?;
    let (mut runs, mut files) = (Vec::new(), Vec::new());
    for setting in Setting::ALL {
        let mut tried: Vec<(Told, f64, Vec<u8>)> = Vec::new();
        let mut error_of = |times: f64| -> Result<f64, Error> {
            told(&setting, times);
            let cholesky = cholesky(&discretisation)?;
            let (seconds, answer) = run(&setting, times, &place).map_err(|why| not_installed(&why))?;
            let version = answer.as_ref().ok().and_then(|value| value["version"].as_str().map(str::to_owned));
            let (ended, error, bytes) = match answer {
                Ok(value) => kept(&format!("{name}-x{times}"), &truth, &discretisation, &place, &value)?,
                Err(why) => (Ended::Failed(why), f64::INFINITY, vec![]),
            };
            let Setting { code, method, .. } = setting;
            tried.push((Told { code, method: method.into(), times, version, seconds, cholesky, ended }, error, bytes));
            Ok(error)
        };
        let first = error_of(TIMES[0])?;
        for multiples in setting.multiples() {
            let mut before = first;
            for times in multiples {
                let error = error_of(*times)?;
                if !falls(before, error) {
                    break;
                }
                before = error;
            }
            // Upwards it has found something.
            if before < first {
                break;
            }
        }
        let least = (0..tried.len()).min_by(|a, b| tried[*a].1.total_cmp(&tried[*b].1));
        for (k, (mut told, _, bytes)) in tried.into_iter().enumerate() {
            if let Ended::Answered { file, .. } = &mut told.ended {
                *file = file.take().filter(|_| k == 0 || Some(k) == least);
                files.extend(file.clone().map(|file| (file, bytes)));
            }
            runs.push(told);
        }
    }
    Ok((Asked { dofs: discretisation.system.dofs(), runs }, files))
}

/// Whether the search goes on from a multiple with an error, infinite where it failed, to the one after that with
/// another.
fn falls(before: f64, error: f64) -> bool {
    error < FALLS * before
}

/// Refuses scripts that are not those this program was built with, whose digests it writes.
fn refuse_other_scripts() -> Result<(), Error> {
    for (name, text, _) in SCRIPTS {
        let file = root().join("oracles/peers").join(name);
        if fs::read_to_string(&file).ok().as_deref() != Some(text) {
            return Err(Error::file(
                &file,
                "it has changed since this program was built",
                "build it again: `cargo build --release`",
            ));
        }
    }
    Ok(())
}

/// Seconds of one sparse Cholesky solve of all bodies, the shortest of some.
fn cholesky(discretisation: &Discretisation) -> Result<f64, Error> {
    let systems = discretisation.system.bodies.iter().map(Plain::of).collect::<Result<Vec<Plain>, Error>>()?;
    let once = |_| {
        let clock = Instant::now();
        systems.iter().try_for_each(|system| system.solve().map(|found| drop(std::hint::black_box(found))))?;
        Ok(clock.elapsed().as_secs_f64())
    };
    let all = (0..REPEATS).map(once).collect::<Result<Vec<f64>, Error>>()?;
    Ok(all.into_iter().fold(f64::INFINITY, f64::min))
}

/// Seconds of a script, and what it told or why it failed; refused with the reason where its code is not installed.
fn run(setting: &Setting, times: f64, place: &Path) -> Result<(f64, Result<Value, String>), String> {
    let script = root().join("oracles/peers").join(setting.code.script());
    let clock = Instant::now();
    let times = setting.searched.map(|_| format!("--times={times}"));
    let started = Command::new(PYTHON).arg("-EsB").arg(&script).arg(place).arg(setting.method).args(times).output();
    let output = started.map_err(|_| format!("{PYTHON} is missing"))?;
    let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    let last = said.lines().last().unwrap_or("it failed without a word").to_owned();
    if output.status.code() == Some(MISSING) {
        return Err(last);
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let value = text.lines().last().and_then(|line| serde_json::from_str::<Value>(line).ok());
    Ok(match value.filter(|_| output.status.success()) {
        Some(value) => (value["seconds"].as_f64().unwrap_or(f64::NAN), Ok(value)),
        None => (clock.elapsed().as_secs_f64(), Err(last)),
    })
}

/// How a run ended that wrote a file, the larger error of peak and width, and the file as it is kept beside the record.
fn kept(
    name: &str,
    truth: &Truth,
    discretisation: &Discretisation,
    place: &Path,
    value: &Value,
) -> Result<(Ended, f64, Vec<u8>), Error> {
    let file = value["file"].as_str().unwrap_or_default();
    let written = place.join(file);
    let mut bytes = fs::read(&written).map_err(|error| Error::unreadable(&written, error, "run the script by hand"))?;
    let mut named = format!("{name}-{file}");
    if LARGE.iter().any(|ending| file.ends_with(ending)) {
        named += ".gz";
        let mut compressed = GzEncoder::new(Vec::new(), Compression::best());
        bytes = compressed
            .write_all(&bytes)
            .and_then(|()| compressed.finish())
            .map_err(|error| Error::unwritable(&written, error))?;
    }
    let scored = scored(truth, discretisation, Path::new(&named), &bytes).ok();
    let Some(scored) = scored.filter(|scored| scored.error().is_finite()) else {
        let why = format!("what it wrote holds no profile that can be judged: {file}");
        return Ok((Ended::Failed(why), f64::INFINITY, vec![]));
    };
    let iterations = value["iterations"].as_u64().unwrap_or(0) as usize;
    let found = scored.scores.each_ref().map(|score| score.value);
    Ok((Ended::Answered { file: Some(named), iterations, found }, scored.error().max(ROUND_OFF), bytes))
}

/// An answer against its truth.
#[derive(Clone, Debug)]
pub struct Scored {
    /// Peak pressure \[MPa\] and second-moment width \[mm, or ° on an arc\] as they are judged.
    pub scores: [Judged; 2],
    /// Largest penetration over the approach that the contact makes, and largest tension over the largest pressure;
    /// none where the answer does not tell them.
    pub laws: [Option<f64>; 2],
    /// What is not met.
    pub failed: Vec<String>,
}

/// Peak and second-moment width of a file that a code wrote for an exported case, and what of all that is judged is not
/// met.
pub fn scored(truth: &Truth, discretisation: &Discretisation, file: &Path, bytes: &[u8]) -> Result<Scored, Error> {
    of_answer(truth, answer(&truth.case, discretisation, file, bytes)?)
}

/// Our own answer on the mesh of a case, by the same.
pub fn ours(truth: &Truth, discretisation: &Discretisation) -> Result<Scored, Error> {
    let run = Run::of(discretisation, &Formulation::verification())?;
    let document = serde_json::to_vec(&own::answer(&truth.case.name, discretisation, &run));
    let bytes = document.map_err(|error| Error::at(truth.case.name.as_str(), error.to_string(), "report it"))?;
    of_answer(truth, answer(&truth.case, discretisation, Path::new("ours.json"), &bytes)?)
}

fn of_answer(truth: &Truth, answer: Answer) -> Result<Scored, Error> {
    let found = verdicts(truth, answer, ENGINEERING)?;
    let judged: Vec<&Judged> = found.ruled.iter().flat_map(|ruled| &ruled.judged).collect();
    let score = |wanted: Number| {
        let one = judged.iter().find(|one| one.check.quantity.number() == Some(&wanted)).copied().cloned();
        one.ok_or_else(|| Error::at(truth.case.name.as_str(), "no profile can be judged", "hand in its pressures"))
    };
    let failed = judged.iter().filter(|one| one.verdict == Verdict::Fail).map(|one| one.check.quantity.to_string());
    let scores = [score(Number::PeakPressure)?, score(Number::SecondMomentWidth)?];
    let law = |name: &str| judged.iter().find(|one| one.check.quantity.name() == name).map(|one| one.error);
    let laws = [contact_laws::PENETRATION, judge::TENSION].map(law);
    Ok(Scored { scores, laws, failed: failed.collect() })
}

/// The answer in a file: numbers are in mm, N and MPa, and nodes are those of the exported mesh.
fn answer(case: &Case, discretisation: &Discretisation, file: &Path, bytes: &[u8]) -> Result<Answer, Error> {
    let named = file.with_extension("");
    let ending =
        if file.extension().is_some_and(|ending| ending == "gz") { named.extension() } else { file.extension() };
    let fields = ending.is_some_and(|ending| ending == "frd" || ending == "vtu");
    let units = [(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Displacement, "mm")];
    let table = file.extension().is_some_and(|ending| ending == "csv");
    let asked = referee::Asked {
        // Fields do not say their units; tables and documents do.
        units: if fields { units.map(|(role, unit)| (role, unit.to_owned())).into() } else { vec![] },
        // A table does not say how its points follow one another.
        order: table.then_some(discretisation.mesh.order),
        ..referee::Asked::default()
    };
    if ending.is_some_and(|ending| ending == "dat") {
        let text = String::from_utf8_lossy(bytes);
        return calculix::forces(file, &text, &deck::text(discretisation)?, &case.scene, &asked);
    }
    read::parse(file, bytes, case, &asked)
}
