//! What is run.

use serde::Serialize;

use crate::case::Case;
use crate::case::library::{Cylinder, PinRod};
use crate::mesh::Resolution;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::Planned;
use crate::study::sweep::run::{self, Numbers};

/// What is swept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Scene {
    /// The cylinder, candidates to twice the half-width.
    Cylinder,
    /// The pin in the connecting-rod eye.
    PinRod,
    /// The cylinder, candidates that end where the contact does.
    AtTheEdge,
}

impl Scene {
    /// The paper's two examples.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// Name in charts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::PinRod => "pin-rod",
            Self::AtTheEdge => "candidates end at the edge",
        }
    }

    /// The case on the mesh of the sweep.
    pub(super) fn case(self) -> Case {
        let (case, elements) = match self {
            Self::Cylinder => (Cylinder::default().case(), 8),
            Self::PinRod => (PinRod::default().case(), 12),
            Self::AtTheEdge => (Cylinder { stretch: 1.0, ..Default::default() }.case(), 8),
        };
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }
}

/// Start stiffnesses: half decades from 1e-3 to 1e6.
pub(super) fn stiffnesses() -> impl Iterator<Item = f64> {
    (-6..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}

/// Every formulation on both scenes, the rules, and the condition of "two steps".
pub fn plan() -> Vec<Planned<Numbers>> {
    let sweep = |scene: Scene, formulation: Formulation| {
        let name = formulation.name();
        Planned::new(format!("stiffness sweep, {}", scene.name()), name, move || run::sweep(scene, &formulation))
    };
    let mut trials: Vec<_> = Scene::PAPER
        .into_iter()
        .flat_map(|scene| Formulation::nine().into_iter().map(move |formulation| sweep(scene, formulation)))
        .collect();
    trials.push(Planned::new("rules, cylinder", "all rules", run::rules));
    trials.push(sweep(Scene::AtTheEdge, Formulation::new(Element::Node, Iteration::Kinematic)));
    trials
}
