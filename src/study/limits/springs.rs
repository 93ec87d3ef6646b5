//! Limit of stiff springs: the digits they cost.

use serde::Serialize;

use crate::case::library::{PinRod, TruncatedHertz};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::order;
use crate::mesh::Order;
use crate::solve::{Discretisation, Formulation, LIMITS};
use crate::stability::conditioning::{self, Conditioning};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::Refusal;
use crate::study::limits::solved::{largest, meshed, truncated};
use crate::study::limits::written::{number, range};

/// Error of one solve that leaves three digits of the pressure.
const THREE_DIGITS: f64 = 1e-3;

/// Condition and digits as springs stiffen beyond what users may ask for.
#[derive(Clone, Debug, Serialize)]
pub struct SpringStiffness {
    /// κ.
    pub stiffnesses: Vec<f64>,
    /// Of a body on a rigid plane.
    pub plane: Vec<Conditioning>,
    /// Of two bodies.
    pub pin_rod: Vec<Conditioning>,
    /// The error at ten times the limit.
    pub refused: Refusal,
}

/// Springs where the verified solution is in contact.
pub(super) fn run() -> Result<SpringStiffness, Error> {
    let stiffnesses: Vec<f64> = (0..=8).map(|k| 10f64.powi(2 * k)).collect();
    let one = truncated(TruncatedHertz::default(), 8, Order::Quadratic)?;
    let formulation = Formulation { stiffness: 10.0 * LIMITS[1], ..Formulation::verification() };
    Ok(SpringStiffness {
        plane: conditions(&one, &stiffnesses)?,
        pin_rod: conditions(&meshed(PinRod::default().scene(), 8, Order::Quadratic)?, &stiffnesses)?,
        refused: Refusal::expected(one.solve(&formulation), "a spring stiffer than the limit")?,
        stiffnesses,
    })
}

fn conditions(discretisation: &Discretisation, stiffnesses: &[f64]) -> Result<Vec<Conditioning>, Error> {
    let formulation = Formulation::verification();
    let solution = discretisation.solve(&formulation)?;
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let nothing = Conditioning { condition: f64::NAN, plain: f64::NAN, refined: f64::NAN };
    let at = |kappa: &f64| {
        let spring = |p: &f64| if *p > 0.0 { kappa * problem.scale.stiffness } else { 0.0 };
        let springs: Vec<f64> = solution.spring_pressures.iter().map(spring).collect();
        conditioning::of(&problem, &springs).unwrap_or(nothing)
    };
    Ok(stiffnesses.iter().map(at).collect())
}

impl SpringStiffness {
    /// The first κ at which two bodies are refused; NaN where none is.
    fn first_refused(&self) -> f64 {
        let mut pairs = self.stiffnesses.iter().zip(&self.pin_rod);
        pairs.find(|(_, found)| found.refined.is_nan()).map_or(f64::NAN, |(kappa, _)| *kappa)
    }

    /// `d log / d log κ` on the rigid plane.
    fn slope(&self, of: fn(&Conditioning) -> f64, range: std::ops::Range<usize>) -> f64 {
        order::slope(&self.stiffnesses[range.clone()], &self.plane[range].iter().map(of).collect::<Vec<_>>())
    }

    fn slope_of_errors(&self) -> f64 {
        self.slope(|found| found.plain, 2..8)
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let both = self.plane.iter().zip(&self.pin_rod);
        let allowed = self.stiffnesses.iter().zip(both).filter(|(kappa, _)| **kappa <= LIMITS[1]);
        let refined = largest(allowed.flat_map(|(_, (one, two))| [one.refined, two.refined]));
        let proportional = |quantity: &'static str, slope: f64, because: &'static str| {
            Check::error(quantity, Reference::analytic("growth in proportion to κ", 0.0), 0.1, because)
                .judge((slope - 1.0).abs())
        };
        vec![
            proportional(
                "|d log condition / d log κ − 1|",
                self.slope(|found| found.condition, 2..6),
                "the largest eigenvalue is A κ",
            ),
            proportional(
                "|d log error / d log κ − 1|",
                self.slope_of_errors(),
                "p = κ (w − g), and w − g carries round-off of w",
            ),
            Check::error(
                Quantity::at("largest error of a refined pressure over p_ref", "κ ≤ 1e6"),
                Reference::own("the mixed system", 0.0),
                1e-9,
                "the accuracy to which every run is compared with its variants",
            )
            .judge(refined),
            Check::at_least(
                "first κ at which two bodies are refused as having no spring left",
                Reference::own("two decades beyond the limit", 100.0 * LIMITS[1]),
                "a pivot falls as 1/κ, and is taken for round-off below 1e-10",
            )
            .judge(self.first_refused()),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let mut lost = self.stiffnesses.iter().zip(&self.plane).filter(|(_, found)| found.plain > THREE_DIGITS);
        let refined = largest(self.plane.iter().map(|found| found.refined));
        Limit {
            pushed: "stiffness of the springs",
            range: range(&self.stiffnesses, "κ"),
            onset: format!(
                "one solve loses {:.1} digits with every decade of κ, all but three by {}; after refinement errors are {}; two bodies are refused from {}",
                self.slope_of_errors(),
                number(lost.next().map_or(f64::NAN, |(kappa, _)| *kappa)),
                digits(refined),
                number(self.first_refused())
            ),
            seen: self.refused.to_string(),
            instead: self.refused.remedy.clone(),
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let cells = |found: &Conditioning| [condition(found.condition), digits(found.plain), digits(found.refined)];
        let row = |(i, kappa): (usize, &f64)| {
            [number(*kappa)].into_iter().chain(cells(&self.plane[i])).chain(cells(&self.pin_rod[i])).collect()
        };
        let head = [
            "κ",
            "condition, rigid plane",
            "error of one solve",
            "after refinement",
            "condition, pin–rod",
            "error of one solve",
            "after refinement",
        ];
        Detail::of(
            "Springs of κ on the final active set: condition of S + K, errors of the pressures over p_ref",
            &head,
            self.stiffnesses.iter().enumerate().map(row),
        )
    }
}

/// A condition number, as far as round-off lets it be known.
fn condition(condition: f64) -> String {
    if condition < 1e13 { format!("{condition:.0e}") } else { "> 1e13".into() }
}

/// An error of round-off by the next even power of ten above it: its digits are the machine's.
fn digits(error: f64) -> String {
    match error {
        e if e.is_nan() => "refused".into(),
        e if e < 1e-8 => "< 1e-8".into(),
        e => format!("< {:e}", 10f64.powi(2 * (0.5 * e.log10()).ceil() as i32)),
    }
}
