//! Speed against accuracy: what each accuracy costs, in seconds and in counted work. Seconds are believed only while the errors and
//! counts recorded beside them are still the code's own: these are computed again. A folder, since what measures seconds, what keeps
//! them and what computes errors and counts again with every report are three things.
//!
//! * `precision` — on which meshes truncated Hertz is solved; error against seconds and work, ours and of codes on meshes of their own.
//! * `growth` — one solve at three sizes, stage by stage, against one plain sparse Cholesky solve; all nine formulations over one.
//! * `record` — what is kept under `snapshots/timings`, measured on demand by the command `timings`, and what of it is cheapest.
//! * `targets` — what was asked for, and what was measured.
//!
//! Below are the trials, the page, the sentence of the front page, and its chart: the worst error of
//! p₀ and a under all loads against seconds and counted work.

pub mod growth;
pub mod precision;
pub mod record;
pub mod targets;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::clock::Stage;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Axis, Bars, Chart, Colour, Direction, Drawing, Guide, Remark, panels};
use crate::error::Error;
use crate::markdown::{self, Column, significant};
use crate::mesh::Order;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::drawn::picture;
use crate::study::timings::growth::{Counts, Growth, exponent};
use crate::study::timings::precision::{LOADS, Point, Series, TOLERANCE, cells};
use crate::study::timings::record::{Beside, MEASURES, Measure, Record, cheapest, front, sound};
use crate::study::timings::targets::{COMPARED, NOT_ASKED, Target, ours, targets};

/// Name of the trials.
const CASE: &str = "speed against accuracy";
/// Recorded errors may differ from recomputed ones by this share: other machines round otherwise, and runs stop at 1e-5.
const DIGITS: f64 = 1e-3;
/// Degrees of freedom up to which iterations and entries of the factor are counted again.
const RECOUNTED: usize = 200_000;

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Error against work on a series of meshes.
    Precision(Again<Point>),
    /// Counts of the growth with the mesh.
    Growth(Again<Counts>),
}

impl Study for Numbers {
    const NAME: &'static str = "timings";
    const ABOUT: About = About {
        title: "Speed against accuracy",
        asked: "What an accuracy costs, in seconds and in counted work, here and in other codes.",
        limits: "Seconds are those of one machine. Errors and counts are computed again with every report, seconds are not.",
    };

    /// One trial a series of our meshes, one for the growth.
    fn plan() -> Vec<Planned<Self>> {
        let precision = |series: Series| Planned::new(CASE, series.name(), move || again(series));
        Series::OURS.into_iter().map(precision).chain([Planned::new(CASE, "growth", recounted)]).collect()
    }

    /// The check of a trial.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(vec![match self {
            Numbers::Precision(points) => as_recorded(
                "point whose errors or counts are not those recorded with its seconds",
                format!(
                    "every mesh is computed again; errors within {DIGITS:e}, which the tolerance of the runs leaves; `timings` renews the record"
                ),
                points,
                is_same,
            ),
            Numbers::Growth(counts) => as_recorded(
                "mesh whose degrees of freedom, iterations or operations are not those recorded with its seconds",
                "exact counts; `timings` renews the record".into(),
                counts,
                Counts::eq,
            ),
        }])
    }

    /// The page of the committed record.
    fn section(_: &[Found<Self>]) -> Result<String, Error> {
        Ok(page(&Record::read()?))
    }

    /// The chart of the committed record.
    fn pictures(_: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        Ok(vec![("work-precision.svg".into(), chart(&Record::read()?))])
    }
}

/// What is recorded, and what of it is computed again.
#[derive(Clone, Debug)]
pub struct Again<T> {
    /// As recorded.
    pub recorded: Vec<T>,
    /// As they are now: all points, and the counts of the smaller meshes.
    pub fresh: Vec<T>,
    /// How many shall be recorded.
    pub planned: usize,
}

/// Every mesh of a series once more.
fn again(series: Series) -> Result<Numbers, Error> {
    let recorded = Record::read()?.of(series).cloned().collect();
    let planned = series.meshes().len() * series.formulations().len();
    let fresh = series.meshes().iter().map(|mesh| precision::measure(series, *mesh));
    let fresh = fresh.collect::<Result<Vec<_>, _>>()?.concat();
    Ok(Numbers::Precision(Again { recorded, fresh, planned }))
}

