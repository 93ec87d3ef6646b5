//! Against measurements: digitised curves of pins, each held against the same scene of ours on two meshes and not run
//! while the figures are not at hand, and a photograph of a disc between two plates. Two comparisons of one page, which
//! share nothing but that nothing of theirs is ours; so the second has a file of its own:
//!
//! * [`photograph`] — isochromatics of a disc, shape only: the fringe orders of our disc, and what is fitted to them.

pub mod photograph;

use std::path::Path;

use crate::case::library::{PinPlate, PinRod};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::checkout::root;
use crate::drawing::Drawing;
use crate::error::Error;
use crate::measure::order::bar_of_two;
use crate::measure::profile;
use crate::mesh::{Order, Resolution};
use crate::oracle::ReferenceKind;
use crate::oracle::digitised::{
    self, Abscissa, DigitisedCurve, DigitisedScene, Ordinate, OurPoint, compare, fringes, model_form, worst,
};
use crate::scene::Scene;
use crate::solution::PointState;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::{About, Found, Planned, Study};
use crate::uncertainty::{COVERAGE, standard};
use photograph::Photograph;

/// The source of the paper's Figures 14 and 15.
pub const GAERTNER: &str = "gaertner 1977";

/// Sources of curves, and their folders under `oracles/digitised`.
const SOURCES: [(&str, &str); 2] = [(GAERTNER, "gaertner-1977"), ("ghosh 1982", "ghosh-1982")];

/// What a trial found.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// The check of every curve of a source.
    Curves(Vec<Judged>),
    /// What the photograph says of our disc.
    Photograph(Photograph),
}

impl Study for Numbers {
    const NAME: &'static str = "measured";
    const ABOUT: About = About {
        title: "Against measurements",
        asked: "Whether stresses and loads along real pins are those that were measured, and the stress field between \
            two plates that of a photographed disc.",
        limits: "Digitised curves: nothing is compared until somebody brings the figures. The photograph is \
            uncalibrated: shapes only. It tells neither load, nor material, nor pressure.",
    };

    /// A trial a source of curves, and the one photograph.
    fn plan() -> Vec<Planned<Self>> {
        let curves = SOURCES.map(|(source, folder)| {
            Planned::new(source, "digitised curves", move || {
                let folder = root().join("oracles/digitised").join(folder);
                Ok(Numbers::Curves(judge_curves(source, &against(&folder)?)))
            })
        });
        let photograph = Planned::new("photoelastic disc between plates", "isochromatics of a photograph", || {
            photograph::compare(&fringes::read(&fringes::file())?).map(Numbers::Photograph)
        });
        curves.into_iter().chain([photograph]).collect()
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(match self {
            Numbers::Curves(judged) => judged.clone(),
            Numbers::Photograph(photograph) => photograph::judge(photograph),
        })
    }

    /// What is compared; of curves the table of checks says the rest.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let photographs: String = photographs(findings).map(photograph::section).collect();
        Ok(include_str!("page.md").to_owned() + "\n" + &photographs)
    }

    /// Of the photograph.
    fn pictures(findings: &[Found<Self>]) -> Result<Vec<(String, Drawing)>, Error> {
        Ok(photographs(findings).map(photograph::picture_of).collect())
    }
}

fn photographs<'a>(findings: &'a [Found<Numbers>]) -> impl Iterator<Item = &'a Photograph> {
    findings.iter().filter_map(|found| match found.numbers {
        Numbers::Photograph(photograph) => Some(photograph),
        Numbers::Curves(_) => None,
    })
}

/// Elements per 10 mm of arc for a pin of 10 mm radius, on the coarse and the fine mesh; scaled with the source's pin.
const ELEMENTS: [usize; 2] = [24, 48];

/// Compares every curve of a source's folder; why not, where its figures are not at hand.
pub fn against(folder: &Path) -> Result<Result<Vec<Judged>, String>, Error> {
    match digitised::load(folder)? {
        Err(why) => Ok(Err(why.into())),
        Ok(curves) => curves.iter().map(compared).collect::<Result<_, _>>().map(Ok),
    }
}

