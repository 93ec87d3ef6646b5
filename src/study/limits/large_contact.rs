//! Limit of the reference: Hertz's parabola on a half-space.

use serde::Serialize;

use crate::case::library::{self, Cylinder};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::Order;
use crate::solve::run::Errors;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::{Refusal, Seen};
use crate::study::limits::solved::{exceeds, hertz_errors, meshed, verified, worst};
use crate::study::limits::written::{bracket, number, percents, range, size};

/// Half-widths over the radius.
const RATIOS: [f64; 7] = [0.005, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5];
/// Difference to Hertz that counts as its failure.
const FAILS: f64 = 0.01;
/// Difference to Hertz, and change by refinement, that is none.
const HOLDS: f64 = 1e-3;
/// Ratio from which on the contact is large.
const LARGE: f64 = 0.15;

/// Contacts of up to half the radius: the difference to Hertz grows, the change by refinement does not.
#[derive(Clone, Debug, Serialize)]
pub struct LargeContact {
    /// By ratio.
    pub ratios: Vec<AtRatio>,
    /// The error of a ratio beyond the last.
    pub refused: Refusal,
}

/// Runs at one ratio.
#[derive(Clone, Debug, Serialize)]
pub struct AtRatio {
    /// Differences to Hertz.
    pub difference: Errors,
    /// By how much they change from half as many elements.
    pub change: Errors,
    /// What the user sees.
    pub seen: Seen,
}

/// Every ratio.
pub(super) fn run() -> Result<LargeContact, Error> {
    let beyond = library::find("cylinder", Some(0.6));
    Ok(LargeContact {
        ratios: RATIOS.into_iter().map(at_ratio).collect::<Result<_, _>>()?,
        refused: Refusal::expected(beyond, "a contact of more than half the radius")?,
    })
}

fn at_ratio(a_over_r: f64) -> Result<AtRatio, Error> {
    let [coarse, fine] = [12, 24].map(|elements| {
        let scene = Cylinder { a_over_r, ..Default::default() }.scene();
        let discretisation = meshed(scene, elements, Order::Quadratic)?;
        let run = verified(&discretisation)?;
        Ok::<_, Error>((hertz_errors(&discretisation.scene, &run), Seen::of(&Ok(run))))
    });
    let ((coarse, _), (fine, seen)) = (coarse?, fine?);
    let change = Errors { peak: fine.peak - coarse.peak, half_width: fine.half_width - coarse.half_width };
    Ok(AtRatio { difference: fine, change, seen })
}

impl LargeContact {
    fn change(&self) -> f64 {
        worst(self.ratios.iter().map(|at| at.change))
    }

    /// Whether the difference to Hertz is above a bound.
    fn is_off(&self, ratio: usize, bound: f64) -> bool {
        exceeds(self.ratios[ratio].difference.largest(), bound)
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let large = RATIOS.iter().zip(&self.ratios).filter(|(ratio, _)| **ratio > LARGE);
        let changes = large.map(|(_, at)| at.change.largest() / at.difference.largest());
        let share = changes.reduce(larger).map_or(f64::NAN, f64::recip);
        vec![
            Check::error(
                Quantity::at("largest change of p₀ and a by refinement", "from 12 to 24 elements per half-width"),
                Reference::own("twice as fine a mesh", 0.0),
                HOLDS,
                "a tenth of the difference that is attributed to the reference",
            )
            .judge(self.change()),
            Check::at_least(
                Quantity::at("difference to Hertz over change by refinement of a large contact", "a/R ≥ 0.2"),
                Reference::own("ten times", 10.0),
                "parabola for circle, half-space for cylinder: of the order of (a/R)²",
            )
            .judge(share),
            Check::error(
                Quantity::at("error of p₀ and a of a small contact", "a/R = 0.005"),
                Reference::analytic("Hertz", 0.0),
                HOLDS,
                "(a/R)² is 2.5e-5; 24 8-node cells per half-width",
            )
            .judge(self.ratios[0].difference.largest()),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let trusted = (0..RATIOS.len()).take_while(|&i| !self.is_off(i, HOLDS)).last();
        let last = self.ratios.last().map(|at| at.seen.to_string()).unwrap_or_default();
        Limit {
            pushed: "a/R of the cylinder: Hertz's own limit",
            range: range(&RATIOS, "a/R"),
            onset: format!(
                "Hertz is off by {} {}; refinement changes p₀ and a by at most {}",
                size(FAILS),
                bracket(&RATIOS, |i| self.is_off(i, FAILS), "a/R"),
                size(self.change())
            ),
            seen: format!("{last}; beyond, {}", self.refused),
            instead: format!(
                "trust the solution, not Hertz; verify at a/R ≤ {}",
                number(trusted.map_or(f64::NAN, |i| RATIOS[i]))
            ),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |(ratio, at): (f64, &AtRatio)| {
            [ratio.to_string()].into_iter().chain(percents(at.difference)).chain(percents(at.change)).collect()
        };
        Detail::of(
            "Cylinder: what fails at large a/R",
            &["a/R", "p₀ against Hertz", "a against Hertz", "p₀, change by refinement", "a, change by refinement"],
            RATIOS.into_iter().zip(&self.ratios).map(row),
        )
    }
}
