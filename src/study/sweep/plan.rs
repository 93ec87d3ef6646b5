//! What is run.

use crate::solve::{Element, Formulation, Iteration};
use crate::study::Planned;
use crate::study::sweep::run::{self, Numbers};
use crate::study::sweep::scene::Scene;

/// Every formulation on both scenes, the rules, and the condition of "two iterations".
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
