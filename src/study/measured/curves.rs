//! How far each digitised curve lies from ours: of the same scene, on two meshes.

use std::path::{Path, PathBuf};

use crate::case::library::{PinPlate, PinRod};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::checkout::root;
use crate::error::Error;
use crate::measure::order::bound_of_two;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::digitised::{
    Abscissa, Digitised, DigitisedCurve, DigitisedScene, Ordinate, OurPoint, RodScene, SheetScene, compare,
};
use crate::oracle::{Oracle, ReferenceKind};
use crate::scene::Scene;
use crate::solution::PointState;
use crate::solve::{Discretisation, Formulation, Run};
use crate::uncertainty::{COVERAGE, standard};

/// Elements per 10 mm of arc for a pin of 10 mm radius, on the coarse and the fine mesh; scaled with the source's pin.
const ELEMENTS: [usize; 2] = [24, 48];

/// A digitised curve beside ours.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its file.
    pub file: String,
    /// Name of the source.
    pub source: String,
    /// Experiment, or elements of another code.
    pub kind: ReferenceKind,
    /// Largest deviation of a point, in combined standard uncertainties; NaN without points, or where a run of ours did
    /// not converge.
    pub worst: f64,
    /// What the source models and we do not.
    pub model_form: Option<String>,
}

/// Ours at an abscissa \[rad, mm or N\], with the uncertainty of its mesh.
type Ours = Box<dyn Fn(f64) -> Result<OurPoint, Error>>;

/// Where the curves of a source are looked for.
pub fn folder(name: &str) -> PathBuf {
    root().join("oracles/digitised").join(name)
}

/// Compares every curve of a source's folder; why not, where its figures are not at hand.
pub fn against(folder: &Path) -> Result<Result<Vec<Curve>, String>, Error> {
    match Digitised::load(folder)? {
        Digitised::Absent(why) => Ok(Err(why)),
        Digitised::Present(curves) => curves.iter().map(compared).collect::<Result<_, _>>().map(Ok),
    }
}

fn compared(curve: &DigitisedCurve) -> Result<Curve, Error> {
    let ours = ours(curve)?;
    // A scene that is refused says why; one that cannot be solved beside a point is no agreement: NaN, which no check
    // passes.
    for point in &curve.points {
        ours(point.abscissa)?;
    }
    let comparison = compare(curve, &|at| ours(at).unwrap_or(OurPoint { value: f64::NAN, uncertainty: f64::NAN }));
    let worst = comparison.worst().map_or(f64::NAN, |deviation| deviation.ratio);
    let (file, source, kind) = (curve.file.clone(), curve.name().into(), curve.kind());
    Ok(Curve { file, source, kind, worst, model_form: comparison.model_form })
}

fn ours(curve: &DigitisedCurve) -> Result<Ours, Error> {
    let of_two = |both: [f64; 2]| OurPoint { value: both[1], uncertainty: standard(bound_of_two(both)) };
    let rod = match curve.scene {
        DigitisedScene::Sheet(sheet) => {
            return Ok(Box::new(move |force| {
                let [coarse, fine] = ELEMENTS.map(|elements| half_angle(&sheet, force, elements));
                Ok(of_two([coarse?, fine?]))
            }));
        }
        DigitisedScene::Rod(rod) => rod,
    };
    let [coarse, fine] = ELEMENTS.map(|elements| along(&pin_rod(&rod), elements, curve.ordinate));
    let (both, abscissa) = ([coarse?, fine?], curve.abscissa);
    let radius = match curve.ordinate {
        Ordinate::HoopStress => rod.pin_radius + rod.clearance,
        Ordinate::Pressure | Ordinate::HalfAngle => rod.pin_radius,
    };
    Ok(Box::new(move |at| {
        let angle = match abscissa {
            Abscissa::Distance => (at.abs() / radius).asin(),
            Abscissa::Angle | Abscissa::Force => at.abs(),
        };
        Ok(of_two(both.each_ref().map(|(stretch, points)| profile::interpolate(points, *stretch, angle))))
    }))
}

/// A stress along the arc, by rising angle, and how far candidates go: pressures are edge means, hoop stresses are of
/// the nodes of the hole.
fn along(scene: &Scene, elements: usize, ordinate: Ordinate) -> Result<(f64, Vec<PointState>), Error> {
    let (discretisation, run) = solved(scene, elements)?;
    let stresses: Vec<[f64; 2]> = match ordinate {
        Ordinate::HoopStress => discretisation.hoop_stresses(&discretisation.recover(&run.solution)?, 0)?,
        Ordinate::Pressure | Ordinate::HalfAngle => {
            run.solution.edges.iter().map(|edge| [edge.position(), edge.pressure]).collect()
        }
    };
    let converged = |value: f64| if run.solution.converged() { value } else { f64::NAN };
    let point =
        |[position, stress]: [f64; 2]| PointState { position, weight: 1.0, pressure: converged(stress), gap: f64::NAN };
    Ok((discretisation.scene.contact().stretch, stresses.into_iter().map(point).collect()))
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
        pin: source.pin,
        rod: source.rod,
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
        material: source.sheet,
        force,
        unit: base.unit * source.pin_radius / base.pin_radius,
        ..base
    };
    let mut scene = plate.scene();
    scene.bodies[0].material = source.pin;
    scene
}

/// Our curves agree with the digitised ones of a source within the combined uncertainty.
pub fn judge(source: &str, found: &Result<Vec<Curve>, String>) -> Vec<Judged> {
    let measured = ReferenceKind::Measured;
    match found {
        Ok(curves) => curves.iter().map(judge_curve).collect(),
        Err(why) => vec![check("every curve", source, measured, None).not_run(measured, source, why.clone())],
    }
}

fn judge_curve(curve: &Curve) -> Judged {
    check(&curve.file, &curve.source, curve.kind, curve.model_form.as_deref()).judge(curve.worst)
}

fn check(curve: &str, source: &str, kind: ReferenceKind, model_form: Option<&str>) -> Check {
    let friction = model_form.unwrap_or("no friction in the source");
    Check::error(
        Quantity::at("largest deviation in combined standard uncertainties", curve),
        Reference { name: source.into(), kind, value: 0.0, uncertainty: None },
        COVERAGE,
        format!("u_val = digitising ⊕ measurement ⊕ our mesh, each standard; coverage {COVERAGE}; {friction}"),
    )
}
