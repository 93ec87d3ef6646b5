//! How large a mesh would be, before it is made.

use std::f64::consts::PI;

use crate::mesh::block::Block;
use crate::mesh::outline::{Layout, cells_at_bore, widest};
use crate::mesh::{Order, Resolution};
use crate::scene::{Body, ContactPair, Face, Path, Scene, Shape};

/// Most cells, and most candidate elements whose nodes share one dense matrix: a solve with its bars then stays within
/// about 8 GB.
pub const MOST: [f64; 2] = [500e3, 2e3];
/// Bytes of a solve with its bars by the cell, and by the square of the candidate elements: 5e3 to 14e3 by the cell of
/// 400 small bodies and of a large one, and four matrices of two nodes an element on each body.
const BYTES: [f64; 2] = [12e3, 512.0];

/// Retained dofs, or candidate elements, from which on those of many bodies share no dense matrix, and the part of it
/// that their blocks fill at most.
const APART: (f64, f64) = (2000.0, 0.125);

/// Whether the stiffness of bodies of some sizes is better kept body by body than as one dense matrix.
pub fn is_sparse<T: Iterator<Item = f64>>(sizes: impl Fn() -> T) -> bool {
    let (least, filled) = APART;
    let total: f64 = sizes().sum();
    total >= least && sizes().map(|size| size * size).sum::<f64>() <= filled * total * total
}

/// About how many cells and how many candidate elements a mesh would have; of a contact those of its finer body count.
pub fn expected(scene: &Scene, resolution: Resolution) -> [f64; 2] {
    let cells: f64 = (0..scene.bodies.len()).map(|body| cells(scene, resolution, body)).sum();
    let of_pair =
        |pair: &ContactPair| pair.bodies().map(|b| candidates(scene, resolution, b, pair)).fold(0.0, f64::max);
    let along: f64 = scene.contacts.iter().map(of_pair).sum();
    [cells * finer(resolution).powi(2), along * finer(resolution)]
}

/// Estimated cells up to which those of a mesh that may be too large are counted.
const COUNTED: f64 = 2e7;

/// How many cells a mesh would have: as estimated where so many are solved; else counted on the sides of its blocks,
/// before any cell is made, since the estimate is many times too high where two contacts share a body.
pub fn cells_of(scene: &Scene, resolution: Resolution) -> f64 {
    let [estimated, _] = expected(scene, resolution);
    if estimated <= MOST[0] || estimated > COUNTED || scene.validate().is_err() {
        return estimated;
    }
    let plain = Resolution { refinement: 0, order: Order::Quadratic, ..resolution };
    let counted = |body: usize| match &scene.bodies[body].shape {
        Shape::Blocks(_) | Shape::Given(_) => cells(scene, plain, body),
        shape => {
            let blocks = Layout::new(scene, plain, body).blocks(shape);
            let of = |block: &Block| block.size().map(|points| (points - 1) as f64 / 2.0).iter().product::<f64>();
            blocks.iter().map(of).sum()
        }
    };
    finer(resolution).powi(2) * (0..scene.bodies.len()).map(counted).sum::<f64>()
}

/// Elements along a side over those that the scene asks for, where cells of order p count as the 8-node ones, two
/// intervals wide, that have as many nodes along it.
fn finer(resolution: Resolution) -> f64 {
    2.0_f64.powi(resolution.refinement as i32) * resolution.order.intervals() as f64 / 2.0
}

/// Candidate elements of which one dense matrix would take as much memory as what is solved: all together, or where
/// bodies are kept apart `√Σ n²` over the n of each.
pub fn dense(scene: &Scene, resolution: Resolution) -> f64 {
    let [_, along] = expected(scene, resolution);
    let of_body = |body: usize| {
        finer(resolution) * scene.contacts_of(body).map(|pair| candidates(scene, resolution, body, pair)).sum::<f64>()
    };
    let sizes = || (0..scene.bodies.len()).map(of_body);
    if is_sparse(sizes) { sizes().map(|n| n * n).sum::<f64>().sqrt() } else { along }
}

/// About how many bytes a solve takes.
fn bytes(cells: f64, dense: f64) -> f64 {
    BYTES[0] * cells + BYTES[1] * dense * dense
}

/// Candidate elements of a body for one of its contacts.
fn candidates(scene: &Scene, resolution: Resolution, body: usize, pair: &ContactPair) -> f64 {
    let (side, body) = (pair.side(body), &scene.bodies[body]);
    match &body.shape {
        Shape::Given(mesh) => mesh.boundaries.get(side).map_or(0.0, |edges| edges.len() as f64),
        Shape::Blocks(blocks) => {
            let sides = blocks.iter().flat_map(|block| (0..4).map(move |k| (&block.names[k], block.elements[k % 2])));
            sides.filter(|(name, _)| name.as_deref() == Some(side)).map(|(_, n)| n as f64).sum()
        }
        _ => sides_of(pair) * along(scene, resolution, body, pair),
    }
}

