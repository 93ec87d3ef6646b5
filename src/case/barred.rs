//! Checks beside the error bars of the numbers that they judge.

use crate::accuracy::{self, Barred, Subject};
use crate::case::check::Relation;
use crate::case::definition::Case;
use crate::case::judged::Judged;
use crate::case::meshed::Meshed;
use crate::case::quantity::Quantity;
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::solve::Run;

impl Judged {
    /// The number that is judged, where it has an error bar; an error that is judged has none.
    pub fn barred(&self) -> Option<Subject> {
        if self.check.relation == Relation::Error {
            return None;
        }
        let contact = self.check.contact;
        Some(match &self.check.quantity {
            Quantity::PeakPressure => Subject::Contact(contact, accuracy::Quantity::PeakPressure),
            Quantity::HalfWidth | Quantity::HalfAngle => Subject::Contact(contact, accuracy::Quantity::HalfWidth),
            Quantity::Centre => Subject::Contact(contact, accuracy::Quantity::Centre),
            Quantity::Resultant => Subject::Contact(contact, accuracy::Quantity::Resultant),
            Quantity::Reaction { body, support } => Subject::Reaction(*body, *support),
            Quantity::Displacement(displaced) => Subject::Displacement(displaced.clone()),
            Quantity::Approach => Subject::Approach(contact),
            Quantity::Shear { body } => Subject::Shear(contact, *body),
            Quantity::ShearDepth { body } => Subject::ShearDepth(contact, *body),
            _ => return None,
        })
    }

    /// Whether a number is held against that of a closed form.
    pub fn is_of_closed_form(&self) -> bool {
        let near = matches!(self.check.relation, Relation::Near | Relation::NearAbsolutely);
        near && self.reference.kind == ReferenceKind::Analytic
    }

    /// The check with the bar of the number that it judges; NaN where that is among those that have one, and it is not known.
    pub fn with_bar(self, bars: &[Barred]) -> Self {
        // Bars of angles are in radians, as what the run measures.
        let unit = if self.check.quantity == Quantity::HalfAngle { 1f64.to_degrees() } else { 1.0 };
        let of = |subject: Subject| {
            let found = bars.iter().find(|one| one.subject == subject);
            found.map_or(f64::NAN, |one| unit * one.bar.total())
        };
        Self { bar: self.barred().map(of), ..self }
    }

    /// Bar of the number in terms of the error: over the reference where that is relative.
    pub fn bar_as_error(&self) -> Option<f64> {
        let scale = if self.check.relation == Relation::Near { self.reference.value.abs() } else { 1.0 };
        self.bar.map(|bar| bar / scale)
    }

    /// Whether the error is within the bar and what the closed form itself may be off; none where the number has no bar or is not
    /// held against a closed form, false where the bar is not known.
    pub fn is_within_bar(&self) -> Option<bool> {
        self.bar_as_error().filter(|_| self.is_of_closed_form()).map(|bar| self.error <= bar + self.check.model)
    }
}

impl Case {
    /// Judged checks of a converged run with the bars of their numbers; what coarser meshes say is solved for once for each
    /// contact element, and for no check that has no bar.
    pub(super) fn with_bars(&self, meshed: &Meshed, run: &Run, judged: Vec<Judged>) -> Result<Vec<Judged>, Error> {
        let subjects: Vec<Subject> = judged.iter().filter_map(Judged::barred).collect();
        if subjects.is_empty() || !run.solution.converged() {
            return Ok(judged);
        }
        let Meshed { discretisation, .. } = meshed;
        let wanted = self.displaced();
        let of_contacts = subjects.iter().all(|subject| matches!(subject, Subject::Contact(..)));
        let family = meshed.family(run, &wanted);
        let wanted = (!of_contacts).then_some(wanted.as_slice());
        let bars = accuracy::of_family(discretisation, run, family, wanted)?;
        Ok(judged.into_iter().map(|one| one.with_bar(&bars)).collect())
    }
}
