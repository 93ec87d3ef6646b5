//! Speed against accuracy: what each accuracy costs, in seconds and in counted work. Our seconds are believed only
//! while our errors and counts recorded beside them are still the code's own: these the claims compute again. A folder,
//! since what measures seconds and what keeps them are two things.
//!
//! * `precision` — on which meshes truncated Hertz is solved; error against seconds and work, ours and of codes on
//!   meshes of their own.
//! * `growth` — one solve at three sizes, stage by stage, against one plain sparse Cholesky solve.
//! * `record` — what is kept under `snapshots/timings`, measured on demand by the command `timings`, what of it is
//!   cheapest, and what was asked for.
//!
//! Below are the page, the answer of the front page, and the charts. An error is everywhere the larger one of p₀ and a
//! under the worst of all loads.

pub mod growth;
pub mod precision;
pub mod record;

use crate::case::Judged;
use crate::clock::Stage;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Axis, Bars, Chart, Colour, Direction, Drawing, Guide, Remark, panels};
use crate::error::Error;
use crate::markdown::{self, significant};
use crate::solve::{Element, Formulation, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::target;
use crate::study::timings::growth::{Growth, RECOUNTED, exponent};
use crate::study::timings::precision::{LOADS, Point, STEEP, Series, TOLERANCE, cells, meshes_of, ours_tried};
use crate::study::timings::record::{Beside, COMPARED, Record, cheapest, front, ours, sound, targets};

pub use record::Record as Numbers;

impl Study for Record {
    const NAME: &'static str = "timings";
    const ABOUT: About = About {
        title: "Speed against accuracy",
        asked: "What an accuracy costs, in seconds and in counted work, here and in other codes.",
        limits: "Seconds are those of one machine. Our errors and counts are computed again by the tests; seconds, and \
            what other codes printed, are not.",
    };

    fn plan() -> Vec<Planned<Self>> {
        vec![Planned::new("speed against accuracy", "the record", || Record::read().map(Record::in_one_run))]
    }

    /// Seconds are of their machine; that our errors and counts are still those of the code is claimed by the tests.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(vec![])
    }

    /// The page of the committed record.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        Ok(findings.iter().map(|found| page(found.numbers)).collect())
    }

    /// The charts of the committed record.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        let of = |record: &Record| [(FRONTS[0].into(), fronts(record)), (CLOUD[0].into(), cloud(record))];
        Ok(findings.iter().flat_map(|found| of(found.numbers)).collect())
    }
}

/// How many of the targets are met.
pub fn met(record: &Record) -> String {
    let targets = targets(record);
    let count = |met: Option<bool>| targets.iter().filter(|target| target.met == met).count();
    format!(
        "Of {} targets for speed {} are met, {} are not and {} could not be measured.",
        targets.len(),
        count(Some(true)),
        count(Some(false)),
        count(None)
    )
}

/// The page of a record.
pub fn page(record: &Record) -> String {
    let asked = format!(
        "**{}** No check holds these: what seconds are worth changes with the machine.\n\n{}",
        met(record),
        markdown::columns(&target::COLUMNS, &targets(record))
    );
    [asked, "\n".into(), machine(record), precision(record), growth(record)].concat()
}

fn machine(record: &Record) -> String {
    let machine = &record.measured.machine;
    let versions: Vec<String> = machine.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let text = format!(
        include_str!("machine.md"),
        processor = machine.processor,
        threads = machine.threads,
        system = machine.system,
        compiler = machine.compiler,
        versions = versions.join(", "),
        again = again(record)
    ) + "\n";
    let skipped = record.measured.absent.iter().map(|(code, why)| format!("Skipped: {code}: {why}.\n\n"));
    let beside = beside(record).into_iter().map(|sentence| sentence + "\n\n");
    text + &skipped.chain(beside).collect::<String>()
}

/// How many recorded points and meshes are computed again, and how many are not.
fn again(record: &Record) -> String {
    let Record { measured, points } = record;
    let theirs = points.iter().filter(|point| Series::CODES.contains(&point.series)).count();
    let meshes = || measured.growth.iter().chain(&measured.revolved);
    let large = meshes().filter(|one| one.counts.dofs > RECOUNTED).count();
    format!(
        "the errors and counts of {} points of ours, and the counts of {} of the {} meshes below *Growth*, those up \
        to {RECOUNTED} dofs. The {theirs} points of other codes are as these printed them",
        points.len() - theirs,
        meshes().count() - large,
        meshes().count()
    )
}

fn precision(record: &Record) -> String {
    let text = format!(
        include_str!("precision.md"),
        loads = LOADS,
        tolerance = TOLERANCE,
        methods = methods(record),
        tried = tried(record),
        own = of_their_own(record)
    ) + "\n";
    "\n".to_owned() + &text + &picture(FRONTS[0], FRONTS[1]) + &picture(CLOUD[0], CLOUD[1])
}

