//! Whether error bars hold: random scenes whose truth is known on random meshes, and their true errors.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::accuracy::counted::Kind;
use crate::accuracy::longest::longest;
use crate::accuracy::{Barred, bars};
use crate::algorithm::StiffnessRule;
use crate::case::{self, Check, Judged, Reference};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series, panels};
use crate::error::Error;
use crate::markdown;
use crate::measure::{Quantity, larger};
use crate::mesh::{Order, Resolution};
use crate::scene::{Profile, Scene};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::drawn;
use crate::study::random::family::{self, FAMILIES, JUDGED};
use crate::study::random::{Draw, Family, Sample, Site, Truth};
use crate::study::records::{Millionths, Survey};

/// The survey.
pub const SURVEY: Survey<Site, Record> = Survey {
    name: "coverage",
    head,
    sites: || Ok(FAMILIES.into_iter().flat_map(family::unseen).collect()),
    key: Site::key,
    of: |record| record.site.key(),
    run: |site| Ok(vec![record(site)?]),
};

/// Fewest and most elements on half of the contact.
const ELEMENTS: [f64; 2] = [3.0, 30.0];
/// Growth of the elements along the surface, and into the depth.
const GROWTH: [[f64; 2]; 2] = [[1.2, 1.6], [1.2, 1.5]];
/// Candidate stretch over half of the contact.
const STRETCH: [f64; 2] = [1.3, 2.5];
/// Most candidate elements on a side: a contact far from s = 0 has them all the way from there.
const CANDIDATES: f64 = 160.0;
/// Of iterations that end early, the tolerance.
const EARLY: f64 = 1e-2;
/// Of those that end late.
const LATE: f64 = 1e-8;
/// Stiffness of penalties, over E*/a.
const PENALTY: [f64; 2] = [1e2, 1e4];
/// What tells the numbers of a mesh from those of the scene.
const SEED: u64 = 31_000_000;

/// Orders of cells, which go in turn.
const ORDERS: [Order; 2] = [Order::Linear, Order::Quadratic];

/// The cells that a scene is solved with.
pub(super) fn order(number: usize) -> Order {
    ORDERS[number % 2]
}

/// The contact element that a scene is solved with.
pub(super) fn element(number: usize) -> Element {
    Element::ALL[number / 2 % 3]
}

/// A random scene with its candidates and growth, its mesh and its formulation: order, element and the way to end go in
/// turn; all else is drawn. The contact ends within an element, but where the candidates end with it.
pub fn setup(site: &Site, sample: &Sample) -> (Scene, Resolution, Formulation) {
    let mut draw = Draw::new(SEED + 100_000 * site.family as u64 + site.number as u64);
    // The first number of a seed is like that of the next one.
    draw.between(0.0, 1.0);
    let mut scene = sample.scene.clone();
    let pair = &scene.contacts[0];
    let ends_there = matches!(pair.profile, Profile::Uniform(_) | Profile::Punch { .. });
    // A symmetric contact begins as far before s = 0 as it ends after it.
    let end = sample.end(0);
    let begin = Some(sample.truth(0, &Quantity::Begin(0))).filter(|begin| begin.is_finite()).unwrap_or(-end);
    let (half, outer) = (0.5 * (end - begin), end.max(-begin));
    let [fewest, most] = ELEMENTS;
    let most = most.min(CANDIDATES * half / (STRETCH[1] * outer)).max(fewest);
    let per = draw.decades(fewest.max(sample.fewest.min(most)), most);
    let elements = per.ceil();
    if !ends_there {
        let stretch = (draw.between(STRETCH[0], STRETCH[1]) * outer).min(longest(&scene, pair));
        scene.grading.unit = half * pair.path.metric() * elements / per;
        scene.contacts[0].stretch = stretch;
    }
    // Scenes whose elements are all alike stay so.
    if scene.grading.along > 1.0 {
        let [along, depth] = GROWTH.map(|[low, high]| draw.between(low, high));
        (scene.grading.along, scene.grading.depth) = (along, depth);
    }
    let turn = site.number;
    let formulation = Formulation::new(element(turn), Iteration::Kinematic);
    let formulation = match turn / 6 % 3 {
        0 => formulation.tolerance(LATE),
        1 => formulation.tolerance(EARLY),
        _ => Formulation {
            rule: StiffnessRule::Penalty,
            stiffness: draw.decades(PENALTY[0], PENALTY[1]),
            ..formulation.tolerance(LATE)
        },
    };
    (scene, Resolution { elements: elements as usize, refinement: 0, order: order(turn) }, formulation)
}

