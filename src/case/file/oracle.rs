//! `oracle = { hertz = { … } }` of a contact: the closed form that its checks are held against.
//!
//! Forces are those on the whole contact; moduli, Poisson's ratios and the plane hypothesis are the scene's own.

use std::sync::Arc;

use crate::case::file::form::Form::{Number, OneOf, Table};
use crate::case::file::form::{Form, PAIR, must};
use crate::case::file::gap::{POWERS, powers};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::oracle::SharedOracle;
use crate::oracle::analytic::even_gap::EvenGap;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::on_arc::OnArc;
use crate::oracle::analytic::persson::PinInHole;
use crate::oracle::analytic::punch::FlatPunch;
use crate::oracle::analytic::revolution::indentation::Indentation;
use crate::oracle::analytic::revolution::sphere::Sphere;
use crate::oracle::analytic::shell::{PressFit, Shape};
use crate::oracle::analytic::uniform::Uniform;
use crate::oracle::analytic::waves::Waves;
use crate::scene::{ContactPair, Path, Scene};

/// Terms of the series of a rounded wedge.
const TERMS: usize = 400;
/// Half-widths between which that of a load is looked for \[mm\].
const HALF_WIDTHS: [f64; 2] = [1e-9, 1e9];

/// A closed form by its name.
pub(super) const ORACLE: Form = OneOf(&[
    // Hertz's line contact, or the point contact of bodies of revolution; on truncated bodies too.
    ("hertz", Table(&[must("load", Number), must("radius", Number)])),
    // A pin in a hole with clearance.
    ("persson", Table(&[must("load", Number), must("radius", Number), must("clearance", Number)])),
    // A press fit: radii of the bore, where the rings meet, and of the outside.
    ("lame", Table(&[must("radii", PAIR), must("interference", Number)])),
    // A rigid flat punch; of bodies of revolution the half-width is its radius.
    ("flat-punch", Table(&[must("load", Number), must("half-width", Number)])),
    // A uniform pressure on the whole width.
    ("uniform", Table(&[must("pressure", Number), must("width", Number)])),
    // Two bars closing a gap: the first body is the moved one.
    ("bars", Table(&[must("lengths", PAIR), must("width", Number), must("gap", Number), must("push", Number)])),
    // A block under its own weight, force per volume.
    ("own-weight", Table(&[must("weight", Number), must("height", Number), must("width", Number)])),
    // The gap c₂ s² + c₄ s⁴ + c₆ s⁶, as `gap = { even = … }` has it.
    ("polynomial", Table(&[must("load", Number), must("coefficients", PAIR)])),
    // The profile Σ c rⁿ of bodies of revolution, as `gap = { powers = … }` has it.
    ("powers", Table(&[must("load", Number), must("terms", POWERS)])),
    // A wedge with a round tip: the gap has the slope s/R up to `round`, b, and b/R beyond.
    ("wedge", Table(&[must("load", Number), must("radius", Number), must("round", Number)])),
    // The cone g = r tan β, of bodies of revolution.
    ("cone", Table(&[must("load", Number), must("slope", Number)])),
    // A sinusoidal gap, under the force on a whole wave.
    ("cosine", Table(&[must("load", Number), must("amplitude", Number), must("wavelength", Number)])),
]);

/// Those whose coordinate is a length along a straight line.
const OF_A_LINE: [&str; 5] = ["hertz", "flat-punch", "polynomial", "wedge", "cosine"];

/// The closed form that is given for a contact of a scene.
pub(super) fn read(given: Value, scene: &Scene, contact: usize) -> Result<SharedOracle, Error> {
    let pair = &scene.contacts[contact];
    if let Some(radial) = scene.plane.radial() {
        return of_revolution(given, (scene, pair), radial);
    }
    let closed = of_plane(given, (scene, pair))?;
    Ok(match &pair.path {
        Path::Arc(arc) if OF_A_LINE.contains(&given.only().0) => {
            Arc::new(OnArc { straight: closed, radius: arc.radius })
        }
        _ => closed,
    })
}

/// Force per thickness \[N/mm\].
fn load(t: Value, scene: &Scene) -> Result<f64, Error> {
    Ok(t.units.force * t.at("load").positive()? / scene.thickness)
}

/// Coefficients of x², x⁴ and x⁶ \[mm⁻¹, mm⁻³, mm⁻⁵\].
fn coefficients(t: Value) -> Result<[f64; 3], Error> {
    let [second, fourth, sixth] = t.at("coefficients").exactly()?.map(Value::finite);
    let per = |k: i32| t.units.length.powi(-k);
    Ok([second? * per(1), fourth? * per(3), sixth? * per(5)])
}

