//! What is run: discrete problems by scene, order and code.

use crate::mesh::Order;
use crate::oracle::cross_code::Code;
use crate::study::Planned;
use crate::study::answers::Answers;
use crate::study::cross_code::discrete::{Compared, compare};
use crate::study::cross_code::twin;

/// All trials, against frozen answers.
pub fn plan() -> Vec<Planned<Compared>> {
    against(Answers::Frozen)
}

/// The same with the codes themselves asked.
#[cfg(feature = "python")]
pub fn live() -> Vec<Planned<Compared>> {
    against(Answers::Live)
}

fn against(answers: Answers) -> Vec<Planned<Compared>> {
    let of_both = |(name, order): (&'static str, Order)| {
        Code::ALL.map(|code| {
            let title = format!("{name}, {}-node, {code}{}", order.nodes_per_cell(), answers.suffix());
            Planned::new("same discrete problem", title, move || compare(name, order, code, answers))
        })
    };
    twin::problems().into_iter().flat_map(of_both).collect()
}
