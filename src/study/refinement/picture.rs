//! Errors of truncated Hertz over the mesh size.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Series};
use crate::mesh::Order;
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::refinement::run::{Errors, Numbers, Orders};

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    let mut chart =
        Chart::new("Truncated Hertz: errors on nested meshes", Axis::log("h / a"), Axis::log("relative error"));
    for found in findings {
        if let Numbers::Orders(orders) = found.numbers {
            chart.series.extend(curves(orders));
        }
    }
    Ok(vec![("orders.svg".into(), chart.svg()?)])
}

fn curves(orders: &Orders) -> [Series; 3] {
    let (dash, marker) = match orders.order {
        Order::Linear => (Dash::Dashed, Marker::Square),
        Order::Quadratic => (Dash::Solid, Marker::Circle),
    };
    let curve = |quantity, colour, of: fn(&Errors) -> f64| {
        let points = orders.levels.iter().map(|level| [level.size, of(level)]).collect();
        let label = format!("{quantity}, {}-node", orders.order.nodes_per_cell());
        Curve { points, failed: Vec::new() }.drawn(label, Style::run(colour, dash, marker))
    };
    [
        curve("p₀", palette::NODE, |level| level.peak),
        curve("a", palette::PURPLE, |level| level.half_width),
        curve("L2(p)", palette::ORANGE, |level| level.l2),
    ]
}
