//! The record, and what can be measured again: errors and counts, not seconds.

use serde::Serialize;

use crate::error::Error;
use crate::mesh::Order;
use crate::study::Found;
use crate::study::timings::answers::Answers;
use crate::study::timings::digits::{self, RECOMPUTED, Reached};
use crate::study::timings::growth::{self, Counts, RECOUNTED};
use crate::study::timings::precision::{self, Family, Point};
use crate::study::timings::record::{Measured, Record};

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// Error against work on the meshes of a family.
    Precision(Precision),
    /// Growth of the work with the mesh.
    Growth(Box<Recounted>),
    /// What more digits cost.
    Digits(Redone),
}

/// Points of a family, with one order of cells.
#[derive(Clone, Debug, Serialize)]
pub struct Precision {
    /// As recorded.
    pub recorded: Vec<Point>,
    /// As they are now.
    pub fresh: Vec<Point>,
    /// How many there shall be.
    pub planned: usize,
}

/// Meshes fitted to the contact and 8-node ones.
#[derive(Clone, Debug, Serialize)]
pub struct Redone {
    /// As recorded.
    pub recorded: Vec<Reached>,
    /// The smaller ones as they are now; their seconds are of no use.
    pub fresh: Vec<Reached>,
}

impl Redone {
    /// Recorded meshes that are solved again.
    pub fn kept(recorded: &[Reached]) -> impl Iterator<Item = &Reached> {
        recorded.iter().filter(|one| one.dofs <= RECOMPUTED)
    }
}

/// The rest of the record.
#[derive(Clone, Debug, Serialize)]
pub struct Recounted {
    /// As recorded.
    pub recorded: Measured,
    /// Counts of its smaller meshes as they are now.
    pub fresh: Vec<Counts>,
}

impl Recounted {
    /// Recorded counts that are counted again.
    pub fn kept(recorded: &Measured) -> impl Iterator<Item = &Counts> {
        recorded.growth.iter().map(|one| &one.counts).filter(|counts| counts.dofs <= RECOUNTED)
    }
}

/// Every mesh of a family once more.
pub fn precision(family: Family, order: Order) -> Result<Numbers, Error> {
    let is_own = |point: &Point| point.family == family && point.cell_nodes == order.nodes_per_cell();
    let recorded = Record::read()?.points.into_iter().filter(is_own).collect();
    let answers = Answers::of(family)?;
    let fresh = family.elements().map(|elements| precision::measure(family, order, elements, &answers));
    let fresh = fresh.collect::<Result<Vec<_>, _>>()?.concat();
    let planned = family.elements().count() * family.formulations().len();
    Ok(Numbers::Precision(Precision { recorded, fresh, planned }))
}

/// The smaller meshes of the growth once more.
pub fn growth() -> Result<Numbers, Error> {
    let recorded = Record::read()?.measured;
    let counted = |kept: &Counts| growth::counts(kept.elements, kept.refinement);
    let fresh = Recounted::kept(&recorded).map(counted).collect::<Result<_, _>>()?;
    Ok(Numbers::Growth(Box::new(Recounted { recorded, fresh })))
}

/// The smaller of the meshes whose digits are recorded once more.
pub fn digits() -> Result<Numbers, Error> {
    let recorded = Record::read()?.measured.digits;
    let fresh = Redone::kept(&recorded).map(|kept| digits::measure(kept.cells, 1)).collect::<Result<_, _>>()?;
    Ok(Numbers::Digits(Redone { recorded, fresh }))
}

/// The record that the trials have read.
pub fn record(findings: &[Found<Numbers>]) -> Result<Record, Error> {
    let (mut measured, mut points) = (None, Vec::new());
    for found in findings {
        match found.numbers {
            Numbers::Precision(precision) => points.extend(precision.recorded.iter().cloned()),
            Numbers::Growth(growth) => measured = Some(growth.recorded.clone()),
            Numbers::Digits(_) => {}
        }
    }
    let none = || Error::at("timings", "the trial `growth` was not run", "run all trials");
    Ok(Record { measured: measured.ok_or_else(none)?, points })
}