/// One of a contact around the axis x = 0, or of fitted rings.
fn of_revolution(given: Value, (scene, pair): (&Scene, &ContactPair), radial: usize) -> Result<SharedOracle, Error> {
    let (name, t) = given.only();
    if name == "lame" {
        return lame_of_revolution(t, (scene, pair), radial);
    }
    if radial == 1 || !pair.path.is_around_axis(scene.plane) || !pair.path.is_straight() {
        let message = format!("`{name}` is a closed form of a contact around the axis x = 0, along y = const");
        return Err(given.refused(message, "leave `oracle` out and give checks a `value`; of fitted rings use `lame`"));
    }
    let modulus = scene.modulus_of(pair);
    let load = || load(t, scene);
    let pressed = |powers: &[[f64; 2]]| Ok::<_, Error>(Indentation::of_load(load()?, modulus, powers, HALF_WIDTHS));
    Ok(match name {
        "hertz" => Arc::new(Sphere { load: load()?, radius: t.at("radius").length()?, modulus }),
        "flat-punch" => Arc::new(Indentation::flat(modulus, t.at("half-width").length()?, load()?)),
        "polynomial" => {
            let [second, fourth, sixth] = coefficients(t)?;
            Arc::new(pressed(&[[second, 2.0], [fourth, 4.0], [sixth, 6.0]])?)
        }
        "powers" => Arc::new(pressed(&powers(t.at("terms"))?)?),
        "cone" => Arc::new(pressed(&[[t.at("slope").positive()?, 1.0]])?),
        _ => {
            let message = format!("`{name}` is a closed form of plane scenes, not of bodies of revolution");
            let remedy = "use `hertz`, `flat-punch`, `polynomial`, `powers`, `cone` or `lame`, or leave `oracle` \
                out and give checks a `value`";
            return Err(given.refused(message, remedy));
        }
    })
}

/// One of plane strain or plane stress, along a line; `persson` and `lame` along an arc.
fn of_plane(given: Value, (scene, pair): (&Scene, &ContactPair)) -> Result<SharedOracle, Error> {
    let (name, t) = given.only();
    let (units, modulus, material) = (t.units, scene.modulus_of(pair), scene.bodies[pair.first].material);
    let length = |key| t.at(key).length();
    let load = || load(t, scene);
    Ok(match name {
        "hertz" => Arc::new(Hertz { load: load()?, radius: length("radius")?, modulus }),
        "persson" => Arc::new(PinInHole {
            radius: length("radius")?,
            clearance: length("clearance")?,
            load: load()?,
            modulus: material.plane_modulus(scene.plane),
            poisson: material.poisson,
            plane: scene.plane,
        }),
        "lame" => Arc::new(lame(t, scene, pair)?),
        "flat-punch" => Arc::new(FlatPunch { load: load()?, half_width: length("half-width")? }),
        "uniform" => Arc::new(Uniform::patch(units.stress * t.at("pressure").positive()?, length("width")?)),
        "bars" => {
            let [moved, fixed] = t.at("lengths").exactly()?;
            let lengths = [moved.length()?, fixed.length()?];
            let gap = units.length * t.at("gap").within("a gap of 0 or more", |gap| gap >= 0.0)?;
            Arc::new(Uniform::bars(material.young, length("width")?, lengths, gap, length("push")?))
        }
        "own-weight" => {
            let specific_weight = units.specific_weight() * t.at("weight").positive()?;
            Arc::new(Uniform::own_weight(specific_weight, length("height")?, length("width")?))
        }
        "polynomial" => {
            let coefficients = coefficients(t)?;
            let gap = |a| EvenGap::polynomial(modulus, a, coefficients);
            Arc::new(EvenGap::of_load(load()?, HALF_WIDTHS, gap))
        }
        "wedge" => {
            let (radius, round) = (length("radius")?, length("round")?);
            let gap = |a| match a > round {
                true => EvenGap::rounded_wedge(modulus, a, radius, round, TERMS),
                false => EvenGap::polynomial(modulus, a, [0.5 / radius, 0.0, 0.0]),
            };
            Arc::new(EvenGap::of_load(load()?, HALF_WIDTHS, gap))
        }
        "cosine" => {
            let wavelength = length("wavelength")?;
            Arc::new(Waves { modulus, amplitude: length("amplitude")?, wavelength, mean: load()? / wavelength })
        }
        "cone" | "powers" => {
            let message = format!("`{name}` is a closed form of bodies of revolution, and the scene is plane");
            return Err(given.refused(message, "use `wedge` or `polynomial`, or give `plane = \"axisymmetric\"`"));
        }
        _ => t.unknown(),
    })
}

fn lame(t: Value, scene: &Scene, pair: &ContactPair) -> Result<PressFit, Error> {
    let [bore, interface, outside] = t.at("radii").exactly()?;
    let materials = rings(pair).map(|body| scene.bodies[body].material);
    let bore = bore.within("a radius of 0 or more", |radius| radius >= 0.0)?;
    let radii = [t.units.length * bore, interface.length()?, outside.length()?];
    let (shape, interference) = (Shape::of_ring(scene.plane), t.at("interference").length()?);
    Ok(PressFit { shape, radii, interference, materials })
}

/// Rings of free ends about y = 0 that touch along a line of the shaft, or spheres about one centre on the axis.
fn lame_of_revolution(t: Value, (scene, pair): (&Scene, &ContactPair), radial: usize) -> Result<SharedOracle, Error> {
    let fit = lame(t, scene, pair)?;
    match pair.path {
        Path::Straight { .. } if radial == 1 => Ok(Arc::new(fit)),
        Path::Arc(_) if radial == 0 => Ok(Arc::new(PressFit { shape: Shape::Sphere, ..fit })),
        _ => {
            let message = "`lame` is of rings about y = 0 along a straight path, and of spheres along an arc about a \
                centre on the axis";
            Err(t.refused(message, "give checks a `value` instead"))
        }
    }
}

/// The inner and the outer ring of a contact.
pub(super) fn rings(pair: &ContactPair) -> [usize; 2] {
    let second = pair.second.unwrap_or(pair.first);
    // Of rings about y = 0 the upper body is the outer one.
    if pair.above != pair.path.is_straight() { [pair.first, second] } else { [second, pair.first] }
}
