//! Each digitised curve beside the pin–rod of its own dimensions.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::case::library::PinRod;
use crate::error::Error;
use crate::measure::order::bound_of_two;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::checkout::root;
use crate::oracle::digitised::{Abscissa, Digitised, DigitisedCurve, DigitisedScene, Ordinate, OurPoint, compare};
use crate::oracle::{Oracle, ReferenceKind};
use crate::scene::Material;
use crate::solution::{EdgeState, PointState};
use crate::solve::{Discretisation, Formulation, Run};
use crate::uncertainty::standard;

/// Elements per 10 mm of arc for a pin of 10 mm radius; scaled with the source's pin.
const ELEMENTS: usize = 24;

/// What the folder of the curves holds.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// The figures are not at hand, and why.
    Absent(String),
    /// Every curve.
    Present(Vec<Curve>),
}

/// A digitised curve.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// Its file.
    pub file: String,
    /// Name of the source.
    pub source: String,
    /// Experiment, or elements of another code.
    pub kind: ReferenceKind,
    /// How far it lies from ours; none of what is not compared so far.
    pub deviates: Option<Deviates>,
}

/// How far a digitised curve lies from ours.
#[derive(Clone, Debug, Serialize)]
pub struct Deviates {
    /// Largest deviation of a point, in combined standard uncertainties; NaN without points.
    pub worst: f64,
    /// What the source models and we do not.
    pub model_form: Option<String>,
}

/// Where the curves are looked for.
pub fn folder() -> PathBuf {
    root().join("oracles/digitised/gaertner-1977")
}

/// Compares every curve of a folder.
pub fn against(folder: &Path) -> Result<Numbers, Error> {
    match Digitised::load(folder)? {
        Digitised::Absent(why) => Ok(Numbers::Absent(why)),
        Digitised::Present(curves) => curves.iter().map(curve).collect::<Result<_, _>>().map(Numbers::Present),
    }
}

fn curve(curve: &DigitisedCurve) -> Result<Curve, Error> {
    let compared = curve.ordinate == Ordinate::Pressure && curve.abscissa == Abscissa::Angle;
    let deviates = if compared { Some(deviation(curve)?) } else { None };
    Ok(Curve { file: curve.file.clone(), source: curve.name().into(), kind: curve.kind(), deviates })
}

fn deviation(curve: &DigitisedCurve) -> Result<Deviates, Error> {
    let (fine, coarse) = (edges(&curve.scene, 2 * ELEMENTS)?, edges(&curve.scene, ELEMENTS)?);
    let at =
        |(stretch, points): &(f64, Vec<PointState>), angle: f64| profile::interpolate(points, *stretch, angle.abs());
    let ours = |angle: f64| {
        let value = at(&fine, angle);
        OurPoint { value, uncertainty: standard(bound_of_two([at(&coarse, angle), value])) }
    };
    let comparison = compare(curve, &ours);
    let worst = comparison.worst().map_or(f64::NAN, |deviation| deviation.ratio);
    Ok(Deviates { worst, model_form: comparison.model_form })
}

/// Candidate stretch \[rad\] and edge means of the pressure on the source's own scene.
fn edges(scene: &DigitisedScene, elements: usize) -> Result<(f64, Vec<PointState>), Error> {
    let base = PinRod::default();
    let rod = PinRod {
        pin_radius: scene.pin_radius,
        clearance: scene.clearance,
        eye_outer_radius: scene.eye_outer_radius,
        shank_width: scene.shank_width,
        shank_end: scene.shank_end,
        thickness: scene.thickness,
        pin: Material { young: scene.pin.young, poisson: scene.pin.poisson },
        rod: Material { young: scene.rod.young, poisson: scene.rod.poisson },
        force: scene.force,
        unit: base.unit * scene.pin_radius / base.pin_radius,
        ..base
    };
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(rod.scene(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let middle = |edge: &EdgeState| PointState {
        position: edge.position(),
        weight: edge.weight,
        pressure: if run.solution.converged() { edge.pressure } else { f64::NAN },
        gap: f64::NAN,
    };
    Ok((discretisation.scene.contact().stretch, run.solution.edges.iter().map(middle).collect()))
}