/// Kinds of numbers, and how many of each a scene has at most.
const KINDS: [(Kind, usize); 8] = [
    (Kind::Peak, 1),
    (Kind::Place, 1),
    (Kind::End, 5),
    (Kind::Moment, 3),
    (Kind::Force, 2),
    (Kind::Displacement, 3),
    (Kind::Shear, 2),
    (Kind::Depth, 2),
];

/// Numbers that a record has room for.
const NUMBERS: usize = 19;

/// Their kinds.
fn kinds() -> impl Iterator<Item = Kind> {
    KINDS.into_iter().flat_map(|(kind, most)| std::iter::repeat_n(kind, most))
}

/// The numbers of a scene, as many of each kind as it has: errors and bars over the size of such a number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The scene.
    pub site: Site,
    /// True errors; NaN where the run did not converge, infinite where what has no limit is quoted.
    pub errors: [Option<Millionths>; NUMBERS],
    /// Their bars; NaN where they are not known.
    pub bars: [Option<Millionths>; NUMBERS],
}

fn head() -> Vec<String> {
    let each = |what: &'static str| {
        let named = move |(kind, most): (Kind, usize)| (1..=most).map(move |k| format!("{} {k} {what}", kind.name()));
        KINDS.into_iter().flat_map(named)
    };
    ["family", "number"].map(String::from).into_iter().chain(each("error")).chain(each("bar")).collect()
}

impl Record {
    /// Its numbers by kind: error and bar.
    pub fn numbers(&self) -> impl Iterator<Item = (Kind, [f64; 2])> {
        let both = self.errors.iter().zip(&self.bars);
        kinds().zip(both).filter_map(|(kind, (error, bar))| Some((kind, [error.as_ref()?.0, bar.as_ref()?.0])))
    }
}

/// What errors of a number are relative to: the true peak, half-width, force or shear stress, the largest true
/// displacement.
fn size(sample: &Sample, Truth { quantity, value, .. }: &Truth) -> f64 {
    let true_one = |quantity| sample.truth(0, &quantity);
    match quantity {
        Quantity::PeakPressure | Quantity::Reaction { .. } | Quantity::Shear { .. } => value.abs(),
        Quantity::Resultant => *value,
        Quantity::Moment => true_one(Quantity::Resultant) * true_one(Quantity::SecondMomentWidth),
        Quantity::Displacement(_) | Quantity::Approach => {
            let own = sample.truths.iter().filter(|truth| Kind::of(&truth.quantity) == Kind::Displacement);
            own.map(|truth| truth.value.abs()).fold(0.0, f64::max)
        }
        _ => true_one(Quantity::SecondMomentWidth),
    }
}

/// The numbers of a scene whose truth is known, each with its bar, its true error, and what that is relative to; a run
/// that does not converge has none.
pub(super) fn barred(site: &Site) -> Result<Vec<(Barred, f64, f64)>, Error> {
    let (sample, found) = solved(site)?;
    let each = sample.truths.iter().filter_map(|truth| {
        let one = found.iter().find(|one| one.is_of(truth.contact, &truth.quantity))?;
        Some((one.clone(), (one.value - truth.value).abs(), size(&sample, truth)))
    });
    Ok(each.collect())
}

