//! The scoreboard: exported cases solved by other codes, each by its own contact: as it documents it, and by the best
//! of its parameters that were tried; our own answer among them. Runs in which a code only solves our contact rows are
//! told apart and count for nothing. The frozen answers of a case are scored as `contact-vv judge` does; whether they
//! are read, and are of the present scripts.
//!
//! A folder, since asking the codes and judging what they wrote are two things of 400 lines.
//!
//! * [`board`] — which codes with which contact, the live run, what it leaves under `oracles/frozen/scoreboard`, and
//!   how a file that a code wrote is scored.

pub mod board;

use std::fmt::Write;
use std::fs;

use crate::case::{Case, Check, Judged, Quantity, Reference, library};
use crate::checkout::root;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Remark, Series, panels};
use crate::error::Error;
use crate::markdown::{self, Column, table};
use crate::measure::{Quantity as Number, larger};
use crate::mesh::{Order, Resolution};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::Code;
use crate::referee::Truth;
use crate::scene::Profile;
use crate::solve::{Discretisation, Formulation};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::scoreboard::board::{
    Board, Ended, FALLS, LESS, RENEW, ROUND_OFF, Scored, Setting, TIMES, Told, hashes, scored,
};

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
    /// Truth of the peak.
    pub truth: Reference,
    /// What the truths of peak and second-moment width may be off, relative: the larger.
    pub bar: f64,
    /// What cells with 4 nodes leave, whose sides are straight and along which pressures are linear, relative.
    pub straight: f64,
    /// What the end of the contact leaves within an edge, relative.
    pub end: f64,
    /// Our own answer on the exported mesh.
    pub ours: Result<Scored, String>,
    /// A row a run.
    pub rows: Vec<Row>,
}

impl Study for Numbers {
    const NAME: &'static str = "scoreboard";
    const ABOUT: About = About {
        title: "Scoreboard of contact codes",
        asked: "How far other codes are from the truths of exported cases by their own contact: by its first choice, \
            and by the best that a stated search finds.",
        limits: "One mesh a case, one parameter a code, seconds of one machine; another user may find better ones. \
            Looked at and not asked: FreeFEM, which leaves contact to an optimiser, MFEM's wheel, which has none, and \
            Elmer and code_aster, which neither Debian 12 nor PyPI holds.",
    };

    /// One trial a case.
    fn plan() -> Vec<Planned<Self>> {
        let planned =
            CASES.map(|name| Planned::new("scoreboard", name, move || numbers(name, &named(name)?, &Board::load()?)));
        planned.into()
    }

    /// Whether each code comes as near as it may by the best of its own contact.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        let own_contact = Code::ALL.into_iter().filter(|code| own(*code).is_some());
        let judged = own_contact.map(|code| {
            let error = format!("error of {}'s own contact at its best", code.name());
            let because = "the bar of the truth, what its parameter leaves, the force of the edge in which the contact \
                ends, and what straight cells leave where it needs them";
            let bar = self.allowed(code);
            let check = Check::error(Quantity::at(error, self.case.clone()), self.truth.clone(), bar, because);
            Judged { bar: Some(bar), ..check.judge(self.own(code)[1].map_or(f64::NAN, Row::error)) }
        });
        Ok(judged.collect())
    }

    /// The section.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let board = Board::load()?;
        let mut text = format!(
            include_str!("page.md"),
            multiples = listed(&TIMES),
            less = listed(&LESS),
            falls = 100.0 * (1.0 - FALLS),
            ours = Formulation::verification().name(),
            processor = board.processor
        ) + "\n";
        text += &(markdown::columns(&SUMMARY, &ranked(findings)) + "\n");
        let searches = Code::ALL.into_iter().filter_map(own).map(|Setting { code, says, searched, .. }| {
            let runs: usize = findings.iter().map(|found| found.numbers.search(code).count()).sum();
            let [first, documented] = searched.unwrap_or_default();
            [code.name(), says, first, documented, &runs.to_string()].map(str::to_owned).into()
        });
        let head = ["code", "its own contact", "first choice", "its documentation", "runs tried"].map(str::to_owned);
        text += &(table(&head, &searches.collect::<Vec<_>>()) + "\n");
        text += &picture(
            FILE,
            &format!(
                "Scoreboard: error of each code by its own contact, first choice to best of the search; errors below \
                {} are drawn there",
                markdown::bound(FLOOR)
            ),
        );
        for found in findings {
            let numbers = found.numbers;
            let _ = write!(
                text,
                "\n## {}, {} degrees of freedom, truth: {}, {} {}\n\n",
                numbers.case,
                numbers.dofs[0],
                numbers.truth.kind,
                if numbers.truth.kind == ReferenceKind::Analytic { "model error stated" } else { "error bar" },
                markdown::error(numbers.bar)
            );
            text += &markdown::columns(&RUNS, &numbers.lines(false));
            text += &("\n".to_owned() + &markdown::folded("errors of the search", &numbers.tried(), false));
            let rows = markdown::columns(&RUNS, &numbers.lines(true));
            text += &("\n".to_owned() + &markdown::folded("our rows, their solver", &rows, false));
        }
        Ok(text)
    }

    /// Error of each code by its own contact, a panel a case.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let mut order: Vec<Option<Code>> = ranked(findings).into_iter().rev().map(|(code, _)| code).collect();
        order.retain(|code| code.is_none_or(|code| own(code).is_some()));
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
                Series::new("best of the search", best, points(palette::LINE, Marker::Circle)),
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

