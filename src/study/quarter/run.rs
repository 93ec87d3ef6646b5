//! Quarter and half cylinder, by a/R.

use serde::Serialize;

use crate::case::library::{Cylinder, CylinderModel};
use crate::error::Error;
use crate::measure::{larger, relative_error};
use crate::solve::{Discretisation, Formulation, Run};

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
