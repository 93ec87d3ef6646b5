//! The problems of the suite by name: scene, default mesh and oracle.

use std::sync::Arc;

use crate::case::library::{
    Bars, Cylinder, CylinderModel, FlatPunch, OwnWeight, Patch, PinPlate, PinRod, PressFit, TruncatedHertz,
};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::{Plane, bars, hertz::Hertz, lame, persson::PinInHole, punch, uniform::Uniform, weight};
use crate::oracle::{Oracle, Quantity};
use crate::scene::{PlaneHypothesis, Scene, StressField};

/// An oracle that can be shared between threads.
pub type SharedOracle = Arc<dyn Oracle + Send + Sync>;

/// A scene with its default mesh and the independent truth about it, if there is any.
#[derive(Clone)]
pub struct Problem {
    /// Name on the command line.
    pub name: String,
    /// What it is, in a sentence.
    pub title: String,
    /// The scene.
    pub scene: Scene,
    /// Default mesh.
    pub resolution: Resolution,
    /// Independent truth.
    pub oracle: Option<SharedOracle>,
}

/// Names and titles of all problems.
pub const PROBLEMS: [(&str, &str); 11] = [
    ("cylinder", "elastic cylinder pressed on a rigid plane, the lower quarter (paper, example a)"),
    ("cylinder-half", "the same with the half cylinder modelled"),
    ("truncated-hertz", "block with Hertz tractions pressed by a rigid parabola: Hertz without model error"),
    ("pin-rod", "pin in a connecting-rod eye, two elastic bodies (paper, example b)"),
    ("pin-plate", "pin in a wide plate with clearance"),
    ("patch", "two blocks under uniform pressure"),
    ("bars", "two bars in line closing a gap"),
    ("own-weight", "block under its own weight on a rigid plane"),
    ("press-fit", "press fit of two rings, plane stress"),
    ("press-fit-strain", "press fit of two rings, plane strain"),
    ("flat-punch", "rigid flat punch on a large block"),
];

/// The problem of a name; `a_over_r` sets the load of the Hertz scenes.
pub fn problem(name: &str, a_over_r: Option<f64>) -> Result<Problem, Error> {
    let Some(&(name, title)) = PROBLEMS.iter().find(|(known, _)| *known == name) else {
        return Err(Error::Unknown {
            place: "solve".into(),
            kind: "case",
            name: name.into(),
            known: PROBLEMS.map(|(name, _)| name).join(", "),
        });
    };
    let loaded = ["cylinder", "cylinder-half", "truncated-hertz"].contains(&name);
    if let Some(ratio) = a_over_r {
        if !loaded {
            let remedy = "leave it out, or solve cylinder, cylinder-half or truncated-hertz";
            return Err(Error::Combination { what: format!("`{name}` has no a/R"), remedy: remedy.into() });
        }
        if !(ratio > 0.0 && ratio <= 0.5) {
            return Err(Error::value(
                name,
                "a-over-r",
                ratio,
                "it must lie between 0 and 0.5, where the candidates reach the side of the cylinder",
                "use for instance 0.05",
            ));
        }
    }
    let ratio = a_over_r.unwrap_or(0.05);
    let (scene, elements, oracle) = match name {
        "cylinder" | "cylinder-half" => {
            let model = if name == "cylinder" { CylinderModel::Quarter } else { CylinderModel::Half };
            cylinder(Cylinder { a_over_r: ratio, model, ..Default::default() })
        }
        "truncated-hertz" => truncated_hertz(TruncatedHertz { a_over_r: ratio, ..Default::default() }),
        "pin-rod" => (PinRod::default().scene(), 32, None),
        "pin-plate" => pin_plate(60.0),
        "patch" => patch(Patch::default()),
        "bars" => bars(Bars::default()),
        "own-weight" => own_weight(OwnWeight::default()),
        "press-fit" => press_fit(PressFit { plane: PlaneHypothesis::Stress, ..Default::default() }),
        "press-fit-strain" => press_fit(PressFit { plane: PlaneHypothesis::Strain, ..Default::default() }),
        _ => flat_punch(FlatPunch::default()),
    };
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    Ok(Problem { name: name.into(), title: title.into(), scene, resolution, oracle })
}

/// Scene, elements of the default mesh, oracle.
pub type Parts = (Scene, usize, Option<SharedOracle>);

