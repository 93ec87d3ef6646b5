//! The same physical problem: each code on its own meshes, with its own uncertainty.

use crate::case::check::{Check, Reference};
use crate::case::cross_code::answers::worst_difference;
use crate::case::cross_code::benchmark::{Benchmark, NAMES, STATIONS, benchmarks};
use crate::case::cross_code::{Answers, PHYSICAL};
use crate::case::pin;
use crate::case::problem::Problem;
use crate::case::run::Run;
use crate::case::suite::{Finding, Series as Curve, Table, Trial};
use crate::error::Error;
use crate::formulation::{Discretisation, Formulation};
use crate::measure::order::richardson;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::frozen::Series;
use crate::oracle::cross_code::{Code, OtherCode, PhysicalAnswer};
use crate::oracle::{Quantity, Reading, ReferenceKind};

/// Meshes of each refinement series.
pub const LEVELS: usize = 3;
/// One trial per scene, holding both codes.
pub fn trials(answers: Answers) -> Vec<Trial> {
    let each = |(index, name): (usize, &str)| {
        Trial::new(PHYSICAL, format!("{name}{}", answers.suffix()), move || {
            let benchmark = benchmarks()?.swap_remove(index);
            compare(&benchmark, answers)
        })
    };
    NAMES.into_iter().enumerate().map(each).collect()
}

/// What one code found on its finest mesh, with its uncertainty.
pub struct Found {
    name: String,
    half_width: [f64; 2],
    peak: [f64; 2],
    resultant: f64,
    profile: Vec<f64>,
    freedoms: usize,
}

impl Found {
    /// From a refinement series, coarse to fine.
    pub fn of(name: &str, levels: &[PhysicalAnswer]) -> Result<Self, Error> {
        let [coarse, medium, fine] = levels else {
            let what = format!("{name} answered on {} meshes instead of {LEVELS}", levels.len());
            return Err(Error::Combination { what, remedy: crate::oracle::cross_code::frozen::REFREEZE.into() });
        };
        let with_uncertainty = |of: fn(&PhysicalAnswer) -> f64| {
            let series = richardson([of(coarse), of(medium), of(fine)]);
            [of(fine), series.uncertainty * of(fine).abs()]
        };
        Ok(Self {
            name: name.into(),
            half_width: with_uncertainty(|answer| answer.half_width),
            peak: with_uncertainty(|answer| answer.peak),
            resultant: fine.resultant,
            profile: fine.pressure.clone(),
            freedoms: fine.freedoms,
        })
    }

    fn oracle(&self, code: Code) -> OtherCode {
        let found = vec![
            (Quantity::HalfWidth, self.half_width),
            (Quantity::PeakPressure, self.peak),
            (Quantity::Resultant, [self.resultant, 0.0]),
        ];
        OtherCode { code, found }
    }
}

