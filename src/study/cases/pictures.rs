//! Pictures of the two examples: the schemes of their scenes, contact pressure in the paper's Figs 10 and 14 with its five
//! formulations, and that of all nine as a band over the reference with their differences to it.

use crate::case::library::{Cylinder, PinRod, cylinder, pin_rod};
use crate::drawing::palette::{GREY, Style};
use crate::drawing::{Axis, Band, Chart, Direction, Drawing, Ribbon, Series, panels, schematic};
use crate::error::Error;
use crate::measure::display_factor;
use crate::scene::ReferenceValues;
use crate::solution::EdgeState;
use crate::solve::{Formulation, Run};
use crate::study::Found;
use crate::study::cases::Numbers;
use crate::study::drawn::{label, style};

/// Intervals into which the closed form is drawn.
const INTERVALS: usize = 200;
/// Parts of an edge over which the closed form is averaged.
const PARTS: usize = 20;
/// Where the pictures of the cylinder end, over the half-width.
const END: f64 = 1.5;
/// Label of the band.
const BAND: &str = "all nine formulations, edge means: least to most";

/// Pressure of the two examples, with the schemes of their scenes.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let nine = |case: &str| -> Vec<&Run> {
        findings.iter().filter(|found| found.case == case).map(|found| &found.numbers.run).collect()
    };
    let [on_cylinder, on_pin] = [nine(cylinder::NINE), nine(pin_rod::NINE)];
    Ok(vec![
        ("scene-cylinder.svg".into(), cylinder_scheme()),
        ("scene-pin-rod.svg".into(), pin_rod_scheme()),
        ("figure-10.svg".into(), figure_10(&on_cylinder).drawing()),
        ("pressure-cylinder.svg".into(), all_on_cylinder(&on_cylinder)),
        ("figure-14.svg".into(), figure_14(&on_pin).drawing()),
        ("pressure-pin-rod.svg".into(), all_on_pin(&on_pin)),
    ])
}

/// The cylinder on its rigid plane with its load and supports (the paper's Fig. 8).
fn cylinder_scheme() -> Drawing {
    let numbers = Cylinder::default();
    let (a, load) = (numbers.half_width(), numbers.load() / (2.0 * numbers.radius));
    let shown = [("R", numbers.radius), ("a", a), ("L", numbers.stretch * a), ("q", load.round())];
    schematic("cylinder", include_str!("cylinder.svg"), &shown)
}

/// The pin in the connecting-rod eye with its load and supports (the paper's Fig. 12).
fn pin_rod_scheme() -> Drawing {
    let numbers = PinRod::default();
    let shown = [
        ("R", numbers.pin_radius),
        ("c", numbers.clearance),
        ("R + c", numbers.pin_radius + numbers.clearance),
        ("outer", numbers.eye_outer_radius),
        ("half width", 0.5 * numbers.shank_width),
        ("height", numbers.shank_end),
        ("F/2", 0.5 * numbers.force),
        ("candidates", numbers.stretch.to_degrees()),
    ];
    schematic("pin-rod", include_str!("pin-rod.svg"), &shown)
}

/// Edge means of the pressure of the formulations that the paper shows; runs that did not converge stand hollow at the frame.
fn curves(runs: &[&Run], place: f64, scale: f64) -> Vec<Series> {
    let curve = |run: &&&Run| {
        let points = run.solution.edges.iter().map(|edge| (edge.position() * place, edge.pressure / scale));
        let points = if run.solution.converged() { points.collect() } else { Vec::new() };
        let (label, style) = (label(&run.formulation), style(&run.formulation));
        Series { label, points, style, hollow: failed(&[run]) }
    };
    runs.iter().filter(|run| run.formulation.is_in_the_paper()).map(|run| curve(&run)).collect()
}

/// Hertz's pressure over p₀ along x/a.
fn hertz(hollow: Vec<f64>) -> Series {
    let problem = Cylinder::default().case();
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let places = (0..=INTERVALS).map(|k| END * k as f64 / INTERVALS as f64);
    let points = places.map(|x| (x, problem.reference_pressure(0, x * a) / p0)).collect();
    Series { label: "Hertz".into(), points, style: Style::reference(), hollow }
}

/// Pressure on the cylinder, its axes.
fn on_cylinder(title: &str) -> Chart {
    let place = Axis::linear("place over half-width x / a [–]").over(0.0, END);
    Chart::new(title, place, Axis::linear("pressure p / p₀ [–]").over(0.0, 1.1))
}

/// Pressure against angle on the pin, its axes.
fn on_pin(title: &str) -> Chart {
    let angle = Axis::linear("θ from the load line [°]").over(0.0, 90.0);
    Chart::new(title, angle, Axis::linear("pressure R t p / F [–]").over(0.0, 0.9))
}

/// Pressure on the cylinder against Hertz.
fn figure_10(runs: &[&Run]) -> Chart {
    let ReferenceValues { length: a, pressure: p0, .. } = Cylinder::default().case().scene.reference;
    let mut chart = on_cylinder("Fig. 10: exact and approximate solutions on the cylinder");
    chart.series = curves(runs, 1.0 / a, p0);
    chart.series.push(hertz(vec![]));
    chart
}

