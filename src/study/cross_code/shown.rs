//! What the page shows of the same physical problem: every code's numbers, the price of the penalty, the profiles.

use crate::case::problem::Problem;
use crate::measure::order::richardson;
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::frozen::Series;
use crate::oracle::{Quantity, Reading};
use crate::study::cross_code::PHYSICAL;
use crate::study::cross_code::benchmark::Benchmark;
use crate::study::cross_code::physical::Found;
use crate::study::unsorted::{Series as Curve, Table};

/// Title of the table of penalty errors.
pub const PENALTY: &str = "Penalty error";
/// Its columns.
pub const PENALTY_HEAD: [&str; 5] =
    ["case", "quantity", "by penalty, extrapolated", "without penalty, extrapolated", "penalty error"];

/// What the penalty costs, apart from the mesh: both series extrapolated to no mesh size.
pub(super) fn without_penalty(benchmark: &Benchmark, series: &Series) -> Table {
    let limit = |levels: &[PhysicalAnswer], of: fn(&PhysicalAnswer) -> f64| match levels {
        [coarse, medium, fine] => richardson([of(coarse), of(medium), of(fine)]).limit,
        _ => f64::NAN,
    };
    let quantities: [Measured; 2] =
        [("peak", |answer| answer.peak), ("second-moment width", |answer| answer.half_width)];
    let rows = quantities.map(|(quantity, of)| {
        let (soft, exact) = (limit(&series.penalty, of), limit(&series.active_set, of));
        let cells = [format!("{soft:.5}"), format!("{exact:.5}"), format!("{:+.4} %", 100.0 * (soft / exact - 1.0))];
        [benchmark.name.to_string(), quantity.to_string()].into_iter().chain(cells).collect()
    });
    Table { title: PENALTY.into(), head: PENALTY_HEAD.map(String::from).into(), rows: rows.into() }
}

/// A quantity of an answer, by name.
type Measured = (&'static str, fn(&PhysicalAnswer) -> f64);

/// Peak and second-moment width of the closed form, if there is one.
fn closed_form(problem: &Problem) -> Option<[f64; 2]> {
    let oracle = problem.oracle.as_deref()?;
    let value = |quantity| match oracle.read(quantity) {
        Reading::Value { value, .. } => Some(value),
        Reading::Silent | Reading::Unavailable(_) => None,
    };
    Some([value(Quantity::PeakPressure)?, value(Quantity::SecondMoment)?])
}

/// A column of the closed form, its name and unit, and how a code's value is found.
type Quoted<'a> = (usize, &'a str, f64, fn(&Found) -> [f64; 2]);

/// Columns of the benchmark table.
pub const HEAD: [&str; 7] = [
    "case",
    "quantity",
    "closed form",
    "code",
    "found ± its own uncertainty",
    "ours − theirs",
    "its difference to the closed form",
];

/// Peak and width of every code beside the closed form.
pub(super) fn table(benchmark: &Benchmark, ours: &Found, others: &[Found]) -> Table {
    let exact = closed_form(&benchmark.problem);
    let mut rows = Vec::new();
    let (unit, factor) =
        if benchmark.arc { ("2 √(∫pθ²/∫p) [°]", 180.0 / std::f64::consts::PI) } else { ("a [mm]", 1.0) };
    let quantities: [Quoted<'_>; 2] =
        [(0, "peak [MPa]", 1.0, |found| found.peak), (1, unit, factor, |found| found.half_width)];
    for (index, quantity, factor, of) in quantities {
        for found in std::iter::once(ours).chain(others) {
            let [value, uncertainty] = of(found);
            let own = std::ptr::eq(found, ours);
            rows.push(vec![
                benchmark.name.into(),
                quantity.into(),
                exact.map_or("none".into(), |exact| format!("{:.5}", factor * exact[index])),
                format!("{} ({} freedoms)", found.name, found.freedoms),
                format!("{:.5} ± {:.3} %", factor * value, 100.0 * uncertainty / value.abs()),
                if own { String::new() } else { difference(of(ours), of(found)) },
                exact.map_or(String::new(), |exact| difference(of(found), [exact[index], 0.0])),
            ]);
        }
    }
    Table { title: PHYSICAL.into(), head: HEAD.map(String::from).into(), rows }
}

/// A relative difference in per cent, and whether the uncertainties cover it.
fn difference(a: [f64; 2], b: [f64; 2]) -> String {
    let covered = (a[0] - b[0]).abs() <= a[1].hypot(b[1]);
    let word = if covered { "within" } else { "**beyond**" };
    format!("{:+.3} %, {word} the uncertainty", 100.0 * (a[0] - b[0]) / b[0].abs())
}

/// Pictures of the profiles and of their differences to the closed form; the scene's name follows.
pub const PROFILES: [&str; 2] = ["cross-code pressure, ", "cross-code difference, "];

/// Samples of the closed form in a stretch.
const SAMPLES: usize = 100;

/// Profiles of every code and of the closed form, and the differences.
pub(super) fn curves(benchmark: &Benchmark, ours: &Found, others: &[Found]) -> Vec<Curve> {
    let reference = &benchmark.problem.scene.reference;
    let scale = if benchmark.arc { 180.0 / std::f64::consts::PI } else { 1.0 / reference.length };
    let stations = &benchmark.physical.stations;
    let step = stations[1] - stations[0];
    let exact = |s: f64| {
        let within = (0..SAMPLES).map(|k| s + step * ((k as f64 + 0.5) / SAMPLES as f64 - 0.5));
        within.map(|at| benchmark.problem.reference_pressure(at)).sum::<f64>() / SAMPLES as f64
    };
    let curve = |picture: &str, label: &str, of: &dyn Fn(usize, f64) -> f64| Curve {
        picture: format!("{picture}{}", benchmark.name),
        label: label.into(),
        points: stations.iter().enumerate().map(|(k, &s)| [scale * s, of(k, s) / reference.pressure]).collect(),
        failed: Vec::new(),
    };
    let mut curves = Vec::new();
    for found in std::iter::once(ours).chain(others) {
        curves.push(curve(PROFILES[0], &found.name, &|k, _| found.profile[k]));
        if benchmark.problem.oracle.is_some() {
            curves.push(curve(PROFILES[1], &found.name, &|k, s| 100.0 * (found.profile[k] - exact(s))));
        }
    }
    if let Some(oracle) = &benchmark.problem.oracle {
        curves.push(curve(PROFILES[0], oracle.name(), &|_, s| exact(s)));
    }
    curves
}
