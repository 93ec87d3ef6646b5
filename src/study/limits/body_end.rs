//! Limit of the body: the contact grows until it reaches the end of it.

use serde::Serialize;

use crate::case::library::TruncatedHertz;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Load;
use crate::solution::Outcome;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Seen;
use crate::study::limits::solved::{largest, meshed, verified};
use crate::study::limits::written::{bracket, number, range};

/// Loads over that whose Hertz contact is half as wide as the block.
const LOADS: [f64; 7] = [0.2, 1.0, 2.0, 4.0, 6.0, 8.0, 50.0];

/// A block on a parabola under growing loads.
#[derive(Clone, Debug, Serialize)]
pub struct BodyEnd {
    /// By load.
    pub loads: Vec<Pressed>,
}

/// The contact under one load.
#[derive(Clone, Debug, Serialize)]
pub struct Pressed {
    /// How the run ended.
    pub outcome: Outcome,
    /// What the user sees.
    pub seen: Seen,
    /// Last closed point over the width of the block.
    pub edge: f64,
    /// Pressure at the corner over the peak.
    pub corner: f64,
    /// `|ΣA p − P| / P`; NaN where the run did not converge.
    pub balance: f64,
}

/// Every load.
pub(super) fn run() -> Result<BodyEnd, Error> {
    Ok(BodyEnd { loads: LOADS.into_iter().map(pressed).collect::<Result<_, _>>()? })
}

/// A block of two half-widths pressed evenly on the parabola by a multiple of the Hertz load.
fn pressed(factor: f64) -> Result<Pressed, Error> {
    let numbers = TruncatedHertz { size: 2.0, stretch: 2.0, ..Default::default() };
    let (load, width) = (factor * numbers.load(), 2.0 * numbers.half_width());
    let mut scene = numbers.scene();
    scene.bodies[0].loads = vec![Load::Traction { boundary: "far".into(), traction: [0.0, -0.5 * load / width] }];
    let run = verified(&meshed(scene, 8, Order::Quadratic)?)?;
    let at_corner = run.solution.points.last().map_or(f64::NAN, |point| point.pressure);
    Ok(Pressed {
        outcome: run.solution.outcome,
        edge: run.measures().edge() / width,
        corner: at_corner / run.measures().peak.pressure,
        balance: if run.solution.converged() { (run.transmitted() / load - 1.0).abs() } else { f64::NAN },
        seen: Seen::of(&Ok(run)),
    })
}

impl BodyEnd {
    pub(super) fn judge(&self) -> Vec<Judged> {
        let [before, last] = [2, 1].map(|back| self.loads[LOADS.len() - back].corner);
        vec![
            Check::error(
                Quantity::at("largest |ΣA p − P| / P of a contact that reaches the end of the body", "every load"),
                Reference::own("the applied load", 0.0),
                1e-8,
                "the tolerance of the runs; there is no surface beyond the end",
            )
            .judge(largest(self.loads.iter().map(|pressed| pressed.balance))),
            Check::at_least(
                Quantity::at("pressure at the corner over the peak", "largest load"),
                Reference::own("that under the load before", before),
                "towards a punch of the block's width, whose pressure is largest at the corner",
            )
            .judge(last),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let last = self.loads.last().map(|pressed| pressed.seen.to_string()).unwrap_or_default();
        Limit {
            pushed: "contact reaching the end of the body",
            range: range(&LOADS, "P/P₁, with the Hertz half-width of P₁ half the block's"),
            onset: bracket(&LOADS, |i| self.loads[i].edge > 1.0 - 1e-9, "P/P₁"),
            seen: format!("{last}; the pressure is that of a body that ends there"),
            instead: "nothing; model the body as long as it is".into(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(load, pressed): (f64, &Pressed)| {
            let Pressed { outcome, edge, corner, .. } = pressed;
            vec![number(load), outcome.to_string(), format!("{edge:.3}"), format!("{corner:.3}")]
        };
        Detail::of(
            "Block between a flat plate and a parabola",
            &["P / P₁", "outcome", "last closed point / width", "p at the corner / peak"],
            LOADS.into_iter().zip(&self.loads).map(row),
        )
    }
}
