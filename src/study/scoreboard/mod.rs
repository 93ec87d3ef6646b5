//! The scoreboard: exported cases solved by other codes, each with the contact it documents and with the best of its settings that were
//! tried. The frozen answers of a case are scored as `contact-vv judge` does; whether they are read, are of the present scripts, and agree.
//!
//! A folder, since asking the codes and judging what they wrote are two things of 400 lines.
//!
//! * [`board`] — which codes with which contact, the live run, what it leaves under `oracles/frozen/scoreboard`, and how a file that a code
//!   wrote is scored.

pub mod board;

use std::fmt::Write;
use std::fs;

use crate::case::{Case, Check, Judged, Quantity, library};
use crate::checkout::root;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::{Quantity as Number, larger};
use crate::oracle::ReferenceKind;
use crate::referee::Truth;
use crate::solve::Discretisation;
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::scoreboard::board::{Board, Code, Ended, RENEW, Scored, Setting, Told, hashes, scored};

/// One body on a rigid one, flat and curved; two bodies, straight, curved, and conforming.
pub const CASES: [&str; 6] = ["cylinder", "truncated-hertz", "bars", "own-weight", "two-cylinders", "pin-rod"];

/// A case of the library, or of a scene file of the repository.
pub fn named(name: &str) -> Result<Case, Error> {
    let file = root().join("tests/cases").join(name).with_extension("toml");
    if library::NAMES.iter().any(|(known, _)| *known == name) { library::find(name, None) } else { Case::read(&file) }
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

impl Study for Numbers {
    const NAME: &'static str = "scoreboard";
    const ABOUT: About = About {
        title: "Scoreboard of contact codes",
        asked: "How far other codes are from the truths of exported cases, with the contact they document and with the best setting tried.",
        limits: "One mesh a case, settings tried by us, seconds of one machine; another user may find better settings. Looked at and not asked: \
                 FreeFEM, which leaves contact to an optimiser, MFEM's wheel, which has none, and Elmer and code_aster, which neither Debian 12 nor PyPI holds.",
    };

    /// One trial a case.
    fn plan() -> Vec<Planned<Self>> {
        let planned =
            CASES.map(|name| Planned::new("scoreboard", name, move || numbers(name, &named(name)?, &Board::load()?)));
        planned.into()
    }

    /// Whether the frozen answers are read, are of the present scripts and meshes, and whether some code agrees with the truth: one of
    /// them, not all.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let rows = || self.rows.iter();
        let unread =
            rows().filter(|row| matches!(row.told.ended, Ended::Answered { .. }) && row.scored.is_err()).count();
        let complete = |value: f64| if self.rows.len() == Setting::ALL.len() { value } else { f64::NAN };
        let named = |name: &'static str| Quantity::at(name, self.case.clone());
        let none =
            |name, value: usize, because: &'static str| Check::none(named(name), because).judge(complete(value as f64));
        Ok(vec![
            none("frozen answers that cannot be read", unread, "what a code wrote once is read as it was"),
            none("scripts changed since their answers were frozen", self.changed.len(), RENEW),
        ])
    }

    /// The section.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let board = Board::load()?;
        let mut text = format!(
            "Each case is exported by `contact-vv export`, and solved on the exported mesh by the scripts that are exported with it. What each code \
             writes is judged by what `contact-vv judge` judges by: errors of the peak pressure p₀ and of the half-width a are relative to the \
             truth, which may itself be off by the larger of its bars in the fifth column. *First choice* is the contact that a code documents; \
             scikit-fem and dolfinx have none of their own, and are given what one writes first: springs. The best setting that was tried is set \
             in bold: the one with the least that is not met, then with the smaller error of p₀ and a together. Seconds are those of the solution by the script's own account, CalculiX's of the whole \
             process, over one sparse Cholesky solve of the exported mesh just before, of one machine ({}), and are recorded; errors and \
             verdicts are computed from the frozen files with every report. CalculiX makes bricks of plane cells, so that it solves for more unknowns. \
             In the plane the contact of SfePy, of Kratos and of Akantu has edges with 2 nodes alone: they are given each 8-node cell cut into four with 4 nodes. \
             Akantu finds pairs, gaps and the forces on the first side; the forces on the other side, the tangent and a turn of the scene are ours, since its \
             contact in the plane has faults there. FElupe's contact knows rigid planes only: beside a second body each node has a plane of its own, which \
             moves with the node that faces it, and these pairs are ours.\n\n",
            board.processor
        );
        text += &(markdown::columns(&SUMMARY, &Code::ALL.map(|code| summed(findings, code))) + "\n");
        text += &picture(
            FILE,
            &format!(
                "Scoreboard: larger error of p₀ and a over seconds; hollow: runs that failed; errors below {} are drawn there",
                markdown::bound(FLOOR)
            ),
        );
        for found in findings {
            let numbers = found.numbers;
            let is_best = |row: &Row| {
                numbers.best(|setting| setting.code == row.setting.code).is_some_and(|best| best.setting == row.setting)
            };
            let rows: Vec<Line> = numbers.rows.iter().map(|row| (row.clone(), is_best(row))).collect();
            let _ = write!(
                text,
                "\n## {}, {} degrees of freedom, truth: {}\n\n",
                numbers.case, numbers.dofs[0], numbers.kind
            );
            text += &markdown::columns(&RUNS, &rows);
        }
        Ok(text)
    }

    /// Error over seconds, code by code.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let mut chart = Chart::new(
            "Other codes on exported cases",
            Axis::log("seconds over one sparse Cholesky solve [–]"),
            Axis::log("larger relative error of p₀ and a [–]"),
        );
        for (code, first) in Code::ALL.into_iter().flat_map(|code| [(code, true), (code, false)]) {
            let (mut points, mut hollow) = (Vec::new(), Vec::new());
            for found in findings {
                let best = found.numbers.best(|setting| setting.code == code).map(|row| row.setting);
                let rows = found.numbers.rows.iter().filter(|row| row.setting.code == code);
                for row in rows.filter(|row| if first { row.setting.first } else { Some(row.setting) == best }) {
                    match row.scored {
                        Ok(_) => points.push([row.seconds(), row.error().max(FLOOR)]),
                        Err(_) => hollow.push(row.seconds()),
                    }
                }
            }
            let label = format!("{}, {}", code.name(), if first { "first choice" } else { "best setting" });
            chart.series.push(Series { hollow, ..Series::new(label, points, style(code, first)) });
        }
        Ok(vec![(FILE.into(), chart.drawing())])
    }
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

