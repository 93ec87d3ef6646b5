//! Cells of higher and higher order, fitted to the one contact of a scene, until the error bars of a mesh are within what is asked.
//!
//! They know where the contact ends by a mesh line, and 8-node cells by its pressures alone, so that these take three times as many dofs to
//! tell the half-width. Above 1e-2 8-node cells are as cheap.

use crate::accuracy::fitted::{self, Fitted};
use crate::accuracy::rungs::{Rung, Rungs};
use crate::accuracy::{Asked, Quantity};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Element, Formulation, Run};

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

/// The first such mesh whose bars are within what is asked; none where no mesh can be fitted to the contact, or none of them is enough.
pub(super) fn found(around: &Fitted, rungs: &mut Rungs) -> Result<Option<Rung>, Error> {
    let asked = rungs.asked.relative;
    let scene = around.plan(fitted::FEWEST).scene(&around.scene);
    let Some(first) = rungs.first.as_ref().map(|first| first.run.clone()) else { return Ok(None) };
    let mut before = f64::INFINITY;
    let at_rest = (REST * asked).sqrt();
    let digits = (-asked.log10() + 1e-9).floor() as usize;
    let meshes = if asks_for_ends(rungs.asked) {
        OF_ENDS.get(digits.saturating_sub(2)..)
    } else {
        OF_PEAK.get(digits.saturating_sub(3)..)
    };
    for &(order, layers, elements) in meshes.unwrap_or_default() {
        let mesh = crate::solve::Fitted { order, layers };
        let Ok(mut answer) = mesh.around(&scene, &first, &rungs.formulation, at_rest) else { return Ok(None) };
        if !answer.is_where_it_was_sought() {
            // Two stretches that the first mesh took for one have no lines: they are sought on finer ones.
            let Ok(other) = mesh.solve_with_ends(&scene, &rungs.formulation, at_rest) else { return Ok(None) };
            answer = other;
        }
        answer.tried.iter().for_each(|tried| rungs.sought(tried));
        let resolution = Resolution { elements, refinement: 0, order };
        let is_solved = answer.discretisation.resolution == resolution;
        let (discretisation, run) = match is_solved {
            true => (answer.discretisation, Some(answer.run)),
            false => (Discretisation::of(answer.discretisation.scene, resolution)?, None),
        };
        // Counted as the 8-node cells that have as many nodes along a side.
        if discretisation.mesh.cells() as f64 * (0.5 * order.intervals() as f64).powi(2) > rungs.asked.most_cells {
            return Ok(None);
        }
        let run = run.map_or_else(|| Run::of(&discretisation, &rungs.formulation), Ok)?;
        if !run.solution.converged() {
            return Ok(None);
        }
        let mut rung = rungs.remember(&discretisation, run, "order");
        rungs.look(&discretisation, &mut rung)?;
        let estimate = rung.error;
        if estimate <= asked {
            return Ok(Some(rung));
        }
        // What is not smooth within a cell gains nothing by its order.
        if estimate > SLOW * before && estimate > NEAR * asked {
            return Ok(None);
        }
        before = estimate;
    }
    Ok(None)
}
