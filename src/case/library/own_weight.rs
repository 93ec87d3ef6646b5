//! A block on a rigid plane under its own weight.

use crate::case::library::shared::{block, even, flat_contact, symmetry};
use crate::case::{Against, Case, Check, Quantity};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::uniform::Uniform;
use crate::scene::{Face, Load, Material, PlaneHypothesis, ReferenceValues, Scene};

/// A block standing on a rigid plane under its own weight, its sides guided so that it only shortens.
#[derive(Clone, Copy, Debug)]
pub struct OwnWeight {
    /// Width of the modelled half \[mm\].
    pub width: f64,
    /// Height \[mm\].
    pub height: f64,
    /// Elastic constants.
    pub material: Material,
    /// Specific weight `ρ g` [N/mm³].
    pub weight: f64,
}

impl Default for OwnWeight {
    fn default() -> Self {
        Self { width: 20.0, height: 40.0, material: Material { young: 1e3, poisson: 0.3 }, weight: 1e-2 }
    }
}

impl OwnWeight {
    /// The scene: body force downwards, rigid plane below.
    pub fn scene(&self) -> Scene {
        let pressure = self.weight * self.height;
        let modulus = self.material.plane_modulus(PlaneHypothesis::Strain);
        let weight = Load::BodyForce([0.0, -self.weight]);
        let block = block(
            "block",
            [0.0, self.width],
            [0.0, self.height],
            Face::Bottom,
            self.material,
            vec![symmetry("right")],
            vec![weight],
        );
        Scene {
            name: "own-weight".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![block],
            contacts: vec![flat_contact(None, 0.0, self.width)],
            reference: ReferenceValues { length: self.height, pressure, gap: pressure * self.height / modulus },
            grading: even(self.width),
        }
    }

    /// The case, with `p = ρ g H`.
    pub fn case(&self) -> Case {
        let oracle = Uniform::own_weight(self.weight, self.height, 2.0 * self.width);
        Case::of("own-weight", TITLE, self.scene(), 4).against(oracle)
    }
}

/// What it is.
pub(super) const TITLE: &str = "block under its own weight on a rigid plane";

/// Both kinds of cells.
pub(super) fn cases() -> Vec<Case> {
    let because = "exact in the discrete space; iterated to 1e-8, balance to round-off";
    let check = Check::error(Quantity::Departure, Against::Oracle, 1e-9, because);
    let of = |(name, order)| {
        let case = OwnWeight::default().case();
        Case { resolution: Resolution { order, ..case.resolution }, checks: vec![check.clone()], ..case.named(name) }
    };
    [("own weight, 4-node", Order::Linear), ("own weight, 8-node", Order::Quadratic)].map(of).into()
}
