//! The frozen answers of a case, judged as `judge` does.

use std::fs;
use std::path::Path;

use serde::Serialize;

use crate::case::Case;
use crate::case::Judged;
use crate::case::Verdict;
use crate::case::quantity::Quantity;
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::ReferenceKind;
use crate::referee::export::deck;
use crate::referee::judge::ENGINEERING;
use crate::referee::units::Role;
use crate::referee::{Answer, Asked, Truth, calculix, read, verdicts};
use crate::solve::Discretisation;
use crate::study::scoreboard::board::{self, Board, Told, hashes};
use crate::study::scoreboard::setting::Setting;
use crate::uncertainty::COVERAGE;

/// A case by all codes.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// The case.
    pub case: String,
    /// Displacement components of the exported mesh: now, and when it was asked.
    pub dofs: [usize; 2],
    /// Scripts that are no longer what they were.
    pub changed: Vec<String>,
    /// Kind of the truth of the peak.
    pub kind: ReferenceKind,
    /// A row a run.
    pub rows: Vec<Row>,
}

/// A run.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Index of its setting among all.
    pub setting: usize,
    /// Version of the code; none of a run that failed.
    pub version: Option<String>,
    /// Seconds over those of one sparse Cholesky solve.
    pub seconds: f64,
    /// How it ended.
    pub ended: Ended,
}

/// How it ended.
#[derive(Clone, Debug, Serialize)]
pub enum Ended {
    /// With an answer.
    Judged {
        /// Iterations.
        iterations: usize,
        /// Peak pressure, half-width.
        scores: [Score; 2],
        /// What is not met.
        failed: Vec<String>,
        /// Largest relative change of peak and second-moment width since they were judged by the live run.
        moved: f64,
    },
    /// Without one, or with one that cannot be read: why.
    Failed {
        /// Why.
        why: String,
        /// Whether the code itself failed.
        by_itself: bool,
    },
}

/// A number against its truth.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Score {
    /// The number \[MPa; mm, or ° on an arc\].
    pub value: f64,
    /// Its relative error, with its sign.
    pub error: f64,
    /// What the truth may itself be off, relative.
    pub bar: f64,
}

impl Row {
    /// Its setting.
    pub fn setting(&self) -> Setting {
        Setting::ALL[self.setting]
    }

    /// How much of all that is judged is not met.
    fn not_met(&self) -> usize {
        match &self.ended {
            Ended::Judged { failed, .. } => failed.len(),
            Ended::Failed { .. } => usize::MAX,
        }
    }

    /// The larger error of peak and second-moment width; NaN of a run that failed.
    pub fn error(&self) -> f64 {
        match &self.ended {
            Ended::Judged { scores: [peak, width], .. } => larger(peak.error.abs(), width.error.abs()),
            Ended::Failed { .. } => f64::NAN,
        }
    }
}

impl Numbers {
    /// The best row of the settings that hold something: the least that is not met, then the least error; the first one of equals.
    pub fn best(&self, of: impl Fn(&Setting) -> bool) -> Option<&Row> {
        let rows = self.rows.iter().filter(|row| of(&row.setting()) && row.error().is_finite());
        // Errors of round-off are equal.
        rows.min_by(|a, b| {
            a.not_met().cmp(&b.not_met()).then(a.error().max(ROUND_OFF).total_cmp(&b.error().max(ROUND_OFF)))
        })
    }
}

/// Relative error that rounding explains.
pub const ROUND_OFF: f64 = 1e-9;

/// The frozen answers of a case, judged.
pub fn numbers(name: &str, case: &Case, board: &Board) -> Result<Numbers, Error> {
    let asked = board.of(name)?;
    let discretisation = case.meshed()?.discretisation;
    let truth = Truth::of(case.clone())?;
    let rows: Vec<Row> = asked.runs.iter().filter_map(|told| row(&truth, &discretisation, told)).collect();
    let now = hashes();
    let changed = now.iter().filter(|(script, hash)| board.scripts.get(*script) != Some(*hash));
    let peak = truth.known(0, crate::accuracy::Quantity::PeakPressure, crate::oracle::Quantity::PeakPressure);
    Ok(Numbers {
        case: name.into(),
        dofs: [discretisation.system.dofs(), asked.dofs],
        changed: changed.map(|(script, _)| script.clone()).collect(),
        kind: peak.reference.kind,
        rows,
    })
}

