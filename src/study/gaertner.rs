//! Comparison with Gaertner's digitised curves, on their own scene; not run while the figures are not at hand.

use std::path::{Path, PathBuf};

use crate::case::library::PinRod;
use crate::case::{Judged, Reference, Verdict};
use crate::checkout::root;
use crate::error::Error;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::digitised::{
    Abscissa, Digitised, DigitisedCurve, DigitisedScene, Ordinate, OurPoint, acceptance, compare,
};
use crate::oracle::{Oracle, ReferenceKind};
use crate::scene::Material;
use crate::solution::{EdgeState, PointState};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Finding, Trial};

/// Name of the case.
pub const CASE: &str = "gaertner 1977";
/// Elements per 10 mm of arc for a pin of 10 mm radius; scaled with the source's pin.
const ELEMENTS: usize = 24;

/// Where the curves are looked for.
pub fn folder() -> PathBuf {
    root().join("oracles/digitised/gaertner-1977")
}

/// The trial.
pub fn trials() -> Vec<Trial> {
    vec![Trial::new(CASE, "digitised curves", || against(&folder()))]
}

/// Compares every curve of a folder with the pin–rod of its own dimensions.
pub fn against(folder: &Path) -> Result<Finding, Error> {
    let requirement = "The pin–rod shall agree with Gaertner within the combined uncertainty";
    let curves = match Digitised::load(folder)? {
        Digitised::Absent(why) => {
            let check = Judged::not_run(requirement, "p(θ), σ(θ)", ReferenceKind::Measured, "Gaertner 1977", why);
            return Ok(Finding { checks: vec![check], ..Default::default() });
        }
        Digitised::Present(curves) => curves,
    };
    let checks = curves.iter().map(|curve| judge(requirement, curve)).collect::<Result<_, _>>()?;
    Ok(Finding { checks, ..Default::default() })
}

fn judge(requirement: &str, curve: &DigitisedCurve) -> Result<Judged, Error> {
    if curve.ordinate != Ordinate::Pressure || curve.abscissa != Abscissa::Angle {
        let why = format!("{}: only pressure against angle is compared so far", curve.file);
        return Ok(Judged::not_run(requirement, &curve.file, curve.kind(), curve.name(), why));
    }
    let (fine, coarse) = (edges(&curve.scene, 2 * ELEMENTS)?, edges(&curve.scene, ELEMENTS)?);
    let at =
        |(stretch, points): &(f64, Vec<PointState>), angle: f64| profile::interpolate(points, *stretch, angle.abs());
    let ours = |angle: f64| {
        let value = at(&fine, angle);
        OurPoint { value, uncertainty: (value - at(&coarse, angle)).abs() }
    };
    let comparison = compare(curve, &ours);
    let worst = comparison.worst().map_or(f64::NAN, |deviation| deviation.ratio);
    let reference = Reference { name: curve.name().into(), kind: curve.kind(), value: 0.0 };
    let friction = comparison.model_form.as_deref().unwrap_or("no friction in the source");
    let because = format!("digitising ⊕ measurement ⊕ ours at coverage 2; {friction}");
    let mut check =
        Judged::norm(requirement, curve.file.as_str(), worst, reference, acceptance::COVERAGE_FACTOR, because);
    if !comparison.accepted() {
        check.verdict = Verdict::Fail;
    }
    Ok(check)
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
