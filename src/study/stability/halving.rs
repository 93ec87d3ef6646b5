//! The halving law of kinematic load: predicted against measured iterations.

use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::scene;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::halving::{self, SOFT};

/// Candidate stretch over the half-width, elements per half-width and initial stiffnesses of the halving law: a soft one, one
/// between, a hard one.
const STRETCHES: [f64; 4] = [1.0, 1.5, 2.0, 3.0];
const ELEMENTS: [usize; 3] = [5, 8, 16];
const STARTS: [f64; 3] = [0.1, 1.0, 1e6];
/// Tenths of a decade of κ₀ among which soft springs are told from hard ones on truncated Hertz.
const TENTHS: std::ops::RangeInclusive<i32> = -15..=5;
/// Candidates of the pin-rod beyond its contact \[degrees\], and elements per 10 mm of arc, each twice the one before.
const PIN_STRETCHES: [f64; 4] = [65.0, 70.0, 75.0, 85.0];
const PIN_ELEMENTS: [usize; 2] = [12, 24];
/// Iterations within which the halving law is met.
const HALVINGS: f64 = 1.0;
/// Factor within which the softness of a start is known: a tenth of a decade.
const TENTH: f64 = 1.26;

/// A scene on which predictions are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// The cylinder.
    Cylinder,
    /// Truncated Hertz.
    TruncatedHertz,
    /// The pin-rod, whose contact is no Hertz contact.
    PinRod,
}

/// Iterations on a mesh, from a soft start, one between and a hard one.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// Candidate stretch over the half-width, on the pin-rod over the last closed point.
    pub stretch: f64,
    /// Elements per half-width, on the pin-rod per 10 mm.
    pub elements: usize,
    /// By the law.
    pub predicted: [usize; 3],
    /// As measured; none where the run did not converge.
    pub measured: [Option<usize>; 3],
    /// Least κ₀ from which on no start takes more iterations than a hard one: on truncated Hertz, with candidates beyond the contact.
    pub hard_from: Option<f64>,
}

impl Scene {
    /// All.
    pub const ALL: [Self; 3] = [Self::Cylinder, Self::TruncatedHertz, Self::PinRod];

    /// Name of its trial.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::TruncatedHertz => "truncated hertz",
            Self::PinRod => "pin-rod",
        }
    }

    /// The scene with candidates over the half-width, of the pin-rod in degrees.
    pub(super) fn stretched(self, stretch: f64) -> scene::Scene {
        match self {
            Self::Cylinder => Cylinder { stretch, ..Default::default() }.scene(),
            Self::TruncatedHertz => TruncatedHertz { stretch, ..Default::default() }.scene(),
            Self::PinRod => PinRod { stretch: stretch.to_radians(), ..Default::default() }.scene(),
        }
    }
}

/// A scene on all its meshes.
pub fn meshes(scene: Scene) -> Result<Vec<Mesh>, Error> {
    let (stretches, elements): (&[f64], &[usize]) = match scene {
        Scene::PinRod => (&PIN_STRETCHES, &PIN_ELEMENTS),
        Scene::Cylinder | Scene::TruncatedHertz => (&STRETCHES, &ELEMENTS),
    };
    let pairs = stretches.iter().flat_map(|&stretch| elements.iter().map(move |&elements| (stretch, elements)));
    pairs.map(|(stretch, elements)| mesh(scene, stretch, elements)).collect()
}

fn mesh(scene: Scene, stretch: f64, elements: usize) -> Result<Mesh, Error> {
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(scene.stretched(stretch), resolution)?;
    let given = &discretisation.scene;
    // A Hertz contact's half-width is known beforehand; the last closed point of the pin-rod is found first.
    let [end, edge, spacing] = match scene {
        Scene::PinRod => {
            let edge = Run::of(&discretisation, &Formulation::verification())?.measures().edge();
            let end = given.contact().stretch;
            [end, edge, end / (discretisation.interfaces[0].nodes.len() - 1) as f64]
        }
        Scene::Cylinder | Scene::TruncatedHertz => {
            let half_width = given.reference.length;
            [stretch * half_width, half_width, half_width / (2.0 * elements as f64)]
        }
    };
    let [soft, middle, hard] = STARTS.map(|stiffness| measured(&discretisation, stiffness));
    let is_told = scene == Scene::TruncatedHertz && stretch > 1.0;
    Ok(Mesh {
        stretch: if scene == Scene::PinRod { end / edge } else { stretch },
        elements,
        predicted: STARTS.map(|stiffness| halving::iterations(end, edge, spacing, stiffness)),
        measured: [soft?, middle?, hard.clone()?],
        hard_from: if is_told { Some(hard_from(&discretisation, hard?)?) } else { None },
    })
}

/// Where starts cease to be soft, given the iterations of a hard one.
fn hard_from(discretisation: &Discretisation, hard: Option<usize>) -> Result<f64, Error> {
    let mut from = f64::NAN;
    for tenth in TENTHS.rev() {
        let stiffness = 10f64.powf(0.1 * f64::from(tenth));
        match (measured(discretisation, stiffness)?, hard) {
            (Some(iterations), Some(hard)) if iterations <= hard => from = stiffness,
            _ => break,
        }
    }
    Ok(from)
}

