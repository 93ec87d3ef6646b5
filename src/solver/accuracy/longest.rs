//! How far candidates may go.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use crate::scene::{ContactPair, Profile, Scene, Shape};

/// Longest candidates over the distance to the next contact on the same side: a little less than halfway, since a node
/// belongs to one contact.
const BETWEEN: f64 = 0.49;

/// Longest candidates of a contact that the sides of its bodies and the gap allow \[mm, or rad\].
pub fn longest(scene: &Scene, pair: &ContactPair) -> f64 {
    let (straight, across) = (pair.path.is_straight(), pair.path.has_both_sides());
    let farthest = |points: Vec<[f64; 2]>| {
        let towards = |sign: f64| points.iter().map(|point| sign * pair.path.coordinate(*point)).fold(0.0, f64::max);
        if across { towards(1.0).min(towards(-1.0)) } else { towards(1.0) }
    };
    let round = |body: usize| {
        let (shape, side) = (&scene.bodies[body].shape, pair.side(body));
        // Beyond 45° the radial candidates of a quarter are hardly pressed.
        Some(shape.reach(side, &pair.path)?.min(shape.circle(side)?.radius * FRAC_1_SQRT_2))
    };
    let side = |body: usize| match &scene.bodies[body].shape {
        Shape::Rectangle { x, .. } if across => (x[1] - pair.path.origin()[0]).min(pair.path.origin()[0] - x[0]),
        Shape::Rectangle { x, .. } => x[1] - x[0],
        Shape::Ring { sweep, .. } => sweep.min(FRAC_PI_2),
        Shape::Disc { .. } | Shape::Eye { .. } => FRAC_PI_2,
        Shape::Blocks(blocks) => {
            let sides = blocks.iter().flat_map(|block| (0..4).map(move |k| (block, k)));
            let touching = sides.filter(|(block, k)| block.names[*k].as_deref() == Some(pair.side(body)));
            let ends = touching.map(|(block, k)| [block.corners[k], block.corners[(k + 1) % 4]]);
            farthest(ends.filter(|ends| pair.faces(body, *ends, 0.0)).flatten().collect())
        }
        Shape::Given(mesh) => {
            let edges = mesh.boundaries.get(pair.side(body)).into_iter().flatten();
            let ends = edges.map(|edge| [mesh.points[edge[0]], mesh.points[edge[1]]]);
            farthest(ends.filter(|ends| pair.faces(body, *ends, FRAC_1_SQRT_2)).flatten().collect())
        }
    };
    let next = |other: &ContactPair| {
        let shares = |body: usize| other.bodies().any(|theirs| theirs == body) && other.side(body) == pair.side(body);
        let apart = (other.path.origin()[0] - pair.path.origin()[0]).abs();
        if straight && other.path.is_straight() && apart > 0.0 && pair.bodies().any(shares) {
            BETWEEN * apart
        } else {
            f64::INFINITY
        }
    };
    let neighbours = scene.contacts.iter().map(next);
    pair.bodies().map(|body| round(body).unwrap_or_else(|| side(body))).chain(neighbours).fold(of_gap(pair), f64::min)
}

/// How far a gap goes \[mm, or rad\].
fn of_gap(pair: &ContactPair) -> f64 {
    let profile = &pair.profile;
    match *profile {
        Profile::Punch { half_width } => half_width,
        // Beyond the trough the next crest comes near, unless the candidates shall hold it too.
        Profile::Cosine { wavelength, .. } => (0.5 * wavelength).max(pair.stretch),
        _ if profile.is_by_points() => {
            let towards = |side: f64| profile.places().iter().map(|s| side * s).fold(0.0, f64::max);
            towards(1.0).min(towards(-1.0))
        }
        _ => profile.reach().map_or(f64::INFINITY, |radius| radius * FRAC_1_SQRT_2),
    }
}