/// The row of a run; none of a setting that is no more.
fn row(truth: &Truth, discretisation: &Discretisation, told: &Told) -> Option<Row> {
    let wanted = Setting::named(told.code, &told.method)?;
    let setting = Setting::ALL.iter().position(|one| *one == wanted)?;
    let ended = match &told.ended {
        board::Ended::Failed(why) => Ended::Failed { why: why.clone(), by_itself: true },
        board::Ended::Answered { file, iterations, found } => {
            let path = board::folder().join(file);
            let judged = fs::read(&path)
                .map_err(|error| Error::unreadable(&path, error, board::RENEW))
                .and_then(|bytes| scored(truth, discretisation, &path, &bytes));
            match judged {
                Ok((scores, failed)) => {
                    let moved = scores.iter().zip(found).map(|(now, then)| (now.value - then).abs() / then.abs());
                    Ended::Judged { iterations: *iterations, moved: moved.fold(0.0, larger), scores, failed }
                }
                Err(error) => Ended::Failed { why: error.message.to_string(), by_itself: false },
            }
        }
    };
    Some(Row { setting, version: told.version.clone(), seconds: told.seconds / told.cholesky, ended })
}

/// Peak and second-moment width of a file that a code wrote for an exported case, and what of all that is judged is not met.
pub fn scored(
    truth: &Truth,
    discretisation: &Discretisation,
    file: &Path,
    bytes: &[u8],
) -> Result<([Score; 2], Vec<String>), Error> {
    let answer = answer(&truth.case, discretisation, file, bytes)?;
    let found = verdicts(truth, answer, ENGINEERING)?;
    let judged: Vec<&Judged> = found.ruled.iter().flat_map(|ruled| &ruled.judged).collect();
    let score = |wanted: &dyn Fn(&Quantity) -> bool| {
        let one = judged.iter().find(|one| wanted(&one.check.quantity));
        one.map_or(Score { value: f64::NAN, error: f64::NAN, bar: f64::NAN }, |one| Score {
            value: one.value,
            error: (one.value - one.reference.value) / one.reference.value,
            bar: one.reference.uncertainty.map_or(0.0, |u| COVERAGE * u / one.reference.value.abs()),
        })
    };
    let peak = score(&|quantity| *quantity == Quantity::PeakPressure);
    let width = score(&|quantity| matches!(quantity, Quantity::SecondMomentWidth | Quantity::SecondMomentAngle));
    let failed = judged.iter().filter(|one| one.verdict == Verdict::Fail).map(|one| one.check.quantity.to_string());
    Ok(([peak, width], failed.collect()))
}

/// The answer in a file: numbers are in mm, N and MPa, and nodes are those of the exported mesh.
fn answer(case: &Case, discretisation: &Discretisation, file: &Path, bytes: &[u8]) -> Result<Answer, Error> {
    let named = file.with_extension("");
    let ending =
        if file.extension().is_some_and(|ending| ending == "gz") { named.extension() } else { file.extension() };
    let fields = ending.is_some_and(|ending| ending == "frd" || ending == "vtu");
    let units = [(Role::Position, "mm"), (Role::Pressure, "MPa"), (Role::Displacement, "mm")];
    let table = file.extension().is_some_and(|ending| ending == "csv");
    let asked = Asked {
        // Fields do not say their units; tables and documents do.
        units: if fields { units.map(|(role, unit)| (role, unit.to_owned())).into() } else { vec![] },
        // A table does not say how its points follow one another.
        order: table.then_some(discretisation.mesh.order),
        ..Asked::default()
    };
    if ending.is_some_and(|ending| ending == "dat") {
        let text = String::from_utf8_lossy(bytes);
        return calculix::forces(file, &text, &deck::text(discretisation)?, &case.scene, &asked);
    }
    read::parse(file, bytes, case, &asked)
}
