//! The pin–rod by dimensionless clearance, eye radius and shank width.

use serde::Serialize;

use crate::case::library::PinRod;
use crate::error::{Error, Kind};
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::persson::PinInHole;
use crate::scene::Material;
use crate::solve::{Discretisation, Formulation, Run};

/// Values of `E t c / F`.
const CLEARANCES: [f64; 8] = [0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// Values of outer radius of the eye over pin radius.
const EYES: [f64; 3] = [1.6, 2.0, 2.5];
/// Values of shank width over pin diameter.
const SHANKS: [f64; 3] = [0.8, 1.0, 1.4];
/// Relative step of the sensitivities.
const STEP: f64 = 0.05;
/// Elements per 10 mm of arc of a pin of 10 mm radius.
const ELEMENTS: usize = 16;
/// Part of the candidate stretch from which on a contact reaches its end.
const REACHES: f64 = 0.97;
/// The default scene.
const DEFAULT: Place = Place { clearance: 5.0, eye: 2.0, shank: 1.0 };

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// Pressure and angle over the clearance.
    Curves(Curves),
    /// Slopes at the default scene.
    Sensitivities(Sensitivities),
}

/// The three dimensionless numbers a scene is placed by.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Place {
    /// `E t c / F`.
    pub clearance: f64,
    /// Outer radius of the eye over pin radius.
    pub eye: f64,
    /// Shank width over pin diameter.
    pub shank: f64,
}

/// What a scene of the family has.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Placed {
    /// `R t p_max / F`.
    pub pressure: f64,
    /// Contact half-angle by second moment \[rad\].
    pub angle: f64,
}

/// How a run of the family ended.
#[derive(Clone, Copy, Debug, Serialize)]
pub enum Ended {
    /// It converged.
    Converged(Placed),
    /// The contact reaches beyond the quarter of the pin that is modelled.
    Beyond,
    /// It did not converge.
    NotConverged,
}

impl Ended {
    /// What was found; NaN where nothing was.
    pub fn placed(self) -> Placed {
        match self {
            Self::Converged(placed) => placed,
            Self::Beyond | Self::NotConverged => Placed { pressure: f64::NAN, angle: f64::NAN },
        }
    }
}

/// Curves over the clearance.
#[derive(Clone, Debug, Serialize)]
pub struct Curves {
    /// Values of `E t c / F`.
    pub clearances: Vec<f64>,
    /// By the radius of the eye.
    pub eyes: Vec<Line>,
    /// By the width of the shank.
    pub shanks: Vec<Line>,
    /// The default scene, and another pin of the same three numbers.
    pub same_place: [Placed; 2],
    /// Half-angle in a wide plate at the largest clearance (Persson) \[rad\].
    pub wide_plate: f64,
}

/// One curve.
#[derive(Clone, Debug, Serialize)]
pub struct Line {
    /// Radius of the eye over that of the pin, or width of the shank over the diameter of the pin.
    pub value: f64,
    /// By clearance.
    pub ended: Vec<Ended>,
}

/// Slopes at the default scene.
#[derive(Clone, Debug, Serialize)]
pub struct Sensitivities {
    /// Where they are taken.
    pub at: Place,
    /// By clearance, eye and shank.
    pub slopes: [Slope; 3],
}

/// `∂ ln result / ∂ ln number`, by central differences.
#[derive(Clone, Debug, Serialize)]
pub struct Slope {
    /// The number.
    pub number: &'static str,
    /// Of the pressure, and of the angle.
    pub slope: [f64; 2],
    /// The same by half the step.
    pub by_half: [f64; 2],
}

/// A pin–rod of the proportions of another at a place of the family.
fn at(base: &PinRod, place: Place) -> PinRod {
    PinRod {
        clearance: place.clearance * base.force / (base.pin.young * base.thickness),
        eye_outer_radius: place.eye * base.pin_radius,
        shank_width: place.shank * 2.0 * base.pin_radius,
        stretch: 89f64.to_radians(),
        ..*base
    }
}

