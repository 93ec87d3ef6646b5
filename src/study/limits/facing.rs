//! Nodes that do not face one another: the patch test and Hertz across meshes of different sizes.

use super::interface::two_blocks;
use super::{Limit, bracket, hertz_errors, number, percent, range, seen, size, table, within, worse};
use crate::case::library::Patch;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::unsorted::Finding;

/// Error that counts as wrong.
const WRONG: f64 = 0.01;
/// Departure from a uniform pressure that the iteration, of tolerance 1e-9, explains.
const EXACT: f64 = 1e-8;
/// Elements of the second body over those of the first.
const DENSITIES: [f64; 9] = [0.1, 0.2, 0.5, 0.8, 1.0, 1.25, 2.0, 2.3, 5.0];

/// Meshes that do not match.
pub(super) fn across() -> Result<Finding, Error> {
    let (mut rows, mut errors, mut patch, mut apart) = (Vec::new(), Vec::new(), 0.0_f64, 0.0_f64);
    let mut last = String::new();
    for density in DENSITIES {
        let mut worst = [f64::NAN; 2];
        for (slot, order) in worst.iter_mut().zip([Order::Linear, Order::Quadratic]) {
            let mut cells = vec![number(density), format!("{}-node", order.nodes_per_cell())];
            for element in Element::ALL {
                let uniform = patch_error(element, order, density)?;
                patch = worse(patch, uniform);
                cells.push(within(uniform, EXACT));
            }
            for swapped in [false, true] {
                let (scene, run, unbalanced) = curved(order, density, swapped)?;
                apart = worse(apart, unbalanced);
                let [peak, width] = hertz_errors(&scene, &run);
                *slot = if swapped { *slot } else { worse(peak, width) };
                cells.extend([percent(peak), percent(width)]);
                last = seen(&Ok(run));
            }
            rows.push(cells);
        }
        errors.push(worst);
    }
    let from = DENSITIES.iter().position(|density| *density >= 0.5).unwrap_or(0);
    let checks = vec![
        Judged::norm(
            "The patch test shall hold across meshes that do not match",
            "largest |p − q| / q, all elements, both orders",
            patch,
            Reference::analytic("uniform pressure", 0.0),
            EXACT,
            "exact but for the iteration: both sides integrate the same pressure",
        ),
        Judged::norm(
            "Contact forces on both bodies shall have one resultant and one line of action",
            "difference over the force on the first, moment about s = 0 over the force times the stretch",
            apart,
            Reference::own("action and reaction", 0.0),
            1e-10,
            "round-off: the weights of the facing nodes reproduce constants and the coordinate itself",
        ),
        Judged::norm(
            "Points opposite a side up to twice as coarse as their own, or finer, shall find the contact",
            "largest error of p₀ and a, 8-node, node element",
            errors[from..].iter().fold(0.0, |worst, [_, eight]| worse(worst, *eight)),
            Reference::analytic("Hertz", 0.0),
            WRONG,
            "engineering tolerance of the paper's comparison, 8 cells per half-width on the first body",
        ),
    ];
    let coarse: Vec<f64> = DENSITIES.iter().rev().map(|density| 1.0 / density).collect();
    let onset = |k: usize| bracket(&coarse, |i| errors[DENSITIES.len() - 1 - i][k] > WRONG, "coarseness").0;
    let limit = Limit {
        pushed: "nodes that do not face one another",
        range: range(&DENSITIES, "elements of the second body over those of the first"),
        onset: format!(
            "error beyond {}: 4-node {}; 8-node {}; largest error of the patch test {}",
            size(WRONG),
            onset(0),
            onset(1),
            within(patch, EXACT)
        ),
        seen: format!("{last}; only a finer mesh shows the error"),
        instead: "contact points on the finer side: name its body as `first`".into(),
    };
    let head = [
        "elements, second / first",
        "cells",
        "patch: line",
        "layer",
        "node",
        "Hertz, node element: p₀",
        "a",
        "points on the second: p₀",
        "a",
    ];
    let title = "Two blocks whose meshes do not match: largest error of a uniform pressure, and with Hertz's tractions";
    Ok(limit.finding(vec![table(title, &head, rows)], checks))
}

/// The scene with the contact points on its second body.
fn exchanged(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    (scene.contacts[0].first, scene.contacts[0].second) = (1, Some(0));
    scene.contacts[0].above = false;
    scene
}

/// Largest departure from the uniform pressure of the patch test.
fn patch_error(element: Element, order: Order, density: f64) -> Result<f64, Error> {
    let numbers = Patch::default();
    let mut scene = numbers.scene();
    scene.bodies[1].density = density;
    let discretisation = Discretisation::of(scene, Resolution { elements: 10, refinement: 0, order })?;
    let run = Run::of(&discretisation, &Formulation::new(element, Iteration::Kinematic).tolerance(1e-9))?;
    let departures = run.solution.points.iter().map(|point| point.pressure / numbers.pressure - 1.0);
    Ok(if run.solution.converged() { departures.fold(0.0, worse) } else { f64::NAN })
}

/// Two blocks with Hertz's tractions, the second with `density` times the elements of the first; and by how much the
/// contact forces on them differ.
fn curved(order: Order, density: f64, swapped: bool) -> Result<(Scene, Run, f64), Error> {
    let mut scene = two_blocks(1.0);
    scene.bodies[1].density = density;
    let scene = if swapped { exchanged(&scene) } else { scene };
    let discretisation = Discretisation::of(scene.clone(), Resolution { elements: 8, refinement: 0, order })?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let unbalanced = unbalanced(&discretisation, &run);
    Ok((scene, run, unbalanced))
}

/// Difference of the contact forces on the two bodies and of their moments, over the force and the force times the stretch.
fn unbalanced(discretisation: &Discretisation, run: &Run) -> f64 {
    let of_body = |body: usize| {
        let offset = discretisation.condensed.offsets[body];
        let candidates = discretisation.mesh.bodies[body].candidates.iter().enumerate();
        candidates.fold([0.0; 2], |[force, moment], (index, candidate)| {
            let pressing = run.solution.contact_force[offset + index];
            [force + pressing, moment + pressing * candidate.coordinate]
        })
    };
    let ([force, moment], [other, opposite]) = (of_body(0), of_body(1));
    let arm = discretisation.scene.contact().stretch;
    worse((force - other) / force, (moment - opposite) / (force * arm))
}