/// A scene solved on its random mesh: its truths, and its numbers with their bars; none of a run that does not
/// converge.
fn solved(site: &Site) -> Result<(Sample, Vec<Barred>), Error> {
    let sample = site.sample()?;
    let (scene, resolution, formulation) = setup(site, &sample);
    let discretisation = Discretisation::of(scene, resolution)?;
    // As it is told: without the peaks that are said to have no limit.
    let run = Run::of(&discretisation, &formulation)?.with_limits(&discretisation)?;
    let bars = bars(&discretisation, &run, &sample.displaced())?;
    let found = if run.solution.converged() { bars.all } else { Vec::new() };
    Ok((sample, found))
}

/// How far a number is from its truth; what has no limit must not be quoted.
pub fn error(value: f64, truth: f64) -> f64 {
    match truth.is_finite() {
        true => (value - truth).abs(),
        false => {
            if value.is_nan() {
                0.0
            } else {
                f64::INFINITY
            }
        }
    }
}

/// All numbers of a scene whose truth is known.
pub fn record(site: &Site) -> Result<Record, Error> {
    let (sample, all) = solved(site)?;
    let mut record = Record { site: *site, errors: [None; NUMBERS], bars: [None; NUMBERS] };
    for truth in &sample.truths {
        let is_of = |one: &&Barred| one.is_of(truth.contact, &truth.quantity);
        let [error, bar] = all.iter().find(is_of).map_or([f64::NAN; 2], |one| match truth.value.is_finite() {
            true => [error(one.value, truth.value), one.bar.total()],
            false => [error(one.value, truth.value), 0.0],
        });
        let size = if truth.value.is_finite() { size(&sample, truth) } else { 1.0 };
        let kind = Kind::of(&truth.quantity);
        let free = kinds().zip(&record.errors).position(|(own, error)| own == kind && error.is_none());
        let free = free.expect("no scene has more numbers of a kind than a record");
        (record.errors[free], record.bars[free]) = (Some(Millionths(error / size)), Some(Millionths(bar / size)));
    }
    Ok(record)
}

/// Errors and bars below are round-off, which no bar needs to follow, and which may differ.
pub const ROUND_OFF: f64 = 1e-7;

/// Errors and bars of the numbers that are meant.
pub fn meant(recorded: &[Record], is_meant: impl Fn(&Record, Kind) -> bool) -> Vec<[f64; 2]> {
    let of = |record| Record::numbers(record).filter(|(kind, _)| is_meant(record, *kind)).map(|(_, both)| both);
    recorded.iter().flat_map(of).collect()
}

/// Share of some errors within so many of their bars; one that is not known is outside, NaN of none.
pub fn share_within(numbers: &[[f64; 2]], bars: f64) -> f64 {
    numbers.iter().filter(|[error, bar]| *error <= bars * bar).count() as f64 / numbers.len() as f64
}

/// Errors up to which all may count as round-off: what is judged must not hang on which.
const CUTS: [f64; 4] = [1e-9, 1e-8, ROUND_OFF, 1e-6];

