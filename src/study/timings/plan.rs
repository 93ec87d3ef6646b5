//! What is run: errors and counts of every recorded mesh once more.

use crate::mesh::Order;
use crate::study::Planned;
use crate::study::timings::precision::{self, Family};
use crate::study::timings::run::{self, Numbers};

/// Name of the trials.
const CASE: &str = "speed against accuracy";

/// One trial a family and order, one for the growth, one for more digits.
pub fn plan() -> Vec<Planned<Numbers>> {
    let growth = Planned::new(CASE, "growth", run::growth);
    let digits = Planned::new(CASE, "more digits", run::digits);
    precision::series().map(precision).chain([growth, digits]).collect()
}

fn precision((family, order): (Family, Order)) -> Planned<Numbers> {
    let name = format!("{}, {}-node", family.name(), order.nodes_per_cell());
    Planned::new(CASE, name, move || run::precision(family, order))
}