/// The smaller meshes of the growth once more.
fn recounted() -> Result<Numbers, Error> {
    let recorded: Vec<Counts> = Record::read()?.measured.growth.into_iter().map(|one| one.counts).collect();
    let kept = recorded.iter().filter(|counts| counts.dofs <= RECOUNTED);
    let fresh = kept.map(|kept| growth::counts(kept.elements, kept.refinement)).collect::<Result<_, _>>()?;
    Ok(Numbers::Growth(Again { recorded, fresh, planned: growth::MESHES.len() }))
}

/// How many are not recorded as they are now; not a number where something is missing.
fn as_recorded<T>(what: &'static str, because: String, again: &Again<T>, is_same: fn(&T, &T) -> bool) -> Judged {
    let Again { recorded, fresh, planned } = again;
    let moved = fresh.iter().filter(|fresh| !recorded.iter().any(|kept| is_same(kept, fresh))).count();
    let complete = !fresh.is_empty() && recorded.len() == *planned;
    let quantity = Quantity::at(what, format!("of {}", fresh.len()));
    let check = Check::at_most(quantity, Reference::own("snapshots/timings", 0.0), because);
    check.judge(if complete { moved as f64 } else { f64::NAN })
}

/// Whether two points are of the same mesh and formulation, with the same errors and counts; seconds are not compared.
fn is_same(kept: &Point, fresh: &Point) -> bool {
    let exact = |one: &Point| (one.series, one.mesh, one.formulation.clone(), one.dofs, one.converged);
    let numbers = |one: &Point| [one.operations, one.peak, one.peak_worst, one.half_width, one.half_width_worst];
    exact(kept) == exact(fresh) && numbers(kept).into_iter().zip(numbers(fresh)).all(|(a, b)| near(a, b))
}

