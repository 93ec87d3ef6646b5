//! The frozen answers of a case, scored as `contact-vv judge` does; whether they are read, are of the present scripts, and agree.

use std::fs;
use std::path::Path;

use crate::case::{Case, Check, Judged, Quantity, Reference, Verdict, library};
use crate::checkout::root;
use crate::error::Error;
use crate::measure::{Quantity as Number, larger};
use crate::oracle::ReferenceKind;
use crate::referee::export::deck;
use crate::referee::judge::ENGINEERING;
use crate::referee::units::Role;
use crate::referee::{Answer, Asked, Truth, calculix, read, verdicts};
use crate::solve::Discretisation;
use crate::study::Planned;
use crate::study::scoreboard::board::{self, Board, Ended, FOLDER, RENEW, Told, hashes};
use crate::study::scoreboard::setting::Setting;
use crate::uncertainty::COVERAGE;

/// One body on a rigid one, flat and curved; two bodies, straight, curved, and conforming.
pub const CASES: [&str; 6] = ["cylinder", "truncated-hertz", "bars", "own-weight", "two-cylinders", "pin-rod"];

/// A case of the library, or of a scene file of the repository.
pub fn named(name: &str) -> Result<Case, Error> {
    let file = root().join("tests/cases").join(name).with_extension("toml");
    if library::NAMES.iter().any(|(known, _)| *known == name) { library::find(name, None) } else { Case::read(&file) }
}

/// One trial a case.
pub fn plan() -> Vec<Planned<Numbers>> {
    let planned =
        CASES.map(|name| Planned::new("scoreboard", name, move || numbers(name, &named(name)?, &Board::load()?)));
    planned.into()
}

/// A case by all codes.
#[derive(Clone, Debug)]
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
#[derive(Clone, Debug)]
pub struct Row {
    /// Its setting.
    pub setting: Setting,
    /// What the live run left of it.
    pub told: Told,
    /// What its file holds now; why there is none, or none that can be read.
    pub scored: Result<Scored, String>,
}

/// An answer against its truth.
#[derive(Clone, Debug)]
pub struct Scored {
    /// Peak pressure, half-width.
    pub scores: [Score; 2],
    /// What is not met.
    pub failed: Vec<String>,
}

/// A number against its truth.
#[derive(Clone, Copy, Debug)]
pub struct Score {
    /// The number \[MPa; mm, or ° on an arc\].
    pub value: f64,
    /// Its relative error, with its sign.
    pub error: f64,
    /// What the truth may itself be off, relative.
    pub bar: f64,
}

impl Row {
    /// How much of all that is judged is not met.
    pub fn not_met(&self) -> usize {
        self.scored.as_ref().map_or(usize::MAX, |scored| scored.failed.len())
    }

    /// The larger error of peak and second-moment width; NaN of a run that failed.
    pub fn error(&self) -> f64 {
        let of = |scored: &Scored| larger(scored.scores[0].error.abs(), scored.scores[1].error.abs());
        self.scored.as_ref().map_or(f64::NAN, of)
    }

    /// Seconds over those of one sparse Cholesky solve.
    pub fn seconds(&self) -> f64 {
        self.told.seconds / self.told.cholesky
    }

    /// Largest relative change of peak and second-moment width since they were judged by the live run; none without an answer.
    fn moved(&self) -> Option<f64> {
        let (Ended::Answered { found, .. }, Ok(Scored { scores, .. })) = (&self.told.ended, &self.scored) else {
            return None;
        };
        Some(scores.iter().zip(found).map(|(now, then)| (now.value - then).abs() / then.abs()).fold(0.0, larger))
    }
}

