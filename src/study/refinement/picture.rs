//! Errors of truncated Hertz over the mesh size, beside triangles of the formal orders.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, Series, Slope};
use crate::mesh::Order;
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::refinement::run::{Errors, Numbers, Orders};

/// How far a triangle stands from the curve beside it, as a factor.
const APART: f64 = 1.6;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut chart = Chart::new(
        "Truncated Hertz: errors on nested meshes",
        Axis::log("mesh size h / a [–]"),
        Axis::log("|relative error| [–]"),
    );
    let all = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Orders(orders) => Some(orders),
        _ => None,
    });
    let all: Vec<&Orders> = all.collect();
    chart.series.extend(all.iter().flat_map(|orders| curves(orders)));
    chart.slopes.extend(slopes(&all));
    Ok(vec![("orders.svg".into(), chart.drawing()?)])
}

fn curves(orders: &Orders) -> [Series; 3] {
    let (dash, marker) = match orders.order {
        Order::Linear => (Dash::Dashed, Marker::Square),
        _ => (Dash::Solid, Marker::Circle),
    };
    let curve = |quantity, colour, of: fn(&Errors) -> f64| {
        let points = orders.levels.iter().map(|level| [level.size, of(level).abs()]).collect();
        let label = format!("{quantity}, {}-node", orders.order.nodes_per_cell());
        Curve { points, failed: Vec::new() }.drawn(label, Style::run(colour, dash, marker))
    };
    [
        curve("p₀", palette::NODE, |level| level.peak),
        curve("a", palette::PURPLE, |level| level.half_width),
        curve("L2(p)", palette::ORANGE, |level| level.l2),
    ]
}

/// A triangle of second order above the curves of p₀, and one of first order below those of L2(p).
fn slopes(all: &[&Orders]) -> Vec<Slope> {
    let Some([.., medium, fine]) = all.first().map(|orders| orders.levels.as_slice()) else { return Vec::new() };
    let from = (medium.size * fine.size).sqrt();
    let ends = [from, from * medium.size / fine.size];
    let between = |of: fn(&Errors) -> f64| {
        all.iter().map(move |orders| match orders.levels.as_slice() {
            [.., medium, fine] => (of(medium) * of(fine)).abs().sqrt(),
            _ => f64::NAN,
        })
    };
    let above = APART * between(|level| level.peak).fold(f64::NAN, f64::max);
    let below = between(|level| level.l2).fold(f64::NAN, f64::min) / APART;
    vec![Slope { ends, value: above, order: 2.0, above: true }, Slope { ends, value: below, order: 1.0, above: false }]
}
