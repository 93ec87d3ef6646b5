//! Quantities of a run, and what an oracle reads for them.

use crate::case::check::Reference;
use crate::case::definition::Case;
use crate::case::quantity::Quantity;
use crate::error::Error;
use crate::measure::{larger, nodal, profile};
use crate::oracle;
use crate::solve::run::Contact;
use crate::solve::{Discretisation, Run, Shear};

/// Half-widths over which profiles are compared.
const COMPARED: f64 = 1.5;
/// A node this near to where a stress is asked for is that place \[rad\].
const NEAR: f64 = 1e-6;

/// A case solved: the mesh, the run, and the verification run of the same mesh where a check asks for it.
pub(super) struct Solved<'a> {
    pub(super) case: &'a Case,
    pub(super) discretisation: &'a Discretisation,
    pub(super) run: &'a Run,
    pub(super) verification: Option<&'a Run>,
}

impl Solved<'_> {
    /// The value of a quantity in a contact; NaN, which no check passes, where the run did not converge.
    pub(super) fn value(&self, quantity: &Quantity, contact: usize) -> Result<f64, Error> {
        if !self.run.solution.converged() {
            return Ok(f64::NAN);
        }
        let points = self.run.solution.points_of(contact);
        let Contact { measures, transmitted, unbounded, .. } = &self.run.contacts[contact];
        Ok(match quantity {
            // A peak without a limit is no number to be judged.
            Quantity::PeakPressure if unbounded.is_some() => f64::NAN,
            Quantity::PeakPressure => measures.peak.pressure,
            Quantity::HalfWidth => measures.half_width(),
            Quantity::HalfAngle => measures.half_width().to_degrees(),
            Quantity::SecondMomentWidth => measures.second_moment_width,
            Quantity::SecondMomentAngle => measures.second_moment_width.to_degrees(),
            Quantity::Centre => measures.centre,
            Quantity::Resultant => *transmitted,
            Quantity::Pressure { at } => {
                let stretch = self.discretisation.scene.contacts[contact].stretch;
                nodal::pressure_at(self.run.solution.part(contact), stretch, at.value())
            }
            Quantity::HoopStress { at } => self.hoop_stress(contact, *at)?,
            Quantity::Reaction { body, support } => self.reaction([*body, *support])?,
            Quantity::Displacement(of) => self.discretisation.displaced(&self.displacement(), of)?,
            Quantity::Approach => self.discretisation.approach(&self.displacement(), contact)?.unwrap_or(f64::NAN),
            Quantity::Shear { body } => self.shear([contact, *body])?.map_or(f64::NAN, |shear| shear.stress),
            Quantity::ShearDepth { body } => self.shear([contact, *body])?.map_or(f64::NAN, |shear| shear.depth),
            Quantity::Profile => {
                profile::relative_l2(points, |s| self.case.reference_pressure(s), COMPARED * self.edge(contact))
            }
            Quantity::EdgeMeans => self
                .verification
                .map_or(f64::NAN, |other| profile::misplaced(&self.run.solution.edges, &other.solution.edges)),
            Quantity::Departure => {
                let departure = |at: f64, p: f64| (p - self.case.reference_pressure(at)).abs();
                let largest = points.iter().map(|p| departure(p.position, p.pressure)).fold(0.0, larger);
                largest / self.scale()
            }
            Quantity::Dofs => self.run.dofs as f64,
            Quantity::Named { .. } => f64::NAN,
        })
    }

    /// What the oracle of a contact reads for a quantity.
    pub(super) fn reading(&self, quantity: &Quantity, contact: usize) -> Reference {
        match quantity {
            Quantity::Profile => {
                let peak = self.case.reference(contact, &Quantity::PeakPressure);
                Reference { value: 0.0, ..peak }
            }
            other => self.case.reference(contact, other),
        }
    }

    /// The largest pressure of the oracle \[MPa\]; the scene's reference pressure where nothing presses.
    fn scale(&self) -> f64 {
        match self.case.reading(oracle::Quantity::PeakPressure).value {
            peak if peak > 0.0 => peak,
            _ => self.case.scene.reference.pressure,
        }
    }

    /// Where the contact of the oracle ends \[mm, or rad on arcs\].
    fn edge(&self, contact: usize) -> f64 {
        let on_arc = !self.case.scene.contacts[contact].path.is_straight();
        let edge = if on_arc { oracle::Quantity::ContactAngle } else { oracle::Quantity::HalfWidth };
        self.case.reading(edge).value
    }

    /// Force of a support \[N\].
    fn reaction(&self, support: [usize; 2]) -> Result<f64, Error> {
        let reactions = self.discretisation.reactions_under(self.run.share(), &self.run.solution)?;
        let wanted = reactions.iter().find(|reaction| [reaction.body, reaction.support] == support);
        Ok(wanted.map_or(f64::NAN, |reaction| reaction.force))
    }

    /// Displacement of every node \[mm\].
    fn displacement(&self) -> Vec<[f64; 2]> {
        self.discretisation.displacement_under(self.run.share(), &self.run.solution)
    }

    /// The largest shear stress below a contact in a body; none where it has no limit, or there is none inside.
    fn shear(&self, [contact, body]: [usize; 2]) -> Result<Option<Shear>, Error> {
        let found = &self.run.contacts[contact];
        if found.unbounded.is_some() {
            return Ok(None);
        }
        self.discretisation.shear_below(&self.displacement(), &found.measures, [contact, body])
    }

    /// Hoop stress at the node of the secondary body's contact side at an angle \[MPa\]; NaN where no node is there.
    fn hoop_stress(&self, contact: usize, at: f64) -> Result<f64, Error> {
        let fields = self.discretisation.recover(&self.run.solution)?;
        let along = self.discretisation.hoop_stresses(&fields, contact)?;
        let nearest = along.into_iter().min_by(|a, b| (a[0] - at).abs().total_cmp(&(b[0] - at).abs()));
        Ok(nearest.filter(|[place, _]| (place - at).abs() < NEAR).map_or(f64::NAN, |[_, stress]| stress))
    }
}
