//! Share of the runs that converge against the candidate stretch, one panel an algorithm.

use crate::error::Error;
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::solve::{Element, Formulation, Iteration};
use crate::study::Found;
use crate::study::converged::run::{Numbers, Record};
use crate::study::converged::share::{same, share};
use crate::study::converged::sites::{STRETCHES, TOLERANCES};
use crate::study::drawn::{Curve, label, style};
use crate::study::pairing::Pairing;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let recorded: Vec<&Record> = findings.iter().flat_map(|found| &found.numbers.recorded).collect();
    let panel = |algorithm: Iteration| {
        let share = Axis::linear("converged [%]").over(0.0, 100.0);
        let mut chart = Chart::new(algorithm.name(), Axis::log("candidate stretch / a [–]").over(1.0, 150.0), share);
        for element in Element::ALL {
            let formulation = Formulation::new(element, algorithm);
            let curve = curve(&recorded, Pairing::of(&formulation));
            chart.series.push(curve.drawn(label(&formulation), style(&formulation)));
        }
        chart
    };
    let chart = panels("Share of the runs that converge", &Iteration::ALL.map(panel), 3)?;
    Ok(vec![("converged.svg".into(), chart)])
}

/// Shares at the default tolerance; stretches without a run are left out.
fn curve(recorded: &[&Record], pairing: Pairing) -> Curve {
    let at = |stretch: f64| {
        let is_own = |record: &&Record| {
            record.formulation == pairing && same(record.tolerance, TOLERANCES[0]) && same(record.stretch, stretch)
        };
        share(recorded.iter().copied().filter(is_own)).map(|share| [stretch, 100.0 * share])
    };
    let points = STRETCHES.into_iter().filter(|stretch| *stretch > 0.0).filter_map(at).collect();
    Curve { points, failed: Vec::new() }
}
