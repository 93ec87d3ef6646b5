//! Predicted against measured, one iteration at a time; in a folder, since its six predictions have little in common.
//!
//! * `rates` — asymptotic rates of constant and varying stiffness, a posteriori and by Hertz's closed form alone, and the scenes on which
//!   predictions are tried.
//! * `springs` — constant stiffness towards given springs, varying stiffness near and far, and rules that fail.
//!
//! Below are the page, and the halving law of kinematic load: predicted against measured iterations. Each prediction is made and measured
//! by a function, judged by `judge_…` and shown by `table_of_…`.

pub mod rates;
pub mod springs;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::halving::{self, SOFT};
use crate::study::about::{About, Found, Planned, Study};
use crate::study::method::Method;
use rates::{Before, Rate, Scene};
use springs::{Basin, Failing, Towards};

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// Rates of a method.
    Rates(Vec<Rate>),
    /// Rates of varying stiffness before anything is solved.
    Before(Vec<Before>),
    /// Constant stiffness towards fixed springs.
    Towards(Vec<Towards>),
    /// Varying stiffness with `correction`.
    Basin(Vec<Basin>),
    /// Constant stiffness with `secant` and `literal`.
    Failing(Vec<Failing>),
    /// The halving law on the meshes of a scene.
    Halving(Scene, Vec<Mesh>),
}

impl Study for Numbers {
    const NAME: &'static str = "stability";
    const ABOUT: About = About {
        title: "Predicted against measured",
        asked: "Whether rates and iterations are those that the matrices predict.",
        limits: "What is called a posteriori needs the solved contact, and is no help before it.",
    };

    /// All trials of the predictions.
    fn plan() -> Vec<Planned<Self>> {
        let mut trials = Vec::new();
        for element in Element::ALL {
            for algorithm in [Iteration::Constant, Iteration::Varying] {
                let method = Method::usual(element, algorithm);
                let run = move || rates::rates(method).map(Numbers::Rates);
                trials.push(Planned::new("predicted rate of convergence", method.to_string(), run));
            }
        }
        trials.extend([Scene::TruncatedHertz, Scene::Cylinder].map(|scene| {
            let run = move || rates::before(scene).map(Numbers::Before);
            Planned::new("rate of varying stiffness before the contact is solved", scene.name(), run)
        }));
        trials.extend(by_element("constant stiffness, fixed target springs", |e| {
            springs::towards(e).map(Numbers::Towards)
        }));
        trials.extend(by_element("varying stiffness with correction, near and far", |e| {
            springs::basin(e).map(Numbers::Basin)
        }));
        trials.extend(by_element("constant stiffness, rules that fail", |e| springs::failing(e).map(Numbers::Failing)));
        trials.extend(Scene::ALL.map(|scene| {
            let run = move || meshes(scene).map(|meshes| Numbers::Halving(scene, meshes));
            Planned::new("predicted iterations of kinematic load", scene.name(), run)
        }));
        trials
    }

    /// The predictions hold.
    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Rates(starts) => rates::judge_rates(starts),
            Numbers::Before(meshes) => vec![rates::judge_before(meshes)],
            Numbers::Towards(starts) => springs::judge_towards(starts),
            Numbers::Basin(starts) => vec![springs::judge_basin(starts)],
            Numbers::Failing(starts) => springs::judge_failing(starts),
            Numbers::Halving(scene, meshes) => judge_halving(*scene, meshes),
        })
    }

    /// A subsection for each prediction.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let (mut rates, mut before, mut basin, mut failing) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (mut towards, mut halving) = (String::new(), String::new());
        for Found { case, name, numbers, .. } in findings {
            match numbers {
                Numbers::Rates(starts) => rates.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Before(meshes) => before.extend(meshes.iter().map(|mesh| (*name, mesh))),
                Numbers::Basin(starts) => basin.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Failing(starts) => failing.extend(starts.iter().map(|start| (*name, start))),
                Numbers::Towards(starts) => {
                    let title = format!("{case}, {name}: starts κ₀ from 1e-6 to 1e6 by how they end");
                    towards += &markdown::folded(&title, &springs::table_of_towards(starts), false);
                }
                Numbers::Halving(scene, meshes) => {
                    let table = table_of_halving(*scene, meshes);
                    halving += &markdown::folded(&format!("{case}: {name}"), &table, false);
                }
            }
        }
        Ok([
            TOWARDS,
            &towards,
            RATES,
            &rates::table_of_rates(&rates),
            BEFORE,
            &rates::table_of_before(&before),
            FAILING,
            &springs::table_of_failing(&failing),
            BASIN,
            &springs::table_of_basin(&basin),
            HALVING,
            &halving,
        ]
        .concat())
    }
}

