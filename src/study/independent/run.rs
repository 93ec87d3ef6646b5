//! What every script found of a scene, beside ours.

use crate::algorithm::StiffnessRule;
use crate::case::Judged;
use crate::error::Error;
use crate::measure::whole;
use crate::mesh::{Order, Resolution};
use crate::oracle::cross_code::frozen::{REFREEZE, changed_versions};
use crate::oracle::cross_code::independent::{Asked, Independent, Script, file};
use crate::oracle::cross_code::live::Live;
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::Planned;
use crate::study::answers::{Answers, reproduced};
use crate::study::differences::peak_and_width;
use crate::study::independent::benchmark::{ASKED, Benchmark, LEVELS, Scene};
use crate::study::independent::found::{Found, ours};

/// Springs of the scripts with a penalty, `k_n = κ E*/ℓ`.
pub const KAPPA: f64 = 1e4;

/// All scenes, against frozen answers.
pub fn plan() -> Vec<Planned<Compared>> {
    against(Answers::Frozen)
}

/// All scenes, against answers that are frozen, or of the scripts themselves.
pub fn against(answers: Answers) -> Vec<Planned<Compared>> {
    let planned = Scene::ALL.map(|scene| {
        let name = format!("{}{}", scene.name(), answers.suffix());
        Planned::new("independent codes", name, move || compare(&scene.benchmark(), answers))
    });
    planned.into()
}

/// A scene by every script that serves it.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The scene.
    pub scene: Scene,
    /// Middles of the stretches over which profiles are compared \[mm, or rad\].
    pub stations: Vec<f64>,
    /// Length \[mm\] and pressure \[MPa\] that the scene is measured by.
    pub reference: [f64; 2],
    /// What we found.
    pub ours: Found,
    /// What the scripts found.
    pub others: Vec<Other>,
    /// Force along the load line that a pressure of 1 MPa on each stretch carries, both halves \[N\].
    pub carries: Vec<f64>,
    /// What springs of their stiffness change of peak \[MPa\] and width \[mm, or rad\] on our mesh.
    pub penalty: [f64; 2],
    /// That stiffness \[MPa/mm\]: bodies enter one another by the pressure over it.
    pub spring: f64,
}

/// What a script found.
#[derive(Clone, Debug)]
pub struct Other {
    /// The script.
    pub script: Script,
    /// Whether it finds what was frozen; none where it was not asked.
    pub reproduced: Option<Judged>,
    /// Its numbers.
    pub found: Found,
}

/// A scene by every script.
pub fn compare(benchmark: &Benchmark, answers: Answers) -> Result<Compared, Error> {
    let (scene, reference) = (&benchmark.case.scene, &benchmark.case.scene.reference);
    let mut others = Vec::new();
    for (script, series, reproduced) in asked(benchmark, answers)? {
        others.push(Other { script, reproduced, found: Found::of(script.name(), &series)? });
    }
    Ok(Compared {
        scene: benchmark.scene,
        stations: benchmark.physical.stations.clone(),
        reference: [reference.length, reference.pressure],
        ours: Found::of("ours", &ours(benchmark)?)?,
        others,
        carries: carries(benchmark),
        penalty: penalty(benchmark)?,
        spring: KAPPA * scene.contact_modulus() / reference.length,
    })
}

/// `2 t Δx` on a plane, `2 t R · 2 sin(Δθ/2) cos θ` on an arc.
fn carries(benchmark: &Benchmark) -> Vec<f64> {
    let (scene, stations) = (&benchmark.case.scene, &benchmark.physical.stations);
    let (step, pair) = (stations[1] - stations[0], scene.contact());
    let scale = whole(pair) * scene.thickness * pair.path.metric();
    let along = |at: f64| if benchmark.scene.is_arc() { 2.0 * (0.5 * step).sin() * at.cos() } else { step };
    stations.iter().map(|&at| scale * along(at)).collect()
}

/// A script, its series, and whether that is what was frozen.
pub type Series = (Script, Vec<PhysicalAnswer>, Option<Judged>);

