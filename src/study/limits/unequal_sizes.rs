//! Limit of the interface: elements of unequal depth on its two sides.

use std::sync::Arc;

use serde::Serialize;

use crate::case::library::{Patch, TruncatedHertz};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{Component, Face, Load, Place, Profile, Scene, Shape, StressField, Support};
use crate::solve::run::Errors;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::{exceeds, hertz_errors, largest, patch_error, unchecked, with_both_orders, worst};
use crate::study::limits::written::{bracket, number, percents, range, size, within};

/// Departure from a uniform pressure that round-off explains.
const EXACT: f64 = 1e-9;
/// Error that counts as wrong.
const WRONG: f64 = 0.01;
/// Depth of the elements at the interface, second body over first.
const RATIOS: [f64; 7] = [0.05, 0.2, 1.0, 2.0, 5.0, 10.0, 20.0];
/// Largest ratio at which 8-node cells must find the contact.
const MODERATE: f64 = 5.0;

/// Elements of up to 1:20 across the interface.
#[derive(Clone, Debug, Serialize)]
pub struct UnequalSizes {
    /// By ratio, with 4-node and 8-node cells.
    pub ratios: Vec<[AtRatio; 2]>,
}

/// Runs at one ratio.
#[derive(Clone, Debug, Serialize)]
pub struct AtRatio {
    /// Errors against Hertz of two blocks with its tractions.
    pub errors: Errors,
    /// What the user sees of them.
    pub seen: Seen,
    /// Largest error of the patch test.
    pub patch: f64,
}

/// Every ratio with both kinds of cells.
pub(super) fn run() -> Result<UnequalSizes, Error> {
    Ok(UnequalSizes { ratios: with_both_orders(&RATIOS, at_ratio)? })
}

fn at_ratio(ratio: f64, order: Order) -> Result<AtRatio, Error> {
    let resolution = Resolution { elements: 8, refinement: 0, order };
    let scene = two_blocks(ratio);
    let run = unchecked(&scene, stretched(&two_blocks(1.0), ratio, resolution)?, resolution)?;
    let (patch, coarse) = (Patch::default(), Resolution { elements: 3, ..resolution });
    let uniform = unchecked(&patch.scene(), stretched(&patch.scene(), ratio, coarse)?, coarse)?;
    Ok(AtRatio { errors: hertz_errors(&scene, &run), seen: Seen::of(&Ok(run)), patch: patch_error(&patch, &uniform) })
}

/// The mesh with the nodes of its second body moved to `ratio` times their depth.
fn stretched(scene: &Scene, ratio: f64, resolution: Resolution) -> Result<Mesh, Error> {
    let mut mesh = Mesh::of(scene, resolution)?;
    let nodes = mesh.bodies[1].nodes.clone();
    mesh.points[nodes].iter_mut().for_each(|point| point[1] *= ratio);
    Ok(mesh)
}

/// Truncated Hertz and its mirror image, `ratio` times as high: each carries Hertz's tractions, and with twice the
/// curvature between them each does what it does on the rigid parabola.
pub(super) fn two_blocks(ratio: f64) -> Scene {
    let numbers = TruncatedHertz::default();
    let side = numbers.size * numbers.half_width();
    let radius = 0.5 * numbers.radius;
    let mut scene = numbers.scene();
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

impl UnequalSizes {
    fn patch(&self) -> f64 {
        largest(self.ratios.iter().flatten().map(|found| found.patch))
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let moderate = RATIOS.iter().zip(&self.ratios).filter(|(ratio, _)| **ratio <= MODERATE);
        vec![
            Check::error(
                Quantity::at("largest |p − q| / q of the patch test", "ratios 1/20 to 20"),
                Reference::analytic("the uniform pressure", 0.0),
                EXACT,
                "exact but for round-off: tributary areas come from the interface alone",
            )
            .judge(self.patch()),
            Check::error(
                "largest error of p₀ and a on 8-node cells up to five times as deep on one side",
                Reference::analytic("Hertz", 0.0),
                WRONG,
                "engineering tolerance of the paper's comparison, 8 cells per half-width along the contact",
            )
            .judge(worst(moderate.map(|(_, [_, eight])| eight.errors))),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let onset = |k: usize| bracket(&RATIOS, |i| exceeds(self.ratios[i][k].errors.largest(), WRONG), "ratio");
        let last = self.ratios.last().map(|[_, eight]| eight.seen.to_string()).unwrap_or_default();
        Limit {
            pushed: "element sizes across the interface",
            range: range(&RATIOS, "depth of the elements, second body over first"),
            onset: format!(
                "error beyond {}: 4-node {}; 8-node {}; largest error of the patch test {}",
                size(WRONG),
                onset(0),
                onset(1),
                within(self.patch(), EXACT)
            ),
            seen: format!("{last}; only a finer mesh shows the error"),
            instead: format!("8-node cells, at most {} times as deep on one side", number(MODERATE)),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(ratio, found): (f64, &[AtRatio; 2])| {
            std::iter::once(number(ratio)).chain(found.iter().flat_map(|found| percents(found.errors))).collect()
        };
        Detail::of(
            "Two blocks with Hertz's tractions, the second stretched in depth (errors against Hertz)",
            &["depth, second / first", "4-node: p₀", "a", "8-node: p₀", "a"],
            RATIOS.into_iter().zip(&self.ratios).map(row),
        )
    }
}
