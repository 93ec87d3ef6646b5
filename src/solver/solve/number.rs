//! How every number that one quotes is taken from a solution.

use crate::error::Error;
use crate::measure::{Measures, Quantity, nodal};
use crate::solve::run::Contact;
use crate::solve::{Discretisation, Run};

/// A node this near to where a stress is asked for is that place \[rad\].
const NEAR: f64 = 1e-6;

impl Run {
    /// Whether it is the peak of a contact that has no limit, or the pressure where that is, which is no number.
    pub fn is_unbounded(&self, contact: usize, quantity: &Quantity) -> bool {
        let unbounded = self.contacts[contact].unbounded;
        match *quantity {
            Quantity::PeakPressure => unbounded.is_some(),
            Quantity::Pressure { at } => unbounded.is_some_and(|unbounded| unbounded.position.value() == at),
            _ => false,
        }
    }
}

impl Discretisation {
    /// A number of a run on this mesh, in its own unit; NaN where there is none: what has no limit, a support that is
    /// not there, a stress where no node is, an approach of bodies that are not pressed.
    pub fn number(&self, run: &Run, contact: usize, quantity: &Quantity) -> Result<f64, Error> {
        let Contact { measures, transmitted, unbounded, .. } = &run.contacts[contact];
        Ok(match quantity {
            Quantity::PeakPressure | Quantity::Shear { .. } | Quantity::ShearDepth { .. } if unbounded.is_some() => {
                f64::NAN
            }
            Quantity::Resultant => *transmitted,
            Quantity::Pressure { at } => {
                nodal::pressure_at(run.solution.part(contact), self.scene.contacts[contact].stretch, *at)
            }
            // On an arc, whose coordinate is the angle from the load line.
            Quantity::Across => {
                let points = run.solution.points_of(contact).iter();
                points.map(|one| one.pressure * one.weight * one.position.sin()).sum()
            }
            Quantity::HoopStress { at } => self.hoop_stress(run, contact, *at)?,
            Quantity::Reaction { body, support } => {
                let reactions = self.reactions(run.share(), &run.solution)?;
                let own = reactions.iter().find(|reaction| [reaction.body, reaction.support] == [*body, *support]);
                own.map_or(f64::NAN, |reaction| reaction.force)
            }
            Quantity::VonMises { body } => {
                let displacement = self.displacement_under(run.share(), &run.solution);
                let all = self.largest_von_mises(run, &displacement)?;
                all[*body].largest.map_or(f64::NAN, |largest| largest.stress)
            }
            of_pressures if of_pressures.is_of_pressures() => of_pressures.of(measures),
            other => {
                let displacement = self.displacement_under(run.share(), &run.solution);
                self.of_displacement(&displacement, measures, contact, other)?.unwrap_or(f64::NAN)
            }
        })
    }

    /// A number that the displacements of all nodes tell \[mm\], of a contact with some measures; none of others.
    pub fn of_displacement(
        &self,
        displacement: &[[f64; 2]],
        measures: &Measures,
        contact: usize,
        quantity: &Quantity,
    ) -> Result<Option<f64>, Error> {
        let shear = |body: usize| self.shear_below(displacement, measures, [contact, body]);
        Ok(Some(match quantity {
            Quantity::Displacement(of) => self.displaced(displacement, of)?,
            Quantity::Approach => self.approach(displacement, contact)?.unwrap_or(f64::NAN),
            Quantity::Shear { body } => shear(*body)?.map_or(f64::NAN, |shear| shear.stress),
            Quantity::ShearDepth { body } => shear(*body)?.map_or(f64::NAN, |shear| shear.depth),
            _ => return Ok(None),
        }))
    }

    /// Hoop stress at the node of the secondary body's contact side at an angle \[MPa\]; NaN where no node is there.
    fn hoop_stress(&self, run: &Run, contact: usize, at: f64) -> Result<f64, Error> {
        let fields = self.recover(&run.solution)?;
        let along = self.hoop_stresses(&fields, contact)?;
        let nearest = along.into_iter().min_by(|a, b| (a[0] - at).abs().total_cmp(&(b[0] - at).abs()));
        Ok(nearest.filter(|[place, _]| (place - at).abs() < NEAR).map_or(f64::NAN, |[_, stress]| stress))
    }
}