impl Numbers {
    /// The best row of the settings that hold something: the least that is not met, then the least error; the first one of equals.
    pub fn best(&self, of: impl Fn(&Setting) -> bool) -> Option<&Row> {
        let rows = self.rows.iter().filter(|row| of(&row.setting) && row.error().is_finite());
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
    let peak = truth.known(0, &Number::PeakPressure);
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
    let setting = Setting::named(told.code, &told.method)?;
    let scored = match &told.ended {
        Ended::Failed(why) => Err(why.clone()),
        Ended::Answered { file, .. } => {
            let path = board::folder().join(file);
            fs::read(&path)
                .map_err(|error| Error::unreadable(&path, error, RENEW))
                .and_then(|bytes| scored(truth, discretisation, &path, &bytes))
                .map_err(|error| error.message.to_string())
        }
    };
    Some(Row { setting, told: told.clone(), scored })
}

/// Peak and second-moment width of a file that a code wrote for an exported case, and what of all that is judged is not met.
pub fn scored(truth: &Truth, discretisation: &Discretisation, file: &Path, bytes: &[u8]) -> Result<Scored, Error> {
    let answer = answer(&truth.case, discretisation, file, bytes)?;
    let found = verdicts(truth, answer, ENGINEERING)?;
    let judged: Vec<&Judged> = found.ruled.iter().flat_map(|ruled| &ruled.judged).collect();
    let score = |wanted: Number| {
        let one = judged.iter().find(|one| one.check.quantity.number() == Some(&wanted));
        one.map_or(Score { value: f64::NAN, error: f64::NAN, bar: f64::NAN }, |one| Score {
            value: one.value,
            error: (one.value - one.reference.value) / one.reference.value,
            bar: one.reference.uncertainty.map_or(0.0, |u| COVERAGE * u / one.reference.value.abs()),
        })
    };
    let failed = judged.iter().filter(|one| one.verdict == Verdict::Fail).map(|one| one.check.quantity.to_string());
    let scores = [Number::PeakPressure, Number::SecondMomentWidth].map(score);
    Ok(Scored { scores, failed: failed.collect() })
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

/// Relative change that other rounding explains.
const SAME: f64 = 1e-6;

/// Whether the frozen answers are read, are of the present scripts and meshes, and whether some code agrees with the truth: one of
/// them, not all.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let rows = || numbers.rows.iter();
    let unread = rows().filter(|row| matches!(row.told.ended, Ended::Answered { .. }) && row.scored.is_err()).count();
    // Acceptance is stated, so that what is no number has moved.
    let is_same = |row: &&Row| row.moved().is_none_or(|moved| moved <= SAME);
    let moved = numbers.rows.len() - rows().filter(is_same).count();
    let complete = |value: f64| if numbers.rows.len() == Setting::ALL.len() { value } else { f64::NAN };
    let named = |name: &'static str| Quantity::at(name, numbers.case.clone());
    let none =
        |name, value: usize, because: &'static str| Check::none(named(name), because).judge(complete(value as f64));
    let best = numbers.best(|_| true).and_then(|row| row.scored.as_ref().ok());
    let agrees = |k: usize, name| {
        let (error, bar) = best.map_or((f64::NAN, 0.0), |best| (best.scores[k].error.abs(), best.scores[k].bar));
        let reference =
            Reference { kind: ReferenceKind::CrossCode, ..Reference::own("the nearest of other codes", 0.0) };
        Check::error(named(name), reference, ENGINEERING + bar, "engineering tolerance, and what the truth may be off")
            .judge(error)
    };
    let [now, then] = numbers.dofs;
    let dofs = Check::at_most(
        named("degrees of freedom that the exported mesh has changed by"),
        Reference::own("none", 0.0),
        format!("{FOLDER} is of the present meshes: {RENEW}"),
    );
    Ok(vec![
        none("frozen answers that cannot be read", unread, "what a code wrote once is read as it was"),
        none(
            "frozen answers judged otherwise than when they were written",
            moved,
            "peak and second-moment width within 1e-6",
        ),
        none("scripts changed since their answers were frozen", numbers.changed.len(), RENEW),
        dofs.judge(now.abs_diff(then) as f64),
        agrees(0, "relative error of the peak pressure of the nearest code"),
        agrees(1, "relative error of the second-moment width of the nearest code"),
    ])
}
