//! Truncated Hertz by codes on meshes of their own and by ours fitted to the contact: their curves on the charts, and sentences.

use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Bars, Chart, Colour, Remark, Series};
use crate::markdown::significant;
use crate::measure::larger;
use crate::study::timings::code::Code;
use crate::study::timings::digits::{Cells, Reached};
use crate::study::timings::others::OtherPoint;
use crate::study::timings::pareto::{Measure, front, sound, within};
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::record::{Beside, Record};
use crate::study::timings::targets::{COMPARED, cheapest};

/// Families of truncated Hertz.
pub(super) const TRUNCATED: [Family; 3] = [Family::Truncated, Family::Steep, Family::Uniform];

pub(super) fn spread(ends: Vec<[(f64, f64); 2]>, colour: Colour) -> Bars {
    Bars { label: format!("upright bar: median to worst of {LOADS} loads"), ends, colour }
}

pub(super) fn remark(at: (f64, f64), text: String, right: bool, colour: Colour) -> Remark {
    Remark { at, text, right, label: format!("cheapest within {}", percent()), colour }
}

pub(super) fn percent() -> String {
    format!("{} %", 100.0 * COMPARED)
}

pub(super) fn milliseconds(seconds: f64) -> String {
    format!("{} ms", significant(1e3 * seconds, 2))
}

/// Seconds, and the median and the worst error of a quantity.
type Marked = (f64, [f64; 2]);

/// Curve and bars of some points, the cheapest first.
fn marked(chart: &mut Chart, label: String, style: Style, own: &[Marked]) {
    let points = own.iter().map(|one| ends(one)[1]).collect();
    chart.series.push(Series { label, points, style, hollow: vec![] });
    chart.bars.push(spread(own.iter().map(ends).collect(), style.colour));
}

/// Median and worst error of a point at its seconds.
fn ends((seconds, errors): &Marked) -> [(f64, f64); 2] {
    errors.map(|error| (*seconds, 100.0 * error))
}

/// Codes that ran under all loads, on meshes of their own; those that were not asked are not drawn.
pub(super) fn others(chart: &mut Chart, record: &Record, measure: Measure) {
    let looks = [
        (Code::ScikitFem, palette::PURPLE, Marker::Triangle),
        (Code::Dolfinx, palette::ORANGE, Marker::Wedge),
        (Code::Ngsolve, palette::SKY, Marker::Diamond),
    ];
    let errors = |point: &OtherPoint| match measure {
        Measure::Peak => [point.peak, point.peak_worst],
        Measure::HalfWidth => [point.half_width, point.half_width_worst],
    };
    for (code, colour, marker) in looks.into_iter().filter(|(code, ..)| record.measured.of(*code).next().is_some()) {
        let mut own: Vec<Marked> = record.measured.of(code).map(|point| (point.seconds, errors(point))).collect();
        own.sort_by(|a, b| a.0.total_cmp(&b.0));
        let style = Style::run(colour, Dash::DashDot, marker);
        marked(chart, format!("{code}, {}", code.cells()), style, &own);
        if let Some(first) = own.iter().find(|(_, errors)| errors[1] <= COMPARED) {
            chart.remarks.push(remark(ends(first)[1], milliseconds(first.0), code != Code::ScikitFem, colour));
        }
    }
}

/// Our meshes that end with the contact, which they find; not drawn where they were not timed.
pub(super) fn ours_fitted(chart: &mut Chart, record: &Record, measure: Measure) {
    let errors = |one: &Reached| match measure {
        Measure::Peak => [one.peak, one.peak_worst],
        Measure::HalfWidth => [one.half_width, one.half_width_worst],
    };
    let fitted = record.measured.digits.iter().filter(|one| matches!(one.cells, Cells::Fitted(_)));
    let own: Vec<Marked> = fitted.map(|one| (one.seconds.median, errors(one))).collect();
    if !own.is_empty() {
        let style = Style::run(palette::INK, Dash::Dashed, Marker::Square);
        marked(chart, "node element, high order, fitted to the contact it finds".into(), style, &own);
    }
}

/// The cheapest run of each code that keeps the error in both quantities under every load.
pub fn conclusion(record: &Record) -> String {
    let both = |point: &Point| larger(point.peak_worst, point.half_width_worst);
    let points = sound(&record.points, &TRUNCATED);
    let own = within(&front(&points, |point| point.seconds, &both), COMPARED, &both).map(|point| {
        let Point { formulation, cell_nodes, elements, dofs, .. } = point;
        format!(
            "ours {} ({formulation}, {cell_nodes}-node cells, {elements} per half-width, {dofs} dofs)",
            milliseconds(point.seconds)
        )
    });
    let theirs = Code::ALL.map(|code| {
        let best = cheapest_of(record, code, COMPARED);
        let told = |best: &OtherPoint| format!("{code} {} ({} dofs)", milliseconds(best.seconds), best.dofs);
        match record.measured.of(code).next() {
            Some(_) => best.map_or(format!("{code} on none of its meshes"), told),
            None => record.measured.why_not(code),
        }
    });
    let own = own.unwrap_or("ours on no mesh".into());
    format!("Within {} in p₀ and a under each of the {LOADS} loads: {own}; {}.", percent(), theirs.join("; "))
}

/// The cheapest mesh of a code that keeps the error in both quantities under every load.
pub fn cheapest_of(record: &Record, code: Code, error: f64) -> Option<&OtherPoint> {
    let enough = |point: &&OtherPoint| point.worst() <= error;
    record.measured.of(code).filter(enough).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// What must be known to read the charts.
pub(super) fn notes(record: &Record) -> Vec<String> {
    std::iter::once(conclusion(record)).chain(apart(record)).collect()
}

/// Codes that were asked in a run of their own, with what our own solve took there.
pub fn apart(record: &Record) -> Vec<String> {
    let told = |beside: &Beside| {
        let machine = beside.apart.as_ref()?;
        let own = cheapest(&record.points)?;
        Some(format!(
            "{} was asked in a run of its own ({}, {} threads, {}), where our solve to {} took {} against {} in the other: its seconds \
             compare with ours by the ratio beside it alone.",
            beside.code,
            machine.processor,
            machine.threads,
            machine.system,
            percent(),
            milliseconds(beside.seconds.median),
            milliseconds(own.seconds)
        ))
    };
    record.measured.beside.iter().filter_map(told).collect()
}
