//! The ladder along the contact: more and more elements on one growth.

use crate::accuracy::Quantity;
use crate::accuracy::estimate::{Estimate, envelope, richardson};
use crate::accuracy::rungs::{Attempt, Search};
use crate::error::Error;

/// Elements within the contact of the first ladder: halves of most are among them.
const LADDER: [usize; 16] = [2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64, 96, 128];
/// Part of the error asked for that the end of a ladder may be uncertain by.
const SETTLED: f64 = 0.2;
/// Part of the error asked for that the elements along the contact may take.
const SHARE: f64 = 0.6;
/// Rungs of a ladder on which the growth is judged, before gentler growth is tried.
const CHOSEN: usize = 2;

/// A ladder along the contact on one growth.
pub(super) struct Along {
    /// Rungs whose elements are small enough, the cheapest first.
    pub(super) chosen: Vec<Fine>,
    /// Its finest rung; none where not even one was solved.
    pub(super) finest: Option<Fine>,
    /// Why none is chosen.
    pub(super) unmet: Option<String>,
}

/// A rung, and what is known of the error that its elements along the contact leave.
#[derive(Clone)]
pub(super) struct Fine {
    pub(super) rung: usize,
    /// By quantity; NaN where nothing is known.
    pub(super) errors: Vec<f64>,
    /// Observed orders, by quantity.
    pub(super) orders: Vec<f64>,
}

impl Search<'_> {
    /// Refines the elements along the contact until their error is known well enough to choose among them.
    pub(super) fn along(&mut self, level: u32) -> Result<Along, Error> {
        let mut ladder: Vec<(usize, usize)> = Vec::new();
        let mut found = Along { chosen: vec![], finest: None, unmet: None };
        let mut why = "the elements along the contact leave too large an error".to_owned();
        for elements in LADDER {
            let at = match self.attempt(self.plan(elements, level), "elements")? {
                Attempt::Solved(at) => at,
                Attempt::Short => {
                    self.widen();
                    continue;
                }
                Attempt::Stopped(reason) => {
                    why = reason;
                    break;
                }
            };
            self.look(at);
            ladder.push((elements, at));
            let Some(estimates) = self.of_elements(&ladder) else { continue };
            let fine: Vec<Fine> = (0..ladder.len()).map(|from| self.first_of(&ladder[from..], &estimates)).collect();
            let small = |fine: &&Fine| fine.errors.iter().all(|&error| error <= SHARE * self.asked.relative);
            let settled = estimates.iter().all(|e| e.uncertainty <= SETTLED * self.asked.relative * e.limit.abs());
            let enough = |fine: &&Fine| self.rungs[fine.rung].plan.elements >= self.least;
            found.chosen = fine.iter().filter(small).filter(enough).take(CHOSEN).cloned().collect();
            found.finest = fine.into_iter().last();
            if settled && !found.chosen.is_empty() {
                return Ok(found);
            }
        }
        found.unmet = Some(why);
        Ok(found)
    }

    /// Richardson on the finest mesh and those with half and a quarter of its elements; none where the half is missing.
    fn of_elements(&self, ladder: &[(usize, usize)]) -> Option<Vec<Estimate>> {
        let (finest, top) = *ladder.last()?;
        let with = |elements: usize| ladder.iter().find(|rung| rung.0 == elements).map(|rung| rung.1);
        let half = with(finest / 2).filter(|_| finest % 2 == 0)?;
        let quarter = with(finest / 4).filter(|_| finest % 4 == 0);
        let of = |q: Quantity| {
            let value = |at: usize| q.of(self.rungs[at].run.measures());
            richardson(quarter.map(value), value(half), value(top), 2.0)
        };
        Some(self.quantities().map(of).collect())
    }

    /// What the finer meshes of a ladder say of its first one.
    fn first_of(&self, ladder: &[(usize, usize)], estimates: &[Estimate]) -> Fine {
        let error = |(quantity, estimate): (Quantity, &Estimate)| {
            let values = ladder.iter().map(|rung| quantity.of(self.rungs[rung.1].run.measures()));
            (envelope(values, estimate.limit) + estimate.uncertainty) / estimate.limit.abs()
        };
        Fine {
            rung: ladder[0].1,
            errors: self.quantities().zip(estimates).map(error).collect(),
            orders: estimates.iter().map(|estimate| estimate.order).collect(),
        }
    }
}
