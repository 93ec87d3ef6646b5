//! Iterations against initial stiffness, one panel per scene and algorithm.

use crate::algorithm::Acceleration;
use crate::error::Error;
use crate::figure::palette::{Dash, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::solve::{Formulation, Iteration};
use crate::study::Found;
use crate::study::drawn::{label, style};
use crate::study::sweep::run::{Numbers, Sweep};
use crate::study::sweep::scene::Scene;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let sweeps = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Sweep(sweep) => Some(sweep),
        Numbers::Rules(_) | Numbers::Saved(..) => None,
    });
    let sweeps: Vec<&Sweep> = sweeps.collect();
    let panels_of = |scene| Iteration::ALL.map(|algorithm| panel(&sweeps, scene, algorithm));
    let charts: Vec<Chart> = Scene::PAPER.into_iter().flat_map(panels_of).collect();
    Ok(vec![("iterations-against-stiffness.svg".into(), panels("Iterations against initial stiffness", &charts, 3)?)])
}

fn panel(sweeps: &[&Sweep], scene: Scene, algorithm: Iteration) -> Chart {
    let title = format!("{}: {}", scene.name(), algorithm.name());
    let mut chart = Chart::new(
        &title,
        Axis::log("initial stiffness κ₀ [–]").over(1e-3, 1e6),
        Axis::log("iterations [–]").over(1.0, 3000.0),
    );
    let own = sweeps.iter().filter(|sweep| sweep.scene == scene && sweep.formulation.algorithm == algorithm);
    chart.series =
        own.map(|sweep| sweep.iterations.drawn(label(&sweep.formulation), drawn(&sweep.formulation))).collect();
    chart
}

/// Accelerated ones are dash-dotted.
fn drawn(formulation: &Formulation) -> Style {
    match formulation.acceleration {
        Acceleration::None => style(formulation),
        _ => Style { dash: Dash::DashDot, ..style(formulation) },
    }
}
