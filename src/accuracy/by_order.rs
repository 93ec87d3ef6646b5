//! Cells of higher and higher order, fitted to the one contact of a scene, until the error bars of a mesh are within what is asked.
//!
//! On truncated Hertz 1e-3 takes 919 dofs so, and 8-node cells 1,540; 3e-4 takes 1,100 and 3,500. Above 1e-3 8-node cells are as cheap, and
//! tell it by fewer meshes.

use crate::accuracy::answer::largest;
use crate::accuracy::fitted::{self, Fitted};
use crate::accuracy::rungs::{Rung, Rungs};
use crate::accuracy::{Asked, Quantity};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Element, Formulation, Run};

/// Relative error asked for up to which such cells pay.
const PAYS: f64 = 1e-3 * (1.0 + 1e-9);
/// Order and layers of the meshes, and cells on each piece of the contact side.
const MESHES: [(Order, usize, usize); 6] = [
    (Order::Quintic, 1, 1),
    (Order::Sextic, 1, 1),
    (Order::Septic, 2, 1),
    (Order::Octic, 3, 1),
    (Order::Octic, 4, 2),
    (Order::Octic, 5, 3),
];

/// What is asked over what ends at rest may leave, from which on an order is tried.
const ROOM: f64 = 3.0;
/// Bar over that of the mesh before, from which on the bars fall too slowly.
const SLOW: f64 = 0.5;

/// Whether such meshes are tried.
pub(super) fn applies(formulation: &Formulation, asked: &Asked) -> bool {
    let known = |quantity: &Quantity| {
        matches!(quantity, Quantity::PeakPressure | Quantity::HalfWidth | Quantity::SecondMomentWidth)
    };
    asked.relative <= PAYS && formulation.element == Element::Node && asked.quantities.iter().all(known)
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
        let mesh = crate::solve::Fitted { order, layers };
        let Ok(answer) = mesh.around(&scene, &first, &rungs.formulation, mesh.at_rest()) else { return Ok(None) };
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
        rungs.look(&discretisation, &mut rung);
        let estimate = largest(&rung.estimates);
        if estimate <= asked {
            return Ok(Some(rung));
        }
        // What is not smooth within a cell gains nothing by its order.
        if estimate > SLOW * before {
            return Ok(None);
        }
        before = estimate;
    }
    Ok(None)
}
