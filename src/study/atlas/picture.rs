//! Iterations against initial stiffness, measured and predicted (Fig. 11), and maps of how every run of a plane ended.

use crate::algorithm::{Acceleration, StiffnessRule};
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Cell, Chart as Figure, ClassMap, Colour, Drawing, MapPanel, Series, panels};
use crate::markdown::significant;
use crate::solve::{Element, Ended, Iteration, Settings};
use crate::study::atlas::plane::{Chart, Plane, Record, STRETCH, same};
use crate::study::atlas::run::FACTOR;
use crate::study::drawn::{label, style};
use crate::study::method::Method;
use crate::study::seconds::quantile;

/// A map of each full plane, the iterations with their prediction, and those on the scenes of the paper.
pub fn pictures(charts: &[&Chart]) -> Vec<(String, Drawing)> {
    let mut pictures = Vec::new();
    for chart in charts.iter().filter(|chart| chart.plane.is_full()) {
        pictures.push((format!("atlas-{}.svg", chart.plane.name()), map(chart)));
        if chart.plane == Plane::Stretch {
            pictures.push(("iterations-predicted.svg".into(), predicted(chart)));
        }
    }
    pictures.push(("iterations-against-stiffness.svg".into(), in_the_paper(charts)));
    pictures
}

/// Iterations over initial stiffness.
fn panel(title: &str, softest: f64) -> Figure {
    let stiffness = Axis::log("initial stiffness κ₀ [–]").over(softest, 1e6);
    Figure::new(title, stiffness, Axis::log("iterations [–]").over(1.0, 3000.0))
}

/// All nine formulations on the scenes of the paper, one panel a scene and algorithm, accelerated ones dash-dotted.
fn in_the_paper(charts: &[&Chart]) -> Drawing {
    const SOFTEST: f64 = 1e-3;
    let curve = |chart: &Chart, method: Method| {
        let (mut points, mut hollow) = (Vec::new(), Vec::new());
        let row = chart.of_method(method).flatten().zip(Plane::stiffnesses());
        for (record, stiffness) in row.filter(|(record, _)| record.stiffness >= SOFTEST) {
            match record.class {
                Ended::Converged => points.push([stiffness, record.iterations as f64]),
                _ => hollow.push(stiffness),
            }
        }
        let formulation = method.formulation(1.0);
        let plain = style(&formulation);
        let drawn = if method.is_accelerated() { Style { dash: Dash::DashDot, ..plain } } else { plain };
        Series { hollow, ..Series::new(label(&formulation), points, drawn) }
    };
    let on = |chart: &Chart, algorithm: Iteration| {
        let mut panel = panel(&format!("{}: {}", chart.plane.name(), algorithm.name()), SOFTEST);
        let plain = Element::ALL.map(|element| Method::usual(element, algorithm));
        let taken = Element::ALL.map(|element| Method::default(element, algorithm));
        let methods = plain.into_iter().chain(taken.into_iter().filter(|method| method.is_accelerated()));
        panel.series = methods.map(|method| curve(chart, method)).collect();
        panel
    };
    let scenes = charts.iter().filter(|chart| Plane::PAPER.contains(&chart.plane));
    let all: Vec<Figure> = scenes.flat_map(|chart| Iteration::ALL.map(|algorithm| on(chart, algorithm))).collect();
    panels("Iterations against initial stiffness", &all, 3)
}

