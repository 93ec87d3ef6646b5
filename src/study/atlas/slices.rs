//! Iterations along the slices, at the initial stiffness of each algorithm that the paper's forms start from.

use std::fmt::Write;

use crate::markdown;
use crate::solve::Element;
use crate::study::atlas::chart::Chart;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::record::Record;
use crate::study::class::Class;
use crate::study::method::Method;

/// A table for each slice.
pub fn slices(charts: &[&Chart]) -> String {
    let mut text = String::from(
        "Slices through the centre, at the surveyed initial stiffness next to each algorithm's own: iterations, and error of p₀ or a \
         against the discrete solution.\n\n",
    );
    let is_slice = |plane| [Plane::Increments, Plane::Thickness, Plane::Quadrature].contains(&plane);
    for chart in charts.iter().filter(|chart| is_slice(chart.plane)) {
        let methods = Element::ALL.into_iter().flat_map(Method::of);
        let first = methods.filter(|method| method.rule == method.algorithm.rules()[0]);
        let rows: Vec<Vec<String>> = first.filter_map(|method| row(chart, method)).collect();
        let ordinates = chart.plane.ordinates().iter().map(f64::to_string);
        let head: Vec<String> = std::iter::once(chart.plane.label().to_string()).chain(ordinates).collect();
        let _ = writeln!(text, "{}", markdown::table(&head, &rows));
    }
    text
}

/// A method along a slice; none where the slice does not hold it.
fn row(chart: &Chart, method: Method) -> Option<Vec<String>> {
    let near = |r: &&Record| (r.stiffness / method.algorithm.default_stiffness()).log10().abs() < 0.5;
    let records: Vec<&Record> = chart.of_method(method).filter_map(|row| row.iter().find(near)).collect();
    let first = format!("{method}, κ₀ = {:e}", records.first()?.stiffness);
    Some(std::iter::once(first).chain(records.into_iter().map(cell)).collect())
}

fn cell(record: &Record) -> String {
    match record.class {
        Class::Converged => format!("{} iterations, {}", record.iterations, markdown::error(record.error)),
        class => class.name().into(),
    }
}
