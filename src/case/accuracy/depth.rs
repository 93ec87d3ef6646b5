//! The ladder of growth: gentler and gentler away from the contact, on one and the same surface mesh.

use crate::case::accuracy::along::Fine;
use crate::case::accuracy::estimate::{envelope, levels};
use crate::case::accuracy::fitted::{LEVELS, Plan};
use crate::case::accuracy::rungs::{Search, Step};
use crate::case::accuracy::{Quantity, Quoted};
use crate::error::Error;

/// What gentler growth says of a mesh.
pub(super) enum Depth {
    /// It meets what is asked.
    Met(Vec<Quoted>),
    /// It does not; from this level of growth on its surface mesh does, as far as is known.
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
            match self.step(Plan { level, ..plan }, "growth")? {
                Step::Solved(at) => ladder.push(at),
                Step::Short => {
                    return Ok(Depth::Stopped("contact goes on beyond the candidates of a gentler mesh".into()));
                }
                Step::Stopped(reason) => return Ok(Depth::Stopped(reason)),
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
                if error <= self.asked.relative {
                    return Ok(if from == 0 {
                        Depth::Met(quoted)
                    } else {
                        Depth::From(plan.level + from as u32, quoted)
                    });
                }
            }
        }
        let quoted = self.quoted(fine, Some((&ladder, 0)));
        Ok(Depth::From(LEVELS + 1, quoted))
    }

    /// What is said of a surface mesh on one growth of a ladder of growth; without one, of its elements alone.
    pub(super) fn quoted(&self, fine: &Fine, growth: Option<(&[usize], usize)>) -> Vec<Quoted> {
        let one = |(k, quantity): (usize, Quantity)| {
            let (growth, growth_order) = growth.map_or((f64::NAN, f64::NAN), |(ladder, from)| {
                let values: Vec<f64> = ladder.iter().map(|&at| quantity.of(&self.rungs[at].run)).collect();
                let estimate = levels(&values);
                let distance = envelope(values[from..].iter().copied(), estimate.limit);
                ((distance + estimate.uncertainty) / estimate.limit.abs(), estimate.order)
            });
            Quoted { quantity, relative: fine.errors[k] + growth, growth, order: fine.orders[k], growth_order }
        };
        self.quantities().enumerate().map(one).collect()
    }
}

/// Largest relative error; NaN where one is.
pub(super) fn largest(quoted: &[Quoted]) -> f64 {
    quoted.iter().fold(
        0.0,
        |worst: f64, one| {
            if worst.is_nan() || one.relative.is_nan() { f64::NAN } else { worst.max(one.relative) }
        },
    )
}
