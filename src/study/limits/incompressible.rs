//! Limit of the cells: ν towards 0.5 in plane strain.

use serde::Serialize;

use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Reference};
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::Order;
use crate::scene::LARGEST_POISSON;
use crate::solve::run::{Errors, INSIDE};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Refusal;
use crate::study::limits::solved::{exceeds, hertz_errors, largest, meshed, on_even_cells, truncated, verified, worst};
use crate::study::limits::written::{bracket, percent, percents, range, size};

/// Poisson's ratios.
const RATIOS: [f64; 5] = [0.3, 0.45, 0.49, 0.499, LARGEST_POISSON];
/// One that is refused.
const BEYOND: f64 = 0.49999;
/// Error that counts as wrong.
const WRONG: f64 = 0.03;
/// Elements per half-width.
const MESHES: [(usize, Order); 2] = [(16, Order::Linear), (8, Order::Quadratic)];

/// Truncated Hertz of bodies that hardly change their volume.
#[derive(Clone, Debug, Serialize)]
pub struct Incompressible {
    /// By Poisson's ratio, on 4-node and 8-node cells.
    pub ratios: Vec<[OnCells; 2]>,
    /// The error of a ratio beyond the limit.
    pub refused: Refusal,
}

/// A run on one kind of cells.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OnCells {
    /// Errors against Hertz.
    pub errors: Errors,
    /// Largest departure of a pressure from its neighbours' line, over p₀.
    pub departure: f64,
}

/// Every ratio on both kinds of cells.
pub(super) fn run() -> Result<Incompressible, Error> {
    let at = |poisson: f64| {
        let [linear, quadratic] = MESHES.map(|(elements, order)| on_cells(poisson, elements, order));
        Ok([linear?, quadratic?])
    };
    let beyond = TruncatedHertz { poisson: BEYOND, ..Default::default() };
    Ok(Incompressible {
        ratios: RATIOS.into_iter().map(at).collect::<Result<_, Error>>()?,
        refused: Refusal::expected(truncated(beyond, 8, Order::Quadratic), "a body that keeps its volume")?,
    })
}

fn on_cells(poisson: f64, elements: usize, order: Order) -> Result<OnCells, Error> {
    let scene = on_even_cells(TruncatedHertz { poisson, ..Default::default() });
    let run = verified(&meshed(scene.clone(), elements, order)?)?;
    let inside = INSIDE * scene.reference.length;
    let departure = profile::oscillation(&run.solution.points, inside) / scene.reference.pressure;
    Ok(OnCells { errors: hertz_errors(&scene, &run), departure })
}

impl Incompressible {
    pub(super) fn judge(&self) -> Vec<Judged> {
        let hertz = || Reference::analytic("Hertz, whose a depends on E/(1 − ν²) only", 0.0);
        vec![
            Check::error(
                "largest error of p₀ and a on 4-node cells as ν tends to 0.5",
                hertz(),
                5e-3,
                "16 cells per half-width; locking stiffens without bound as ν tends to 0.5",
            )
            .judge(worst(self.ratios.iter().map(|[four, _]| four.errors))),
            Check::error(
                "largest error of p₀ and a on 8-node cells as ν tends to 0.5",
                hertz(),
                2e-3,
                "8 cells per half-width; locking stiffens without bound as ν tends to 0.5",
            )
            .judge(worst(self.ratios.iter().map(|[_, eight]| eight.errors))),
            Check::at_most(
                "departure of a pressure from its neighbours' line over p₀",
                Reference::own("whatever ν", 0.02),
                "a smooth profile departs by its curvature, whatever ν",
            )
            .judge(largest(self.ratios.iter().flatten().map(|found| found.departure))),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let onset = |k: usize| bracket(&RATIOS, |i| exceeds(self.ratios[i][k].errors.largest(), WRONG), "ν");
        Limit {
            pushed: "ν towards 0.5 in plane strain",
            range: range(&RATIOS, "ν"),
            onset: format!(
                "errors of p₀ and a beyond {}: 4-node cells {}, 8-node cells {}",
                size(WRONG),
                onset(0),
                onset(1)
            ),
            seen: self.refused.to_string(),
            instead: self.refused.remedy.clone(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let cells = |found: &OnCells| {
            let [peak, width] = percents(found.errors);
            [peak, width, percent(found.departure)]
        };
        let row = |(poisson, found): (f64, &[OnCells; 2])| {
            std::iter::once(poisson.to_string()).chain(found.iter().flat_map(cells)).collect()
        };
        Detail::of(
            "Truncated Hertz by Poisson's ratio (errors against Hertz)",
            &["ν", "4-node: p₀", "a", "departure of neighbours", "8-node: p₀", "a", "departure of neighbours"],
            RATIOS.into_iter().zip(&self.ratios).map(row),
        )
    }
}
