//! The scoreboard: exported cases solved by other codes, each by its own contact: as it documents it, and by the best of its parameters that
//! were tried; our own answer among them. Runs in which a code only solves our contact rows are told apart and count for nothing. The frozen
//! answers of a case are scored as `contact-vv judge` does; whether they are read, and are of the present scripts.
//!
//! A folder, since asking the codes and judging what they wrote are two things of 400 lines.
//!
//! * [`board`] — which codes with which contact, the live run, what it leaves under `oracles/frozen/scoreboard`, and how a file that a code
//!   wrote is scored.

pub mod board;

use std::fmt::Write;
use std::fs;

use crate::case::{Case, Check, Judged, Quantity, Reference, library};
use crate::checkout::root;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Remark, Series, panels};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::{Quantity as Number, larger};
use crate::oracle::ReferenceKind;
use crate::referee::Truth;
use crate::solve::{Discretisation, Formulation};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::scoreboard::board::{
    Board, Code, Contact, Ended, FOLDER, RENEW, Scored, Setting, Told, hashes, scored,
};
use crate::uncertainty::COVERAGE;

/// One body on a rigid one, flat and curved; two bodies, straight, curved, and conforming.
pub const CASES: [&str; 6] = ["cylinder", "truncated-hertz", "bars", "own-weight", "two-cylinders", "pin-rod"];

/// The smallest of them.
pub const SMALLEST: &str = "own-weight";

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
    /// Our own answer on the exported mesh.
    pub ours: Result<Scored, String>,
    /// A row a run.
    pub rows: Vec<Row>,
}

impl Study for Numbers {
    const NAME: &'static str = "scoreboard";
    const ABOUT: About = About {
        title: "Scoreboard of contact codes",
        asked: "How far other codes are from the truths of exported cases by their own contact, as they document it and by the best parameters tried.",
        limits: "One mesh a case, few parameters tried, and by us, seconds of one machine; another user may find better ones. Looked at and not asked: \
                 FreeFEM, which leaves contact to an optimiser, MFEM's wheel, which has none, and Elmer and code_aster, which neither Debian 12 nor PyPI holds.",
    };

    /// One trial a case.
    fn plan() -> Vec<Planned<Self>> {
        let planned =
            CASES.map(|name| Planned::new("scoreboard", name, move || numbers(name, &named(name)?, &Board::load()?)));
        planned.into()
    }

    /// Whether the frozen answers are read, and are of the present scripts and meshes.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let rows = || self.rows.iter();
        let unread =
            rows().filter(|row| matches!(row.told.ended, Ended::Answered { .. }) && row.scored.is_err()).count();
        let complete = |value: f64| if self.rows.len() == Setting::ALL.len() { value } else { f64::NAN };
        let named = |name: &'static str| Quantity::at(name, self.case.clone());
        let none = |name, value: usize, because: &'static str| {
            Check::at_most(named(name), Reference::own(FOLDER, 0.0), because).judge(complete(value as f64))
        };
        Ok(vec![
            none("frozen answers that cannot be read", unread, "what a code wrote once is read as it was"),
            none(
                "scripts changed since their answers were frozen",
                self.changed.len(),
                "an answer is of the script that asked for it",
            ),
        ])
    }

    /// The section.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let board = Board::load()?;
        let mut text = format!(
            include_str!("page.md"),
            tried = tried(),
            ours = Formulation::verification().name(),
            processor = board.processor
        ) + "\n";
        text += &(markdown::columns(&SUMMARY, &ranked(findings)) + "\n");
        text += &picture(
            FILE,
            &format!(
                "Scoreboard: error of each code by its own contact, first choice to best of its parameters tried; errors below {} are drawn there",
                markdown::bound(FLOOR)
            ),
        );
        for found in findings {
            let numbers = found.numbers;
            // What the truth may itself be off, relative.
            let bar =
                |one: &Judged| one.reference.uncertainty.map_or(0.0, |u| COVERAGE * u / one.reference.value.abs());
            let bar = |scored: &Scored| markdown::error(larger(bar(&scored.scores[0]), bar(&scored.scores[1])));
            let _ = write!(
                text,
                "\n## {}, {} degrees of freedom, truth: {}, error bar {}\n\n",
                numbers.case,
                numbers.dofs[0],
                numbers.kind,
                numbers.ours.as_ref().map_or("unknown".into(), bar)
            );
            text += &markdown::columns(&RUNS, &numbers.lines(false));
            let rows = markdown::columns(&RUNS, &numbers.lines(true));
            text += &("\n".to_owned() + &markdown::folded("our rows, their solver", &rows, false));
        }
        Ok(text)
    }

    /// Error of each code by its own contact, a panel a case.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let mut order: Vec<Option<Code>> = ranked(findings).into_iter().rev().map(|(code, _)| code).collect();
        order.retain(|code| code.is_none_or(|code| own_contacts(code) > 0));
        let names = || order.iter().map(|code| code.map_or("ours", Code::name).to_owned()).collect();
        let panel = |found: &Found<Self>| {
            let error = Axis::log("larger error of p₀ and a [–]").over(0.5 * FLOOR, 2.0);
            let mut chart = Chart::new(&found.numbers.case, error, Axis::rows(names()));
            let [mut first, mut best, mut ours] = [vec![], vec![], vec![]];
            for (row, code) in order.iter().enumerate() {
                let at = |error: f64| (error.max(FLOOR), row as f64 + 1.0);
                let Some(code) = code else {
                    ours.extend(found.numbers.ours.as_ref().map(|scored| at(scored.error())));
                    continue;
                };
                let both = found.numbers.own(*code).map(|row| row.map(Row::error).filter(|error| error.is_finite()));
                first.extend(both[0].map(at));
                best.extend(both[1].map(at));
                let way: Vec<(f64, f64)> = both.into_iter().flatten().map(at).collect();
                chart.series.push(Series::new("", way, Style::run(palette::GREY, Dash::Solid, Marker::Absent)));
                if both[0].is_none() {
                    let (at, text, colour) = ((1.0, row as f64 + 1.0), "failed".into(), palette::LAYER);
                    chart.remarks.push(Remark { at, text, ring: None, colour });
                }
            }
            let points = |colour, marker| Style::run(colour, Dash::Absent, marker);
            chart.series.extend([
                Series::new("first choice", first, points(palette::LAYER, Marker::Square)),
                Series::new("best of its parameters tried", best, points(palette::LINE, Marker::Circle)),
                Series::new("ours", ours, points(palette::NODE, Marker::Diamond)),
            ]);
            chart
        };
        let charts: Vec<Chart> = findings.iter().map(panel).collect();
        Ok(vec![(
            FILE.into(),
            panels("Each code by its own contact: from first choice to best parameters", &charts, 3),
        )])
    }
}

