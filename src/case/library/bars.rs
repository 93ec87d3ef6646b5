//! Two bars in line closing a gap.

use crate::case::library::shared::{block, even, flat_contact, moved};
use crate::case::{Against, Case, Check, Quantity};
use crate::oracle::analytic::uniform::Uniform;
use crate::scene::{Face, Material, PlaneHypothesis, ReferenceValues, Scene};
use crate::solve::{Element, Formulation, Iteration};

/// Two bars in line with a gap; the end of the upper one is pushed down by `u`.
#[derive(Clone, Copy, Debug)]
pub struct Bars {
    /// Length of each bar \[mm\].
    pub length: f64,
    /// Width of the bars \[mm\].
    pub width: f64,
    /// Young's modulus; Poisson's ratio is zero \[MPa\].
    pub young: f64,
    /// Gap \[mm\].
    pub gap: f64,
    /// Displacement of the upper end over the gap.
    pub push: f64,
}

impl Default for Bars {
    fn default() -> Self {
        Self { length: 100.0, width: 25.0, young: 210e3, gap: 0.1, push: 1.5 }
    }
}

impl Bars {
    /// The scene, in plane stress.
    pub fn scene(&self) -> Scene {
        let material = Material { young: self.young, poisson: 0.0 };
        let u = self.push * self.gap;
        let pressure = self.young * u / (2.0 * self.length);
        let upper = [self.gap, self.gap + self.length];
        Scene {
            name: "bars".into(),
            plane: PlaneHypothesis::Stress,
            thickness: 1.0,
            bodies: vec![
                block("upper", [0.0, self.width], upper, Face::Bottom, material, vec![moved(-u)], vec![]),
                block("lower", [0.0, self.width], [-self.length, 0.0], Face::Top, material, vec![moved(0.0)], vec![]),
            ],
            contacts: vec![flat_contact(Some(1), self.gap, self.width)],
            reference: ReferenceValues {
                length: self.length,
                pressure,
                gap: pressure * self.length / (0.5 * self.young),
            },
            grading: even(self.width),
        }
    }
}

/// Displacements of the upper end over the gap.
const PUSHES: [f64; 3] = [0.5, 1.5, 3.0];
/// Load increments.
const INCREMENTS: [usize; 3] = [1, 2, 7];

impl Bars {
    /// The case, with its bilinear law.
    pub fn case(&self) -> Case {
        let oracle = Uniform::bars(self.young, 2.0 * self.width, [self.length; 2], self.gap, self.push * self.gap);
        Case::of("bars", TITLE, self.scene(), 2).against(oracle)
    }
}

/// What it is.
pub(super) const TITLE: &str = "two bars in line closing a gap";

/// Before and after the gap is closed, at once and in increments; where they only just touch the runs are reported.
pub(super) fn cases() -> Vec<Case> {
    let check =
        Check::error(Quantity::Departure, Against::Oracle, 1e-9, "exact in the discrete space; iterated to 1e-12");
    let of = |push: f64, name: String, checks: Vec<Check>| {
        let case = Bars { push, ..Default::default() }.case();
        Case { formulations: formulations(), checks, ..case.named(name) }
    };
    let mut cases: Vec<Case> = PUSHES.map(|push| of(push, format!("bars, u/g = {push}"), vec![check.clone()])).into();
    cases.push(of(1.0, "bars, u/g = 1 (reported)".into(), vec![]));
    cases
}

fn formulations() -> Vec<Formulation> {
    let of = |algorithm, increments| {
        let mut formulation = Formulation::new(Element::Node, algorithm).tolerance(1e-12);
        formulation.settings.increments = increments;
        formulation
    };
    Iteration::ALL.into_iter().flat_map(|algorithm| INCREMENTS.map(move |n| of(algorithm, n))).collect()
}
