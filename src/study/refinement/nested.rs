//! Nested meshes: the orders by which errors of truncated Hertz fall, pair by pair, and what the series of the pin–rod
//! says of its limit.

use crate::case::library::{PinRod, TruncatedHertz};
use crate::case::{Check, Judged, Quantity, Reference, covered};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series as Drawn, Slope};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::order::{Observed, Richardson, Why, of_changes, pairs, richardson};
use crate::measure::{larger, profile, relative_error, whole};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::{Discretisation, Formulation, Run};
use crate::uncertainty::{COVERAGE, Comparison};

/// Elements of the coarsest mesh: per half-width of truncated Hertz, per 10 mm of arc of the pin–rod.
const COARSEST: [usize; 2] = [4, 8];
/// Nested meshes.
const LEVELS: u32 = 4;

/// Nested meshes of cells of one order.
#[derive(Clone, Debug)]
pub struct Series {
    /// Order of the cells.
    pub order: Order,
    /// Coarse to fine.
    pub levels: Vec<Level>,
}

/// What is found on one of them; NaN where the run did not converge.
#[derive(Clone, Debug)]
pub struct Level {
    /// Elements per half-width, or per 10 mm of arc.
    pub elements: usize,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Of truncated Hertz the relative error of the pressure of the centre node, of the pin–rod the peak pressure
    /// \[MPa\].
    pub peak: f64,
    /// Of truncated Hertz the relative error of the second-moment width, of the pin–rod the half-angle by second moment
    /// \[rad\].
    pub width: f64,
    /// Relative error of the profile in L2; NaN without a closed form.
    pub l2: f64,
    /// Where the contact ends: from the nearest node outwards \[elements\].
    pub edge: f64,
}

impl Level {
    /// Mesh size h/a.
    fn size(&self) -> f64 {
        1.0 / self.elements as f64
    }
}

impl Series {
    /// Observed orders of an error, between each two successive meshes; the assembled load, or the tolerance of the
    /// iteration if that is larger, is what no mesh removes.
    fn orders(&self, load: f64, error: fn(&Level) -> f64) -> Vec<Observed> {
        let sizes: Vec<f64> = self.levels.iter().map(Level::size).collect();
        let floor = larger(load, Formulation::verification().settings.tolerance);
        pairs(&sizes, &self.values(error), floor)
    }

    /// Observed orders of a number, between each two successive changes.
    fn changes(&self, of: fn(&Level) -> f64) -> Vec<Observed> {
        of_changes(&self.values(of))
    }

    /// What the three finest meshes say of the limit of a number.
    fn limit(&self, of: fn(&Level) -> f64) -> Richardson {
        let finest: Option<[f64; 3]> = self.values(of).last_chunk().copied();
        richardson(finest.unwrap_or([f64::NAN; 3]))
    }

    fn values(&self, of: fn(&Level) -> f64) -> Vec<f64> {
        self.levels.iter().map(of).collect()
    }

    fn cells(&self) -> String {
        format!("{}-node", self.order.nodes_per_cell())
    }
}

/// A scene on the nested meshes.
fn runs(scene: &Scene, elements: usize, order: Order) -> Result<Vec<(Discretisation, Run)>, Error> {
    let run = |refinement| {
        let made = Discretisation::of(scene.clone(), Resolution { elements, refinement, order })?;
        let run = Run::of(&made, &Formulation::verification())?;
        Ok((made, run))
    };
    (0..LEVELS).map(run).collect()
}

/// What a run found; NaN, which no check passes, of one that did not converge.
fn level(run: &Run, elements: usize, [peak, width, l2]: [f64; 3]) -> Level {
    let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
    let end = run.measures().edge();
    let nodes = run.solution.edges.iter().flat_map(|edge| edge.ends.map(|node| (end - node) / edge.length()));
    let edge = nodes.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(f64::NAN);
    let [peak, width, l2, edge] = [peak, width, l2, edge].map(converged);
    Level { elements, dofs: run.dofs, peak, width, l2, edge }
}

/// Errors of truncated Hertz, and the largest one of the assembled load.
pub fn truncated(order: Order) -> Result<(Series, f64), Error> {
    let numbers = TruncatedHertz::default();
    let (hertz, load) = (numbers.closed_form(), numbers.load());
    let runs = runs(&numbers.scene(), COARSEST[0], order)?;
    let levels = runs.iter().enumerate().map(|(k, (_, run))| {
        let measures = run.measures();
        let errors = [
            measures.largest.pressure / hertz.peak_pressure() - 1.0,
            measures.second_moment_width / hertz.half_width() - 1.0,
            profile::relative_l2(&run.solution.points, |x| hertz.pressure(x), 1.5 * hertz.half_width()),
        ];
        level(run, COARSEST[0] << k, errors)
    });
    let loads = runs.iter().map(|(made, _)| {
        let assembled = whole(made.scene.contact()) * made.system.bodies[0].applied_vertical().abs();
        relative_error(assembled, load)
    });
    Ok((Series { order, levels: levels.collect() }, loads.fold(0.0, larger)))
}