fn compared(curve: &DigitisedCurve) -> Result<Judged, Error> {
    let ours = ours(curve)?;
    // A scene that is refused says why; one that cannot be solved beside a point is no agreement: NaN, which no check
    // passes.
    for point in &curve.points {
        ours(point.abscissa)?;
    }
    let comparison = compare(curve, &|at| ours(at).unwrap_or(OurPoint { value: f64::NAN, uncertainty: f64::NAN }));
    Ok(check(&curve.file, &curve.file, curve.kind(), model_form(curve).as_deref()).judge(worst(&comparison)))
}

/// Ours at an abscissa \[rad, mm or N\], with the uncertainty of its mesh.
type Ours = Box<dyn Fn(f64) -> Result<OurPoint, Error>>;

fn ours(curve: &DigitisedCurve) -> Result<Ours, Error> {
    let of_two = |both: [f64; 2]| OurPoint { value: both[1], uncertainty: standard(bar_of_two(both)) };
    let scene = curve.scene.clone();
    if scene.is_sheet {
        return Ok(Box::new(move |force| {
            let [coarse, fine] = ELEMENTS.map(|elements| half_angle(&scene, force, elements));
            Ok(of_two([coarse?, fine?]))
        }));
    }
    let [coarse, fine] = ELEMENTS.map(|elements| along(&pin_rod(&scene), elements, curve.ordinate));
    let (both, abscissa) = ([coarse?, fine?], curve.abscissa);
    let radius = match curve.ordinate {
        Ordinate::HoopStress => scene.number("pin_radius") + scene.number("clearance"),
        Ordinate::Pressure | Ordinate::HalfAngle => scene.number("pin_radius"),
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
fn half_angle(sheet: &DigitisedScene, force: f64, elements: usize) -> Result<f64, Error> {
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

fn pin_rod(source: &DigitisedScene) -> Scene {
    let (base, number) = (PinRod::default(), |key| source.number(key));
    let rod = PinRod {
        pin_radius: number("pin_radius"),
        clearance: number("clearance"),
        eye_outer_radius: number("eye_outer_radius"),
        shank_width: number("shank_width"),
        shank_end: number("shank_end"),
        thickness: number("thickness"),
        pin: source.material("pin"),
        rod: source.material("rod"),
        force: number("force"),
        unit: base.unit * number("pin_radius") / base.pin_radius,
        ..base
    };
    rod.scene()
}

fn pin_sheet(source: &DigitisedScene, force: f64) -> Scene {
    let (base, number) = (PinPlate::default(), |key| source.number(key));
    let plate = PinPlate {
        pin_radius: number("pin_radius"),
        clearance: number("clearance"),
        rim_radius: number("rim_radius"),
        thickness: number("thickness"),
        material: source.material("sheet"),
        force,
        unit: base.unit * number("pin_radius") / base.pin_radius,
        ..base
    };
    let mut scene = plate.scene();
    scene.bodies[0].material = source.material("pin");
    scene
}

/// Our curves agree with the digitised ones of a source within the combined uncertainty.
pub fn judge_curves(source: &str, found: &Result<Vec<Judged>, String>) -> Vec<Judged> {
    let measured = ReferenceKind::Measured;
    match found {
        Ok(curves) => curves.clone(),
        Err(why) => vec![check("every curve", source, measured, None).not_run(measured, source, why.clone())],
    }
}

/// The check of the largest deviation of a point, which is NaN without points, or where a run of ours did not converge;
/// `model_form` is what the source models and we do not.
pub fn check(curve: &str, source: &str, kind: ReferenceKind, model_form: Option<&str>) -> Check {
    let friction = model_form.unwrap_or("no friction in the source");
    Check::error(
        Quantity::at("largest deviation in combined standard uncertainties", curve),
        Reference { name: source.into(), kind, value: 0.0, uncertainty: None },
        COVERAGE,
        format!("u_val = digitising ⊕ measurement ⊕ our mesh, each standard; coverage {COVERAGE}; {friction}"),
    )
}