fn near(a: f64, b: f64) -> bool {
    (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + 1e-9
}

/// What a parabola misses of the top of `√(1 − x²/a²)`, fitted by least squares to x < a/4: its next term is x⁴/8a⁴, and the best
/// parabola for x⁴ on 0 to h is at 0 off by 3h⁴/35.
const PARABOLA: f64 = 3.0 / 35.0 / 8.0 * (0.25 * 0.25 * 0.25 * 0.25);

/// Columns of the table of targets.
const ASKED: [Column<Target>; 4] = [
    ("what", |target| target.what.clone()),
    ("asked for", |target| target.asked.clone()),
    ("measured", |target| target.measured.clone()),
    ("met", |target| target.met.map_or("–", |met| if met { "✓" } else { "✗" }).into()),
];

/// The page of a record.
pub fn page(record: &Record) -> String {
    let asked = markdown::columns(&ASKED, &targets(record));
    [machine(record), asked, precision(), growth(record)].concat()
}

fn machine(record: &Record) -> String {
    let machine = &record.measured.machine;
    let versions: Vec<String> = machine.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let text = format!(
        "Seconds and ratios are the record of one machine ({}, {} threads, {}; {}; {}), on one thread unless said otherwise; \
         `cargo run --release -- timings` renews it. Ratios are medians of runs by turns in one process. The *plain solve* is one \
         sparse Cholesky solve of the same matrix by faer's own high-level solver with its default ordering, the *contact solve* \
         everything from the assembled matrix to the full displacement: ordering, factorisation, Schur complement, all iterations \
         of node + kinematic load, recovery. Errors and counts beside the seconds are computed again with every report.\n\n",
        machine.processor,
        machine.threads,
        machine.system,
        machine.compiler,
        versions.join(", ")
    );
    let skipped = record.measured.absent.iter().map(|(code, why)| format!("Skipped: {code}: {why}.\n\n"));
    let beside = beside(record).into_iter().map(|sentence| sentence + "\n\n");
    text + &skipped.chain(beside).collect::<String>()
}

fn precision() -> String {
    let text = format!(
        "\n## Error against seconds and work\n\nThe mesh does not know the answer: it is graded for a nominal half-width, and {LOADS} loads \
         move the contact edge across one of its elements. Finding the contact is part of the cost. All runs to the tolerance \
         {TOLERANCE:e}. The other codes solve on meshes and by methods of their own: scikit-fem by exact active sets, dolfinx by a penalty, \
         NGSolve ({}) by an augmented Lagrangian. No mesh of theirs knows where the contact ends. scikit-fem and dolfinx read p₀ by a parabola over a quarter of the \
         half-width, which leaves {} of Hertz's ellipse even where the pressure is exact; NGSolve's is read with a term in x⁴, so that its \
         error is free of that.\n\n",
        cells(Series::Ngsolve),
        significant(PARABOLA, 1)
    );
    let caption = "Truncated Hertz: worst error of peak and second-moment width against seconds and counted operations";
    text + &picture("work-precision.svg", caption)
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
    format!(
        "## Growth\n\nThe cylinder by node + kinematic load, one thread. A boundary method needs far fewer unknowns for Hertz itself: this is \
         the price of a method that takes any body.\n\n{}\nNested dissection of a plane mesh of n nodes leads to n^1.5 operations (George \
         1973): the time of a direct method grows slower only as long as something else takes most of it.\n\n",
        markdown::table(&head, &rows),
    )
}

/// The cheapest run of each code that keeps the error in both quantities under every load.
pub fn conclusion(record: &Record) -> String {
    let best = |points: Vec<&Point>| cheapest(points, |point| point.seconds, Point::worst, COMPARED).cloned();
    let own = best(sound(&record.points)).map(|Point { series, seconds, formulation, mesh, dofs, .. }| {
        let formulation = formulation.unwrap_or_default();
        let (told, nodes) = (milliseconds(seconds), series.order().map_or(0, Order::nodes_per_cell));
        format!("ours {told} ({formulation}, {nodes}-node cells, {mesh} per half-width, {dofs} dofs)")
    });
    let theirs = Series::CODES.map(|code| match best(record.of(code).collect()) {
        Some(best) => format!("{} {} ({} dofs)", code.name(), milliseconds(best.seconds), best.dofs),
        None if record.of(code).next().is_some() => format!("{} on none of its meshes", code.name()),
        None => format!("{} {NOT_ASKED}", code.name()),
    });
    let own = own.unwrap_or("ours on no mesh".into());
    format!("Within {} in p₀ and a under each of the {LOADS} loads: {own}; {}.", percent(), theirs.join("; "))
}

/// What our own solve took beside each of the other codes.
pub fn beside(record: &Record) -> Vec<String> {
    let own = ours(&record.points).map_or(f64::NAN, |own| own.seconds);
    let told = |Beside { code, version, seconds, machine }: &Beside| {
        format!(
            "Beside {} {version} ({}, {} threads, {}) our solve to {} took {} against {} in the chart: its seconds compare with ours by the \
             ratio to these alone.",
            code.name(),
            machine.processor,
            machine.threads,
            machine.system,
            percent(),
            milliseconds(seconds.median),
            milliseconds(own)
        )
    };
    record.measured.beside.iter().map(told).collect()
}

/// The error to which codes are compared.
pub fn percent() -> String {
    format!("{} %", 100.0 * COMPARED)
}

/// Seconds in milliseconds.
pub fn milliseconds(seconds: f64) -> String {
    format!("{} ms", significant(1e3 * seconds, 2))
}

/// What a run costs: the axis, the number, and how it is told with its unit.
type Cost = (&'static str, fn(&Point) -> f64, fn(f64) -> String);

const SECONDS: Cost = ("time from the scene to the pressures [s]", |point| point.seconds, milliseconds);
const OPERATIONS: Cost = (
    "counted operations [floating-point operations]",
    |point| point.operations,
    |count| format!("{} million", significant(1e-6 * count, 2)),
);

/// Truncated Hertz, whose answer is known, beside meshes fitted to the contact and codes on meshes of their own.
pub fn chart(record: &Record) -> Drawing {
    let mut charts = charts(record);
    for (chart, measure) in charts.iter_mut().step_by(2).zip(MEASURES) {
        let style = Style::run(palette::INK, Dash::Dashed, Marker::Square);
        let label = "node element, high order, fitted to the contact it finds".into();
        curve(chart, label, style, record.of(Series::Fitted).collect(), SECONDS, measure);
        others(chart, record, measure);
    }
    panels(&format!("What accuracy costs: truncated Hertz, worst error under {LOADS} loads"), &charts, 2)
}

/// A row a quantity, a column a cost: ours, and what is cheapest.
fn charts(record: &Record) -> Vec<Chart> {
    let points = sound(&record.points);
    let both = |measure: Measure| [SECONDS, OPERATIONS].map(|cost| own(&points, measure, cost));
    MEASURES.into_iter().flat_map(both).collect()
}

fn own(points: &[&Point], measure @ (name, errors): Measure, cost: Cost) -> Chart {
    let (axis, value, _) = cost;
    let worst = |point: &Point| errors(point)[1];
    let mut chart = Chart::new(name, Axis::log(axis), Axis::log("worst relative error [%]"));
    for (element, colour) in Element::ALL.into_iter().zip(palette::CURVES) {
        let names = Iteration::ALL.map(|algorithm| Some(Formulation::new(element, algorithm).name()));
        let own = points.iter().filter(|point| names.contains(&point.formulation));
        let label = format!("{} element, any algorithm and mesh", element.name());
        let points = own.map(|point| (value(point), 100.0 * worst(point)));
        chart.series.push(drawing::Series::new(label, points, Style::run(colour, Dash::Absent, Marker::Dot)));
    }
    let label = "Pareto front: none is cheaper and as exact".into();
    let style = Style::run(palette::INK, Dash::Solid, Marker::Absent);
    curve(&mut chart, label, style, front(points, value, &worst), cost, measure);
    chart.guides.push(Guide { direction: Direction::Horizontal, at: 100.0 * COMPARED, label: percent() });
    remark(&mut chart, points.iter().copied(), cost, measure, false, palette::INK);
    chart
}

/// A curve through the worst errors of some points, with bars from their medians; nothing where there is no point.
fn curve(
    chart: &mut Chart,
    label: String,
    style: Style,
    mut points: Vec<&Point>,
    (_, cost, _): Cost,
    (_, errors): Measure,
) {
    if points.is_empty() {
        return;
    }
    points.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let ends: Vec<_> = points.iter().map(|point| errors(point).map(|error| (cost(point), 100.0 * error))).collect();
    chart.series.push(drawing::Series::new(label, ends.iter().map(|[_, worst]| *worst), style));
    let label = format!("upright bar: median to worst of {LOADS} loads");
    chart.bars.push(Bars { label, ends, colour: style.colour });
}

/// What the cheapest of some points within the compared error costs.
fn remark<'a>(
    chart: &mut Chart,
    points: impl IntoIterator<Item = &'a Point>,
    (_, cost, told): Cost,
    (_, errors): Measure,
    right: bool,
    colour: Colour,
) {
    let worst = |point: &Point| errors(point)[1];
    if let Some(point) = cheapest(points, cost, worst, COMPARED) {
        let label = format!("cheapest within {}", percent());
        let (at, text) = ((cost(point), 100.0 * worst(point)), told(cost(point)));
        chart.remarks.push(Remark { at, text, right, label, colour });
    }
}

/// Codes that ran under all loads, on meshes of their own.
fn others(chart: &mut Chart, record: &Record, measure: Measure) {
    let looks = [
        (Series::ScikitFem, palette::PURPLE, Marker::Triangle),
        (Series::Dolfinx, palette::ORANGE, Marker::Wedge),
        (Series::Ngsolve, palette::SKY, Marker::Diamond),
    ];
    for (code, colour, marker) in looks {
        let (label, style) = (format!("{}, {}", code.name(), cells(code)), Style::run(colour, Dash::DashDot, marker));
        curve(chart, label, style, record.of(code).collect(), SECONDS, measure);
        remark(chart, record.of(code), SECONDS, measure, code != Series::ScikitFem, colour);
    }
}
