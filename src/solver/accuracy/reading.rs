//! The numbers that are quoted of a run, each with the scale of its round-off.

use crate::measure::Measures;
use crate::scene::ContactPair;
use crate::solve::{Discretisation, Displaced, Run};

/// A number of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Peak pressure \[MPa\].
    PeakPressure,
    /// Where it lies \[mm, or rad on arcs\].
    PeakPlace,
    /// Half-width: half of what lies between where the contact begins and ends.
    HalfWidth,
    /// Second-moment width; on arcs the same functional of the angle.
    SecondMomentWidth,
    /// Centre of pressure of a contact on both sides of s = 0.
    Centre,
    /// Where a closed stretch begins.
    Begin(usize),
    /// Where it ends.
    End(usize),
    /// Force along the load line \[N\].
    Resultant,
    /// Moment of the pressures about s = 0, of a straight contact on both sides of it \[N mm\].
    Moment,
}

/// What is measured.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// A number of a contact.
    Contact(usize, Quantity),
    /// Force of a support of a body \[N\].
    Reaction(usize, usize),
    /// Displacement of a side or of a point \[mm\].
    Displacement(Displaced),
    /// Approach of the bodies of a contact, positive where they have come nearer \[mm\].
    Approach(usize),
    /// Largest in-plane shear stress below a contact, in one of its bodies \[MPa\].
    Shear(usize, usize),
    /// Its depth below the surface \[mm\].
    ShearDepth(usize, usize),
}

/// A number, and the size that round-off of it is judged by.
#[derive(Clone, Debug)]
pub struct Reading {
    /// What is measured.
    pub subject: Subject,
    /// Its value.
    pub value: f64,
    /// What its round-off is relative to.
    pub scale: f64,
}

impl Reading {
    /// What its bar must stay below to say anything: the number itself; of what may vanish, as ends, centres, moments, reactions and
    /// displacements do, its scale. Where a maximum lies is told within whatever it may be: where values come near the largest.
    pub(super) fn size(&self) -> f64 {
        use Quantity::{HalfWidth, PeakPressure, Resultant, SecondMomentWidth};
        match self.subject {
            Subject::Contact(_, PeakPressure | HalfWidth | SecondMomentWidth | Resultant) | Subject::Shear(..) => {
                self.value.abs()
            }
            Subject::Contact(_, Quantity::PeakPlace) | Subject::ShearDepth(..) => f64::INFINITY,
            _ => self.scale.abs(),
        }
    }
}

impl Subject {
    /// The contact by whose elements the mesh is measured: its own, else the first.
    pub(super) fn contact(&self) -> usize {
        match *self {
            Self::Contact(contact, _) | Self::Approach(contact) => contact,
            Self::Shear(contact, _) | Self::ShearDepth(contact, _) => contact,
            Self::Reaction(..) | Self::Displacement(_) => 0,
        }
    }
}

impl Quantity {
    /// Those that an accuracy may be asked for.
    pub const ASKED: [Self; 2] = [Self::PeakPressure, Self::HalfWidth];

    /// Name in scene files and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::PeakPressure => "peak-pressure",
            Self::PeakPlace => "peak-place",
            Self::HalfWidth => "half-width",
            Self::SecondMomentWidth => "second-moment-width",
            Self::Centre => "centre",
            Self::Begin(_) => "begin",
            Self::End(_) => "end",
            Self::Resultant => "resultant",
            Self::Moment => "moment",
        }
    }

    /// Its value; NaN where there is no such stretch.
    pub fn of(self, measures: &Measures) -> f64 {
        let stretch = |k: usize| measures.stretches.get(k);
        match self {
            Self::PeakPressure => measures.peak.pressure,
            Self::PeakPlace => measures.peak.position,
            Self::HalfWidth => measures.half_width(),
            Self::SecondMomentWidth => measures.second_moment_width,
            Self::Centre => measures.centre,
            Self::Begin(k) => stretch(k).map_or(f64::NAN, |stretch| stretch.begin),
            Self::End(k) => stretch(k).map_or(f64::NAN, |stretch| stretch.end),
            Self::Resultant => measures.resultant,
            Self::Moment => measures.resultant * measures.centre,
        }
    }

    /// Those of a contact: what a symmetry line fixes is none.
    pub fn all(pair: &ContactPair, measures: &Measures) -> Vec<Self> {
        let across = pair.path.has_both_sides();
        let mut all =
            vec![Self::PeakPressure, Self::PeakPlace, Self::HalfWidth, Self::SecondMomentWidth, Self::Resultant];
        if across {
            all.push(Self::Centre);
        }
        if across && pair.path.is_straight() {
            all.push(Self::Moment);
        }
        for (k, stretch) in measures.stretches.iter().enumerate() {
            if across || stretch.begin > 0.0 {
                all.push(Self::Begin(k));
            }
            all.push(Self::End(k));
        }
        all
    }

    /// What round-off of it is relative to.
    pub(super) fn scale(self, measures: &Measures) -> f64 {
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
        let one = |quantity: Quantity| Reading {
            subject: Subject::Contact(contact, quantity),
            value: quantity.of(measures),
            scale: quantity.scale(measures),
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
pub(super) fn value_of(readings: &[Reading], subject: &Subject) -> f64 {
    readings.iter().find(|reading| reading.subject == *subject).map_or(f64::NAN, |reading| reading.value)
}
