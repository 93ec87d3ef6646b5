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
/// Meshes whose peak and second-moment width are as good as is asked: the largest relative error asked for from which on one is tried, order
/// and layers, and cells on each piece of the contact side.
const OF_PEAK: [(f64, Order, usize, usize); 6] = [
    (1e-3, Order::Quintic, 1, 1),
    (1e-4, Order::Sextic, 1, 1),
    (1e-5, Order::Septic, 2, 1),
    (1e-6, Order::Octic, 3, 1),
    (0.0, Order::Octic, 5, 2),
    (0.0, Order::Octic, 7, 3),
];
/// Those whose half-width is: what is left in it falls to a third with every layer, whatever the order. With truncated Hertz their bars are
/// 5e-3, 6e-4, 2e-4, 8e-5, 5e-5.
const OF_ENDS: [(f64, Order, usize, usize); 9] = [
    (1e-2, Order::Quintic, 1, 1),
    (3e-3, Order::Quintic, 2, 1),
    (5e-4, Order::Quintic, 3, 1),
    (1.5e-4, Order::Sextic, 3, 1),
    (5e-5, Order::Sextic, 4, 1),
    (1e-5, Order::Septic, 6, 1),
    (1e-6, Order::Octic, 8, 1),
    (0.0, Order::Octic, 8, 2),
    (0.0, Order::Octic, 10, 3),
];

/// Part of what is asked that ends at rest may leave, as a move that they no longer make, over the half-width: its square is what matters.
const REST: f64 = 0.02;
/// Bar over that of the mesh before, from which on the bars fall too slowly, unless they are as near to what is asked.
const SLOW: f64 = 0.5;
const NEAR: f64 = 3.0;
/// Bar over what is asked up to which smaller cells are tried where a higher order gains nothing: not above 1e-3, where 8-node cells are as
/// cheap (wedges with a round tip).
const FAR: f64 = 20.0;

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
    let Some(mut from) = rungs.first.as_ref().map(|first| first.run.clone()) else { return Ok(Found::Unmet(None)) };
    let meshes = if asks_for_ends(rungs.asked) { &OF_ENDS[..] } else { &OF_PEAK };
    let is_coarser = |mesh: &&(f64, Order, usize, usize)| mesh.0 * (1.0 + 1e-9) >= asked;
    let coarser = meshes.iter().filter(is_coarser).count();
    let (mut step, mut times, mut has_stalled, mut before) = (coarser.saturating_sub(1), 1, false, f64::INFINITY);
    let mut best: Option<Rung> = None;
    while let Some(&(_, order, layers, elements)) = meshes.get(step) {
        let mesh = crate::solve::Fitted { order, layers };
        let Some(answer) = sought(mesh, times * elements, (&scene, &from, best.is_some()), rungs) else { break };
        // The last one is the mesh itself.
        let others = answer.tried.len().saturating_sub(1);
        answer.tried[..others].iter().for_each(|tried| rungs.sought(tried));
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
        let is_slow = estimate > SLOW * before && estimate > NEAR * asked;
        let is_near = asked <= PAYS[0] && estimate <= FAR * asked;
        let is_last = step + 1 == meshes.len();
        from = rung.run.clone();
        if best.as_ref().is_none_or(|best| best.error.is_nan() || estimate < best.error) {
            best = Some(rung);
        }
        if is_slow && has_stalled || !is_near && (is_slow || is_last) {
            break;
        }
        // What is not smooth within a cell gains nothing by its order, and may by smaller cells.
        if is_slow || is_last {
            times *= 2;
        } else {
            step += 1;
        }
        (has_stalled, before) = (is_slow, estimate);
    }
    Ok(Found::Unmet(best))
}

/// A mesh whose lines lie on the ends of the contact that a run shows; none where none can be fitted, or is allowed.
fn sought(
    mesh: crate::solve::Fitted,
    elements: usize,
    (scene, first, is_near): (&Scene, &Run, bool),
    rungs: &mut Rungs,
) -> Option<edge_fitted::Answer> {
    let permits = |dofs| rungs.watch.permits(dofs);
    let at_rest = (REST * rungs.asked.relative).sqrt();
    let sought = Sought { elements, is_near, permits: &permits, ..Sought::new(scene, &rungs.formulation, at_rest) };
    let found = match mesh.around(first, &sought) {
        // Two stretches that the first mesh took for one have no lines: they are sought on finer ones.
        Ok(answer) if !answer.is_where_it_was_sought() => mesh.found(&Sought { is_near: false, ..sought }),
        found => found,
    };
    found.map_err(|error| rungs.is_refused(&error)).ok()
}