/// The pin–rod by both orders, which has no closed form, and the difference of their profiles on the finest mesh.
pub fn pin_rod() -> Result<([Series; 2], f64), Error> {
    let scene = PinRod::default().scene();
    let both = [Order::Linear, Order::Quadratic].map(|order| {
        let runs = runs(&scene, COARSEST[1], order)?;
        let levels = runs.iter().enumerate().map(|(k, (_, run))| {
            let measures = run.measures();
            level(run, COARSEST[1] << k, [measures.peak.pressure, measures.second_moment_width, f64::NAN])
        });
        let series = Series { order, levels: levels.collect() };
        let finest = runs.into_iter().next_back().map(|(_, run)| run.solution.edges).unwrap_or_default();
        Ok::<_, Error>((series, finest))
    });
    let [linear, quadratic] = both;
    let ((linear, coarser), (quadratic, finer)) = (linear?, quadratic?);
    Ok(([linear, quadratic], profile::relative_l2_between(&coarser, &finer)))
}

/// What is below the formal order and passes: pairs approach it from both sides.
const SLACK: f64 = 0.1;
/// Relative standard uncertainty that a series of the pin–rod may have.
const OWN: f64 = 7e-4;
/// How near the limits of both orders of cells must come.
const LIMITS: f64 = 3.5e-4;

/// The order between each two successive meshes reaches the formal one; one that is withheld does not.
pub fn judge_orders(series: &Series, load: f64) -> Vec<Judged> {
    let reaches = |name: &'static str, formal: f64, because: &'static str, of: fn(&Level) -> f64| {
        let pairs = series.levels.windows(2).zip(series.orders(load, of));
        let judged = pairs.map(|(two, pair)| {
            let quantity = Quantity::at(name, format!("h/a = {} to {}", two[0].size(), two[1].size()));
            let formal = Reference::analytic(&format!("formal order {formal}, a tenth less"), formal - SLACK);
            Check::at_least(quantity, formal, because).judge(pair.value())
        });
        judged.collect::<Vec<_>>()
    };
    let peak =
        reaches("observed order of the pressure of the centre node", 2.0, "every pair of meshes", |level| level.peak);
    let width = match series.order {
        Order::Linear => below_second_order(series, load),
        _ => reaches("observed order of the second-moment width", 2.0, "the edge lies on a node", |level| level.width),
    };
    let edge = "square-root edge (Drouet & Hild 2015; Belhachmi & Ben Belgacem 2003): capped near 1";
    let profile = reaches("observed order of the pressure profile in L2", 1.0, edge, |level| level.l2);
    let hertz = Reference::analytic("Hertz", 0.0);
    let assembled =
        Check::error("largest error of the assembled load", hertz, 1e-7, "16-point Gauss on every edge").judge(load);
    [peak, width, profile, vec![assembled]].concat()
}

/// Without an order that could be read, the half-width must lie below a line of second order on every mesh.
///
/// A pressure that stands for its surroundings of length h has the error `h²/24` of the midpoint rule.
fn below_second_order(series: &Series, load: f64) -> Vec<Judged> {
    let pairs = series.orders(load, |level| level.width);
    let because = if pairs.into_iter().all(|pair| matches!(pair, Observed::Order(_))) {
        "the midpoint rule's h²/24"
    } else {
        "the midpoint rule's h²/24; errors that change their sign or do not fall have no order"
    };
    let judged = series.levels.iter().map(|level| {
        let quantity = Quantity::at("error of the second-moment width over (h/a)²", format!("h/a = {}", level.size()));
        Check::error(quantity, Reference::analytic("Hertz", 0.0), 1.0 / 24.0, because)
            .judge(level.width.abs() / level.size().powi(2))
    });
    judged.collect()
}

