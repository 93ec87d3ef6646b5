//! The picture of one run: deformed shape with stress, contact pressure, and the residuals step by step.

use super::{deformed, label, style};
use crate::case::{Problem, Run};
use crate::error::Error;
use crate::formulation::Discretisation;
use crate::measure::display_factor;
use crate::report::figure::palette::{self, Colour};
use crate::report::figure::{Axis, Chart, Dash, Direction, Guide, Marker, Series, Sheet, Style};
use crate::solution::Residuals;

/// Stations at which the closed form is drawn.
const STATIONS: usize = 200;
/// Upper end of the pressure axis over the highest pressure.
const HEADROOM: f64 = 1.08;
/// Fewest steps an axis has room for.
const STEPS: usize = 5;

/// The sheet of a run, converged or not.
pub fn sheet(problem: &Problem, discretisation: &Discretisation, run: &Run) -> Result<Sheet, Error> {
    let steps = run.solution.work.steps;
    let plural = if steps == 1 { "" } else { "s" };
    let field = deformed::field(discretisation, run)?;
    let missing = field.is_none().then(|| "The last step has no finite displacements to draw.".to_string());
    Ok(Sheet {
        title: format!(
            "{}: {}, {} after {steps} step{plural}",
            problem.name,
            run.formulation.name(),
            run.solution.outcome
        ),
        field,
        charts: vec![pressure(problem, run), residuals(run)],
        notes: missing.into_iter().chain(run.note().map(sentence)).collect(),
    })
}

/// Pressure against the contact coordinate, with the oracle's curve where there is one.
pub fn pressure(problem: &Problem, run: &Run) -> Chart {
    let path = &problem.scene.contact.path;
    let factor = display_factor(path);
    let pair = &problem.scene.contact;
    let (points, ends) = (&run.solution.points, [pair.begin(), pair.stretch].map(|s| factor * s));
    let found: Vec<(f64, f64)> = points.iter().map(|point| (factor * point.position, point.pressure)).collect();
    let x = Axis::linear(if factor > 1.0 { "θ [°]" } else { "s [mm]" }).over(ends[0], ends[1]);
    let y = Axis::linear("contact pressure [MPa]");
    let mut chart = Chart::new("Contact pressure", x, y);
    let series = |label: String, points, style| Series { label, points, style, hollow: vec![] };
    chart.series.push(series(label(&run.formulation), found, style(&run.formulation)));
    if let Some(oracle) = &problem.oracle {
        let stations = (0..=STATIONS).map(|k| k as f64 / STATIONS as f64 * problem.scene.contact.stretch);
        let curve = stations.map(|s| (factor * s, problem.reference_pressure(s))).collect();
        chart.series.push(series(oracle.name().into(), curve, Style::reference()));
    }
    // From zero, so that a uniform pressure looks uniform.
    let drawn = chart.series.iter().flat_map(|series| &series.points).map(|point| point.1);
    let highest = drawn.filter(|pressure| pressure.is_finite()).fold(0.0, f64::max);
    chart.y.range = Some((0.0, if highest > 0.0 { HEADROOM * highest } else { 1.0 }));
    chart
}

/// What a curve shows: its name, the residual, its colour and sign.
type Kind = (&'static str, fn(&Residuals) -> f64, Colour, Marker);

const KINDS: [Kind; 4] = [
    ("penetration", |r| r.penetration, palette::PURPLE, Marker::Circle),
    ("tension", |r| r.tension, palette::SKY, Marker::Square),
    ("complementarity", |r| r.complementarity, palette::ORANGE, Marker::Triangle),
    ("balance", |r| r.balance, palette::INK, Marker::Diamond),
];

/// The four residuals of every step with the tolerance; what a logarithm cannot show is left out.
pub fn residuals(run: &Run) -> Chart {
    let history = &run.solution.history;
    let last = history.len().max(STEPS) as f64;
    let mut chart = Chart::new("Residuals", Axis::linear("step").over(0.0, last), Axis::log("residual"));
    let shown = |value: f64| if value.is_finite() && value > 0.0 { value } else { f64::NAN };
    let mut at_rest = Vec::new();
    for (label, of, colour, marker) in KINDS {
        let steps = history.iter().enumerate();
        let points: Vec<(f64, f64)> =
            steps.map(|(step, state)| ((step + 1) as f64, shown(of(&state.residuals)))).collect();
        if points.iter().all(|point| point.1.is_nan()) {
            at_rest.push(label);
            continue;
        }
        let style = Style::run(colour, Dash::Solid, marker);
        chart.series.push(Series { label: label.into(), points, style, hollow: vec![] });
    }
    let at = run.formulation.settings.tolerance;
    chart.guides.push(Guide { direction: Direction::Horizontal, at, label: "tolerance".into() });
    if !at_rest.is_empty() {
        chart.notes.push(format!("Residuals that are 0 or no number in every step: {}.", at_rest.join(", ")));
    }
    chart
}

/// A note as a sentence of its own.
fn sentence(note: String) -> String {
    let mut letters = note.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str())
}
