//! Steps against initial stiffness (Fig. 11), orders of accuracy, and the path of the iterations
//! (Figs 6, 7).

use super::{curve, of_picture, style};
use crate::case::library::Bars;
use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, IterationPaths, Path, State, panels};
use crate::solve::Element;
use crate::study::pictures;
use crate::study::unsorted::Finding;

/// Errors of truncated Hertz on nested meshes.
pub fn orders(findings: &[Finding]) -> Chart {
    let mut chart =
        Chart::new("Truncated Hertz: errors on nested meshes", Axis::log("h / a"), Axis::log("relative error"));
    let colours = [palette::NODE, palette::PURPLE, palette::ORANGE];
    for (k, series) in of_picture(findings, "orders").enumerate() {
        let (dash, marker) = if k < 3 { (Dash::Dashed, Marker::Square) } else { (Dash::Solid, Marker::Circle) };
        chart.series.push(curve(series, series.label.clone(), Style::run(colours[k % 3], dash, marker)));
    }
    chart
}

/// The way of each algorithm to the solution of two bars closing a gap.
pub fn paths(findings: &[Finding]) -> Result<String, Error> {
    let bars = Bars { push: pictures::PUSH, ..Default::default() };
    let (u, stiffness) = (bars.push * bars.gap, bars.young / (2.0 * bars.length));
    let runs =
        findings.iter().filter(|finding| finding.case == pictures::PATHS).filter_map(|finding| finding.run.as_ref());
    let paths = runs.map(|run| {
        let states = run.solution.history.iter().map(|step| {
            let [approach, pressure, stiffness] = step.first_point;
            State { approach, pressure, stiffness }
        });
        Path {
            algorithm: format!("{}, {} steps", run.formulation.algorithm.name(), run.solution.work.steps),
            dash: style(&run.formulation).dash,
            states: states.collect(),
            converged: run.solution.converged(),
        }
    });
    IterationPaths {
        title: "The path of the iterations: two bars closing a gap".into(),
        approach_label: "approach w [mm]".into(),
        pressure_label: "spring force p [MPa]".into(),
        load_line: [(0.0, stiffness * u), (u, 0.0)],
        gap: bars.gap,
        target: (bars.gap, stiffness * (u - bars.gap)),
        colour: palette::NODE,
        paths: paths.collect(),
        notes: vec![],
    }
    .svg()
}