/// Iterations of kinematic load on nodes; none where it does not converge.
fn measured(discretisation: &Discretisation, stiffness: f64) -> Result<Option<usize>, Error> {
    let formulation = Formulation { stiffness, ..Formulation::new(Element::Node, Iteration::Kinematic) };
    let solution = discretisation.solve(&formulation)?;
    Ok(solution.converged().then_some(solution.work.iterations))
}

/// The law on the meshes of a scene. Where starts cease to be soft is taken from truncated Hertz, so that soft starts are judged on
/// the cylinder alone; the contact of the pin-rod is no Hertz contact, and the law is asked only what a finer mesh costs.
pub fn judge_halving(scene: Scene, meshes: &[Mesh]) -> Vec<Judged> {
    match scene {
        Scene::PinRod => vec![twice_the_elements(meshes)],
        Scene::TruncatedHertz => vec![threshold(meshes), halved(meshes, "hard starts", |k| k >= SOFT)],
        Scene::Cylinder => vec![halved(meshes, "soft and hard starts", |_| true)],
    }
}

/// Where starts cease to be soft: the median over the meshes of the scene that the threshold is taken from.
fn threshold(meshes: &[Mesh]) -> Judged {
    let mut from: Vec<f64> = meshes.iter().filter_map(|mesh| mesh.hard_from).collect();
    from.sort_by(f64::total_cmp);
    let ratio = from.get(from.len() / 2).map_or(f64::NAN, |median| median / SOFT);
    Check::at_most(
        Quantity::at(
            "factor between κ₀ below which a start counts as soft and the median of where it measurably is",
            format!("{} meshes", from.len()),
        ),
        Reference::own("a tenth of a decade", TENTH),
        "the threshold of the halving law is taken from this scene; soft starts are judged on others",
    )
    .judge(larger(ratio, 1.0 / ratio))
}

/// The starts that are judged, against the law.
fn halved(meshes: &[Mesh], which: &str, is_judged: fn(f64) -> bool) -> Judged {
    let starts = meshes.iter().flat_map(|mesh| (0..STARTS.len()).map(move |start| (mesh, start)));
    let off = starts.filter(|(_, start)| is_judged(STARTS[*start])).map(|(mesh, start)| {
        let measured = mesh.measured[start].map_or(f64::NAN, |iterations| iterations as f64);
        (measured - mesh.predicted[start] as f64).abs()
    });
    let off: Vec<f64> = off.collect();
    Check::at_most(
        Quantity::at(
            "largest number of iterations of kinematic load off the halving law",
            format!("{which}, {} runs", off.len()),
        ),
        Reference::own("halving of L² − a²", HALVINGS),
        "the law counts halvings; the last one may end anywhere within a node spacing",
    )
    .judge(off.into_iter().reduce(larger).unwrap_or(f64::NAN))
}

/// How many more iterations a mesh of twice the elements costs.
fn twice_the_elements(meshes: &[Mesh]) -> Judged {
    let measured = |mesh: &Mesh| mesh.measured.map(|iterations| iterations.map_or(f64::NAN, |n| n as f64));
    let pairs = meshes.chunks_exact(PIN_ELEMENTS.len());
    let more = pairs.flat_map(|pair| (0..STARTS.len()).map(move |k| measured(&pair[1])[k] - measured(&pair[0])[k]));
    let more: Vec<f64> = more.collect();
    Check::at_most(
        Quantity::at(
            "largest number of iterations of kinematic load that twice the elements cost",
            format!("{} pairs of meshes", more.len()),
        ),
        Reference::own("halving of L² − a²", HALVINGS),
        "half the node spacing is one halving more, whatever the pressure of the contact",
    )
    .judge(more.into_iter().reduce(larger).unwrap_or(f64::NAN))
}

/// Predicted and measured iterations on every mesh of a scene.
pub(super) fn table_of_halving(scene: Scene, meshes: &[Mesh]) -> String {
    let (places, first) = match scene {
        Scene::PinRod => (Some(2), ["L / last closed point", "elements per 10 mm"]),
        Scene::Cylinder | Scene::TruncatedHertz => (None, ["L/a", "elements per a"]),
    };
    let starts = STARTS.map(|stiffness| format!("predicted / measured, κ₀ = {stiffness:e}"));
    let head: Vec<String> = first.map(String::from).into_iter().chain(starts).collect();
    let row = |mesh: &Mesh| {
        let stretch = places.map_or(mesh.stretch.to_string(), |places| format!("{:.places$}", mesh.stretch));
        let iterations = mesh.predicted.into_iter().zip(mesh.measured).map(|(predicted, measured)| {
            let measured = measured.map_or("not converged".into(), |measured| measured.to_string());
            format!("{predicted} / {measured}")
        });
        [stretch, mesh.elements.to_string()].into_iter().chain(iterations).collect()
    };
    markdown::table(&head, &meshes.iter().map(row).collect::<Vec<_>>())
}
