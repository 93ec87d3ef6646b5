//! Contact pressure of all nine formulations against the reference (the paper's Figs 10 and 14).

use super::{label, style};
use crate::case::problem::problem;
use crate::case::{hertz, pin};
use crate::error::Error;
use crate::figure::palette::Style;
use crate::figure::{Axis, Band, Chart, Direction, Series, panels};
use crate::measure::display_factor;
use crate::scene::ReferenceValues;
use crate::solve::Run;
use crate::study::unsorted::Finding;

/// Stations at which the closed form is drawn.
const STATIONS: usize = 200;

fn runs<'a>(findings: &'a [Finding], case: &'a str) -> impl Iterator<Item = &'a Run> {
    findings.iter().filter(move |finding| finding.case == case).filter_map(|finding| finding.run.as_ref())
}

/// Edge means of the pressure of every run; runs that did not converge stand hollow at the frame.
fn curves<'a>(runs: impl Iterator<Item = &'a Run>, scale: f64, [x, y]: [f64; 2]) -> Vec<Series> {
    runs.map(|run| {
        let points = run.solution.edges.iter().map(|p| (p.position() * x, p.pressure / scale * y));
        let converged = run.solution.converged();
        Series {
            label: label(&run.formulation),
            points: if converged { points.collect() } else { Vec::new() },
            style: style(&run.formulation),
            hollow: if converged { Vec::new() } else { vec![0.0] },
        }
    })
    .collect()
}

/// Pressure on the cylinder against Hertz, and the difference to Hertz where it can be seen.
pub fn cylinder(findings: &[Finding]) -> Result<String, Error> {
    let problem = problem("cylinder", None)?;
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let exact = |x: f64| problem.reference_pressure(x * a) / p0;
    let mut pressure =
        Chart::new("Pressure, edge means", Axis::linear("x / a").over(0.0, 1.5), Axis::linear("p / p₀").over(0.0, 1.1));
    pressure.series = curves(runs(findings, hertz::CYLINDER), p0, [1.0 / a, 1.0]);
    let hertz = (0..=STATIONS).map(|k| 1.5 * k as f64 / STATIONS as f64).map(|x| (x, exact(x)));
    pressure.series.push(Series {
        label: "Hertz".into(),
        points: hertz.collect(),
        style: Style::reference(),
        hollow: vec![],
    });

    let mut difference =
        Chart::new("Difference to Hertz", Axis::linear("x / a").over(0.0, 1.5), Axis::linear("(p − p_Hertz) / p₀ [%]"));
    difference.series = runs(findings, hertz::CYLINDER)
        .map(|run| {
            let mean = |from: f64, to: f64| {
                (0..20).map(|k| exact(from + (to - from) * (k as f64 + 0.5) / 20.0)).sum::<f64>() / 20.0
            };
            let points = run.solution.edges.iter().map(|edge| {
                let (x, half) = (edge.position() / a, 0.5 * edge.weight / problem.scene.thickness / a);
                (x, 100.0 * (edge.pressure / p0 - mean(x - half, x + half)))
            });
            let converged = run.solution.converged();
            let points = if converged { points.collect() } else { Vec::new() };
            Series { label: label(&run.formulation), points, style: style(&run.formulation), hollow: vec![] }
        })
        .collect();
    panels("Cylinder on a rigid plane: all nine formulations", &[pressure, difference], 2)
}

/// Pressure against angle on the pin, and the place of the measured curves.
pub fn pin_rod(findings: &[Finding]) -> Result<String, Error> {
    let problem = problem("pin-rod", None)?;
    let degrees = display_factor(&problem.scene.contact().path);
    let scale = problem.scene.reference.pressure;
    let mut chart = Chart::new(
        "Pin in a connecting-rod eye: pressure of all nine formulations, edge means",
        Axis::linear("θ from the load line [°]").over(0.0, 90.0),
        Axis::linear("R t p / F").over(0.0, 0.9),
    );
    chart.series = curves(runs(findings, pin::PIN_ROD), scale, [degrees, 1.0]);
    let label = "Gaertner 1977: not at hand".into();
    chart.bands.push(Band { direction: Direction::Vertical, from: 76.0, to: 89.0, label });
    chart.notes.push("Nothing here has yet been compared with an experiment.".into());
    chart.svg()
}