/// A code, its row of each case by the first choice and by the best setting, and how many of its runs failed.
type Summed = (Code, [Vec<Option<Row>>; 2], usize);

/// Code by code: how many cases are met, by the first choice and by the best setting.
const SUMMARY: [Column<Summed>; 6] = [
    ("code", |(code, ..)| code.name().into()),
    ("all met, first choice", |(_, [first, _], _)| met(first)),
    ("all met, best setting", |(_, [_, best], _)| met(best)),
    ("worst error, first choice", |(_, [first, _], _)| worst(first)),
    ("worst error, best setting", |(_, [_, best], _)| worst(best)),
    ("runs that failed", |(_, _, failed)| failed.to_string()),
];

fn met(rows: &[Option<Row>]) -> String {
    let met = rows.iter().flatten().filter(|row| row.not_met() == 0).count();
    format!("{met} of {}", rows.len())
}

fn worst(rows: &[Option<Row>]) -> String {
    let errors = rows.iter().flatten().map(Row::error).filter(|error| error.is_finite());
    errors.reduce(f64::max).map_or("–".into(), markdown::error)
}

fn summed(findings: &[Found<Numbers>], code: Code) -> Summed {
    let cases = || findings.iter().map(|found| found.numbers);
    let own =
        |numbers: &Numbers| numbers.rows.iter().filter(|row| row.setting.code == code).cloned().collect::<Vec<_>>();
    let first = cases().map(|numbers| own(numbers).into_iter().find(|row| row.setting.first)).collect();
    let best = cases().map(|numbers| numbers.best(|setting| setting.code == code).cloned()).collect();
    (code, [first, best], cases().flat_map(own).filter(|row| row.scored.is_err()).count())
}

/// A row of a run, and whether its setting is the best of its code.
type Line = (Row, bool);

/// A run.
const RUNS: [Column<Line>; 8] = [
    ("code", |(row, _)| {
        let version = row.told.version.as_ref().map_or(String::new(), |version| format!(" {version}"));
        format!("{}{version}", row.setting.code.name())
    }),
    ("contact", |(Row { setting: Setting { says, first, .. }, .. }, best)| {
        let says = if *best { format!("**{says}**") } else { (*says).to_owned() };
        if *first { format!("first choice: {says}") } else { says }
    }),
    ("p₀ − truth", |(row, _)| departure(row, 0)),
    ("a − truth", |(row, _)| departure(row, 1)),
    ("truth ±", |(row, _)| {
        let bar = |scored: &Scored| markdown::error(larger(scored.scores[0].bar, scored.scores[1].bar));
        row.scored.as_ref().map_or("–".into(), bar)
    }),
    ("iterations", |(row, _)| match (&row.told.ended, &row.scored) {
        (Ended::Answered { iterations, .. }, Ok(_)) => iterations.to_string(),
        _ => "–".into(),
    }),
    ("seconds ÷ Cholesky", |(row, _)| markdown::significant(row.seconds(), 2)),
    ("not met", |(row, _)| match &row.scored {
        Ok(scored) if scored.failed.is_empty() => "–".into(),
        Ok(scored) => scored.failed.join("; "),
        Err(why) => why.clone(),
    }),
];

/// How far a number is from its truth.
fn departure(row: &Row, k: usize) -> String {
    let told = |scored: &Scored| match scored.scores[k].error {
        error if error.abs() < ROUND_OFF => markdown::error(error.abs()),
        error => format!("{} %", markdown::signed(100.0 * error, 2)),
    };
    row.scored.as_ref().map_or("failed".into(), told)
}

/// File of the chart.
const FILE: &str = "scoreboard.svg";
/// Errors below this are drawn there.
const FLOOR: f64 = 1e-6;

/// Colour = code, sign = setting.
fn style(code: Code, first: bool) -> Style {
    let colour = match code {
        Code::Calculix => palette::ORANGE,
        Code::Getfem => palette::PURPLE,
        Code::Ngsolve => palette::NODE,
        Code::Sfepy => palette::SKY,
        Code::Kratos => palette::INK,
        Code::Akantu => palette::WINE,
        Code::Felupe => palette::GREY,
        Code::ScikitFem => palette::LINE,
        Code::Dolfinx => palette::LAYER,
    };
    Style::run(colour, Dash::Absent, if first { Marker::Square } else { Marker::Circle })
}
