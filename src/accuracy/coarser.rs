//! The same scene on coarser meshes of the same family.

use std::sync::Arc;

use crate::mesh::size::expected;
use crate::mesh::{Order, Resolution};
use crate::scene::{BlockShape, GivenMesh, Scene, Shape};

/// Element sizes over those of the mesh: whole numbers of candidates make them uneven, which is welcome: an end of the contact
/// lies at another place of its element on each. With rounder ratios those numbers would hang on round-off.
pub const RATIOS: [f64; 4] = [1.99, 2.51, 3.17, 3.97];
/// Those of small meshes: they cost nothing there, and on half as many elements little is left of a contact.
pub const CLOSE: [f64; 4] = [1.59, 1.99, 2.51, 3.17];
/// Cells of a small mesh.
const SMALL: f64 = 2e3;

/// The coarser meshes, from the finest on.
///
/// Growth and coarsest element follow the elements of the contact, as they do in refinement; blocks have fewer elements. A mesh
/// made elsewhere has those that it was halved from, here or elsewhere.
pub fn coarser(scene: &Scene, resolution: Resolution) -> Vec<(Scene, Resolution)> {
    if scene.bodies.iter().any(|body| matches!(body.shape, Shape::Given(_))) {
        return of_given(scene, resolution);
    }
    let [cells, _] = expected(scene, resolution);
    let ratios = if cells < SMALL { CLOSE } else { RATIOS };
    ratios.into_iter().map(|ratio| (by(scene, resolution, ratio), resolution)).collect()
}

/// Those of a scene with a mesh made elsewhere. Where nothing was halved, cells without the nodes on their sides; where they have
/// none and are few, the mesh halved: a finer one tells as much.
fn of_given(scene: &Scene, resolution: Resolution) -> Vec<(Scene, Resolution)> {
    let halved =
        (0..resolution.refinement).rev().map(|refinement| (scene.clone(), Resolution { refinement, ..resolution }));
    let once = Resolution { refinement: 0, ..resolution };
    let merged = std::iter::successors(merged(scene, once), |scene| merged(scene, once)).map(|scene| (scene, once));
    let all: Vec<_> = halved.chain(merged).take(RATIOS.len()).collect();
    if !all.is_empty() {
        return all;
    }
    if let Some(scene) = with_given(scene, GivenMesh::without_sides) {
        return vec![(scene, Resolution { order: Order::Linear, ..resolution })];
    }
    let [cells, _] = expected(scene, resolution);
    let finer = Resolution { refinement: resolution.refinement + 1, ..resolution };
    if cells < SMALL { vec![(scene.clone(), finer)] } else { Vec::new() }
}

/// The scene whose meshes are halved to those of this one.
fn merged(scene: &Scene, resolution: Resolution) -> Option<Scene> {
    Some(by(&with_given(scene, GivenMesh::merged)?, resolution, 2.0))
}

/// The scene with other meshes in place of those made elsewhere; none where one of them has no other.
fn with_given(scene: &Scene, other: impl Fn(&GivenMesh) -> Option<GivenMesh>) -> Option<Scene> {
    let mut scene = scene.clone();
    for body in &mut scene.bodies {
        if let Shape::Given(mesh) = &mut body.shape {
            *mesh = Arc::new(other(mesh)?);
        }
    }
    Some(scene)
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
