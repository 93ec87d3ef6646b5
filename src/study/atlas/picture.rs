//! Iterations against initial stiffness with their prediction (Fig. 11).

use crate::algorithm::{Acceleration, StiffnessRule};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Colour, Drawing, Series, panels};
use crate::error::Error;
use crate::solve::{Element, Iteration};
use crate::study::Found;
use crate::study::atlas::chart::Chart as Recorded;
use crate::study::atlas::picture_map::map;
use crate::study::atlas::plane::{Plane, STRETCH};
use crate::study::atlas::record::{Record, same};
use crate::study::atlas::run::Numbers;
use crate::study::class::Class;
use crate::study::method::Method;

/// A map of each full plane, and the iterations with their prediction.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut pictures = Vec::new();
    for chart in findings.iter().map(|found| &found.numbers.chart) {
        if [Plane::Stretch, Plane::Mesh].contains(&chart.plane) {
            pictures.push((format!("atlas-{}.svg", chart.plane.name()), map(chart)));
        }
        if chart.plane == Plane::Stretch {
            pictures.push(("iterations-predicted.svg".into(), iterations(chart)));
        }
    }
    Ok(pictures)
}

/// Iterations against initial stiffness, one panel per algorithm and element: measured points over the predicted curve.
fn iterations(stretch: &Recorded) -> Drawing {
    let mut charts = Vec::new();
    for algorithm in Iteration::ALL {
        for element in Element::ALL {
            let title = format!("{} · {}", element.name(), algorithm.name());
            let mut chart = Chart::new(
                &title,
                Axis::log("initial stiffness κ₀ [–]").over(1e-6, 1e6),
                Axis::log("iterations [–]").over(1.0, 3000.0),
            );
            for method in Method::of(element).into_iter().filter(|method| method.algorithm == algorithm) {
                let mut rows = stretch.of_method(method);
                if let Some(row) = rows.find(|row| same(row[0].ordinate, STRETCH)) {
                    chart.series.extend(curves(row, method));
                }
            }
            charts.push(chart);
        }
    }
    panels("Iterations against initial stiffness: measured points on predicted curves", &charts, 3)
}

/// One colour a rule, whatever the algorithm, and one for what is accelerated.
fn colour(method: Method) -> Colour {
    match method.rule {
        _ if method.is_accelerated() => palette::NODE,
        StiffnessRule::Secant | StiffnessRule::Squared | StiffnessRule::Step | StiffnessRule::Doubling => palette::LINE,
        StiffnessRule::Correction => palette::LAYER,
        StiffnessRule::Literal => palette::PURPLE,
        StiffnessRule::Switching => palette::NODE,
        StiffnessRule::Penalty => palette::SKY,
    }
}

/// Predicted curve, measured points, and the failures by their cause.
fn curves(row: &[Record], method: Method) -> Vec<Series> {
    let rule = match method.acceleration {
        Acceleration::None => method.rule.name().to_string(),
        acceleration => format!("{} + {}", method.rule.name(), acceleration.name()),
    };
    let colour = colour(method);
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
