//! The schemes of both examples, and contact pressure in the paper's Figs 10 and 14 with its five formulations.

use super::{picture_band, scene};
use crate::case::library::{Cylinder, PinRod, cylinder, pin_rod};
use crate::error::Error;
use crate::figure::palette::Style;
use crate::figure::{Axis, Band, Chart, Direction, Drawing, Series};
use crate::measure::display_factor;
use crate::scene::ReferenceValues;
use crate::solve::Run;
use crate::study::Found;
use crate::study::cases::run::Numbers;
use crate::study::drawn::{label, style};

/// Intervals into which the closed form is drawn.
const INTERVALS: usize = 200;

/// Pressure of the two examples, with the schemes of their scenes.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(vec![
        ("scene-cylinder.svg".into(), scene::cylinder()?),
        ("scene-pin-rod.svg".into(), scene::pin_rod()?),
        (
            "figure-10.svg".into(),
            on_cylinder("Fig. 10: exact and approximate solutions on the cylinder", shown(findings, cylinder::NINE))
                .drawing()?,
        ),
        ("pressure-cylinder.svg".into(), picture_band::cylinder(&runs(findings, cylinder::NINE).collect::<Vec<_>>())?),
        ("figure-14.svg".into(), on_pin("Fig. 14: pressure on the pin", shown(findings, pin_rod::NINE)).drawing()?),
        ("pressure-pin-rod.svg".into(), picture_band::pin_rod(&runs(findings, pin_rod::NINE).collect::<Vec<_>>())?),
    ])
}

fn runs<'a>(findings: &'a [Found<'a, Numbers>], case: &'a str) -> impl Iterator<Item = &'a Run> {
    findings.iter().filter(move |found| found.case == case).map(|found| &found.numbers.run)
}

/// Those that the paper shows.
fn shown<'a>(findings: &'a [Found<'a, Numbers>], case: &'a str) -> impl Iterator<Item = &'a Run> {
    runs(findings, case).filter(|run| run.formulation.is_in_the_paper())
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

/// Pressure on the cylinder against Hertz.
fn on_cylinder<'a>(title: &str, runs: impl Iterator<Item = &'a Run>) -> Chart {
    let problem = Cylinder::default().case();
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let mut pressure = Chart::new(
        title,
        Axis::linear("place over half-width x / a [–]").over(0.0, 1.5),
        Axis::linear("pressure p / p₀ [–]").over(0.0, 1.1),
    );
    pressure.series = curves(runs, p0, [1.0 / a, 1.0]);
    let hertz = (0..=INTERVALS).map(|k| 1.5 * k as f64 / INTERVALS as f64);
    let hertz = hertz.map(|x| (x, problem.reference_pressure(x * a) / p0));
    pressure.series.push(Series {
        label: "Hertz".into(),
        points: hertz.collect(),
        style: Style::reference(),
        hollow: vec![],
    });
    pressure
}

/// Pressure against angle on the pin, and the place of the measured curves.
fn on_pin<'a>(title: &str, runs: impl Iterator<Item = &'a Run>) -> Chart {
    let problem = PinRod::default().case();
    let degrees = display_factor(&problem.scene.contact().path);
    let scale = problem.scene.reference.pressure;
    let mut chart = Chart::new(
        title,
        Axis::linear("θ from the load line [°]").over(0.0, 90.0),
        Axis::linear("pressure R t p / F [–]").over(0.0, 0.9),
    );
    chart.series = curves(runs, scale, [degrees, 1.0]);
    let label = "Gaertner 1977: not at hand".into();
    chart.bands.push(Band { direction: Direction::Vertical, from: 76.0, to: 89.0, label });
    chart.notes.push("No calibrated experiment has yet been compared.".into());
    chart
}
