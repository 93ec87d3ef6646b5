//! Our own curve of a digitised source: of the same scene, on two meshes.

use crate::case::library::{PinPlate, PinRod};
use crate::error::Error;
use crate::measure::order::bound_of_two;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::digitised::{
    Abscissa, DigitisedCurve, DigitisedScene, Ordinate, OurPoint, RodScene, SceneMaterial, SheetScene,
};
use crate::scene::{Material, Scene};
use crate::solution::{EdgeState, PointState};
use crate::solve::{Discretisation, Formulation, Run};
use crate::uncertainty::standard;

/// Elements per 10 mm of arc for a pin of 10 mm radius, on the coarse and the fine mesh; scaled with the source's pin.
const ELEMENTS: [usize; 2] = [24, 48];

/// A curve that can be asked at any abscissa.
pub enum Curve {
    /// Stresses along the arc.
    Stresses {
        /// What the abscissa is.
        abscissa: Abscissa,
        /// Radius of the arc \[mm\].
        radius: f64,
        /// Coarse and fine.
        along: [Along; 2],
    },
    /// The half-angle of the contact under a force.
    HalfAngle(SheetScene),
}

/// A stress along the arc, by rising angle.
pub struct Along {
    stretch: f64,
    points: Vec<PointState>,
}

impl Curve {
    /// Ours of a digitised one.
    pub fn of(curve: &DigitisedCurve) -> Result<Self, Error> {
        let rod = match curve.scene {
            DigitisedScene::Sheet(sheet) => return Ok(Self::HalfAngle(sheet)),
            DigitisedScene::Rod(rod) => rod,
        };
        let along = |elements| Along::of(&pin_rod(&rod), elements, curve.ordinate);
        let radius = match curve.ordinate {
            Ordinate::HoopStress => rod.pin_radius + rod.clearance,
            Ordinate::Pressure | Ordinate::HalfAngle => rod.pin_radius,
        };
        Ok(Self::Stresses { abscissa: curve.abscissa, radius, along: [along(ELEMENTS[0])?, along(ELEMENTS[1])?] })
    }

    /// Our value at an abscissa \[rad, mm or N\], with the uncertainty of its mesh.
    pub fn at(&self, at: f64) -> Result<OurPoint, Error> {
        let both = match self {
            Self::Stresses { abscissa, radius, along } => {
                let angle = match abscissa {
                    Abscissa::Distance => (at.abs() / radius).asin(),
                    Abscissa::Angle | Abscissa::Force => at.abs(),
                };
                [along[0].at(angle), along[1].at(angle)]
            }
            Self::HalfAngle(sheet) => {
                let half_angle = |elements| half_angle(sheet, at, elements);
                [half_angle(ELEMENTS[0])?, half_angle(ELEMENTS[1])?]
            }
        };
        Ok(OurPoint { value: both[1], uncertainty: standard(bound_of_two(both)) })
    }
}

impl Along {
    /// Pressures are edge means; hoop stresses are of the nodes of the hole.
    fn of(scene: &Scene, elements: usize, ordinate: Ordinate) -> Result<Self, Error> {
        let (discretisation, run) = solved(scene, elements)?;
        let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
        let point =
            |position: f64, value: f64| PointState { position, weight: 1.0, pressure: converged(value), gap: f64::NAN };
        let points = match ordinate {
            Ordinate::HoopStress => {
                let fields = discretisation.recover(&run.solution)?;
                discretisation.hoop_stresses(&fields, 0)?.into_iter().map(|[at, stress]| point(at, stress)).collect()
            }
            Ordinate::Pressure | Ordinate::HalfAngle => {
                run.solution.edges.iter().map(|edge: &EdgeState| point(edge.position(), edge.pressure)).collect()
            }
        };
        Ok(Self { stretch: discretisation.scene.contact().stretch, points })
    }

    fn at(&self, angle: f64) -> f64 {
        profile::interpolate(&self.points, self.stretch, angle)
    }
}

/// Where the contact ends under a force \[rad\], 0 under none; NaN where the run did not converge.
fn half_angle(sheet: &SheetScene, force: f64, elements: usize) -> Result<f64, Error> {
    if force <= 0.0 {
        return Ok(0.0);
    }
    let (_, run) = solved(&pin_sheet(sheet, force), elements)?;
    Ok(if run.solution.converged() { run.measures().edge() } else { f64::NAN })
}

fn solved(scene: &Scene, elements: usize) -> Result<(Discretisation, Run), Error> {
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(scene.clone(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    Ok((discretisation, run))
}

fn pin_rod(source: &RodScene) -> Scene {
    let base = PinRod::default();
    let rod = PinRod {
        pin_radius: source.pin_radius,
        clearance: source.clearance,
        eye_outer_radius: source.eye_outer_radius,
        shank_width: source.shank_width,
        shank_end: source.shank_end,
        thickness: source.thickness,
        pin: material(source.pin),
        rod: material(source.rod),
        force: source.force,
        unit: base.unit * source.pin_radius / base.pin_radius,
        ..base
    };
    rod.scene()
}

fn pin_sheet(source: &SheetScene, force: f64) -> Scene {
    let base = PinPlate::default();
    let plate = PinPlate {
        pin_radius: source.pin_radius,
        clearance: source.clearance,
        rim_radius: source.rim_radius,
        thickness: source.thickness,
        material: material(source.sheet),
        force,
        unit: base.unit * source.pin_radius / base.pin_radius,
        ..base
    };
    let mut scene = plate.scene();
    scene.bodies[0].material = material(source.pin);
    scene
}

fn material(source: SceneMaterial) -> Material {
    Material { young: source.young, poisson: source.poisson }
}
