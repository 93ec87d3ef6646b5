//! Growth with the number of degrees of freedom.

use crate::clock::Stage;
use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Colour, Drawing, Series, panels};
use crate::study::timings::growth::{Growth, LARGE};
use crate::study::timings::statistics::exponent;

/// Bytes of a megabyte.
const BYTES: f64 = 1e6;

/// Seconds by stage, whole solves, and memory against the degrees of freedom.
pub fn growth(growth: &[Growth]) -> Result<Drawing, Error> {
    let dofs = || Axis::log("degrees of freedom [–]");
    let mut stages = Chart::new("Seconds by stage", dofs(), Axis::log("time [s]"));
    for (k, stage) in Stage::ALL.into_iter().enumerate().filter(|(_, stage)| *stage != Stage::Interface) {
        let dash = if k % 2 == 0 { Dash::Solid } else { Dash::Dashed };
        let marker = [Marker::Circle, Marker::Square, Marker::Diamond, Marker::Triangle, Marker::Wedge][k % 5];
        stages.series.push(grown(
            growth,
            stage.name(),
            &|one| one.seconds(&[stage]),
            Style::run(palette::CURVES[k % palette::CURVES.len()], dash, marker),
        ));
    }
    let mut whole = Chart::new("Whole solves", dofs(), Axis::log("time [s]"));
    let run = |colour: Colour, dash, marker| Style::run(colour, dash, marker);
    let plain_ours =
        [Stage::Ordering, Stage::Analysis, Stage::Factorisation, Stage::ForwardElimination, Stage::Recovery];
    whole.series = vec![
        grown(growth, "contact solve", &|g| g.contact.median, run(palette::NODE, Dash::Solid, Marker::Circle)),
        grown(
            growth,
            "plain Cholesky, its own ordering",
            &|g| g.plain.median,
            run(palette::INK, Dash::Dashed, Marker::Square),
        ),
        grown(
            growth,
            "plain Cholesky, our ordering",
            &|g| g.seconds(&plain_ours),
            run(palette::GREY, Dash::Dotted, Marker::Diamond),
        ),
        grown(
            growth,
            "from nothing",
            &|g| g.seconds(&Stage::ALL),
            run(palette::LAYER, Dash::DashDot, Marker::Triangle),
        ),
    ];
    let mut memory = Chart::new("Memory", dofs(), Axis::log("memory [MB]"));
    let factor = |g: &Growth| 8.0 / BYTES * g.counts.factor_entries as f64;
    let peak = |g: &Growth| g.memory_ratio.map_or(f64::NAN, |ratio| ratio * factor(g));
    memory.series = vec![
        grown(growth, "whole process, at most", &peak, run(palette::LAYER, Dash::Solid, Marker::Circle)),
        grown(growth, "sparse factor", &factor, run(palette::INK, Dash::Dashed, Marker::Square)),
    ];
    panels("Growth: cylinder, node + kinematic load, one thread", &[stages, whole, memory], 2)
}

/// A curve with its exponent, fitted to the larger meshes, in the legend.
fn grown(growth: &[Growth], name: &str, of: &dyn Fn(&Growth) -> f64, style: Style) -> Series {
    let points: Vec<[f64; 2]> = growth.iter().map(|g| [g.counts.dofs as f64, of(g)]).collect();
    let large: Vec<[f64; 2]> = points.iter().copied().filter(|p| p[0] >= LARGE && p[1] > 0.0).collect();
    Series {
        label: format!("{name}: ∝ n^{:.2}", exponent(&large)),
        points: points.into_iter().map(|[x, y]| (x, y)).collect(),
        style,
        hollow: Vec::new(),
    }
}
