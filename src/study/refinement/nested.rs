//! Nested meshes: the orders by which errors of truncated Hertz fall, pair by pair.

use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, Series as Drawn, Slope};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::order::{Observed, Why, pairs};
use crate::measure::{larger, profile, relative_error, whole};
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Formulation, Run};

/// Elements per half-width on the coarsest mesh.
const COARSEST: usize = 4;
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
    /// Elements per half-width.
    pub elements: usize,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Relative error of the pressure of the centre node.
    pub peak: f64,
    /// Relative error of the second-moment width.
    pub width: f64,
    /// Relative error of the profile in L2.
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
        pairs(&sizes, &self.levels.iter().map(error).collect::<Vec<_>>(), floor)
    }

    fn cells(&self) -> String {
        format!("{}-node", self.order.nodes_per_cell())
    }
}

/// Errors of truncated Hertz, and the largest one of the assembled load; NaN, which no check passes, where a run did not converge.
pub fn truncated(order: Order) -> Result<(Series, f64), Error> {
    let numbers = TruncatedHertz::default();
    let hertz = numbers.closed_form();
    let on_mesh = |refinement| {
        let made = Discretisation::of(numbers.scene(), Resolution { elements: COARSEST, refinement, order })?;
        let run = Run::of(&made, &Formulation::verification())?;
        let measures = run.measures();
        let (elements, end) = (COARSEST << refinement, measures.edge());
        let nodes = run.solution.edges.iter().flat_map(|edge| edge.ends.map(|node| (end - node) / edge.length()));
        let found = [
            measures.largest.pressure / hertz.peak_pressure() - 1.0,
            measures.second_moment_width / hertz.half_width() - 1.0,
            profile::relative_l2(&run.solution.points, |x| hertz.pressure(x), 1.5 * hertz.half_width()),
            nodes.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(f64::NAN),
        ];
        let [peak, width, l2, edge] = found.map(|value| if run.solution.converged() { value } else { f64::NAN });
        let assembled = whole(made.scene.contact()) * made.system.bodies[0].applied_vertical().abs();
        Ok((Level { elements, dofs: run.dofs, peak, width, l2, edge }, relative_error(assembled, numbers.load())))
    };
    let found = (0..LEVELS).map(on_mesh).collect::<Result<Vec<_>, Error>>()?;
    let (levels, loads): (_, Vec<f64>) = found.into_iter().unzip();
    Ok((Series { order, levels }, loads.into_iter().fold(0.0, larger)))
}

/// What is below the formal order and passes: pairs approach it from both sides.
const SLACK: f64 = 0.1;
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

/// How orders are read.
pub const INTRODUCTION: &str = "Orders are read between each two successive meshes. Those of a series whose errors do not keep \
     their sign and fall are withheld, as are those of errors near what no mesh removes. The edge is where the contact ends: its distance \
     from the nearest node, outwards positive, in elements.\n\n";

/// How far the contact's edge may move within its element from mesh to mesh and still be said to stay \[elements\].
const STAYS: f64 = 0.1;

/// A mesh in a table, and the orders to the mesh before.
type Row<'a> = (&'a Level, Vec<String>);

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
        ("h / a", |(level, _)| format!("{:.4}", level.size())),
        ("dofs", |(level, _)| level.dofs.to_string()),
        ("p₀", |(level, _)| format!("{:+.2e}", level.peak)),
        ("order", |(_, orders)| orders[0].clone()),
        ("a", |(level, _)| format!("{:+.2e}", level.width)),
        ("order", |(_, orders)| orders[1].clone()),
        ("L2(p)", |(level, _)| format!("{:.2e}", level.l2)),
        ("order", |(_, orders)| orders[2].clone()),
        ("edge", |(level, _)| in_elements(level.edge)),
    ];
    let errors: [fn(&Level) -> f64; 3] = [|level| level.peak, |level| level.width, |level| level.l2];
    let pairs = errors.map(|of| series.orders(load, of));
    let orders = |k: usize| pairs.iter().map(move |pairs| told(k.checked_sub(1).and_then(|before| pairs.get(before))));
    let rows: Vec<Row> = series.levels.iter().enumerate().map(|(k, level)| (level, orders(k).collect())).collect();
    format!(
        "**Truncated Hertz, {}: errors on nested meshes**\n\n{}{}\n",
        series.cells(),
        markdown::columns(&columns, &rows),
        why_withheld(series, &pairs[1])
    )
}

/// Whether the contact's edge wanders within its element, where the errors of the second-moment width are not monotone; nothing where
/// they are.
fn why_withheld(series: &Series, orders: &[Observed]) -> String {
    if !orders.iter().any(|pair| matches!(pair, Observed::Withheld(Why::NotMonotone))) {
        return String::new();
    }
    let edges = || series.levels.iter().map(|level| level.edge);
    let moves = edges().fold(f64::NAN, f64::max) - edges().fold(f64::NAN, f64::min);
    let moved = markdown::significant(moves, 2);
    let why = if moves <= STAYS {
        format!(
            ". It is not that the contact's edge wanders within its element, where it moves by {moved} of an element: terms of different \
             order and sign cancel."
        )
    } else {
        format!(": the contact's edge wanders by {moved} of an element from mesh to mesh.")
    };
    format!("\nNo order can be read from the error of the second-moment width, which is not monotone{why}\n")
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
