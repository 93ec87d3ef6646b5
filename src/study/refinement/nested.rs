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

/// What is found on a mesh of a nested series; NaN where the run did not converge.
#[derive(Clone, Debug)]
pub struct Level<const N: usize> {
    /// Elements along the contact: per half-width, or of the inner ring along the fit.
    pub elements: usize,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Relative errors.
    pub errors: [f64; N],
}

/// Observed orders of an error between each two successive meshes, coarse to fine; `floor` is what no mesh removes.
pub fn orders<const N: usize>(levels: &[Level<N>], number: usize, floor: f64) -> Vec<Observed> {
    let sizes: Vec<f64> = levels.iter().map(|level| 1.0 / level.elements as f64).collect();
    pairs(&sizes, &levels.iter().map(|level| level.errors[number]).collect::<Vec<_>>(), floor)
}

/// What is below the order expected and passes: pairs approach it from both sides.
const SLACK: f64 = 0.1;

/// The order between each two successive meshes reaches the one expected, by its name and value; one that is withheld
/// does not.
pub fn reach<const N: usize>(
    (name, kind, order, because): (&'static str, &str, f64, &'static str),
    (levels, number, floor): (&[Level<N>], usize, f64),
    between: impl Fn(usize, usize) -> String,
) -> Vec<Judged> {
    let of_pair = |(two, pair): (&[Level<N>], Observed)| {
        let quantity = Quantity::at(name, between(two[0].elements, two[1].elements));
        let expected = Reference::analytic(&format!("{kind} {order}, a tenth less"), order - SLACK);
        Check::at_least(quantity, expected, because).judge(pair.unwrap_or(f64::NAN))
    };
    levels.windows(2).zip(orders(levels, number, floor)).map(of_pair).collect()
}

/// Truncated Hertz on nested meshes of cells of one order.
#[derive(Clone, Debug)]
pub struct Series {
    /// Order of the cells.
    pub order: Order,
    /// Coarse to fine: errors of the pressure of the centre node, of the second-moment width, and of the profile in L2.
    pub levels: Vec<Level<3>>,
    /// Where the contact ends on each of them: from the nearest node outwards \[elements\].
    pub edges: Vec<f64>,
    /// Largest relative error of the assembled load.
    pub load: f64,
}

impl Series {
    /// Observed orders of an error; the assembled load, or the tolerance of the iteration if that is larger, is what no
    /// mesh removes.
    fn orders(&self, number: usize) -> Vec<Observed> {
        orders(&self.levels, number, self.floor())
    }

    fn floor(&self) -> f64 {
        larger(self.load, Formulation::verification().settings.tolerance)
    }

    fn cells(&self) -> String {
        format!("{}-node", self.order.nodes_per_cell())
    }
}

/// Errors of truncated Hertz; NaN, which no check passes, where a run did not converge.
pub fn truncated(order: Order) -> Result<Series, Error> {
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
        let level = Level { elements, dofs: run.dofs, errors: [peak, width, l2] };
        Ok((level, (edge, relative_error(assembled, numbers.load()))))
    };
    let found = (0..LEVELS).map(on_mesh).collect::<Result<Vec<_>, Error>>()?;
    let (levels, (edges, loads)): (_, (_, Vec<f64>)) = found.into_iter().unzip();
    Ok(Series { order, levels, edges, load: loads.into_iter().fold(0.0, larger) })
}

/// The order between each two successive meshes reaches the formal one.
pub fn judge_orders(series: &Series) -> Vec<Judged> {
    let reaches = |name: &'static str, order: f64, because: &'static str, number: usize| {
        let between = |a: usize, b: usize| format!("h/a = {} to {}", 1.0 / a as f64, 1.0 / b as f64);
        reach((name, "formal order", order, because), (&series.levels, number, series.floor()), between)
    };
    let peak = reaches("observed order of the pressure of the centre node", 2.0, "every pair of meshes", 0);
    let width = match series.order {
        Order::Linear => below_second_order(series),
        _ => reaches("observed order of the second-moment width", 2.0, "the edge lies on a node", 1),
    };
    let edge = "square-root edge (Drouet & Hild 2015; Belhachmi & Ben Belgacem 2003): capped near 1";
    let profile = reaches("observed order of the pressure profile in L2", 1.0, edge, 2);
    let hertz = Reference::analytic("Hertz", 0.0);
    let assembled = Check::error("largest error of the assembled load", hertz, 1e-7, "16-point Gauss on every edge")
        .judge(series.load);
    [peak, width, profile, vec![assembled]].concat()
}

