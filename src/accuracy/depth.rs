//! The ladder of growth: gentler and gentler away from the contact, on one and the same surface mesh.

use crate::accuracy::along::Fine;
use crate::accuracy::answer::largest;
use crate::accuracy::estimate::{envelope, levels};
use crate::accuracy::fitted::{LEVELS, Plan};
use crate::accuracy::rungs::{Attempt, Search};
use crate::accuracy::{Quantity, Quoted};
use crate::error::Error;

/// What gentler growth says of a mesh.
pub(super) enum Depth {
    /// It meets what is asked, as far as the ladders tell.
    Met(Vec<Quoted>),
    /// It does not, by this estimate; from this level of growth on its surface mesh does, as far as is known.
    From(u32, Vec<Quoted>),
    /// Nothing, for this reason.
    Stopped(String),
}

impl Search<'_> {
    /// Makes the growth gentler on one surface mesh until it is known what the growth of that mesh leaves, and if that is
    /// too much, from which level on it is not.
    pub(super) fn on_gentler_growth(&mut self, fine: &Fine) -> Result<Depth, Error> {
        let mut ladder = vec![fine.rung];
        let plan = self.rungs[fine.rung].plan;
        for level in plan.level + 1..=LEVELS + 2 {
            match self.attempt(Plan { level, ..plan }, "growth")? {
                Attempt::Solved(at) => ladder.push(at),
                Attempt::Short => {
                    return Ok(Depth::Stopped(
                        "the contact reaches the end of the candidate surface of a gentler mesh".into(),
                    ));
                }
                Attempt::Stopped(reason) => return Ok(Depth::Stopped(reason)),
            }
            if ladder.len() < 3 {
                continue;
            }
            for from in 0..ladder.len() - 1 {
                let quoted = self.quoted(fine, Some((&ladder, from)));
                let error = largest(&quoted);
                if from == 0 {
                    self.note(fine.rung, error);
                }
                if error <= self.asked.relative && from == 0 {
                    return Ok(Depth::Met(quoted));
                }
                if error <= self.asked.relative {
                    return Ok(Depth::From(plan.level + from as u32, self.quoted(fine, Some((&ladder, 0)))));
                }
            }
        }
        let quoted = self.quoted(fine, Some((&ladder, 0)));
        Ok(Depth::From(LEVELS + 1, quoted))
    }

    /// What can be said of a rung that does not meet what is asked, from two steeper growths on its surface mesh, which
    /// are cheaper; from gentler ones where there are none.
    pub(super) fn told(&mut self, fine: &Fine) -> Result<Vec<Quoted>, Error> {
        let plan = self.rungs[fine.rung].plan;
        let steepest = plan.level.saturating_sub(2);
        let mut ladder = Vec::new();
        for level in steepest..steepest + 3 {
            if level == plan.level {
                ladder.push(fine.rung);
            } else if let Attempt::Solved(at) = self.attempt(Plan { level, ..plan }, "growth")? {
                ladder.push(at);
            }
        }
        let from = (plan.level - steepest) as usize;
        Ok(self.quoted(fine, Some((ladder.as_slice(), from)).filter(|_| ladder.len() == 3)))
    }

    /// What is said of a surface mesh on one growth of a ladder of growth; without one, of its elements alone.
    pub(super) fn quoted(&self, fine: &Fine, growth: Option<(&[usize], usize)>) -> Vec<Quoted> {
        let one = |(k, quantity): (usize, Quantity)| {
            let (growth, growth_order) = growth.map_or((f64::NAN, f64::NAN), |(ladder, from)| {
                let values: Vec<f64> = ladder.iter().map(|&at| quantity.of(self.rungs[at].run.measures())).collect();
                let estimate = levels(&values);
                let distance = envelope(values[from..].iter().copied(), estimate.limit);
                ((distance + estimate.uncertainty) / estimate.limit.abs(), estimate.order)
            });
            let elements = fine.errors[k];
            let iteration = quantity.iterated(&self.rungs[fine.rung].run.contacts[0]);
            Quoted {
                contact: 0,
                quantity,
                relative: elements + growth + iteration,
                elements,
                growth,
                check: f64::NAN,
                iteration,
                order: fine.orders[k],
                growth_order,
            }
        };
        self.quantities().enumerate().map(one).collect()
    }
}
