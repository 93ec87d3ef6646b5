//! Every run ends as it may, three numbers place a scene, a compliant eye embraces the pin, slopes do not depend on their step.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::family::run::{Curves, Ended, Line, Numbers, Placed, Sensitivities, Slope};

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Curves(curves) => of_curves(curves),
        Numbers::Sensitivities(sensitivities) => of_slopes(sensitivities),
    })
}

fn of_curves(curves: &Curves) -> Vec<Judged> {
    let lines: Vec<&Line> = curves.eyes.iter().chain(&curves.shanks).collect();
    let ended: Vec<Ended> = lines.iter().flat_map(|line| line.ended.clone()).collect();
    let lost = ended.iter().filter(|ended| matches!(ended, Ended::NotConverged)).count();
    let lost = Check::none(
        Quantity::at("scene of the family whose iteration does not converge", format!("of {}", ended.len())),
        "a contact is found, or refused because it reaches beyond the quarter",
    )
    .judge(lost as f64);
    let at_last = |line: &&Line| line.ended.last().map_or(f64::NAN, |ended| ended.placed().angle);
    let smallest = lines.iter().map(at_last).reduce(smaller).unwrap_or(f64::NAN);
    let embraced = Check::at_least(
        "smallest contact angle of all eyes at the largest clearance [°]",
        Reference::analytic("Persson, a wide plate", curves.wide_plate.to_degrees()),
        "an eye that bends embraces the pin",
    )
    .judge(smallest.to_degrees());
    let [first, other] = &curves.same_place;
    let placed =
        [("R t p_max / F", (|p| p.pressure) as fn(&Placed) -> f64), ("angle", |p| p.angle)].map(|(name, of)| {
            Check::near(
                Quantity::at("result for another pin of the same three numbers", name),
                Reference::own("the default pin", of(first)),
                5e-3,
                "the family leaves c/R out, which is 0.005 and 0.006 here: results depend on it in that order",
            )
            .judge(of(other))
        });
    [lost, embraced].into_iter().chain(placed).collect()
}

/// The smaller of two numbers; NaN if either is.
fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// Change of a slope with half the step.
const STEPS: f64 = 0.02;

fn of_slopes(sensitivities: &Sensitivities) -> Vec<Judged> {
    let of_number = |slope: &Slope| {
        ["p_max", "angle"]
            .into_iter()
            .enumerate()
            .map(|(k, result)| {
                let quantity =
                    Quantity::at("change of a sensitivity by half the step", format!("{result} by {}", slope.number));
                let because =
                    "central differences: error of the order of the step squared, and of the mesh that changes with it";
                Check::error(quantity, Reference::own("half the step", 0.0), STEPS, because)
                    .judge((slope.slope[k] - slope.by_half[k]).abs())
            })
            .collect::<Vec<_>>()
    };
    sensitivities.slopes.iter().flat_map(of_number).collect()
}
