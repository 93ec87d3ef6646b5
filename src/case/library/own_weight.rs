//! A block on a rigid plane under its own weight.

use crate::case::library::shared::{block, even, flat_contact, symmetry};
use crate::case::{Against, Case, Check, Quantity};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::uniform::Uniform;
use crate::scene::{Face, Load, Material, PlaneHypothesis, ReferenceValues, Scene};

/// Width of the modelled half \[mm\].
const WIDTH: f64 = 20.0;
/// Height \[mm\].
const HEIGHT: f64 = 40.0;
/// Elastic constants.
const MATERIAL: Material = Material { young: 1e3, poisson: 0.3 };
/// Specific weight `ρ g` [N/mm³].
const WEIGHT: f64 = 1e-2;

/// A block standing on a rigid plane under its own weight, its sides guided so that it only shortens; with `p = ρ g H`.
pub fn case() -> Case {
    let (supports, loads) = (vec![symmetry("right")], vec![Load::BodyForce([0.0, -WEIGHT])]);
    let block = block("block", [0.0, WIDTH], [0.0, HEIGHT], Face::Bottom, MATERIAL, supports, loads);
    let pressure = WEIGHT * HEIGHT;
    let gap = pressure * HEIGHT / MATERIAL.plane_modulus(PlaneHypothesis::Strain);
    let scene = Scene {
        name: "own-weight".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies: vec![block],
        contacts: vec![flat_contact(None, 0.0, WIDTH)],
        reference: ReferenceValues { length: HEIGHT, pressure, gap },
        grading: even(WIDTH),
    };
    let oracle = Uniform::own_weight(WEIGHT, HEIGHT, 2.0 * WIDTH);
    Case::of("own-weight", TITLE, scene, 4).against(oracle)
}

/// What it is.
pub(super) const TITLE: &str = "block under its own weight on a rigid plane";

/// Both kinds of cells.
pub(super) fn cases() -> Vec<Case> {
    let because = "exact in the discrete space; iterated to 1e-8, balance to round-off";
    let check = Check::error(Quantity::Departure, Against::Oracle, 1e-9, because);
    let of = |(name, order)| {
        let case = case();
        Case { resolution: Resolution { order, ..case.resolution }, checks: vec![check.clone()], ..case.named(name) }
    };
    [("own weight, 4-node", Order::Linear), ("own weight, 8-node", Order::Quadratic)].map(of).into()
}
