//! A case meshed, run and judged.

use std::sync::OnceLock;

use crate::accuracy::{self, Answer, Asked, Family};
use crate::case::check::{Against, Check, Reference};
use crate::case::definition::Case;
use crate::case::judged::Judged;
use crate::case::quantity::Quantity;
use crate::case::universal;
use crate::error::Error;
use crate::measure::{Quantity as Number, larger, profile};
use crate::oracle::ReferenceKind;
use crate::solve::{Discretisation, Displaced, Element, Formulation, Iteration, Run};

/// Half-widths over which profiles are compared.
const COMPARED: f64 = 1.5;

/// A case on its mesh, which all its formulations share.
pub struct Meshed {
    /// Mesh, system and condensation.
    pub discretisation: Discretisation,
    /// How the mesh was found, where an accuracy chose it.
    pub answer: Option<Answer>,
    /// What coarser meshes say, once it was asked for.
    pub families: Families,
}

/// What coarser meshes say, a contact element each.
pub type Families = [OnceLock<Family>; Element::ALL.len()];

impl Meshed {
    /// What coarser meshes say of the contact element of a run, and of the displacements that are wanted: solved for
    /// once.
    pub(super) fn family(&self, run: &Run, wanted: &[Displaced]) -> &Family {
        let Formulation { element, layer_thickness, .. } = run.formulation;
        let cell = &self.families[element as usize];
        if let Some(known) = cell.get() {
            return known;
        }
        // Not within the cell: a thread that waits in there might be handed work that needs it.
        let formulation = Formulation { layer_thickness, ..Formulation::new(element, Iteration::Kinematic) };
        let family = Family::of(&self.discretisation, &formulation, Some(wanted));
        cell.get_or_init(|| family)
    }
}

impl Case {
    /// The mesh that is given, or that the accuracy asked for chooses for the first formulation.
    pub fn meshed(&self) -> Result<Meshed, Error> {
        let found = || {
            let Some(asked) = &self.accuracy else {
                let discretisation = Discretisation::of(self.scene.clone(), self.resolution)?;
                return Ok(Meshed { discretisation, answer: None, families: Families::default() });
            };
            let mut answer = accuracy::solve(&self.scene, self.formulation(), asked)?;
            let held = answer.discretisation.take();
            let discretisation =
                held.map_or_else(|| Discretisation::of(answer.scene.clone(), answer.resolution), Ok)?;
            Ok(Meshed { discretisation, answer: Some(answer), families: Families::default() })
        };
        found().map_err(|error| self.located(error))
    }

    /// Runs a formulation on the mesh; where an accuracy chose that, as the answer was run, but from its own start.
    pub fn run(&self, meshed: &Meshed, formulation: &Formulation) -> Result<Run, Error> {
        let Meshed { discretisation, answer, .. } = meshed;
        let formulation = answer.as_ref().map_or(formulation, |answer| &answer.run.formulation);
        let run = Run::of(discretisation, formulation);
        // An accuracy has told which peaks have no limit.
        let run = if answer.is_none() { run.and_then(|run| run.with_limits(discretisation)) } else { run };
        run.map_err(|error| self.located(error))
    }

    /// The formulation that is named first, which is the only one of a file.
    pub fn formulation(&self) -> &Formulation {
        &self.formulations[0]
    }

    /// Meshes the case and runs its first formulation.
    pub fn solve(&self) -> Result<(Meshed, Run), Error> {
        let meshed = self.meshed()?;
        let run = self.run(&meshed, self.formulation())?;
        Ok((meshed, run))
    }

    /// Judges a run: what bounds every run, whether it converged, and of a case with checks these and what every
    /// converged run must satisfy. A reported run that did not converge is not judged, and says so.
    pub fn judge(&self, meshed: &Meshed, run: &Run) -> Result<Vec<Judged>, Error> {
        let discretisation = &meshed.discretisation;
        let mut judged: Vec<Judged> = universal::bounded(run).into_iter().collect();
        if !run.solution.converged() {
            let check = Check::none("run that does not converge", "its numbers are those of no solution").universal();
            let why = "the case is reported only, and the run did not converge";
            judged.push(match self.is_reported() {
                true => check.not_run(ReferenceKind::SelfConsistency, "none", why.into()),
                false => check.judge(1.0),
            });
        }
        if self.is_reported() {
            return Ok(judged);
        }
        judged.extend(self.with_bars(meshed, run, self.own(discretisation, run)?)?);
        judged.extend(self.accuracy.iter().zip(&meshed.answer).map(|(asked, answer)| met(asked, answer)));
        if run.solution.converged() {
            judged.extend(universal::checks(discretisation, run)?);
        }
        Ok(judged)
    }

