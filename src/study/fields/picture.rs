//! Vertical stress on the deformed meshes (the paper's Figs 9 and 13), stress and displacement along the pin (Fig. 15), and the
//! path of the iterations (Figs 6, 7).

use crate::error::Error;
use crate::figure::palette::{self, Marker, Style};
use crate::figure::{
    self, Axis, Band, Chart, ColourMap, Detail, Direction, Drawing, IterationPaths, Path, State, Window, panels,
};
use crate::solve::Run;
use crate::study::Found;
use crate::study::drawn::{Curve, label, style};
use crate::study::fields::run::{Along, Arc, Field, Numbers, Shown, bars};

/// All charts of what was found.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let (mut runs, mut alongs, mut charts) = (Vec::new(), Vec::new(), Vec::new());
    for found in findings {
        match found.numbers {
            Numbers::Path(run) => runs.push(&**run),
            Numbers::Field(field) => charts.push(of_field(field)?),
            Numbers::Along(along) => alongs.push(along),
        }
    }
    charts.push(("figure-15.svg".into(), along(&alongs)?));
    charts.push(("iteration-paths.svg".into(), paths(&runs)?));
    Ok(charts)
}

fn of_field(field: &Field) -> Result<(String, Drawing), Error> {
    let [length, pressure] = field.reference;
    let stress = match field.scene {
        Shown::Cylinder => {
            let window = Window { x: (0.0, 4.0 * length), y: (-0.1 * length, 3.9 * length) };
            stress(field, 1.0, pressure, window)?
        }
        Shown::PinRod => {
            let window = Window { x: (0.0, 1.3 * length), y: (-1.3 * length, 0.0) };
            stress(field, 20.0, 1.5 * pressure, window)?
        }
    };
    Ok((format!("field-{}.svg", field.scene.name()), stress))
}

/// Values are rounded to this fraction of the range, so that round-off cannot move one across the edge of a band.
const GRAIN: f64 = 1e-6;

/// σ_y up to a largest size, with the contact enlarged.
fn stress(field: &Field, magnification: f64, largest: f64, zoom: Window) -> Result<Drawing, Error> {
    let pairs = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| (x, y)).collect();
    let grain = GRAIN * 2.0 * largest;
    figure::Field {
        title: format!("{}: σ_y on the deformed mesh", field.scene.name()),
        quantity: "σ_y [MPa]".into(),
        points: pairs(&field.points),
        cells: field.cells.clone(),
        values: field.stress.iter().map(|value| (value / grain).round() * grain).collect(),
        displacements: pairs(&field.displacement),
        magnification,
        map: ColourMap::Diverging,
        range: Some((-largest, largest)),
        zoom: Some(Detail::of(zoom, magnification)),
        notes: vec![],
    }
    .drawing()
}

/// Hoop stress and normal displacement along the arcs of pin and rod, by every formulation.
fn along(alongs: &[&Along]) -> Result<Drawing, Error> {
    let chart = |body: usize, quantity: &str, axis: &str, of: fn(&Arc) -> &Vec<[f64; 2]>| {
        let name = alongs.first().map_or("", |along| &along.arcs[body].body);
        let angle = Axis::linear("θ from the load line [°]").over(0.0, 90.0);
        let mut chart = Chart::new(&format!("{name}: {quantity}"), angle, Axis::linear(axis));
        chart.series.extend(alongs.iter().filter(|along| along.converged).map(|along| {
            let style = Style { marker: Marker::Absent, ..style(&along.formulation) };
            Curve { points: of(&along.arcs[body]).clone(), failed: Vec::new() }.drawn(label(&along.formulation), style)
        }));
        let label = "Gaertner 1977: not at hand".into();
        chart.bands.push(Band { direction: Direction::Vertical, from: 76.0, to: 89.0, label });
        chart
    };
    let of_body = |body: usize| {
        [
            chart(body, "hoop stress", "σ_θθ [MPa]", |arc| &arc.hoop),
            chart(body, "normal displacement", "u_n, outward [mm]", |arc| &arc.displacement),
        ]
    };
    let bodies = alongs.iter().map(|along| along.arcs.len()).min().unwrap_or(0);
    let charts: Vec<Chart> = (0..bodies).flat_map(of_body).collect();
    panels("Fig. 15: pin and rod along their contact arcs", &charts, 2)
}

/// The way of each iteration to the solution of two bars closing a gap.
fn paths(runs: &[&Run]) -> Result<Drawing, Error> {
    let bars = bars();
    let (u, stiffness) = (bars.push * bars.gap, bars.young / (2.0 * bars.length));
    IterationPaths {
        title: "The path of the iterations: two bars closing a gap".into(),
        approach_label: "approach w [mm]".into(),
        pressure_label: "spring force p [MPa]".into(),
        load_line: [(0.0, stiffness * u), (u, 0.0)],
        gap: bars.gap,
        target: (bars.gap, stiffness * (u - bars.gap)),
        colour: palette::NODE,
        paths: runs.iter().map(|run| path(run)).collect(),
        notes: vec![],
    }
    .drawing()
}

fn path(run: &Run) -> Path {
    let states = run.solution.history.iter().map(|iteration| {
        let [approach, pressure, stiffness] = iteration.first_point;
        State { approach, pressure, stiffness }
    });
    Path {
        algorithm: format!("{}, {} iterations", run.formulation.algorithm.name(), run.solution.work.iterations),
        dash: style(&run.formulation).dash,
        states: states.collect(),
        converged: run.solution.converged(),
    }
}
