//! What is run: each prediction against its measurement, by element or by scene.

use crate::error::Error;
use crate::solve::{Element, Iteration};
use crate::study::Planned;
use crate::study::method::Method;
use crate::study::stability::halving::Scene;
use crate::study::stability::{Numbers, basin, before, failing, fixed_target, halving, rates};

/// All trials of the predictions.
pub fn plan() -> Vec<Planned<Numbers>> {
    let mut trials = Vec::new();
    for element in Element::ALL {
        for algorithm in [Iteration::Constant, Iteration::Varying] {
            let method = Method::usual(element, algorithm);
            let run = move || rates::rates(method).map(Numbers::Rates);
            trials.push(Planned::new("predicted rate of convergence", method.to_string(), run));
        }
    }
    trials.extend(before::Scene::ALL.map(|scene| {
        let run = move || before::starts(scene).map(Numbers::Before);
        Planned::new("rate of varying stiffness before the contact is solved", scene.name(), run)
    }));
    trials.extend(by_element("constant stiffness, fixed target springs", |e| {
        fixed_target::grid(e).map(Numbers::FixedTarget)
    }));
    trials.extend(by_element("varying stiffness with correction, near and far", |e| {
        basin::near_and_far(e).map(Numbers::Basin)
    }));
    trials.extend(by_element("constant stiffness, rules that fail", |e| failing::failing(e).map(Numbers::Failing)));
    trials.extend(Scene::ALL.map(|scene| {
        let run = move || halving::law(scene).map(Numbers::Halving);
        Planned::new("predicted iterations of kinematic load", scene.name(), run)
    }));
    trials
}

/// One trial an element.
fn by_element(case: &str, run: fn(Element) -> Result<Numbers, Error>) -> impl Iterator<Item = Planned<Numbers>> {
    Element::ALL.into_iter().map(move |element| Planned::new(case, element.name(), move || run(element)))
}