/// Pressure against angle on the pin, and the place of the measured curves.
fn figure_14(runs: &[&Run]) -> Chart {
    let scene = PinRod::default().case().scene;
    let mut chart = on_pin("Fig. 14: pressure on the pin");
    chart.series = curves(runs, display_factor(&scene.contact().path), scene.reference.pressure);
    let label = "Gaertner 1977: not at hand".into();
    chart.bands.push(Band { direction: Direction::Vertical, from: 76.0, to: 89.0, label });
    chart.notes.push("No calibrated experiment has yet been compared.".into());
    chart
}

/// All nine on the cylinder against Hertz.
fn all_on_cylinder(runs: &[&Run]) -> Drawing {
    let problem = Cylinder::default().case();
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let exact = |x: f64| problem.reference_pressure(0, x * a) / p0;
    let mean = |edge: &EdgeState| {
        let half = 0.5 * edge.weight / problem.scene.thickness / a;
        let part = |k: usize| edge.position() / a + half * (2.0 * (k as f64 + 0.5) / PARTS as f64 - 1.0);
        (0..PARTS).map(|k| exact(part(k))).sum::<f64>() / PARTS as f64
    };
    let mut pressure = on_cylinder("Pressure");
    pressure.ribbons.push(band(runs, 1.0 / a, p0));
    pressure.series.push(hertz(failed(runs)));
    let place = Axis::linear("place over half-width x / a [–]").over(0.0, END);
    let mut difference = Chart::new("Difference to Hertz", place, Axis::linear("(p − p_Hertz) / p₀ [%]"));
    difference.series = differences(runs, 1.0 / a, &|_, edge| 100.0 * (edge.pressure / p0 - mean(edge)));
    panels("Cylinder on a rigid plane: all nine formulations", &[pressure, difference], 2)
}

/// All nine on the pin against the formulation that verification uses: there is no closed form.
fn all_on_pin(runs: &[&Run]) -> Drawing {
    let scene = PinRod::default().case().scene;
    let (degrees, scale) = (display_factor(&scene.contact().path), scene.reference.pressure);
    let own = Formulation::verification();
    let is_own = |run: &&&Run| (run.formulation.element, run.formulation.algorithm) == (own.element, own.algorithm);
    let edges = runs.iter().find(is_own).map(|run| run.solution.edges.as_slice()).unwrap_or_default();
    let mut pressure = on_pin("Pressure");
    pressure.ribbons.push(band(runs, degrees, scale));
    let points = edges.iter().map(|edge| (degrees * edge.position(), edge.pressure / scale)).collect();
    pressure.series.push(Series { label: label(&own), points, style: Style::reference(), hollow: failed(runs) });
    let angle = Axis::linear("θ from the load line [°]").over(0.0, 90.0);
    let axis = Axis::linear("difference of R t p / F [% of its largest]");
    let mut difference = Chart::new(&format!("Difference to {}", label(&own)), angle, axis);
    let largest = edges.iter().map(|edge| edge.pressure).fold(f64::NAN, f64::max);
    let to_own = |k: usize, edge: &EdgeState| {
        edges.get(k).map_or(f64::NAN, |own| 100.0 * (edge.pressure - own.pressure) / largest)
    };
    difference.series = differences(runs, degrees, &to_own);
    panels("Pin in a connecting-rod eye: all nine formulations", &[pressure, difference], 2)
}

/// The least and the largest edge mean of the runs that converged, edge by edge.
fn band(runs: &[&Run], place: f64, scale: f64) -> Ribbon {
    let sound: Vec<&[EdgeState]> =
        runs.iter().filter(|run| run.solution.converged()).map(|run| run.solution.edges.as_slice()).collect();
    let edges = sound.iter().map(|edges| edges.len()).min().unwrap_or(0);
    let at = |k: usize| {
        let pressures = sound.iter().map(|edges| edges[k].pressure / scale);
        let [least, most] = pressures.fold([f64::NAN; 2], |[least, most], p| [p.min(least), p.max(most)]);
        [sound[0][k].position() * place, least, most]
    };
    Ribbon { label: BAND.into(), points: (0..edges).map(at).collect(), colour: GREY }
}

/// What the edges of every run that converged differ by, with their number.
fn differences(runs: &[&Run], place: f64, of: &dyn Fn(usize, &EdgeState) -> f64) -> Vec<Series> {
    let curve = |run: &&&Run| {
        let points = run.solution.edges.iter().enumerate().map(|(k, edge)| (edge.position() * place, of(k, edge)));
        Series {
            label: label(&run.formulation),
            points: points.collect(),
            style: style(&run.formulation),
            hollow: vec![],
        }
    };
    runs.iter().filter(|run| run.solution.converged()).map(|run| curve(&run)).collect()
}

/// A hollow sign for each run that did not converge.
fn failed(runs: &[&Run]) -> Vec<f64> {
    runs.iter().filter(|run| !run.solution.converged()).map(|_| 0.0).collect()
}
