//! What is run: errors and counts of every recorded mesh once more, and the default meshes against finer ones.

use crate::case::library;
use crate::mesh::Order;
use crate::study::Planned;
use crate::study::timings::default_mesh;
use crate::study::timings::precision::{self, Family};
use crate::study::timings::run::{self, Numbers};

/// Name of the trials.
const CASE: &str = "speed against accuracy";
/// Scenes whose default mesh is held against a finer one.
const SCENES: [&str; 4] = ["cylinder", "truncated-hertz", "pin-rod", "pin-plate"];

/// One trial a family and order, one for the growth, one for more digits, one for error bars, and one a default mesh.
pub fn plan() -> Vec<Planned<Numbers>> {
    let cost = Planned::new(CASE, "error bars", run::bar_cost);
    let growth = Planned::new(CASE, "growth", run::growth);
    let digits = Planned::new(CASE, "more digits", run::digits);
    precision::series().map(precision).chain([growth, digits, cost]).chain(SCENES.map(default_mesh)).collect()
}

fn precision((family, order): (Family, Order)) -> Planned<Numbers> {
    let name = format!("{}, {}-node", family.name(), order.nodes_per_cell());
    Planned::new(CASE, name, move || run::precision(family, order))
}

fn default_mesh(scene: &'static str) -> Planned<Numbers> {
    Planned::new(CASE, format!("default mesh, {scene}"), move || {
        default_mesh::measure(&library::find(scene, None)?).map(Numbers::DefaultMesh)
    })
}
