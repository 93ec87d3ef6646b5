//! How large a mesh would be, before it is made.

use std::f64::consts::PI;

use crate::mesh::Resolution;
use crate::scene::{ContactPair, Path, Scene, Shape};

/// Most cells and most candidate elements that are meshed: a solve then stays within about 4 GB.
pub const MOST: [f64; 2] = [500e3, 2e3];

/// About how many cells and how many candidate elements a mesh would have.
pub fn expected(scene: &Scene, resolution: Resolution) -> [f64; 2] {
    let sizes: Vec<[f64; 2]> = (0..scene.bodies.len()).map(|body| of_body(scene, resolution, body)).collect();
    let cells: f64 = sizes.iter().map(|[cells, _]| cells).sum();
    let largest = sizes.iter().map(|[_, candidates]| *candidates).fold(0.0, f64::max);
    let halved = 2.0_f64.powi(resolution.refinement as i32);
    // Cells of order p count as the 8-node ones, two intervals wide, that have as many nodes along a side.
    let wide = resolution.order.intervals() as f64 / 2.0;
    [cells * (halved * wide).powi(2), largest * halved * wide]
}

/// Cells and candidate elements of one body.
fn of_body(scene: &Scene, resolution: Resolution, body: usize) -> [f64; 2] {
    let (pair, grading) = (scene.contact_of(body), &scene.grading);
    let index = body;
    let own = || scene.contacts_of(index);
    let touching = own().map(move |pair| pair.side(index));
    let body = &scene.bodies[index];
    let length = pair.stretch * pair.path.metric();
    let kinks_of = |pair: &ContactPair| pair.profile.kinks().iter().filter(|s| **s < pair.stretch).count() as f64;
    let elements = resolution.elements as f64 * body.density;
    let counted_on = |length: f64| (elements * length / grading.unit).round().max(1.0);
    let sides_of = |pair: &ContactPair| if pair.path.has_both_sides() { 2.0 } else { 1.0 };
    let (candidates, sides) = (counted_on(length) + kinks_of(pair), sides_of(pair));
    let others = || own().filter(|other| !std::ptr::eq(*other, pair));
    let more: f64 = others()
        .map(|other| sides_of(other) * (counted_on(other.stretch * other.path.metric()) + kinks_of(other)))
        .sum();
    // The smallest of the candidates, as a length and in the contact coordinate.
    let even = grading.end.min(1.0 / grading.end);
    let [mut size, mut step] = [length, pair.stretch].map(|whole| even * whole / candidates);
    for other in others() {
        let whole = other.stretch * other.path.metric();
        size = size.min(whole / counted_on(whole));
        step = if other.path.is_straight() { step } else { step.min(other.stretch / counted_on(whole)) };
    }
    let counted = |length: f64, first: f64, ratio: f64, coarsest: f64| {
        let until = if ratio > 1.0 { (coarsest / first).ln().max(0.0) / ratio.ln() } else { f64::INFINITY };
        (length / first).min(until + length / coarsest.max(first)) + 2.0
    };
    // Rows of the arcs' blocks share the size of the surface, whatever the radius of the body.
    let arc = |[size, step]: [f64; 2], radius: f64, deep: f64| {
        let angle = if matches!(pair.path, Path::Arc(_)) { step } else { size / radius };
        let first = angle * radius * grading.first;
        let along = counted(PI, angle, grading.along, 1.6 * grading.coarsest);
        [along, counted(deep, first, grading.depth, grading.coarsest * deep)]
    };
    let structured = || {
        let [along, depth] = match body.shape {
            Shape::Rectangle { x, y, .. } => [(x, size, grading.along), (y, size * grading.first, grading.depth)]
                .map(|([from, to], first, ratio)| counted(to - from, first, ratio, grading.coarsest * (to - from))),
            Shape::Disc { radius, .. } => arc([size, step], radius, radius),
            Shape::Ring { inner, outer, .. } => arc([size, step], inner.radius, outer.radius - inner.radius),
            Shape::Eye { outer_radius, .. } => arc([size, step], outer_radius, outer_radius),
            Shape::Blocks(_) | Shape::Given(_) => [0.0, 0.0],
        };
        let others = others().count() as f64;
        let columns = sides * (candidates + along) + more + 2.0 * others * along;
        columns * (candidates.min(along) + depth * (1.0 + others.min(1.0)))
    };
    match &body.shape {
        Shape::Given(mesh) => {
            let touching = touching.map(|side| mesh.boundaries.get(side).map_or(0, Vec::len) as f64);
            [mesh.cells.len() as f64, touching.sum()]
        }
        Shape::Blocks(blocks) => {
            let cells = blocks.iter().map(|block| block.elements[0] as f64 * block.elements[1] as f64).sum();
            let sides = blocks.iter().flat_map(|block| (0..4).map(move |k| (&block.names[k], block.elements[k % 2])));
            let elements = |side: &str| -> f64 {
                let own = sides.clone().filter(|(name, _)| name.as_deref() == Some(side));
                own.map(|(_, n)| n as f64).sum()
            };
            [cells, touching.map(elements).sum()]
        }
        _ => [structured(), sides * candidates + more],
    }
}

/// Whether a mesh stays within [`MOST`], before anything is allocated for it; else what is wrong, and what to do.
pub fn solvable(scene: &Scene, resolution: Resolution) -> Result<(), (String, String)> {
    let [total, candidates] = expected(scene, resolution);
    let [most, along] = MOST;
    if total <= most && candidates <= along {
        return Ok(());
    }
    let message = format!("the mesh would have about {total:.1e} cells and {candidates:.0} candidate elements");
    let kinks = scene.contacts.iter().map(|pair| pair.profile.kinks().len()).max().unwrap_or(0);
    let smooth = if kinks > resolution.elements { "`smooth = true` for the table, " } else { "" };
    let remedy = format!(
        "ask for {smooth}fewer `elements`, a longer `stretch` or faster growth: {most:.0e} and {along} are solved"
    );
    Err((message, remedy))
}
