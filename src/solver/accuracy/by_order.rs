//! Cells of higher and higher order, fitted to the one contact of a scene, until the error bars of a mesh are within what is asked.
//!
//! They know where the contact ends by a mesh line, and 8-node cells by its pressures alone, so that these take three times as many dofs to
//! tell the half-width. Above 1e-2 8-node cells are as cheap.

use crate::accuracy::fitted::{self, Fitted};
use crate::accuracy::rungs::{Rung, Rungs};
use crate::accuracy::{Asked, Quantity};
use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Scene;
use crate::solve::edge_fitted::{self, Sought};
use crate::solve::{Element, Formulation, Run};

/// Relative error asked for up to which such cells pay, and the same of the half-width.
const PAYS: [f64; 2] = [1e-3 * (1.0 + 1e-9), 1e-2 * (1.0 + 1e-9)];
/// Meshes whose peak and second-moment width are as good as is asked: order and layers, and cells on each piece of the contact side. The first
/// is tried for three digits, the next one for four, and so on.
const OF_PEAK: [(Order, usize, usize); 6] = [
    (Order::Quintic, 1, 1),
    (Order::Sextic, 1, 1),
    (Order::Septic, 2, 1),
    (Order::Octic, 3, 1),
    (Order::Octic, 5, 2),
    (Order::Octic, 7, 3),
];
/// Those whose half-width is, the first for two digits: what is left in it falls to a third with every layer, whatever the order.
const OF_ENDS: [(Order, usize, usize); 7] = [
    (Order::Quintic, 1, 1),
    (Order::Sextic, 1, 1),
    (Order::Sextic, 4, 1),
    (Order::Septic, 6, 1),
    (Order::Octic, 8, 1),
    (Order::Octic, 8, 2),
    (Order::Octic, 10, 3),
];

/// Part of what is asked that ends at rest may leave, as a move that they no longer make, over the half-width: its square is what matters.
const REST: f64 = 0.02;
/// Bar over that of the mesh before, from which on the bars fall too slowly, unless they are as near to what is asked.
const SLOW: f64 = 0.5;
const NEAR: f64 = 3.0;
/// Whether such meshes are tried.
pub(super) fn applies(formulation: &Formulation, asked: &Asked) -> bool {
    let known = |quantity: &Quantity| {
        matches!(quantity, Quantity::PeakPressure | Quantity::HalfWidth | Quantity::SecondMomentWidth)
    };
    let [without, with] = PAYS;
    let pays = if asks_for_ends(asked) { with } else { without };
    asked.relative <= pays && formulation.element == Element::Node && asked.quantities.iter().all(known)
}

fn asks_for_ends(asked: &Asked) -> bool {
    asked.quantities.contains(&Quantity::HalfWidth)
}

/// What came of such meshes.
pub(super) enum Found {
    /// The bars of one are within what is asked.
    Met(Rung),
    /// Those of none are; the best of them, where any was solved.
    Unmet(Option<Rung>),
}

/// The first such mesh whose bars are within what is asked.
pub(super) fn found(around: &Fitted, rungs: &mut Rungs) -> Result<Found, Error> {
    let asked = rungs.asked.relative;
    let scene = around.plan(fitted::FEWEST).scene(&around.scene);
    let Some(first) = rungs.first.as_ref().map(|first| first.run.clone()) else { return Ok(Found::Unmet(None)) };
    let mut best: Option<Rung> = None;
    let digits = (-asked.log10() + 1e-9).floor() as usize;
    let meshes = if asks_for_ends(rungs.asked) {
        OF_ENDS.get(digits.saturating_sub(2)..)
    } else {
        OF_PEAK.get(digits.saturating_sub(3)..)
    };
    for &(order, layers, elements) in meshes.unwrap_or_default() {
        let mesh = crate::solve::Fitted { order, layers };
        let Some(answer) = sought(mesh, elements, (&scene, &first), rungs) else { break };
        answer.tried.iter().for_each(|tried| rungs.sought(tried));
        let discretisation = answer.discretisation;
        // Counted as the 8-node cells that have as many nodes along a side.
        if discretisation.mesh.cells() as f64 * (0.5 * order.intervals() as f64).powi(2) > rungs.asked.most_cells
            || !answer.run.solution.converged()
        {
            break;
        }
        let mut rung = rungs.remember(&discretisation, answer.run, "order");
        rungs.look(&discretisation, &mut rung)?;
        let estimate = rung.error;
        if estimate <= asked {
            return Ok(Found::Met(rung));
        }
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.error);
        if best.is_none() || estimate < before {
            best = Some(rung);
        }
        // What is not smooth within a cell gains nothing by its order.
        if estimate > SLOW * before && estimate > NEAR * asked {
            break;
        }
    }
    Ok(Found::Unmet(best))
}

/// A mesh whose lines lie on the ends of the contact that a run shows; none where none can be fitted, or is allowed.
fn sought(
    mesh: crate::solve::Fitted,
    elements: usize,
    (scene, first): (&Scene, &Run),
    rungs: &mut Rungs,
) -> Option<edge_fitted::Answer> {
    let permits = |dofs| rungs.watch.permits(dofs);
    let at_rest = (REST * rungs.asked.relative).sqrt();
    let sought = Sought { elements, permits: &permits, ..Sought::new(scene, &rungs.formulation, at_rest) };
    let found = match mesh.around(first, &sought) {
        // Two stretches that the first mesh took for one have no lines: they are sought on finer ones.
        Ok(answer) if !answer.is_where_it_was_sought() => mesh.found(&sought),
        found => found,
    };
    found.map_err(|error| rungs.is_refused(&error)).ok()
}
