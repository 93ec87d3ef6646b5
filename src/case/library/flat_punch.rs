//! A rigid flat punch on a large block.
use std::f64::consts::PI;

use crate::case::library::shared::block;
use crate::case::{Against, Case, Check};
use crate::measure::Quantity;
use crate::oracle::analytic::punch;
use crate::scene::{
    Action, ContactPair, Face, Grading, Load, Material, Path, PlaneHypothesis, Profile, ReferenceValues, Scene,
};

/// A rigid flat punch with sharp corners pressed on a large block.
#[derive(Clone, Copy, Debug)]
pub struct FlatPunch {
    /// Half-width of the punch \[mm\].
    pub half_width: f64,
    /// Width of the modelled half and height of the block over the punch's half-width.
    pub size: f64,
    /// Elastic constants.
    pub material: Material,
    /// Full load per thickness [N/mm].
    pub load: f64,
}

impl Default for FlatPunch {
    fn default() -> Self {
        Self { half_width: 1.0, size: 40.0, material: Material::STEEL, load: 1000.0 }
    }
}

impl FlatPunch {
    /// The scene: the block is pressed on the punch by a uniform pressure on its far side.
    pub fn scene(&self) -> Scene {
        let a = self.half_width;
        let side = self.size * a;
        let pressure = self.load / (PI * a);
        let modulus = self.material.plane_modulus(PlaneHypothesis::Strain);
        let load = Load::on("far", Action::Uniform([0.0, -0.5 * self.load / side]));
        Scene {
            name: "flat-punch".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![block("block", [0.0, side], [0.0, side], Face::Bottom, self.material, vec![], vec![load])],
            contacts: vec![ContactPair::new(None, Path::HORIZONTAL, Profile::Punch { half_width: a }, a)],
            reference: ReferenceValues { length: a, pressure, gap: pressure * a / modulus },
            grading: Grading { unit: a, along: 1.4, depth: 1.4, first: 1.0, coarsest: 0.1, end: 0.02 },
        }
    }

    /// The case, with `p = P / π√(a² − x²)`.
    pub fn case(&self) -> Case {
        let oracle = punch::FlatPunch { load: self.load, half_width: self.half_width };
        Case { model: self.size.powi(-2), ..Case::of("flat-punch", TITLE, self.scene(), 24).against(oracle) }
    }
}

/// What it is.
pub(super) const TITLE: &str = "rigid flat punch on a large block";

/// Blocks of two sizes, whose ends the closed form leaves out: as the square of half-width over block.
pub(super) fn cases() -> Vec<Case> {
    let because = "the block is finite: two sizes are shown; the corner singularity is resolved to a/250";
    let check = Check::near(Quantity::Pressure { at: 0.0 }, Against::Oracle, 5e-3, because);
    let of = |size| {
        let case = FlatPunch { size, ..Default::default() }.case();
        case.named(format!("flat punch, block {size} half-widths")).held_to([check.clone()])
    };
    [20.0, 40.0].map(of).into()
}
