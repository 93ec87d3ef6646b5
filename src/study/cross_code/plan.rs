//! What is run: discrete problems by scene, order and code; physical problems by scene.

use crate::oracle::cross_code::Code;
use crate::study::Planned;
use crate::study::cross_code::benchmark::Scene;
use crate::study::cross_code::{Answers, Numbers, discrete, physical, twin};

/// All trials, against frozen answers.
pub fn plan() -> Vec<Planned<Numbers>> {
    against(Answers::Frozen)
}

/// The same with the codes themselves asked.
#[cfg(feature = "python")]
pub fn live() -> Vec<Planned<Numbers>> {
    against(Answers::Live)
}

fn against(answers: Answers) -> Vec<Planned<Numbers>> {
    let discrete = twin::problems().into_iter().flat_map(|(name, order)| {
        Code::ALL.map(|code| {
            let title = format!("{name}, {}-node, {code}{}", order.nodes_per_cell(), answers.suffix());
            Planned::new("same discrete problem", title, move || {
                discrete::compare(name, order, code, answers).map(Numbers::Discrete)
            })
        })
    });
    let physical = Scene::ALL.into_iter().map(|scene| {
        Planned::new("assembly twin", format!("{}{}", scene.name(), answers.suffix()), move || {
            physical::compare(&scene.benchmark(), answers).map(Numbers::Physical)
        })
    });
    discrete.chain(physical).collect()
}
