//! What is run.

use crate::solve::Element;
use crate::study::Planned;
use crate::study::cures::run::{Numbers, Reach};
use crate::study::cures::{nested, rules};

/// The trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    let reach = |element: Element| {
        let run = move || Reach::of(element).map(Numbers::Reach);
        Planned::new("reach of constant stiffness, accelerated", element.name(), run)
    };
    let mut trials: Vec<_> = Element::ALL.map(reach).into();
    trials.push(Planned::new("accelerated rules", "node.constant", || rules::run().map(Numbers::Rules)));
    trials.extend(nested::scenes().into_iter().map(|(name, scene)| {
        let run = move || nested::run(name, &scene).map(Numbers::Nested);
        Planned::new("nested start of kinematic load", name, run)
    }));
    trials
}
