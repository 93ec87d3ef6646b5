//! Truncated Hertz and the pin–rod on nested meshes, the cylinder on fine ones.

use serde::Serialize;

use crate::case::library::{self, Cylinder, TruncatedHertz};
use crate::error::Error;
use crate::measure::order::{Richardson, observed, richardson};
use crate::measure::{profile, relative_error, whole};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::{Discretisation, Formulation, Run};

/// Elements per half-width of the coarsest of the nested meshes on truncated Hertz.
const COARSEST: usize = 4;
/// Elements per 10 mm of arc of the coarsest nested mesh of the pin–rod.
const COARSEST_PIN: usize = 8;
/// Nested meshes.
const LEVELS: u32 = 4;
/// Elements per half-width that show the model error of the cylinder.
const FINE: usize = 48;
/// Ratios a/R of the cylinder.
const A_OVER_R: [f64; 4] = [0.005, 0.05, 0.1, 0.2];

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// Errors of truncated Hertz.
    Orders(Orders),
    /// The cylinder against Hertz.
    ModelError(ModelError),
    /// The pin–rod by both orders.
    PinRod(PinRod),
}

/// Errors of truncated Hertz on nested meshes.
#[derive(Clone, Debug, Serialize)]
pub struct Orders {
    /// Order of the cells.
    pub order: Order,
    /// Coarse to fine.
    pub levels: Vec<Errors>,
}

/// Relative errors on one mesh of truncated Hertz.
#[derive(Clone, Debug, Serialize)]
pub struct Errors {
    /// Element size over the half-width.
    pub size: f64,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Of the pressure of the centre node.
    pub peak: f64,
    /// Of the half-width.
    pub half_width: f64,
    /// Of the profile in L2.
    pub l2: f64,
    /// Of the assembled load.
    pub load: f64,
}

/// The cylinder under uniform load over Hertz's line contact, by a/R.
#[derive(Clone, Debug, Serialize)]
pub struct ModelError {
    /// Elements per half-width.
    pub elements: usize,
    /// From the smallest contact to the largest.
    pub ratios: [Ratio; 4],
}

/// The cylinder over Hertz at one a/R.
#[derive(Clone, Debug, Serialize)]
pub struct Ratio {
    /// Half-width of Hertz over the radius.
    pub a_over_r: f64,
    /// Peak pressure over that of Hertz.
    pub peak: f64,
    /// Half-width over that of Hertz.
    pub half_width: f64,
    /// Degrees of freedom.
    pub dofs: usize,
}

/// The pin–rod on nested meshes.
#[derive(Clone, Debug, Serialize)]
pub struct PinRod {
    /// By 4-node cells, and by 8-node cells.
    pub series: [PinSeries; 2],
    /// Difference of their profiles on the finest mesh, relative in L2.
    pub difference: f64,
}

/// The pin–rod by cells of one order.
#[derive(Clone, Debug, Serialize)]
pub struct PinSeries {
    /// Order of the cells.
    pub order: Order,
    /// Coarse to fine.
    pub levels: [PinLevel; LEVELS as usize],
}

/// The pin–rod on one mesh.
#[derive(Clone, Debug, Serialize)]
pub struct PinLevel {
    /// Elements per 10 mm of arc.
    pub elements: usize,
    /// Degrees of freedom.
    pub dofs: usize,
    /// Peak pressure \[MPa\].
    pub peak: f64,
    /// Half-angle by second moment \[rad\].
    pub angle: f64,
}

impl Orders {
    /// Observed order of an error.
    pub fn order_of(&self, error: fn(&Errors) -> f64) -> f64 {
        let sizes: Vec<f64> = self.levels.iter().map(|level| level.size).collect();
        observed(&sizes, &self.levels.iter().map(error).collect::<Vec<_>>())
    }
}

impl PinSeries {
    /// What the three finest meshes say of the limit of a number.
    pub fn limit(&self, of: fn(&PinLevel) -> f64) -> Richardson {
        let [_, coarse, medium, fine] = &self.levels;
        richardson([of(coarse), of(medium), of(fine)])
    }
}

