//! Seconds are believed only while the errors and counts recorded beside them are still the code's own.

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::study::timings::growth::{self, RECOUNTED};
use crate::study::timings::precision::{self, Family, Point};
use crate::study::timings::record::Record;
use crate::study::unsorted::{Finding, Trial};

/// Name of the trials.
pub const TIMINGS: &str = "speed against accuracy";
/// Recorded errors may differ from recomputed ones by this share: other machines round otherwise, and runs stop at 1e-5.
const DIGITS: f64 = 1e-3;

/// One trial a family and order, and one for the growth.
pub fn trials() -> Vec<Trial> {
    let orders = [Order::Linear, Order::Quadratic];
    let pairs = Family::ALL.into_iter().flat_map(|family| orders.map(|order| (family, order)));
    let mut trials: Vec<Trial> = pairs
        .map(|(family, order)| {
            let name = format!("{}, {}-node", family.name(), order.nodes_per_cell());
            Trial::new(TIMINGS, name, move || recomputed(family, order))
        })
        .collect();
    trials.push(Trial::new(TIMINGS, "growth", recounted));
    trials
}

fn recomputed(family: Family, order: Order) -> Result<Finding, Error> {
    let recorded = Record::read()?.points;
    let of_trial = |point: &&Point| point.family == family.name() && point.cell_nodes == order.nodes_per_cell();
    let planned = family.elements().count() * family.formulations().len();
    let (mut compared, mut count) = (0, 0);
    for elements in family.elements() {
        let fresh = precision::measure(family, order, elements)?;
        compared += fresh.len();
        count += moved(&recorded, &fresh);
    }
    let kept = recorded.iter().filter(of_trial).count();
    let moved = if compared == 0 || kept != planned { f64::NAN } else { count as f64 };
    Ok(Finding {
        checks: vec![Judged::at_most(
            "Errors and counts recorded with the timings shall still be the code's",
            format!("points that moved, of {compared}"),
            moved,
            Reference::own("snapshots/timings", 0.0),
            format!(
                "every mesh is computed again; errors within {DIGITS:e}, which the tolerance of the runs leaves; `timings` renews \
                 the record"
            ),
        )],
        ..Default::default()
    })
}

/// How many points are not the recorded ones, or not recorded; seconds are not compared.
pub fn moved(recorded: &[Point], fresh: &[Point]) -> usize {
    let kept = |fresh: &Point| {
        recorded.iter().find(|kept| {
            kept.family == fresh.family
                && kept.cell_nodes == fresh.cell_nodes
                && kept.elements == fresh.elements
                && kept.formulation == fresh.formulation
        })
    };
    fresh.iter().filter(|fresh| !kept(fresh).is_some_and(|kept| is_same(kept, fresh))).count()
}

fn is_same(kept: &Point, fresh: &Point) -> bool {
    let near = |a: f64, b: f64| (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + 1e-9;
    let pairs = [
        (kept.sparse_operations, fresh.sparse_operations),
        (kept.dense_operations, fresh.dense_operations),
        (kept.steps, fresh.steps),
        (kept.peak, fresh.peak),
        (kept.peak_worst, fresh.peak_worst),
        (kept.half_width, fresh.half_width),
        (kept.half_width_worst, fresh.half_width_worst),
        (kept.l2, fresh.l2),
        (kept.l2_worst, fresh.l2_worst),
    ];
    kept.freedoms == fresh.freedoms && kept.converged == fresh.converged && pairs.into_iter().all(|(a, b)| near(a, b))
}

fn recounted() -> Result<Finding, Error> {
    let measured = Record::read()?.measured;
    let (mut compared, mut moved) = (0, 0);
    for kept in measured.growth.iter().map(|one| &one.counts).filter(|counts| counts.freedoms <= RECOUNTED) {
        compared += 1;
        moved += usize::from(growth::counts(kept.elements, kept.refinement)? != *kept);
    }
    let complete = measured.growth.len() == growth::MESHES.len();
    let moved = if compared == 0 || !complete { f64::NAN } else { moved as f64 };
    Ok(Finding {
        checks: vec![Judged::at_most(
            "Freedoms, steps and operations recorded with the timings shall still be the code's",
            format!("meshes that moved, of {compared}"),
            moved,
            Reference::own("snapshots/timings", 0.0),
            "exact counts; `timings` renews the record",
        )],
        ..Default::default()
    })
}
