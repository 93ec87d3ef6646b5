//! The picture of one run: deformed shape with stress, contact pressure, and the iteration error from iteration to
//! iteration.

use super::deformed;
use crate::case::{Case, notes, plausible};
use crate::drawing::palette;
use crate::drawing::{Axis, Chart, Colour, Dash, Direction, Guide, Marker, Series, Sheet, Style};
use crate::error::Error;
use crate::markdown;
use crate::measure::display_factor;
use crate::scene::ContactPair;
use crate::solution::{IterationError, PointState};
use crate::solve::Discretisation;
use crate::solve::Run;
use crate::study::drawn::{label, style};

/// Intervals into which the closed form is drawn.
const INTERVALS: usize = 200;
/// Upper end of the pressure axis over the highest pressure.
const HEADROOM: f64 = 1.08;
/// Part of the largest gap that rounding explains.
const ROUND_OFF: f64 = 1e-9;
/// Fewest iterations an axis has room for.
const FEWEST: usize = 5;
/// More iterations than these are drawn on an axis of ratios.
const MANY: usize = 100;

/// The sheet of a run, converged or not.
pub fn sheet(problem: &Case, discretisation: &Discretisation, run: &Run) -> Result<Sheet, Error> {
    let iterations = markdown::counted(run.solution.work.iterations, "iteration");
    let field = deformed::field(discretisation, run)?;
    let missing = field.is_none().then(|| "The last iteration has no finite displacements to draw.".to_string());
    Ok(Sheet {
        title: format!("{}: {}, {} after {iterations}", problem.name, run.formulation.name(), run.solution.outcome),
        field,
        charts: charts(problem, run),
        notes: missing.into_iter().chain(told(problem, discretisation, run)).collect(),
    })
}

/// A row for every contact, pressure and gap; the iteration error stands in the first.
fn charts(problem: &Case, run: &Run) -> Vec<Vec<Chart>> {
    let of = |contact| vec![pressure(problem, run, contact), gap(problem, run, contact)];
    let mut rows: Vec<Vec<Chart>> = (0..run.contacts.len()).map(of).collect();
    rows.iter_mut().take(1).for_each(|first| first.push(iteration_error(run)));
    rows
}

/// The notes on the contacts, by name where there are several.
fn told(problem: &Case, discretisation: &Discretisation, run: &Run) -> Vec<String> {
    let doubts = plausible::doubts(discretisation, run);
    let several = run.contacts.len() > 1;
    let of = |(index, pair): (usize, &ContactPair)| {
        let told = |note: String| match several {
            true => format!("{}: {note}.", pair.name),
            false => markdown::capitalised(&note) + ".",
        };
        notes::of(run, index).iter().chain(&doubts[index]).cloned().map(told).collect::<Vec<_>>()
    };
    problem.scene.contacts.iter().enumerate().flat_map(of).collect()
}

/// A quantity of the points of one contact against the contact coordinate.
fn profile(problem: &Case, run: &Run, contact: usize, [title, y]: [&str; 2], of: impl Fn(&PointState) -> f64) -> Chart {
    let pair = &problem.scene.contacts[contact];
    let factor = display_factor(&pair.path);
    let ends = [pair.begin(), pair.stretch].map(|s| factor * s);
    let found = run.solution.points_of(contact).iter().map(|point| (factor * point.position, of(point)));
    let x = Axis::linear(if factor > 1.0 { "θ [°]" } else { "s [mm]" }).over(ends[0], ends[1]);
    let title = if run.contacts.len() > 1 { format!("{title}, {}", pair.name) } else { title.to_string() };
    let mut chart = Chart::new(&title, x, Axis::linear(y));
    let solid = Style { dash: Dash::Solid, ..style(&run.formulation) };
    chart.series.push(Series::new(label(&run.formulation), found, solid));
    chart
}

