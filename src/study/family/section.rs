//! Pressure and angle by clearance, and the slopes.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::family::run::{Curves, Ended, Line, Numbers, Place, Placed, Sensitivities, Slope};

/// The chart and both tables.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::from("Three dimensionless numbers place any published figure of a pin in an eye.\n\n");
    text += &picture("family-pin-rod.svg", "Peak pressure and second-moment angle against dimensionless clearance");
    for found in findings {
        text += &match found.numbers {
            Numbers::Curves(curves) => of_curves(curves),
            Numbers::Sensitivities(sensitivities) => of_slopes(sensitivities),
        };
    }
    Ok(text)
}

/// A name for each curve: the eyes, then the shanks.
pub fn named(curves: &Curves) -> impl Iterator<Item = (String, &Line)> {
    let eyes = curves.eyes.iter().map(|line| (format!("eye {} R", line.value), line));
    eyes.chain(curves.shanks.iter().map(|line| (format!("shank {} · 2R", line.value), line)))
}

fn of_curves(curves: &Curves) -> String {
    let head = ["R t p_max/F / 2√(∫pθ²/∫p) at E t c/F =".into()].into_iter();
    let head: Vec<String> = head.chain(curves.clearances.iter().map(f64::to_string)).collect();
    let cell = |ended: &Ended| match ended {
        Ended::Converged(Placed { pressure, angle }) => format!("{pressure:.3} / {:.1}°", angle.to_degrees()),
        Ended::Beyond => "beyond the quarter".into(),
        Ended::NotConverged => "not converged".into(),
    };
    let rows = named(curves).map(|(name, line)| [name].into_iter().chain(line.ended.iter().map(cell)).collect());
    let table = markdown::table(&head, &rows.collect::<Vec<_>>());
    format!("**Pin–rod: pressure and second-moment angle by dimensionless clearance**\n\n{table}\n")
}

fn of_slopes(sensitivities: &Sensitivities) -> String {
    let Place { clearance, eye, shank } = sensitivities.at;
    let row = |slope: &Slope| {
        let slopes = slope.slope.map(|slope| format!("{slope:+.3}"));
        [slope.number.to_string()].into_iter().chain(slopes).collect()
    };
    let rows: Vec<Vec<String>> = sensitivities.slopes.iter().map(row).collect();
    let head = ["number", "∂ ln p_max / ∂ ln", "∂ ln angle / ∂ ln"].map(String::from);
    let table = markdown::table(&head, &rows);
    format!("**Pin–rod: sensitivities around E t c/F = {clearance}, eye {eye} R, shank {shank} · 2R**\n\n{table}\n")
}
