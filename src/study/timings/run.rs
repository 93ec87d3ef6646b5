//! Seconds are believed only while the errors and counts recorded beside them are still the code's own: these are computed again.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::Planned;
use crate::study::timings::growth::{self, Counts};
use crate::study::timings::precision::{self, Point};
use crate::study::timings::record::Record;
use crate::study::timings::series::Series;

/// Name of the trials.
const CASE: &str = "speed against accuracy";
/// Recorded errors may differ from recomputed ones by this share: other machines round otherwise, and runs stop at 1e-5.
const DIGITS: f64 = 1e-3;
/// Degrees of freedom up to which iterations and entries of the factor are counted again.
const RECOUNTED: usize = 200_000;

/// One trial a series of our meshes, one for the growth.
pub fn plan() -> Vec<Planned<Numbers>> {
    let precision = |series: Series| Planned::new(CASE, series.name(), move || again(series));
    Series::OURS.into_iter().map(precision).chain([Planned::new(CASE, "growth", recounted)]).collect()
}

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Error against work on a series of meshes.
    Precision(Again<Point>),
    /// Counts of the growth with the mesh.
    Growth(Again<Counts>),
}

/// What is recorded, and what of it is computed again.
#[derive(Clone, Debug)]
pub struct Again<T> {
    /// As recorded.
    pub recorded: Vec<T>,
    /// As they are now: all points, and the counts of the smaller meshes.
    pub fresh: Vec<T>,
    /// How many shall be recorded.
    pub planned: usize,
}

/// Every mesh of a series once more.
fn again(series: Series) -> Result<Numbers, Error> {
    let recorded = Record::read()?.of(series).cloned().collect();
    let planned = series.meshes().len() * series.formulations().len();
    let fresh = series.meshes().iter().map(|mesh| precision::measure(series, *mesh));
    let fresh = fresh.collect::<Result<Vec<_>, _>>()?.concat();
    Ok(Numbers::Precision(Again { recorded, fresh, planned }))
}

/// The smaller meshes of the growth once more.
fn recounted() -> Result<Numbers, Error> {
    let recorded: Vec<Counts> = Record::read()?.measured.growth.into_iter().map(|one| one.counts).collect();
    let kept = recorded.iter().filter(|counts| counts.dofs <= RECOUNTED);
    let fresh = kept.map(|kept| growth::counts(kept.elements, kept.refinement)).collect::<Result<_, _>>()?;
    Ok(Numbers::Growth(Again { recorded, fresh, planned: growth::MESHES.len() }))
}

/// The check of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![match numbers {
        Numbers::Precision(points) => as_recorded(
            "point whose errors or counts are not those recorded with its seconds",
            format!(
                "every mesh is computed again; errors within {DIGITS:e}, which the tolerance of the runs leaves; `timings` renews the record"
            ),
            points,
            is_same,
        ),
        Numbers::Growth(counts) => as_recorded(
            "mesh whose degrees of freedom, iterations or operations are not those recorded with its seconds",
            "exact counts; `timings` renews the record".into(),
            counts,
            Counts::eq,
        ),
    }])
}

/// How many are not recorded as they are now; not a number where something is missing.
fn as_recorded<T>(what: &'static str, because: String, again: &Again<T>, is_same: fn(&T, &T) -> bool) -> Judged {
    let Again { recorded, fresh, planned } = again;
    let moved = fresh.iter().filter(|fresh| !recorded.iter().any(|kept| is_same(kept, fresh))).count();
    let complete = !fresh.is_empty() && recorded.len() == *planned;
    let quantity = Quantity::at(what, format!("of {}", fresh.len()));
    let check = Check::at_most(quantity, Reference::own("snapshots/timings", 0.0), because);
    check.judge(if complete { moved as f64 } else { f64::NAN })
}

/// Whether two points are of the same mesh and formulation, with the same errors and counts; seconds are not compared.
fn is_same(kept: &Point, fresh: &Point) -> bool {
    let exact = |one: &Point| (one.series, one.mesh, one.formulation, one.dofs, one.converged);
    let numbers = |one: &Point| [one.operations, one.peak, one.peak_worst, one.half_width, one.half_width_worst];
    exact(kept) == exact(fresh) && numbers(kept).into_iter().zip(numbers(fresh)).all(|(a, b)| near(a, b))
}

fn near(a: f64, b: f64) -> bool {
    (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + 1e-9
}