/// Gap that remains; 0 where the surfaces touch but for round-off.
fn gap(problem: &Case, run: &Run, contact: usize) -> Chart {
    let points = run.solution.points_of(contact);
    let share = run.solution.contacts[contact].approach;
    let widest = points.iter().map(|point| point.gap.abs()).filter(|gap| gap.is_finite()).fold(share, f64::max);
    let told = |point: &PointState| if point.gap.abs() <= ROUND_OFF * widest { 0.0 } else { point.gap };
    let mut chart = profile(problem, run, contact, ["Remaining gap", "gap [mm]"], told);
    if points.iter().all(|point| told(point) == 0.0) {
        chart.y.range = Some((0.0, if share > 0.0 { share } else { 1.0 }));
    }
    chart
}

/// Pressure against the contact coordinate, with the oracle's curve where there is one.
pub fn pressure(problem: &Case, run: &Run, contact: usize) -> Chart {
    let mut chart =
        profile(problem, run, contact, ["Contact pressure", "contact pressure [MPa]"], |point| point.pressure);
    let pair = &problem.scene.contacts[contact];
    if let Some(oracle) = problem.oracle_of(contact) {
        let factor = display_factor(&pair.path);
        let [begin, end] = [pair.begin(), pair.stretch];
        let places = (0..=INTERVALS).map(|k| begin + k as f64 / INTERVALS as f64 * (end - begin));
        let curve = places.map(|s| (factor * s, problem.reference_pressure(contact, s)));
        chart.series.push(Series::new(oracle.name(), curve, Style::reference()));
    }
    // From zero, so that a uniform pressure looks uniform.
    let drawn = chart.series.iter().flat_map(|series| &series.points).map(|point| point.1);
    let highest = drawn.filter(|pressure| pressure.is_finite()).fold(0.0, f64::max);
    chart.y.range = Some((0.0, if highest > 0.0 { HEADROOM * highest } else { 1.0 }));
    chart
}

/// What a curve shows: its name, the part of the error, its colour and sign.
type Kind = (&'static str, fn(&IterationError) -> f64, Colour, Marker);

const KINDS: [Kind; 4] = [
    ("peak", |error| error.peak, palette::INK, Marker::Diamond),
    ("force", |error| error.force, palette::PURPLE, Marker::Circle),
    ("width", |error| error.width, palette::SKY, Marker::Square),
    ("approach", |error| error.approach, palette::ORANGE, Marker::Triangle),
];

/// The iteration error of every iteration with the tolerance; what a logarithm cannot show is left out.
pub fn iteration_error(run: &Run) -> Chart {
    let history = &run.solution.history;
    let mut chart = Chart::new("Iteration error", iterations(history.len()), Axis::log("relative error [–]"));
    let shown = |value: f64| if value.is_finite() && value > 0.0 { value } else { f64::NAN };
    let mut at_rest = Vec::new();
    for (label, of, colour, marker) in KINDS {
        let iterations = history.iter().enumerate();
        let points: Vec<(f64, f64)> =
            iterations.map(|(before, state)| ((before + 1) as f64, shown(of(&state.error)))).collect();
        if points.iter().all(|point| point.1.is_nan()) {
            at_rest.push(label);
            continue;
        }
        chart.series.push(Series::new(label, points, Style::run(colour, Dash::Solid, marker)));
    }
    let at = run.formulation.settings.tolerance;
    chart.guides.push(Guide { direction: Direction::Horizontal, at, label: "tolerance".into() });
    if !at_rest.is_empty() {
        chart.notes.push(format!("Errors that are 0 or no number in every iteration: {}.", at_rest.join(", ")));
    }
    chart
}

/// The axis of iterations: by ratios where they are many.
fn iterations(count: usize) -> Axis {
    if count > MANY {
        return Axis::log("iteration [–]").over(1.0, count as f64);
    }
    Axis::linear("iteration [–]").over(0.0, count.max(FEWEST) as f64)
}
