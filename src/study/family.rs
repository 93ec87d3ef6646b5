//! The dimensionless family of the pin–rod, so that any published figure can be placed the day it appears.

use crate::case::library::PinRod;
use crate::error::{Error, Kind};
use crate::mesh::{Order, Resolution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::unsorted::{Finding, Series, Table, Trial};

/// Values of `E t c / F`.
const CLEARANCES: [f64; 8] = [0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// Values of outer radius of the eye over pin radius.
const EYES: [f64; 3] = [1.6, 2.0, 2.5];
/// Values of shank width over pin diameter.
const SHANKS: [f64; 3] = [0.8, 1.0, 1.4];
/// Relative step of the sensitivities.
const STEP: f64 = 0.05;
/// Elements per 10 mm of arc.
const ELEMENTS: usize = 16;

/// Part of the candidate stretch from which on a contact counts as spilling over its end.
const SPILLS: f64 = 0.97;

/// Name of the study.
pub const STUDY: &str = "dimensionless family, pin-rod";

/// Trials of the family.
pub fn trials() -> Vec<Trial> {
    vec![Trial::new(STUDY, "clearance and thickness", curves), Trial::new(STUDY, "sensitivities", sensitivities)]
}

/// The three dimensionless numbers a scene is placed by.
#[derive(Clone, Copy)]
struct Numbers {
    /// `E t c / F`.
    clearance: f64,
    /// Outer radius of the eye over pin radius.
    eye: f64,
    /// Shank width over pin diameter.
    shank: f64,
}

const DEFAULT: Numbers = Numbers { clearance: 5.0, eye: 2.0, shank: 1.0 };

/// `R t p_max / F` and the contact half-angle by second moment \[rad\].
fn solve(numbers: Numbers) -> Result<[f64; 2], Error> {
    let base = PinRod::default();
    let rod = PinRod {
        clearance: numbers.clearance * base.force / (base.pin.young * base.thickness),
        eye_outer_radius: numbers.eye * base.pin_radius,
        shank_width: numbers.shank * 2.0 * base.pin_radius,
        stretch: 89f64.to_radians(),
        ..base
    };
    let resolution = Resolution { elements: ELEMENTS, refinement: 0, order: Order::Quadratic };
    let run = match Run::of(&Discretisation::of(rod.scene(), resolution)?, &Formulation::verification()) {
        Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => return Ok([f64::NAN; 2]),
        other => other?,
    };
    // Only the pin's lower quarter is modelled: a contact that reaches its end goes on beyond it.
    let spills = run.measures().edge() > SPILLS * rod.stretch;
    if spills || !run.solution.converged() {
        return Ok([f64::NAN; 2]);
    }
    let pressure = run.measures().peak.pressure * rod.pin_radius * rod.thickness / rod.force;
    Ok([pressure, run.measures().half_width])
}

fn curves() -> Result<Finding, Error> {
    let mut finding = Finding::default();
    let eyes = EYES.map(|eye| (format!("eye {eye} R"), Numbers { eye, ..DEFAULT }));
    let shanks = SHANKS.map(|shank| (format!("shank {shank} · 2R"), Numbers { shank, ..DEFAULT }));
    let mut rows = Vec::new();
    for (label, numbers) in eyes.into_iter().chain(shanks) {
        let results = CLEARANCES.map(|clearance| solve(Numbers { clearance, ..numbers }));
        let results: Vec<[f64; 2]> = results.into_iter().collect::<Result<_, _>>()?;
        let curve = |picture: &str, k: usize, factor: f64| Series {
            picture: picture.into(),
            label: label.clone(),
            points: CLEARANCES.iter().zip(&results).map(|(x, r)| [*x, factor * r[k]]).collect(),
            failed: Vec::new(),
        };
        finding.series.push(curve("family: pressure", 0, 1.0));
        finding.series.push(curve("family: angle", 1, 180.0 / std::f64::consts::PI));
        let cells = results.iter().map(|[p, angle]| match p.is_nan() {
            true => "beyond the quarter".into(),
            false => format!("{p:.3} / {:.1}°", angle.to_degrees()),
        });
        rows.push(std::iter::once(label).chain(cells).collect());
    }
    let head = std::iter::once("R t p_max/F / 2√(∫pθ²/∫p) at E t c/F =".into());
    finding.tables.push(Table {
        title: "Pin–rod: pressure and second-moment angle by dimensionless clearance".into(),
        head: head.chain(CLEARANCES.map(|c| c.to_string())).collect(),
        rows,
    });
    Ok(finding)
}

/// A dimensionless number by name, and the default numbers with it multiplied by a factor.
type Change = (&'static str, fn(f64) -> Numbers);

/// `∂ ln result / ∂ ln number` at the default scene, by central differences.
fn sensitivities() -> Result<Finding, Error> {
    let change: [Change; 3] = [
        ("E t c / F", |f| Numbers { clearance: DEFAULT.clearance * f, ..DEFAULT }),
        ("eye outer radius / R", |f| Numbers { eye: DEFAULT.eye * f, ..DEFAULT }),
        ("shank width / 2R", |f| Numbers { shank: DEFAULT.shank * f, ..DEFAULT }),
    ];
    let mut rows = Vec::new();
    for (name, numbers) in change {
        let (up, down) = (solve(numbers(1.0 + STEP))?, solve(numbers(1.0 - STEP))?);
        let slope = |k: usize| (up[k] / down[k]).ln() / ((1.0 + STEP) / (1.0 - STEP)).ln();
        rows.push(vec![name.to_string(), format!("{:+.3}", slope(0)), format!("{:+.3}", slope(1))]);
    }
    let head = ["number", "∂ ln p_max / ∂ ln", "∂ ln angle / ∂ ln"].map(String::from).into();
    let Numbers { clearance, eye, shank } = DEFAULT;
    let title = format!("Pin–rod: sensitivities around E t c/F = {clearance}, eye {eye} R, shank {shank} · 2R");
    let table = Table { title, head, rows };
    Ok(Finding { tables: vec![table], ..Default::default() })
}