/// The pin–rod has no closed form: its refinement series gives its own uncertainty.
pub fn judge_pin_rod(both: &[Series; 2], difference: f64) -> Vec<Judged> {
    type Named = (&'static str, fn(&Level) -> f64);
    let numbers: [Named; 2] =
        [("peak [MPa]", |level| level.peak), ("second-moment angle [°]", |level| level.width.to_degrees())];
    let own = both.iter().flat_map(|series| {
        numbers.map(|(name, of)| {
            let at = format!("{name}, {}", series.cells());
            let quantity = Quantity::at("relative standard uncertainty of the pin–rod on the finest mesh", at);
            let because = "three finest of four nested meshes, standard";
            let limit = series.limit(of);
            Check::error(quantity, Reference::own("Richardson", 0.0), OWN, because)
                .judge(limit.uncertainty() / limit.limit.abs())
        })
    });
    let [linear, quadratic] = both;
    let limits = numbers.into_iter().flat_map(|(name, of)| one_limit(name, linear.limit(of), quadratic.limit(of)));
    let curve = Check::error(
        "difference of the profile of 4-node cells in L2",
        Reference::own("8-node", 0.0),
        6e-3,
        "edge means on the finest mesh; the contact edge moves by a fraction of an element",
    );
    own.chain(limits).chain([curve.judge(difference)]).collect()
}

/// Both orders of cells tend to one limit: near each other, and within what their own uncertainties cover.
pub fn one_limit(name: &str, linear: Richardson, quadratic: Richardson) -> [Judged; 2] {
    let sources = [linear.uncertainty(), quadratic.uncertainty()];
    let reference = || {
        let reference = Reference::own("8-node, limit", quadratic.limit);
        Reference { uncertainty: Some(sources[1]), ..reference }
    };
    let because = format!("three finest of four nested meshes; {COVERAGE} u_val is asked beside it");
    let near = Check::near(Quantity::at("limit of 4-node cells", name), reference(), LIMITS, because);
    let near = Judged { uncertainty: Some(sources[0]), ..near.judge(linear.limit) };
    let comparison = Comparison::of(linear.limit, quadratic.limit, sources);
    let of = format!("limit of 4-node cells, {name}");
    [near, covered(&of, reference(), comparison, "4-node mesh ⊕ 8-node mesh")]
}

/// How orders are read.
pub const INTRODUCTION: &str = "Orders are read between each two successive meshes. Those of a series whose errors, or changes, do not keep \
     their sign and fall are withheld, as are those of errors near what no mesh removes. The edge is where the contact ends: its distance \
     from the nearest node, outwards positive, in elements.\n\n";

/// How far the contact's edge may move within its element from mesh to mesh and still be said to stay \[elements\].
const STAYS: f64 = 0.1;

/// A mesh in a table: its series, itself, and the orders to the mesh before.
type Row<'a> = (&'a Series, &'a Level, Vec<String>);

/// The meshes of a series with the orders of their numbers, the first of which belongs to the mesh after so many.
fn rows<'a>(series: &'a Series, pairs: &[Vec<Observed>], after: usize) -> Vec<Row<'a>> {
    let row = |(k, level): (usize, &'a Level)| {
        let read = pairs.iter().map(|pairs| told(k.checked_sub(after).and_then(|before| pairs.get(before))));
        (series, level, read.collect())
    };
    series.levels.iter().enumerate().map(row).collect()
}

/// An order in a table.
pub fn told(observed: Option<&Observed>) -> String {
    match observed {
        None => "–".into(),
        Some(Observed::Order(order)) => format!("{order:.2}"),
        Some(Observed::Withheld(Why::NotMonotone)) => "withheld".into(),
        Some(Observed::Withheld(Why::Floor)) => "withheld: floor".into(),
    }
}

/// A length in elements; round-off has no sign.
fn in_elements(length: f64) -> String {
    if length.abs() < 0.005 { "0.00".into() } else { format!("{length:+.2}") }
}

/// Errors of truncated Hertz.
pub fn table_of_orders(series: &Series, load: f64) -> String {
    let columns: [Column<Row>; 9] = [
        ("h / a", |(_, level, _)| format!("{:.4}", level.size())),
        ("dofs", |(_, level, _)| level.dofs.to_string()),
        ("p₀", |(_, level, _)| format!("{:+.2e}", level.peak)),
        ("order", |(.., orders)| orders[0].clone()),
        ("a", |(_, level, _)| format!("{:+.2e}", level.width)),
        ("order", |(.., orders)| orders[1].clone()),
        ("L2(p)", |(_, level, _)| format!("{:.2e}", level.l2)),
        ("order", |(.., orders)| orders[2].clone()),
        ("edge", |(_, level, _)| in_elements(level.edge)),
    ];
    let errors: [fn(&Level) -> f64; 3] = [|level| level.peak, |level| level.width, |level| level.l2];
    let pairs = errors.map(|of| series.orders(load, of));
    format!(
        "**Truncated Hertz, {}: errors on nested meshes**\n\n{}{}\n",
        series.cells(),
        markdown::columns(&columns, &rows(series, &pairs, 1)),
        why_withheld(series, &pairs[1..2], "the error of the second-moment width")
    )
}

