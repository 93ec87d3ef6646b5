//! The sides of shapes as curves.

use crate::scene::{BlockShape, Circle, Curve};

/// A circle from an angle to another, from the downward vertical \[rad\]: two curves, each less than half a turn.
pub(super) fn of_circle(circle: &Circle, from: f64, to: f64) -> Vec<Curve> {
    let at = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [circle.centre[0] + circle.radius * sin, circle.centre[1] - circle.radius * cos]
    };
    let middle = 0.5 * (from + to);
    let arc = |a: f64, b: f64| Curve::Arc { centre: circle.centre, ends: [at(a), at(b)] };
    vec![arc(from, middle), arc(middle, to)]
}

/// The sides that have a name; none where no side has it.
pub(super) fn of_blocks(blocks: &[BlockShape], name: &str) -> Option<Vec<Curve>> {
    let named = |block: &BlockShape, k: usize| block.names[k].as_deref() == Some(name);
    let curve = |block: &BlockShape, k: usize| {
        let ends = [block.corners[k], block.corners[(k + 1) % 4]];
        block.arcs[k].map_or(Curve::Line(ends), |centre| Curve::Arc { centre, ends })
    };
    let of_block =
        |block: &BlockShape| (0..4).filter(|&k| named(block, k)).map(|k| curve(block, k)).collect::<Vec<_>>();
    let curves: Vec<Curve> = blocks.iter().flat_map(of_block).collect();
    (!curves.is_empty()).then_some(curves)
}