/// What grows with the mesh, by its name.
type Growing = (&'static str, fn(&Growth) -> f64);

/// Rows of the table of the growth below those of the stages.
const WHOLE: [Growing; 6] = [
    ("contact solve [ms]", |one| 1e3 * one.contact.median),
    ("plain solve [ms]", |one| 1e3 * one.plain.median),
    ("from nothing [ms]", |one| 1e3 * one.seconds(&Stage::ALL)),
    ("operations of the factorisation [million]", |one| 1e-6 * one.counts.factor_operations),
    ("sparse factor [MB]", |one| 8e-6 * one.counts.factor_entries as f64),
    ("whole process, at most [MB]", |one| {
        one.memory_ratio.map_or(f64::NAN, |ratio| 8e-6 * ratio * one.counts.factor_entries as f64)
    }),
];

/// How seconds, memory and the counted operations grow, which seconds follow in the end.
fn growth(record: &Record) -> String {
    let growth = &record.measured.growth;
    let row = |name: String, of: &dyn Fn(&Growth) -> f64| {
        let cells = growth.iter().map(|one| significant(of(one), 3));
        std::iter::once(name).chain(cells).chain([format!("{:.2}", exponent(growth, of))]).collect()
    };
    let stages = Stage::ALL.map(|stage| row(format!("{} [ms]", stage.name()), &|one| 1e3 * one.seconds(&[stage])));
    let rows: Vec<Vec<String>> = stages.into_iter().chain(WHOLE.map(|(name, of)| row(name.into(), &of))).collect();
    let sizes = growth.iter().map(|one| format!("{} dofs, {} iterations", one.counts.dofs, one.counts.iterations));
    let head: Vec<String> = std::iter::once("".into()).chain(sizes).chain(["exponent".into()]).collect();
    let revolved = growth.first().zip(record.measured.revolved.first());
    let revolved = revolved.map(of_revolution).unwrap_or_default();
    format!(include_str!("growth.md"), table = markdown::table(&head, &rows), revolved = revolved) + "\n"
}

/// Why the contact solve of a body of revolution is another multiple of the plain one than that of the plane on as many
/// dofs.
fn of_revolution((plane, revolved): (&Growth, &Growth)) -> String {
    let seconds = |of: fn(&Growth) -> f64| [revolved, plane].map(|one| format!("{} ms", significant(1e3 * of(one), 3)));
    let [own_plain, plain] = seconds(|one| one.plain.median);
    let [own_factor, factor] = seconds(|one| one.seconds(&[Stage::Factorisation]));
    let [own_rest, rest] = seconds(|one| one.contact.median - one.seconds(&[Stage::Factorisation]));
    let [own_steps, steps] = seconds(|one| one.seconds(&[Stage::Iteration]));
    let (dofs, ratios) = (revolved.counts.dofs, [revolved, plane].map(|one| significant(one.ratio.median, 4)));
    format!(
        " Of {dofs} dofs the contact solve of the sphere takes {} times its plain solve, that of the cylinder {}: of \
        as many entries the plain solve takes {own_plain} there and {plain} here, its factorisation {own_factor} and \
        {factor}, while all else of the contact solve takes {own_rest} and {rest}, {own_steps} and {steps} of them \
        the iteration.",
        ratios[0], ratios[1]
    )
}

/// Who is compared on the front page: a name, whose points, and a colour.
pub type Compared = (&'static str, &'static [Series], Colour);

/// Ours on meshes that do not know where the contact ends, ours on meshes fitted to where it is found to end, and other
/// codes.
pub const COMPARED_CODES: [Compared; 5] = [
    ("ours, 8-node cells", &[Series::Quadratic, Series::SteepQuadratic], palette::NODE),
    ("ours, fitted", &[Series::Fitted], palette::INK),
    ("NGSolve", &[Series::Ngsolve], palette::SKY),
    ("scikit-fem", &[Series::ScikitFem], palette::PURPLE),
    ("dolfinx", &[Series::Dolfinx], palette::ORANGE),
];
/// Errors at which they are compared.
const ACCURACIES: [f64; 3] = [COMPARED, 1e-4, 1e-5];

/// The points of one that is compared to which none of its own is both as cheap and as exact.
pub fn front_of<'a>(record: &'a Record, series: &[Series]) -> Vec<&'a Point> {
    let own: Vec<&Point> = record.points.iter().filter(|point| series.contains(&point.series)).collect();
    front(&own, |point| point.seconds)
}

