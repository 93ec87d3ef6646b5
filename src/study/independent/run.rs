//! What every script found of a scene, beside ours: the scenes as numbers, a series of three meshes each, and what it
//! says of peak, width, resultant and profile.

use crate::algorithm::StiffnessRule;
use crate::case::library::{Cylinder, PinPlate, PinRod, TruncatedHertz};
use crate::case::{Case, Judged};
use crate::error::Error;
use crate::measure::{profile, whole};
use crate::mesh::{Order, Resolution};
use crate::named::named_enum;
use crate::oracle::cross_code::frozen::{REFREEZE, changed_versions};
use crate::oracle::cross_code::independent::{Asked, Independent, Script, file};
use crate::oracle::cross_code::live::Live;
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::Planned;
use crate::study::differences::{on_finest, peak_and_width, reproduced, suffix};

/// Springs of the scripts with a penalty, `k_n = κ E*/ℓ`.
pub const KAPPA: f64 = 1e4;

/// Meshes of each refinement series.
pub const LEVELS: usize = 3;
/// Degrees of freedom up to which the tests ask for a mesh of a series: the finest takes nine tenths of the time, and
/// freezing asks it.
pub const ASKED: usize = 20_000;
/// Stretches of equal length over which profiles are compared by their means; the stations are their middles.
pub const STATIONS: usize = 40;
/// Half-angle of the contact in the wide plate \[degrees\].
const PLATE_ANGLE: f64 = 60.0;

named_enum! {
    /// A scene that every code solves, by its name in the frozen files.
    pub enum Scene {
        /// The cylinder on its plane at a/R = 0.05.
        Cylinder = "cylinder, a/R = 0.05",
        /// The same at a/R = 0.1.
        WiderCylinder = "cylinder, a/R = 0.1",
        /// Hertz without model error.
        TruncatedHertz = "truncated Hertz",
        /// The pin in the eye of the rod.
        PinRod = "pin-rod",
        /// The pin in a wide plate.
        PinPlate = "pin in plate",
    }
}

/// A scene for all codes.
pub struct Benchmark {
    /// Which.
    pub scene: Scene,
    /// The scene for the other codes.
    pub physical: PhysicalScene,
    /// The scene for us, with its closed form if there is one.
    pub case: Case,
    /// Elements of our coarsest mesh per half-width, or per 10 mm of arc.
    pub elements: usize,
}

impl Scene {
    /// The scene in numbers.
    pub fn benchmark(self) -> Benchmark {
        match self {
            Self::Cylinder => self.cylinder(0.05),
            Self::WiderCylinder => self.cylinder(0.1),
            Self::TruncatedHertz => {
                let block = TruncatedHertz::default();
                let reach = 1.25 * block.half_width();
                let TruncatedHertz { radius, young, poisson, a_over_r, size, stretch } = block;
                let mut given = hertz_numbers(radius, young, poisson, a_over_r, stretch).to_vec();
                given.push(("size", size));
                self.of(block.case(), &given, reach, 8)
            }
            Self::PinRod => {
                let rod = PinRod::default();
                let given = [
                    ("pin_radius", rod.pin_radius),
                    ("clearance", rod.clearance),
                    ("eye_outer_radius", rod.eye_outer_radius),
                    ("shank_width", rod.shank_width),
                    ("shank_end", rod.shank_end),
                    ("thickness", rod.thickness),
                    ("pin_young", rod.pin.young),
                    ("pin_poisson", rod.pin.poisson),
                    ("rod_young", rod.rod.young),
                    ("rod_poisson", rod.rod.poisson),
                    ("force", rod.force),
                    ("stretch", rod.stretch),
                ];
                self.of(rod.case(), &given, rod.stretch, 16)
            }
            Self::PinPlate => {
                let plate = PinPlate::of_half_angle(PLATE_ANGLE);
                let given = [
                    ("pin_radius", plate.pin_radius),
                    ("clearance", plate.clearance),
                    ("rim_radius", plate.rim_radius),
                    ("thickness", plate.thickness),
                    ("young", plate.material.young),
                    ("poisson", plate.material.poisson),
                    ("force", plate.force),
                    ("stretch", plate.stretch),
                ];
                self.of(plate.case(), &given, plate.stretch, 12)
            }
        }
    }

    fn cylinder(self, a_over_r: f64) -> Benchmark {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let given = hertz_numbers(numbers.radius, numbers.young, numbers.poisson, a_over_r, numbers.stretch);
        self.of(numbers.case(), &given, 1.25 * numbers.half_width(), 8)
    }

    fn of(self, case: Case, given: &[(&str, f64)], reach: f64, elements: usize) -> Benchmark {
        let numbers = given.iter().map(|&(name, value)| (name.to_owned(), value)).collect();
        let stations = (0..STATIONS).map(|k| reach * (k as f64 + 0.5) / STATIONS as f64).collect();
        let physical = PhysicalScene { case: case.name.clone(), numbers, stations };
        Benchmark { scene: self, physical, case, elements }
    }
}