/// A number of a converged run; NaN, which no check passes, of any other.
fn converged(run: &Run, value: f64) -> f64 {
    if run.solution.converged() { value } else { f64::NAN }
}

/// Errors of truncated Hertz on nested meshes of an order.
pub fn orders(order: Order) -> Result<Orders, Error> {
    let numbers = TruncatedHertz::default();
    let levels = (0..LEVELS).map(|refinement| errors(&numbers, order, refinement));
    Ok(Orders { order, levels: levels.collect::<Result<_, _>>()? })
}

fn errors(numbers: &TruncatedHertz, order: Order, refinement: u32) -> Result<Errors, Error> {
    let resolution = Resolution { elements: COARSEST, refinement, order };
    let discretisation = Discretisation::of(numbers.scene(), resolution)?;
    let scene = &discretisation.scene;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let exact = Hertz { load: numbers.load(), radius: numbers.radius, modulus: scene.contact_modulus() };
    let within = 1.5 * exact.half_width();
    let load = whole(scene.contact()) * discretisation.system.bodies[0].applied_vertical().abs();
    Ok(Errors {
        size: 1.0 / (COARSEST << refinement) as f64,
        dofs: run.dofs,
        peak: converged(&run, relative_error(run.measures().largest.pressure, exact.peak_pressure())),
        half_width: converged(&run, relative_error(run.measures().half_width, exact.half_width())),
        l2: converged(&run, profile::relative_l2(&run.solution.points, |x| exact.pressure(x), within)),
        load: relative_error(load, numbers.load()),
    })
}

/// What the quarter cylinder under uniform load differs from Hertz by, on meshes fine enough to show it.
pub fn model_error() -> Result<ModelError, Error> {
    let ratio = |a_over_r| {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let scene = numbers.scene();
        let pressure = scene.reference.pressure;
        let resolution = Resolution { elements: FINE, refinement: 0, order: Order::Quadratic };
        let run = Run::of(&Discretisation::of(scene, resolution)?, &Formulation::verification())?;
        Ok(Ratio {
            a_over_r,
            peak: converged(&run, run.measures().peak.pressure / pressure),
            half_width: converged(&run, run.measures().half_width / numbers.half_width()),
            dofs: run.dofs,
        })
    };
    let [a, b, c, d]: [Result<Ratio, Error>; 4] = A_OVER_R.map(ratio);
    Ok(ModelError { elements: FINE, ratios: [a?, b?, c?, d?] })
}

/// The pin–rod by both orders; it has no closed form.
pub fn pin_rod() -> Result<PinRod, Error> {
    let (linear, quadratic) = (pin_runs(Order::Linear)?, pin_runs(Order::Quadratic)?);
    let difference = profile::relative_l2_between(&linear[3].solution.edges, &quadratic[3].solution.edges);
    Ok(PinRod { series: [series(Order::Linear, &linear), series(Order::Quadratic, &quadratic)], difference })
}

fn pin_runs(order: Order) -> Result<[Run; LEVELS as usize], Error> {
    let scene = library::PinRod::default().scene();
    let run = |refinement| {
        let resolution = Resolution { elements: COARSEST_PIN, refinement, order };
        Run::of(&Discretisation::of(scene.clone(), resolution)?, &Formulation::verification())
    };
    Ok([run(0)?, run(1)?, run(2)?, run(3)?])
}

fn series(order: Order, runs: &[Run; LEVELS as usize]) -> PinSeries {
    let level = |refinement: usize| {
        let run = &runs[refinement];
        PinLevel {
            elements: COARSEST_PIN << refinement,
            dofs: run.dofs,
            peak: converged(run, run.measures().peak.pressure),
            angle: converged(run, run.measures().half_width),
        }
    };
    PinSeries { order, levels: std::array::from_fn(level) }
}
