//! A recorded plane, and a fixed twentieth of it recomputed.

use rayon::prelude::*;
use serde::Serialize;

use crate::error::Error;
use crate::study::atlas::chart::Chart;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::point::{Ground, Site};
use crate::study::atlas::record::{self, Record};
use crate::study::atlas::row::Row;
use crate::study::atlas::survey::sites;
use crate::study::class::Class;

/// Of the meshes of the full planes every third is entered again, and on it three of twenty points; of the slices every mesh,
/// and one of twenty points.
const FULL: [usize; 2] = [3, 3];
const SLICES: [usize; 2] = [1, 1];
const OF: usize = 20;
/// A recomputed error or prediction may differ by this share: the records hold four digits.
const DIGITS: f64 = 2e-3;

/// What came out of a plane.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// As recorded.
    pub chart: Chart,
    /// Points that were recomputed.
    pub recomputed: usize,
    /// Those of them that are not as recorded.
    pub moved: usize,
}

/// The record of a plane, and what of it was recomputed.
pub fn of_plane(plane: Plane) -> Result<Numbers, Error> {
    let chart = Chart::of(plane, &record::read(plane)?);
    let [every, share] = if [Plane::Stretch, Plane::Mesh].contains(&plane) { FULL } else { SLICES };
    let entered: Vec<Vec<Vec<Row>>> = sites(&[plane]).into_iter().step_by(every).collect();
    let fresh = entered.par_iter().map(|grounds| recomputed(&chart, grounds, share)).collect::<Result<Vec<_>, _>>()?;
    let as_recorded: Vec<bool> = fresh.concat();
    let moved = as_recorded.iter().filter(|same| !**same).count();
    Ok(Numbers { recomputed: as_recorded.len(), moved, chart })
}

/// Whether each chosen point of a mesh is as recorded.
fn recomputed(chart: &Chart, grounds: &[Vec<Row>], share: usize) -> Result<Vec<bool>, Error> {
    let (site, rows, stiffnesses) = (Site::of(&grounds[0][0])?, chart.plane.rows(), chart.plane.stiffnesses());
    let mut as_recorded = Vec::new();
    for own in grounds {
        let ground = Ground::of(&site, &own[0])?;
        for (r, row) in rows.iter().enumerate().filter(|(_, row)| own.contains(row)) {
            let chosen = |(column, _): &(usize, &f64)| (7 * r + 3 * column) % OF < share;
            for (column, &stiffness) in stiffnesses.iter().enumerate().filter(chosen) {
                as_recorded.push(is_as_recorded(chart, r, column, &ground.record(row, stiffness)?));
            }
        }
    }
    Ok(as_recorded)
}

/// Whether a fresh point is the recorded one: class and predictions always, what was measured where no boundary is near.
pub fn is_as_recorded(chart: &Chart, row: usize, column: usize, fresh: &Record) -> bool {
    let kept = &chart.rows[row][column];
    let near = |a: f64, b: f64| a.is_finite() && b.is_finite() && (a - b).abs() <= DIGITS * a.abs().max(b.abs());
    let alike = |a: f64, b: f64| (a.is_nan() && b.is_nan()) || a == b || near(a, b);
    let predictions = alike(kept.predicted_rate, fresh.predicted_rate)
        && alike(kept.predicted_iterations, fresh.predicted_iterations);
    let measured = alike(kept.error, fresh.error)
        && alike(kept.penalty, fresh.penalty)
        && alike(kept.iteration_error, fresh.iteration_error)
        && alike(kept.rate, fresh.rate);
    let exact = kept.class == Class::Converged && !chart.is_near_a_boundary(row, column);
    kept.class == fresh.class && predictions && (!exact || (kept.iterations == fresh.iterations && measured))
}
