//! Limit of the load: too small for the mesh, so that the contact falls between the nodes.

use serde::Serialize;

use crate::case::library::Cylinder;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Scene;
use crate::solve::Discretisation;
use crate::solve::run::Errors;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::{exceeds, hertz_errors, meshed, verified, with_both_orders, worst};
use crate::study::limits::written::{bracket, number, percents, size};

/// Elements per half-width of the contact under ever smaller loads.
const SIZES: [f64; 9] = [8.0, 4.0, 3.0, 2.0, 1.5, 1.0, 0.5, 0.25, 0.1];
/// Error of p₀ and a that counts as wrong.
const WRONG: f64 = 0.05;

/// The cylinder on one mesh while the load falls.
#[derive(Clone, Debug, Serialize)]
pub struct SmallLoad {
    /// By size, on 4-node and 8-node cells.
    pub sizes: Vec<[OnMesh; 2]>,
}

/// A contact on a mesh that was made for a larger one.
#[derive(Clone, Debug, Serialize)]
pub struct OnMesh {
    /// Active points.
    pub active: usize,
    /// Errors against Hertz.
    pub errors: Errors,
    /// What the user sees.
    pub seen: Seen,
}

/// Every size on both kinds of cells.
pub(super) fn run() -> Result<SmallLoad, Error> {
    Ok(SmallLoad { sizes: with_both_orders(&SIZES, on_mesh)? })
}

fn on_mesh(size: f64, order: Order) -> Result<OnMesh, Error> {
    let run = verified(&falling(size, order)?)?;
    let errors = hertz_errors(&falling_scene(size), &run);
    Ok(OnMesh { active: run.measures().active, errors, seen: Seen::of(&Ok(run)) })
}

/// The cylinder whose Hertz half-width is `size / 8` of the default one.
fn falling_scene(size: f64) -> Scene {
    let base = Cylinder::default();
    Cylinder { a_over_r: base.a_over_r * size / SIZES[0], ..base }.scene()
}

/// The same on the mesh made for the default load.
fn falling(size: f64, order: Order) -> Result<Discretisation, Error> {
    let base = Cylinder::default();
    let mut scene = falling_scene(size);
    scene.grading.unit = base.half_width();
    scene.contacts[0].stretch = base.stretch * base.half_width();
    meshed(scene, SIZES[0] as usize, order)
}

impl SmallLoad {
    fn is_wrong(&self, size: usize, order: usize) -> bool {
        exceeds(self.sizes[size][order].errors.largest(), WRONG)
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let unnoted = self.sizes.iter().flatten().filter(|found| found.seen.is_unnoted());
        let check = Check::error(
            Quantity::at("largest error of p₀ and a of a contact reported without a note", "every load"),
            Reference::analytic("Hertz", 0.0),
            WRONG,
            "four points: the edge is known to a third of the half-width, and enters the error of p₀ squared",
        );
        vec![check.judge(worst(unnoted.map(|found| found.errors)))]
    }

    pub(super) fn limit(&self) -> Limit {
        let onset = |order: usize| bracket(&SIZES, |i| self.is_wrong(i, order), "elements per half-width");
        let enough = (0..SIZES.len()).take_while(|&i| !self.is_wrong(i, 0) && !self.is_wrong(i, 1)).last();
        Limit {
            pushed: "a load too small for two contact nodes",
            range: format!("{} … {} elements per half-width", SIZES[0], SIZES[SIZES.len() - 1]),
            onset: format!("errors beyond {}: 4-node {}; 8-node {}", size(WRONG), onset(0), onset(1)),
            seen: self.sizes.last().map(|[_, eight]| eight.seen.to_string()).unwrap_or_default(),
            instead: format!(
                "a mesh made for the load: at least {} elements in the half-width",
                number(enough.map_or(f64::NAN, |i| SIZES[i]))
            ),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let cells = |found: &OnMesh| {
            let [peak, width] = percents(found.errors);
            [found.active.to_string(), peak, width, found.seen.to_string()]
        };
        let row = |(size, found): (f64, &[OnMesh; 2])| {
            std::iter::once(number(size)).chain(found.iter().flat_map(cells)).collect()
        };
        let head = [
            "elements per half-width",
            "4-node: points",
            "p₀",
            "a",
            "user sees",
            "8-node: points",
            "p₀",
            "a",
            "user sees",
        ];
        Detail::of("Cylinder: contact falling between the nodes", &head, SIZES.into_iter().zip(&self.sizes).map(row))
    }
}