/// One trial an element.
fn by_element(case: &str, run: fn(Element) -> Result<Numbers, Error>) -> [Planned<Numbers>; 3] {
    Element::ALL.map(|element| Planned::new(case, element.name(), move || run(element)))
}

const TOWARDS: &str = "## Constant stiffness towards fixed springs\n\n\
`(S + K₀) u⁺ = f̂ + (K₀ − K*) u` converges if and only if S + K* and S + 2K₀ − K* are positive definite: in effect k₀ ≥ k*/2. \
Softer springs diverge, stiffer ones crawl. The condition is known before the run for any given springs; those tried here carry the \
contact's own pressure without a gap, cut off at the κ* given, and are thus known *a posteriori*.\n\n";

const RATES: &str = "## Rates of constant and varying stiffness\n\n\
*A posteriori*: the asymptotic rate of an iteration is the spectral radius of its error's matrix on the final active set, made of the \
flexibility of the contact and of its springs, and needs the solved contact; – where too few iterations lie between the final active set \
and round-off. Truncated Hertz, contact edge between two nodes. Constant stiffness is also followed from its start as a linear iteration \
on that set, over the same errors: where the start hardly holds the slowest mode, round-off comes before that is alone, and by the \
linear iteration's own slope no spectral radius is to be measured there. Each prediction has a check of its own.\n\n";

const BEFORE: &str = "\n## Varying stiffness: the rate before anything is solved\n\n\
*A priori*: the slowest spring to let go is the one next to the contact edge, by w/g an iteration, and Hertz's closed form says w/g at the \
first node outside. The bound of the factor plays no part in it: near the edge w/g is next to 1. Where in its element the discrete contact \
ends the closed form does not know. Nodes only: line and layer elements are slowed by an alternating mode of their points inside the \
contact, which only the solved contact tells.\n\n";

const FAILING: &str = "\n## `secant` and `literal` with constant stiffness\n\n\
`secant` wants every closed spring to reach p/g: at the contact's centre, where g → 0, that is without bound, and the start must \
have half of it. `literal` adds up changes of stiffness times approach, which is not the change of the force: what is missing \
remains in points that open.\n\n";

const BASIN: &str = "\n## Varying stiffness with `correction`\n\n\
*A posteriori.* Next to the contact it is stable while 2 (S + K*) − max(K*, K₀) is positive definite on the closed points: near the edge, where \
k* → 0, κ₀ must remain below about twice the stiffness of the bodies. From equal springs, farther away, that is no promise.\n\n";

const HALVING: &str = "\n## Kinematic load: the halving law\n\n\
Started with every candidate closed it shrinks the contact by halving L² − a²: *a priori* where the half-width is known, as on the \
cylinder and on truncated Hertz; on the pin-rod the last closed point is taken from the solved contact. From which κ₀ on a start is soft, and \
takes one iteration more, is read off truncated Hertz, and soft starts are judged on the cylinder. By that law the paper's *two iterations for any initial \
stiffness* need candidates that end at the contact edge, L = a; elsewhere each halving of the mesh costs one iteration more. It is a law \
of nodes: the Gauss points of line and layer elements have an alternating mode that it does not know.\n\n";

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
