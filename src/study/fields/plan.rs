//! What is run: two bars by each iteration, the two scenes of the paper, and the pin-rod by each of its formulations.

use crate::solve::{Element, Formulation, Iteration};
use crate::study::Planned;
use crate::study::fields::run::{self, Numbers, Shown};

/// Start stiffness of the bars, so soft that every iteration has a way to go.
const SOFT: f64 = 0.4;

/// All trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    let paths = Iteration::ALL.map(|algorithm| {
        let formulation = Formulation { stiffness: SOFT, ..Formulation::new(Element::Node, algorithm) };
        Planned::new("iteration paths, two bars", formulation.name(), move || run::path(&formulation))
    });
    let fields = Shown::ALL.map(|scene| {
        Planned::new(format!("fields, {}", scene.name()), "node.kinematic", move || {
            run::field(scene).map(Numbers::Field)
        })
    });
    let along = Formulation::compared().into_iter().filter(Formulation::is_in_the_paper).map(|formulation| {
        Planned::new("along pin and rod", formulation.name(), move || run::along(&formulation).map(Numbers::Along))
    });
    paths.into_iter().chain(fields).chain(along).collect()
}
