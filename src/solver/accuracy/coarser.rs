//! The same scene on coarser meshes of the same family, on the next finer one, and on one whose growth alone is
//! gentler.

use crate::mesh::size::expected;
use crate::mesh::{Order, Resolution};
use crate::scene::{BlockShape, Body, Load, Scene, Shape};

/// Element sizes over those of the mesh: whole numbers of candidates make them uneven, which is welcome: an end of the
/// contact lies at another place of its element on each. With rounder ratios those numbers would hang on round-off.
pub const RATIOS: [f64; 4] = [1.99, 2.51, 3.17, 3.97];
/// Those of small meshes: they cost nothing there, and on half as many elements little is left of a contact.
pub const CLOSE: [f64; 4] = [1.59, 1.99, 2.51, 3.17];
/// By how much the growth is gentler: as that of a mesh with so many times as many elements.
const GENTLER: f64 = 2.0;
/// Layers that halve the error of an end as often as twice the cells do.
const MORE: usize = 2;
/// Cells of a small mesh.
const SMALL: f64 = 2e3;

/// The coarser meshes, from the finest on; none where a mesh made elsewhere was not halved.
///
/// Where mesh lines lie on the ends of a contact, these are cells of lower order at the same places, down to order 4;
/// below that there are 8-node cells only.
///
/// Growth and coarsest element follow the elements of the contact, as they do in refinement; blocks have fewer
/// elements; a mesh made elsewhere has only those that it was halved from.
pub fn coarser(scene: &Scene, resolution: Resolution) -> Vec<(Scene, Resolution)> {
    if scene.bodies.iter().any(|body| matches!(body.shape, Shape::Given(_))) {
        let halved = (0..resolution.refinement).rev().take(RATIOS.len());
        return halved.map(|refinement| (scene.clone(), Resolution { refinement, ..resolution })).collect();
    }
    if scene.contacts.iter().any(|pair| !pair.ends.places.is_empty()) {
        let lowest = if resolution.order > Order::Quartic { Order::Quartic } else { Order::Quadratic };
        let lower = Order::ALL.into_iter().rev().filter(|order| (lowest..resolution.order).contains(order));
        return lower.take(RATIOS.len()).map(|order| (scene.clone(), Resolution { order, ..resolution })).collect();
    }
    let [cells, _] = expected(scene, resolution);
    let ratios = if cells < SMALL { CLOSE } else { RATIOS };
    ratios.into_iter().map(|ratio| (by(scene, resolution, ratio), resolution)).collect()
}

/// The next mesh of those that end with the contact: cells of the next order with a layer more, and beyond the highest
/// order twice as many cells with two layers more.
pub fn finer(scene: &Scene, resolution: Resolution) -> (Scene, Resolution) {
    let next = Order::numbered(usize::from(resolution.order.number()) + 1);
    let (layers, resolution) = match next {
        Some(order) => (1, Resolution { order, ..resolution }),
        None => (MORE, Resolution { elements: 2 * resolution.elements, ..resolution }),
    };
    let mut scene = scene.clone();
    scene.contacts.iter_mut().for_each(|pair| pair.ends.layers += layers);
    (scene, resolution)
}

/// The scene with the same elements on the contacts and gentler growth away from them; none where no far cell decides.
///
/// Far cells are few on a body that bends, approximate a curved side by chords, are large at the corner of a clamped
/// side and where a load ends within a side; all of a body takes part where bodies are pressed by their interference.
/// Coarser meshes may have the same cells there, and what these leave cancels from every difference.
pub fn gentler(scene: &Scene, resolution: Resolution) -> Option<(Scene, Resolution)> {
    let has_other_family = scene.bodies.iter().any(|body| matches!(body.shape, Shape::Given(_)))
        || scene.contacts.iter().any(|pair| !pair.ends.places.is_empty());
    let grading = resolution.order.refined(&scene.grading, GENTLER);
    let interferes = scene.contacts.iter().any(|pair| pair.profile.interferes());
    let matter =
        interferes || scene.bends() || scene.bodies.iter().any(|body| body.is_clamped() || is_loaded_far(body));
    (matter && !has_other_family).then(|| (Scene { grading, ..scene.clone() }, resolution))
}

/// Whether the size of far cells decides about a load: own weight of a body with a curved side, or a load that ends
/// within a side.
fn is_loaded_far(body: &Body) -> bool {
    let is_round = matches!(body.shape, Shape::Disc { .. } | Shape::Ring { .. } | Shape::Eye { .. });
    body.loads.iter().any(|load| match load {
        Load::BodyForce(_) => is_round,
        Load::OnSide { part, .. } => part.is_some(),
        Load::Force { .. } | Load::RigidFace { .. } => false,
    })
}

/// The scene with elements larger by a ratio.
fn by(scene: &Scene, resolution: Resolution, ratio: f64) -> Scene {
    let mut scene = scene.clone();
    scene.grading = resolution.order.coarsened(&scene.grading, ratio);
    for body in &mut scene.bodies {
        if let Shape::Blocks(blocks) = &mut body.shape {
            blocks.iter_mut().for_each(|block| fewer(block, ratio));
        }
    }
    scene
}

fn fewer(block: &mut BlockShape, ratio: f64) {
    for (elements, growth) in block.elements.iter_mut().zip(&mut block.growth) {
        let fewer = (*elements as f64 / ratio).round().max(1.0);
        *growth = growth.powf(*elements as f64 / fewer);
        *elements = fewer as usize;
    }
}
