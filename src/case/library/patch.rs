//! Patch test: two blocks under uniform pressure.

use crate::case::library::shared::{block, even, flat_contact, moved};
use crate::case::{Against, Case, Check, Quantity};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::uniform::Uniform;
use crate::scene::{Action, Face, Load, Material, PlaneHypothesis, ReferenceValues, Scene};
use crate::solve::Formulation;

/// Two equal blocks pressed on one another by a uniform pressure across a uniform clearance.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Width of the modelled halves and height of each block \[mm\].
    pub side: f64,
    /// Elastic constants.
    pub material: Material,
    /// Pressure on the upper block \[MPa\].
    pub pressure: f64,
}

impl Default for Patch {
    fn default() -> Self {
        Self { side: 10.0, material: Material::STEEL, pressure: 100.0 }
    }
}

impl Patch {
    /// The scene; the clearance is `q ℓ/E*`, so that the exact spring has κ = 1 and every rule can find it.
    pub fn scene(&self) -> Scene {
        let modulus = 0.5 * self.material.plane_modulus(PlaneHypothesis::Strain);
        let gap = self.pressure * self.side / modulus;
        let width = [0.0, self.side];
        let load = Load::on("far", Action::Uniform([0.0, -self.pressure]));
        Scene {
            name: "patch".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![
                block("upper", width, [gap, gap + self.side], Face::Bottom, self.material, vec![], vec![load]),
                block("lower", width, [-self.side, 0.0], Face::Top, self.material, vec![moved(0.0)], vec![]),
            ],
            contacts: vec![flat_contact(Some(1), gap, self.side)],
            reference: ReferenceValues { length: self.side, pressure: self.pressure, gap },
            grading: even(self.side),
        }
    }
}

/// Factors on the initial stiffness of neighbouring points.
const UNEVEN: [f64; 5] = [1.0, 30.0, 5.0, 100.0, 10.0];

impl Patch {
    /// The case of all nine, with its closed form `p = q`.
    pub fn case(&self) -> Case {
        let oracle = Uniform::patch(self.pressure, 2.0 * self.side);
        Case::of("patch", TITLE, self.scene(), 3).against(oracle)
    }
}

/// What it is.
pub(super) const TITLE: &str = "two blocks under uniform pressure";

/// Both kinds of cells under all nine, whatever the initial stiffness of each point.
pub(super) fn cases() -> Vec<Case> {
    let uneven =
        |f: Formulation| Formulation { stiffness_pattern: UNEVEN.to_vec(), stiffness: 1.0, ..f }.tolerance(1e-11);
    let check =
        Check::error(Quantity::Departure, Against::Oracle, 1e-8, "exact in the discrete space; iterated to 1e-11");
    let of = |(name, order)| {
        let case = Patch::default().case();
        Case {
            resolution: Resolution { order, ..case.resolution },
            formulations: Formulation::nine().into_iter().map(uneven).collect(),
            checks: vec![check.clone()],
            ..case.named(name)
        }
    };
    [("patch, 4-node", Order::Linear), ("patch, 8-node", Order::Quadratic)].map(of).into()
}
