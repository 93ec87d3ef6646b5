//! The dimensionless family of the pin–rod, so that any published figure can be placed the day it appears.

use crate::case::library::PinRod;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::persson::PinInHole;
use crate::scene::Material;
use crate::solve::{Discretisation, Ended, Formulation, Run};

/// Values of `E t c / F`.
pub const CLEARANCES: [f64; 8] = [0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// Values of outer radius of the eye over pin radius.
const EYES: [f64; 3] = [1.6, 2.0, 2.5];
/// Values of shank width over pin diameter.
const SHANKS: [f64; 3] = [0.8, 1.0, 1.4];
/// Elements per 10 mm of arc of a pin of 10 mm radius.
const ELEMENTS: usize = 16;
/// Part of the candidate stretch from which on a contact reaches its end.
const REACHES: f64 = 0.97;
/// The default scene: `E t c / F`, outer radius of the eye over pin radius, shank width over pin diameter.
const DEFAULT: [f64; 3] = [5.0, 2.0, 1.0];

/// `R t p_max / F` and the contact half-angle by second moment \[rad\] of a scene; else how its run ended, of which
/// [`Ended::Beyond`] says that the contact reaches beyond the quarter of the pin that is modelled.
pub type Placed = Result<[f64; 2], Ended>;

/// An eye or a shank by its radius over that of the pin, or its width over the diameter of the pin: what was found at
/// each clearance.
pub type Curve = (String, Vec<Placed>);

/// A pin–rod of the proportions of another at a place of the family.
fn at(base: &PinRod, [clearance, eye, shank]: [f64; 3]) -> PinRod {
    PinRod {
        clearance: clearance * base.force / (base.pin.young * base.thickness),
        eye_outer_radius: eye * base.pin_radius,
        shank_width: shank * 2.0 * base.pin_radius,
        stretch: 89f64.to_radians(),
        ..*base
    }
}

fn solve(rod: &PinRod) -> Result<Placed, Error> {
    let resolution = Resolution { elements: ELEMENTS, refinement: 0, order: Order::Quadratic };
    let run = Run::of(&Discretisation::of(rod.scene(), resolution)?, &Formulation::verification());
    let (class, _) = Ended::of(&run)?;
    let Ok(run) = run else { return Ok(Err(class)) };
    let measures = run.measures();
    let pressure = measures.peak.pressure * rod.pin_radius * rod.thickness / rod.force;
    Ok(match class {
        Ended::Converged if measures.edge() > REACHES * rod.stretch => Err(Ended::Beyond),
        Ended::Converged => Ok([pressure, measures.second_moment_width]),
        other => Err(other),
    })
}

/// What was found; NaN where nothing was.
fn numbers(placed: Placed) -> [f64; 2] {
    placed.unwrap_or([f64::NAN; 2])
}

/// Curves over the clearance: the eyes, then the shanks.
pub fn curves() -> Result<Vec<Curve>, Error> {
    let [_, eye, shank] = DEFAULT;
    let eyes = EYES.map(|eye| (format!("eye {eye} R"), [eye, shank]));
    let shanks = SHANKS.map(|shank| (format!("shank {shank} · 2R"), [eye, shank]));
    let curve = |(name, [eye, shank]): (String, [f64; 2])| {
        let placed = CLEARANCES.map(|clearance| solve(&at(&PinRod::default(), [clearance, eye, shank])));
        Ok((name, placed.into_iter().collect::<Result<_, Error>>()?))
    };
    eyes.into_iter().chain(shanks).map(curve).collect()
}

/// The default scene, and a pin–rod of aluminium of the same three numbers, larger, thicker and under another load.
pub fn same_place() -> Result<[[f64; 2]; 2], Error> {
    let (base, larger) = (PinRod::default(), 2.5);
    let aluminium = Material { young: 70e3, ..base.pin };
    let other = PinRod {
        pin_radius: larger * base.pin_radius,
        shank_end: larger * base.shank_end,
        unit: larger * base.unit,
        thickness: 4.0,
        force: 9000.0,
        pin: aluminium,
        rod: aluminium,
        ..base
    };
    Ok([numbers(solve(&at(&base, DEFAULT))?), numbers(solve(&at(&other, DEFAULT))?)])
}

/// Half-angle by second moment of the pin of largest clearance in an infinite plate (Persson) \[rad\].
pub fn in_wide_plate() -> f64 {
    let [_, eye, shank] = DEFAULT;
    let rod = at(&PinRod::default(), [CLEARANCES[7], eye, shank]);
    let (radius, clearance, load) = (rod.pin_radius, rod.clearance, rod.force / rod.thickness);
    let (modulus, poisson) = (rod.rod.young, rod.rod.poisson);
    PinInHole { radius, clearance, load, modulus, poisson, plane: Plane::Stress }.second_moment()
}

/// No scene is lost, an eye embraces the pin, and three numbers place a pin.
pub fn judge(curves: &[Curve], [first, other]: &[[f64; 2]; 2], wide_plate: f64) -> Vec<Judged> {
    let all = || curves.iter().flat_map(|(_, placed)| placed);
    let lost = all().filter(|placed| placed.is_err_and(|class| class != Ended::Beyond)).count();
    let lost = Check::none(
        "scene of the family whose iteration does not converge",
        "a contact is found, or refused because it reaches beyond the quarter",
    )
    .asked_of(all().count())
    .judge(lost as f64);
    let at_last = |(_, placed): &Curve| placed.last().map_or(f64::NAN, |placed| numbers(*placed)[1]);
    let smallest = curves.iter().map(at_last).reduce(|a, b| -larger(-a, -b)).unwrap_or(f64::NAN);
    let embraced = Check::at_least(
        "smallest contact angle of all eyes at the largest clearance [°]",
        Reference::analytic("Persson, a wide plate", wide_plate.to_degrees()),
        "an eye that bends embraces the pin",
    )
    .judge(smallest.to_degrees());
    let placed = ["R t p_max / F", "angle"].into_iter().enumerate().map(|(k, name)| {
        Check::near(
            Quantity::at("result for another pin of the same three numbers", name),
            Reference::own("the default pin", first[k]),
            5e-3,
            "the family leaves c/R out, which is 0.005 and 0.006 here: results depend on it in that order",
        )
        .judge(other[k])
    });
    [lost, embraced].into_iter().chain(placed).collect()
}

/// Pressure and angle over the clearance.
pub fn table_of_curves(curves: &[Curve]) -> String {
    let head = ["R t p_max/F / 2√(∫pθ²/∫p) at E t c/F =".into()].into_iter();
    let head: Vec<String> = head.chain(CLEARANCES.iter().map(f64::to_string)).collect();
    let cell = |placed: &Placed| match placed {
        Ok([pressure, angle]) => format!("{pressure:.3} / {:.1}°", angle.to_degrees()),
        Err(Ended::Beyond) => "beyond the quarter".into(),
        Err(_) => "not converged".into(),
    };
    let row = |(name, placed): &Curve| [name.clone()].into_iter().chain(placed.iter().map(cell)).collect();
    let table = markdown::table(&head, &curves.iter().map(row).collect::<Vec<_>>());
    format!("**Pin–rod: pressure and second-moment angle by dimensionless clearance**\n\n{table}")
}
