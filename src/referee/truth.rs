//! The truth of a case: its closed form where it has one, else our own fine answer; each with what it may itself be
//! off.

use std::sync::OnceLock;

use crate::accuracy::reference::{self, Known as Answered};
use crate::accuracy::{Bar, Barred, bars};
use crate::case::{self, Case, Reference};
use crate::error::Error;
use crate::measure::{Quantity, larger, nodal};
use crate::mesh::Resolution;
use crate::mesh::size::solvable;
use crate::oracle::{self, ReferenceKind};
use crate::scene::Component;
use crate::solve::{Discretisation, Formulation, Run};

/// A value with how far it may be off.
#[derive(Clone, Debug)]
pub struct Known {
    /// The value, its name and its kind.
    pub reference: Reference,
    /// How far it may be from the truth of the scene, in its unit; NaN where that is not known.
    pub bar: f64,
}

/// What a case is judged by.
pub struct Truth {
    /// The case.
    pub case: Case,
    /// Our own mesh.
    pub discretisation: Discretisation,
    /// Our own run on it.
    pub run: Run,
    /// What its numbers may be off.
    pub bars: Vec<Barred>,
    /// The run on a mesh fitted to the contact, whose pressures are known better; none where there is none, or they are
    /// not.
    pub fitted: Option<Run>,
    /// Our own answer on the mesh that the case is exported on: known from the first field on that is judged.
    pub exported: OnceLock<Exported>,
    /// Whether its profile is that of a closed form, known from the first pressure on that is read.
    is_closed: OnceLock<bool>,
}

/// Our own answer on the mesh that a case is exported on.
pub struct Exported {
    /// The case on that mesh.
    pub discretisation: Discretisation,
    /// Displacements of its nodes \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// Strain energies of our fine answer and of this one, body by body \[N mm\].
    pub energies: Vec<[f64; 2]>,
}

/// Name of our own answer.
pub const OURS: &str = "our fine answer";
/// Part of the half-width by which round-off may move the centre of a contact.
const CENTRED: f64 = 1e-6;
/// Pressure, over the largest of a closed form, from which on it has no limit.
const UNLIMITED: f64 = 1e6;

impl Truth {
    /// Solves the case on a mesh finer than its own, where that can be solved.
    pub fn of(case: Case) -> Result<Self, Error> {
        let (discretisation, run) = match finer(&case) {
            Some(found) => found,
            None => {
                let (meshed, run) = case.solve()?;
                (meshed.discretisation, run.clone())
            }
        };
        if !run.solution.converged() {
            let message = format!("our own run is {}, so that there is nothing to judge by", run.solution.outcome);
            let remedy = "look at what `contact-vv solve` says of the case, and change it until it converges";
            return Err(Error::at(case.name.as_str(), message, remedy));
        }
        let run = run.with_limits(&discretisation)?;
        let mut bars = bars(&discretisation, &run, &case.displaced())?.all;
        let may_be_fitted = case.oracle().is_none() && case.scene.contacts.len() == 1;
        // Where a mesh can be fitted to the contact.
        let answer = may_be_fitted.then(|| reference::answer(&case.scene).ok()).flatten();
        let fitted = answer.and_then(|reference::Answer { known, run, .. }| {
            let taken: Vec<&Answered> = known.iter().filter(|known| takes(&mut bars, known)).collect();
            taken.iter().any(|known| known.quantity == Quantity::PeakPressure).then_some(run)
        });
        Ok(Self {
            case,
            discretisation,
            run,
            bars,
            fitted,
            exported: Default::default(),
            is_closed: Default::default(),
        })
    }

    /// What the closed forms of the case say that our own run contradicts.
    pub fn notes(&self) -> Vec<String> {
        self.case.notes(&self.run, &self.bars)
    }

    /// Our own value of a number of a contact, with its bar.
    pub fn ours(&self, contact: usize, quantity: &Quantity) -> Known {
        let found = self.bars.iter().find(|one| one.is_of(contact, quantity));
        let (value, bar) = found.map_or((f64::NAN, f64::NAN), |one| (one.value, one.bar.total()));
        let (name, kind) = (OURS.into(), ReferenceKind::CrossCode);
        Known { reference: Reference { name, kind, value, uncertainty: None }, bar }
    }

    /// The closed form's value where there is one, with what the case states that it may be off; else ours with its
    /// bar. What our own answer departs from a closed form widens nothing: a fault of ours would let others be off by
    /// as much.
    pub fn known(&self, contact: usize, quantity: &Quantity) -> Known {
        let closed = self.closed(quantity);
        closed.map_or_else(
            || self.ours(contact, quantity),
            |reference| Known { bar: self.model(quantity) * reference.value.abs(), reference },
        )
    }

    /// What the oracle of the case reads of its only contact; none where it is silent, or there are several.
    pub fn closed(&self, quantity: &Quantity) -> Option<Reference> {
        let only = self.case.oracle().is_some() && self.case.scene.contacts.len() == 1;
        Some(self.case.reading(0, quantity)).filter(|reference| only && reference.value.is_finite())
    }

