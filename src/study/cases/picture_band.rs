//! Contact pressure of all nine formulations: their band over the reference, and their differences to it.

use crate::case::library::{Cylinder, PinRod};
use crate::error::Error;
use crate::figure::palette::{GREY, Style};
use crate::figure::{Axis, Chart, Drawing, Ribbon, Series, panels};
use crate::measure::display_factor;
use crate::scene::ReferenceValues;
use crate::solution::EdgeState;
use crate::solve::{Formulation, Run};
use crate::study::drawn::{label, style};

/// Intervals into which the closed form is drawn.
const INTERVALS: usize = 200;
/// Parts of an edge over which the closed form is averaged.
const PARTS: usize = 20;
/// Where the pictures of the cylinder end, over the half-width.
const END: f64 = 1.5;

/// Label of the band.
const BAND: &str = "all nine formulations, edge means: least to most";

/// Against Hertz.
pub fn cylinder(runs: &[&Run]) -> Result<Drawing, Error> {
    let problem = Cylinder::default().case();
    let ReferenceValues { length: a, pressure: p0, .. } = problem.scene.reference;
    let exact = |x: f64| problem.reference_pressure(x * a) / p0;
    let mean = |edge: &EdgeState| {
        let half = 0.5 * edge.weight / problem.scene.thickness / a;
        let part = |k: usize| edge.position() / a + half * (2.0 * (k as f64 + 0.5) / PARTS as f64 - 1.0);
        (0..PARTS).map(|k| exact(part(k))).sum::<f64>() / PARTS as f64
    };
    let x = || Axis::linear("place over half-width x / a [–]").over(0.0, END);
    let mut pressure = Chart::new("Pressure", x(), Axis::linear("pressure p / p₀ [–]").over(0.0, 1.1));
    pressure.ribbons.push(band(runs, 1.0 / a, p0));
    let places = (0..=INTERVALS).map(|k| END * k as f64 / INTERVALS as f64);
    let points = places.map(|x| (x, exact(x))).collect();
    pressure.series.push(Series { label: "Hertz".into(), points, style: Style::reference(), hollow: failed(runs) });
    let mut difference = Chart::new("Difference to Hertz", x(), Axis::linear("(p − p_Hertz) / p₀ [%]"));
    difference.series = differences(runs, 1.0 / a, &|_, edge| 100.0 * (edge.pressure / p0 - mean(edge)));
    panels("Cylinder on a rigid plane: all nine formulations", &[pressure, difference], 2)
}

/// Against the formulation that verification uses: there is no closed form.
pub fn pin_rod(runs: &[&Run]) -> Result<Drawing, Error> {
    let problem = PinRod::default().case();
    let (degrees, scale) = (display_factor(&problem.scene.contact().path), problem.scene.reference.pressure);
    let x = || Axis::linear("θ from the load line [°]").over(0.0, 90.0);
    let own = Formulation::verification();
    let is_own = |run: &&&Run| (run.formulation.element, run.formulation.algorithm) == (own.element, own.algorithm);
    let edges = runs.iter().find(is_own).map(|run| run.solution.edges.as_slice()).unwrap_or_default();
    let mut pressure = Chart::new("Pressure", x(), Axis::linear("pressure R t p / F [–]").over(0.0, 0.9));
    pressure.ribbons.push(band(runs, degrees, scale));
    let points = edges.iter().map(|edge| (degrees * edge.position(), edge.pressure / scale)).collect();
    pressure.series.push(Series { label: label(&own), points, style: Style::reference(), hollow: failed(runs) });
    let axis = Axis::linear("difference of R t p / F [% of its largest]");
    let mut difference = Chart::new(&format!("Difference to {}", label(&own)), x(), axis);
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
