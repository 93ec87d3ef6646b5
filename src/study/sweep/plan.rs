//! What is run.

use crate::algorithm::Acceleration;
use crate::solve::{Element, Formulation, Iteration};
use crate::study::Planned;
use crate::study::sweep::run::{self, Numbers};
use crate::study::sweep::scene::Scene;

/// Every formulation on both scenes, as it stands in the paper and accelerated, what that saves, the rules, and the condition of
/// "two iterations".
pub fn plan() -> Vec<Planned<Numbers>> {
    let sweep = |scene: Scene, formulation: Formulation| {
        let name = formulation.name();
        Planned::new(format!("stiffness sweep, {}", scene.name()), name, move || run::sweep(scene, &formulation))
    };
    let accelerated = || Formulation::compared().into_iter().filter(|one| one.acceleration != Acceleration::None);
    let each = || Formulation::nine().into_iter().chain(accelerated());
    let mut trials: Vec<_> =
        Scene::PAPER.into_iter().flat_map(|scene| each().map(move |formulation| sweep(scene, formulation))).collect();
    trials.extend(Scene::PAPER.map(|scene| {
        Planned::new(format!("before and after, {}", scene.name()), "all nine", move || run::saved(scene))
    }));
    trials.push(Planned::new("rules, cylinder", "all rules", run::rules));
    trials.push(sweep(Scene::AtTheEdge, Formulation::new(Element::Node, Iteration::Kinematic)));
    trials
}
