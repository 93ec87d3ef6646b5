//! What each error costs under the worst load: our 8-node cells, our cells fitted to the contact, codes on meshes of their own.

use crate::markdown::{self, significant};
use crate::measure::larger;
use crate::study::timings::code::Code;
use crate::study::timings::compared::{TRUNCATED, cheapest_of};
use crate::study::timings::digits::{self, Cells, Reached};
use crate::study::timings::pareto::sound;
use crate::study::timings::precision::Point;
use crate::study::timings::record::Record;

/// Errors of the columns.
const ERRORS: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];

/// The table, and what must be known to read it.
pub fn section(record: &Record) -> String {
    let reached = &record.measured.digits;
    let theirs = |code: Code| {
        let cell = |error: f64| cheapest_of(record, code, error).map(|point| (point.dofs, point.seconds));
        row(format!("{code}, {}", code.cells()), cell)
    };
    let mut rows = vec![row("ours, 8-node, edge unknown to the mesh".into(), |error| quadratic(record, error))];
    if !reached.is_empty() {
        let cell = |error: f64| digits::fitted(reached, error).map(|one| (one.dofs, one.seconds.median));
        rows.push(row("ours, high order, fitted to the edge it finds".into(), cell));
    }
    rows.extend(Code::ALL.into_iter().filter(|code| record.measured.of(*code).next().is_some()).map(theirs));
    let head = std::iter::once("cells".into()).chain(ERRORS.map(|error| format!("{error:e}"))).collect::<Vec<_>>();
    format!(
        "Degrees of freedom and milliseconds of the cheapest mesh that was timed whose errors of p₀ and a are both within, under the \
         worst load; the dofs of fitted meshes are those of the last, their milliseconds those of all on the way:\n\n{}\n",
        markdown::table(&head, &rows)
    )
}

fn row(name: String, cell: impl Fn(f64) -> Option<(usize, f64)>) -> Vec<String> {
    let told = |(dofs, seconds): (usize, f64)| format!("{dofs}, {} ms", significant(1e3 * seconds, 2));
    std::iter::once(name).chain(ERRORS.map(|error| cell(error).map_or("–".into(), told))).collect()
}

/// The cheapest 8-node mesh within an error, by any formulation.
fn quadratic(record: &Record, error: f64) -> Option<(usize, f64)> {
    let of = |one: &Reached| (one.dofs, one.seconds.median, one.worst());
    let finer = record.measured.digits.iter().filter(|one| matches!(one.cells, Cells::Quadratic(_))).map(of);
    let worst = |point: &Point| larger(point.peak_worst, point.half_width_worst);
    let points = sound(&record.points, &TRUNCATED).into_iter().filter(|point| point.cell_nodes == 8);
    let all = points.map(|point| (point.dofs, point.seconds, worst(point))).chain(finer);
    let cheapest = all.filter(|one| one.2 <= error).min_by(|a, b| a.1.total_cmp(&b.1));
    cheapest.map(|(dofs, seconds, _)| (dofs, seconds))
}
