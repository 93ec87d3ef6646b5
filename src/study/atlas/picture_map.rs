//! Maps of the atlas: how every run of a plane ended, with the error where it stopped off the solution.

use crate::drawing::{Cell, ClassMap, Drawing, MapPanel};
use crate::solve::{Element, Iteration, Settings};
use crate::study::atlas::chart::Chart;
use crate::study::atlas::record::Record;
use crate::study::class::Class;
use crate::study::method::Method;

/// Iterations up to which a converged run is quick, and ordinary.
const QUICK: [usize; 2] = [20, 200];
/// Error of p₀ and a from which a run that stopped off the solution has the next colour.
const OFF: f64 = 0.1;
/// Errors that labels tell apart [%].
const LABELLED: [f64; 7] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// Where the maps carry ticks: every third decade of twelve, by halves.
const TICKS: [(usize, &str); 5] = [(0, "10⁻⁶"), (6, "10⁻³"), (12, "1"), (18, "10³"), (24, "10⁶")];

/// One panel a rule and element, with the predicted boundary.
pub fn map(plane: &Chart) -> Drawing {
    let on_each = |method: Method| Element::ALL.map(|element| panel(plane, Method { element, ..method }));
    let limit = Settings::default().max_iterations;
    let [quick, ordinary] = QUICK;
    ClassMap {
        title: format!("How runs end on truncated Hertz: {} against initial stiffness", plane.plane.label()),
        axes: ["initial stiffness κ₀ [–]".into(), plane.plane.label().into()],
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
        notes: vec![note(plane)],
    }
    .drawing()
}

fn panel(plane: &Chart, method: Method) -> MapPanel {
    let rows = plane.of_method(method).map(|row| (row[0].ordinate.to_string(), row.iter().map(cell).collect()));
    let added = if method.is_accelerated() { format!(" + {}", method.acceleration.name()) } else { String::new() };
    let [element, algorithm, rule] = [method.element.name(), method.algorithm.name(), method.rule.name()];
    MapPanel { rows: rows.collect(), title: format!("{element} · {algorithm} · {rule}{added}") }
}

fn note(plane: &Chart) -> String {
    let predicted =
        |rule| plane.rows.iter().flatten().any(|r| r.method.rule == rule && !r.predicted_iterations.is_nan());
    let rules = Iteration::ALL.into_iter().flat_map(Iteration::rules);
    let silent: Vec<String> = rules.filter(|rule| !predicted(**rule)).map(|rule| rule.name().to_string()).collect();
    format!(
        "Error: the larger one of p₀ and a against the solution of the same discrete problem. The boundary is predicted from the \
         condensed matrices. Nothing is predicted for what is accelerated, nor for: {}.",
        silent.join(", ")
    )
}

/// Class and label of a run.
fn cell(record: &Record) -> Cell {
    let [quick, ordinary] = QUICK;
    let off = record.error + record.penalty;
    let (class, label) = match record.class {
        Class::Converged if !record.is_right() => (if off <= OFF { 3 } else { 4 }, percent(off)),
        Class::Converged if record.iterations <= quick => (0, format!("≤{quick}")),
        Class::Converged if record.iterations <= ordinary => (1, format!("≤{ordinary}")),
        Class::Converged => (2, format!(">{ordinary}")),
        Class::Capped => (5, "m".into()),
        Class::Stopped | Class::Stalled => (5, "s".into()),
        Class::Cycling => (5, "c".into()),
        Class::Diverged => (5, "d".into()),
        Class::Unsupported => (6, "o".into()),
        Class::Beyond => (6, "b".into()),
    };
    let limit = Settings::default().max_iterations as f64;
    let predicted = (!record.predicted_iterations.is_nan()).then_some(record.predicted_iterations <= limit);
    Cell { class, label, predicted }
}

/// The least of the labelled errors that is not below this one [%].
fn percent(error: f64) -> String {
    let enough = LABELLED.into_iter().find(|labelled| 100.0 * error <= *labelled);
    enough.map_or("> 50".into(), |labelled| labelled.to_string())
}