/// The own contact of a code, if it has one.
fn own(code: Code) -> Option<Setting> {
    Setting::ALL.into_iter().find(|one| one.code == code && one.searched.is_some())
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
    /// Departures of peak and second-moment width from their truths, relative: of its file or, where none is kept, of
    /// what was found in it then; NaN of a run that failed.
    pub departures: [f64; 2],
}

impl Row {
    /// The larger of its departures.
    pub fn error(&self) -> f64 {
        larger(self.departures[0].abs(), self.departures[1].abs())
    }

    /// Seconds over those of one sparse Cholesky solve.
    pub fn seconds(&self) -> f64 {
        self.told.seconds / self.told.cholesky
    }
}

impl Numbers {
    /// The row of the settings that hold something with the least error, of those whose files are kept; the first one
    /// of equals, as those of round-off are.
    pub fn best(&self, of: impl Fn(&Setting) -> bool) -> Option<&Row> {
        let rows = self.rows.iter().filter(|row| of(&row.setting) && row.scored.is_ok() && row.error().is_finite());
        rows.min_by(|a, b| a.error().max(ROUND_OFF).total_cmp(&b.error().max(ROUND_OFF)))
    }

    /// A code's rows by its own contact: the first choice, and the best.
    pub fn own(&self, code: Code) -> [Option<&Row>; 2] {
        [self.search(code).next(), self.best(|setting| setting.code == code && setting.searched.is_some())]
    }

