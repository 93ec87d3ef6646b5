//! Checks beside the error bars of the numbers that they judge.

use crate::accuracy::{self, Barred};
use crate::case::check::{Against, Check, Reference, Relation};
use crate::case::definition::Case;
use crate::case::judged::Judged;
use crate::case::quantity::Quantity;
use crate::case::solved::Meshed;
use crate::error::Error;
use crate::markdown;
use crate::measure::Quantity as Number;
use crate::oracle::ReferenceKind;
use crate::solve::Run;

impl Judged {
    /// The number that is judged, where it has an error bar: what is taken at a place has none, nor an error that is
    /// judged.
    pub fn barred(&self) -> Option<&Number> {
        let number = self.check.quantity.number().filter(|_| self.check.relation != Relation::Error)?;
        let is_at_place = matches!(number, Number::Pressure { .. } | Number::HoopStress { .. });
        (!is_at_place).then_some(number)
    }

    /// Whether a number is held against that of a closed form.
    pub fn is_of_closed_form(&self) -> bool {
        let near = matches!(self.check.relation, Relation::Near | Relation::NearAbsolutely);
        near && self.reference.kind == ReferenceKind::Analytic
    }

    /// The check with the bar of the number that it judges; NaN where that is among those that have one, and it is not
    /// known.
    pub fn with_bar(self, bars: &[Barred]) -> Self {
        let (contact, factor) = (self.check.contact, self.check.quantity.factor());
        let of = |number: &Number| {
            bars.iter().find(|one| one.is_of(contact, number)).map_or(f64::NAN, |one| factor * one.bar.total())
        };
        Self { bar: self.barred().map(of), ..self }
    }

    /// Bar of the number in terms of the error: over the reference where that is relative.
    pub fn bar_as_error(&self) -> Option<f64> {
        let scale = if self.check.relation == Relation::Near { self.reference.value.abs() } else { 1.0 };
        self.bar.map(|bar| bar / scale)
    }

    /// Whether how far the number may be off is known.
    pub fn has_known_bar(&self) -> bool {
        self.bar_as_error().is_some_and(|bar| !bar.is_nan())
    }

    /// Whether the error is within the bar and what the closed form itself may be off; none where the number has no bar
    /// or is not held against a closed form, false where the bar is not known.
    pub fn is_within_bar(&self) -> Option<bool> {
        self.bar_as_error().filter(|_| self.is_of_closed_form()).map(|bar| self.error <= bar + self.check.model)
    }
}

/// Difference of a force from the load of its closed form, over the latter, beyond which it is noted: loads are told to
/// three digits.
const LOAD: f64 = 1e-3;
/// The same where the bar of the force is not known.
const UNBARRED: f64 = 1e-2;
/// The same of other numbers, which a closed form may idealise.
const NOTED: f64 = 0.05;
/// Digits that a file gives.
const DIGITS: f64 = 1e-6;

impl Case {
    /// Peak, second-moment width and force of a converged run, each held against what the closed form of its contact
    /// says: it shall be within its bar and what the case states of the closed form. Bars that are not given are none.
    pub fn beside_closed_forms(&self, run: &Run, bars: &[Barred]) -> Vec<Judged> {
        let contacts = (0..run.contacts.len()).filter(|_| run.solution.converged());
        contacts.flat_map(|contact| self.beside_closed_form(run, bars, contact)).collect()
    }

    fn beside_closed_form(&self, run: &Run, bars: &[Barred], contact: usize) -> Vec<Judged> {
        let found = &run.contacts[contact];
        let measures = &found.measures;
        let all = [
            (Number::Resultant, found.transmitted),
            (Number::PeakPressure, measures.peak.pressure),
            (Number::SecondMomentWidth, measures.second_moment_width),
        ];
        let bounded = all.into_iter().filter(|(number, _)| !run.is_unbounded(contact, number));
        let all = bounded.map(|(number, value)| {
            let quantity = Quantity::on(&self.scene, contact, number);
            (self.reference(contact, &quantity), quantity.factor() * value, quantity)
        });
        let all =
            all.filter(|(reference, ..)| reference.value.abs() > 0.0 && reference.kind == ReferenceKind::Analytic);
        let judged = all.map(|(reference, value, quantity)| {
            let model = self.model_error(contact, &quantity);
            let because = "its error bar, and what the case states that its closed form is off";
            let check = Check { contact, ..Check::near(quantity, reference, DIGITS + model, because).leaving(model) };
            let judged = check.judge(value);
            let judged = if bars.is_empty() { judged } else { judged.with_bar(bars) };
            match judged.bar_as_error() {
                Some(bar) if bar.is_finite() => {
                    let tolerance = judged.check.tolerance + bar;
                    Judged { check: Check { tolerance, ..judged.check }, ..judged }
                }
                _ => judged,
            }
        });
        judged.collect()
    }