/// Measured points over the predicted curve, one panel an algorithm and element.
fn predicted(stretch: &Chart) -> Drawing {
    let on = |algorithm: Iteration, element: Element| {
        let mut panel = panel(&format!("{} · {}", element.name(), algorithm.name()), 1e-6);
        for method in Method::of(element).into_iter().filter(|method| method.algorithm == algorithm) {
            let row = stretch.of_method(method).find(|row| same(row[0].ordinate, STRETCH));
            panel.series.extend(row.map(|row| curves(row, method)).unwrap_or_default());
        }
        panel
    };
    let pairs = Iteration::ALL.into_iter().flat_map(|algorithm| Element::ALL.map(|element| on(algorithm, element)));
    let mut panels_of_all: Vec<Figure> = pairs.collect();
    let ratios = over_predicted(stretch);
    let off = ratios.iter().filter(|(_, ratio)| !(1.0 / FACTOR..=FACTOR).contains(ratio));
    let off: Vec<String> = off
        .map(|(method, ratio)| format!("{method} (measured {} times what is predicted)", significant(*ratio, 2)))
        .collect();
    let [all, held] = [ratios.len(), ratios.len() - off.len()];
    let title = format!(
        "Iterations measured (points), and predicted within a factor {FACTOR} for {held} of {all} methods (curves)"
    );
    if held < all {
        let note =
            format!("Off their curves by a factor above {FACTOR} in the median of the starts: {}.", off.join(", "));
        panels_of_all[0].notes.push(note);
    }
    panels(&title, &panels_of_all, 3)
}

/// Measured iterations over predicted ones, the median of the starts of each method that has both.
fn over_predicted(stretch: &Chart) -> Vec<(Method, f64)> {
    let median = |method: Method| {
        let row = stretch.of_method(method).find(|row| same(row[0].ordinate, STRETCH))?;
        let sound = row.iter().filter(|record| record.class == Ended::Converged);
        let ratio =
            |record: &Record| Some(record.iterations as f64 / record.predicted_iterations.filter(|n| n.is_finite())?);
        let ratios: Vec<f64> = sound.filter_map(ratio).collect();
        (!ratios.is_empty()).then(|| (method, quantile(&ratios, 0.5)))
    };
    Method::all().into_iter().filter_map(median).collect()
}

/// Name of a method's rule, with what is added.
fn rule(method: Method) -> String {
    match method.acceleration {
        Acceleration::None => method.rule.name().to_string(),
        acceleration => format!("{} + {}", method.rule.name(), acceleration.name()),
    }
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
    let points = |of: fn(&Record) -> Option<f64>| -> Vec<(f64, f64)> {
        row.iter().map(|record| (record.stiffness, of(record).unwrap_or(f64::NAN))).collect()
    };
    let predicted = points(|record| record.predicted_iterations.filter(|iterations| iterations.is_finite()));
    let measured = points(|record| (record.class == Ended::Converged).then_some(record.iterations as f64));
    let series = |what: &str, points: Vec<(f64, f64)>, dash, marker| {
        Series::new(format!("{}: {what}", rule(method)), points, Style::run(colour(method), dash, marker))
    };
    let mut curves = vec![
        series("predicted", predicted, Dash::Solid, Marker::Absent),
        series("measured", measured, Dash::Absent, Marker::Circle),
    ];
    curves.retain(|curve| curve.points.iter().any(|(_, iterations)| iterations.is_finite()));
    let causes = [
        (Ended::Capped, Marker::Circle),
        (Ended::Stalled, Marker::Circle),
        (Ended::Cycling, Marker::Diamond),
        (Ended::Diverged, Marker::Triangle),
        (Ended::Unsupported, Marker::Square),
        (Ended::Beyond, Marker::Wedge),
    ];
    let failed = causes.map(|(class, marker)| {
        let hollow = row.iter().filter(|record| record.class == class).map(|record| record.stiffness).collect();
        Series { hollow, ..series(class.name(), vec![], Dash::Absent, marker) }
    });
    curves.extend(failed.into_iter().filter(|curve| !curve.hollow.is_empty()));
    curves
}

/// Iterations up to which a converged run is quick, and ordinary.
const QUICK: [usize; 2] = [20, 200];
/// Error of p₀ and a from which a run that stopped off the solution has the next colour.
const OFF: f64 = 0.1;
/// Errors that labels tell apart [%].
const LABELLED: [f64; 7] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// Where the maps carry ticks: every third decade of twelve, by halves.
const TICKS: [(usize, &str); 5] = [(0, "10⁻⁶"), (6, "10⁻³"), (12, "1"), (18, "10³"), (24, "10⁶")];