/// Cylinder with Hertz's solution.
pub fn cylinder(numbers: Cylinder) -> Parts {
    let scene = numbers.scene();
    let oracle = Hertz { load: numbers.load(), radius: numbers.radius, modulus: scene.contact_modulus() };
    (scene, 12, Some(Arc::new(oracle)))
}

/// Truncated Hertz with Hertz's solution, whose interior stresses are also its load.
pub fn truncated_hertz(numbers: TruncatedHertz) -> Parts {
    let modulus = numbers.young / (1.0 - numbers.poisson * numbers.poisson);
    let hertz = Hertz { load: numbers.load(), radius: numbers.radius, modulus };
    let field = StressField(Arc::new(move |[x, depth]: [f64; 2]| hertz.stress(x, depth)));
    (numbers.scene(field), 8, Some(Arc::new(hertz)))
}

/// Pin in a wide plate whose contact half-angle is `degrees`, by Persson's load.
pub fn plate(degrees: f64) -> PinPlate {
    let numbers = PinPlate::default();
    let load = PinInHole::load_for(degrees.to_radians(), numbers.clearance, numbers.material.young);
    PinPlate { force: load * numbers.thickness, stretch: (1.5 * degrees).min(90.0).to_radians(), ..numbers }
}

/// The same with Persson's solution.
pub fn pin_plate(degrees: f64) -> Parts {
    let numbers = plate(degrees);
    let oracle = PinInHole {
        radius: numbers.pin_radius,
        clearance: numbers.clearance,
        load: numbers.force / numbers.thickness,
        modulus: numbers.material.young,
        poisson: numbers.material.poisson,
        plane: Plane::Stress,
    };
    (numbers.scene(), 24, Some(Arc::new(oracle)))
}

/// Patch test with `p = q`.
pub fn patch(numbers: Patch) -> Parts {
    let oracle = Uniform { applied: numbers.pressure, width: 2.0 * numbers.side };
    (numbers.scene(), 3, Some(Arc::new(oracle)))
}

/// Two bars with their bilinear law.
pub fn bars(numbers: Bars) -> Parts {
    let oracle = bars::Bars {
        young: numbers.young,
        section: 2.0 * numbers.width,
        moved_length: numbers.length,
        held_length: numbers.length,
        gap: numbers.gap,
        displacement: numbers.push * numbers.gap,
    };
    (numbers.scene(), 2, Some(Arc::new(oracle)))
}

/// Own weight with `p = ρ g H`.
pub fn own_weight(numbers: OwnWeight) -> Parts {
    let oracle =
        weight::OwnWeight { specific_weight: numbers.weight, height: numbers.height, width: 2.0 * numbers.width };
    (numbers.scene(), 4, Some(Arc::new(oracle)))
}

/// Press fit with Lamé's solution.
pub fn press_fit(numbers: PressFit) -> Parts {
    let [inner, outer] = numbers.materials.map(|m| lame::RingMaterial { young: m.young, poisson: m.poisson });
    let plane = match numbers.plane {
        PlaneHypothesis::Stress => Plane::Stress,
        PlaneHypothesis::Strain => Plane::Strain,
    };
    let oracle = lame::PressFit {
        bore: numbers.inner,
        interface: numbers.interface,
        outside: numbers.outer,
        interference: numbers.interference,
        inner,
        outer,
        plane,
    };
    (numbers.scene(), 32, Some(Arc::new(oracle)))
}

/// Flat punch with `p = P / π√(a² − x²)`.
pub fn flat_punch(numbers: FlatPunch) -> Parts {
    let oracle = punch::FlatPunch { load: numbers.load, half_width: numbers.half_width };
    (numbers.scene(), 24, Some(Arc::new(oracle)))
}

impl Problem {
    /// A problem from its parts.
    pub fn new(name: &str, title: &str, (scene, elements, oracle): Parts) -> Self {
        let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
        Self { name: name.into(), title: title.into(), scene, resolution, oracle }
    }

    /// The oracle's pressure at a contact coordinate; NaN where there is no oracle or it cannot say.
    pub fn reference_pressure(&self, at: f64) -> f64 {
        let Some(oracle) = &self.oracle else { return f64::NAN };
        super::Reference::read(oracle.as_ref(), Quantity::Pressure { at }).value
    }
}
