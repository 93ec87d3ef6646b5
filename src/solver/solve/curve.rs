//! The load–approach curve: what every load increment came to.

use crate::error::Error;
use crate::measure::Measures;
use crate::solution::{Increment, Outcome};
use crate::solve::Discretisation;
use crate::solve::run::{Run, transmitted};

/// One load increment.
#[derive(Clone, Debug)]
pub struct CurvePoint {
    /// Share of loads and prescribed displacements that act.
    pub share: f64,
    /// How its iteration ended.
    pub outcome: Outcome,
    /// Iterations made in it.
    pub iterations: usize,
    /// What the contacts came to, in their order.
    pub contacts: Vec<CurveContact>,
}

/// One contact at the end of a load increment.
#[derive(Clone, Copy, Debug)]
pub struct CurveContact {
    /// Force on the whole contact along the load line, both halves \[N\].
    pub resultant: f64,
    /// Approach of its bodies \[mm\]; none where it is not defined.
    pub approach: Option<f64>,
    /// Half-width: half of what lies between where the contact begins and ends \[mm, or rad on an arc\].
    pub half_width: f64,
    /// Largest pressure \[MPa\]; none where it has no limit.
    pub peak: Option<f64>,
}

impl Discretisation {
    /// What every load increment of a run on this mesh came to, the one that did not converge included; empty where all
    /// of the load was applied at once.
    pub fn curve(&self, run: &Run) -> Result<Vec<CurvePoint>, Error> {
        run.solution.increments.iter().map(|increment| self.curve_point(run, increment)).collect()
    }

    fn curve_point(&self, run: &Run, increment: &Increment) -> Result<CurvePoint, Error> {
        let share = increment.number as f64 / run.formulation.settings.increments as f64;
        let unknowns = self.condensed.recover(share, &increment.displacement);
        let displacement = self.system.nodal_displacements(share, &unknowns);
        let contact = |index: usize| {
            let part = increment.states.part(&run.solution.contacts[index]);
            let measures = Measures::of(&self.scene, index, part);
            Ok(CurveContact {
                resultant: transmitted(&self.interfaces[index], &increment.contact_force),
                approach: self.approach(&displacement, index)?,
                half_width: measures.half_width(),
                peak: run.contacts[index].unbounded.is_none().then_some(measures.peak.pressure),
            })
        };
        let contacts = (0..self.interfaces.len()).map(contact).collect::<Result<_, Error>>()?;
        Ok(CurvePoint { share, outcome: increment.outcome, iterations: increment.iterations, contacts })
    }
}