/// How every run of a plane ended, one panel a rule and element, with the predicted boundary.
fn map(chart: &Chart) -> Drawing {
    let panel = |method: Method| {
        let rows = chart.of_method(method).map(|row| (row[0].ordinate.to_string(), row.iter().map(cell).collect()));
        let [element, algorithm] = [method.element.name(), method.algorithm.name()];
        MapPanel { rows: rows.collect(), title: format!("{element} · {algorithm} · {}", rule(method)) }
    };
    let on_each = |method: Method| Element::ALL.map(|element| panel(Method { element, ..method }));
    let limit = Settings::default().max_iterations;
    let [quick, ordinary] = QUICK;
    let scene = if chart.plane == Plane::Sphere { "the truncated sphere" } else { "truncated Hertz" };
    ClassMap {
        title: format!("How runs end on {scene}: {} against initial stiffness", chart.plane.label()),
        axes: ["initial stiffness κ₀ [–]".into(), chart.plane.label().into()],
        panels: Method::of(Element::Node).into_iter().flat_map(on_each).collect(),
        columns: 3,
        ticks: TICKS.map(|(column, text)| (column, text.to_string())).into(),
        classes: vec![
            format!("converged in ≤ {quick} iterations"),
            format!("in ≤ {ordinary} iterations"),
            "in more iterations".into(),
            format!("stopped, error ≤ {} % (the number: at most so many %)", 100.0 * OFF),
            format!("stopped, error > {} % (the number: at most so many %)", 100.0 * OFF),
            "not converged: m at the maximum, s stalled, c cycling, d diverged".into(),
            "named error: o no spring left, b contact beyond candidates".into(),
        ],
        boundary: Some(format!("predicted: ≤ {limit} iterations on one side only")),
        notes: vec![note(chart)],
    }
    .drawing()
}

fn note(chart: &Chart) -> String {
    let is_predicted = |rule: &StiffnessRule| {
        chart.rows.iter().flatten().any(|r| r.method.rule == *rule && r.predicted_iterations.is_some())
    };
    let rules = Iteration::ALL.into_iter().flat_map(Iteration::rules);
    let silent: Vec<&str> = rules.filter(|rule| !is_predicted(rule)).map(|rule| rule.name()).collect();
    format!(
        "Error: the larger one of p₀ and a against the solution of the same discrete problem. The boundary is \
        predicted from the condensed matrices. Nothing is predicted for what is accelerated, nor for: {}.",
        silent.join(", ")
    )
}

/// Ended and label of a run; of an error the least of the labelled ones that is not below it.
fn cell(record: &Record) -> Cell {
    let [quick, ordinary] = QUICK;
    let enough = LABELLED.into_iter().find(|labelled| 100.0 * record.off() <= *labelled);
    let percent = enough.map_or("> 50".into(), |labelled| labelled.to_string());
    let (class, label) = match record.class {
        Ended::Converged if !record.is_right() => (if record.off() <= OFF { 3 } else { 4 }, percent),
        Ended::Converged if record.iterations <= quick => (0, format!("≤{quick}")),
        Ended::Converged if record.iterations <= ordinary => (1, format!("≤{ordinary}")),
        Ended::Converged => (2, format!(">{ordinary}")),
        Ended::Capped => (5, "m".into()),
        Ended::Stopped | Ended::Stalled => (5, "s".into()),
        Ended::Cycling => (5, "c".into()),
        Ended::Diverged => (5, "d".into()),
        Ended::Unsupported => (6, "o".into()),
        Ended::Beyond => (6, "b".into()),
    };
    let limit = Settings::default().max_iterations as f64;
    Cell { class, label, predicted: record.predicted_iterations.map(|predicted| predicted <= limit) }
}
