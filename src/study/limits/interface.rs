//! Limits of the interface: elements of unequal depth on its two sides.

use std::sync::Arc;

use super::cells::unchecked;
use super::{Limit, bracket, hertz_errors, number, percent, range, seen, size, table, within, worse};
use crate::case::library::{Patch, TruncatedHertz};
use crate::case::problem;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{Component, Face, Load, Place, Profile, Scene, Shape, StressField, Support};
use crate::solve::run::Run;
use crate::study::unsorted::Finding;

/// Departure from a uniform pressure that round-off explains.
const EXACT: f64 = 1e-9;
/// Error that counts as wrong.
const WRONG: f64 = 0.01;
/// Depth of the elements at the interface, second body over first.
const RATIOS: [f64; 7] = [0.05, 0.2, 1.0, 2.0, 5.0, 10.0, 20.0];
/// Elements of up to 1:20 across the interface.
pub(super) fn across() -> Result<Finding, Error> {
    let (mut rows, mut errors, mut patch) = (Vec::new(), Vec::new(), 0.0_f64);
    let mut last = String::new();
    for ratio in RATIOS {
        let mut worst = [f64::NAN; 2];
        let mut cells = vec![number(ratio)];
        for (slot, order) in worst.iter_mut().zip([Order::Linear, Order::Quadratic]) {
            let (run, scene) = curved(ratio, order)?;
            let [peak, width] = hertz_errors(&scene, &run);
            *slot = worse(peak, width);
            cells.extend([percent(peak), percent(width)]);
            last = seen(&Ok(run));
            let uniform = patch_error(ratio, order)?;
            patch = worse(patch, uniform);
        }
        rows.push(cells);
        errors.push(worst);
    }
    let moderate = RATIOS.iter().position(|ratio| *ratio > 5.0).unwrap_or(0);
    let checks = vec![
        Judged::norm(
            "The patch test shall hold whatever the sizes across the interface",
            "largest |p − q| / q, ratios 1/20 to 20",
            patch,
            Reference::analytic("uniform pressure", 0.0),
            EXACT,
            "exact but for round-off: tributary areas come from the interface alone",
        ),
        Judged::norm(
            "8-node cells up to five times as deep on one side shall find the contact",
            "largest error of p₀ and a",
            errors[..moderate].iter().fold(0.0, |worst, [_, eight]| worse(worst, *eight)),
            Reference::analytic("Hertz", 0.0),
            WRONG,
            "engineering tolerance of the paper's comparison, 8 cells per half-width along the contact",
        ),
    ];
    let onset = |k: usize| bracket(&RATIOS, |i| errors[i][k] > WRONG, "ratio").0;
    let limit = Limit {
        pushed: "element sizes across the interface",
        range: range(&RATIOS, "depth of the elements, second body over first"),
        onset: format!(
            "error beyond {}: 4-node {}; 8-node {}; largest error of the patch test {}",
            size(WRONG),
            onset(0),
            onset(1),
            within(patch, EXACT)
        ),
        seen: format!("{last}; only a finer mesh shows the error"),
        instead: "8-node cells, at most five to one".into(),
    };
    let head = ["depth, second / first", "4-node: p₀", "a", "8-node: p₀", "a"];
    let title = "Two blocks with Hertz's tractions, the second stretched in depth (errors against Hertz)";
    Ok(limit.finding(vec![table(title, &head, rows)], checks))
}

/// The mesh with the nodes of its second body moved to `ratio` times their depth.
fn stretched(scene: &Scene, ratio: f64, resolution: Resolution) -> Result<Mesh, Error> {
    let mut mesh = Mesh::of(scene, resolution)?;
    let nodes = mesh.bodies[1].nodes.clone();
    mesh.points[nodes].iter_mut().for_each(|point| point[1] *= ratio);
    Ok(mesh)
}

/// Run of two blocks with the scene it belongs to.
fn curved(ratio: f64, order: Order) -> Result<(Run, Scene), Error> {
    let resolution = Resolution { elements: 8, refinement: 0, order };
    let scene = two_blocks(ratio);
    Ok((unchecked(&scene, stretched(&two_blocks(1.0), ratio, resolution)?, resolution)?, scene))
}

/// Truncated Hertz and its mirror image, `ratio` times as high: each carries Hertz's tractions, and with twice the
/// curvature between them each does what it does on the rigid parabola.
pub(super) fn two_blocks(ratio: f64) -> Scene {
    let numbers = TruncatedHertz::default();
    let side = numbers.size * numbers.half_width();
    let radius = 0.5 * numbers.radius;
    let (mut scene, _, _) = problem::truncated_hertz(numbers);
    let mut lower = scene.bodies[0].clone();
    lower.name = "lower block".into();
    lower.shape = Shape::Rectangle { x: [0.0, side], y: [-ratio * side, 0.0], contact: Face::Top };
    let corner = Place::Point([0.0, -ratio * side]);
    lower.supports.push(Support { at: corner, component: Component::Y, value: 0.0 });
    for load in &mut lower.loads {
        if let Load::Stress { field, .. } = load {
            let upper = field.0.clone();
            *field = StressField(Arc::new(move |[x, y]: [f64; 2]| {
                let [along, across, shear] = upper([x, -y]);
                [along, across, -shear]
            }));
        }
    }
    scene.bodies.push(lower);
    scene.contacts[0].second = Some(1);
    scene.contacts[0].profile = Profile::Parabola { radius };
    scene.reference.gap *= 2.0;
    scene
}

/// Largest departure from the uniform pressure of the patch test.
fn patch_error(ratio: f64, order: Order) -> Result<f64, Error> {
    let numbers = Patch::default();
    let resolution = Resolution { elements: 3, refinement: 0, order };
    let scene = numbers.scene();
    let run = unchecked(&scene, stretched(&scene, ratio, resolution)?, resolution)?;
    let departures = run.solution.points.iter().map(|point| point.pressure / numbers.pressure - 1.0);
    Ok(departures.fold(0.0, worse))
}
