//! Hertz without its model error: a block that carries the tractions of the half-plane.
use std::f64::consts::PI;

use crate::case::library::shared::{ENGINEERING, block, hertz_checks};
use crate::case::{Against, Case, Check, Quantity};
use crate::oracle::analytic::hertz::Hertz;
use crate::scene::{
    Action, ContactPair, Face, Grading, Load, Material, Path, PlaneHypothesis, Profile, ReferenceValues, Scene,
    VectorField,
};
use crate::solve::Formulation;

/// Rectangle pressed by a rigid parabola, with the closed-form Hertz tractions on its other sides.
#[derive(Clone)]
pub struct TruncatedHertz {
    /// Radius of curvature of the parabola \[mm\].
    pub radius: f64,
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Hertz half-width over the radius.
    pub a_over_r: f64,
    /// Width and height of the block over the half-width.
    pub size: f64,
    /// Candidate stretch over the half-width.
    pub stretch: f64,
}

impl Default for TruncatedHertz {
    fn default() -> Self {
        Self { radius: 50.0, young: 210e3, poisson: 0.3, a_over_r: 0.05, size: 8.0, stretch: 2.0 }
    }
}

impl TruncatedHertz {
    /// The same block and candidates under the load of another half-width than they are drawn for, by its factor.
    pub fn under(self, factor: f64) -> Self {
        let Self { a_over_r, size, stretch, .. } = self;
        Self { a_over_r: factor * a_over_r, size: size / factor, stretch: stretch / factor, ..self }
    }

    /// Half-width `a` \[mm\].
    pub fn half_width(&self) -> f64 {
        self.a_over_r * self.radius
    }

    /// Full load per thickness `P = π a² E* / 4R` [N/mm].
    pub fn load(&self) -> f64 {
        let modulus = self.material().plane_modulus(PlaneHypothesis::Strain);
        PI * self.half_width().powi(2) * modulus / (4.0 * self.radius)
    }

    fn material(&self) -> Material {
        Material { young: self.young, poisson: self.poisson }
    }

    /// The scene, with the half-space stress `(x, depth) ↦ [σ_x, σ_depth, τ]` of the same Hertz problem as its load.
    ///
    /// The block lies above the contact line y = 0, so that y is the depth.
    pub fn scene(&self) -> Scene {
        let hertz = self.closed_form();
        self.scene_under(VectorField::of(move |[x, depth]: [f64; 2]| hertz.stress(x, depth)))
    }

    /// The same under other stresses of a half-plane.
    pub fn scene_under(&self, half_space: VectorField<3>) -> Scene {
        let a = self.half_width();
        let side = self.size * a;
        let profile = Profile::Parabola { radius: self.radius };
        let field = |boundary: &'static str| Load::on(boundary, Action::Stress(half_space.clone()));
        let loads = vec![field("right"), field("far")];
        Scene {
            name: "truncated-hertz".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![block("block", [0.0, side], [0.0, side], Face::Bottom, self.material(), vec![], loads)],
            contacts: vec![ContactPair::new(None, Path::HORIZONTAL, profile, self.stretch * a)],
            reference: ReferenceValues::hertz(a, self.load(), self.radius),
            grading: Grading { unit: a, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
        }
    }

    /// The closed form, whose stresses are also the load.
    pub fn closed_form(&self) -> Hertz {
        let modulus = self.young / (1.0 - self.poisson * self.poisson);
        Hertz { load: self.load(), radius: self.radius, modulus }
    }

    /// The case, with Hertz's solution.
    pub fn case(&self) -> Case {
        Case::of("truncated-hertz", TITLE, self.scene(), 8).against(self.closed_form())
    }
}

/// What it is.
pub(super) const TITLE: &str = "block with Hertz tractions pressed by a rigid parabola: Hertz without model error";

/// Name of the case of all nine.
pub const NINE: &str = "truncated hertz";

/// Verified, and all nine compared.
pub(super) fn cases() -> Vec<Case> {
    let case = TruncatedHertz::default().case();
    let because = ["8-node cells, 8 per half-width; no model error", "the edge lies between two nodes at worst"];
    let mut checks = hertz_checks([5e-4, 2e-3], because);
    checks.push(Check::error(Quantity::Profile, Against::Oracle, 1.5e-2, "square-root edge: order capped near 1"));
    vec![
        Case { checks, ..case.clone().named("truncated hertz, verification") },
        Case {
            formulations: Formulation::compared(),
            checks: hertz_checks([1e-2; 2], [ENGINEERING; 2]),
            ..case.named(NINE)
        },
    ]
}
