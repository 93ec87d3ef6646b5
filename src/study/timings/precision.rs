//! Error against seconds and work, over loads the mesh does not know: ours, and by other codes in processes of their
//! own, if they are installed: scikit-fem, dolfinx and NGSolve on truncated Hertz with their own meshes.
//!
//! The mesh is graded for the nominal half-width and the candidate stretch; eight loads then move the contact edge
//! across one of its elements, so that no mesh has the edge on a node by luck. Every point is the median and the worst
//! of them.

use std::time::Instant;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::case::library::TruncatedHertz;
use crate::checkout::root;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::named::named_enum;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::cross_code::process::{Told, run, run_by};
use crate::scene::{Grading, Scene};
use crate::solve::{Discretisation, Fitted, Formulation, Iteration, Run};
use crate::study::differences::errors;
use crate::study::seconds::Spread;

/// Tolerance of every run: a thirtieth of the smallest error that is asked for.
pub const TOLERANCE: f64 = 1e-5;
/// Elements per half-width.
const ELEMENTS: [usize; 8] = [2, 3, 4, 5, 7, 10, 14, 20];
/// Digits for which meshes are fitted.
const DIGITS: [usize; 3] = [4, 5, 6];

named_enum! {
    /// A series of meshes, coarse to fine.
    pub enum Series {
        /// Cells with 4 nodes, graded as in the library.
        Linear = "truncated-hertz, 4-node",
        /// Cells with 8 nodes, graded as in the library.
        Quadratic = "truncated-hertz, 8-node",
        /// Cells with 4 nodes that grow twice as fast.
        SteepLinear = "truncated-hertz, steep, 4-node",
        /// Cells with 8 nodes that grow twice as fast.
        SteepQuadratic = "truncated-hertz, steep, 8-node",
        /// Cells of high order, fitted to the end of the contact that they find.
        Fitted = "truncated-hertz, fitted",
        /// By exact active sets and by a penalty.
        ScikitFem = "scikit-fem",
        /// By exact active sets and by a penalty.
        Dolfinx = "dolfinx",
        /// At high order, by an augmented Lagrangian and by a penalty.
        Ngsolve = "NGSolve",
    }
}

impl Series {
    /// Ours.
    pub const OURS: [Self; 5] = [Self::Linear, Self::Quadratic, Self::SteepLinear, Self::SteepQuadratic, Self::Fitted];
    /// Codes on meshes of their own.
    pub const CODES: [Self; 3] = [Self::ScikitFem, Self::Dolfinx, Self::Ngsolve];
    /// These as a command line names them.
    pub const ASKED: &[(Self, &str, &str)] = Self::TOLD.split_at(Self::OURS.len()).1;

    /// Order of our cells whose mesh does not know where the contact ends.
    pub fn order(self) -> Option<Order> {
        match self {
            Self::Linear | Self::SteepLinear => Some(Order::Linear),
            Self::Quadratic | Self::SteepQuadratic => Some(Order::Quadratic),
            Self::Fitted | Self::ScikitFem | Self::Dolfinx | Self::Ngsolve => None,
        }
    }

    fn is_steep(self) -> bool {
        matches!(self, Self::SteepLinear | Self::SteepQuadratic)
    }

    /// Our meshes: elements per half-width, or digits for which they are fitted.
    pub fn meshes(self) -> &'static [usize] {
        match self.order() {
            Some(_) => &ELEMENTS,
            None if self == Self::Fitted => &DIGITS,
            None => &[],
        }
    }

    /// Our formulations: all nine, on steep meshes the elements with kinematic load, on fitted ones the fastest.
    pub fn formulations(self) -> Vec<Formulation> {
        if self == Self::Fitted {
            return vec![Formulation::verification()];
        }
        let nine = Formulation::nine().into_iter();
        let kept = nine.filter(|formulation| !self.is_steep() || formulation.algorithm == Iteration::Kinematic);
        kept.map(|formulation| formulation.tolerance(TOLERANCE)).collect()
    }

    /// The scene under the load of another half-width, with the outline, candidates and grading of the nominal one, and
    /// the Hertz solution.
    pub(super) fn loaded(self, half_width: f64) -> (Scene, Hertz) {
        let numbers = TruncatedHertz::default().under(half_width / nominal());
        let mut scene = numbers.scene();
        scene.grading.unit = nominal();
        if self.is_steep() {
            scene.grading = Grading { along: 2.0, depth: 1.8, coarsest: 0.5, ..scene.grading };
        }
        (scene, numbers.closed_form())
    }
}

/// Nominal half-width \[mm\].
pub fn nominal() -> f64 {
    TruncatedHertz::default().half_width()
}

/// Loads of every point.
pub const LOADS: usize = 8;
/// Elements per half-width across one of which the loads move the edge where a mesh has none of ours.
pub const ACROSS: usize = 8;