/// The series of every script that serves a scene; live, meshes up to [`ASKED`] are asked now, and finer ones are as they were frozen.
pub fn asked(benchmark: &Benchmark, answers: Answers) -> Result<Vec<Series>, Error> {
    let (name, scene) = (benchmark.scene.name(), &benchmark.physical);
    let frozen = Independent::read()?;
    let kept =
        frozen.scenes.get(name).ok_or_else(|| Error::missing_key(&file(), name, "the frozen results", REFREEZE))?;
    if let Some((key, ours, theirs)) = other_scene(scene, &kept.scene) {
        let found = format!("{theirs} in the frozen scene, but {ours} in ours");
        return Err(Error::refused(&file(), &format!("{name}: {key}"), found, REFREEZE));
    }
    let all = kept.series.iter().map(|(script, kept)| match answers {
        Answers::Live(live) if script.is_set_up() => {
            let asked = |(level, one): (usize, &PhysicalAnswer)| {
                if one.dofs <= ASKED { (live.independent)(*script, scene, level) } else { Ok(one.clone()) }
            };
            let now = kept.iter().enumerate().map(asked).collect::<Result<Vec<_>, _>>()?;
            let versions = changed_versions(&frozen.versions, &(live.versions)()?);
            let reproduced = reproduced(script.name(), &Asked::numbers(&now), &Asked::numbers(kept), &versions);
            Ok((*script, now, Some(reproduced)))
        }
        Answers::Live(_) | Answers::Frozen => Ok((*script, kept.clone(), None)),
    });
    all.collect()
}

/// The whole series of a scene, asked now of a script whose code the set-up of the tests installs.
pub fn series(live: &Live, script: Script, scene: &PhysicalScene) -> Result<Vec<PhysicalAnswer>, Error> {
    (0..LEVELS).map(|level| (live.independent)(script, scene, level)).collect()
}

/// What springs change of peak and width on our coarsest mesh.
fn penalty(benchmark: &Benchmark) -> Result<[f64; 2], Error> {
    let resolution = Resolution { elements: benchmark.elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(benchmark.case.scene.clone(), resolution)?;
    let springs = Formulation {
        rule: StiffnessRule::Penalty,
        stiffness: KAPPA,
        ..Formulation::new(Element::Node, Iteration::Kinematic).tolerance(1e-8)
    };
    let numbers = |formulation: &Formulation| Ok::<_, Error>(peak_and_width(&Run::of(&discretisation, formulation)?));
    let [soft, exact] = [numbers(&springs)?, numbers(&Formulation::verification())?];
    Ok([0, 1].map(|k| (soft[k] - exact[k]).abs()))
}

/// The first number in which two scenes differ; NaN where one has none.
fn other_scene(ours: &PhysicalScene, theirs: &PhysicalScene) -> Option<(String, f64, f64)> {
    let pairs = |(key, &value): (&String, &f64)| (key.clone(), value, theirs.numbers.get(key).copied());
    let mut all: Vec<(String, f64, Option<f64>)> = ours.numbers.iter().map(pairs).collect();
    let surplus = theirs.numbers.iter().filter(|(key, _)| !ours.numbers.contains_key(*key));
    all.extend(surplus.map(|(key, &value)| (key.clone(), f64::NAN, Some(value))));
    all.push(("stations".into(), ours.stations.len() as f64, Some(theirs.stations.len() as f64)));
    let stations = ours.stations.iter().zip(&theirs.stations);
    all.extend(stations.map(|(&a, &b)| ("a station".to_string(), a, Some(b))));
    all.push(("case".into(), 0.0, Some(if ours.case == theirs.case { 0.0 } else { 1.0 })));
    let told = all.into_iter().map(|(key, a, b)| (key, a, b.unwrap_or(f64::NAN)));
    // Acceptance is stated, so that a missing number is a difference.
    told.into_iter().find(|(_, a, b)| {
        let same = (a - b).abs() <= 1e-12 * b.abs();
        !same
    })
}
