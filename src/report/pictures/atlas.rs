//! Steps against initial stiffness with their prediction (Fig. 11), and the maps of the stability atlas.

use crate::error::Error;
use crate::figure::palette::{self, Colour, Dash, Marker, Style};
use crate::figure::{Axis, Cell, Chart, ClassMap, MapPanel, Series, panels};
use crate::solve::{Element, Iteration, Settings};
use crate::study::atlas::plan::STRETCH;
use crate::study::atlas::{Chart as Plane, Class, Plane as Name, Record};

/// Steps up to which a converged run is quick, and ordinary.
const QUICK: [usize; 2] = [20, 200];
/// Errors of p₀ and a that a run which stopped may have, told by colours where they are no iteration error.
const OFF: [f64; 2] = [0.01, 0.1];
/// Where the maps carry ticks: every third decade of twelve, by halves.
const TICKS: [(usize, &str); 5] = [(0, "1e-6"), (6, "1e-3"), (12, "1"), (18, "1e3"), (24, "1e6")];

/// Steps against initial stiffness, one panel per algorithm and element: measured points over the predicted curve.
pub fn steps(stretch: &Plane) -> Result<String, Error> {
    let mut charts = Vec::new();
    for algorithm in Iteration::ALL {
        for element in Element::ALL {
            let title = format!("{} · {}", element.name(), algorithm.name());
            let mut chart = Chart::new(&title, Axis::log("κ₀").over(1e-6, 1e6), Axis::log("steps").over(1.0, 3000.0));
            for rule in algorithm.rules().iter().map(|rule| rule.name()) {
                let name = format!("{}.{}.{rule}", element.name(), algorithm.name());
                if let Some(row) = stretch.of_formulation(&name).find(|row| (row[0].ordinate - STRETCH).abs() < 1e-3) {
                    chart.series.extend(curves(row, rule));
                }
            }
            charts.push(chart);
        }
    }
    panels("Steps against initial stiffness: measured points on predicted curves", &charts, 3)
}

/// One colour a rule, whatever the algorithm.
fn colour(rule: &str) -> Colour {
    match rule {
        "secant" => palette::LINE,
        "correction" => palette::LAYER,
        "literal" => palette::PURPLE,
        "switching" => palette::NODE,
        _ => palette::SKY,
    }
}

/// Predicted curve, measured points, and the failures by their cause.
fn curves(row: &[Record], rule: &str) -> Vec<Series> {
    let colour = colour(rule);
    let points = |of: &dyn Fn(&Record) -> f64| row.iter().map(|r| (r.stiffness, of(r))).collect::<Vec<_>>();
    let predicted = points(&|r| if r.predicted_steps.is_finite() { r.predicted_steps } else { f64::NAN });
    let measured = points(&|r| if r.class == Class::Converged { r.steps as f64 } else { f64::NAN });
    let series = |label: String, points, style, hollow| Series { label, points, style, hollow };
    let shown = |points: &[(f64, f64)]| points.iter().any(|(_, steps)| steps.is_finite());
    let mut curves = Vec::new();
    if shown(&predicted) {
        let style = Style::run(colour, Dash::Solid, Marker::Absent);
        curves.push(series(format!("{rule}: predicted"), predicted, style, vec![]));
    }
    if shown(&measured) {
        let style = Style::run(colour, Dash::Absent, Marker::Circle);
        curves.push(series(format!("{rule}: measured"), measured, style, vec![]));
    }
    let causes = [
        (Class::Slow, Marker::Circle),
        (Class::Stalled, Marker::Circle),
        (Class::Cycling, Marker::Diamond),
        (Class::Diverged, Marker::Triangle),
        (Class::Unsupported, Marker::Square),
        (Class::Spilled, Marker::Wedge),
    ];
    for (class, marker) in causes {
        let hollow: Vec<f64> = row.iter().filter(|r| r.class == class).map(|r| r.stiffness).collect();
        if !hollow.is_empty() {
            let label = format!("{rule}: {}", class.name());
            curves.push(series(label, vec![], Style::run(colour, Dash::Absent, marker), hollow));
        }
    }
    curves
}

/// How every run of a plane ended, one panel per rule and element, with the predicted boundary.
pub fn map(plane: &Plane) -> Result<String, Error> {
    let mut panels = Vec::new();
    let rules = Iteration::ALL.into_iter().flat_map(|a| a.rules().iter().map(move |rule| (a.name(), rule.name())));
    for (algorithm, rule) in rules {
        for element in Element::ALL {
            let name = format!("{}.{algorithm}.{rule}", element.name());
            let rows =
                plane.of_formulation(&name).map(|row| (row[0].ordinate.to_string(), row.iter().map(cell).collect()));
            panels.push(MapPanel { rows: rows.collect(), title: name.replace('.', " · ") });
        }
    }
    let colours = palette::ENDS;
    let [quick, ordinary] = QUICK;
    let names = [
        format!("≤ {quick} steps"),
        format!("≤ {ordinary} steps"),
        "converged".into(),
        format!("stopped off by ≤ {} %", 100.0 * OFF[0]),
        format!("off by ≤ {} %", 100.0 * OFF[1]),
        "off by more".into(),
        "slow or stalled".into(),
        "cycling".into(),
        "diverged".into(),
        "no spring left".into(),
        "spilled".into(),
    ];
    let other = plane.plane.label();
    ClassMap {
        title: format!("How runs end on truncated Hertz: {other} (upwards) against initial stiffness κ₀"),
        panels,
        columns: 3,
        ticks: TICKS.map(|(column, text)| (column, text.to_string())).into(),
        legend: names.into_iter().zip(colours).collect(),
        notes: vec![note()],
    }
    .svg()
}

fn note() -> String {
    let limit = Settings::default().max_steps;
    format!(
        "The black line is predicted: on its one side the condensed matrices say that a run ends within {limit} steps, on \
         the other that it does not. Off by: stopped there, and that far from p₀ or a of the discrete \
         solution. Slow: not at the tolerance after {limit} steps. No spring left: the named error. Spilled: \
         contact beyond the candidates, the named error. Nothing is predicted for `literal` and `penalty`."
    )
}

fn cell(record: &Record) -> Cell {
    let [quick, ordinary] = QUICK;
    let place = match record.class {
        Class::Converged if !record.is_right() => {
            3 + OFF.len() - OFF.iter().filter(|limit| record.error + record.penalty <= **limit).count()
        }
        Class::Converged if record.steps <= quick => 0,
        Class::Converged if record.steps <= ordinary => 1,
        Class::Converged => 2,
        Class::Slow | Class::Stalled => 6,
        Class::Cycling => 7,
        Class::Diverged => 8,
        Class::Unsupported => 9,
        Class::Spilled => 10,
    };
    let limit = Settings::default().max_steps as f64;
    let predicted = (!record.predicted_steps.is_nan()).then_some(record.predicted_steps <= limit);
    Cell { colour: palette::ENDS[place], predicted }
}

/// The two full planes.
pub const PLANES: [Name; 2] = [Name::Stretch, Name::Mesh];