/// One point of the charts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// Whose mesh, and of which cells.
    pub series: Series,
    /// Elements per nominal half-width, digits for which it is fitted, or its place in the series of another code.
    pub mesh: usize,
    /// Name of ours: contact element and algorithm.
    pub formulation: Option<String>,
    /// Unknown displacement components; of the last mesh where several are solved on the way.
    pub dofs: usize,
    /// Operations of the sparse factorisation and, median, of the iteration; NaN where they are not counted.
    pub operations: f64,
    /// Loads of eight that converged; the errors are numbers only where all do.
    pub converged: usize,
    /// Seconds from the scene to the pressures, all meshes on the way included: median.
    pub seconds: f64,
    /// Of another code's, those in its own assembly and in its own linear solver, medians; none where they were not
    /// told apart.
    pub assembly: Option<f64>,
    /// The latter.
    pub linear: Option<f64>,
    /// Error of p₀: median and worst.
    pub peak: f64,
    /// Worst.
    pub peak_worst: f64,
    /// Error of a: median and worst.
    pub half_width: f64,
    /// Worst.
    pub half_width_worst: f64,
}

impl Point {
    /// A mesh with its errors of p₀ and a, of which nothing else is known.
    fn of(series: Series, mesh: usize, [peak, half_width]: [Spread; 2]) -> Self {
        Self {
            series,
            mesh,
            formulation: None,
            dofs: 0,
            operations: f64::NAN,
            converged: 0,
            seconds: f64::NAN,
            assembly: None,
            linear: None,
            peak: peak.median,
            peak_worst: peak.most,
            half_width: half_width.median,
            half_width_worst: half_width.most,
        }
    }

    /// The larger median error of p₀ and a.
    pub fn error(&self) -> f64 {
        larger(self.peak, self.half_width)
    }

    /// The larger worst error of p₀ and a; NaN where either is.
    pub fn worst(&self) -> f64 {
        larger(self.peak_worst, self.half_width_worst)
    }
}

/// Half-widths of the loads: from the nominal one on, across one element.
pub fn half_widths(elements: usize) -> [f64; LOADS] {
    std::array::from_fn(|k| nominal() * (1.0 + k as f64 / (LOADS * elements) as f64))
}

/// One load by one formulation: the run, its seconds, and the errors of p₀ and a.
type Loaded = (Run, f64, [f64; 2]);

/// Points of one of our meshes, one a formulation.
pub fn measure(series: Series, mesh: usize) -> Result<Vec<Point>, Error> {
    let formulations = series.formulations();
    let mut loaded: Vec<Vec<Loaded>> = formulations.iter().map(|_| Vec::new()).collect();
    let across = if series == Series::Fitted { ACROSS } else { mesh };
    for half_width in half_widths(across) {
        let runs = solved(series, mesh, half_width, &formulations)?;
        let (_, exact) = series.loaded(half_width);
        for ((run, seconds), loaded) in runs.into_iter().zip(&mut loaded) {
            let errors = errors(&run, [exact.peak_pressure(), exact.half_width()]);
            loaded.push((run, seconds, errors));
        }
    }
    let point = |(formulation, loaded): (&Formulation, Vec<Loaded>)| {
        let over = |of: &dyn Fn(&Loaded) -> f64| Spread::of(&loaded.iter().map(of).collect::<Vec<_>>());
        let errors = [0, 1].map(|k| over(&|(.., errors)| errors[k]));
        let counted = loaded[0].0.sparse_operations + over(&|(run, ..)| run.solution.work.operations).median;
        Point {
            formulation: Some(Formulation::new(formulation.element, formulation.algorithm).name()),
            dofs: loaded.iter().map(|(run, ..)| run.dofs).max().unwrap_or(0),
            operations: if series == Series::Fitted { f64::NAN } else { counted },
            converged: loaded.iter().filter(|(run, ..)| run.solution.converged()).count(),
            seconds: over(&|(_, seconds, _)| *seconds).median,
            ..Point::of(series, mesh, errors)
        }
    };
    Ok(formulations.iter().zip(loaded).map(point).collect())
}

/// One mesh under one load by some formulations, each with its seconds.
pub fn solved(
    series: Series,
    mesh: usize,
    half_width: f64,
    formulations: &[Formulation],
) -> Result<Vec<(Run, f64)>, Error> {
    let (scene, _) = series.loaded(half_width);
    let Some(order) = series.order() else {
        let fitted = |formulation| {
            let clock = Instant::now();
            let run = Fitted::of_digits(mesh).solve(&scene, formulation)?.run;
            Ok((run, clock.elapsed().as_secs_f64()))
        };
        return formulations.iter().map(fitted).collect();
    };
    let discretisation = Discretisation::of(scene, Resolution { elements: mesh, refinement: 0, order })?;
    let of = |formulation| {
        let run = Run::of(&discretisation, formulation)?;
        let seconds = run.seconds.iter().map(|(_, seconds)| seconds).sum();
        Ok((run, seconds))
    };
    formulations.iter().map(of).collect()
}

