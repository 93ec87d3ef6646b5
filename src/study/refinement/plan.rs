//! What is run: truncated Hertz by both orders, the cylinder by a/R, the pin–rod.

use crate::mesh::Order;
use crate::study::Planned;
use crate::study::refinement::run::{self, Numbers};

/// All trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    let orders = [("4-node", Order::Linear), ("8-node", Order::Quadratic)];
    let orders = orders.map(|(name, order)| {
        Planned::new("order of accuracy, truncated hertz", name, move || run::orders(order).map(Numbers::Orders))
    });
    let others = [
        Planned::new("model error, cylinder", "node.kinematic", || run::model_error().map(Numbers::ModelError)),
        Planned::new("refinement, pin-rod", "4-node and 8-node", || run::pin_rod().map(Numbers::PinRod)),
    ];
    orders.into_iter().chain(others).collect()
}
