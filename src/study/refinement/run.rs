//! Truncated Hertz and the pin–rod on nested meshes, the cylinder on fine ones.

use serde::Serialize;

use crate::case::library::{self, Cylinder, TruncatedHertz};
use crate::error::Error;
use crate::measure::order::{Observed, Richardson, of_changes, pairs, richardson};
use crate::measure::{larger, profile, relative_error, whole};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::{Discretisation, Formulation, Run};

/// Elements per half-width of the coarsest of the nested meshes on truncated Hertz.
const COARSEST: usize = 4;
/// Elements per 10 mm of arc of the coarsest nested mesh of the pin–rod.
const COARSEST_PIN: usize = 8;
/// Nested meshes.
const LEVELS: u32 = 4;
/// Elements per half-width that show the model error of the cylinder: the finest of three meshes.
const FINE: [usize; 3] = [12, 24, 48];
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
    /// Relative error that no mesh removes: of the assembled load, or of the iteration if its tolerance is larger.
    pub floor: f64,
}

/// Relative errors with their signs on one mesh of truncated Hertz.
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
    /// Where the contact ends: from the nearest node outwards \[elements\].
    pub edge: f64,
}

/// The cylinder under uniform load over Hertz's line contact, by a/R.
#[derive(Clone, Debug, Serialize)]
pub struct ModelError {
    /// Elements per half-width of the finest mesh.
    pub elements: usize,
    /// From the smallest contact to the largest.
    pub ratios: [Ratio; 4],
}

/// The cylinder beside Hertz at one a/R.
#[derive(Clone, Debug, Serialize)]
pub struct Ratio {
    /// Half-width of Hertz over the radius.
    pub a_over_r: f64,
    /// Of the peak pressure.
    pub peak: Departure,
    /// Of the half-width.
    pub half_width: Departure,
    /// Degrees of freedom of the finest mesh.
    pub dofs: usize,
}

/// How far a number of the cylinder departs from that of Hertz, relative to it.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Departure {
    /// On the finest mesh.
    pub value: f64,
    /// What the mesh may still change, a bound that covers about 95 %.
    pub bound: f64,
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
    /// Where the contact ends: from the nearest node outwards \[elements\].
    pub edge: f64,
}

impl Orders {
    /// Observed orders of an error, between each two successive meshes.
    pub fn pairs(&self, error: fn(&Errors) -> f64) -> Vec<Observed> {
        let sizes: Vec<f64> = self.levels.iter().map(|level| level.size).collect();
        pairs(&sizes, &self.levels.iter().map(error).collect::<Vec<_>>(), self.floor)
    }
}

impl ModelError {
    /// Powers of a/R by which a departure falls, from the largest contact to the smallest, whose own departure is what the mesh
    /// leaves: it has no power, and nothing below five times as much has one.
    pub fn powers(&self, of: fn(&Ratio) -> Departure) -> Vec<Observed> {
        let [smallest, others @ ..] = &self.ratios;
        let floor = others.iter().map(|ratio| of(ratio).bound).fold(of(smallest).value.abs(), larger);
        let falling = || self.ratios.iter().rev();
        let sizes: Vec<f64> = falling().map(|ratio| ratio.a_over_r).collect();
        pairs(&sizes, &falling().map(|ratio| of(ratio).value).collect::<Vec<_>>(), floor)
    }
}

impl PinSeries {
    /// Observed orders of a number, between each two successive changes.
    pub fn pairs(&self, of: fn(&PinLevel) -> f64) -> Vec<Observed> {
        of_changes(&self.levels.each_ref().map(of))
    }

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

impl Departure {
    /// From three meshes, coarse to fine.
    fn of(series: [f64; 3]) -> Self {
        Self { value: series[2], bound: richardson(series).bound }
    }
}

/// Where the contact ends: from the nearest node outwards \[elements\].
fn within_element(run: &Run) -> f64 {
    let end = run.measures().edge();
    let nodes = run.solution.edges.iter().flat_map(|edge| edge.ends.map(|node| (end - node) / edge.length()));
    nodes.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(f64::NAN)
}

/// Errors of truncated Hertz on nested meshes of an order.
pub fn orders(order: Order) -> Result<Orders, Error> {
    let numbers = TruncatedHertz::default();
    let levels = (0..LEVELS).map(|refinement| errors(&numbers, order, refinement));
    let levels: Vec<Errors> = levels.collect::<Result<_, _>>()?;
    let floor = levels.iter().map(|level| level.load).fold(Formulation::verification().settings.tolerance, larger);
    Ok(Orders { order, levels, floor })
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
        peak: converged(&run, run.measures().largest.pressure / exact.peak_pressure() - 1.0),
        half_width: converged(&run, run.measures().second_moment_width / exact.half_width() - 1.0),
        l2: converged(&run, profile::relative_l2(&run.solution.points, |x| exact.pressure(x), within)),
        load: relative_error(load, numbers.load()),
        edge: converged(&run, within_element(&run)),
    })
}

/// What the quarter cylinder under uniform load differs from Hertz by, on meshes fine enough to show it.
pub fn model_error() -> Result<ModelError, Error> {
    let ratio = |a_over_r| {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let run = |elements| {
            let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
            Run::of(&Discretisation::of(numbers.scene(), resolution)?, &Formulation::verification())
        };
        let [coarse, medium, fine] = FINE.map(run);
        let runs = [coarse?, medium?, fine?];
        let departure =
            |exact: f64, of: fn(&Run) -> f64| Departure::of(runs.each_ref().map(|run| of(run) / exact - 1.0));
        Ok(Ratio {
            a_over_r,
            peak: departure(numbers.scene().reference.pressure, |run| converged(run, run.measures().peak.pressure)),
            half_width: departure(numbers.half_width(), |run| converged(run, run.measures().second_moment_width)),
            dofs: runs[2].dofs,
        })
    };
    let [a, b, c, d]: [Result<Ratio, Error>; 4] = A_OVER_R.map(ratio);
    Ok(ModelError { elements: FINE[2], ratios: [a?, b?, c?, d?] })
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
            angle: converged(run, run.measures().second_moment_width),
            edge: converged(run, within_element(run)),
        }
    };
    PinSeries { order, levels: std::array::from_fn(level) }
}