fn solve(rod: &PinRod) -> Result<Ended, Error> {
    let resolution = Resolution { elements: ELEMENTS, refinement: 0, order: Order::Quadratic };
    let run = match Run::of(&Discretisation::of(rod.scene(), resolution)?, &Formulation::verification()) {
        Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => return Ok(Ended::Beyond),
        other => other?,
    };
    if !run.solution.converged() {
        return Ok(Ended::NotConverged);
    }
    let pressure = run.measures().peak.pressure * rod.pin_radius * rod.thickness / rod.force;
    let placed = Placed { pressure, angle: run.measures().second_moment_width };
    Ok(if run.measures().edge() > REACHES * rod.stretch { Ended::Beyond } else { Ended::Converged(placed) })
}

/// Curves over the clearance, and what they are judged by.
pub fn curves() -> Result<Curves, Error> {
    let base = PinRod::default();
    let line = |value: f64, place: Place| -> Result<Line, Error> {
        let ended = CLEARANCES.into_iter().map(|clearance| solve(&at(&base, Place { clearance, ..place })));
        Ok(Line { value, ended: ended.collect::<Result<_, _>>()? })
    };
    let eyes = EYES.into_iter().map(|eye| line(eye, Place { eye, ..DEFAULT }));
    let shanks = SHANKS.into_iter().map(|shank| line(shank, Place { shank, ..DEFAULT }));
    let same_place = [solve(&at(&base, DEFAULT))?.placed(), solve(&at(&other(), DEFAULT))?.placed()];
    Ok(Curves {
        clearances: CLEARANCES.into(),
        eyes: eyes.collect::<Result<_, _>>()?,
        shanks: shanks.collect::<Result<_, _>>()?,
        same_place,
        wide_plate: in_wide_plate(&at(&base, Place { clearance: CLEARANCES[7], ..DEFAULT })),
    })
}

/// A pin–rod of aluminium, larger, thicker and under another load.
fn other() -> PinRod {
    let (base, larger) = (PinRod::default(), 2.5);
    let aluminium = Material { young: 70e3, ..base.pin };
    PinRod {
        pin_radius: larger * base.pin_radius,
        shank_end: larger * base.shank_end,
        unit: larger * base.unit,
        thickness: 4.0,
        force: 9000.0,
        pin: aluminium,
        rod: aluminium,
        ..base
    }
}

/// Half-angle by second moment of the same pin in an infinite plate.
fn in_wide_plate(rod: &PinRod) -> f64 {
    let (radius, clearance, load) = (rod.pin_radius, rod.clearance, rod.force / rod.thickness);
    let (modulus, poisson) = (rod.rod.young, rod.rod.poisson);
    PinInHole { radius, clearance, load, modulus, poisson, plane: Plane::Stress }.second_moment()
}

/// Slopes at the default scene, by two steps.
pub fn sensitivities() -> Result<Sensitivities, Error> {
    Ok(Sensitivities {
        at: DEFAULT,
        slopes: [
            slope("E t c / F", |f| Place { clearance: DEFAULT.clearance * f, ..DEFAULT })?,
            slope("eye outer radius / R", |f| Place { eye: DEFAULT.eye * f, ..DEFAULT })?,
            slope("shank width / 2R", |f| Place { shank: DEFAULT.shank * f, ..DEFAULT })?,
        ],
    })
}

fn slope(number: &'static str, place: fn(f64) -> Place) -> Result<Slope, Error> {
    let base = PinRod::default();
    let by = |step: f64| -> Result<[f64; 2], Error> {
        let (up, down) =
            (solve(&at(&base, place(1.0 + step)))?.placed(), solve(&at(&base, place(1.0 - step)))?.placed());
        let per = ((1.0 + step) / (1.0 - step)).ln();
        Ok([up.pressure / down.pressure, up.angle / down.angle].map(|ratio| ratio.ln() / per))
    };
    Ok(Slope { number, slope: by(STEP)?, by_half: by(0.5 * STEP)? })
}
