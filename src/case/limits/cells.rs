//! Limits of the cells: near incompressibility, distortion.

use super::{
    Limit, bracket, hertz_errors, largest, number, percent, range, refusal, said, seen, size, table, truncated,
    verified, worse,
};
use crate::case::check::{Check, Reference};
use crate::case::problem;
use crate::case::run::{INSIDE, Run};
use crate::case::suite::Finding;
use crate::elasticity::ElasticSystem;
use crate::error::Error;
use crate::formulation::{Discretisation, INCOMPRESSIBLE};
use crate::measure::profile;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::library::TruncatedHertz;
use crate::scene::{Grading, Scene};

/// Poisson's ratios.
const RATIOS: [f64; 8] = [0.3, 0.45, 0.49, 0.499, 0.4999, 0.49999, 0.499999, 0.4999999];
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
    let (mut rows, mut linear, mut widths, mut rough) = (Vec::new(), Vec::new(), 0.0_f64, Vec::new());
    for poisson in RATIOS {
        let scene = on_even_cells(TruncatedHertz { poisson, ..Default::default() });
        let run = |elements, order| {
            let resolution = Resolution { elements, refinement: 0, order };
            unchecked(&scene, Mesh::of(&scene, resolution)?, resolution)
        };
        let (four, eight) = (run(16, Order::Linear)?, run(8, Order::Quadratic)?);
        let inside = INSIDE * scene.reference.length;
        let departure = profile::oscillation(&eight.solution.points, inside) / scene.reference.pressure;
        let (errors, exact) = (hertz_errors(&scene, &four), hertz_errors(&scene, &eight));
        let user = |elements, order| match truncated(TruncatedHertz { poisson, ..Default::default() }, elements, order)
        {
            Ok(_) => "accepted",
            Err(_) => "refused",
        };
        let cells = [errors[0], errors[1], exact[0], exact[1], departure].map(percent);
        let users = [user(16, Order::Linear), user(8, Order::Quadratic)].map(String::from);
        rows.push([vec![poisson.to_string()], cells.into(), users.into()].concat());
        linear.push(worse(errors[0], errors[1]));
        widths = worse(widths, exact[1]);
        rough.push(departure);
    }
    let beyond = |order, poisson| {
        refusal(truncated(TruncatedHertz { poisson, ..Default::default() }, 8, order), "a nearly incompressible body")
    };
    let told = [beyond(Order::Linear, 0.499)?, beyond(Order::Quadratic, 0.4999)?].map(|error| said(&error).0);
    let last = |limit: f64| RATIOS.iter().rposition(|ratio| *ratio <= limit).unwrap_or(0);
    let checks = vec![
        Check::norm(
            "4-node cells shall not be accepted where they lock",
            "largest error of p₀ and a, accepted ν",
            largest(&linear[..=last(INCOMPRESSIBLE[0])]),
            Reference::analytic("Hertz", 0.0),
            WRONG,
            "engineering accuracy on a mesh of 16 cells per half-width, which without locking gives 0.2 %",
        ),
        Check::norm(
            "8-node cells shall not lock: the half-width shall hold for every ν",
            "largest error of a",
            widths,
            Reference::analytic("Hertz, whose a depends on E/(1 − ν²) only", 0.0),
            5e-3,
            "locking stiffens without bound as ν tends to 0.5; an error that stays is none",
        ),
        Check::at_most(
            "8-node cells shall not be accepted where their pressures oscillate beyond use",
            "departure over p₀, accepted ν",
            largest(&rough[..=last(INCOMPRESSIBLE[1])]),
            Reference::own("at most", 0.2),
            "means over edges are still good, and a note says so",
        ),
    ];
    let limit = Limit {
        pushed: "ν towards 0.5 in plane strain",
        range: range(&RATIOS, "ν"),
        onset: format!(
            "4-node cells lock: error beyond {} {}; 8-node cells do not, but their pressures depart from one another by 5 % of p₀ {}",
            size(WRONG),
            bracket(&RATIOS, |i| linear[i] > WRONG, "ν").0,
            bracket(&RATIOS, |i| rough[i] > 0.05, "ν").0
        ),
        seen: told.join("; "),
        instead: "8-node cells up to ν = 0.499; beyond, a mixed element, which is not built here".into(),
    };
    let head = [
        "ν",
        "4-node: p₀",
        "a",
        "8-node: p₀",
        "a",
        "departure of neighbouring pressures",
        "4-node user",
        "8-node user",
    ];
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
                    others += usize::from(!matches!(error, Error::DegenerateCell { .. }));
                    told = said(error);
                    seen(&result)
                }
            });
        }
        onsets.push(format!("{name}: inverted {}", bracket(&FRACTIONS, |i| inverted[i], "fraction").0));
    }
    let checks = vec![
        Check::norm(
            "Cells that are distorted but not inverted shall find the contact",
            "largest error of p₀ and a",
            worst,
            Reference::analytic("Hertz", 0.0),
            1e-2,
            "isoparametric cells keep linear fields; engineering tolerance of the paper's comparison",
        ),
        Check::norm(
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