/// All our meshes of the charts.
pub fn meshes() -> Vec<(Series, usize)> {
    let of = |series: Series| series.meshes().iter().map(move |mesh| (series, *mesh));
    Series::OURS.into_iter().flat_map(of).collect()
}

/// Meshes of scikit-fem and dolfinx: cells per candidate stretch, and times cut into four.
const TRIANGLES: [[usize; 2]; 8] = [[8, 0], [12, 0], [16, 0], [17, 0], [32, 0], [17, 1], [32, 1], [64, 1]];
/// Meshes of NGSolve: order, and cells per candidate stretch.
const HIGH_ORDER: [[usize; 2]; 8] = [[3, 6], [3, 9], [4, 9], [6, 9], [4, 18], [4, 27], [6, 27], [4, 81]];
/// Factors on the growth of cells that the script of a code has.
pub const STEEP: [usize; 2] = [1, 2];

/// What the meshes of a code are, in a few words.
pub fn cells(code: Series) -> String {
    if code != Series::Ngsolve {
        return "meshes of its own".into();
    }
    let orders = || HIGH_ORDER.into_iter().map(|[order, _]| order);
    let [least, most] = [orders().min(), orders().max()].map(Option::unwrap_or_default);
    format!("orders {least} to {most}, contact edge unknown to its mesh")
}

/// Asks a code for truncated Hertz on all its meshes, under the loads of our own; the reason where it is not installed.
pub fn precision(code: Series) -> Result<Told, Error> {
    let (script, arguments) = match code {
        Series::Ngsolve => ("ngsolve_precision.py", vec![]),
        _ => ("work_precision.py", vec![code.name().into()]),
    };
    let nominal = TruncatedHertz::default();
    let request = json!({
        "scene": {
            "a_over_r": nominal.a_over_r, "poisson": nominal.poisson, "radius": nominal.radius,
            "size": nominal.size, "stretch": nominal.stretch, "young": nominal.young,
        },
        "half_widths": half_widths(ACROSS),
        "meshes": meshes_of(code),
        "repeats": 3,
    });
    let (request, newest) = (request.to_string(), root().join(NEWEST));
    match code == Series::Dolfinx && newest.is_file() {
        true => run_by(&newest, &root().join("oracles/peers").join(script), &arguments, &request),
        false => run(script, &arguments, &request),
    }
}

/// Interpreter of today's dolfinx, where `oracles/setup.sh` found a Python for it; Debian's answers where it is not
/// there.
const NEWEST: &str = "oracles/.python/newest/bin/python";

/// Meshes of another code, in each of as many gradings as ours.
pub fn meshes_of(code: Series) -> Vec<[usize; 3]> {
    let meshes = if code == Series::Ngsolve { &HIGH_ORDER } else { &TRIANGLES };
    STEEP.into_iter().flat_map(|steep| meshes.map(|[first, second]| [first, second, steep])).collect()
}

/// How many meshes of ours are tried.
pub fn ours_tried() -> String {
    let graded =
        |is_steep: bool| Series::OURS.iter().filter(|one| one.order().is_some() && one.is_steep() == is_steep).count();
    let kinds = [false, true].map(graded);
    format!(
        "{} meshes of {} kinds of cells in each of {} gradings, and {} fitted ones",
        ELEMENTS.len(),
        kinds[0],
        kinds.len(),
        DIGITS.len()
    )
}

/// What a code printed of one of its meshes.
pub fn answered(code: Series, mesh: usize, line: &Value) -> Point {
    let [peak, half_width, seconds] = ["peak_error", "half_width_error", "seconds"].map(|key| spread(line, key));
    let [assembly, linear] =
        ["stiffness", "linear"].map(|key| Some(spread(line, key).median).filter(|one| one.is_finite()));
    Point {
        dofs: line["freedoms"].as_u64().unwrap_or(0) as usize,
        converged: if peak.most.is_finite() { LOADS } else { 0 },
        seconds: seconds.median,
        assembly,
        linear,
        ..Point::of(code, mesh, [peak, half_width])
    }
}

/// Version of the code that printed a line.
pub fn version(line: &Value) -> String {
    line["version"].as_str().unwrap_or("unknown").into()
}

/// Numbers of a list in a line; NaN where one is missing.
fn spread(line: &Value, key: &str) -> Spread {
    let list = line[key].as_array().into_iter().flatten().map(|x| x.as_f64().unwrap_or(f64::NAN));
    Spread::of(&list.collect::<Vec<_>>())
}
