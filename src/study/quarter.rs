//! The half cylinder against the quarter: the top may be left out while the contact is small.

use serde::Serialize;

use crate::case::library::{Cylinder, CylinderModel};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::{larger, relative_error};
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::About;
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Half cylinder against quarter",
    asked: "Whether the top quarter of the half cylinder may be left out, as the paper says.",
    limits: "One cylinder, one material, one way of loading it from above.",
};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("half cylinder against quarter", "node.kinematic", changes)]
}

/// Ratios a/R of the cylinder.
const A_OVER_R: [f64; 4] = [0.0125, 0.025, 0.05, 0.1];

/// Every a/R.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// From the smallest contact to the largest.
    pub changes: Vec<Change>,
}

/// The contact of each model at one a/R.
#[derive(Clone, Debug, Serialize)]
pub struct Change {
    /// Half-width of Hertz over the radius.
    pub a_over_r: f64,
    /// The lower quarter, loaded on its horizontal cut.
    pub quarter: Contact,
    /// The half cylinder, loaded on the same line.
    pub half: Contact,
    /// The half cylinder, loaded on its upper arc.
    pub above: Contact,
}

/// The two numbers of a Hertz contact.
#[derive(Clone, Debug, Serialize)]
pub struct Contact {
    /// Peak pressure \[MPa\].
    pub peak: f64,
    /// Half-width \[mm\].
    pub half_width: f64,
}

impl Change {
    /// Larger relative change of peak and second-moment width when the half loaded on the same line is modelled instead of the quarter.
    pub fn largest(&self) -> f64 {
        let (half, quarter) = (&self.half, &self.quarter);
        larger(relative_error(half.peak, quarter.peak), relative_error(half.half_width, quarter.half_width))
    }
}

/// Every model at every a/R.
pub fn changes() -> Result<Numbers, Error> {
    let change = |a_over_r| {
        Ok(Change {
            a_over_r,
            quarter: contact(a_over_r, CylinderModel::Quarter)?,
            half: contact(a_over_r, CylinderModel::Half)?,
            above: contact(a_over_r, CylinderModel::HalfLoadedAbove)?,
        })
    };
    Ok(Numbers { changes: A_OVER_R.into_iter().map(change).collect::<Result<_, Error>>()? })
}

fn contact(a_over_r: f64, model: CylinderModel) -> Result<Contact, Error> {
    let case = Cylinder { a_over_r, model, ..Default::default() }.case();
    let run = Run::of(&Discretisation::of(case.scene, case.resolution)?, &Formulation::verification())?;
    if !run.solution.converged() {
        return Ok(Contact { peak: f64::NAN, half_width: f64::NAN });
    }
    Ok(Contact { peak: run.measures().peak.pressure, half_width: run.measures().second_moment_width })
}

/// Change of peak and second-moment width below which the top quarter may be left out.
pub const LEFT_OUT: f64 = 1e-3;
/// Largest a/R at which that is required.
const JUDGED: f64 = 0.025;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let judged = numbers.changes.iter().filter(|change| change.a_over_r <= JUDGED);
    Ok(judged.flat_map(of).collect())
}

fn of(change: &Change) -> [Judged; 2] {
    let near = |quantity: &'static str, of: fn(&Contact) -> f64| {
        let at = format!("a/R = {}", change.a_over_r);
        let half = Reference::own("half cylinder", of(&change.half));
        Check::near(Quantity::at(quantity, at), half, LEFT_OUT, "far field: of the order of (a/R)²")
            .judge(of(&change.quarter))
    };
    [
        near("peak pressure of the quarter cylinder [MPa]", |contact| contact.peak),
        near("half-width of the quarter cylinder [mm]", |contact| contact.half_width),
    ]
}

/// Changes of peak and second-moment width.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let head = ["a/R", "p₀, loaded on the same line", "a, same line", "p₀, loaded on the upper arc", "a, upper arc"];
    let rows: Vec<Vec<String>> = findings.iter().flat_map(|found| &found.numbers.changes).map(row).collect();
    Ok(format!(
        "Change of the contact when the half cylinder is modelled instead of the quarter.\n\n{}\n",
        markdown::table(&head.map(String::from), &rows)
    ))
}

fn row(change: &Change) -> Vec<String> {
    let quarter = &change.quarter;
    let changes = [&change.half, &change.above]
        .into_iter()
        .flat_map(|half| [half.peak / quarter.peak, half.half_width / quarter.half_width])
        .map(|ratio| format!("{:+.3} %", 100.0 * (ratio - 1.0)));
    [change.a_over_r.to_string()].into_iter().chain(changes).collect()
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