/// Without an order that could be read, the half-width must lie below a line of second order on every mesh.
///
/// A pressure that stands for its surroundings of length h has the error `h²/24` of the midpoint rule.
fn below_second_order(series: &Series) -> Vec<Judged> {
    let because = if series.orders(1).into_iter().all(|pair| pair.is_ok()) {
        "the midpoint rule's h²/24"
    } else {
        "the midpoint rule's h²/24; errors that change their sign or do not fall have no order"
    };
    let judged = series.levels.iter().map(|Level { elements, errors, .. }| {
        let size = 1.0 / *elements as f64;
        let quantity = Quantity::at("error of the second-moment width over (h/a)²", format!("h/a = {size}"));
        Check::at_most(quantity, Reference::analytic("Hertz", 1.0 / 24.0), because)
            .judge(errors[1].abs() / size.powi(2))
    });
    judged.collect()
}

/// How far the contact's edge may move within its element from mesh to mesh and still be said to stay \[elements\].
const STAYS: f64 = 0.1;

/// The order from the mesh before to the mesh `k`, in a table.
pub fn told(orders: &[Observed], k: usize) -> String {
    match k.checked_sub(1).and_then(|before| orders.get(before)) {
        None => "–".into(),
        Some(Ok(order)) => format!("{order:.2}"),
        Some(Err(Why::NotMonotone)) => "withheld".into(),
        Some(Err(Why::Floor)) => "withheld: floor".into(),
    }
}

/// A length in elements; round-off has no sign.
fn in_elements(length: f64) -> String {
    if length.abs() < 0.005 { "0.00".into() } else { format!("{length:+.2}") }
}

/// Errors of truncated Hertz.
pub fn table_of_orders(series: &Series) -> String {
    // A mesh, where the contact ends on it, and the orders to the mesh before.
    type Row<'a> = (&'a Level<3>, f64, [String; 3]);
    let columns: [Column<Row>; 9] = [
        ("h / a", |(level, ..)| format!("{:.4}", 1.0 / level.elements as f64)),
        ("dofs", |(level, ..)| level.dofs.to_string()),
        ("p₀", |(level, ..)| format!("{:+.2e}", level.errors[0])),
        ("order", |(.., orders)| orders[0].clone()),
        ("a", |(level, ..)| format!("{:+.2e}", level.errors[1])),
        ("order", |(.., orders)| orders[1].clone()),
        ("L2(p)", |(level, ..)| format!("{:.2e}", level.errors[2])),
        ("order", |(.., orders)| orders[2].clone()),
        ("edge", |(_, edge, _)| in_elements(*edge)),
    ];
    let pairs = [0, 1, 2].map(|number| series.orders(number));
    let orders = |k: usize| pairs.each_ref().map(|pairs| told(pairs, k));
    let levels = series.levels.iter().zip(&series.edges).enumerate();
    let rows: Vec<Row> = levels.map(|(k, (level, edge))| (level, *edge, orders(k))).collect();
    format!(
        "**Truncated Hertz, {}: errors on nested meshes**\n\n{}{}\n",
        series.cells(),
        markdown::columns(&columns, &rows),
        why_withheld(series, &pairs[1])
    )
}

/// Whether the contact's edge wanders within its element, where the errors of the second-moment width are not monotone;
/// nothing where they are.
fn why_withheld(series: &Series, orders: &[Observed]) -> String {
    if !orders.contains(&Err(Why::NotMonotone)) {
        return String::new();
    }
    let edges = || series.edges.iter().copied();
    let moves = edges().fold(f64::NAN, f64::max) - edges().fold(f64::NAN, f64::min);
    let moved = markdown::significant(moves, 2);
    let why = if moves <= STAYS {
        format!(
            ". It is not that the contact's edge wanders within its element, where it moves by {moved} of an element: \
            terms of different order and sign cancel."
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
    let curve = |quantity, colour, number: usize| {
        let points = series.levels.iter().map(|level| [1.0 / level.elements as f64, level.errors[number].abs()]);
        let label = format!("{quantity}, {}", series.cells());
        Drawn::new(label, points, Style::run(colour, dash, marker))
    };
    [curve("p₀", palette::NODE, 0), curve("a", palette::PURPLE, 1), curve("L2(p)", palette::ORANGE, 2)]
}

/// A triangle of second order above the curves of p₀, and one of first order below those of L2(p).
fn slopes(all: &[&Series]) -> Vec<Slope> {
    let Some([.., medium, fine]) = all.first().map(|series| series.levels.as_slice()) else { return Vec::new() };
    let [medium, fine] = [medium, fine].map(|level| 1.0 / level.elements as f64);
    let from = (medium * fine).sqrt();
    let ends = [from, from * medium / fine];
    let between = |number: usize| {
        all.iter().map(move |series| match series.levels.as_slice() {
            [.., medium, fine] => (medium.errors[number] * fine.errors[number]).abs().sqrt(),
            _ => f64::NAN,
        })
    };
    let above = APART * between(0).fold(f64::NAN, f64::max);
    let below = between(2).fold(f64::NAN, f64::min) / APART;
    vec![Slope { ends, value: above, order: 2.0, above: true }, Slope { ends, value: below, order: 1.0, above: false }]
}