fn hertz_numbers(radius: f64, young: f64, poisson: f64, a_over_r: f64, stretch: f64) -> [(&'static str, f64); 5] {
    [("radius", radius), ("young", young), ("poisson", poisson), ("a_over_r", a_over_r), ("stretch", stretch)]
}

/// What was found on the finest of three meshes.
#[derive(Clone, Debug)]
pub struct Found {
    /// Peak pressure \[MPa\] and half-width by second moment \[mm, or rad\], each with its standard uncertainty by
    /// Richardson.
    pub measured: [[f64; 2]; 2],
    /// Force on the whole contact \[N\].
    pub resultant: f64,
    /// Means of the pressure over the stretches \[MPa\].
    pub profile: Vec<f64>,
}

impl Found {
    /// From a refinement series, coarse to fine; `by` is named where it has not three meshes.
    pub fn of(by: &str, levels: &[PhysicalAnswer]) -> Result<Self, Error> {
        let measured = |of| on_finest(levels, of);
        let (Some(peak), Some(width), [.., fine]) = (measured(|one| one.peak), measured(|one| one.half_width), levels)
        else {
            let message = format!("it answered on {} meshes instead of {LEVELS}", levels.len());
            return Err(Error::at(by, message, REFREEZE));
        };
        Ok(Self { measured: [peak, width], resultant: fine.resultant, profile: fine.pressure.clone() })
    }
}

/// Our own series, in the same form.
fn ours(benchmark: &Benchmark) -> Result<Vec<PhysicalAnswer>, Error> {
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

/// All scenes, against answers that are frozen, or of the scripts themselves.
pub fn against(live: Option<Live>) -> Vec<Planned<Compared>> {
    let planned = Scene::ALL.map(|scene| {
        let name = format!("{}{}", scene.name(), suffix(live));
        Planned::new("independent codes", name, move || compare(&scene.benchmark(), live))
    });
    planned.into()
}

/// A scene by every script that serves it.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The scene.
    pub scene: Scene,
    /// What we found.
    pub ours: Found,
    /// What the scripts found.
    pub others: Vec<Other>,
    /// What springs of their stiffness add to peak \[MPa\] and width \[mm, or rad\] on our mesh.
    pub penalty: [f64; 2],
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
pub fn compare(benchmark: &Benchmark, live: Option<Live>) -> Result<Compared, Error> {
    let others = asked(benchmark, live)?;
    let ours = Found::of("ours", &ours(benchmark)?)?;
    Ok(Compared { scene: benchmark.scene, ours, others, penalty: penalty(benchmark)? })
}

impl Benchmark {
    /// Force along the load line that a pressure of 1 MPa on each stretch carries, both halves \[N\]: `2 t Δx` on a
    /// plane, `2 t R · 2 sin(Δθ/2) cos θ` on an arc.
    pub fn carries(&self) -> Vec<f64> {
        let (scene, stations) = (&self.case.scene, &self.physical.stations);
        let (step, pair) = (stations[1] - stations[0], scene.contact());
        let scale = whole(pair) * scene.thickness * pair.path.metric();
        let along = |at: f64| if pair.path.is_straight() { step } else { 2.0 * (0.5 * step).sin() * at.cos() };
        stations.iter().map(|&at| scale * along(at)).collect()
    }

    /// Stiffness of the springs of the scripts \[MPa/mm\]: bodies enter one another by the pressure over it.
    pub fn spring(&self) -> f64 {
        KAPPA * self.case.scene.contact_modulus() / self.case.scene.reference.length
    }
}

/// What every script that serves a scene found; live, meshes up to [`ASKED`] are asked now, and finer ones are as they
/// were frozen.
pub fn asked(benchmark: &Benchmark, live: Option<Live>) -> Result<Vec<Other>, Error> {
    let (name, scene) = (benchmark.scene.name(), &benchmark.physical);
    let frozen = Independent::read()?;
    let kept =
        frozen.scenes.get(name).ok_or_else(|| Error::missing_key(&file(), name, "the frozen results", REFREEZE))?;
    if let Some((key, ours, theirs)) = other_scene(scene, &kept.scene) {
        let found = format!("{theirs} in the frozen scene, but {ours} in ours");
        return Err(Error::refused(&file(), &format!("{name}: {key}"), found, REFREEZE));
    }
    let all = kept.answers.iter().map(|(&script, kept)| {
        let Some(live) = live.filter(|_| script.is_set_up()) else {
            return Ok(Other { script, reproduced: None, found: Found::of(script.title(), kept)? });
        };
        let asked = |(level, one): (usize, &PhysicalAnswer)| {
            if one.dofs <= ASKED { (live.independent)(script, scene, level) } else { Ok(one.clone()) }
        };
        let now = kept.iter().enumerate().map(asked).collect::<Result<Vec<_>, _>>()?;
        let versions = changed_versions(&frozen.versions, &(live.versions)()?);
        let reproduced = reproduced(script.title(), &Asked::numbers(&now), &Asked::numbers(kept), &versions);
        Ok(Other { script, reproduced: Some(reproduced), found: Found::of(script.title(), &now)? })
    });
    all.collect()
}

/// The whole series of a scene, asked now of a script whose code the set-up of the tests installs.
pub fn series(live: &Live, script: Script, scene: &PhysicalScene) -> Result<Vec<PhysicalAnswer>, Error> {
    (0..LEVELS).map(|level| (live.independent)(script, scene, level)).collect()
}

/// What springs add to peak and width on our coarsest mesh.
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
    Ok([0, 1].map(|k| soft[k] - exact[k]))
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
