//! The part of the section on what error bars cost, and its chart.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Bars, Chart, Drawing, Series, panels};
use crate::markdown;
use crate::study::drawn::picture;
use crate::study::timings::bar_cost::{BarCost, BarCosts};
use crate::study::timings::statistics::Spread;

/// Degrees of freedom at which a ratio is asked for, and the ratio.
const ASKED: (f64, f64) = (1e4, 1.6);
/// Threads.
const THREADS: [&str; 2] = ["one thread", "all threads"];

/// Columns.
const HEAD: [&str; 4] = ["dofs", "seconds without", "with ÷ without, one thread", "with ÷ without, all threads"];

/// The part of the section.
pub fn section(record: &BarCosts) -> String {
    let (dofs, asked) = ASKED;
    let rows: Vec<Vec<String>> = record.costs.iter().map(row).collect();
    let nearest = nearest(record, dofs).map_or("not recorded".into(), |one| {
        let met = |spread: Spread| {
            if spread.most <= asked {
                "✓"
            } else if spread.least <= asked {
                "~"
            } else {
                "✗"
            }
        };
        let told = THREADS
            .iter()
            .zip(one.ratio)
            .map(|(threads, spread)| format!("{} on {threads} {}", told(spread), met(spread)));
        format!("{} dofs: {}", one.dofs, told.collect::<Vec<_>>().join(", "))
    });
    format!(
        "## What error bars cost\n\n{}A solve of the cylinder as `solve` does it, with bars over without (`--no-error-bar`), median and from least \
         to most of repeated runs ({}, {} threads). Asked for: at most {asked} at {dofs:e} dofs; {nearest} (✓ all runs, ~ some, ✗ none).\n\n{}\n",
        picture(
            "bars-cost.svg",
            "Seconds with error bars over seconds without: median, least and most of repeated runs"
        ),
        record.machine.processor,
        record.machine.threads,
        markdown::table(&HEAD.map(String::from), &rows)
    )
}

/// The mesh whose number of degrees of freedom is nearest to one.
fn nearest(record: &BarCosts, dofs: f64) -> Option<&BarCost> {
    let apart = |one: &BarCost| (one.dofs as f64 / dofs).ln().abs();
    record.costs.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)))
}

fn row(one: &BarCost) -> Vec<String> {
    let [single, all] = one.ratio.map(told);
    vec![one.dofs.to_string(), markdown::significant(one.alone.median, 2), single, all]
}

fn told(spread: Spread) -> String {
    let [median, least, most] = [spread.median, spread.least, spread.most].map(|x| markdown::significant(x, 3));
    format!("{median} ({least} to {most})")
}

/// The chart.
pub fn chart(record: &BarCosts) -> Result<Drawing, Error> {
    let mut chart = Chart::new(
        "Cylinder, node + kinematic load",
        Axis::log("degrees of freedom [–]"),
        Axis::linear("time with bars ÷ without [–]"),
    );
    let styles = [(palette::NODE, Dash::Solid, Marker::Circle), (palette::LINE, Dash::Dashed, Marker::Square)];
    for (k, (colour, dash, marker)) in styles.into_iter().enumerate() {
        let at = |one: &BarCost, value: fn(&Spread) -> f64| (one.dofs as f64, value(&one.ratio[k]));
        let points = record.costs.iter().map(|one| at(one, |spread| spread.median)).collect();
        let style = Style::run(colour, dash, marker);
        chart.series.push(Series { label: format!("{}, median", THREADS[k]), points, style, hollow: Vec::new() });
        let ends =
            record.costs.iter().map(|one| [at(one, |spread| spread.least), at(one, |spread| spread.most)]).collect();
        chart.bars.push(Bars { label: "bar: least to most of repeated runs".into(), ends, colour });
    }
    let ends = record.costs.iter().map(|one| (one.dofs as f64, ASKED.1));
    chart.series.push(Series {
        label: "asked for".into(),
        points: ends.collect(),
        style: Style::reference(),
        hollow: Vec::new(),
    });
    panels("What error bars cost", &[chart], 1)
}