/// Parts of a contact on either side of s = 0.
fn sides_of(pair: &ContactPair) -> f64 {
    if pair.path.has_both_sides() { 2.0 } else { 1.0 }
}

/// Candidate elements on one side of s = 0, of a body that is meshed for its contacts.
fn along(scene: &Scene, resolution: Resolution, body: &Body, pair: &ContactPair) -> f64 {
    let kinks = pair.profile.kinks().iter().filter(|s| **s < pair.stretch).count() as f64;
    counted_on(scene, resolution, body, pair.stretch * pair.path.metric()) + kinks
}

/// Elements on a length of a body's surface.
fn counted_on(scene: &Scene, resolution: Resolution, body: &Body, length: f64) -> f64 {
    (resolution.elements as f64 * body.density * length / scene.grading.unit).round().max(1.0)
}

/// Cells of one body.
fn cells(scene: &Scene, resolution: Resolution, index: usize) -> f64 {
    let (pair, grading, body) = (scene.contact_of(index), &scene.grading, &scene.bodies[index]);
    let length = pair.stretch * pair.path.metric();
    let counted_on = |length: f64| counted_on(scene, resolution, body, length);
    let (candidates, sides) = (along(scene, resolution, body, pair), sides_of(pair));
    let others = || scene.contacts_of(index).filter(|other| !std::ptr::eq(*other, pair));
    let more: f64 = others().map(|other| sides_of(other) * along(scene, resolution, body, other)).sum();
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
        let along = counted(PI, angle, grading.along, widest(&body.shape, grading, resolution.order));
        [along, counted(deep, first, grading.depth, grading.coarsest * deep)]
    };
    let structured = || {
        let [along, depth] = match body.shape {
            Shape::Rectangle { x, y, .. } => [(x, size, grading.along), (y, size * grading.first, grading.depth)]
                .map(|([from, to], first, ratio)| counted(to - from, first, ratio, grading.coarsest * (to - from))),
            Shape::Disc { radius, .. } => arc([size, step], radius, radius),
            Shape::Ring { inner, outer, contact, .. } => {
                let of_radii = |face: f64| arc([size, step], face, outer.radius - inner.radius);
                let at_bore = || cells_at_bore([inner.radius, outer.radius], grading.coarsest);
                match contact {
                    Face::Top => of_radii(outer.radius).map(|count| count.max(at_bore())),
                    Face::Bottom => of_radii(inner.radius),
                }
            }
            Shape::Eye { outer_radius, .. } => arc([size, step], outer_radius, outer_radius),
            Shape::Blocks(_) | Shape::Given(_) => [0.0, 0.0],
        };
        let others = others().count() as f64;
        let columns = sides * (candidates + along) + more + 2.0 * others * along;
        columns * (candidates.min(along) + depth * (1.0 + others.min(1.0)))
    };
    match &body.shape {
        Shape::Given(mesh) => mesh.cells.len() as f64,
        Shape::Blocks(blocks) => blocks.iter().map(|block| block.elements[0] as f64 * block.elements[1] as f64).sum(),
        _ => structured(),
    }
}

/// Whether a mesh stays within [`MOST`], before anything is allocated for it; else what is wrong, and what to do.
pub fn solvable(scene: &Scene, resolution: Resolution) -> Result<(), (String, String)> {
    let (total, [_, candidates]) = (cells_of(scene, resolution), expected(scene, resolution));
    let ([most, along], dense) = (MOST, dense(scene, resolution));
    if total <= most && dense <= along {
        return Ok(());
    }
    let together = match scene.contacts.len() {
        1 => String::new(),
        contacts => format!(" in all {contacts} contacts together"),
    };
    let message = format!(
        "the mesh would have about {total:.1e} cells and {candidates:.0} candidate elements{together}, which take some \
        {:.1e} bytes",
        bytes(total, dense)
    );
    let kinks = scene.contacts.iter().map(|pair| pair.profile.kinks().len()).max().unwrap_or(0);
    let smooth = if kinks > resolution.elements { "`smooth = true` for the table, " } else { "" };
    let scenes = if scene.contacts.len() > 1 { ", or make scenes of fewer contacts" } else { "" };
    let remedy = format!(
        "ask for {smooth}fewer `elements`, a longer `per`, a shorter `stretch` or faster growth{scenes}: {most:.0e} \
        cells and {along} candidate elements of one body are solved, in some {:.0e} bytes",
        bytes(most, along)
    );
    Err((message, remedy))
}
