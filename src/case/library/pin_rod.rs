//! Pin in a connecting-rod eye (the paper's example b).
use crate::case::library::shared::{ARC_UNIT, ENGINEERING, body, fixed, hole_contact, pin_reference, symmetry};
use crate::case::{Against, Case, Check, Quantity, Reference};
use crate::measure::Quantity as Number;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::high::{High, Way};
use crate::scene::{Circle, Component, Face, Grading, Load, Material, PlaneHypothesis, Scene, Sector, Shape};
use crate::solve::Formulation;
use crate::uncertainty::standard;

/// Pin and connecting rod (paper, example b); every number of the scene is here.
#[derive(Clone, Copy, Debug)]
pub struct PinRod {
    /// Radius of the pin \[mm\].
    pub pin_radius: f64,
    /// Radial clearance \[mm\].
    pub clearance: f64,
    /// Outer radius of the eye \[mm\].
    pub eye_outer_radius: f64,
    /// Width of the shank \[mm\].
    pub shank_width: f64,
    /// Height of the shank's flat end above the eye's centre \[mm\].
    pub shank_end: f64,
    /// Thickness of pin and rod \[mm\].
    pub thickness: f64,
    /// Elastic constants of the pin.
    pub pin: Material,
    /// Elastic constants of the rod.
    pub rod: Material,
    /// Force on the whole rod, upwards \[N\].
    pub force: f64,
    /// Candidates lie between the load line and this angle \[rad\].
    pub stretch: f64,
    /// Arc length that holds `N` elements \[mm\].
    pub unit: f64,
}

impl Default for PinRod {
    fn default() -> Self {
        let steel = Material::STEEL;
        Self {
            pin_radius: 10.0,
            clearance: 0.05,
            eye_outer_radius: 20.0,
            shank_width: 20.0,
            shank_end: 60.0,
            thickness: 1.0,
            pin: steel,
            rod: steel,
            force: 2000.0,
            stretch: 75f64.to_radians(),
            unit: ARC_UNIT,
        }
    }
}

impl PinRod {
    /// The scene: half by symmetry, pin fixed on its horizontal diameter, rod pulled upwards by a rigid end face.
    pub fn scene(&self) -> Scene {
        let (centre, radius, load) = ([0.0, 0.0], self.pin_radius, self.force / self.thickness);
        let disc = Shape::Disc { centre, radius, sector: Sector::Quarter, contact: Face::Bottom };
        let eye = Shape::Eye {
            pole: centre,
            hole: Circle { centre: [0.0, self.clearance], radius: radius + self.clearance },
            outer_radius: self.eye_outer_radius,
            shank_half_width: 0.5 * self.shank_width,
            shank_end: self.shank_end,
        };
        let pull = Load::RigidFace { boundary: "end".into(), component: Component::Y, force: 0.5 * self.force };
        let held = vec![symmetry("axis"), fixed("cut", Component::Y, 0.0)];
        Scene {
            name: "pin-rod".into(),
            plane: PlaneHypothesis::Stress,
            thickness: self.thickness,
            bodies: vec![
                body("pin", disc, self.pin, held, vec![]),
                body("rod", eye, self.rod, vec![symmetry("axis")], vec![pull]),
            ],
            contacts: vec![hole_contact(self.pin_radius, self.clearance, self.stretch)],
            reference: pin_reference(load, self.pin_radius, self.clearance, [self.pin, self.rod]),
            grading: Grading { unit: self.unit, along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 },
        }
    }

    /// The case; there is no closed form.
    pub fn case(&self) -> Case {
        Case { source: SOURCE.into(), ..Case::of("pin-rod", TITLE, self.scene(), 32) }
    }
}

/// What it is.
pub(super) const TITLE: &str = "pin in a connecting-rod eye, two elastic bodies (paper, example b)";
/// Its dimensions are not in the text of the paper.
const SOURCE: &str = "J. Égert 1999, second example; dimensions chosen here";

/// Name of the case of all nine.
pub const NINE: &str = "pin-rod";

/// All nine against what NGSolve finds with cells of order 8, which shares the scene alone; their profiles against the
/// verification formulation.
pub(super) fn cases() -> Vec<Case> {
    let high = High::built_in().expect("it is compiled in");
    let near = |quantity: Quantity| {
        let key = quantity.number().map(Number::key).unwrap_or_default();
        let found = high.of(NINE, &key).into_iter().find(|(way, _)| *way == Way::FiniteElements);
        let [value, bar] = found.map_or([f64::NAN; 2], |(_, found)| found);
        let (name, kind) = (Way::FiniteElements.title().into(), ReferenceKind::CrossCode);
        let reference = Reference { name, kind, value, uncertainty: Some(standard(bar)) }.times(quantity.factor());
        Check::near(quantity, reference, 1e-2, ENGINEERING)
    };
    let profile = Check::error(Quantity::EdgeMeans, Against::Verification, 1e-2, ENGINEERING);
    let checks = vec![near(Number::PeakPressure.into()), near(Quantity::on_arc(Number::SecondMomentWidth)), profile];
    vec![Case { formulations: Formulation::compared(), checks, ..PinRod::default().case() }]
}
