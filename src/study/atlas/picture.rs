//! Iterations against initial stiffness with their prediction (Fig. 11), and the maps of the stability atlas.

use crate::algorithm::StiffnessRule;
use crate::error::Error;
use crate::figure::palette::{self, Colour, Dash, Marker, Style};
use crate::figure::{Axis, Cell, Chart, ClassMap, MapPanel, Series, panels};
use crate::solve::{Element, Iteration, Settings};
use crate::study::Found;
use crate::study::atlas::chart::Chart as Recorded;
use crate::study::atlas::plane::{Plane, STRETCH};
use crate::study::atlas::record::{Record, same};
use crate::study::atlas::run::Numbers;
use crate::study::class::Class;
use crate::study::method::Method;

/// Iterations up to which a converged run is quick, and ordinary.
const QUICK: [usize; 2] = [20, 200];
/// Errors of p₀ and a that a run which stopped may have, told by colours where they are no iteration error.
const OFF: [f64; 2] = [0.01, 0.1];
/// Where the maps carry ticks: every third decade of twelve, by halves.
const TICKS: [(usize, &str); 5] = [(0, "1e-6"), (6, "1e-3"), (12, "1"), (18, "1e3"), (24, "1e6")];

/// A map of each full plane, and the iterations with their prediction.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    let mut pictures = Vec::new();
    for chart in findings.iter().map(|found| &found.numbers.chart) {
        if [Plane::Stretch, Plane::Mesh].contains(&chart.plane) {
            pictures.push((format!("atlas-{}.svg", chart.plane.name()), map(chart)?));
        }
        if chart.plane == Plane::Stretch {
            pictures.push(("iterations-predicted.svg".into(), iterations(chart)?));
        }
    }
    Ok(pictures)
}

/// Iterations against initial stiffness, one panel per algorithm and element: measured points over the predicted curve.
fn iterations(stretch: &Recorded) -> Result<String, Error> {
    let mut charts = Vec::new();
    for algorithm in Iteration::ALL {
        for element in Element::ALL {
            let title = format!("{} · {}", element.name(), algorithm.name());
            let mut chart = Chart::new(&title, Axis::log("κ₀").over(1e-6, 1e6), Axis::log("iterations").over(1.0, 3000.0));
            for &rule in algorithm.rules() {
                let mut rows = stretch.of_method(Method { element, algorithm, rule });
                if let Some(row) = rows.find(|row| same(row[0].ordinate, STRETCH)) {
                    chart.series.extend(curves(row, rule));
                }
            }
            charts.push(chart);
        }
    }
    panels("Iterations against initial stiffness: measured points on predicted curves", &charts, 3)
}

/// One colour a rule, whatever the algorithm.
fn colour(rule: StiffnessRule) -> Colour {
    match rule {
        StiffnessRule::Secant | StiffnessRule::Squared | StiffnessRule::Step | StiffnessRule::Doubling => palette::LINE,
        StiffnessRule::Correction => palette::LAYER,
        StiffnessRule::Literal => palette::PURPLE,
        StiffnessRule::Switching => palette::NODE,
        StiffnessRule::Penalty => palette::SKY,
    }
}

/// Predicted curve, measured points, and the failures by their cause.
fn curves(row: &[Record], rule: StiffnessRule) -> Vec<Series> {
    let (colour, rule) = (colour(rule), rule.name());
    let points = |of: &dyn Fn(&Record) -> f64| row.iter().map(|r| (r.stiffness, of(r))).collect::<Vec<_>>();
    let predicted = points(&|r| if r.predicted_iterations.is_finite() { r.predicted_iterations } else { f64::NAN });
    let measured = points(&|r| if r.class == Class::Converged { r.iterations as f64 } else { f64::NAN });
    let series = |label: String, points, style, hollow| Series { label, points, style, hollow };
    let shown = |points: &[(f64, f64)]| points.iter().any(|(_, iterations)| iterations.is_finite());
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
        (Class::Capped, Marker::Circle),
        (Class::Stalled, Marker::Circle),
        (Class::Cycling, Marker::Diamond),
        (Class::Diverged, Marker::Triangle),
        (Class::Unsupported, Marker::Square),
        (Class::Beyond, Marker::Wedge),
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
fn map(plane: &Recorded) -> Result<String, Error> {
    let of_rule = |algorithm: Iteration, rule| Element::ALL.map(|element| panel(plane, Method { element, algorithm, rule }));
    let of_algorithm = |algorithm: Iteration| algorithm.rules().iter().flat_map(move |&rule| of_rule(algorithm, rule));
    let panels: Vec<MapPanel> = Iteration::ALL.into_iter().flat_map(of_algorithm).collect();
    let colours = palette::ENDS;
    let [quick, ordinary] = QUICK;
    let names = [
        format!("≤ {quick} iterations"),
        format!("≤ {ordinary} iterations"),
        "converged".into(),
        format!("stopped off by ≤ {} %", 100.0 * OFF[0]),
        format!("off by ≤ {} %", 100.0 * OFF[1]),
        "off by more".into(),
        "not converged or stalled".into(),
        "cycling".into(),
        "diverged".into(),
        "no spring left".into(),
        "beyond".into(),
    ];
    let other = plane.plane.label();
    ClassMap {
        title: format!("How runs end on truncated Hertz: {other} (upwards) against initial stiffness κ₀"),
        panels,
        columns: 3,
        ticks: TICKS.map(|(column, text)| (column, text.to_string())).into(),
        legend: names.into_iter().zip(colours).collect(),
        notes: vec![note(plane)],
    }
    .svg()
}

fn panel(plane: &Recorded, method: Method) -> MapPanel {
    let rows = plane.of_method(method).map(|row| (row[0].ordinate.to_string(), row.iter().map(cell).collect()));
    let Method { element, algorithm, rule } = method;
    MapPanel { rows: rows.collect(), title: [element.name(), algorithm.name(), rule.name()].join(" · ") }
}

fn note(plane: &Recorded) -> String {
    let limit = Settings::default().max_iterations;
    let predicted = |rule| plane.rows.iter().flatten().any(|r| r.method.rule == rule && !r.predicted_iterations.is_nan());
    let rules = Iteration::ALL.into_iter().flat_map(Iteration::rules);
    let silent: Vec<String> = rules.filter(|rule| !predicted(**rule)).map(|rule| format!("`{}`", rule.name())).collect();
    let silent = silent.join(" and ");
    format!(
        "The black line is predicted: on its one side the condensed matrices say that a run ends within {limit} iterations, on \
         the other that it does not. Off by: stopped there, and that far from p₀ or a of the discrete \
         solution. Not converged: not at the tolerance after {limit} iterations. No spring left: the named error. \
         Beyond: contact beyond the candidates, the named error. Nothing is predicted for {silent}."
    )
}

fn cell(record: &Record) -> Cell {
    let [quick, ordinary] = QUICK;
    let place = match record.class {
        Class::Converged if !record.is_right() => {
            3 + OFF.len() - OFF.iter().filter(|limit| record.error + record.penalty <= **limit).count()
        }
        Class::Converged if record.iterations <= quick => 0,
        Class::Converged if record.iterations <= ordinary => 1,
        Class::Converged => 2,
        Class::Stopped | Class::Capped | Class::Stalled => 6,
        Class::Cycling => 7,
        Class::Diverged => 8,
        Class::Unsupported => 9,
        Class::Beyond => 10,
    };
    let limit = Settings::default().max_iterations as f64;
    let predicted = (!record.predicted_iterations.is_nan()).then_some(record.predicted_iterations <= limit);
    Cell { colour: palette::ENDS[place], predicted }
}