    /// What the case states that its closed form is off: for the quantity, else the most that it states for any, else
    /// for all.
    pub fn model_error(&self, contact: usize, quantity: &Quantity) -> f64 {
        let analytic = |check: &&Check| match &check.against {
            Against::Oracle => true,
            Against::Value(reference) => reference.kind == ReferenceKind::Analytic,
            Against::Verification => false,
        };
        let stated =
            || self.checks.iter().filter(|check| check.contact == contact && check.model > 0.0).filter(analytic);
        let own = stated().find(|check| check.quantity == *quantity).map(|check| check.model);
        own.unwrap_or_else(|| stated().map(|check| check.model).fold(self.model, f64::max))
    }

    /// What the closed forms say that the run contradicts, with both numbers: another load than the contact carries, or
    /// a contact that no mesh and no stated model error explains.
    pub fn notes(&self, run: &Run, bars: &[Barred]) -> Vec<String> {
        let beyond = |one: &Judged| {
            let is_known = one.bar.is_some_and(f64::is_finite);
            let is_unknown = one.bar.is_some_and(|bar| !bar.is_finite());
            let slack = match one.check.quantity.number() {
                Some(Number::Resultant) if is_known => LOAD + run.formulation.settings.tolerance,
                Some(Number::Resultant) => UNBARRED,
                _ => NOTED,
            };
            let within = one.error <= one.check.tolerance + slack;
            // Of a number that the mesh may not resolve nothing is said.
            let is_of_mesh = is_unknown && one.check.quantity.number() != Some(&Number::Resultant);
            !within && !is_of_mesh
        };
        self.beside_closed_forms(run, bars)
            .iter()
            .filter(|one| one.value.is_finite() && beyond(one))
            .map(|one| self.note(one))
            .collect()
    }

    fn note(&self, one: &Judged) -> String {
        let Judged { check, reference, value, .. } = one;
        let contact = &self.scene.contacts[check.contact].name;
        let closed = markdown::value(reference.value);
        let found = markdown::with_bar(*value, one.bar.filter(|bar| bar.is_finite()));
        let (name, unit) = (&reference.name, check.quantity.unit().unwrap_or_default());
        match check.quantity.number() {
            Some(Number::Resultant) => {
                let pair = &self.scene.contacts[check.contact];
                let whole = match (self.scene.is_of_revolution(), pair.symmetric) {
                    (true, _) => "all around",
                    (false, true) => "both halves of a symmetric one",
                    (false, false) => "the whole of it",
                };
                format!(
                    "the closed form of contact `{contact}` is not of this scene: {name} has a load of {closed} N, and \
                    the contact carries {found} N, {whole}"
                )
            }
            _ => format!(
                "the closed form of contact `{contact}` is not of this scene, or leaves more out than its checks state \
                as `model-error`: {} is {closed} {unit} by {name}, and {found} {unit} here",
                check.quantity.name()
            ),
        }
    }

    /// The numbers of a run beside its closed forms as checks of the suite: each error over its bar and the model error
    /// stated.
    pub fn held_to_closed_forms(&self, meshed: &Meshed, run: &Run) -> Result<Vec<Judged>, Error> {
        if self.oracles.iter().flatten().next().is_none() || !run.solution.converged() {
            return Ok(Vec::new());
        }
        let family = meshed.family(run, &self.displaced());
        let bars = accuracy::of_family(&meshed.discretisation, run, family, None)?;
        let barred = self.beside_closed_forms(run, &bars).into_iter();
        let barred = barred.filter(|one| one.bar.is_some_and(f64::is_finite));
        Ok(barred.map(|one| self.over_what_is_allowed(one)).collect())
    }

    /// The error over what is allowed, as an error of its own.
    fn over_what_is_allowed(&self, Judged { check, reference, error, .. }: Judged) -> Judged {
        let place = format!("{} of {}", check.quantity.name(), self.scene.contacts[check.contact].name);
        let quantity = Quantity::at("error against the closed form over bar and model error stated", place);
        let because = "a closed form that is off by more is not of this scene, or its case does not say so";
        // A force is that of the load that both were given: equilibrium, which is no closed form.
        let kind = match check.quantity.number() {
            Some(Number::Resultant) => ReferenceKind::SelfConsistency,
            _ => reference.kind,
        };
        let reference = Reference { value: 0.0, kind, ..reference };
        Check::error(quantity, reference, 1.0, because).judge(error / check.tolerance)
    }

    /// Judged checks of a converged run with the bars of their numbers; what coarser meshes say is solved for once for
    /// each contact element, and for no check that has no bar.
    pub(super) fn with_bars(&self, meshed: &Meshed, run: &Run, judged: Vec<Judged>) -> Result<Vec<Judged>, Error> {
        let barred: Vec<&Number> = judged.iter().filter_map(Judged::barred).collect();
        if barred.is_empty() || !run.solution.converged() {
            return Ok(judged);
        }
        let Meshed { discretisation, .. } = meshed;
        let wanted = self.displaced();
        let are_of_pressures = barred.iter().all(|number| number.is_of_pressures());
        let family = meshed.family(run, &wanted);
        let wanted = (!are_of_pressures).then_some(wanted.as_slice());
        let bars = accuracy::of_family(discretisation, run, family, wanted)?;
        Ok(judged.into_iter().map(|one| one.with_bar(&bars)).collect())
    }
}
