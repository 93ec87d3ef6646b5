//! What a series of three meshes says of a scene: ours, and a script's.

use std::f64::consts::PI;

use crate::error::Error;
use crate::measure::order::richardson;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::frozen::REFREEZE;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::differences::peak_and_width;
use crate::study::independent::benchmark::{Benchmark, LEVELS, Scene};

/// What was found on the finest mesh, with its uncertainty.
#[derive(Clone, Debug)]
pub struct Found {
    /// Peak pressure \[MPa\] and half-width by second moment \[mm, or rad\].
    pub measured: [Measured; 2],
    /// Force on the whole contact \[N\].
    pub resultant: f64,
    /// Means of the pressure over the stretches \[MPa\].
    pub profile: Vec<f64>,
}

/// A number on the finest of three meshes.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// Its standard uncertainty, by Richardson.
    pub uncertainty: f64,
}

impl Measured {
    fn of(levels: [&PhysicalAnswer; LEVELS], of: fn(&PhysicalAnswer) -> f64) -> Self {
        let values = levels.map(of);
        Self { value: values[LEVELS - 1], uncertainty: richardson(values).uncertainty() }
    }

    /// The same number in another unit.
    pub fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, uncertainty: factor * self.uncertainty }
    }
}

impl Found {
    /// From a refinement series, coarse to fine; `by` is named where it has not three meshes.
    pub fn of(by: &str, levels: &[PhysicalAnswer]) -> Result<Self, Error> {
        let [coarse, medium, fine] = levels else {
            let message = format!("it answered on {} meshes instead of {LEVELS}", levels.len());
            return Err(Error::at(by, message, REFREEZE));
        };
        let measured = |of| Measured::of([coarse, medium, fine], of);
        Ok(Self {
            measured: [measured(|answer| answer.peak), measured(|answer| answer.half_width)],
            resultant: fine.resultant,
            profile: fine.pressure.clone(),
        })
    }
}

/// Our own series, in the same form.
pub fn ours(benchmark: &Benchmark) -> Result<Vec<PhysicalAnswer>, Error> {
    let level = |refinement: usize| {
        let resolution =
            Resolution { elements: benchmark.elements, refinement: refinement as u32, order: Order::Quadratic };
        let discretisation = Discretisation::of(benchmark.case.scene.clone(), resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;
        let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
        let [peak, half_width] = peak_and_width(&run);
        let means = profile::means(&run.solution.edges, &benchmark.physical.stations);
        Ok(PhysicalAnswer {
            half_width,
            peak,
            resultant: converged(run.transmitted()),
            pressure: means.into_iter().map(converged).collect(),
            dofs: run.dofs,
        })
    };
    (0..LEVELS).map(level).collect()
}

/// A number that is compared, in the order of what is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Peak pressure.
    Peak,
    /// Half-width by second moment.
    Width,
}

impl Number {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Peak, Self::Width];

    /// The number of a code, in its unit.
    pub fn of(self, scene: Scene, found: &Found) -> Measured {
        found.measured[self as usize].times(self.per_unit(scene))
    }

    /// Factor from MPa, mm or rad to its unit: angles are reported in degrees.
    pub fn per_unit(self, scene: Scene) -> f64 {
        match self {
            Self::Width if scene.is_arc() => 180.0 / PI,
            Self::Peak | Self::Width => 1.0,
        }
    }

    /// Its name.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Peak => "peak pressure",
            Self::Width => "second-moment width",
        }
    }

    /// Its unit, and its symbol where that differs from scene to scene.
    pub fn unit(self, scene: Scene) -> &'static str {
        match self {
            Self::Peak => "[MPa]",
            Self::Width if scene.is_arc() => "2 √(∫pθ²/∫p) [°]",
            Self::Width => "a [mm]",
        }
    }

    /// Its name with its unit.
    pub fn name(self, scene: Scene) -> String {
        format!("{}, {}", self.noun(), self.unit(scene))
    }
}