/// How many parameters of each code's own contact were tried.
fn tried() -> String {
    let counts = Code::ALL.map(own_contacts).into_iter().filter(|count| *count > 0);
    let [least, most] = [counts.clone().min(), counts.max()].map(Option::unwrap_or_default);
    if least == most {
        format!("{least} that were tried of each code")
    } else {
        format!("the {least} to {most} that were tried of each code")
    }
}

/// In how many settings a code has a contact of its own.
fn own_contacts(code: Code) -> usize {
    Setting::ALL.iter().filter(|one| one.code == code && one.contact != Contact::OurRows).count()
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
        self.scored.as_ref().map_or(f64::NAN, Scored::error)
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

    /// A code's rows by its own contact: the first choice, and the best.
    pub fn own(&self, code: Code) -> [Option<&Row>; 2] {
        let first = self.rows.iter().find(|row| row.setting.code == code && row.setting.contact == Contact::First);
        [first, self.best(|setting| setting.code == code && setting.contact != Contact::OurRows)]
    }

    /// The rows of the page, by error: of the codes' own contacts with ours among them, or of our rows by their solvers.
    fn lines(&self, our_rows: bool) -> Vec<Line> {
        let rows = self.rows.iter().filter(|row| (row.setting.contact == Contact::OurRows) == our_rows);
        let line = |row: &Row| {
            let is_best = !our_rows && self.own(row.setting.code)[1].is_some_and(|best| best.setting == row.setting);
            (Some((row.clone(), is_best)), row.scored.clone())
        };
        let mut lines: Vec<Line> = rows.map(line).collect();
        lines.extend((!our_rows).then(|| (None, self.ours.clone())));
        let error = |line: &Line| line.1.as_ref().map_or(f64::INFINITY, |scored| scored.error().max(ROUND_OFF));
        lines.sort_by(|a, b| error(a).total_cmp(&error(b)));
        lines
    }
}

impl Scored {
    /// The larger relative error of peak and second-moment width.
    pub fn error(&self) -> f64 {
        larger(self.departure(0).abs(), self.departure(1).abs())
    }

