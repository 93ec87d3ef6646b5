//! The same physical problem: each code on its own meshes, with its own uncertainty.

use std::fmt;

use serde::Serialize;

use crate::error::Error;
use crate::measure::order::richardson;
use crate::measure::{parabola, profile};
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::frozen::REFREEZE;
use crate::oracle::cross_code::independent::Script;
use crate::oracle::cross_code::{Code, Method, PhysicalAnswer};
use crate::oracle::{Quantity, Reading};
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::cross_code::Answers;
use crate::study::cross_code::answers::Reproduced;
use crate::study::cross_code::benchmark::{Benchmark, LEVELS, Scene};

/// A scene in every code.
#[derive(Clone, Debug, Serialize)]
pub struct Compared {
    /// The scene.
    pub scene: Scene,
    /// Middles of the stretches over which profiles are compared \[mm, or rad\].
    pub stations: Vec<f64>,
    /// Length \[mm\] and pressure \[MPa\] that the scene is measured by.
    pub reference: [f64; 2],
    /// The closed form, if there is one.
    pub closed_form: Option<ClosedForm>,
    /// What we found.
    pub ours: Found,
    /// What the others found.
    pub others: Vec<Other>,
    /// Our peak on the finest mesh as the others measure it \[MPa\].
    pub peak_as_theirs: f64,
}

/// The closed form of a scene.
#[derive(Clone, Debug, Serialize)]
pub struct ClosedForm {
    /// Its name.
    pub name: String,
    /// Peak pressure \[MPa\].
    pub peak: f64,
    /// Half-width by second moment \[mm, or rad\].
    pub half_width: f64,
    /// Means of the pressure over the stretches \[MPa\].
    pub profile: Vec<f64>,
}

/// Another code.
#[derive(Clone, Debug, Serialize)]
pub struct Other {
    /// Which.
    pub code: Code,
    /// Whether it finds what was frozen; none where it was not asked.
    pub reproduced: Option<Reproduced>,
    /// What it found, by one or two methods.
    pub found: Vec<Found>,
}

/// Who found something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Finder {
    /// We.
    Ours,
    /// Another code by one of its methods.
    Theirs(Code, Method),
    /// A script that shares nothing.
    Independent(Script),
}

/// What was found on the finest mesh, with its uncertainty.
#[derive(Clone, Debug, Serialize)]
pub struct Found {
    /// By whom.
    pub by: Finder,
    /// Half-width by second moment \[mm, or rad\].
    pub half_width: Measured,
    /// Peak pressure \[MPa\].
    pub peak: Measured,
    /// Force on the whole contact \[N\].
    pub resultant: f64,
    /// Means of the pressure over the stretches \[MPa\].
    pub profile: Vec<f64>,
    /// Degrees of freedom.
    pub dofs: usize,
}

/// A number on the finest of three meshes.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// Its standard uncertainty, by Richardson.
    pub uncertainty: f64,
    /// Extrapolated to no mesh size, where the series allows that.
    pub limit: f64,
}

impl fmt::Display for Finder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ours => f.pad("ours"),
            Self::Theirs(code, Method::Penalty) => f.pad(code.name()),
            Self::Theirs(code, Method::ActiveSet) => f.pad(&format!("{code}, no penalty")),
            Self::Independent(script) => f.pad(script.name()),
        }
    }
}

impl Measured {
    fn of(levels: [&PhysicalAnswer; LEVELS], of: fn(&PhysicalAnswer) -> f64) -> Self {
        let values = levels.map(of);
        let series = richardson(values);
        Self { value: values[LEVELS - 1], uncertainty: series.uncertainty(), limit: series.limit }
    }

    /// The same number in another unit.
    pub fn times(self, factor: f64) -> Self {
        let Self { value, uncertainty, limit } = self;
        Self { value: factor * value, uncertainty: factor * uncertainty, limit: factor * limit }
    }
}

impl Found {
    /// From a refinement series, coarse to fine.
    pub fn of(by: Finder, levels: &[PhysicalAnswer]) -> Result<Self, Error> {
        let [coarse, medium, fine] = levels else {
            let message = format!("it answered on {} meshes instead of {LEVELS}", levels.len());
            return Err(Error::at(by.to_string().as_str(), message, REFREEZE));
        };
        let measured = |of| Measured::of([coarse, medium, fine], of);
        Ok(Self {
            by,
            half_width: measured(|answer| answer.half_width),
            peak: measured(|answer| answer.peak),
            resultant: fine.resultant,
            profile: fine.pressure.clone(),
            dofs: fine.dofs,
        })
    }
}