/// Series of the pin–rod.
pub fn table_of_pin_rod(both: &[Series; 2]) -> String {
    let columns: [Column<Row>; 8] = [
        ("cells", |(series, ..)| series.cells()),
        ("elements / 10 mm", |(_, level, _)| level.elements.to_string()),
        ("dofs", |(_, level, _)| level.dofs.to_string()),
        ("peak [MPa]", |(_, level, _)| format!("{:.3}", level.peak)),
        ("order", |(.., orders)| orders[0].clone()),
        ("2 √(∫pθ²/∫p) [°]", |(_, level, _)| format!("{:.3}", level.width.to_degrees())),
        ("order", |(.., orders)| orders[1].clone()),
        ("edge", |(_, level, _)| in_elements(level.edge)),
    ];
    let pairs = |series: &Series| [series.changes(|level| level.peak), series.changes(|level| level.width)];
    let all: Vec<Row> = both.iter().flat_map(|series| rows(series, &pairs(series), 2)).collect();
    let withheld = both
        .iter()
        .map(|series| why_withheld(series, &pairs(series), &format!("the series of {} cells", series.cells())));
    format!(
        "**Pin–rod: refinement series, orders between successive changes**\n\n{}{}\n",
        markdown::columns(&columns, &all),
        withheld.collect::<String>()
    )
}

/// Whether the contact's edge wanders within its element, where one of some numbers is not monotone; nothing where all
/// are.
fn why_withheld(series: &Series, pairs: &[Vec<Observed>], of: &str) -> String {
    if !pairs.iter().flatten().any(|pair| matches!(pair, Observed::Withheld(Why::NotMonotone))) {
        return String::new();
    }
    let edges = || series.levels.iter().map(|level| level.edge);
    let moves = edges().fold(f64::NAN, f64::max) - edges().fold(f64::NAN, f64::min);
    let told = markdown::significant(moves, 2);
    if moves <= STAYS {
        format!(
            "\nNo order can be read from {of}, which is not monotone. It is not that the contact's edge wanders within its element, \
             where it moves by {told} of an element: terms of different order and sign cancel.\n"
        )
    } else {
        format!(
            "\nNo order can be read from {of}, which is not monotone: the contact's edge wanders by {told} of an element from mesh to mesh.\n"
        )
    }
}

/// File of the chart.
pub const FILE: &str = "orders.svg";
/// How far a triangle stands from the curve beside it, as a factor.
const APART: f64 = 1.6;

/// Errors of truncated Hertz over the mesh size, beside triangles of the formal orders.
pub fn chart(all: &[&Series]) -> Drawing {
    let mut chart = Chart::new(
        "Truncated Hertz: errors on nested meshes",
        Axis::log("mesh size h / a [–]"),
        Axis::log("|relative error| [–]"),
    );
    chart.series.extend(all.iter().flat_map(|series| curves(series)));
    chart.slopes.extend(slopes(all));
    chart.drawing()
}

fn curves(series: &Series) -> [Drawn; 3] {
    let (dash, marker) = match series.order {
        Order::Linear => (Dash::Dashed, Marker::Square),
        _ => (Dash::Solid, Marker::Circle),
    };
    let curve = |quantity, colour, of: fn(&Level) -> f64| {
        let points = series.levels.iter().map(|level| [level.size(), of(level).abs()]);
        let label = format!("{quantity}, {}", series.cells());
        Drawn::new(label, points, Style::run(colour, dash, marker))
    };
    [
        curve("p₀", palette::NODE, |level| level.peak),
        curve("a", palette::PURPLE, |level| level.width),
        curve("L2(p)", palette::ORANGE, |level| level.l2),
    ]
}

/// A triangle of second order above the curves of p₀, and one of first order below those of L2(p).
fn slopes(all: &[&Series]) -> Vec<Slope> {
    let Some([.., medium, fine]) = all.first().map(|series| series.levels.as_slice()) else { return Vec::new() };
    let from = (medium.size() * fine.size()).sqrt();
    let ends = [from, from * medium.size() / fine.size()];
    let between = |of: fn(&Level) -> f64| {
        all.iter().map(move |series| match series.levels.as_slice() {
            [.., medium, fine] => (of(medium) * of(fine)).abs().sqrt(),
            _ => f64::NAN,
        })
    };
    let above = APART * between(|level| level.peak).fold(f64::NAN, f64::max);
    let below = between(|level| level.l2).fold(f64::NAN, f64::min) / APART;
    vec![Slope { ends, value: above, order: 2.0, above: true }, Slope { ends, value: below, order: 1.0, above: false }]
}
