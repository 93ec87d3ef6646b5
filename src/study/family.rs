//! The dimensionless family of the pin–rod, so that any published figure can be placed the day it appears.

use serde::Serialize;

use crate::case::library::PinRod;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::{Error, Kind};
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::markdown;
use crate::mesh::{Order, Resolution};
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::persson::PinInHole;
use crate::scene::Material;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::about::About;
use crate::study::drawn::{Curve, picture};
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "The dimensionless family of the pin–rod",
    asked: "Where a published figure of a pin in an eye belongs, whatever its dimensions.",
    limits: "Eyes of the shape drawn here; no friction, no plate of another outline.",
};

/// Name of the study.
const STUDY: &str = "dimensionless family, pin-rod";

/// Both trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![
        Planned::new(STUDY, "clearance and thickness", || curves().map(Numbers::Curves)),
        Planned::new(STUDY, "sensitivities", || sensitivities().map(Numbers::Sensitivities)),
    ]
}

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

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Curves(curves) => of_curves(curves),
        Numbers::Sensitivities(sensitivities) => of_slopes(sensitivities),
    })
}

fn of_curves(curves: &Curves) -> Vec<Judged> {
    let lines: Vec<&Line> = curves.eyes.iter().chain(&curves.shanks).collect();
    let ended: Vec<Ended> = lines.iter().flat_map(|line| line.ended.clone()).collect();
    let lost = ended.iter().filter(|ended| matches!(ended, Ended::NotConverged)).count();
    let lost = Check::none(
        Quantity::at("scene of the family whose iteration does not converge", format!("of {}", ended.len())),
        "a contact is found, or refused because it reaches beyond the quarter",
    )
    .judge(lost as f64);
    let at_last = |line: &&Line| line.ended.last().map_or(f64::NAN, |ended| ended.placed().angle);
    let smallest = lines.iter().map(at_last).reduce(smaller).unwrap_or(f64::NAN);
    let embraced = Check::at_least(
        "smallest contact angle of all eyes at the largest clearance [°]",
        Reference::analytic("Persson, a wide plate", curves.wide_plate.to_degrees()),
        "an eye that bends embraces the pin",
    )
    .judge(smallest.to_degrees());
    let [first, other] = &curves.same_place;
    let placed =
        [("R t p_max / F", (|p| p.pressure) as fn(&Placed) -> f64), ("angle", |p| p.angle)].map(|(name, of)| {
            Check::near(
                Quantity::at("result for another pin of the same three numbers", name),
                Reference::own("the default pin", of(first)),
                5e-3,
                "the family leaves c/R out, which is 0.005 and 0.006 here: results depend on it in that order",
            )
            .judge(of(other))
        });
    [lost, embraced].into_iter().chain(placed).collect()
}

/// The smaller of two numbers; NaN if either is.
fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// Change of a slope with half the step.
const STEPS: f64 = 0.02;

fn of_slopes(sensitivities: &Sensitivities) -> Vec<Judged> {
    let of_number = |slope: &Slope| {
        ["p_max", "angle"]
            .into_iter()
            .enumerate()
            .map(|(k, result)| {
                let quantity =
                    Quantity::at("change of a sensitivity by half the step", format!("{result} by {}", slope.number));
                let because =
                    "central differences: error of the order of the step squared, and of the mesh that changes with it";
                Check::error(quantity, Reference::own("half the step", 0.0), STEPS, because)
                    .judge((slope.slope[k] - slope.by_half[k]).abs())
            })
            .collect::<Vec<_>>()
    };
    sensitivities.slopes.iter().flat_map(of_number).collect()
}

/// The chart and both tables.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::from("Three dimensionless numbers place any published figure of a pin in an eye.\n\n");
    text += &picture("family-pin-rod.svg", "Peak pressure and second-moment angle against dimensionless clearance");
    for found in findings {
        text += &match found.numbers {
            Numbers::Curves(curves) => curves_table(curves),
            Numbers::Sensitivities(sensitivities) => slopes_table(sensitivities),
        };
    }
    Ok(text)
}

