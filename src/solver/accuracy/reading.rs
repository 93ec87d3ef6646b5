//! The numbers that are quoted of a run, each with the scale of its round-off.

use crate::measure::{Measures, Quantity};
use crate::scene::ContactPair;
use crate::solve::{Discretisation, Run};

/// A number, and the size that round-off of it is judged by.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Index of the contact that it is of; 0 of reactions and displacements.
    pub contact: usize,
    /// What is measured.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// What its round-off is relative to.
    pub scale: f64,
}

impl Reading {
    /// What its bar must stay below to say anything: the number itself; of what may vanish, as ends, centres, moments, reactions and
    /// displacements do, its scale. Where a maximum lies is told within whatever it may be: where values come near the largest.
    pub(super) fn size(&self) -> f64 {
        use Quantity::{HalfWidth, PeakPlace, PeakPressure, Resultant, SecondMomentWidth, Shear, ShearDepth, VonMises};
        match self.quantity {
            PeakPressure | HalfWidth | SecondMomentWidth | Resultant | Shear { .. } | VonMises { .. } => {
                self.value.abs()
            }
            PeakPlace | ShearDepth { .. } => f64::INFINITY,
            _ => self.scale.abs(),
        }
    }
}

impl Quantity {
    /// Those that an accuracy may be asked for.
    pub const ASKED: [Self; 2] = [Self::PeakPressure, Self::HalfWidth];

    /// What round-off of a number of the pressures is relative to.
    pub(super) fn scale(&self, measures: &Measures) -> f64 {
        match self {
            Self::PeakPressure => measures.peak.pressure,
            Self::Resultant => measures.resultant,
            Self::Moment => measures.resultant * measures.second_moment_width,
            _ => measures.second_moment_width,
        }
    }
}

/// The numbers of some measures, contact by contact.
pub fn of_contacts(discretisation: &Discretisation, measures: &[&Measures]) -> Vec<Reading> {
    let pairs = discretisation.scene.contacts.iter().zip(measures).enumerate();
    let of = |(contact, (pair, measures)): (usize, (&ContactPair, &&Measures))| {
        let one = |quantity: Quantity| {
            let (value, scale) = (quantity.of(measures), quantity.scale(measures));
            Reading { contact, quantity, value, scale }
        };
        Quantity::all(pair, measures).into_iter().map(one).collect::<Vec<_>>()
    };
    pairs.flat_map(of).collect()
}

/// Numbers of what the iteration shall end in, or of the discrete solution.
pub(super) fn of_discrete(discretisation: &Discretisation, run: &Run, which: usize) -> Vec<Reading> {
    let measures = run.contacts.iter().map(|contact| contact.exact.as_ref().map(|exact| &exact[which]));
    measures.collect::<Option<Vec<_>>>().map_or_else(Vec::new, |measures| of_contacts(discretisation, &measures))
}

/// The value of a number among some; NaN where it is none of them.
pub(super) fn value_of(readings: &[Reading], contact: usize, quantity: &Quantity) -> f64 {
    let found = readings.iter().find(|one| one.contact == contact && one.quantity == *quantity);
    found.map_or(f64::NAN, |one| one.value)
}