    /// That of one of them, with its sign.
    fn departure(&self, k: usize) -> f64 {
        (self.scores[k].value - self.scores[k].reference.value) / self.scores[k].reference.value
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
        ours: board::ours(&truth, &discretisation).map_err(|error| error.message.to_string()),
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

/// A code over all cases, none being ours: its answers by the first choice, by the best parameters, and by our rows, case by case; none where a
/// run failed, or there is no such contact.
type Summed = (Option<Code>, [Vec<Option<Scored>>; 3]);

/// The largest of a number over the cases; none where no answer tells it.
fn largest_of(answers: &[Option<Scored>], of: impl Fn(&Scored) -> Option<f64>) -> Option<f64> {
    answers.iter().flatten().filter_map(of).reduce(larger)
}

fn worst_of(answers: &[Option<Scored>], of: impl Fn(&Scored) -> Option<f64>) -> String {
    let failed = answers.iter().filter(|one| one.is_none()).count();
    let worst = largest_of(answers, of).map_or("–".into(), markdown::error);
    if failed == 0 || failed == answers.len() { worst } else { format!("{worst}, {failed} failed") }
}

fn met(answers: &[Option<Scored>]) -> String {
    let met = answers.iter().flatten().filter(|scored| scored.failed.is_empty()).count();
    if answers.iter().flatten().next().is_none() { "–".into() } else { format!("{met} of {}", answers.len()) }
}

/// Code by code, over all cases.
const SUMMARY: [Column<Summed>; 8] = [
    ("code", |(code, _)| code.map_or("**ours**", Code::name).into()),
    ("worst error, first choice", |(_, [first, ..])| worst_of(first, |scored| Some(scored.error()))),
    ("worst error, best", |(_, [_, best, _])| worst_of(best, |scored| Some(scored.error()))),
    ("worst penetration, best", |(_, [_, best, _])| worst_of(best, |scored| scored.laws[0])),
    ("worst tension, best", |(_, [_, best, _])| worst_of(best, |scored| scored.laws[1])),
    ("all met, first choice", |(_, [first, ..])| met(first)),
    ("all met, best", |(_, [_, best, _])| met(best)),
    ("our rows, their solver: worst error", |(_, [.., rows])| worst_of(rows, |scored| Some(scored.error()))),
];

/// All codes and ours, by the worst error of the best.
fn ranked(findings: &[Found<Numbers>]) -> Vec<Summed> {
    let answer = |row: Option<&Row>| row.and_then(|row| row.scored.clone().ok());
    let of_code = |code: Code| {
        let own = |which: usize| findings.iter().map(move |found| answer(found.numbers.own(code)[which])).collect();
        let rows = |setting: &Setting| setting.code == code && setting.contact == Contact::OurRows;
        let ours = findings.iter().map(|found| answer(found.numbers.best(rows))).collect();
        (Some(code), [own(0), own(1), ours])
    };
    let ours: Vec<Option<Scored>> = findings.iter().map(|found| found.numbers.ours.clone().ok()).collect();
    let ours = (None, [ours.clone(), ours, vec![]]);
    let mut all: Vec<Summed> = Code::ALL.map(of_code).into_iter().chain([ours]).collect();
    let worst = |(_, [_, best, _]): &Summed| largest_of(best, |scored| Some(scored.error())).unwrap_or(f64::INFINITY);
    all.sort_by(|a, b| worst(a).total_cmp(&worst(b)));
    all
}

/// A run with whether it is the best of its code, and its answer; ours without a run.
type Line = (Option<(Row, bool)>, Result<Scored, String>);

/// A run.
const RUNS: [Column<Line>; 10] = [
    ("code", |(run, _)| match run {
        Some((row, _)) => {
            let version = row.told.version.as_ref().map_or(String::new(), |version| format!(" {version}"));
            format!("{}{version}", row.setting.code.name())
        }
        None => "**ours**".into(),
    }),
    ("contact", |(run, _)| match run {
        Some((Row { setting: Setting { says, contact, .. }, .. }, best)) => {
            let says = if *best { format!("**{says}**") } else { (*says).to_owned() };
            if *contact == Contact::First { format!("first choice: {says}") } else { says }
        }
        None => Formulation::verification().name(),
    }),
    ("error", |(_, scored)| scored.as_ref().map_or("failed".into(), |scored| markdown::error(scored.error()))),
    ("p₀ − truth", |(_, scored)| departure(scored, 0)),
    ("a − truth", |(_, scored)| departure(scored, 1)),
    ("penetration", |(_, scored)| law(scored, 0)),
    ("tension", |(_, scored)| law(scored, 1)),
    ("iterations", |(run, scored)| match (run.as_ref().map(|(row, _)| &row.told.ended), scored) {
        (Some(Ended::Answered { iterations, .. }), Ok(_)) => iterations.to_string(),
        _ => "–".into(),
    }),
    ("seconds ÷ Cholesky", |(run, _)| {
        run.as_ref().map_or("–".into(), |(row, _)| markdown::significant(row.seconds(), 2))
    }),
    ("not met", |(_, scored)| match scored {
        Ok(scored) if scored.failed.is_empty() => "–".into(),
        Ok(scored) => scored.failed.join("; "),
        Err(why) => why.clone(),
    }),
];

/// Penetration, or tension.
fn law(scored: &Result<Scored, String>, which: usize) -> String {
    scored.as_ref().ok().and_then(|scored| scored.laws[which]).map_or("–".into(), markdown::error)
}

/// How far a number is from its truth.
fn departure(scored: &Result<Scored, String>, k: usize) -> String {
    let told = |scored: &Scored| match scored.departure(k) {
        error if error.abs() < ROUND_OFF => markdown::error(error.abs()),
        error => format!("{} %", markdown::signed(100.0 * error, 2)),
    };
    scored.as_ref().map_or("failed".into(), told)
}

/// File of the chart.
const FILE: &str = "scoreboard.svg";
/// Errors below this are drawn there.
const FLOOR: f64 = 1e-6;
