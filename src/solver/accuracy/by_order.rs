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
/// Order of the meshes, their layers and the same where the half-width is asked, and cells on each piece of the contact side.
///
/// On truncated Hertz with cells of order 7, a third layer takes a fifth more dofs and tells the end five times as well.
const MESHES: [(Order, [usize; 2], usize); 6] = [
    (Order::Quintic, [1, 3], 1),
    (Order::Sextic, [1, 3], 1),
    (Order::Septic, [2, 3], 1),
    (Order::Octic, [3, 3], 1),
    (Order::Octic, [4, 5], 2),
    (Order::Octic, [5, 7], 3),
];

/// What is asked over what ends at rest may leave, from which on an order is tried.
const ROOM: f64 = 3.0;
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
    let leaves = |order: Order| ROOM * crate::solve::Fitted::misfit(order);
    let enough = MESHES.iter().filter(|(order, ..)| leaves(*order) < asked || *order == Order::Octic);
    let scene = around.plan(fitted::FEWEST).scene(&around.scene);
    let Some(first) = rungs.first.as_ref().map(|first| first.run.clone()) else { return Ok(None) };
    let mut before = f64::INFINITY;
    for &(order, layers, elements) in enough {
        let mesh = crate::solve::Fitted { order, layers: layers[usize::from(asks_for_ends(rungs.asked))] };
        let Ok(mut answer) = mesh.around(&scene, &first, &rungs.formulation, mesh.at_rest()) else { return Ok(None) };
        if !answer.is_where_it_was_sought() {
            // Two stretches that the first mesh took for one have no lines: they are sought on finer ones.
            let Ok(other) = mesh.solve_with_ends(&scene, &rungs.formulation, mesh.at_rest()) else { return Ok(None) };
            answer = other;
        }
        answer.tried.iter().for_each(|tried| rungs.sought(tried));
        let resolution = Resolution { elements, refinement: 0, order };
        let discretisation = Discretisation::of(answer.discretisation.scene, resolution)?;
        // Counted as the 8-node cells that have as many nodes along a side.
        if discretisation.mesh.cells() as f64 * (0.5 * order.intervals() as f64).powi(2) > rungs.asked.most_cells {
            return Ok(None);
        }
        let run = Run::of(&discretisation, &rungs.formulation)?;
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
