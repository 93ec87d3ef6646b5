//! Sizes of elements where there are several contacts.

use crate::scene::Scene;

/// Gives all contacts of bodies that touch, directly or through others, elements of one size, that of the shortest of them:
/// nodes of both sides then face one another, and other bodies have the size that they need. The grading unit is the longest
/// of these lengths; candidates are `margin` times as long as what they are sized for.
pub(super) fn fit(scene: &mut Scene, margin: f64) {
    let groups = touching(scene);
    let shortest = |group: usize| {
        let own = scene.contacts.iter().filter(|pair| groups[pair.first] == group);
        own.map(|pair| pair.stretch * pair.path.metric()).fold(f64::INFINITY, f64::min) / margin
    };
    let coarsest = |group: usize| {
        let own = scene.bodies.iter().zip(&groups).filter(|(_, other)| **other == group);
        own.map(|(body, _)| body.density).fold(f64::INFINITY, f64::min)
    };
    let unit = scene.contacts.iter().map(|pair| shortest(groups[pair.first])).fold(0.0, f64::max);
    // Bodies that a user made denser than the others they touch stay so.
    let density = |(body, group): (usize, &usize)| match shortest(*group) {
        length if length.is_finite() => scene.bodies[body].density / coarsest(*group) * unit / length,
        _ => scene.bodies[body].density,
    };
    let densities: Vec<f64> = groups.iter().enumerate().map(density).collect();
    scene.bodies.iter_mut().zip(densities).for_each(|(body, density)| body.density = density);
    scene.grading.unit = unit;
}

/// For each body the first of those that it touches, directly or through others.
fn touching(scene: &Scene) -> Vec<usize> {
    let mut groups: Vec<usize> = (0..scene.bodies.len()).collect();
    for pair in &scene.contacts {
        let joined: Vec<usize> = pair.bodies().map(|body| groups[body]).collect();
        let first = joined.iter().copied().min().unwrap_or(0);
        groups.iter_mut().filter(|group| joined.contains(group)).for_each(|group| *group = first);
    }
    groups
}