    /// A code's rows by its own contact, in the order in which they were tried.
    pub fn search(&self, code: Code) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.setting.code == code && row.setting.searched.is_some())
    }

    /// What the best of a code may be off, relative: the bar of the truth, what the mesh allows before anybody has
    /// solved on it (what the end of the contact leaves and, where cells are cut, what straight ones do), and what its
    /// parameter does: of a third of what the last multiple changed (of a penalty ten times as stiff a ninth is left)
    /// and of what the next one changes the smaller, as recorded. Our answer is no part of it: a fault of ours would
    /// let others be off by as much.
    fn allowed(&self, code: Code) -> f64 {
        // The way to the best, upwards or downwards from the first choice.
        let best = self.own(code)[1];
        let is_less = |row: &Row| row.told.times < TIMES[0];
        let is_on_way =
            |row: &&Row| is(row.told.times, TIMES[0]) || best.is_some_and(|best| is_less(best) == is_less(row));
        let tried: Vec<&Row> = self.search(code).filter(|row| row.error().is_finite()).filter(is_on_way).collect();
        let best = best.and_then(|best| tried.iter().position(|row| std::ptr::eq(*row, best)));
        let found = |k: usize| match &tried[k].told.ended {
            Ended::Answered { found, .. } => *found,
            Ended::Failed(_) => [f64::NAN; 2],
        };
        let change = |a: usize, b: usize| {
            let [[p, a], [q, b]] = [a, b].map(found);
            larger((p / q - 1.0).abs(), (a / b - 1.0).abs())
        };
        let parameter = best.map_or(f64::NAN, |k| {
            let before = k.checked_sub(1).map(|before| change(before, k) / 3.0);
            let next = (k + 1 < tried.len()).then(|| change(k, k + 1));
            before.into_iter().chain(next).reduce(f64::min).unwrap_or(0.0)
        });
        let straight = if code.cuts_cells() { self.straight } else { 0.0 };
        self.bar + self.end + straight + parameter + ROUND_OFF
    }

    /// Errors of the search, code by code.
    fn tried(&self) -> String {
        let all = || LESS.iter().rev().chain(&TIMES);
        let head: Vec<String> = all().map(|times| format!("× {times}")).collect();
        let error = |row: &Row| if row.error().is_finite() { markdown::error(row.error()) } else { "failed".into() };
        let rows = Code::ALL.into_iter().filter_map(own).map(|Setting { code, .. }| {
            let at = |times: &f64| self.search(code).find(|row| is(row.told.times, *times)).map_or("–".into(), error);
            [vec![code.name().into()], all().map(at).collect()].concat()
        });
        table(&[vec!["code".into()], head].concat(), &rows.collect::<Vec<_>>())
    }

    /// The rows of the page, by error: of the codes' own contacts with ours among them, or of our rows by their
    /// solvers.
    fn lines(&self, our_rows: bool) -> Vec<Line> {
        let is_best =
            |row: &Row| !our_rows && self.own(row.setting.code)[1].is_some_and(|best| std::ptr::eq(best, row));
        let rows = self.rows.iter().filter(|row| row.setting.searched.is_none() == our_rows);
        let shown = rows.filter(|row| our_rows || is(row.told.times, TIMES[0]) || is_best(row));
        let line = |row: &Row| (Some((row.clone(), is_best(row))), row.scored.clone());
        let mut lines: Vec<Line> = shown.map(line).collect();
        lines.extend((!our_rows).then(|| (None, self.ours.clone())));
        let error = |line: &Line| line.1.as_ref().map_or(f64::INFINITY, |scored| scored.error().max(ROUND_OFF));
        lines.sort_by(|a, b| error(a).total_cmp(&error(b)));
        lines
    }
}

/// Whether two multiples are the same one.
fn is(times: f64, other: f64) -> bool {
    times.total_cmp(&other).is_eq()
}