    /// What the case states that its closed form may be off of a number, relative; 0 where it states nothing.
    pub fn model(&self, quantity: &Quantity) -> f64 {
        let known_by = quantity.known_by(self.case.scene.contact());
        self.case.model_error(0, &case::Quantity::on(&self.case.scene, 0, known_by.clone()))
    }

    /// Whether equilibrium tells the force of a contact: loads act on a body of it that no support holds along the load
    /// line, and the forces of its other contacts are told so too.
    pub fn is_told_by_loads(&self, contact: usize) -> bool {
        let scene = &self.case.scene;
        let bodies = |contact: usize| {
            let pair = &scene.contacts[contact];
            std::iter::once(pair.first).chain(pair.second)
        };
        let is_free = |body: &usize| {
            let mut supports = scene.bodies[*body].supports.iter();
            supports.all(|support| support.component != Component::Y)
        };
        let mut told = vec![false; scene.contacts.len()];
        for _ in 0..told.len() {
            for one in 0..told.len() {
                let others_told = |body: usize| {
                    (0..told.len()).all(|other| other == one || told[other] || !bodies(other).any(|own| own == body))
                };
                told[one] |= bodies(one).filter(is_free).any(others_told);
            }
        }
        told[contact] && scene.bodies.iter().any(|body| !body.loads.is_empty())
    }

    /// Pressure at a contact coordinate of either side \[MPa\]; infinite where it has no limit.
    pub fn pressure(&self, contact: usize, s: f64) -> f64 {
        let pair = &self.case.scene.contacts[contact];
        let s = if pair.path.has_both_sides() { s } else { s.abs() };
        if self.has_closed_profile() {
            let peak = self.run.contacts[contact].measures.peak.pressure;
            return match self.case.oracle().map(|oracle| oracle.read(&Quantity::Pressure { at: s })) {
                Some(oracle::Reading::Value { value, .. })
                    if s.abs() <= pair.stretch * (1.0 + 1e-9) && value < UNLIMITED * peak =>
                {
                    value
                }
                Some(oracle::Reading::Value { value, .. }) if value < UNLIMITED * peak => 0.0,
                _ => f64::INFINITY,
            };
        }
        let run = self.fitted.as_ref().unwrap_or(&self.run);
        nodal::pressure_at(run.solution.part(contact), pair.stretch, s)
    }

    /// Whether the profile is that of a closed form, which is about s = 0: not of a contact whose centre of pressure
    /// lies elsewhere.
    pub fn has_closed_profile(&self) -> bool {
        *self.is_closed.get_or_init(|| self.closed_profile().is_some())
    }

    fn closed_profile(&self) -> Option<Reference> {
        let [centre, width] = [Quantity::Centre, Quantity::SecondMomentWidth].map(|one| self.ours(0, &one));
        let off = centre.reference.value.abs();
        let is_elsewhere = off > centre.bar + CENTRED * width.reference.value;
        // At s = 0 it may have no limit.
        let within = [0.0, 0.5 * width.reference.value];
        within.into_iter().find_map(|at| self.closed(&Quantity::Pressure { at })).filter(|_| !is_elsewhere)
    }

    /// Name and kind of the profile, and how far it may itself be off: of a closed form what the case states of it.
    pub fn of_profile(&self, contact: usize) -> Known {
        let (reference, bar) = match self.closed_profile() {
            Some(closed) => (closed, self.case.model_error(contact, &case::Quantity::Profile)),
            None => {
                let of_peak = |one: &&Barred| one.is_of(contact, &Quantity::PeakPressure);
                let bar = self.bars.iter().filter(of_peak).map(Barred::relative).fold(0.0, larger);
                (self.ours(contact, &Quantity::PeakPressure).reference, bar)
            }
        };
        Known { reference: Reference { value: 0.0, ..reference }, bar }
    }

    /// Whether the peak has no limit.
    pub fn is_unbounded(&self, contact: usize) -> bool {
        self.run.contacts[contact].unbounded.is_some()
    }
}

/// Takes a number of the contact that is known better, or that our own mesh tells no bar of; whether it did.
fn takes(bars: &mut [Barred], known: &Answered) -> bool {
    let own = bars.iter_mut().find(|one| one.is_of(0, &known.quantity));
    let is_wider = |bar: f64| bar.is_nan() || bar > known.bar;
    let Some(own) = own.filter(|own| known.bar.is_finite() && is_wider(own.bar.total())) else { return false };
    (own.value, own.bar) = (known.value, Bar { mesh: known.bar, iteration: 0.0, penalty: 0.0 });
    own.unknown = None;
    true
}

/// The case on a mesh with elements half as large, by exact active sets; none where that cannot be made, or does not
/// converge.
fn finer(case: &Case) -> Option<(Discretisation, Run)> {
    if case.accuracy.is_some() {
        return None;
    }
    let resolution = Resolution { refinement: case.resolution.refinement + 1, ..case.resolution };
    solvable(&case.scene, resolution).ok()?;
    let discretisation = Discretisation::of(case.scene.clone(), resolution).ok()?;
    let run = Run::of(&discretisation, &Formulation::verification()).ok()?;
    run.solution.converged().then_some((discretisation, run))
}
