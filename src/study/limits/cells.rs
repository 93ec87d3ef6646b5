//! Limits of the cells: near incompressibility, distortion.

use super::{
    Limit, bracket, hertz_errors, largest, meshed, number, percent, range, refusal, said, seen, size, table, truncated,
    verified, worse,
};
use crate::case::library::TruncatedHertz;
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::elasticity::ElasticSystem;
use crate::error::{Error, Kind};
use crate::measure::profile;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{Grading, LARGEST_POISSON, Scene};
use crate::solve::Discretisation;
use crate::solve::run::{INSIDE, Run};
use crate::study::unsorted::Finding;

/// Poisson's ratios.
const RATIOS: [f64; 5] = [0.3, 0.45, 0.49, 0.499, LARGEST_POISSON];
/// One that is refused.
const BEYOND: f64 = 0.49999;
/// Error that counts as wrong.
const WRONG: f64 = 0.03;

/// Truncated Hertz on cells that hardly grow: what fails is then the cells' doing, not their sizes'.
fn on_even_cells(numbers: TruncatedHertz) -> Scene {
    let mut scene = problem::truncated_hertz(numbers).0;
    scene.grading = Grading { along: 1.3, depth: 1.25, ..scene.grading };
    scene
}

/// Assembled and solved past the checks of the scene.
pub(super) fn unchecked(scene: &Scene, mesh: Mesh, resolution: Resolution) -> Result<Run, Error> {
    let system = ElasticSystem::assemble(scene, &mesh)?;
    verified(&Discretisation::of_system(scene.clone(), resolution, mesh, system)?)
}

/// ν towards 0.5 in plane strain.
pub(super) fn incompressible() -> Result<Finding, Error> {
    let (mut rows, mut errors, mut rough) = (Vec::new(), [Vec::new(), Vec::new()], Vec::new());
    for poisson in RATIOS {
        let scene = on_even_cells(TruncatedHertz { poisson, ..Default::default() });
        let mut row = vec![poisson.to_string()];
        for ((elements, order), errors) in [(16, Order::Linear), (8, Order::Quadratic)].into_iter().zip(&mut errors) {
            let run = verified(&meshed(scene.clone(), elements, order)?)?;
            let [peak, width] = hertz_errors(&scene, &run);
            let inside = INSIDE * scene.reference.length;
            let departure = profile::oscillation(&run.solution.points, inside) / scene.reference.pressure;
            row.extend([peak, width, departure].map(percent));
            errors.push(worse(peak, width));
            rough.push(departure);
        }
        rows.push(row);
    }
    let [linear, quadratic] = errors;
    let beyond = TruncatedHertz { poisson: BEYOND, ..Default::default() };
    let refused = refusal(truncated(beyond, 8, Order::Quadratic), "a body that keeps its volume")?;
    let hertz = || Reference::analytic("Hertz, whose a depends on E/(1 − ν²) only", 0.0);
    let checks = vec![
        Judged::norm(
            "4-node cells shall not lock",
            "largest error of p₀ and a, 4-node",
            largest(&linear),
            hertz(),
            5e-3,
            "16 cells per half-width; locking stiffens without bound as ν tends to 0.5",
        ),
        Judged::norm(
            "8-node cells shall not lock",
            "largest error of p₀ and a, 8-node",
            largest(&quadratic),
            hertz(),
            2e-3,
            "8 cells per half-width; locking stiffens without bound as ν tends to 0.5",
        ),
        Judged::at_most(
            "Pressures of neighbouring nodes shall not oscillate",
            "departure over p₀",
            largest(&rough),
            Reference::own("at most", 0.02),
            "a smooth profile departs by its curvature, whatever ν",
        ),
    ];
    let limit = Limit {
        pushed: "ν towards 0.5 in plane strain",
        range: range(&RATIOS, "ν"),
        onset: format!(
            "errors of p₀ and a beyond {}: 4-node cells {}, 8-node cells {}",
            size(WRONG),
            bracket(&RATIOS, |i| linear[i] > WRONG, "ν").0,
            bracket(&RATIOS, |i| quadratic[i] > WRONG, "ν").0
        ),
        seen: said(&refused).0,
        instead: said(&refused).1,
    };
    let head = ["ν", "4-node: p₀", "a", "departure of neighbours", "8-node: p₀", "a", "departure of neighbours"];
    Ok(limit.finding(vec![table("Truncated Hertz by Poisson's ratio (errors against Hertz)", &head, rows)], checks))
}

/// Largest moves of inner nodes over their shortest edge.
const FRACTIONS: [f64; 8] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];

/// Inner nodes moved about until cells turn inside out.
pub(super) fn distorted() -> Result<Finding, Error> {
    let orders = [("4-node", Order::Linear), ("8-node", Order::Quadratic)];
    let scene = on_even_cells(TruncatedHertz::default());
    let mut rows: Vec<Vec<String>> = FRACTIONS.iter().map(|fraction| vec![number(*fraction)]).collect();
    let (mut worst, mut others, mut onsets, mut told) = (0.0_f64, 0, Vec::new(), (String::new(), String::new()));
    for (name, order) in orders {
        let resolution = Resolution { elements: 8, refinement: 0, order };
        let mesh = Mesh::of(&scene, resolution)?;
        let mut inverted = Vec::new();
        for (fraction, row) in FRACTIONS.into_iter().zip(&mut rows) {
            let result = unchecked(&scene, mesh.shaken(fraction), resolution);
            inverted.push(result.is_err());
            row.push(match &result {
                Ok(run) => {
                    let [peak, width] = hertz_errors(&scene, run);
                    worst = worse(worst, worse(peak, width));
                    format!("p₀ {}, a {}", percent(peak), percent(width))
                }
                Err(error) => {
                    others += usize::from(error.kind != Kind::DegenerateCell);
                    told = said(error);
                    seen(&result)
                }
            });
        }
        onsets.push(format!("{name}: inverted {}", bracket(&FRACTIONS, |i| inverted[i], "fraction").0));
    }
    let checks = vec![
        Judged::norm(
            "Cells that are distorted but not inverted shall find the contact",
            "largest error of p₀ and a",
            worst,
            Reference::analytic("Hertz", 0.0),
            1e-2,
            "isoparametric cells keep linear fields; engineering tolerance of the paper's comparison",
        ),
        Judged::norm(
            "Inverted cells shall be refused by their number",
            "other errors",
            others as f64,
            Reference::own("none", 0.0),
            0.0,
            "the Jacobian determinant is looked at in every cell",
        ),
    ];
    let limit = Limit {
        pushed: "distorted and inverted cells",
        range: range(&FRACTIONS, "move of the inner nodes over their shortest edge"),
        onset: format!("{}; before, errors of p₀ and a stay below {}", onsets.join("; "), size(worst)),
        seen: told.0,
        instead: told.1,
    };
    let head = ["move / shortest edge", "4-node", "8-node"];
    Ok(limit.finding(vec![table("Truncated Hertz on shaken meshes (errors against Hertz)", &head, rows)], checks))
}