    /// Whether it is shown without being judged: it is built in and declares no check.
    pub fn is_reported(&self) -> bool {
        self.checks.is_empty() && self.places.is_none()
    }

    /// The checks that the case declares, judged.
    pub fn own(&self, discretisation: &Discretisation, run: &Run) -> Result<Vec<Judged>, Error> {
        let needed = self.checks.iter().any(|check| check.against == Against::Verification);
        let verification = needed.then(|| Run::of(discretisation, &Formulation::verification())).transpose()?;
        let verification = verification.as_ref();
        let judged = |check: &Check| {
            let of = |run: &Run| self.value(check, discretisation, run, verification);
            let reference = match &check.against {
                Against::Value(reference) => reference.clone(),
                Against::Oracle => self.reference(check.contact, &check.quantity),
                Against::Verification => {
                    Reference::own("node.kinematic at 1e-8", verification.map_or(Ok(f64::NAN), of)?)
                }
            };
            Ok(check.clone().judge_by(of(run)?, reference))
        };
        self.checks.iter().map(judged).collect::<Result<_, Error>>().map_err(|error| self.located(error))
    }

    /// The value of what a check asks for; NaN, which no check passes, where the run did not converge. Where it is held
    /// against the verification run of the same mesh, that is given.
    fn value(
        &self,
        check: &Check,
        discretisation: &Discretisation,
        run: &Run,
        verification: Option<&Run>,
    ) -> Result<f64, Error> {
        if !run.solution.converged() {
            return Ok(f64::NAN);
        }
        let (quantity, contact) = (&check.quantity, check.contact);
        let points = run.solution.points_of(contact);
        let pressure = |at: f64| self.reference_pressure(contact, at);
        Ok(match quantity {
            Quantity::Number { of, .. } => quantity.factor() * discretisation.number(run, contact, of)?,
            Quantity::Profile => {
                let half_width = self.reading(contact, &Number::HalfWidth).value;
                profile::relative_l2(points, pressure, COMPARED * half_width)
            }
            Quantity::EdgeMeans => {
                verification.map_or(f64::NAN, |other| profile::misplaced(&run.solution.edges, &other.solution.edges))
            }
            Quantity::Departure => {
                let departures = points.iter().map(|point| (point.pressure - pressure(point.position)).abs());
                departures.fold(0.0, larger) / self.scale(contact)
            }
            Quantity::Named { .. } => f64::NAN,
        })
    }

    /// The largest pressure of the oracle of a contact \[MPa\]; the scene's reference pressure where nothing presses.
    fn scale(&self, contact: usize) -> f64 {
        match self.reading(contact, &Number::PeakPressure).value {
            peak if peak > 0.0 => peak,
            _ => self.scene.reference.pressure,
        }
    }

    /// The error with its line, where the case is of a file and the error of something in it.
    pub fn located(&self, error: Error) -> Error {
        match &self.places {
            Some(places) => places.locate(error),
            None => error,
        }
    }
}

/// That an accuracy is met, by the estimate, which tells nothing where it is within what was asked and the search says
/// otherwise.
pub fn met(asked: &Asked, answer: &Answer) -> Judged {
    let estimate = answer.estimate();
    let is_contradicted = answer.unmet.is_some() && estimate <= asked.relative;
    estimated(if is_contradicted { f64::NAN } else { estimate }, asked.relative)
}

/// The same of an estimated error; NaN where the search says that it is not met.
pub fn estimated(error: f64, asked: f64) -> Judged {
    let because = "the bars of the mesh, which coarser ones tell";
    let quantity = Quantity::at("estimated error of the mesh that an accuracy chose", "");
    Check::error(quantity, Reference::own("its error bars", 0.0), asked, because).judge(error)
}