/// Median of bar over error, of errors above what counts as round-off; NaN where there is none.
fn median(numbers: &[[f64; 2]], round_off: f64) -> f64 {
    let above = numbers.iter().filter(|[error, _]| *error > round_off);
    let mut ratios: Vec<f64> = above.map(|[error, bar]| bar / error).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Share of errors that lie within their bars.
const SHARE: f64 = 0.95;
/// Bars beyond which hardly an error lies, and the share that may.
const BEYOND: f64 = 3.0;
const OUTLIERS: f64 = 1e-4;
/// Bars over errors in the median: a bar that is never needed says nothing.
const MEDIAN: f64 = 5.0;

/// The checks.
pub(super) fn judge(recorded: &[Record]) -> Vec<Judged> {
    vec![within(recorded), told(recorded), beyond(recorded), narrow(recorded)]
}

/// The numbers of each kind of each family on each kind of cells.
fn by_cells<'a>(recorded: &'a [Record], families: &'a [Family]) -> impl Iterator<Item = (String, Vec<[f64; 2]>)> + 'a {
    let groups = families.iter().flat_map(|&family| Kind::ALL.map(|kind| (family, kind)));
    let groups = groups.flat_map(|(family, kind)| ORDERS.map(|cells| (family, kind, cells)));
    groups.map(|(family, kind, cells)| {
        let is_own = |one: &Record, own| one.site.family == family && own == kind && order(one.site.number) == cells;
        let at = format!("{}, {}, {}-node cells", kind.title(), family.title(), cells.nodes_per_cell());
        (at, meant(recorded, is_own))
    })
}

/// The share of errors within their bars, an unknown one being outside, of each number of each family on each kind of
/// cells, where it is smallest.
pub fn within(recorded: &[Record]) -> Judged {
    let quantity = "share of the true errors within their bars, where it is smallest";
    let because = format!(
        "of each number of each of the first {} families on each kind of cells, an unknown bar being outside",
        JUDGED.len()
    );
    smallest(by_cells(recorded, JUDGED), |_| true, quantity, "closed forms", because)
}

/// Bodies of revolution whose bars are judged where they are told alone: the smallest share within them, one that is
/// unknown being outside.
pub fn of_revolution(recorded: &[Record]) -> String {
    let groups = by_cells(recorded, &[Family::Indented]).filter(|(_, own)| !own.is_empty());
    let shares = groups.map(|(at, own)| (share_within(&own, 1.0), at, own));
    let Some((share, at, own)) = shares.reduce(|a, b| if b.0 < a.0 { b } else { a }) else { return String::new() };
    let unknown = own.iter().filter(|[_, bar]| bar.is_nan()).count();
    format!(
        " Of {at}, where that is least, {:.1} % of the true errors lie within a bar that is known; {:.0} % are asked \
        of the first {} families; {unknown} of {} bars are not known.",
        100.0 * share,
        100.0 * SHARE,
        JUDGED.len(),
        own.len()
    )
}

/// The share of errors within the bars that are told, of each number of every family, where it is smallest; none told
/// is no share.
pub fn told(recorded: &[Record]) -> Judged {
    let groups = FAMILIES.into_iter().flat_map(|family| Kind::ALL.map(|kind| (family, kind)));
    let groups = groups.map(|(family, kind)| {
        let own = meant(recorded, |one, own| one.site.family == family && own == kind);
        (format!("{}, {}", kind.title(), family.title()), own)
    });
    let quantity = "share of the true errors within the bars that are told, where it is smallest";
    let because = "of each number of every family, on both kinds of cells together";
    smallest(groups, |[_, bar]| !bar.is_nan(), quantity, "closed forms and boundary methods", because)
}

/// The smallest share within their bars of the errors that count, which shall not be below [`SHARE`], of groups that
/// are not empty; one that is no number is the smallest.
fn smallest(
    groups: impl Iterator<Item = (String, Vec<[f64; 2]>)>,
    counts: fn(&[f64; 2]) -> bool,
    quantity: &'static str,
    truth: &str,
    because: impl Into<Cow<'static, str>>,
) -> Judged {
    let shares = groups.filter(|(_, own)| !own.is_empty()).map(|(at, mut own)| {
        own.retain(counts);
        (at, share_within(&own, 1.0))
    });
    let least = shares.reduce(|a, b| if b.1 < a.1 || b.1.is_nan() { b } else { a });
    let (at, share) = least.unwrap_or((String::new(), f64::NAN));
    Check::at_least(case::Quantity::at(quantity, at), Reference::analytic(truth, SHARE), because).judge(share)
}

/// Errors far outside the bars that are known.
pub fn beyond(recorded: &[Record]) -> Judged {
    let mut known = meant(recorded, |_, _| true);
    known.retain(|[_, bar]| !bar.is_nan());
    let quantity =
        case::Quantity::at(format!("share of the true errors beyond {BEYOND} bars"), "bars known of every family");
    let because = "a number so far outside would mislead whoever trusts its bar";
    let beyond = 1.0 - share_within(&known, BEYOND);
    Check::at_most(quantity, Reference::analytic("closed forms and boundary methods", OUTLIERS), because)
        .asked_of(known.len())
        .judge(beyond)
}

/// Bars are no wider than they need be, whatever counts as round-off.
pub fn narrow(recorded: &[Record]) -> Judged {
    let judged = of_judged(recorded);
    let quantity = case::Quantity::at(
        "largest median of bar over true error",
        format!("errors above {:e} to {:e} of {} families", CUTS[0], CUTS[CUTS.len() - 1], JUDGED.len()),
    );
    let because = "a bar that is never needed says nothing";
    Check::at_most(quantity, Reference::analytic("closed forms", MEDIAN), because)
        .asked_of(judged.len())
        .judge(widest(&judged))
}

/// Errors and bars of the families of which every bar is judged.
fn of_judged(recorded: &[Record]) -> Vec<[f64; 2]> {
    meant(recorded, |one, _| JUDGED.contains(&one.site.family))
}

/// The largest median of bar over error, of errors above any of the cuts.
fn widest(judged: &[[f64; 2]]) -> f64 {
    CUTS.map(|cut| median(judged, cut)).into_iter().fold(0.0, larger)
}

/// A row of the table: scenes, number, and its errors and bars on all cells, on those of 4 and on those of 8 nodes.
type Row = (&'static str, &'static str, [Vec<[f64; 2]>; 3]);

/// The table of errors and bars.
const COLUMNS: [markdown::Column<Row>; 7] = [
    ("scenes", |(scenes, ..)| scenes.to_string()),
    ("number", |(_, number, _)| number.to_string()),
    ("numbers", |(.., [all, ..])| all.len().to_string()),
    ("within, 4-node", |(.., [_, four, _])| percent(four)),
    ("within, 8-node", |(.., [.., eight])| percent(eight)),
    ("bar over error, median", |(.., [all, ..])| match median(all, ROUND_OFF) {
        none if none.is_nan() => "–".into(),
        median => markdown::significant(median, 2),
    }),
    ("largest error over bar", |(.., [all, ..])| {
        // The truth of a peak at a corner has no limit, and its bar is infinite.
        let known = all.iter().filter(|[error, bar]| *error > 0.0 && error.is_finite() && !bar.is_nan());
        let worst = known.map(|[error, bar]| error / bar).reduce(larger);
        let worst = worst.map_or("–".into(), |worst| markdown::significant(worst, 2));
        let unknown = all.iter().filter(|[_, bar]| bar.is_nan()).count();
        let endless = all.iter().filter(|[error, bar]| error.is_infinite() && bar.is_finite()).count();
        let others = [(unknown, "not known"), (endless, "without a limit, but with a bar")].into_iter();
        let others = others.filter(|(number, _)| *number > 0).map(|(number, told)| format!("; {number} {told}"));
        worst + &others.collect::<String>()
    }),
];

/// Share within the bars, an unknown one being outside; where some are, also that of the others.
fn percent(numbers: &[[f64; 2]]) -> String {
    let share = |numbers: &[[f64; 2]]| format!("{:.1} %", 100.0 * share_within(numbers, 1.0));
    let known: Vec<[f64; 2]> = numbers.iter().copied().filter(|[_, bar]| !bar.is_nan()).collect();
    match known.len() {
        _ if numbers.is_empty() => "–".into(),
        all if all == numbers.len() => share(numbers),
        0 => share(numbers),
        _ => format!("{}; {} of the known", share(numbers), share(&known)),
    }
}

/// The section: shares by family and number.
pub(super) fn section(recorded: &[Record]) -> String {
    let families = std::iter::once(None).chain(FAMILIES.map(Some));
    let rows = families.flat_map(|family| Kind::ALL.map(|kind| (family, kind, kind.title())));
    let row = |(family, kind, name): (Option<Family>, Kind, &'static str)| {
        let is_own = |one: &Record, own: Kind| own == kind && family.is_none_or(|family| one.site.family == family);
        let of = |cells: Order| meant(recorded, |one, own| is_own(one, own) && order(one.site.number) == cells);
        let [four, eight] = ORDERS.map(of);
        (family.map_or("**all**", Family::title), name, [meant(recorded, is_own), four, eight])
    };
    let rows: Vec<Row> = rows.map(row).filter(|(.., [all, ..])| !all.is_empty()).collect();
    let [fewest, most] = ELEMENTS;
    format!(
        include_str!("bars.md"),
        fewest = fewest,
        most = most,
        found = markdown::significant(widest(&of_judged(recorded)), 3),
        cuts = CUTS.map(|cut| format!("{cut:e}")).join(", "),
        limit = MEDIAN,
        families = JUDGED.len(),
        named = JUDGED.iter().map(|family| family.title()).collect::<Vec<_>>().join(", "),
        surveyed = SURVEY.told(recorded),
        chart = drawn::picture(
            "coverage.svg",
            "True error against the bar claimed: in each range of bars the median, the 95th of 100 and the largest \
            error; below the diagonal a bar holds; errors that are round-off are left out"
        ),
        revolved = of_revolution(recorded),
        table = markdown::columns(&COLUMNS, &rows)
    ) + "\n"
}

/// Numbers that have a panel: errors of the others are mostly round-off.
const SHOWN: [Kind; 3] = [Kind::Peak, Kind::Moment, Kind::End];
/// Ends of both axes.
const RANGE: [f64; 2] = [1e-5, 1.0];
/// Ranges of bars in a decade.
const PER_DECADE: f64 = 4.0;
/// Fewest errors of which quantiles are drawn.
const FEWEST: usize = 20;

/// True error against the bar claimed.
pub(super) fn picture(recorded: &[Record]) -> (String, Drawing) {
    let shown = SHOWN.map(|kind| panel(kind.title(), &meant(recorded, |_, own| own == kind)));
    ("coverage.svg".into(), panels("True error against the bar claimed", &shown, 3))
}

fn panel(name: &str, numbers: &[[f64; 2]]) -> Chart {
    let axis = |label: &str| Axis::log(label).over(RANGE[0], RANGE[1]);
    let mut chart = Chart::new(name, axis("bar, relative [–]"), axis("true error, relative [–]"));
    let quantiles = [
        ("largest", 1.0, palette::LINE, Dash::Solid, Marker::Diamond),
        ("95 of 100", 0.95, palette::NODE, Dash::Solid, Marker::Circle),
        ("median", 0.5, palette::LAYER, Dash::Dashed, Marker::Square),
    ];
    for (label, share, colour, dash, marker) in quantiles {
        chart.series.push(Series::new(label, curve(numbers, share), Style::run(colour, dash, marker)));
    }
    chart.series.push(Series::new("error = bar", RANGE.map(|end| (end, end)), Style::reference()));
    chart
}

/// In each range of bars the error that a share of the errors is not above.
fn curve(numbers: &[[f64; 2]], share: f64) -> Vec<(f64, f64)> {
    let [low, high] = RANGE.map(|end| (PER_DECADE * end.log10()).round() as i32);
    let edge = |k: i32| 10f64.powf(f64::from(k) / PER_DECADE);
    let point = |k: i32| {
        let above = numbers.iter().filter(|[error, _]| *error > ROUND_OFF);
        let own = above.filter(|[_, bar]| edge(k) <= *bar && *bar < edge(k + 1));
        let mut errors: Vec<f64> = own.map(|[error, _]| *error).collect();
        errors.sort_by(f64::total_cmp);
        let rank = (share * errors.len() as f64).ceil() as usize;
        let error = errors.get(rank.max(1) - 1).copied().filter(|_| errors.len() >= FEWEST);
        error.filter(|error| *error >= RANGE[0]).map(|error| (edge(k) * edge(1).sqrt(), error))
    };
    (low..high).filter_map(point).collect()
}
