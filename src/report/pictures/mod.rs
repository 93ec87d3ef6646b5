//! Pictures of runs.
//!
//! * [`solve`] — shape, pressure and iteration error on one sheet.
//! * [`deformed`] — the deformed bodies with their stress.
//!
//! Below is that of formulations side by side: the iteration error of each from iteration to iteration.

use crate::drawing::{Axis, Chart, Direction, Drawing, Guide, Series, panels};
use crate::solve::{Iteration, Run};
use crate::study::drawn::{label, style};

pub mod deformed;
pub mod solve;

/// Iteration error against iterations, a panel for each algorithm.
pub fn compared(case: &str, runs: &[Run]) -> Drawing {
    let charts: Vec<Chart> = Iteration::ALL.into_iter().filter_map(|algorithm| chart(runs, algorithm)).collect();
    panels(&format!("{case}: iteration error of each formulation"), &charts, charts.len().max(1))
}

/// The runs of one algorithm; none where it has none.
fn chart(runs: &[Run], algorithm: Iteration) -> Option<Chart> {
    let own: Vec<&Run> = runs.iter().filter(|run| run.formulation.algorithm == algorithm).collect();
    let longest = own.iter().map(|run| run.solution.history.len()).max()?;
    let x = Axis::log("iteration [–]").over(1.0, longest.max(2) as f64);
    let mut chart = Chart::new(algorithm.name(), x, Axis::log("iteration error [–]"));
    chart.series = own.iter().map(|run| series(run)).collect();
    let at = own.iter().map(|run| run.formulation.settings.tolerance).fold(f64::INFINITY, f64::min);
    chart.guides.push(Guide { direction: Direction::Horizontal, at, label: "tolerance".into() });
    Some(chart)
}

/// What a logarithm cannot show is left out.
fn series(run: &Run) -> Series {
    let shown = |error: f64| if error.is_finite() && error > 0.0 { error } else { f64::NAN };
    let errors = run.solution.history.iter().map(|iteration| shown(iteration.error.largest()));
    let points = errors.enumerate().map(|(before, error)| ((before + 1) as f64, error));
    Series::new(label(&run.formulation), points, style(&run.formulation))
}
