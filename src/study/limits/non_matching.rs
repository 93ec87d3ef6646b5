//! Limit of the interface: non-matching meshes.

use serde::Serialize;

use crate::case::library::Patch;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Scene;
use crate::solve::run::{Errors, Run};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::{
    ORDERS, exceeds, hertz_errors, largest, meshed, patch_error, verified, with_both_orders, worst,
};
use crate::study::limits::unequal_sizes::two_blocks;
use crate::study::limits::written::{bracket, number, percents, range, size, within};

/// Error that counts as wrong.
const WRONG: f64 = 0.01;
/// Departure from a uniform pressure that the iteration, of tolerance 1e-9, explains.
const EXACT: f64 = 1e-8;
/// Elements of the second body over those of the first.
const DENSITIES: [f64; 9] = [0.1, 0.2, 0.5, 0.8, 1.0, 1.25, 2.0, 2.3, 5.0];
/// Coarsest second body opposite which 8-node cells must find the contact.
const COARSE: f64 = 0.5;

/// The patch test and Hertz across meshes that do not match.
#[derive(Clone, Debug, Serialize)]
pub struct NonMatching {
    /// By density, with 4-node and 8-node cells.
    pub densities: Vec<[AtDensity; 2]>,
}

/// Runs at one density.
#[derive(Clone, Debug, Serialize)]
pub struct AtDensity {
    /// Largest error of the patch test, by contact element.
    pub patch: Vec<f64>,
    /// Two blocks with Hertz's tractions, the contact points on the first and on the second.
    pub blocks: [Blocks; 2],
}

/// A run of two blocks.
#[derive(Clone, Debug, Serialize)]
pub struct Blocks {
    /// Errors against Hertz.
    pub errors: Errors,
    /// Difference of the contact forces on the two bodies and of their moments, over the force and the force times the stretch.
    pub unbalanced: f64,
    /// What the user sees.
    pub seen: Seen,
}

/// Every density with both kinds of cells.
pub(super) fn run() -> Result<NonMatching, Error> {
    Ok(NonMatching { densities: with_both_orders(&DENSITIES, at_density)? })
}

fn at_density(density: f64, order: Order) -> Result<AtDensity, Error> {
    let patch = Element::ALL.into_iter().map(|element| patch(element, order, density));
    let mut scene = two_blocks(1.0);
    scene.bodies[1].density = density;
    let [first, second] = [scene.clone(), exchanged(&scene)].map(|scene| blocks(scene, order));
    Ok(AtDensity { patch: patch.collect::<Result<_, _>>()?, blocks: [first?, second?] })
}

/// The scene with the contact points on its second body.
fn exchanged(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    (scene.contacts[0].first, scene.contacts[0].second) = (1, Some(0));
    scene.contacts[0].above = false;
    scene
}

fn patch(element: Element, order: Order, density: f64) -> Result<f64, Error> {
    let numbers = Patch::default();
    let mut scene = numbers.scene();
    scene.bodies[1].density = density;
    let formulation = Formulation::new(element, Iteration::Kinematic).tolerance(1e-9);
    Ok(patch_error(&numbers, &Run::of(&meshed(scene, 10, order)?, &formulation)?))
}

fn blocks(scene: Scene, order: Order) -> Result<Blocks, Error> {
    let discretisation = meshed(scene, 8, order)?;
    let run = verified(&discretisation)?;
    Ok(Blocks {
        errors: hertz_errors(&discretisation.scene, &run),
        unbalanced: unbalanced(&discretisation, &run),
        seen: Seen::of(&Ok(run)),
    })
}

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
    largest([(force - other) / force, (moment - opposite) / (force * arm)])
}

impl NonMatching {
    fn all(&self) -> impl Iterator<Item = &AtDensity> {
        self.densities.iter().flatten()
    }

    fn patch(&self) -> f64 {
        largest(self.all().flat_map(|found| found.patch.iter().copied()))
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let unbalanced = self.all().flat_map(|found| &found.blocks).map(|blocks| blocks.unbalanced);
        let fine = DENSITIES.iter().zip(&self.densities).filter(|(density, _)| **density >= COARSE);
        vec![
            Check::error(
                Quantity::at(
                    "largest |p − q| / q of the patch test across meshes that do not match",
                    "all elements, both orders",
                ),
                Reference::analytic("the uniform pressure", 0.0),
                EXACT,
                "exact but for the iteration: both sides integrate the same pressure",
            )
            .judge(self.patch()),
            Check::error(
                Quantity::at(
                    "difference of the contact forces on both bodies and of their moments",
                    "over the force on the first, and over the force times the stretch",
                ),
                Reference::own("action and reaction", 0.0),
                1e-10,
                "round-off: the weights of the nodes on the other side reproduce constants and the coordinate itself",
            )
            .judge(largest(unbalanced)),
            Check::error(
                Quantity::at(
                    "largest error of p₀ and a at points opposite a side up to twice as coarse as their own, or finer",
                    "8-node, node element",
                ),
                Reference::analytic("Hertz", 0.0),
                WRONG,
                "engineering tolerance of the paper's comparison, 8 cells per half-width on the first body",
            )
            .judge(worst(fine.map(|(_, [_, eight])| eight.blocks[0].errors))),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let coarseness = DENSITIES.map(|density| 1.0 / density);
        let (coarseness, found): (Vec<f64>, Vec<_>) = coarseness.into_iter().zip(&self.densities).rev().unzip();
        let onset = |k: usize| {
            let wrong = |i: usize| exceeds(found[i][k].blocks[0].errors.largest(), WRONG);
            bracket(&coarseness, wrong, "coarseness")
        };
        let last = self.all().last().map(|found| found.blocks[1].seen.to_string()).unwrap_or_default();
        Limit {
            pushed: "non-matching meshes",
            range: range(&DENSITIES, "elements of the second body over those of the first"),
            onset: format!(
                "error beyond {}: 4-node {}; 8-node {}; largest error of the patch test {}",
                size(WRONG),
                onset(0),
                onset(1),
                within(self.patch(), EXACT)
            ),
            seen: format!("{last}; only a finer mesh shows the error"),
            instead: "contact points on the finer side: name its body as `first`".into(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |density: f64, order: Order, found: &AtDensity| {
            let first = [number(density), format!("{}-node", order.nodes_per_cell())];
            let patch = found.patch.iter().map(|&error| within(error, EXACT));
            let blocks = found.blocks.iter().flat_map(|blocks| percents(blocks.errors));
            first.into_iter().chain(patch).chain(blocks).collect()
        };
        let rows = DENSITIES.into_iter().zip(&self.densities).flat_map(|(density, found)| {
            ORDERS.into_iter().zip(found).map(move |(order, found)| row(density, order, found))
        });
        let patch = Element::ALL.map(|element| format!("patch: {}", element.name()));
        let head: Vec<&str> = ["elements, second / first", "cells"]
            .into_iter()
            .chain(patch.iter().map(String::as_str))
            .chain(["Hertz, node element: p₀", "a", "points on the second: p₀", "a"])
            .collect();
        Detail::of(
            "Two blocks whose meshes do not match: largest error of a uniform pressure, and with Hertz's tractions",
            &head,
            rows,
        )
    }
}