/// Who is the cheapest at each accuracy, from where on other codes are ahead of our cells that are not fitted, and what
/// each takes.
pub fn conclusion(record: &Record) -> String {
    let within = |points: &[&Point], most: f64| {
        cheapest(points.iter().copied(), Point::worst, most).map_or(f64::INFINITY, |point| point.seconds)
    };
    let fronts = COMPARED_CODES.map(|(_, series, _)| front_of(record, series));
    let fastest = ACCURACIES.map(|most| {
        let all = fronts.each_ref().map(|front| within(front, most));
        let least = (0..all.len()).min_by(|a, b| all[*a].total_cmp(&all[*b])).filter(|k| all[*k].is_finite());
        format!("**{}** to {}", least.map_or("nobody", |k| COMPARED_CODES[k].0), percent_of(most, 1))
    });
    let [own, _, others @ ..] = &fronts;
    let ahead = others.iter().zip(&COMPARED_CODES[2..]).filter_map(|(front, (name, ..))| {
        let ours = own.iter().filter(|point| within(front, point.worst()) >= point.seconds);
        let ours = ours.map(|point| point.worst()).fold(f64::INFINITY, f64::min);
        let least = front.iter().map(|point| point.worst()).fold(f64::INFINITY, f64::min);
        let from = if ours.is_finite() { format!("below {}", percent_of(ours, 2)) } else { "everywhere".into() };
        (least < ours).then(|| format!("{name} {from}, down to {}", percent_of(least, 2)))
    });
    let ahead: Vec<String> = ahead.collect();
    let ahead = match &ahead[..] {
        [] => "No other code is ahead of our 8-node cells.".into(),
        some => format!("Ahead of our 8-node cells are: {}.", some.join("; ")),
    };
    let head: Vec<String> = std::iter::once("worst error of p₀ and a")
        .chain(COMPARED_CODES.map(|(name, ..)| name))
        .map(String::from)
        .collect();
    let rows = ACCURACIES.map(|most| {
        let cells = fronts.iter().map(|front| told(front, most));
        std::iter::once(percent_of(most, 1)).chain(cells).collect::<Vec<_>>()
    });
    format!(
        "The fastest on truncated Hertz: {}. {ahead} Errors are the larger one of p₀ and a under the worst of {LOADS} \
        loads; – on no mesh that was tried. Theirs are {}.\n\n{}",
        fastest.join(", "),
        methods(record),
        markdown::table(&head, &rows)
    )
}

/// The other codes as they were timed: version and methods, of which the faster one counts.
fn methods(record: &Record) -> String {
    let told = |Beside { code, version, .. }: &Beside| {
        let by = match code {
            Series::Ngsolve => format!("({}) by an augmented Lagrangian and by a penalty", cells(*code)),
            _ => "by exact active sets and by a penalty".into(),
        };
        format!("{} {version} {by}", code.name())
    };
    record.measured.beside.iter().map(told).collect::<Vec<_>>().join(", ")
}

/// How many meshes each has.
fn tried(record: &Record) -> String {
    let told = |code: Series| {
        let (meshes, runs) = (meshes_of(code).len(), record.of(code).count());
        format!("{} {meshes} meshes in {} gradings by {} methods each", code.name(), STEEP.len(), runs / meshes)
    };
    let asked = Series::CODES.into_iter().filter(|code| record.of(*code).next().is_some()).map(told);
    format!("Ours are {}; of the others, {}.", ours_tried(), asked.collect::<Vec<_>>().join(", "))
}

/// What of another code's seconds is in its own assembly and in its own linear solver, on the mesh on which it is
/// compared; the rest is our Python.
fn of_their_own(record: &Record) -> String {
    let told = |code: Series| {
        let best = cheapest(record.of(code), Point::worst, COMPARED)?;
        let [assembly, linear] = [best.assembly?, best.linear?].map(|own| 100.0 * own / best.seconds);
        Some(format!(
            "{}'s {} {:.0} % are in its own assembly and {:.0} % in its own linear solver, {:.0} % in our Python \
            around them",
            code.name(),
            milliseconds(best.seconds),
            assembly,
            linear,
            100.0 - assembly - linear
        ))
    };
    let all: Vec<String> = Series::CODES.into_iter().filter_map(told).collect();
    if all.is_empty() {
        String::new()
    } else {
        format!(" To {} under the worst load, of {}.", percent(), all.join("; of "))
    }
}

/// The seconds of the cheapest of some points within an error, and the error that it has.
fn told(points: &[&Point], most: f64) -> String {
    let best = cheapest(points.iter().copied(), Point::worst, most);
    best.map_or("–".into(), |best| format!("{}, {} off", milliseconds(best.seconds), percent_of(best.worst(), 2)))
}

/// What our own solve took beside each of the other codes.
pub fn beside(record: &Record) -> Vec<String> {
    let own = ours(&record.points).map_or(f64::NAN, |own| own.seconds);
    let told = |Beside { code, version, seconds, machine }: &Beside| {
        format!(
            "Beside {} {version} ({}, {} threads, {}) our solve to {} under the median load took {}, and {} when our \
            points were recorded: {} times as long, by which its own seconds are divided here.",
            code.name(),
            machine.processor,
            machine.threads,
            machine.system,
            percent(),
            milliseconds(seconds.median),
            milliseconds(own),
            significant(seconds.median / own, 3)
        )
    };
    record.measured.beside.iter().map(told).collect()
}