impl Compared {
    /// What every other code found, by every method.
    pub fn theirs(&self) -> impl Iterator<Item = &Found> {
        self.others.iter().flat_map(|other| &other.found)
    }

    /// What the first code found, by every method: with shared meshes, contact and measures the codes are one oracle, and the others
    /// are held to the first on one mesh.
    pub fn counted(&self) -> impl Iterator<Item = &Found> {
        self.others.iter().take(1).flat_map(|other| &other.found)
    }

    /// Ours, then theirs.
    pub fn all(&self) -> impl Iterator<Item = &Found> {
        std::iter::once(&self.ours).chain(self.theirs())
    }
}

/// A scene in every code.
pub fn compare(benchmark: &Benchmark, answers: Answers) -> Result<Compared, Error> {
    let reference = &benchmark.case.scene.reference;
    let other = |code| other(benchmark, code, answers);
    let (ours, peak_as_theirs) = ours(benchmark)?;
    Ok(Compared {
        scene: benchmark.scene,
        stations: benchmark.physical.stations.clone(),
        reference: [reference.length, reference.pressure],
        closed_form: closed_form(benchmark),
        ours: Found::of(Finder::Ours, &ours)?,
        others: Code::ALL.into_iter().map(other).collect::<Result<_, _>>()?,
        peak_as_theirs,
    })
}

fn other(benchmark: &Benchmark, code: Code, answers: Answers) -> Result<Other, Error> {
    let (series, reproduced) = answers.physical(code, benchmark.scene.name(), &benchmark.physical)?;
    let mut found = vec![Found::of(Finder::Theirs(code, Method::Penalty), &series.penalty)?];
    if !series.active_set.is_empty() {
        found.push(Found::of(Finder::Theirs(code, Method::ActiveSet), &series.active_set)?);
    }
    Ok(Other { code, reproduced, found })
}

/// Our own series, in the same form, and the peak on the finest mesh as the others measure it.
pub fn ours(benchmark: &Benchmark) -> Result<(Vec<PhysicalAnswer>, f64), Error> {
    let mut peak_as_theirs = f64::NAN;
    let mut level = |refinement: usize| {
        let resolution =
            Resolution { elements: benchmark.elements, refinement: refinement as u32, order: Order::Quadratic };
        let discretisation = Discretisation::of(benchmark.case.scene.clone(), resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
        let means = profile::means(&run.solution.edges, &benchmark.physical.stations);
        peak_as_theirs = converged(parabola::peak(&run.solution.edges, run.measures().second_moment_width));
        Ok(PhysicalAnswer {
            half_width: converged(run.measures().second_moment_width),
            peak: converged(run.measures().peak.pressure),
            resultant: converged(run.transmitted()),
            pressure: means.into_iter().map(converged).collect(),
            dofs: run.dofs,
        })
    };
    let levels = (0..LEVELS).map(&mut level).collect::<Result<_, Error>>()?;
    Ok((levels, peak_as_theirs))
}

/// Samples of the closed form in a stretch.
const SAMPLES: usize = 100;

/// What the closed form says of a scene, if there is one.
pub fn closed_form(benchmark: &Benchmark) -> Option<ClosedForm> {
    let oracle = benchmark.case.oracle()?;
    let value = |quantity| match oracle.read(quantity) {
        Reading::Value { value, .. } => value,
        Reading::Silent | Reading::Unavailable(_) => f64::NAN,
    };
    let stations = &benchmark.physical.stations;
    let step = stations[1] - stations[0];
    let mean = |&s: &f64| {
        let within = (0..SAMPLES).map(|k| s + step * ((k as f64 + 0.5) / SAMPLES as f64 - 0.5));
        within.map(|at| benchmark.case.reference_pressure(at)).sum::<f64>() / SAMPLES as f64
    };
    Some(ClosedForm {
        name: oracle.name().into(),
        peak: value(Quantity::PeakPressure),
        half_width: value(Quantity::SecondMoment),
        profile: stations.iter().map(mean).collect(),
    })
}