/// Our own series, in the same form.
fn ours(benchmark: &Benchmark) -> Result<Vec<PhysicalAnswer>, Error> {
    let level = |refinement: usize| {
        let resolution =
            Resolution { elements: benchmark.elements, refinement: refinement as u32, order: Order::Quadratic };
        let discretisation = Discretisation::of(benchmark.problem.scene.clone(), resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
        let stretch = benchmark.problem.scene.contact.stretch;
        let means = profile::means(&run.solution.edges, stretch, &benchmark.physical.stations);
        Ok(PhysicalAnswer {
            half_width: converged(run.measures.half_width),
            peak: converged(run.measures.peak.pressure),
            resultant: converged(run.transmitted),
            pressure: means.into_iter().map(converged).collect(),
            freedoms: run.freedoms,
            contact_edges: run.solution.edges.len(),
        })
    };
    (0..LEVELS).map(level).collect()
}

fn compare(benchmark: &Benchmark, answers: Answers) -> Result<Finding, Error> {
    let ours = Found::of("ours", &ours(benchmark)?)?;
    let mut finding = Finding::default();
    let (mut others, mut penalty_error) = (Vec::new(), Vec::new());
    for code in Code::ALL {
        let (series, reproduced) = answers.physical(code, benchmark.name, &benchmark.physical)?;
        finding.checks.extend(reproduced);
        let found = Found::of(code.name(), &series.penalty)?;
        finding.checks.extend(agreement(benchmark, &ours, &found, code));
        others.push(found);
        if !series.active_set.is_empty() {
            let exact = Found::of(&format!("{code}, no penalty"), &series.active_set)?;
            finding.checks.extend(agreement(benchmark, &ours, &exact, code));
            others.push(exact);
            penalty_error.push(without_penalty(benchmark, &series));
        }
    }
    finding.checks.push(one_mesh(&others));
    finding.tables.push(table(benchmark, &ours, &others));
    finding.tables.extend(penalty_error);
    finding.series = curves(benchmark, &ours, &others);
    Ok(finding)
}

/// scikit-fem and dolfinx share meshes, loads, contact rows and measures: on them they must agree to round-off.
fn one_mesh(others: &[Found]) -> Check {
    let of = |code: Code| others.iter().find(|found| found.name == code.name());
    let difference = match Code::ALL.map(of) {
        [Some(a), Some(b)] => {
            let numbers = |found: &Found| vec![vec![found.peak[0]], vec![found.half_width[0]], found.profile.clone()];
            worst_difference(&numbers(a), &numbers(b))
        }
        _ => f64::NAN,
    };
    Check::norm(
        "scikit-fem and dolfinx shall agree with one another on the same mesh",
        "peak, width and profile",
        difference,
        Reference { name: Code::Dolfinx.name().into(), kind: ReferenceKind::CrossCode, value: 0.0 },
        1e-8,
        "only stiffness, edge functions and linear solver differ",
    )
}

/// Title of the table of penalty errors.
pub const PENALTY: &str = "Penalty error";
/// Its columns.
pub const PENALTY_HEAD: [&str; 5] =
    ["case", "quantity", "by penalty, extrapolated", "without penalty, extrapolated", "penalty error"];

/// What the penalty costs, apart from the mesh: both series extrapolated to no mesh size.
fn without_penalty(benchmark: &Benchmark, series: &Series) -> Table {
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

/// The agreement demanded of peak, width, profile and resultant.
pub fn agreement(benchmark: &Benchmark, ours: &Found, theirs: &Found, code: Code) -> Vec<Check> {
    let name = &theirs.name;
    let oracle = theirs.oracle(code);
    let read = |quantity| Reference::read(&oracle, quantity);
    let [demanded, profile] = benchmark.demanded;
    let width = if benchmark.arc { "2 √(∫pθ²/∫p) [rad]" } else { "a [mm]" };
    let combined = |a: [f64; 2], b: [f64; 2]| 100.0 * a[1].hypot(b[1]) / b[0].abs();
    let because = |a, b| format!("demanded at the finest meshes; combined uncertainty {:.3} %", combined(a, b));
    vec![
        Check::relative(
            format!("Peak pressure shall agree with {name}"),
            "peak [MPa]",
            ours.peak[0],
            read(Quantity::PeakPressure),
            demanded,
            because(ours.peak, theirs.peak),
        ),
        Check::relative(
            format!("The second-moment width shall agree with {name}"),
            width,
            ours.half_width[0],
            read(Quantity::HalfWidth),
            demanded,
            because(ours.half_width, theirs.half_width),
        ),
        Check::norm(
            format!("The profile shall agree with {name}"),
            format!("L2(p) over {STATIONS} stretches"),
            l2(&ours.profile, &theirs.profile),
            Reference { name: name.clone(), kind: ReferenceKind::CrossCode, value: 0.0 },
            profile,
            "means over the same stretches; the square-root edge lies within one of them",
        ),
        Check::relative(
            format!("The resultant shall agree with {name}"),
            "resultant [N]",
            ours.resultant,
            read(Quantity::Resultant),
            1e-6,
            "equilibrium on either mesh",
        ),
    ]
}

/// `√( Σ (p − q)² / Σ q² )`; NaN where the lengths differ.
fn l2(p: &[f64], q: &[f64]) -> f64 {
    if p.len() != q.len() {
        return f64::NAN;
    }
    let error: f64 = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum();
    (error / q.iter().map(|q| q * q).sum::<f64>()).sqrt()
}

/// Peak and second-moment width of the closed form, if there is one.
fn closed_form(problem: &Problem) -> Option<[f64; 2]> {
    let oracle = problem.oracle.as_deref()?;
    let value = |quantity| match oracle.read(quantity) {
        Reading::Value { value, .. } => Some(value),
        Reading::Silent | Reading::Unavailable(_) => None,
    };
    let peak = value(Quantity::PeakPressure)?;
    let width = value(Quantity::HalfWidth)
        .or_else(|| value(Quantity::ContactAngle).map(|edge| pin::exact_second_moment(problem, edge)))?;
    Some([peak, width])
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
fn table(benchmark: &Benchmark, ours: &Found, others: &[Found]) -> Table {
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

fn curves(benchmark: &Benchmark, ours: &Found, others: &[Found]) -> Vec<Curve> {
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
