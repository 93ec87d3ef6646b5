//! Limits of stiff springs: the digits they cost.

use super::{Limit, largest, meshed, number, range, refusal, said, table, truncated};
use crate::case::library::{PinRod, TruncatedHertz};
use crate::case::{Judged, Reference};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::measure::order;
use crate::mesh::Order;
use crate::solve::{Discretisation, Formulation, LIMITS};
use crate::stability::conditioning::{self, Conditioning};
use crate::study::unsorted::Finding;

/// Condition and digits as springs stiffen beyond what users may ask for.
pub(super) fn stiffness() -> Result<Finding, Error> {
    let kappas: Vec<f64> = (0..=8).map(|k| 10f64.powi(2 * k)).collect();
    let one = truncated(TruncatedHertz::default(), 8, Order::Quadratic)?;
    let plane = conditions(&one, &kappas)?;
    let pins = conditions(&meshed(PinRod::default().scene(), 8, Order::Quadratic)?, &kappas)?;
    let refused = kappas.iter().zip(&pins).find(|(_, found)| found.refined.is_nan()).map_or(f64::NAN, |(k, _)| *k);
    let formulation = Formulation { stiffness: 10.0 * LIMITS[1], ..Formulation::verification() };
    let (seen, instead) = said(&refusal(one.solve(&formulation), "a spring stiffer than the limit")?);
    let row = |(i, kappa): (usize, &f64)| {
        let both = [&plane[i], &pins[i]];
        let cells = both.into_iter().flat_map(|c| [condition(c.condition), digits(c.plain), digits(c.refined)]);
        std::iter::once(number(*kappa)).chain(cells).collect()
    };
    let rows = kappas.iter().enumerate().map(row).collect();
    let head = [
        "κ",
        "condition, rigid plane",
        "error of one solve",
        "after refinement",
        "condition, pin–rod",
        "error of one solve",
        "after refinement",
    ];
    let title = "Springs of κ on the final contact set: condition of S + K, errors of the pressures over p_ref";
    let first = plane.iter().position(|found| found.plain > 1e-3).unwrap_or(0);
    let limit = Limit {
        pushed: "stiffness of the springs",
        range: range(&kappas, "κ"),
        onset: format!(
            "one solve loses a digit with every decade of κ, all but three by {}, refinement none; two bodies are refused from {}",
            number(kappas[first]),
            number(refused)
        ),
        seen,
        instead,
    };
    Ok(limit.finding(vec![table(title, &head, rows)], digit_checks(&kappas, &plane, &pins, refused)))
}

fn digit_checks(kappas: &[f64], plane: &[Conditioning], pins: &[Conditioning], refused: f64) -> Vec<Judged> {
    let middle = 2..8;
    let slope = |of: fn(&Conditioning) -> f64, range: std::ops::Range<usize>| {
        order::observed(&kappas[range.clone()], &plane[range].iter().map(of).collect::<Vec<_>>())
    };
    let allowed = kappas.iter().zip(plane.iter().zip(pins)).filter(|(kappa, _)| **kappa <= LIMITS[1]);
    let errors: Vec<f64> = allowed.flat_map(|(_, (a, b))| [a.refined, b.refined]).collect();
    let exact = |quantity: &str, slope: f64, because: &str| {
        Judged::norm(
            "Condition and lost digits shall grow in proportion to the stiffness",
            quantity,
            (slope - 1.0).abs(),
            Reference::analytic("proportional to κ", 0.0),
            0.1,
            because,
        )
    };
    vec![
        exact("|d log condition / d log κ − 1|", slope(|c| c.condition, 2..6), "the largest eigenvalue is A κ"),
        exact(
            "|d log error / d log κ − 1|",
            slope(|c| c.plain, middle),
            "p = κ (w − g), and w − g carries round-off of w",
        ),
        Judged::norm(
            "No stiffness that users may ask for shall cost digits of the pressure",
            "largest error over p_ref, κ ≤ 1e6, refined",
            largest(&errors),
            Reference::own("mixed system", 0.0),
            1e-9,
            "the accuracy to which every run is compared with its variants",
        ),
        Judged::at_least(
            "No stiffness that users may ask for shall be refused as having no spring left",
            "first κ refused on two bodies",
            refused,
            Reference::own("two decades beyond the limit", 100.0 * LIMITS[1]),
            "a pivot falls as 1/κ, and is taken for round-off below 1e-10",
        ),
    ]
}

/// Condition and errors with springs of κ where the verified solution is in contact.
fn conditions(discretisation: &Discretisation, kappas: &[f64]) -> Result<Vec<Conditioning>, Error> {
    let formulation = Formulation::verification();
    let solution = discretisation.solve(&formulation)?;
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let nothing = Conditioning { condition: f64::NAN, plain: f64::NAN, refined: f64::NAN };
    let at = |kappa: &f64| {
        let spring = |p: &f64| if *p > 0.0 { kappa * problem.scale.stiffness } else { 0.0 };
        let springs: Vec<f64> = solution.spring_pressures.iter().map(spring).collect();
        conditioning::of(&problem, &springs).unwrap_or(nothing)
    };
    Ok(kappas.iter().map(at).collect())
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