/// A name for each curve: the eyes, then the shanks.
pub fn named(curves: &Curves) -> impl Iterator<Item = (String, &Line)> {
    let eyes = curves.eyes.iter().map(|line| (format!("eye {} R", line.value), line));
    eyes.chain(curves.shanks.iter().map(|line| (format!("shank {} · 2R", line.value), line)))
}

fn curves_table(curves: &Curves) -> String {
    let head = ["R t p_max/F / 2√(∫pθ²/∫p) at E t c/F =".into()].into_iter();
    let head: Vec<String> = head.chain(curves.clearances.iter().map(f64::to_string)).collect();
    let cell = |ended: &Ended| match ended {
        Ended::Converged(Placed { pressure, angle }) => format!("{pressure:.3} / {:.1}°", angle.to_degrees()),
        Ended::Beyond => "beyond the quarter".into(),
        Ended::NotConverged => "not converged".into(),
    };
    let rows = named(curves).map(|(name, line)| [name].into_iter().chain(line.ended.iter().map(cell)).collect());
    let table = markdown::table(&head, &rows.collect::<Vec<_>>());
    format!("**Pin–rod: pressure and second-moment angle by dimensionless clearance**\n\n{table}\n")
}

fn slopes_table(sensitivities: &Sensitivities) -> String {
    let Place { clearance, eye, shank } = sensitivities.at;
    let row = |slope: &Slope| {
        let slopes = slope.slope.map(|slope| format!("{slope:+.3}"));
        [slope.number.to_string()].into_iter().chain(slopes).collect()
    };
    let rows: Vec<Vec<String>> = sensitivities.slopes.iter().map(row).collect();
    let head = ["number", "∂ ln p_max / ∂ ln", "∂ ln angle / ∂ ln"].map(String::from);
    let table = markdown::table(&head, &rows);
    format!("**Pin–rod: sensitivities around E t c/F = {clearance}, eye {eye} R, shank {shank} · 2R**\n\n{table}\n")
}

/// Ends of the axis of clearances; what has none stands on its left end.
const LEAST: f64 = 0.25;
const MOST: f64 = 60.0;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let all: Vec<&Curves> = findings.iter().filter_map(|found| curves_of(found.numbers)).collect();
    let chart = |title: &str, axis: &str, of: fn(Placed) -> f64| {
        let mut chart = Chart::new(title, Axis::log("clearance E t c / F [–]").over(LEAST, MOST), Axis::linear(axis));
        for curves in &all {
            chart.series.extend(named(curves).zip(styles()).map(|((name, line), style)| {
                let points = curves.clearances.iter().zip(&line.ended);
                let points = points.map(|(clearance, ended)| [*clearance, of(ended.placed())]).collect();
                Curve { points, failed: failed(curves, line) }.drawn(name, style)
            }));
        }
        if chart
            .series
            .iter()
            .flat_map(|series| &series.points)
            .any(|(clearance, value)| *clearance <= 0.0 && value.is_finite())
        {
            chart.notes.push("The points on the left rim have no clearance.".into());
        }
        chart
    };
    let charts = [
        chart("family: pressure", "peak pressure R t p_max / F [–]", |placed| placed.pressure),
        chart("family: angle", "angle 2 √(∫pθ²/∫p) [°]", |placed| placed.angle.to_degrees()),
    ];
    Ok(vec![("family-pin-rod.svg".into(), panels("Pin–rod: the dimensionless family", &charts, 2)?)])
}

fn curves_of(numbers: &Numbers) -> Option<&Curves> {
    match numbers {
        Numbers::Curves(curves) => Some(curves),
        Numbers::Sensitivities(_) => None,
    }
}

/// Clearances of iterations that did not converge; a contact beyond the quarter is refused, and no point of the family.
fn failed(curves: &Curves, line: &Line) -> Vec<f64> {
    let all = curves.clearances.iter().zip(&line.ended);
    all.filter(|(_, ended)| matches!(ended, Ended::NotConverged)).map(|(clearance, _)| *clearance).collect()
}

/// Eyes solid, shanks dashed.
fn styles() -> impl Iterator<Item = Style> {
    [(Dash::Solid, Marker::Circle), (Dash::Dashed, Marker::Square)].into_iter().flat_map(|(dash, marker)| {
        [palette::LINE, palette::NODE, palette::LAYER].map(|colour| Style::run(colour, dash, marker))
    })
}
