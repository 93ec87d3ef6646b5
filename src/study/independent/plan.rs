//! What is run: every scene of the benchmark.

use crate::study::Planned;
use crate::study::answers::Answers;
use crate::study::independent::benchmark::Scene;
use crate::study::independent::run::{Compared, compare};

/// All scenes, against frozen answers.
pub fn plan() -> Vec<Planned<Compared>> {
    against(Answers::Frozen)
}

/// The same with the scripts themselves asked.
#[cfg(feature = "python")]
pub fn live() -> Vec<Planned<Compared>> {
    against(Answers::Live)
}

fn against(answers: Answers) -> Vec<Planned<Compared>> {
    let planned = Scene::ALL.map(|scene| {
        let name = format!("{}{}", scene.name(), answers.suffix());
        Planned::new("independent codes", name, move || compare(&scene.benchmark(), answers))
    });
    planned.into()
}
