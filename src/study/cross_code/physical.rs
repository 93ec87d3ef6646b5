//! The same physical problem: each code on its own meshes, with its own uncertainty.

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::order::richardson;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::frozen::REFREEZE;
use crate::oracle::cross_code::{Code, OtherCode, PhysicalAnswer};
use crate::oracle::{Quantity, ReferenceKind};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::cross_code::answers::worst_difference;
use crate::study::cross_code::benchmark::{Benchmark, NAMES, STATIONS, benchmarks};
use crate::study::cross_code::{Answers, PHYSICAL, shown};
use crate::study::unsorted::{Finding, Trial};

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
    pub(super) name: String,
    pub(super) half_width: [f64; 2],
    pub(super) peak: [f64; 2],
    resultant: f64,
    pub(super) profile: Vec<f64>,
    pub(super) freedoms: usize,
}

impl Found {
    /// From a refinement series, coarse to fine.
    pub fn of(name: &str, levels: &[PhysicalAnswer]) -> Result<Self, Error> {
        let [coarse, medium, fine] = levels else {
            let message = format!("it answered on {} meshes instead of {LEVELS}", levels.len());
            return Err(Error::at(name, message, REFREEZE));
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
            (Quantity::SecondMoment, self.half_width),
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
        let means = profile::means(&run.solution.edges, &benchmark.physical.stations);
        Ok(PhysicalAnswer {
            half_width: converged(run.measures().half_width),
            peak: converged(run.measures().peak.pressure),
            resultant: converged(run.transmitted()),
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
            penalty_error.push(shown::without_penalty(benchmark, &series));
        }
    }
    finding.checks.push(one_mesh(&others));
    finding.tables.push(shown::table(benchmark, &ours, &others));
    finding.tables.extend(penalty_error);
    finding.series = shown::curves(benchmark, &ours, &others);
    Ok(finding)
}

/// scikit-fem and dolfinx share meshes, loads, contact rows and measures: on them they must agree to round-off.
fn one_mesh(others: &[Found]) -> Judged {
    let of = |code: Code| others.iter().find(|found| found.name == code.name());
    let difference = match Code::ALL.map(of) {
        [Some(a), Some(b)] => {
            let numbers = |found: &Found| vec![vec![found.peak[0]], vec![found.half_width[0]], found.profile.clone()];
            worst_difference(&numbers(a), &numbers(b))
        }
        _ => f64::NAN,
    };
    Judged::norm(
        "scikit-fem and dolfinx shall agree with one another on the same mesh",
        "peak, width and profile",
        difference,
        Reference { name: Code::Dolfinx.name().into(), kind: ReferenceKind::CrossCode, value: 0.0 },
        1e-8,
        "only stiffness, edge functions and linear solver differ",
    )
}

/// The agreement demanded of peak, width, profile and resultant.
pub fn agreement(benchmark: &Benchmark, ours: &Found, theirs: &Found, code: Code) -> Vec<Judged> {
    let name = &theirs.name;
    let oracle = theirs.oracle(code);
    let read = |quantity| Reference::read(&oracle, quantity);
    let [demanded, profile] = benchmark.demanded;
    let width = if benchmark.arc { "2 √(∫pθ²/∫p) [rad]" } else { "a [mm]" };
    let combined = |a: [f64; 2], b: [f64; 2]| 100.0 * a[1].hypot(b[1]) / b[0].abs();
    let because = |a, b| format!("demanded at the finest meshes; combined uncertainty {:.3} %", combined(a, b));
    vec![
        Judged::relative(
            format!("Peak pressure shall agree with {name}"),
            "peak [MPa]",
            ours.peak[0],
            read(Quantity::PeakPressure),
            demanded,
            because(ours.peak, theirs.peak),
        ),
        Judged::relative(
            format!("The second-moment width shall agree with {name}"),
            width,
            ours.half_width[0],
            read(Quantity::SecondMoment),
            demanded,
            because(ours.half_width, theirs.half_width),
        ),
        Judged::norm(
            format!("The profile shall agree with {name}"),
            format!("L2(p) over {STATIONS} stretches"),
            l2(&ours.profile, &theirs.profile),
            Reference { name: name.clone(), kind: ReferenceKind::CrossCode, value: 0.0 },
            profile,
            "means over the same stretches; the square-root edge lies within one of them",
        ),
        Judged::relative(
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