/// The error to which codes are compared.
pub fn percent() -> String {
    percent_of(COMPARED, 1)
}

/// An error in per cent.
fn percent_of(error: f64, digits: usize) -> String {
    format!("{} %", significant(100.0 * error, digits))
}

/// Seconds in milliseconds.
pub fn milliseconds(seconds: f64) -> String {
    format!("{} ms", significant(1e3 * seconds, 2))
}

/// The chart of the front page, and what it shows.
pub const FRONTS: [&str; 2] = [
    "cost.svg",
    "Truncated Hertz: worst error of p₀ and a against seconds, ours and other codes, of each the runs that none of its \
    own beats; upright bars begin at the median of the loads",
];
/// The chart of all our points.
const CLOUD: [&str; 2] = [
    "work-precision.svg",
    "Truncated Hertz: all our runs by elements on meshes that do not know where the contact ends, against seconds and \
    counted operations",
];

/// Of each that is compared the runs that none of its own beats, its name at their end.
fn fronts(record: &Record) -> Drawing {
    let error = Axis::log("worst error of p₀ and a [%]");
    let title = format!("What accuracy costs: truncated Hertz under {LOADS} loads");
    let mut chart = Chart::new(&title, Axis::log("time from the scene to the pressures [s]"), error);
    for (name, series, colour) in COMPARED_CODES {
        let own = front_of(record, series);
        let place = |error: f64, point: &Point| (point.seconds, 100.0 * error);
        let points = own.iter().map(|point| place(point.worst(), point));
        chart.series.push(drawing::Series::new("", points, Style::run(colour, Dash::Solid, Marker::Circle)));
        let ends = own.iter().map(|point| [place(point.error(), point), place(point.worst(), point)]).collect();
        chart.bars.push(Bars { label: String::new(), ends, colour });
        // At the end that is farther from all others.
        let away = |point: &&&Point| {
            let others = COMPARED_CODES.iter().filter(|(other, ..)| *other != name);
            let each = others.flat_map(|(_, series, _)| front_of(record, series));
            each.map(|other| (other.seconds / point.seconds).ln().hypot((other.worst() / point.worst()).ln()))
                .fold(f64::INFINITY, f64::min)
        };
        let named = [own.first(), own.last()].into_iter().flatten().max_by(|a, b| away(a).total_cmp(&away(b)));
        chart.remarks.extend(named.map(|point| Remark {
            at: place(point.worst(), point),
            text: name.into(),
            ring: None,
            colour,
        }));
        chart.remarks.extend(cheapest(own, Point::worst, COMPARED).map(|point| Remark {
            at: place(point.worst(), point),
            text: milliseconds(point.seconds),
            ring: Some(format!("cheapest within {}", percent())),
            colour,
        }));
    }
    chart.guides.push(Guide { direction: Direction::Horizontal, at: 100.0 * COMPARED, label: percent() });
    chart.drawing()
}

/// What a run costs: the axis and the number.
type Cost = (&'static str, fn(&Point) -> f64);

const COSTS: [Cost; 2] = [
    ("time from the scene to the pressures [s]", |point| point.seconds),
    ("counted operations [floating-point operations]", |point| point.operations),
];

/// All our runs on meshes that do not know where the contact ends, a panel a cost.
fn cloud(record: &Record) -> Drawing {
    let points = sound(&record.points);
    let panel = |(axis, cost): Cost| {
        let mut chart = Chart::new("", Axis::log(axis), Axis::log("worst error of p₀ and a [%]"));
        let place = |point: &Point| (cost(point), 100.0 * point.worst());
        for (element, colour) in Element::ALL.into_iter().zip(palette::CURVES) {
            let names = Iteration::ALL.map(|algorithm| Some(Formulation::new(element, algorithm).name()));
            let own = points.iter().filter(|point| names.contains(&point.formulation)).map(|point| place(point));
            let label = format!("{} element, any algorithm and mesh", element.name());
            chart.series.push(drawing::Series::new(label, own, Style::run(colour, Dash::Absent, Marker::Dot)));
        }
        let front = front(&points, cost);
        let style = Style::run(palette::INK, Dash::Solid, Marker::Absent);
        let front = front.into_iter().map(place).collect::<Vec<_>>();
        chart.series.push(drawing::Series::new("Pareto front: none is cheaper and as exact", front, style));
        chart.guides.push(Guide { direction: Direction::Horizontal, at: 100.0 * COMPARED, label: percent() });
        chart
    };
    panels("All our runs on truncated Hertz", &COSTS.map(panel), 2)
}