/// Multiples in words.
fn listed(times: &[f64]) -> String {
    times.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

impl Scored {
    /// The larger relative error of peak and second-moment width.
    pub fn error(&self) -> f64 {
        larger(self.departure(0).abs(), self.departure(1).abs())
    }

    /// That of one of them, with its sign.
    pub fn departure(&self, k: usize) -> f64 {
        (self.scores[k].value - self.scores[k].reference.value) / self.scores[k].reference.value
    }
}

/// The frozen answers of a case, scored; refused where they are not all there, cannot be read, or are of other scripts
/// than the present ones.
pub fn numbers(name: &str, case: &Case, board: &Board) -> Result<Numbers, Error> {
    let asked = board.of(name)?;
    let discretisation = case.meshed()?.discretisation;
    let truth = Truth::of(case.clone())?;
    let finer = Resolution { order: Order::Linear, refinement: case.resolution.refinement + 1, ..case.resolution };
    let cut = Discretisation::of(case.scene.clone(), finer)?;
    let ours = board::ours(&truth, &discretisation).map_err(|error| error.message.to_string());
    let kept = ours.as_ref().ok();
    let rows: Vec<Row> = asked.runs.iter().filter_map(|told| row(&truth, &discretisation, told, kept)).collect();
    if let Some(found) = missing(board, &rows) {
        return Err(Error::refused(&board::file(), name, found, RENEW));
    }
    let off = |number: Number| {
        let known = truth.known(0, &number);
        known.bar / known.reference.value.abs()
    };
    let width = truth.known(0, &Number::SecondMomentWidth).reference.value;
    Ok(Numbers {
        case: name.into(),
        dofs: [discretisation.system.dofs(), asked.dofs],
        truth: Reference { value: 0.0, ..truth.known(0, &Number::PeakPressure).reference },
        bar: larger(off(Number::PeakPressure), off(Number::SecondMomentWidth)),
        straight: chords(&cut) + lines(&cut, width),
        end: at_end(&discretisation, width),
        ours,
        rows,
    })
}

/// What frozen answers lack: a file that can be read, a run of every setting, the present scripts.
fn missing(board: &Board, rows: &[Row]) -> Option<String> {
    let is_unread = |row: &&Row| matches!(row.told.ended, Ended::Answered { file: Some(_), .. }) && row.scored.is_err();
    let unread =
        rows.iter().find(is_unread).map(|row| format!("an answer of {} that cannot be read", row.setting.method));
    let is_absent = |setting: &&Setting| !rows.iter().any(|row| row.setting == **setting);
    let absent = Setting::ALL.iter().find(is_absent).map(|setting| format!("no answer of {}", setting.method));
    let changed = || hashes().into_iter().find(|(script, hash)| board.scripts.get(script) != Some(hash));
    unread.or(absent).or_else(|| changed().map(|(script, _)| format!("answers of another {script}")))
}

/// What chords of cells with straight sides leave of the clearance c of a pin of radius R, `(R φ)²/8R/c` of cells that
/// span the angle φ: the gap of a node that faces the middle of one is off by its sagitta. 0 of other gaps, which are
/// no narrower than the arcs that face them.
fn chords(cut: &Discretisation) -> f64 {
    let (Profile::Hole { radius, clearance } | Profile::Pin { radius, clearance }) = cut.scene.contact().profile else {
        return 0.0;
    };
    let angles = cut.interfaces[0].contact_edges().map(|edge| edge.ends[1] - edge.ends[0]);
    0.125 * radius * angles.fold(0.0, f64::max).powi(2) / clearance
}

/// What a straight line between nodes leaves of the pressure over a contact of half-width a: at the top of a parabola,
/// h apart, `h²/8a²`.
fn lines(cut: &Discretisation, width: f64) -> f64 {
    let within = cut.interfaces[0].contact_edges().filter(|edge| edge.ends.iter().all(|end| end.abs() <= width));
    let longest = within.map(|edge| (edge.ends[1] - edge.ends[0]).abs()).fold(0.0, f64::max);
    0.125 * (longest / width).powi(2)
}

/// What is left of a second-moment width a where the force of the edge in which the contact ends is lost: of nodes h
/// apart there `0.9 (h/a)^(3/2)`, as Hertz's pressure has `(4√2/3π) (h/a)^(3/2)` of its force there, at four times its
/// second moment. 0 where all candidates are closed, so that a side ends it.
fn at_end(discretisation: &Discretisation, width: f64) -> f64 {
    let mut places: Vec<f64> = discretisation.interfaces[0].nodes.iter().map(|node| node.coordinate.abs()).collect();
    places.sort_by(f64::total_cmp);
    let end = places.windows(2).find(|pair| pair[0] <= width && width < pair[1]);
    end.map_or(0.0, |pair| 0.9 * ((pair[1] - pair[0]) / width).powf(1.5))
}

/// The row of a run; none of a setting that is no more.
fn row(truth: &Truth, discretisation: &Discretisation, told: &Told, ours: Option<&Scored>) -> Option<Row> {
    let setting = Setting::named(told.code, &told.method)?;
    let scored = match &told.ended {
        Ended::Failed(why) => Err(why.clone()),
        Ended::Answered { file: None, .. } => Err("its file is not kept".into()),
        Ended::Answered { file: Some(file), .. } => {
            let path = board::folder().join(file);
            fs::read(&path)
                .map_err(|error| Error::unreadable(&path, error, RENEW))
                .and_then(|bytes| scored(truth, discretisation, &path, &bytes))
                .map_err(|error| error.message.to_string())
        }
    };
    let departures = match (&scored, &told.ended, ours) {
        (Ok(scored), ..) => [0, 1].map(|k| scored.departure(k)),
        (_, Ended::Answered { file: None, found, .. }, Some(ours)) => {
            [0, 1].map(|k| found[k] / ours.scores[k].reference.value - 1.0)
        }
        _ => [f64::NAN; 2],
    };
    Some(Row { setting, told: told.clone(), scored, departures })
}

/// A code over all cases, none being ours: its answers by the first choice, by the best parameters, and by our rows,
/// case by case; none where a run failed, or there is no such contact.
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
        let rows = |setting: &Setting| setting.code == code && setting.searched.is_none();
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
        Some((Row { setting: Setting { says, searched, .. }, told, .. }, best)) => {
            let which = match (searched, told.times) {
                (None, _) => (*says).to_owned(),
                (Some([parameter, _]), times) if is(times, TIMES[0]) => format!("first choice, {parameter}"),
                (Some(_), times) => format!("× {times}"),
            };
            if *best { format!("**{which}**") } else { which }
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
